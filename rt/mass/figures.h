/* figures.h - computes the mass properties of a body from sums over columns, with
 * errors.
 *
 * The host computes the properties in doubles. It averages the sums of the machines
 * (columns.h) over views and shifts, applies the parallel axis theorem, and computes
 * the principal axes. The error of a figure is half the width of its 95 % confidence
 * interval. It is the standard error times Student's t. The jackknife estimates the
 * standard error by omitting one shift at a time. Sources: Quenouille 1956, Tukey 1958;
 * for t, Abramowitz and Stegun 26.7.5.
 */
#ifndef RT_MASS_FIGURES_H
#define RT_MASS_FIGURES_H

#include "rt/mass/columns.h"

/* Lengths are in the unit of the scene, and densities are masses per cube of this unit.
 * A product of inertia has the sign of the element in the tensor: Ixy is minus the
 * integral of density * x * y. */
enum figure {
    FIGURE_VOLUME,
    FIGURE_AREA,
    FIGURE_MASS,
    FIGURE_CENTROID,                       /* x, y, z of the centre of mass; NaN if
                                            * the mass is 0 */
    FIGURE_INERTIA = FIGURE_CENTROID + 3,  /* about the requested point: Ixx, Iyy,
                                            * Izz, Ixy, Ixz, Iyz */
    FIGURE_CENTRAL = FIGURE_INERTIA + 6,   /* inertia about the centroid, in the same
                                            * order */
    FIGURE_PRINCIPAL = FIGURE_CENTRAL + 6, /* three principal moments, in increasing
                                            * order */
    FIGURE_VIEWS = FIGURE_PRINCIPAL + 3,   /* volume from the views along x, y and z */
    FIGURES = FIGURE_VIEWS + 3
};
const char *figure_name(size_t figure);

struct mass_figures {
    double value[FIGURES];
    double error[FIGURES]; /* NaN: unknown, because there are fewer than 4 shifts */
    double axes[3][3];     /* unit vectors of the principal axes */
};

/* The parts of a body, with their densities. Parts that do not belong to the body have
 * the density 0. */
struct mass_body {
    const struct columns_sums *sums;
    const double *density; /* one density for each part, without the sum of all parts */
    const double *about;   /* the reference point of the inertia */
};

/* Computes the mass properties of a body, with their errors. Returns false if out of
 * memory. */
bool mass_figures_find(const struct mass_body *body, struct mass_figures *figures);
/* Converts figures to a unit of length that is smaller by the factor 2^log. */
void mass_figures_enlarge(struct mass_figures *figures, int log);
/* Computes the volume that several objects occupy, and its error. The volume is counted
 * once for each object after the first. */
void mass_overlap(const struct columns_sums *sums, double *volume, double *error);
/* Computes the volume that both parts of a pair occupy. Returns false if it is
 * zero within rounding errors. */
bool mass_overlap_of(const struct columns_sums *sums, size_t pair, double *volume,
                     double *error);
/* Returns the largest relative error. Sets *figure to its figure. The error of a moment
 * is relative to the largest principal moment or, if it is larger, to the largest
 * moment about the requested point. Errors of the centroid are relative to the diagonal
 * of the box. */
double mass_worst(const struct mass_figures *figures, const struct columns_sums *sums,
                  size_t *figure);

#endif
