/* value.c - numbers, and values of every kind. */
#include "rt/scene/value.h"

#include <math.h>
#include <string.h>

static const char *const kind_names[] = {
    "a number",    "a pigment", "a finish",  "a texture",
    "a transform", "a camera",  "an object", "nothing",
};

const char *value_kind_name(enum value_kind kind)
{
    return kind_names[kind];
}

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

void value_free(struct value *value)
{
    if (value->kind == VALUE_OBJECT)
        scene_object_free(&value->is.object);
    memset(value, 0, sizeof *value);
}
