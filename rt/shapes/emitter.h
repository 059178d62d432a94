/* emitter.h - what the kernels of emission (rt/kernels/heat) want of a shape: how
 * points are spread over its surface.
 *
 * A kernel knows its surface in a space of its own, a unit sphere, a torus, or
 * pieces: frusta about the y axis, triangles.
 */
#ifndef RT_EMITTER_H
#define RT_EMITTER_H

#include "rt/shapes/primitive.h"

/* Words of a frustum: its height where it begins, what it rises by, the radii
 * there and where it ends, the normal's parts across the axis and along it.
 * Of a triangle: a corner, the edges from there to the second and the third,
 * the normal; 3 each. */
enum { FRUSTUM_WORDS = 6, TRIANGLE_WORDS = 12, EMITTER_FORM = 24 };

struct emitter {
    const char *kernel;        /* its name among the kernels */
    struct transform to_own;   /* from the kernel's space to the shape's */
    double area;               /* in the kernel's space, of the surface; or
                                    what the kernel has a weight of */
    double form[EMITTER_FORM]; /* other words of the kernel */
    size_t piece_count;        /* 0: it has none */
    size_t piece_words;        /* of each */
    double *pieces;            /* one behind another */
    double *areas;             /* of each */
};
void emitter_free(struct emitter *emitter);

/* Room for so many pieces, of which there are none yet.  False: no memory. */
bool emitter_begin(struct emitter *emitter, const char *kernel, size_t most,
                   size_t words);
/* From the height y1 and the radius r1 to y2 and r2; outside is to the right
 * of this way, x being the radius and y the height.  One without area is left
 * out. */
void emitter_add_frustum(struct emitter *emitter, double y1, double r1, double y2,
                         double r2);
/* The way from corner to corner is anticlockwise, seen from outside, in a
 * right-handed space. */
void emitter_add_triangle(struct emitter *emitter, const double a[3], const double b[3],
                          const double c[3]);

/* A surface of frusta about an axis, whose middle is the origin of the kernel's
 * space; to half its length there.  False: no memory. */
bool emitter_about_axis(struct emitter *emitter, const double base[3],
                        const double cap[3], double *half_length);
/* A cylinder or a cone, with its discs or without. */
const char *emitter_cone(const double base[3], double base_radius, const double cap[3],
                         double cap_radius, bool open, struct emitter *emitter);
/* A torus about y, whose tube is an ellipse. */
const char *emitter_torus(double major, double radial, double axial,
                          struct emitter *emitter);

/* What they say when there is none. */
extern const char emitter_no_memory[];

#endif
