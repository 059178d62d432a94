/* loop.c - executes #while and #for. */
#include "rt/scene/language/condition.h"
#include "rt/scene/language/declare.h"
#include "rt/scene/language/scene_expression.h"

/* Reports an error if the head of the loop does not end in the file or macro in which
 * it began. */
static bool same_frame(struct reader *reader, const struct scene_condition *loop)
{
    return lexer_top(&reader->lexer)->serial == loop->frame
           || reader_fault(reader, &loop->at,
                           "the condition must end in the file or macro where "
                           "it begins");
}

/* Starts an iteration of the loop if its condition holds, or else skips its body. The
 * current token is the last token before the body. */
static bool turn(struct reader *reader, struct scene_condition *loop, bool good,
                 bool holds)
{
    if (!good || !holds)
        return condition_leave(reader, loop) && good;
    reader_step(reader);
    return true;
}

/* Returns true if the loop may continue. An iteration with an error is the last
 * iteration, because the error may have prevented a change of the variable. */
static bool may_go_on(struct reader *reader, struct scene_condition *loop)
{
    if (++loop->turns == MAX_TURNS)
        return reader_fault(reader, &loop->at, "more than %d iterations", MAX_TURNS);
    return reader->reports->errors == loop->errors;
}

/* ---- #while -------------------------------------------------------------- */

static bool begin_turn(struct reader *reader, struct scene_condition *loop)
{
    double value = 0;
    bool good = condition_read(reader, &value) && same_frame(reader, loop);
    return turn(reader, loop, good, condition_holds(value));
}

bool loop_while(struct reader *reader, const struct item *item)
{
    struct scene_condition *loop = condition_push(reader, CONDITION_WHILE, &item->at);
    if (!loop)
        return condition_leave_out(reader, &item->at);
    loop->again = reader->token.place;
    return begin_turn(reader, loop);
}

/* ---- #for ---------------------------------------------------------------- */

static bool set_variable(struct reader *reader, const struct scene_token *name,
                         double number)
{
    struct scene_value value = { .kind = VALUE_NUMBERS,
                                 .is.numbers = numbers_of(number) };
    size_t level = reader->lexer.depth;
    struct declared_name *symbol = symbols_find_at(&reader->symbols, level, name->text,
                                                   name->length);
    return reader_check(reader, name,
                        symbols_assign(&reader->symbols, symbol, level, name, &value));
}

/* Reads the current value of the loop variable. As in POV-Ray, the body may have
 * changed it. */
static bool get_variable(struct reader *reader, const struct scene_token *name,
                         double *number)
{
    struct scene_token found = *name;
    if (!reader_look_up(reader, &found) || found.value->kind != VALUE_NUMBERS
        || found.value->is.numbers.count != 1)
        return reader_fault(reader, name,
                            "the variable of the loop is no longer a number");
    *number = found.value->is.numbers.n[0];
    return true;
}

static bool is_past(const struct scene_condition *loop, double value)
{
    return loop->step > 0 ? value > loop->end + EXPRESSION_SAME
                          : value < loop->end - EXPRESSION_SAME;
}

static bool read_step(struct reader *reader, double *step)
{
    struct scene_token at = reader->token;
    *step = 1;
    if (!reader_accept_sign(reader, ','))
        return true;
    at = reader->token;
    return read_full_number(reader, step)
           && (*step != 0 || reader_fault(reader, &at, "the step must not be 0"));
}

/* Reads "(" name, start, end [, step] of a #for. The current token is then ")". */
static bool read_head(struct reader *reader, struct scene_condition *loop,
                      double *start)
{
    if (!reader_require_sign(reader, '('))
        return false;
    reader_step(reader);
    loop->name = reader->token;
    if (!name_expected(reader, &loop->name))
        return false;
    reader_step(reader);
    return reader_expect_sign(reader, ',') && read_full_number(reader, start)
           && reader_expect_sign(reader, ',') && read_full_number(reader, &loop->end)
           && read_step(reader, &loop->step) && reader_require_sign(reader, ')');
}

bool loop_for(struct reader *reader, const struct item *item)
{
    struct scene_condition *loop = condition_push(reader, CONDITION_FOR, &item->at);
    double start = 0;
    size_t sealed;
    bool good;
    if (!loop)
        return condition_leave_out(reader, &item->at);
    sealed = condition_seal(reader);
    good = read_head(reader, loop, &start) && same_frame(reader, loop)
           && set_variable(reader, &loop->name, start);
    reader->sealed = sealed;
    loop->again = lexer_top(&reader->lexer)->place;
    return turn(reader, loop, good, good && !is_past(loop, start));
}

static bool next_turn(struct reader *reader, struct scene_condition *loop)
{
    double value = 0;
    bool good = get_variable(reader, &loop->name, &value)
                && set_variable(reader, &loop->name, value + loop->step);
    return good && !is_past(loop, value + loop->step);
}

/* ---- End of a loop ------------------------------------------------------- */

bool loop_end(struct reader *reader, struct scene_condition *loop)
{
    bool is_for = loop->kind == CONDITION_FOR;
    if (!may_go_on(reader, loop) || (is_for && !next_turn(reader, loop))) {
        reader->condition_count--;
        return true;
    }
    reader_jump(reader, &loop->again);
    return is_for || begin_turn(reader, loop);
}
