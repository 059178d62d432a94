/* spline_value.c - parses splines and their calls.
 *
 *   spline { [NAME] [kind] t, value, ... }
 *   NAME(t [, kind])
 *   kind   linear_spline | quadratic_spline | cubic_spline | natural_spline
 */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"
#include "rt/scene/spline.h"

static bool accept_kind(struct reader *reader, enum spline_kind *kind)
{
    static const char *const words[SPLINE_KINDS] = { "linear_spline",
                                                     "quadratic_spline", "cubic_spline",
                                                     "natural_spline" };
    for (int i = 0; i < SPLINE_KINDS; i++)
        if (reader_accept(reader, words[i])) {
            *kind = (enum spline_kind)i;
            return true;
        }
    return false;
}

/* Reads a point of a spline: the parameter t, then the value. */
static bool read_point(struct reader *reader, struct spline *spline)
{
    struct numbers value;
    size_t moved;
    double t;
    if (!read_number(reader, &t))
        return false;
    reader_comma(reader);
    if (!read_expression(reader, &value))
        return false;
    reader_comma(reader);
    numbers_widen(&value, 2);
    moved = spline->count - spline_find(spline, t) + MEMORY_COST;
    return reader_spend(reader, moved * sizeof *spline->points)
           && (spline_add(spline, t, value.n, value.count) || reader_no_memory(reader));
}

bool spline_read(struct reader *reader, const struct item *item)
{
    struct scene_value *value = item->subject;
    const struct scene_value *from;
    struct spline *spline;
    struct block block;
    bool good = true;
    if (!block_open(reader, &block, '{'))
        return false;
    from = reader_value_of(reader, VALUE_SPLINE);
    if (from
        && !reader_spend(reader,
                         from->is.spline->count * MEMORY_COST * sizeof *spline->points))
        return false;
    spline = spline_new(from ? from->is.spline : NULL);
    if (!spline)
        return reader_no_memory(reader);
    value->kind = VALUE_SPLINE;
    value->is.spline = spline;
    if (from)
        reader_next(reader);
    while (accept_kind(reader, &spline->kind))
        ;
    while (good && (!spline->count || !reader_at_sign(reader, '}')))
        good = read_point(reader, spline);
    if (good)
        spline_solve(spline);
    return block_items(reader, &block, &no_words, NULL, good);
}

bool spline_is_alone(struct reader *reader)
{
    struct scene_token after;
    if (!reader_value_of(reader, VALUE_SPLINE))
        return false;
    after = reader_peek(reader);
    return !token_is_sign(&after, '(');
}

static bool read_parameter(struct reader *reader, double *t, enum spline_kind *kind)
{
    return reader_expect_sign(reader, '(') && read_full_number(reader, t)
           && (!reader_accept_sign(reader, ',') || accept_kind(reader, kind)
               || reader_expected(reader, "a kind of spline"))
           && reader_expect_sign(reader, ')');
}

/* Reads a call and evaluates it. The spline is held during the call, because a macro in
 * the parameter may redeclare its name. */
bool spline_call(struct reader *reader, struct numbers *value)
{
    struct scene_token at = reader->token;
    struct spline *spline = at.value->is.spline;
    enum spline_kind kind = spline->kind;
    double t;
    bool done;
    spline->holders++;
    reader_next(reader);
    done = read_parameter(reader, &t, &kind);
    *value = numbers_of(0);
    value->count = spline->terms;
    if (done)
        spline_value(spline, kind, t, value->n);
    spline_release(spline);
    return done && operand_finite(reader, &at, value);
}
