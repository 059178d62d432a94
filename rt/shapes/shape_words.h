/* shape_words.h - a primitive's shape as its kernels want it.
 *
 * The words that have room in its record, which routines it has and what they
 * find of a ray; and the words in a table, which may take long to work out.
 */
#ifndef RT_SHAPE_WORDS_H
#define RT_SHAPE_WORDS_H

#include "rt/shapes/shape.h"

/* The most crossings of a ray with a patch, of the fourth degree; records.s
 * has the same. */
enum { PATCH_CROSSINGS = 4 };

struct shape_words {
    double words[MAX_SHAPE_WORDS];
    size_t count;
    bool transformed;            /* it is in a space of its own */
    bool on_patch;               /* a hit has two parameters, too */
    bool on_mesh;                /* .. one of which is a triangle */
    const char *kernel, *normal; /* routines, in both forms of the program */
    const char *solid;           /* for all crossings of a ray: the kernel that
                          is used in trees */
    const char *state;           /* for the segments inside of the closed shape,
                          if it is open; or NULL */
    size_t segments;             /* of a ray, inside, at most */
    size_t events;               /* crossings of a ray that can be seen */
};

void shape_words(const struct primitive *primitive, struct shape_words *words);
/* Of one that is traced alone, not in a tree, as the program of 1984 has it.
 * False: that has no kernel for it; the words are those of today. */
bool shape_words_historical(const struct primitive *primitive,
                            struct shape_words *words);
/* How many words its table has, and the table, of that many; the caller frees
 * it.  Eyes: through which many rays go, or NULL.  NULL: no memory. */
size_t shape_table_count(const struct primitive *primitive,
                         const struct viewpoints *viewpoints);
double *shape_table(const struct primitive *primitive,
                    const struct viewpoints *viewpoints, size_t count);
/* Whether all of that is finite: what squares and reciprocals make of a
 * shape's numbers may be beyond a double.  Without memory for the table that
 * is not asked. */
bool shape_is_finite(const struct primitive *primitive);

#endif
