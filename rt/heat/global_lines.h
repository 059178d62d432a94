/* global_lines.h - computes shape factors from lines through the whole scene. Each gap
 * on a line between two surfaces that face each other counts for both surfaces.
 *
 * The lines are isotropic and uniform in a sphere of radius R around the scene
 * (chords.h). If n_ij ends of gaps at surface i face surface j, then
 *
 *   A_i F_ij = 2 pi R^2 n_ij / lines,    A_i = 2 pi R^2 sum_j n_ij / lines.
 *
 * Since n_ij = n_ji, closure and reciprocity hold exactly. A surface without an inside,
 * such as a disc, is seen from both sides, and its area is the area of both sides.
 * Machines compute the lines, the crossings and the counts, packet by packet. The
 * results do not depend on the form, the queue length, the number of jobs or the number
 * of ranks. Source: M. Sbert, "An integral geometry based method for fast form-factor
 * computation" (1993).
 */
#ifndef RT_GLOBAL_LINES_H
#define RT_GLOBAL_LINES_H

#include "base/accounts.h"
#include "rt/heat/estimate.h"
#include "rt/heat/sampling.h"
#include "rt/heat/step.h"

enum { MAX_GLOBAL_LINES_LOG = 20, GLOBAL_LINES_PACKET = 4096 };

struct global_lines {
    size_t surfaces; /* the environment has the number `surfaces` */
    size_t repeats, lines_log;
    size_t units;   /* number of packets of all repeats */
    double radius;  /* radius of the sphere */
    uint64_t *ends; /* n_ij: [repeats][surfaces + 1][surfaces + 1] */
    struct accounts accounts;
    uint64_t clocks[HEAT_STEPS]; /* clocks of all machines for each step */
};

/* Counts the gaps between surfaces along random lines through the scene. If this
 * process does not collect results (job_set_collects), the counts stay 0. Returns false
 * for invalid options, if the scene has no surface or an unbounded surface, after a
 * trap, if out of memory, or if a file belongs to another run. */
bool global_lines_find(const struct scene *scene,
                       const struct sampling_options *options,
                       struct global_lines *found, c205_error *error);
void global_lines_free(struct global_lines *found);

/* Returns the number of ends of gaps at surface i that face surface j, over all
 * repeats. */
uint64_t global_lines_count(const struct global_lines *found, size_t i, size_t j);
struct estimate global_lines_area(const struct global_lines *found, size_t i);
/* Returns the factor from surface i to surface j, or NAN if no line hit surface i. */
struct estimate global_lines_factor(const struct global_lines *found, size_t i,
                                    size_t j);

#endif
