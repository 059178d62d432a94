/* choice.c - executes #switch, #case and #range.
 *
 * The first matching case is read. As in POV-Ray, all cases after it and the #else are
 * read too, up to a #break.
 */
#include "rt/scene/language/condition.h"
#include "rt/scene/language/scene_expression.h"

/* Skips to the next #case, #range or #else of a #switch, or to its #end. */
static bool to_next(struct reader *reader, struct scene_condition *condition)
{
    struct scene_token at = condition->at;
    if (condition_skip(reader, &at, "case range else end", 1))
        return true;
    reader->condition_count--;
    return false;
}

bool switch_begin(struct reader *reader, const struct item *item)
{
    double value = 0;
    bool good = condition_read(reader, &value);
    struct scene_condition *condition = NULL;
    if (good)
        condition = condition_push(reader, CONDITION_SWITCH, &item->at);
    if (!condition)
        return condition_leave_out(reader, &item->at);
    condition->value = value;
    return to_next(reader, condition);
}

/* Reads "(" value for #case, or "(" lowest "," highest for #range. The current token is
 * then ")". */
static bool read_bounds(struct reader *reader, bool range, double *lowest,
                        double *highest)
{
    if (!range) {
        bool done = condition_read(reader, lowest);
        *highest = *lowest;
        return done;
    }
    if (!reader_require_sign(reader, '('))
        return false;
    reader_next(reader);
    return read_full_number(reader, lowest) && reader_expect_sign(reader, ',')
           && read_full_number(reader, highest) && reader_require_sign(reader, ')');
}

bool switch_case(struct reader *reader, const struct item *item)
{
    struct scene_condition *condition = condition_top(reader);
    double lowest = 0, highest = 0;
    size_t sealed;
    bool good;
    if (!condition || condition->kind != CONDITION_SWITCH || condition->in_else)
        return reader_fault(reader, &item->at, "'#%s' without a matching '#switch'",
                            item->keyword->words);
    sealed = condition_seal(reader);
    good = read_bounds(reader, item->keyword->detail == SWITCH_RANGE, &lowest,
                       &highest);
    reader->sealed = sealed;
    if (!good) {
        condition_leave(reader, condition);
        return false;
    }
    if (condition->value > lowest - EXPRESSION_SAME
        && condition->value < highest + EXPRESSION_SAME)
        condition->chosen = true;
    reader_step(reader);
    return condition->chosen || to_next(reader, condition);
}

bool switch_else(struct reader *reader, struct scene_condition *condition)
{
    (void)reader;
    condition->in_else = true;
    return true;
}
