/* profile.h - the cost of each part of a frame in the three stages of the tracer:
 * all scalar, the paper's, and all vector. */
#ifndef RT_PROFILE_H
#define RT_PROFILE_H

#include "base/table.h"
#include "rt/trace/trace.h"
#include "rt/trace/vector_use.h"

enum profile_part {
    PART_GENERATE,  /* rays of pixels */
    PART_INTERSECT, /* segments of rays in primitives; the traversal of regions and
                     * nodes, with their bounding volumes */
    PART_VISIBLE,   /* the visible surface: trees, the nearest hit */
    PART_SHADE,     /* normals, pigments, light and shadow */
    PART_SPAWN,     /* reflected and refracted rays, and adding their colours */
    PART_REST,      /* the frame's program between the other parts */
    PROFILE_PARTS
};
const char *profile_part_name(enum profile_part part);
/* Finds the part that a region of the kernels belongs to. Returns false if it is
 * in no list, which is an error of the build. */
bool profile_part_of(const char *region, enum profile_part *part);

/* The stages in the order of the tables: scalar, kernels, vector. */
extern const enum trace_mode profile_stages[TRACE_MODES];

/* One frame in the three stages, in that order. It must be zero at the start, and
 * must be freed also after a failure. */
struct profile {
    struct trace *traces[TRACE_MODES];
    struct vector_use vectors[TRACE_MODES];
};
/* Traces the frame in all stages. The mode and the observers of the options are
 * replaced. Returns false with the reason in the error after a trap, if progress
 * returned false, or if the frames of two stages differ. */
bool profile_run(struct profile *profile, const struct scene *scene,
                 const struct trace_options *options, c205_error *error);
void profile_free(struct profile *profile);

/* The tables of a profile that was run. profile_table returns NULL if out of
 * memory. */
enum profile_table {
    PROFILE_GROUPS,  /* parts and kernels in three groups, in millions of clocks, for
                      * readers */
    PROFILE_CLOCKS,  /* exact clocks of each part, and of each primitive's kernel,
                      * for other programs */
    PROFILE_SPEEDUP, /* of the frame, and its prediction by Amdahl's law */
    PROFILE_VECTORS, /* their length, and the density of control vectors */
    PROFILE_RAYS,    /* by kind */
    PROFILE_TABLES
};
const char *profile_table_key(enum profile_table kind);
const char *profile_table_heading(enum profile_table kind);
struct table *profile_table(enum profile_table kind, const struct profile *profile);

#endif
