/* shape_words.h - a primitive's shape as its kernel wants it.
 *
 * What a set-up program would work out once per primitive: reciprocals, the
 * axes of a cylinder, a plane or a uniformly scaled sphere carried into the
 * world.  The order of the words is that of rt/kernels/frame/records.s.
 */
#ifndef RT_SHAPE_WORDS_H
#define RT_SHAPE_WORDS_H

#include "rt/scene/scene.h"

/* How closely roots are found, beside the size of the shape. */
#define ROOT_RESOLUTION 0x1p-44

enum { SHAPE_WORDS_MOST = 16, SHAPE_TABLE_MOST = 96 };

/* The most crossings of a ray with a patch, of the fourth degree; records.s
 * has the same. */
enum { PATCH_CROSSINGS = 4 };

struct shape_words {
    double words[SHAPE_WORDS_MOST];
    size_t count;
    double table[SHAPE_TABLE_MOST]; /* what has no room among the words */
    size_t table_count;
    bool transformed;            /* it stands in a space of its own */
    bool on_patch;               /* a hit has two parameters, too */
    const char *kernel, *normal; /* routines, in both forms of the program */
    const char *solid;      /* for all crossings of a ray: the kernel that
                                    is used in trees */
    const char *state;      /* for the segments inside of the closed shape,
                                    if it is open; or NULL */
    size_t segments;        /* of a ray, inside, at the most */
    size_t events;          /* crossings of a ray that can be seen */
    const char *historical; /* the kernel of 1984, or NULL */
};

void shape_words(const struct primitive *primitive,
                 struct shape_words *shape);
/* Whether all of that is finite: what squares and reciprocals make of a
 * shape's numbers may be beyond a double. */
bool shape_is_finite(const struct primitive *primitive);

#endif
