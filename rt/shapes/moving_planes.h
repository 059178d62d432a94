/* moving_planes.h - the implicit side of a Steiner patch.
 *
 * H(p) = sum of the control points times the quadratic monomials of
 * p = (s, t, u).  A moving plane is a 3 x 4 matrix L with p . (L H(p)) = 0 for
 * all p.  How many of them are independent tells what the surface is, if it is
 * no plane.
 * Formulas: rt/kernels/shapes/steiner_implicit_vector.s.
 */
#ifndef RT_MOVING_PLANES_H
#define RT_MOVING_PLANES_H

#include <stdbool.h>

enum surface_type {
    SURFACE_PLANE,
    SURFACE_STEINER = 2, /* of the fourth degree, two moving planes */
    SURFACE_CUBIC = 3,   /* one base point, three of them */
    SURFACE_QUADRIC = 4  /* two base points, four of them; or twice covered */
};

struct moving_planes {
    enum surface_type type;
    double l[2][3][4]; /* of a Steiner surface */
    double triple[4];  /* its triple point */
};

/* points: x y z w of the forms' coefficients ss tt uu st tu us, the mixed ones
 * halved; x y z of the order of 1, as w is. */
void moving_planes_find(const double points[6][4], struct moving_planes *planes);

#endif
