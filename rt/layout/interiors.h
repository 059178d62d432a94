/* interiors.h - numbers the bodies that can contain a ray, and writes their table in
 * the order of rt/kernels/light/interior.s. */
#ifndef RT_LAYOUT_INTERIORS_H
#define RT_LAYOUT_INTERIORS_H

#include "base/rank_index.h"
#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* The largest number of rays of a chain that pass a surface without refraction. Such a
 * ray has the level of the previous ray, so max_trace_level does not limit these
 * rays. */
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
/* Returns the number of the body that a primitive bounds. Returns 0 if the primitive is
 * invisible or neither transmits light nor reflects by Fresnel's formulas, because rays
 * then need not store the body. */
size_t interiors_number(const struct interiors *interiors,
                        const struct primitive *primitive);
void interiors_layout(struct record_layout *layout, const struct interiors *interiors,
                      const struct scene *scene);

#endif
