/* shape_words.c - collects the data of a primitive for its kernels. */
#include "rt/shapes/shape_words.h"

#include <math.h>
#include <stdlib.h>

void shape_words(const struct primitive *primitive, struct shape_words *words)
{
    const struct shape *shape = shape_of(primitive);
    const struct shape_kernels *kernels = shape_kernels_of(primitive);
    words->count = shape->words(primitive, words->words);
    words->transformed = primitive->transformed
                         && !(shape->carry && shape->carry(primitive, words->words));
    words->kernel = kernels->kernel;
    words->normal = kernels->normal;
    words->solid = kernels->solid ? kernels->solid : kernels->kernel;
    words->state = kernels->state;
    words->segments = shape->segments ? shape->segments(primitive) : kernels->segments;
    words->on_mesh = shape->crossings != NULL;
    words->on_patch = words->on_mesh || words->segments == 0;
    words->events = words->on_mesh         ? shape->crossings(primitive)
                    : words->segments == 0 ? PATCH_CROSSINGS
                                           : 2 * words->segments;
    if (shape->has_body && shape->has_body(primitive))
        words->state = kernels->body;
    else if (kernels->inside && words->segments > 0)
        words->solid = kernels->inside;
    if (primitive->invisible) { /* treated as an open shape without a surface */
        words->state = words->state ? words->state : words->solid;
        words->solid = "invisible";
        words->events = words->on_mesh ? 2 : words->events;
    }
}

bool shape_words_historical(const struct primitive *primitive,
                            struct shape_words *words)
{
    const struct shape *shape = shape_of(primitive);
    const struct shape_kernels *kernels = shape_kernels_of(primitive);
    shape_words(primitive, words);
    if (!kernels->historical
        || (shape->is_historical && !shape->is_historical(primitive)))
        return false;
    words->kernel = kernels->historical;
    if (kernels->historical_normal) {
        words->normal = kernels->historical_normal;
        words->on_patch = true;
    }
    if (shape->historical_words)
        words->count = shape->historical_words(primitive, words->words);
    return true;
}

size_t shape_table_count(const struct primitive *primitive,
                         const struct viewpoints *viewpoints)
{
    const struct shape *shape = shape_of(primitive);
    return shape->table ? shape->table(primitive, viewpoints, NULL) : 0;
}

double *shape_table(const struct primitive *primitive,
                    const struct viewpoints *viewpoints, size_t count)
{
    double *table = calloc(count + 1, sizeof *table);
    if (table && count > 0
        && shape_of(primitive)->table(primitive, viewpoints, table) == 0) {
        free(table);
        return NULL;
    }
    return table;
}

static bool are_finite(const double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(numbers[i]))
            return false;
    return true;
}

static bool table_is_finite(const struct primitive *primitive)
{
    size_t count = shape_table_count(primitive, NULL);
    double *table = shape_table(primitive, NULL, count);
    bool finite = !table || are_finite(table, count);
    free(table);
    return finite;
}

bool shape_is_finite(const struct primitive *primitive)
{
    const struct shape *shape = shape_of(primitive);
    struct shape_words words;
    shape_words(primitive, &words);
    return are_finite(words.words, words.count)
           && (shape->is_finite ? shape->is_finite(primitive)
                                : table_is_finite(primitive));
}
