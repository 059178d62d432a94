/* global_lines.h - what all surfaces of a scene send each other, from lines through all of
 * it: every gap between two that see each other counts for both.
 *
 * The lines are isotropic and uniform through a sphere about the scene, of radius R: those
 * along which the sphere would radiate inward.  Where n_ij ends of gaps at i look at j,
 *
 *   A_i F_ij = 2 pi R^2 n_ij / lines,    A_i = 2 pi R^2 sum_j n_ij / lines;
 *
 * n_ij = n_ji, so closure and reciprocity hold exactly.  What has no inside, as a disc, is
 * seen from both of its sides: its area is that of both.  Lines, all that is seen along
 * them and counts are the machine's, packet by packet; they do not depend on the form, the
 * queue, the jobs or the ranks.
 * Source: M. Sbert, "An integral geometry based method for fast form-factor computation"
 * (1993).
 */
#ifndef RT_GLOBAL_LINES_H
#define RT_GLOBAL_LINES_H

#include "base/accounts.h"
#include "rt/jobs/job_set.h"
#include "rt/heat/estimate.h"
#include "rt/heat/step.h"
#include "rt/trace/trace.h"

enum { MAX_GLOBAL_LINES_LOG = 20, GLOBAL_LINES_PACKET = 4096 };

struct global_lines_options {
    enum trace_mode mode;
    size_t queue;     /* lines at a time; not in scalar mode */
    size_t lines_log; /* 2^lines_log lines of each repeat */
    size_t repeats;   /* 2 or more: their spread gives the errors */
    bool lattice;     /* or random */
    uint64_t seed;
    size_t jobs;             /* packets at a time; 0: one */
    struct job_set *job_set; /* as in job_set_work */
    /* Asked now and then, with packets; false: stop.  NULL: nobody wants to know. */
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
    /* What counts as one surface: of each of the scene's primitives a number, below so
     * many; NULL: each is one. */
    const size_t *surface_of;
    size_t surfaces;
    const c205_model *model;
};

struct global_lines {
    size_t surfaces; /* behind them is the environment */
    size_t repeats, lines_log;
    size_t units;   /* packets of all repeats */
    double radius;  /* of the sphere */
    uint64_t *ends; /* n_ij: [repeats][surfaces + 1][surfaces + 1] */
    struct accounts accounts;
    uint64_t clocks[HEAT_STEPS]; /* .. of them */
};

/* Where the job set does not collect packets (job_set_collects) nothing is counted.  False:
 * options that cannot be, a scene without surfaces, or with one that has no end; a
 * trap, no memory, a file of another run. */
bool global_lines_find(const struct scene *scene,
                       const struct global_lines_options *options,
                       struct global_lines *found, c205_error *error);
void global_lines_free(struct global_lines *found);

/* n_ij of all repeats. */
uint64_t global_lines_count(const struct global_lines *found, size_t i, size_t j);
struct estimate global_lines_area(const struct global_lines *found, size_t i);
/* NAN where no line met i. */
struct estimate global_lines_factor(const struct global_lines *found, size_t i,
                                    size_t j);

#endif
