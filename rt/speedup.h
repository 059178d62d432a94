/* speedup.h - the paper's Table 1 on the emulated machine.
 *
 * A frame of one primitive is traced in both forms; what counts are the
 * clocks of the primitive's kernel and of calling it: the regions named after
 * the primitive and "call".  Making the rays, choosing the nearest hit and
 * shading are left out, as in the paper.
 */
#ifndef RT_SPEEDUP_H
#define RT_SPEEDUP_H

#include "rt/trace.h"

struct speedup_subject {
    const char *primitive; /* also the kernel's region */
    const char *scene;     /* its text */
    double paper[TRACE_MODES]; /* CPU seconds for 100,000 rays, Table 1 */
    double paper_speedup;      /* as printed there */
};

extern const struct speedup_subject speedup_subjects[];
extern const size_t speedup_subject_count;

struct speedup_measure {
    uint64_t clocks[C205_CAUSES];
    uint64_t total;
    size_t rays, hits;
    uint64_t checksum; /* of the frame: equal in both forms */
};

bool speedup_measure(const struct speedup_subject *subject,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error);

#endif
