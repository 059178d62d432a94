/* global_lines.h - computes shape factors from lines through the whole scene:
 * every gap between two surfaces that face each other counts for both.
 *
 * The lines are isotropic and uniform through a sphere around the scene, of radius
 * R (chords.h). If n_ij ends of gaps at surface i face surface j, then
 *
 *   A_i F_ij = 2 pi R^2 n_ij / lines,    A_i = 2 pi R^2 sum_j n_ij / lines.
 *
 * Since n_ij = n_ji, closure and reciprocity hold exactly. A surface without an
 * inside, such as a disc, is seen from both sides, and its area is that of both.
 * Machines compute the lines, the crossings and the counts, packet by packet. The
 * results do not depend on the form, the queue, the jobs or the ranks. Source: M.
 * Sbert, "An integral geometry based method for fast form-factor computation"
 * (1993).
 */
#ifndef RT_GLOBAL_LINES_H
#define RT_GLOBAL_LINES_H

#include "base/accounts.h"
#include "rt/heat/estimate.h"
#include "rt/heat/sampling.h"
#include "rt/heat/step.h"

enum { MAX_GLOBAL_LINES_LOG = 20, GLOBAL_LINES_PACKET = 4096 };

struct global_lines {
    size_t surfaces; /* the environment has the next number */
    size_t repeats, lines_log;
    size_t units;   /* packets of all repeats */
    double radius;  /* of the sphere */
    uint64_t *ends; /* n_ij: [repeats][surfaces + 1][surfaces + 1] */
    struct accounts accounts;
    uint64_t clocks[HEAT_STEPS]; /* the clocks of these machines, by step */
};

/* Counts the gaps. If the job set does not collect packets (job_set_collects), the
 * counts stay 0. Returns false for invalid options, a scene without surfaces or
 * with an unbounded one, after a trap, if out of memory, or if a file belongs to
 * another run. */
bool global_lines_find(const struct scene *scene,
                       const struct sampling_options *options,
                       struct global_lines *found, c205_error *error);
void global_lines_free(struct global_lines *found);

/* Returns n_ij, summed over all repeats. */
uint64_t global_lines_count(const struct global_lines *found, size_t i, size_t j);
struct estimate global_lines_area(const struct global_lines *found, size_t i);
/* Returns NAN if no line hit surface i. */
struct estimate global_lines_factor(const struct global_lines *found, size_t i,
                                    size_t j);

#endif
