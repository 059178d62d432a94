/* array.c - allocates, copies and frees the arrays of a scene text. */
#include "rt/scene/language/value.h"
#include "vm/error.h"

#include <stdlib.h>
#include <string.h>

struct array *array_new(size_t dimensions, const size_t *sizes, size_t *cells)
{
    struct array *array;
    size_t count = 1;
    for (size_t i = 0; i < dimensions; i++) {
        if (sizes[i] > MAX_CELLS / count)
            return NULL;
        count *= sizes[i];
    }
    if (count > MAX_CELLS - *cells)
        return NULL;
    array = calloc(1, sizeof *array + count * sizeof *array->cell);
    if (!array)
        return NULL;
    array->dimensions = dimensions;
    memcpy(array->sizes, sizes, dimensions * sizeof *sizes);
    array->count = count;
    array->cells = cells;
    *cells += count;
    return array;
}

void array_free(struct array *array)
{
    *array->cells -= array->count;
    for (size_t i = 0; i < array->count; i++)
        if (array->cell[i]) {
            value_free(array->cell[i]);
            free(array->cell[i]);
        }
    free(array);
}

static bool array_takes(struct array *array, const struct scene_value *value)
{
    int terms = value->kind == VALUE_NUMBERS ? value->is.numbers.count : 0;
    if (value->kind == VALUE_FAULTY)
        return true;
    if (!array->typed) {
        array->typed = true;
        array->kind = value->kind;
        array->terms = terms;
    }
    return array->kind == value->kind && array->terms == terms;
}

const char *array_set(struct array *array, size_t element, struct scene_value *value)
{
    struct scene_value **cell = &array->cell[element];
    if (!array_takes(array, value)) {
        value_free(value);
        return "the array contains values of another kind";
    }
    if (*cell)
        value_free(*cell);
    else
        *cell = malloc(sizeof **cell);
    if (!*cell) {
        value_free(value);
        return no_memory;
    }
    **cell = *value;
    return NULL;
}

static const char *copy_cells(struct array *copy, const struct array *array)
{
    const char *fault = NULL;
    for (size_t i = 0; i < array->count && !fault; i++) {
        struct scene_value value;
        if (!array->cell[i])
            continue;
        fault = value_copy(&value, array->cell[i]);
        if (!fault)
            fault = array_set(copy, i, &value);
    }
    return fault;
}

const char *array_copy(struct array **copy, const struct array *array)
{
    const char *fault;
    *copy = array_new(array->dimensions, array->sizes, array->cells);
    if (!*copy)
        return "not enough memory, or too many array elements: "
               "at most " LIMIT_TEXT(MAX_CELLS);
    fault = copy_cells(*copy, array);
    if (fault)
        array_free(*copy);
    return fault;
}

size_t array_nesting(const struct array *array)
{
    size_t most = 0;
    for (size_t i = 0; i < array->count && array->kind == VALUE_ARRAY; i++)
        if (array->cell[i] && array->cell[i]->kind == VALUE_ARRAY) {
            size_t inner = array_nesting(array->cell[i]->is.array);
            most = inner > most ? inner : most;
        }
    return most + 1;
}

size_t array_primitives(const struct array *array)
{
    size_t sum = 0;
    for (size_t i = 0; i < array->count; i++) {
        const struct scene_value *value = array->cell[i];
        if (value && value->kind == VALUE_ARRAY)
            sum += array_primitives(value->is.array);
        else if (value && value->kind == VALUE_OBJECT)
            sum += value->is.object.part_count + value->is.object.light_count;
    }
    return sum;
}
