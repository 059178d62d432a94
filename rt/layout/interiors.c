/* interiors.c - numbers the bodies that can contain a ray. */
#include "rt/layout/interiors.h"

#include <math.h>
#include <stdlib.h>

#include "rt/layout/surface.h"
#include "rt/shapes/primitive.h"

enum { BITS = 46 }; /* for a set of bodies: one bit less than an integer has */

bool scene_has_interiors(const struct scene *scene)
{
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (pigment_is_clear(&scene->primitives[i].pigment))
            return true;
    return false;
}

static bool is_wanted(const struct primitive *primitive)
{
    return !primitive->invisible
           && (pigment_is_clear(&primitive->pigment)
               || surface_mirror_kind(&primitive->finish) == MIRROR_FRESNEL);
}

bool interiors_find(const struct scene *scene, struct interiors *interiors)
{
    struct rank_index *bodies = &interiors->bodies;
    interiors->index = NULL;
    if (!rank_index_begin(bodies, scene->primitive_count))
        return false;
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (is_wanted(&scene->primitives[i]))
            rank_index_add(bodies, scene->primitives[i].interior);
    rank_index_sort(bodies);
    interiors->index = calloc(bodies->count + 1, sizeof *interiors->index);
    if (!interiors->index)
        return false;
    interiors->index[0] = 1; /* air has index 1 */
    for (size_t i = 0; i < scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        if (is_wanted(primitive))
            interiors->index[interiors_number(interiors, primitive)] = primitive->ior;
    }
    return true;
}

void interiors_free(struct interiors *interiors)
{
    rank_index_free(&interiors->bodies);
    free(interiors->index);
}

size_t interiors_number(const struct interiors *interiors,
                        const struct primitive *primitive)
{
    return is_wanted(primitive)
               ? rank_index_place(&interiors->bodies, primitive->interior)
               : 0;
}

static uint64_t layout_table(struct record_layout *layout,
                             const struct interiors *interiors)
{
    size_t size = interiors->bodies.count + 1;
    c205_word *words = malloc(size * sizeof *words);
    uint64_t table = layout_reserve(layout, size);
    if (!words) {
        layout_fail(layout, "out of memory");
        return table;
    }
    put_numbers(words, interiors->index, size);
    layout_words(layout, table, words, size);
    free(words);
    return table;
}

/* Writes the table and the constants of rt/kernels/light/interior.s. The set of bodies
 * that contain a ray is one integer: its digits in the base 2^bits are the numbers of
 * the bodies. The integer has at most BITS bits. If a scene has more bodies than the
 * integer has digits, `full` is the power of the base above which the ray's first body
 * is dropped. Otherwise `full` is 0. */
void interiors_layout(struct record_layout *layout, const struct interiors *interiors,
                      const struct scene *scene)
{
    enum { NUMBERS = 5 };
    int bits = 1, room; /* bits of a body's number; number of digits */
    double base, full;
    c205_word words[1 + NUMBERS];
    if (!scene_has_interiors(scene))
        return;
    while (interiors->bodies.count >> bits > 0)
        bits++;
    room = BITS / bits;
    base = ldexp(1, bits);
    full = interiors->bodies.count > (size_t)room ? ldexp(1, bits * (room - 1)) : 0;
    words[0] = layout_table(layout, interiors);
    put_numbers(words + 1,
                (double[NUMBERS]){ base, 1 / base, full, full > 0 ? 1 / full : 0,
                                   (double)scene->max_trace_level },
                NUMBERS);
    layout_words(layout, layout_symbol(layout, "scene_interiors"), words, 1 + NUMBERS);
}
