/* interiors.h - numbers the bodies that can contain a ray, and writes their table in
 * the order of rt/kernels/light/interior.s. */
#ifndef RT_LAYOUT_INTERIORS_H
#define RT_LAYOUT_INTERIORS_H

#include "base/rank_index.h"
#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* A chain can have this many straight transmitted rays in addition to max_trace_level.
 * A straight ray has the level of the previous ray. */
enum { MAX_STRAIGHT = 64 };

/* Returns true if light passes through a surface of the scene. The kernels then
 * need light/interior.s. */
bool scene_has_interiors(const struct scene *scene);

/* The bodies of transparent primitives, and of primitives that reflect by Fresnel's
 * formulas. The kernels number them from 1. */
struct interiors {
    struct rank_index bodies; /* ranks of the scene's interior numbers */
    double *index;            /* refractive indices: first air, then the bodies */
};
/* Numbers the bodies of a scene. Returns false if out of memory. */
bool interiors_find(const struct scene *scene, struct interiors *interiors);
void interiors_free(struct interiors *interiors);
/* Returns the number of a primitive's body, or 0 if rays need not store it. */
size_t interiors_number(const struct interiors *interiors,
                        const struct primitive *primitive);
void interiors_layout(struct record_layout *layout, const struct interiors *interiors,
                      const struct scene *scene);

#endif
