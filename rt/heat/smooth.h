/* smooth.h - adjusts shape factors on a machine, so that reciprocity and closure hold
 * and the change is least. rt/kernels/heat/smooth.s contains the equations. */
#ifndef RT_SMOOTH_H
#define RT_SMOOTH_H

#include "rt/heat/surfaces.h"

enum { MAX_SMOOTH = 1024 }; /* largest number of surfaces */

/* The input. Each surface i has a row of flows x_ij = A_i F_ij to all surfaces j. The
 * last element is the flow to the environment. The flows have variances v_ij. x_ij =
 * x_ji and v_ij = v_ji. */
struct smooth_given {
    enum trace_mode mode;
    size_t count;                    /* number of surfaces, 1 .. MAX_SMOOTH */
    const double *flows, *variances; /* [count][count + 1]; not negative */
    const double *areas;
    const char *const *names; /* names of the surfaces, for error messages */
    const c205_model *model;
};

/* Computes the adjusted flows: `count` rows of count + 1 flows. The sum of a row is the
 * area of its surface. Returns false for invalid numbers, if there is no solution (the
 * error then names the surface), after a trap, or if out of memory. */
bool smooth_flows(const struct smooth_given *given, double *flows,
                  struct accounts *accounts, c205_error *error);

/* Sets surface.smooth of all visible surfaces. The flow between two surfaces is
 * estimated in both directions, and each estimate has the reciprocal of its variance as
 * its weight. If neither surface hit the other, the flow is 0. Adds the machine's
 * accounts. Returns false after an error of smooth_flows, or if a primitive of a
 * surface has no emission; the error then names the surface. */
bool smooth_surfaces(struct surfaces *surfaces, enum trace_mode mode,
                     const c205_model *model, struct accounts *accounts,
                     c205_error *error);

#endif
