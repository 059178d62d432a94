/* value.c - widens, copies and frees the values of a scene text. */
#include "rt/scene/language/value.h"

#include "rt/scene/spline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct numbers numbers_of(double value)
{
    struct numbers numbers = { 1, { value, 0, 0, 0, 0 } };
    return numbers;
}

void numbers_widen(struct numbers *numbers, int count)
{
    if (numbers->count == 1)
        for (int i = 1; i < count; i++)
            numbers->n[i] = numbers->n[0];
    if (numbers->count < count)
        numbers->count = count;
}

bool numbers_are_finite(const struct numbers *numbers)
{
    for (int i = 0; i < numbers->count; i++)
        if (!isfinite(numbers->n[i]))
            return false;
    return true;
}

const char no_memory[] = "there is not enough memory";

static const char *copy_string(struct scene_value *copy, const char *text)
{
    size_t size = strlen(text) + 1;
    copy->is.string = malloc(size);
    if (!copy->is.string)
        return no_memory;
    memcpy(copy->is.string, text, size);
    return NULL;
}

const char *value_copy(struct scene_value *copy, const struct scene_value *value)
{
    *copy = *value;
    switch (value->kind) {
    case VALUE_STRING: return copy_string(copy, value->is.string);
    case VALUE_SPLINE: copy->is.spline->holders++; return NULL;
    case VALUE_ARRAY: return array_copy(&copy->is.array, value->is.array);
    case VALUE_OBJECT:
        memset(&copy->is.object, 0, sizeof copy->is.object);
        if (object_copy(&copy->is.object, &value->is.object))
            return NULL;
        scene_object_free(&copy->is.object);
        return no_memory;
    default: return NULL;
    }
}

void value_free(struct scene_value *value)
{
    switch (value->kind) {
    case VALUE_OBJECT: scene_object_free(&value->is.object); break;
    case VALUE_STRING: free(value->is.string); break;
    case VALUE_ARRAY: array_free(value->is.array); break;
    case VALUE_MACRO: free(value->is.macro); break;
    case VALUE_SPLINE: spline_release(value->is.spline); break;
    default: break;
    }
    memset(value, 0, sizeof *value);
}
