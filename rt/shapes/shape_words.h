/* shape_words.h - computes the data of a primitive that its kernels read.
 *
 * The data consists of the words in the primitive's record, the names and limits of its
 * routines, and the words of its table. Computing the table may take long.
 */
#ifndef RT_SHAPE_WORDS_H
#define RT_SHAPE_WORDS_H

#include "rt/shapes/shape.h"

/* The largest number of crossings of a ray with a patch of degree four, as in
 * records.s. */
enum { PATCH_CROSSINGS = 4 };

struct shape_words {
    double words[MAX_SHAPE_WORDS];
    size_t count;
    bool transformed;            /* the primitive has its own space */
    bool on_patch;               /* a hit has two additional parameters */
    bool on_mesh;                /* one of the two parameters is a triangle */
    const char *kernel, *normal; /* names of routines, for both forms of the program */
    const char *solid;           /* in trees: finds all crossings of a ray */
    const char *state;           /* in trees, for an open shape: finds the segments
                                  * inside the closed shape; else NULL */
    size_t segments;             /* largest number of segments of a ray inside */
    size_t events;               /* largest number of visible crossings of a ray */
};

/* Computes the data for the kernels of shape_kernels_of, which are not those of
 * 1984. */
void shape_words(const struct primitive *primitive, struct shape_words *words);
/* Computes the data for the kernel of 1984. The primitive must not be in a tree. If
 * there is no such kernel for the primitive, computes the same data as shape_words and
 * returns false. */
bool shape_words_historical(const struct primitive *primitive,
                            struct shape_words *words);
/* shape_table_count returns the size of the table in words. shape_table computes a
 * table of this size, which the caller frees, or returns NULL if out of memory.
 * `viewpoints` are points that many rays pass through, or NULL. */
size_t shape_table_count(const struct primitive *primitive,
                         const struct viewpoints *viewpoints);
double *shape_table(const struct primitive *primitive,
                    const struct viewpoints *viewpoints, size_t count);
/* Returns true if all words are finite. Squares and reciprocals of a shape's numbers
 * may overflow. If out of memory, the table is not checked. */
bool shape_is_finite(const struct primitive *primitive);

#endif
