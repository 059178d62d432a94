/* sampling.h - how shape factors are sampled, by rays (factors.h) or by lines
 * (global_lines.h). */
#ifndef RT_HEAT_SAMPLING_H
#define RT_HEAT_SAMPLING_H

#include "rt/jobs/job_set.h"
#include "rt/trace/trace.h"

struct sampling_options {
    enum trace_mode mode;
    size_t queue;     /* of points and of rays or lines; ignored in scalar mode */
    size_t points;    /* by rays, of each repeat: 1 .. MAX_FACTORS_POINTS; a power of
                       * two is best for the lattice */
    size_t lines_log; /* by lines: 2^lines_log lines of each repeat */
    size_t repeats;   /* 2 or more: their spread gives the errors */
    bool lattice;     /* use the lattice under independent shifts; else random points */
    uint64_t seed;
    size_t jobs;             /* packets at a time; 0: one */
    struct job_set *job_set; /* as in job_set_work */
    /* Called at intervals with packets. Returns false to stop. May be NULL. */
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
    /* The surface of each of the scene's primitives, a number below surfaces. NULL:
     * each primitive is a surface of its own. */
    const size_t *surface_of;
    size_t surfaces;
    const c205_model *model; /* must outlive the computation */
};

#endif
