/* transform.h - affine maps as a scene file writes them.
 *
 * A step (translate, rotate, ...) is kept with its inverse, which is made from
 * the step itself and so is as exact as the step.
 */
#ifndef RT_SCENE_TRANSFORM_H
#define RT_SCENE_TRANSFORM_H

#include "rt/scene/scene.h"

struct placement {
    struct transform to_world; /* where the placed points go */
    struct transform to_local; /* and back */
};

extern const struct placement placement_none;

struct placement placement_translation(const double by[3]);
/* No component may be 0. */
struct placement placement_scaling(const double by[3]);
/* About x, then y, then z; degrees; the axes are left-handed, so that a
 * positive angle about z turns x towards y. */
struct placement placement_rotation(const double degrees[3]);
/* The language's twelve numbers: rows of three, a point being a row to their
 * left, the last row the translation.  False when there is no inverse. */
bool placement_matrix(const double values[12], struct placement *placement);

/* What is first placed, then moved by the step. */
struct placement placement_then(const struct placement *first,
                                const struct placement *step);
struct placement placement_inverse(const struct placement *placement);
bool placement_is_none(const struct placement *placement);
bool placement_is_finite(const struct placement *placement);

/* The map that does `first`, then `second`. */
struct transform transform_then(const struct transform *first,
                                const struct transform *second);
/* False when there is no inverse. */
bool transform_invert(const struct transform *map, struct transform *inverse);
void transform_point(const struct transform *transform, double point[3]);
/* A normal from the space that to_local leads to, by the transposed inverse; its
 * length changes. */
void transform_normal(const struct transform *to_local, double normal[3]);
void transform_direction(const struct transform *transform, double vector[3]);

#endif
