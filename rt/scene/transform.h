/* transform.h - composes, inverts and applies the affine maps of a scene.
 *
 * Each step (translate, rotate, ..) is stored with its inverse. The inverse is computed
 * from the arguments of the step, and is therefore as accurate as the step.
 */
#ifndef RT_SCENE_TRANSFORM_H
#define RT_SCENE_TRANSFORM_H

#include "rt/scene/scene.h"

struct placement {
    struct transform to_world; /* from the object's space to world space */
    struct transform to_local; /* the inverse of to_world */
};

extern const struct placement placement_none;

struct placement placement_translation(const double by[3]);
/* Returns a scaling by these factors, none of which may be 0. */
struct placement placement_scaling(const double by[3]);
/* Returns a rotation about x, then y, then z, in degrees. The axes are left-handed: a
 * positive angle about z turns x towards y. */
struct placement placement_rotation(const double degrees[3]);
/* Computes the map of `matrix`. Its twelve numbers are rows of three that are applied
 * to row vectors; the last row is the translation. Returns false if the map has no
 * inverse. */
bool placement_matrix(const double values[12], struct placement *placement);

/* Returns the map that applies `first`, then `step`. */
struct placement placement_then(const struct placement *first,
                                const struct placement *step);
struct placement placement_inverse(const struct placement *placement);
bool placement_is_none(const struct placement *placement);
bool placement_is_finite(const struct placement *placement);

/* Returns the map that applies `first`, then `second`. */
struct transform transform_then(const struct transform *first,
                                const struct transform *second);
/* Computes the inverse of a map. Returns false if the map has none. */
bool transform_invert(const struct transform *map, struct transform *inverse);
void transform_point(const struct transform *transform, double point[3]);
/* Transforms a normal from the target space of to_local back to its source space, by
 * the transpose of to_local. The length of the normal changes. */
void transform_normal(const struct transform *to_local, double normal[3]);
void transform_direction(const struct transform *transform, double vector[3]);

#endif
