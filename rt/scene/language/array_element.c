/* array_element.c - parses arrays and their elements.
 *
 *   array[n]...  { { value, ... }, ... }
 *   NAME[i]...
 */
#include "rt/scene/language/array_element.h"

#include "rt/scene/language/declare.h"
#include "rt/scene/language/scene_expression.h"

/* ---- Elements ------------------------------------------------------------ */

/* Reads a size or an index from "[" to "]". The "]" stays the current token, so that
 * the text after it is not yet interpreted. As in POV-Ray, the value is truncated. */
static bool read_size(struct reader *reader, double most, size_t *size)
{
    struct scene_token at;
    double value;
    if (!reader_require_sign(reader, '['))
        return false;
    reader_next(reader);
    at = reader->token;
    if (!read_number(reader, &value))
        return false;
    if (value < 0 || value >= most + 1)
        return reader_fault(reader, &at, "%g is not between 0 and %.0f", value, most);
    *size = (size_t)value;
    return reader_require_sign(reader, ']');
}

static bool bracket_follows(struct reader *reader)
{
    struct scene_token token = reader_peek(reader);
    return token_is_sign(&token, '[');
}

static bool read_indices(struct reader *reader, const struct array *array,
                         size_t *element)
{
    size_t dimensions = array->dimensions, sizes[MAX_DIMENSIONS];
    for (size_t i = 0; i < dimensions; i++)
        sizes[i] = array->sizes[i];
    *element = 0;
    for (size_t i = 0; i < dimensions; i++) {
        size_t index = 0;
        reader_step(reader);
        if (!read_size(reader, (double)sizes[i] - 1, &index))
            return false;
        *element = *element * sizes[i] + index;
    }
    return true;
}

/* Reads the indices of an array. The expressions in them may change the array, so its
 * value is looked up again. */
static bool read_hop(struct reader *reader, struct scene_token *name)
{
    struct reference *reference = &name->reference;
    if (reference->hops == MAX_ARRAY_NESTING)
        return reader_fault(reader, name, "more than %d nested arrays",
                            MAX_ARRAY_NESTING);
    if (!read_indices(reader, name->value->is.array,
                      &reference->element[reference->hops]))
        return false;
    reference->hops++;
    name->value = reference_value(reference);
    return true;
}

static bool read_hops(struct reader *reader, struct scene_token *name)
{
    bool done = true;
    while (done && name->value && name->value->kind == VALUE_ARRAY
           && bracket_follows(reader))
        done = read_hop(reader, name);
    return done;
}

bool element_read_place(struct reader *reader)
{
    struct scene_token name = reader->token;
    size_t hold = reader_nest(reader);
    bool done = false;
    symbol_hold(name.reference.symbol);
    if (reader_enter(reader)) {
        done = read_hops(reader, &name);
        reader_leave(reader);
    }
    reader->hold = hold;
    if (!symbol_release(name.reference.symbol)) {
        name.reference = (struct reference){ NULL, 0, { 0 } };
        name.value = NULL;
        reader->token = name;
        return reader_fault(reader, &name,
                            "the array of this element no longer exists");
    }
    if (done)
        reader->token = name;
    return done;
}

bool element_read(struct reader *reader)
{
    static const struct scene_value faulty = { .kind = VALUE_FAULTY };
    if (!element_read_place(reader))
        return false;
    if (!reader->token.value) {
        reader_fault(reader, &reader->token, "the element is not set");
        reader->token.value = &faulty;
    }
    return true;
}

/* ---- Arrays -------------------------------------------------------------- */

static bool read_row(struct reader *reader, struct array *array, size_t dimension,
                     size_t *element);

static bool read_cell(struct reader *reader, struct array *array, size_t dimension,
                      size_t *element)
{
    struct scene_token at = reader->token;
    struct scene_value value;
    if (dimension + 1 < array->dimensions)
        return read_row(reader, array, dimension + 1, element);
    if (!value_read(reader, &value))
        return false;
    if (value.kind == VALUE_ARRAY
        && array_nesting(value.is.array) == MAX_ARRAY_NESTING) {
        value_free(&value);
        return reader_fault(reader, &at, "more than %d nested arrays",
                            MAX_ARRAY_NESTING);
    }
    return reader_check(reader, &at, array_set(array, (*element)++, &value));
}

static bool read_row(struct reader *reader, struct array *array, size_t dimension,
                     size_t *element)
{
    if (!reader_expect_sign(reader, '{'))
        return false;
    for (size_t i = 0; i < array->sizes[dimension]; i++) {
        if (!read_cell(reader, array, dimension, element))
            return false;
        reader_comma(reader);
    }
    return reader_expect_sign(reader, '}');
}

static bool read_sizes(struct reader *reader, size_t *dimensions, size_t *sizes)
{
    *dimensions = 0;
    do {
        struct scene_token at = reader->token;
        if (*dimensions == MAX_DIMENSIONS)
            return reader_fault(reader, &at, "more than %d dimensions", MAX_DIMENSIONS);
        if (!read_size(reader, MAX_CELLS, &sizes[*dimensions]))
            return false;
        if (!sizes[(*dimensions)++])
            return reader_fault(reader, &at, "the array has no elements");
        reader_pass(reader);
    } while (reader_at_sign(reader, '['));
    return true;
}

/* Reads the sizes of an array and its elements in braces. Without braces, the elements
 * are not set. */
bool array_read(struct reader *reader, struct scene_value *value)
{
    struct scene_token at = reader->token;
    size_t dimensions, sizes[MAX_DIMENSIONS], element = 0;
    reader_step(reader);
    if (!read_sizes(reader, &dimensions, sizes))
        return false;
    value->is.array = array_new(dimensions, sizes, &reader->cells);
    if (!value->is.array)
        return reader_fault(reader, &at,
                            "more than %d elements in all arrays, or no memory",
                            MAX_CELLS);
    value->kind = VALUE_ARRAY;
    return reader_spend(reader, value->is.array->count * TOKEN_COST)
           && (!reader_at_sign(reader, '{')
               || read_row(reader, value->is.array, 0, &element));
}
