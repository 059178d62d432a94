/* primitive.c - parses the arguments of primitives, which are listed in the fields of
 * their shapes (rt/shapes). */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"
#include "rt/shapes/shape.h"

#include <math.h>
#include <string.h>

/* ---- One argument -------------------------------------------------------- */

/* Reads a radius, and uses its absolute value. */
static bool read_radius(struct reader *reader, double *radius)
{
    if (!read_number(reader, radius))
        return false;
    *radius = fabs(*radius);
    return true;
}

static bool read_size(struct reader *reader, const char *what, double *size)
{
    struct scene_token at = reader->token;
    if (!read_number(reader, size))
        return false;
    return *size > 0 || reader_fault(reader, &at, "the %s must be above 0", what);
}

/* Reads `count` coefficients in <..>. It also reads surplus coefficients, so that the
 * message contains their number. */
static bool read_terms(struct reader *reader, double *terms, size_t count)
{
    struct scene_token at = reader->token;
    size_t found = 0;
    double value;
    if (!reader_expect_sign(reader, '<'))
        return false;
    do {
        if (!read_number(reader, &value))
            return false;
        if (found < count)
            terms[found] = value;
        found++;
        reader_comma(reader);
    } while (!reader_at_sign(reader, '>'));
    if (found != count)
        reader_fault(reader, &at, "expected %zu coefficients, found %zu", count, found);
    return reader_expect_sign(reader, '>') && found == count;
}

/* ---- Paths --------------------------------------------------------------- */

static bool read_count(struct reader *reader, size_t least, size_t *count)
{
    struct scene_token at = reader->token;
    double number;
    if (!read_number(reader, &number))
        return false;
    if (number < (double)least)
        return reader_fault(reader, &at, "a path must have at least %s points",
                            least == 2 ? "two" : "three");
    if (number > MAX_PATH)
        return reader_fault(reader, &at, "more than %d points in one path", MAX_PATH);
    *count = (size_t)number;
    return true;
}

/* Reads a count, then that many points. A point is a vector, of which the first two
 * components are used. The array has space for twice as many points, because curves
 * have handles between their points. */
static bool read_path(struct reader *reader, size_t least, struct outline *path)
{
    double vector[3];
    if (!read_count(reader, least, &path->count))
        return false;
    path->points = arena_take(&reader->scene->kept,
                              2 * path->count * sizeof *path->points);
    if (!path->points)
        return reader_no_memory(reader);
    for (size_t i = 0; i < path->count; i++) {
        reader_comma(reader);
        if (!read_vector(reader, vector))
            return false;
        memcpy(path->points[i], vector, sizeof path->points[i]);
    }
    return true;
}

/* ---- All arguments ------------------------------------------------------- */

/* Returns the number of doubles in one element of the argument. */
static size_t width_of(const struct shape_field *field)
{
    return field->takes == TAKES_VECTOR ? 3 : 1;
}

static bool read_more(struct reader *reader, double *to)
{
    return !starts_expression(reader) || read_number(reader, to);
}

static bool read_one(struct reader *reader, const struct shape_field *field, double *to)
{
    switch (field->takes) {
    case TAKES_NUMBER: return read_number(reader, to);
    case TAKES_VECTOR: return read_vector(reader, to);
    case TAKES_RADIUS: return read_radius(reader, to);
    case TAKES_SIZE: return read_size(reader, field->what, to);
    case TAKES_MORE: return read_more(reader, to);
    case TAKES_TERMS: return read_terms(reader, to, field->count);
    case TAKES_WORD:
    case TAKES_USUAL:
    case TAKES_OTHER:
    case TAKES_PATH:
    case TAKES_END: break;
    }
    return false;
}

/* Reads the elements of an argument. A comma may precede each element, except the first
 * element of all arguments. */
static bool read_row(struct reader *reader, const struct shape_field *field, bool first,
                     double *to)
{
    size_t count = field->count > 0 && field->takes != TAKES_TERMS ? field->count : 1;
    for (size_t i = 0; i < count; i++) {
        if (i > 0 || !first)
            reader_comma(reader);
        if (!read_one(reader, field, to + i * width_of(field)))
            return false;
    }
    return true;
}

static bool is_word(const struct shape_field *field)
{
    return field->takes == TAKES_WORD || field->takes == TAKES_USUAL
           || field->takes == TAKES_OTHER;
}

static bool read_word(struct reader *reader, const struct shape_field *field, bool *to)
{
    struct scene_token at = reader->token;
    bool there = reader_accept(reader, field->what);
    if (field->takes == TAKES_WORD)
        *to = there;
    return !there || field->takes != TAKES_OTHER
           || reader_fault(reader, &at, "'%s' is not supported", field->what);
}

/* Reads an argument. An optional argument follows a keyword. A comma before this
 * keyword belongs to the previous argument. */
static bool read_field(struct reader *reader, const struct shape_field *field,
                       bool first, struct primitive *primitive)
{
    void *to = (char *)primitive + field->offset;
    if (is_word(field))
        return read_word(reader, field, to);
    if (field->takes == TAKES_PATH) {
        reader_comma(reader);
        return read_path(reader, field->count, to);
    }
    if (field->behind) {
        reader_comma(reader);
        if (!reader_accept(reader, field->behind))
            return true;
    }
    return read_row(reader, field, first, to);
}

/* Replaces the primitive by a sphere that is marked as the empty set. A sphere is used
 * because it has an inside, as solids require. */
void primitive_leave_out(struct reader *reader, struct primitive *primitive,
                         const struct scene_token *at, const char *reason)
{
    reader_report(reader, at, "%s: the shape is ignored", reason);
    primitive->kind = PRIMITIVE_SPHERE;
    memset(&primitive->shape, 0, sizeof primitive->shape);
    primitive->empty = true;
}

bool primitive_finish(struct reader *reader, struct primitive *primitive,
                      const struct scene_token *at)
{
    const char *fault = shapes[primitive->kind]->finish(primitive);
    if (!fault || !primitive->empty)
        return reader_check(reader, at, fault);
    primitive_leave_out(reader, primitive, at, fault);
    return true;
}

bool primitive_read(struct reader *reader, enum primitive_kind kind,
                    struct primitive *primitive)
{
    const struct shape_field *fields = shapes[kind]->fields;
    struct scene_token at = reader->token;
    memset(primitive, 0, sizeof *primitive);
    primitive->kind = kind;
    for (size_t i = 0; fields[i].takes != TAKES_END; i++)
        if (!read_field(reader, &fields[i], i == 0, primitive))
            return false;
    return primitive_finish(reader, primitive, &at);
}

/* ---- Polynomials --------------------------------------------------------- */

enum { MIN_ORDER = 2, MAX_ORDER = 4 };

static bool read_order(struct reader *reader, int *order)
{
    struct scene_token at = reader->token;
    double number;
    if (!read_number(reader, &number))
        return false;
    reader_comma(reader);
    if (number < MIN_ORDER || number >= MAX_ORDER + 1)
        return reader_fault(reader, &at,
                            "a polynomial of order %g is not supported; the "
                            "order must be between %d and %d",
                            number, MIN_ORDER, MAX_ORDER);
    *order = (int)number;
    return true;
}

/* Returns the number of coefficients of a polynomial of this order in x, y and z. */
static size_t terms_of(int order)
{
    size_t n = (size_t)order;
    return (n + 1) * (n + 2) * (n + 3) / 6;
}

/* Makes a quartic from a polynomial of lower order. The coefficients of the polynomial
 * have the same order as those of a quartic, but terms of higher degree are missing and
 * become 0. */
static void make_quartic(const double *terms, int order, struct primitive *primitive)
{
    double *quartic = primitive->shape.quartic.coefficients;
    primitive->kind = PRIMITIVE_QUARTIC;
    for (int x = MAX_ORDER; x >= 0; x--)
        for (int y = MAX_ORDER - x; y >= 0; y--)
            for (int z = MAX_ORDER - x - y; z >= 0; z--)
                *quartic++ = x + y + z <= order ? *terms++ : 0;
}

/* Reorders the coefficients of x^2 xy xz x y^2 yz y z^2 z 1 to the order of quadrics,
 * x^2 y^2 z^2 xy xz yz x y z 1. */
static void make_quadric(const double *terms, struct primitive *primitive)
{
    static const size_t places[QUADRIC_TERMS] = { 0, 3, 4, 6, 1, 5, 7, 2, 8, 9 };
    primitive->kind = PRIMITIVE_QUADRIC;
    for (size_t i = 0; i < QUADRIC_TERMS; i++)
        primitive->shape.quadric.coefficients[places[i]] = terms[i];
}

bool polynomial_read(struct reader *reader, enum shape_word word,
                     struct primitive *primitive)
{
    double terms[QUARTIC_TERMS];
    struct scene_token at = reader->token;
    int order = 3;
    memset(primitive, 0, sizeof *primitive);
    if (word == SHAPE_POLY && !read_order(reader, &order))
        return false;
    if (!read_terms(reader, terms, terms_of(order)))
        return false;
    if (order == 2)
        make_quadric(terms, primitive);
    else
        make_quartic(terms, order, primitive);
    return primitive_finish(reader, primitive, &at);
}
