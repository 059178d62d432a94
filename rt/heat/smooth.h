/* smooth.h - adjusts shape factors so that reciprocity and closure hold, with the
 * smallest change, on a machine (rt/kernels/heat/smooth.s has the equations). */
#ifndef RT_SMOOTH_H
#define RT_SMOOTH_H

#include "rt/heat/surfaces.h"

enum { MAX_SMOOTH = 1024 }; /* surfaces */

/* The input. Each surface has a row of flows x_ij = A_i F_ij to all surfaces and,
 * as the last element, to the environment, with their variances v_ij. x_ij = x_ji
 * and v_ij = v_ji. */
struct smooth_given {
    enum trace_mode mode;
    size_t count;                    /* surfaces, 1 .. MAX_SMOOTH */
    const double *flows, *variances; /* [count][count + 1]; not negative */
    const double *areas;
    const char *const *names; /* for errors */
    const c205_model *model;
};

/* Computes adjusted flows [count][count + 1]. The sum of each row is the area.
 * Returns false for invalid numbers, for flows without a solution, whose surface
 * the error names, after a trap, or if out of memory. */
bool smooth_flows(const struct smooth_given *given, double *flows,
                  struct accounts *accounts, c205_error *error);

/* Sets surface.smooth of all visible surfaces. The two estimates of a flow, in
 * either direction, are weighted by their variances. If neither surface hit the
 * other, the flow is 0. Adds the machine's accounts. Returns false for the errors
 * of smooth_flows, and for a surface that only receives; the error names the
 * surface. */
bool smooth_surfaces(struct surfaces *surfaces, enum trace_mode mode,
                     const c205_model *model, struct accounts *accounts,
                     c205_error *error);

#endif
