/* profile.h - measures the cost of each part of a frame in the three stages of the
 * tracer: scalar, the paper's stage, vector. */
#ifndef RT_PROFILE_H
#define RT_PROFILE_H

#include "base/table.h"
#include "rt/trace/trace.h"
#include "rt/trace/vector_use.h"

enum profile_part {
    PART_GENERATE,  /* generates the rays of pixels */
    PART_INTERSECT, /* intersects rays with primitives; traverses regions and nodes,
                     * with their bounding volumes */
    PART_VISIBLE,   /* finds the visible surface: trees, the nearest hit */
    PART_SHADE,     /* computes normals, pigments, light and shadow */
    PART_SPAWN,     /* makes reflected and refracted rays, and adds their colours */
    PART_REST,      /* runs the frame's program between the other parts */
    PROFILE_PARTS
};
const char *profile_part_name(enum profile_part part);
/* Finds the part to which a region of the kernels belongs. If the region is in no list,
 * which is an error of the build, returns false. */
bool profile_part_of(const char *region, enum profile_part *part);

/* The stages in the order of the tables: scalar, kernels, vector. */
extern const enum trace_mode profile_stages[TRACE_MODES];

/* A frame in the three stages, in this order. It must initially be zero. It must be
 * freed even after a failure. */
struct profile {
    struct trace *traces[TRACE_MODES];
    struct vector_use vectors[TRACE_MODES];
};
/* Traces the frame in all stages. Replaces the mode and the observers of the options.
 * Returns false and sets the error after a trap, if progress returned false, or if the
 * frames of two stages differ. */
bool profile_run(struct profile *profile, const struct scene *scene,
                 const struct trace_options *options, c205_error *error);
void profile_free(struct profile *profile);

/* The tables of a profile after profile_run. profile_table returns NULL if out of
 * memory. */
enum profile_table {
    PROFILE_GROUPS,  /* parts and kernels in three groups, in millions of clocks; for
                      * readers */
    PROFILE_CLOCKS,  /* exact clocks of each part, and of the kernel of each primitive;
                      * for other programs */
    PROFILE_SPEEDUP, /* speedup of the frame, and its prediction by Amdahl's law */
    PROFILE_VECTORS, /* lengths of vectors, and density of control vectors */
    PROFILE_RAYS,    /* number of rays of each kind */
    PROFILE_TABLES
};
const char *profile_table_key(enum profile_table kind);
const char *profile_table_heading(enum profile_table kind);
struct table *profile_table(enum profile_table kind, const struct profile *profile);

#endif
