/* sampling.h - the options for the sampling of shape factors, by rays (factors.h) or by
 * lines (global_lines.h). */
#ifndef RT_HEAT_SAMPLING_H
#define RT_HEAT_SAMPLING_H

#include "rt/jobs/job_set.h"
#include "rt/trace/trace.h"

struct sampling_options {
    enum trace_mode mode;
    size_t queue;     /* number of points, rays or lines in a queue; ignored in scalar
                       * mode */
    size_t points;    /* rays: points of each repeat, 1 .. MAX_FACTORS_POINTS; powers of
                       * two suit the lattice best */
    size_t lines_log; /* lines: 2^lines_log lines in each repeat */
    size_t repeats;   /* at least 2, because the errors are computed from their
                       * spread */
    bool lattice;     /* lattice with independent shifts, else random points */
    uint64_t seed;
    size_t jobs;             /* number of packets computed concurrently; 0: one */
    struct job_set *job_set; /* as in job_set_work */
    /* Called at intervals with the number of finished packets and the number of all
     * packets. Returns whether to continue. May be NULL. */
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
    /* The surface of each primitive, a number below `surfaces`. NULL: each primitive is
     * a separate surface. */
    const size_t *surface_of;
    size_t surfaces;
    const c205_model *model; /* must outlive the computation */
};

#endif
