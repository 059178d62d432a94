/* shape_words.h - a primitive's shape as its kernel wants it.
 *
 * What a set-up program would work out once per primitive: reciprocals, the
 * axes of a cylinder, a plane or a uniformly scaled sphere carried into the
 * world.  The order of the words is that of rt/kernels/records.s.
 */
#ifndef RT_SHAPE_WORDS_H
#define RT_SHAPE_WORDS_H

#include "rt/scene/scene.h"

/* How closely roots are found, beside the size of the shape. */
#define ROOT_RESOLUTION 0x1p-44

enum { SHAPE_WORDS_MOST = 16, SHAPE_TABLE_MOST = 96 };

struct shape_words {
    double words[SHAPE_WORDS_MOST];
    size_t count;
    double table[SHAPE_TABLE_MOST]; /* what has no room among the words */
    size_t table_count;
    bool transformed;            /* it stands in a space of its own */
    bool on_patch;               /* a hit has two parameters, too */
    const char *kernel, *normal; /* routines, in both forms of the program */
    const char *historical;      /* the kernel of 1984, or NULL */
};

void shape_words(const struct primitive *primitive,
                 struct shape_words *shape);

#endif
