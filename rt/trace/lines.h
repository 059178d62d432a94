/* lines.h - all that is seen of a scene along lines, found by machines.
 *
 * A crossing of a line with a surface is seen where the tree of its region has
 * another value before it than behind it (docs/solids.md).  lines_new assembles
 * the program and lays the scene out once; lines_find finds the crossings of any
 * lines, packet by packet, and gives them line by line, from near to far.
 *
 * What belongs to bodies comes in pairs: where a line begins outside of all, the
 * senses of a region's crossings are 1 and -1 in turn, and those of an object,
 * which is one region or, of a union that stands by itself, several, add up to how
 * many of its bodies the line is in.
 */
#ifndef RT_LINES_H
#define RT_LINES_H

#include "base/accounts.h"
#include "rt/layout/lines.h"
#include "rt/trace/trace.h"

struct lines_options {
    enum trace_mode mode; /* scalar or vector */
    size_t queue;         /* lines at a time; not in scalar mode */
    size_t packet; /* lines that a machine takes at the most, before the
                             next one is loaded; 0: LINES_PACKET */
    double behind; /* lines begin so far behind their origins, a length
                             in the world, not below 0; what lies behind an
                             origin has a distance below 0 */
    bool normals;  /* are asked, too */
    bool bodies;   /* .. in how many of them lines are */
    bool no_bounds, flat;    /* as in trace_options */
    const c205_model *model; /* must outlive the lines */
};
/* Four queues: what is found of so many fills some of the 16 pages that are in memory. */
enum { LINES_PACKET = 8000 };

/* What the machine found, in its own words where it computed them. */
struct seen_crossing {
    c205_word distance;  /* from the line's origin, a length in the world */
    c205_word normal[3]; /* if asked: of length one, against the line */
    size_t primitive;    /* of the scene's, from 0 on */
    size_t object;       /* .. its object */
    size_t triangle;     /* .. of a mesh, of its triangles; else 0 */
    int inside,
        within; /* if asked: in how many bodies of the object the line is
                            behind it, and of all objects: the sum of senses,
                            0 where it begins */
    int sense;  /* 1: the line comes into the body of the region, -1:
                            it leaves it, 0: the region has none: a surface in
                            it is open, or is not seen */
};

/* Line by line; begin with zeros. */
struct seen_crossings {
    size_t line_count;
    size_t *first; /* of each line, and behind the last: line_count + 1 */
    struct seen_crossing *list;
    struct accounts accounts; /* of the machines that found them */
};
void seen_crossings_free(struct seen_crossings *found);

struct lines;

/* NULL: options or a scene that cannot be; the error says why.  The scene must
 * outlive the lines. */
struct lines *lines_new(const struct scene *scene,
                        const struct lines_options *options,
                        c205_error *error);
void lines_free(struct lines *lines);

/* Those of each of the lines.  False: a direction without length, a number that is
 * not finite, a trap, no memory; the error says which, and nothing is found. */
bool lines_find(const struct lines *lines, const struct scene_line *list,
                size_t count, struct seen_crossings *found,
                c205_error *error);

/* As it was assembled. */
const struct object *lines_program(const struct lines *lines);
/* The machine of these lines, one packet, before it begins; the caller frees it. */
c205 *lines_machine(const struct lines *lines, const struct scene_line *list,
                    size_t count, c205_error *error);

#endif
