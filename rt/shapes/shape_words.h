/* shape_words.h - the data of a primitive for its kernels.
 *
 * It consists of the words in its record, the names and limits of its routines, and the
 * words of its table, which may take long to compute.
 */
#ifndef RT_SHAPE_WORDS_H
#define RT_SHAPE_WORDS_H

#include "rt/shapes/shape.h"

/* The limit of crossings of a ray with a patch of degree four, as in records.s. */
enum { PATCH_CROSSINGS = 4 };

struct shape_words {
    double words[MAX_SHAPE_WORDS];
    size_t count;
    bool transformed;            /* it has a space of its own */
    bool on_patch;               /* a hit also has two parameters */
    bool on_mesh;                /* one of these is a triangle */
    const char *kernel, *normal; /* routines, in both forms of the program */
    const char *solid;           /* for all crossings of a ray: the kernel that is used
                                  * in trees */
    const char *state;           /* for the segments inside of the closed shape, if it
                                  * is open; or NULL */
    size_t segments;             /* limit of a ray's segments inside */
    size_t events;               /* limit of a ray's visible crossings */
};

void shape_words(const struct primitive *primitive, struct shape_words *words);
/* Describes a primitive that is not in a tree, for the program of 1984. Fails if that
 * has no kernel for it; the words are then those of shape_words. */
bool shape_words_historical(const struct primitive *primitive,
                            struct shape_words *words);
/* Returns the size of the table in words; computes a table of that size, which the
 * caller frees. viewpoints: points that many rays pass through, or NULL. shape_table
 * returns NULL without memory. */
size_t shape_table_count(const struct primitive *primitive,
                         const struct viewpoints *viewpoints);
double *shape_table(const struct primitive *primitive,
                    const struct viewpoints *viewpoints, size_t count);
/* Returns true if all words are finite: squares and reciprocals of a shape's numbers
 * may overflow. Without memory the table is not checked. */
bool shape_is_finite(const struct primitive *primitive);

#endif
