/* interiors.h - the bodies that rays are in, numbered for the kernels, in the order
 * of rt/kernels/light/interior.s. */
#ifndef RT_LAYOUT_INTERIORS_H
#define RT_LAYOUT_INTERIORS_H

#include "base/rank_index.h"
#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* So many rays that go straight on may be in a chain besides max_trace_level: they
 * are of the level of the ray before. */
enum { MAX_STRAIGHT = 64 };

/* Whether light passes through anything: the kernels need light/interior.s. */
bool scene_has_interiors(const struct scene *scene);

/* Those of the primitives that light passes through, and of mirrors by Fresnel's
 * formulas: the kernels number them from 1 on. */
struct interiors {
    struct rank_index bodies; /* of the scene's numbers */
    double *index;            /* of refraction: of air, then of each */
};
/* False: no memory. */
bool interiors_find(const struct scene *scene, struct interiors *interiors);
void interiors_free(struct interiors *interiors);
/* A primitive's, 0 if rays need not know it. */
size_t interiors_number(const struct interiors *interiors,
                        const struct primitive *primitive);
void interiors_layout(struct record_layout *layout, const struct interiors *interiors,
                      const struct scene *scene);

#endif
