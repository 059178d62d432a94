/* ray_query.h - all-hits ray queries: every visible crossing of a line with a scene,
 * computed on machines.
 *
 * A crossing is visible if the tree of its region has a different value just before it
 * than just after it (docs/solids.md). ray_query_new assembles the program and lays the
 * scene out once. ray_query_find computes the crossings of any number of lines, packet
 * by packet, and returns them line by line, from near to far.
 *
 * Crossings of bodies come in pairs: if a line begins outside, `crossing` alternates
 * between 1 and -1 for each region. An object is one region or, if it is a union at the
 * top level, several regions whose bodies may overlap. The line is inside the object
 * where `object_depth` is above 0. It is outside of all objects where `scene_depth` is
 * 0.
 */
#ifndef RT_RAY_QUERY_H
#define RT_RAY_QUERY_H

#include "base/accounts.h"
#include "rt/layout/query_layout.h"
#include "rt/trace/trace.h"

struct ray_query_options {
    enum trace_mode mode;
    size_t queue; /* number of lines in a queue; ignored in scalar mode */
    /* The largest number of lines that run on a machine before it is loaded again; 0:
     * QUERY_PACKET. */
    size_t packet;
    /* Lines begin at this distance before their origins: a length in the world, at
     * least 0. The distance of a crossing before the origin is negative. */
    double behind;
    bool normals;            /* compute normals, too */
    bool bodies;             /* compute object_depth and scene_depth, too */
    bool no_bounds, flat;    /* as in trace_options */
    const c205_model *model; /* must outlive the query */
};
/* The default size of a packet: the lines of four queues. Their results fill only a few
 * of the 16 pages of real memory. */
enum { QUERY_PACKET = 8000 };

/* A crossing. Its numbers are in the machine's own format. */
struct ray_hit {
    c205_word distance;  /* from the line's origin, a length in the world */
    c205_word normal[3]; /* on request: unit length, opposed to the line's direction */
    size_t primitive;    /* index among the scene's primitives, from 0 */
    size_t object;       /* index of the scene's object that contains the primitive */
    size_t triangle;     /* index among the triangles of a mesh; else 0 */
    /* 1: the line enters the region's body. -1: it leaves the body. 0: the region has
     * no body, because one of its surfaces is open, or cuts without being visible. */
    int crossing;
    /* On request: the number of bodies that contain the line just after the crossing,
     * among the bodies of this object and of all objects. They are running sums of
     * `crossing` that begin with 0. */
    int object_depth, scene_depth;
};

/* The crossings of all lines, grouped by line. */
struct ray_hits {
    size_t line_count;
    size_t *first; /* line_count + 1 indices into list: the first crossing of each line,
                    * then the end of the list */
    struct ray_hit *list;
    struct accounts accounts; /* accounts of the machines that ran the queries */
};
void ray_hits_free(struct ray_hits *found);

struct ray_query;

/* Returns a query, or NULL with the error if the options or the scene are invalid. The
 * scene must outlive the query. */
struct ray_query *ray_query_new(const struct scene *scene,
                                const struct ray_query_options *options,
                                c205_error *error);
void ray_query_free(struct ray_query *query);

/* Computes the crossings of each line. The caller frees them. Threads may call this
 * function concurrently. Returns false with the error if a direction has length 0, if a
 * number is not finite, after a trap, or if out of memory. The result is then empty. */
bool ray_query_find(const struct ray_query *query, const struct scene_ray *list,
                    size_t count, struct ray_hits *found, c205_error *error);

/* Returns the assembled program. */
const struct object *ray_query_program(const struct ray_query *query);
/* Returns a machine that has been loaded with these lines as one packet, but has not
 * run. The caller frees it. */
c205 *ray_query_machine(const struct ray_query *query, const struct scene_ray *list,
                        size_t count, c205_error *error);

/* Opens the checkpoint files of a job set (rt/jobs/job_set.h) for a run. Two runs are
 * the same if the query, the kind and all choices are equal. Does nothing if the job
 * set is NULL, has no files, or has opened them already. Returns false if a file cannot
 * be opened, or if it belongs to another run. */
struct job_set;
bool ray_query_keep(const struct ray_query *query, struct job_set *job_set,
                    const char *kind, const uint64_t *choices, size_t count,
                    c205_error *error);

#endif
