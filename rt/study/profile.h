/* profile.h - what each part of a frame costs in the three stages of the
 * tracer: all serial, the paper's, all in vector form.
 */
#ifndef RT_PROFILE_H
#define RT_PROFILE_H

#include "base/table.h"
#include "rt/trace/trace.h"
#include "rt/trace/vector_use.h"

enum profile_part {
    PART_GENERATE,  /* rays of pixels */
    PART_INTERSECT, /* segments of rays in primitives; the walk over regions
                       and nodes, with their bounding volumes */
    PART_VISIBLE,   /* which surface is seen: trees, the nearest */
    PART_SHADE,     /* normals, pigments, light and shadow */
    PART_SPAWN,     /* mirrored and refracted rays, their colours added */
    PART_REST,      /* what the frame's program does between them */
    PROFILE_PARTS
};
const char *profile_part_name(enum profile_part part);
/* The part that a region of the kernels belongs to; false: it is in no list,
 * a fault of the build. */
bool profile_part_of(const char *region, enum profile_part *part);

/* The stages in the order of the tables: scalar, kernels, vector. */
extern const enum trace_mode profile_stages[TRACE_MODES];

/* One frame in the three stages, in that order.  Zero it to begin; free it also
 * after a failure. */
struct profile {
    struct trace *traces[TRACE_MODES];
    struct vector_use vectors[TRACE_MODES];
};
/* The options' mode and observers are set here.  False: a trap, progress said
 * to stop, or the frames of two stages differ; the error says which. */
bool profile_run(struct profile *profile, const struct scene *scene,
                 const struct trace_options *options, c205_error *error);
void profile_free(struct profile *profile);

/* The tables of a profile that was run.  NULL: no memory. */
enum profile_table {
    PROFILE_GROUPS,  /* of parts and kernels in three groups, in millions of
                        clocks: for the reader .. */
    PROFILE_CLOCKS,  /* .. what others read: of each part, and of each
                        primitive's kernel, exact */
    PROFILE_SPEEDUP, /* of the frame, and what Amdahl's law says of it */
    PROFILE_VECTORS, /* their length, the density of control vectors */
    PROFILE_RAYS,    /* by kind */
    PROFILE_TABLES
};
const char *profile_table_key(enum profile_table kind);
const char *profile_table_heading(enum profile_table kind);
struct table *profile_table(enum profile_table kind, const struct profile *profile);

#endif
