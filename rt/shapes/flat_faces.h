/* flat_faces.h - the functions with which the descriptors of shapes add their flat
 * faces. The arguments are in the primitive's own space. */
#ifndef RT_FLAT_FACES_H
#define RT_FLAT_FACES_H

#include "rt/shapes/shape_bound.h"

struct face_search; /* the primitive, and the list of faces (opaque_faces.c) */

/* These functions add a flat face that contains `point`. The length of the normal is
 * arbitrary. If `outward` is true, the solid is on the side opposite to the normal,
 * otherwise its side is unknown. The face is inside a bound in world space, the hull of
 * points, or a circle. */
void faces_add_flat(struct face_search *search, const double normal[3],
                    const double point[3], bool outward, const struct bound *box);
void faces_add_hull(struct face_search *search, const double normal[3],
                    const double point[3], bool outward, const struct hull *hull);
void faces_add_ring(struct face_search *search, const double center[3],
                    const double axis[3], double radius, bool outward);
/* Adds the disks at both ends of an axis. */
void faces_add_disks(struct face_search *search, const double base[3],
                     double base_radius, const double cap[3], double cap_radius);
/* Adds the caps of a prism. */
void faces_add_caps(struct face_search *search, const struct outline *path, double low,
                    double high);
/* Adds triangles. Those of the same plane become one face. */
void faces_add_triangles(struct face_search *search, const struct triangles *triangles);

#endif
