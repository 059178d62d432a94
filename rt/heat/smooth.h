/* smooth.h - factors of which reciprocity and closure hold, nearest to those that were
 * found, by a machine (rt/kernels/heat/smooth.s has the equations).
 */
#ifndef RT_SMOOTH_H
#define RT_SMOOTH_H

#include "rt/heat/surfaces.h"

enum { MAX_SMOOTH = 1024 }; /* surfaces */

/* Of each surface a row: flows x_ij = A_i F_ij to all of them and, as the last one, to the
 * environment, with their variances v_ij; x_ij = x_ji, v_ij = v_ji. */
struct smooth_given {
    enum trace_mode mode;
    size_t count;                    /* surfaces, 1 .. MAX_SMOOTH */
    const double *flows, *variances; /* [count][count + 1]; not below 0 */
    const double *areas;
    const char *const *names; /* for errors */
    const c205_model *model;
};

/* Into flows [count][count + 1], in which each row's sum is the area.  False: numbers that
 * cannot be, flows without a solution, whose surface the error tells; a trap, no memory. */
bool smooth_flows(const struct smooth_given *given, double *flows,
                  struct accounts *accounts, c205_error *error);

/* Of all surfaces that something is seen of: surface.smooth.  What one found of a factor and
 * the other found back weighs by its variance; where neither met the other there is none.
 * The machine's accounts are added.  False: a surface that receives alone, too, or one that
 * has no name among those of the error. */
bool smooth_surfaces(struct surfaces *surfaces, enum trace_mode mode,
                     const c205_model *model, struct accounts *accounts,
                     c205_error *error);

#endif
