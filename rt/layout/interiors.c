#include "rt/layout/interiors.h"

#include <stdlib.h>

#include "rt/layout/surface.h"
#include "rt/shapes/primitive.h"

enum { BITS = 46 }; /* one fewer than whole numbers have */

bool scene_has_interiors(const struct scene *scene)
{
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (pigment_is_clear(&scene->primitives[i].pigment))
            return true;
    return false;
}

static bool is_wanted(const struct primitive *primitive)
{
    return !primitive->unseen
           && (pigment_is_clear(&primitive->pigment)
               || surface_mirror_kind(&primitive->finish) == MIRROR_FRESNEL);
}

static int compare_numbers(const void *a, const void *b)
{
    const size_t *x = a, *y = b;

    return (*x > *y) - (*x < *y);
}

bool interiors_find(const struct scene *scene, struct interiors *interiors)
{
    size_t *numbers = malloc((scene->primitive_count + 1) * sizeof *numbers);
    size_t count = 0, kept = 0;

    *interiors = (struct interiors){ .numbers = numbers };
    if (!numbers)
        return false;
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (is_wanted(&scene->primitives[i]))
            numbers[count++] = scene->primitives[i].interior;
    qsort(numbers, count, sizeof *numbers, compare_numbers);
    for (size_t i = 0; i < count; i++)
        if (kept == 0 || numbers[kept - 1] != numbers[i])
            numbers[kept++] = numbers[i];
    interiors->index = malloc((kept + 1) * sizeof *interiors->index);
    if (!interiors->index)
        return false;
    interiors->count = kept;
    for (size_t i = 0; i < scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        size_t number = interiors_number(interiors, primitive);

        if (number > 0)
            interiors->index[number - 1] = primitive->ior;
    }
    return true;
}

void interiors_free(struct interiors *interiors)
{
    free(interiors->numbers);
    free(interiors->index);
}

size_t interiors_number(const struct interiors *interiors,
                        const struct primitive *primitive)
{
    const size_t *place;

    if (!is_wanted(primitive))
        return 0;
    place = bsearch(&primitive->interior, interiors->numbers,
                    interiors->count, sizeof *place, compare_numbers);
    return place ? (size_t)(place - interiors->numbers) + 1 : 0;
}

/* Air, then the bodies. */
static uint64_t layout_table(struct record_layout *layout,
                             const struct interiors *interiors)
{
    size_t size = interiors->count + 1;
    c205_word *words = malloc(size * sizeof *words);
    uint64_t table = layout_reserve(layout, size);
    double air = 1;

    if (!words) {
        layout_fail(layout, "no memory");
        return table;
    }
    put_numbers(words, &air, 1);
    put_numbers(words + 1, interiors->index, interiors->count);
    layout_words(layout, table, words, size);
    free(words);
    return table;
}

void interiors_layout(struct record_layout *layout,
                      const struct interiors *interiors,
                      const struct scene *scene)
{
    double base = 2, numbers[5] = { 0 };
    c205_word words[1 + 5];
    size_t bits = 1;

    if (!scene_has_interiors(scene))
        return;
    for (; base <= (double)interiors->count; base *= 2)
        bits++;
    numbers[0] = base;
    numbers[1] = 1 / base;
    if (interiors->count > BITS / bits) {
        numbers[2] = 1;
        for (size_t i = 1; i < BITS / bits; i++)
            numbers[2] *= base;
        numbers[3] = 1 / numbers[2];
    }
    numbers[4] = (double)scene->max_trace_level;
    words[0] = layout_table(layout, interiors);
    put_numbers(words + 1, numbers, 5);
    layout_words(layout, layout_symbol(layout, "scene_interiors"), words,
                 1 + 5);
}
