/* emitter.h - builds the data with which the kernels of emission (rt/kernels/heat)
 * sample the surface of a shape.
 *
 * A kernel samples the surface in its own space. The surface is a unit sphere, a torus,
 * or a list of pieces: frusta about the y axis, or triangles.
 */
#ifndef RT_EMITTER_H
#define RT_EMITTER_H

#include "rt/shapes/primitive.h"

/* The words of a frustum are the height of its start, the rise, the radius at the
 * start, the radius at the end, and the components of the normal across the axis and
 * along it. The words of a triangle are four vectors: the first corner, the edges from
 * it to the second and the third corner, and the normal. EMITTER_FORM is the largest
 * number of other parameters of a kernel. */
enum { FRUSTUM_WORDS = 6, TRIANGLE_WORDS = 12, EMITTER_FORM = 24 };

struct emitter {
    const char *kernel;        /* name of the kernel */
    struct transform to_own;   /* from the kernel's space to the shape's space */
    double area;               /* area of the surface in the kernel's space, or the sum
                                * of the kernel's weights */
    double form[EMITTER_FORM]; /* other parameters of the kernel */
    size_t piece_count;        /* 0: no pieces */
    size_t piece_words;        /* words in a piece */
    double *pieces;            /* pieces at consecutive positions */
    double *areas;             /* area of each piece */
};
void emitter_free(struct emitter *emitter);

/* Reserves space for up to `most` pieces of `words` words each. Returns false if out of
 * memory. */
bool emitter_begin(struct emitter *emitter, const char *kernel, size_t most,
                   size_t words);
/* Adds a frustum from height y1 and radius r1 to height y2 and radius r2. In a drawing
 * with the radius to the right and the height upwards, the outside is to the right of
 * this direction. A frustum without area is skipped. */
void emitter_add_frustum(struct emitter *emitter, double y1, double r1, double y2,
                         double r2);
/* Adds a triangle. Its corners are anticlockwise as seen from outside, in a
 * right-handed space. */
void emitter_add_triangle(struct emitter *emitter, const double a[3], const double b[3],
                          const double c[3]);

/* Begins a surface of frusta about an axis. The origin of the kernel's space is the
 * midpoint of the axis. Sets *half_length to half the length of the axis. Returns false
 * if out of memory. */
bool emitter_about_axis(struct emitter *emitter, const double base[3],
                        const double cap[3], double *half_length);
/* Describes a cylinder or a cone, with its end discs unless `open` is true. Returns
 * NULL, or an error message. */
const char *emitter_cone(const double base[3], double base_radius, const double cap[3],
                         double cap_radius, bool open, struct emitter *emitter);
/* Describes a torus about the y axis with an elliptical tube. Returns NULL, or the
 * reason why the torus cannot emit. */
const char *emitter_torus(double major, double radial, double axial,
                          struct emitter *emitter);

/* The error message of the emitters if out of memory. */
extern const char emitter_no_memory[];

#endif
