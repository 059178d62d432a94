/* moving_planes.h - computes the implicit form of a Steiner patch.
 *
 * H(p) is the sum of the control points times the quadratic monomials of p = (s, t, u).
 * A moving plane is a 3 x 4 matrix L with p . (L H(p)) = 0 for all p. The number of
 * independent moving planes determines the type of the surface, unless it is a plane.
 * Formulas: rt/kernels/shapes/steiner_implicit.s.
 */
#ifndef RT_MOVING_PLANES_H
#define RT_MOVING_PLANES_H

#include <stdbool.h>

enum surface_type {
    SURFACE_PLANE,
    SURFACE_STEINER = 2, /* degree four, two moving planes */
    SURFACE_CUBIC = 3,   /* one base point; three moving planes */
    SURFACE_QUADRIC = 4  /* two base points, or covered twice; four moving planes */
};

struct moving_planes {
    enum surface_type type;
    double l[2][3][4]; /* two moving planes of a surface of degree four */
    double triple[4];  /* triple point of this surface */
};

/* Computes the moving planes of the patch H(s, t, u). The rows of `points` are the
 * coefficients of ss, tt, uu, st, tu and us in H; those of st, tu and us are halved.
 * Each has the elements x, y, z and w, of the order of 1. */
void moving_planes_find(const double points[6][4], struct moving_planes *planes);

#endif
