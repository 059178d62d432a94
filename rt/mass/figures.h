/* figures.h - computes the mass properties of a body from sums over columns, with
 * errors.
 *
 * The host computes these in doubles. It averages the sums of the machines
 * (columns.h) over views and shifts, moves them by the parallel axis theorem, and
 * rotates them to principal axes. The error of a figure is half the width of its
 * 95 % confidence interval: the standard error, estimated by leaving out one shift
 * at a time (the jackknife), times Student's t. Sources: Quenouille 1956, Tukey
 * 1958; for t, Abramowitz and Stegun 26.7.5.
 */
#ifndef RT_MASS_FIGURES_H
#define RT_MASS_FIGURES_H

#include "rt/mass/columns.h"

/* Lengths are the scene's. A density is a mass per cube of the unit length.
 * Products of inertia have their sign in the tensor: Ixy = - integral of density x
 * y. */
enum figure {
    FIGURE_VOLUME,
    FIGURE_AREA,
    FIGURE_MASS,
    FIGURE_CENTROID,                       /* x, y, z of the centre of mass; NaN if
                                            * the mass is 0 */
    FIGURE_INERTIA = FIGURE_CENTROID + 3,  /* about the requested point: Ixx, Iyy,
                                            * Izz, Ixy, Ixz, Iyz */
    FIGURE_CENTRAL = FIGURE_INERTIA + 6,   /* about the centroid, in the same order */
    FIGURE_PRINCIPAL = FIGURE_CENTRAL + 6, /* three moments, in increasing order */
    FIGURE_VIEWS = FIGURE_PRINCIPAL + 3,   /* the volume from the views along x, y, z */
    FIGURES = FIGURE_VIEWS + 3
};
const char *figure_name(size_t figure);

struct mass_figures {
    double value[FIGURES];
    double error[FIGURES]; /* NaN: unknown, for fewer than 4 shifts */
    double axes[3][3];     /* unit vectors of the principal moments */
};

/* The parts of a body, with their densities. The density of any other part is 0. */
struct mass_body {
    const struct columns_sums *sums;
    const double *density; /* one for each part, without the sum of all parts */
    const double *about;   /* the reference point of the inertia */
};

/* Computes the figures. Returns false if out of memory. */
bool mass_figures_find(const struct mass_body *body, struct mass_figures *figures);
/* Converts figures to a unit of length that is smaller by the factor 2^log. */
void mass_figures_enlarge(struct mass_figures *figures, int log);
/* Computes the volume that several objects occupy, counted once for each object
 * after the first, and its error. */
void mass_overlap(const struct columns_sums *sums, double *volume, double *error);
/* Computes the volume that both parts of a pair occupy. Returns false if it is
 * zero within rounding errors. */
bool mass_overlap_of(const struct columns_sums *sums, size_t pair, double *volume,
                     double *error);
/* Returns the largest relative error, and the figure that has it. Errors of
 * moments are relative to the largest principal moment, and those of the centroid
 * to the box's diagonal. */
double mass_worst(const struct mass_figures *figures, const struct columns_sums *sums,
                  size_t *figure);

#endif
