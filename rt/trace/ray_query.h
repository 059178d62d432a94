/* ray_query.h - all that is seen of a scene along lines, found by machines.
 *
 * A crossing of a line with a surface is seen where the tree of its region has
 * another value before it than behind it (docs/solids.md).  ray_query_new assembles
 * the program and lays the scene out once; ray_query_find finds the crossings of any
 * lines, packet by packet, and gives them line by line, from near to far.
 *
 * What belongs to bodies comes in pairs: the senses of a region's crossings are 1 and
 * -1 in turn where a line begins outside.  An object is one region or, where it is a
 * union that stands by itself, several, whose bodies may overlap: a piece of the line
 * is inside of it from where `inside` comes from 0 to 1 to where it falls to 0 again,
 * and outside of everything where `within` is 0.
 */
#ifndef RT_LINES_H
#define RT_LINES_H

#include "base/accounts.h"
#include "rt/layout/query_layout.h"
#include "rt/trace/trace.h"

struct ray_query_options {
    enum trace_mode mode;
    size_t queue; /* lines at a time; not in scalar mode */
    /* Lines that a machine takes at most, before it is loaded again; 0:
     * QUERY_PACKET. */
    size_t packet;
    /* Lines begin so far behind their origins, a length in the world, not below
     * 0; what lies behind an origin has a distance below 0. */
    double behind;
    bool normals;            /* are asked, too */
    bool bodies;             /* .. in how many of them lines are */
    bool no_bounds, flat;    /* as in trace_options */
    const c205_model *model; /* must outlive the lines */
};
/* Four queues: what is found of so many fills a few of the 16 pages that are in
 * memory. */
enum { QUERY_PACKET = 8000 };

/* What the machine found, in its own words where these are numbers. */
struct ray_hit {
    c205_word distance;  /* from the line's origin, a length in the world */
    c205_word normal[3]; /* if asked: of length one, against the line */
    size_t primitive;    /* of the scene's, from 0 on */
    size_t object;       /* .. the object that it is a part of */
    size_t triangle;     /* .. of a mesh, of its triangles; else 0 */
    /* 1: the line comes into the body of the region, -1: it leaves it, 0: the
     * region has none: a surface in it is open, or cuts and is not seen. */
    int crossing;
    /* If asked: in how many bodies of the object the line is behind it, and of
     * all objects: senses added up, 0 where the line begins. */
    int object_depth, scene_depth;
};

/* Line by line. */
struct ray_hits {
    size_t line_count;
    size_t *first; /* of each line, and behind the last: line_count + 1 */
    struct ray_hit *list;
    struct accounts accounts; /* of the machines that found them */
};
void ray_hits_free(struct ray_hits *found);

struct ray_query;

/* NULL: options or a scene that cannot be; the error says why.  The scene must
 * outlive the lines. */
struct ray_query *ray_query_new(const struct scene *scene,
                                const struct ray_query_options *options,
                                c205_error *error);
void ray_query_free(struct ray_query *lines);

/* Those of each of the lines, which the caller frees; any number of threads may ask
 * at a time.  False: a direction without length, a number that is not finite, a trap,
 * no memory; the error says which, and nothing is found. */
bool ray_query_find(const struct ray_query *lines, const struct scene_ray *list,
                    size_t count, struct ray_hits *found, c205_error *error);

/* As it was assembled. */
const struct object *ray_query_program(const struct ray_query *lines);
/* The machine of these lines, one packet, before it begins; the caller frees it. */
c205 *ray_query_machine(const struct ray_query *lines, const struct scene_ray *list,
                        size_t count, c205_error *error);

/* Open the files of a job set (rt/jobs/job_set.h) for a run along such lines, of that kind and with
 * these choices besides, unless they are open or there is none (NULL).  False: one is of
 * another run. */
struct job_set;
bool ray_query_keep(const struct ray_query *lines, struct job_set *job_set,
                    const char *kind, const uint64_t *choices, size_t count,
                    c205_error *error);

#endif
