/* emitter.h - surface sampling of a shape for the kernels of emission
 * (rt/kernels/heat).
 *
 * A kernel samples its surface in a space of its own: a unit sphere, a torus, or
 * pieces, which are frusta about the y axis or triangles.
 */
#ifndef RT_EMITTER_H
#define RT_EMITTER_H

#include "rt/shapes/primitive.h"

/* Words of a frustum: height of its start, rise, radius at the start, radius at the
 * end, components of the normal across the axis and along it. Words of a triangle: a
 * corner, the edges from it to the second and the third corner, the normal; 3 each. */
enum { FRUSTUM_WORDS = 6, TRIANGLE_WORDS = 12, EMITTER_FORM = 24 };

struct emitter {
    const char *kernel;        /* its name */
    struct transform to_own;   /* from the kernel's space to the shape's */
    double area;               /* of the surface in the kernel's space, or the total of
                                * the kernel's weights */
    double form[EMITTER_FORM]; /* other parameters of the kernel */
    size_t piece_count;        /* 0: no pieces */
    size_t piece_words;        /* of each piece */
    double *pieces;            /* consecutive */
    double *areas;             /* of each piece */
};
void emitter_free(struct emitter *emitter);

/* Reserves space for pieces. Fails without memory. */
bool emitter_begin(struct emitter *emitter, const char *kernel, size_t most,
                   size_t words);
/* Adds a frustum from height y1 and radius r1 to y2 and r2. The outside is to the right
 * of this direction if x is the radius and y the height. A frustum without area is
 * skipped. */
void emitter_add_frustum(struct emitter *emitter, double y1, double r1, double y2,
                         double r2);
/* Adds a triangle. Its corners are anticlockwise seen from outside, in a right-handed
 * space. */
void emitter_add_triangle(struct emitter *emitter, const double a[3], const double b[3],
                          const double c[3]);

/* Begins a surface of frusta about an axis, whose midpoint is the origin of the
 * kernel's space. Sets half the length of the axis. Fails without memory. */
bool emitter_about_axis(struct emitter *emitter, const double base[3],
                        const double cap[3], double *half_length);
/* Adds a cylinder or a cone, with its discs unless it is open. */
const char *emitter_cone(const double base[3], double base_radius, const double cap[3],
                         double cap_radius, bool open, struct emitter *emitter);
/* Sets a torus about y with an elliptical tube. */
const char *emitter_torus(double major, double radial, double axial,
                          struct emitter *emitter);

/* The reason that emitters return without memory. */
extern const char emitter_no_memory[];

#endif
