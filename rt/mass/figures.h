/* figures.h - what sums over columns say of a body: its mass properties, with errors.
 *
 * Arithmetic at the edge, in doubles: what machines have added up (columns.h) is
 * averaged over views and shifts, moved by the parallel axes' theorem, and turned to
 * principal axes.  The error of a figure is half the width of the interval that holds
 * it with 95 %: the standard error, found by leaving out one shift after another (the
 * jackknife), times Student's t.  Sources: Quenouille 1956, Tukey 1958; of t,
 * Abramowitz and Stegun 26.7.5.
 */
#ifndef RT_MASS_FIGURES_H
#define RT_MASS_FIGURES_H

#include "rt/mass/columns.h"

/* Lengths are the scene's, densities masses of its cubes.  Inertia has the products
 * with the sign that they have in the tensor: Ixy = - integral of density x y. */
enum figure {
    FIGURE_VOLUME,
    FIGURE_AREA,
    FIGURE_MASS,
    FIGURE_CENTROID,                       /* x, y, z, of the mass; NaN: it is 0 */
    FIGURE_INERTIA = FIGURE_CENTROID + 3,  /* about the point asked for: Ixx, Iyy, Izz,
                                             Ixy, Ixz, Iyz */
    FIGURE_CENTRAL = FIGURE_INERTIA + 6,   /* about the centroid, likewise */
    FIGURE_PRINCIPAL = FIGURE_CENTRAL + 6, /* three moments, rising */
    FIGURE_VIEWS = FIGURE_PRINCIPAL + 3,   /* the volume as seen along x, y, z */
    FIGURES = FIGURE_VIEWS + 3
};
const char *figure_name(size_t figure);

struct mass_figures {
    double value[FIGURES];
    double error[FIGURES]; /* NaN: of one shift none is known */
    double axes[3][3];     /* of the principal moments, each of length one */
};

/* Which parts, with which densities, make the body: 0 where one is none of it. */
struct mass_body {
    const struct columns_sums *sums;
    const double *density; /* of each part, all together not among them */
    const double *about;   /* a point */
};

/* False: no memory. */
bool mass_figures_find(const struct mass_body *body, struct mass_figures *figures);
/* In a unit of length that is 2^log times as large. */
void mass_figures_enlarge(struct mass_figures *figures, int log);
/* The volume that more than one object claims, each time that it does, and its error. */
void mass_overlap(const struct columns_sums *sums, double *volume, double *error);
/* .. that the parts of a pair claim both.  False: none, but for roundings. */
bool mass_overlap_of(const struct columns_sums *sums, size_t pair, double *volume,
                     double *error);
/* Of errors beside what they are errors of the largest, and which figure's it is:
 * moments beside the largest principal one, the centroid beside the box's diagonal. */
double mass_worst(const struct mass_figures *figures, const struct columns_sums *sums,
                  size_t *figure);

#endif
