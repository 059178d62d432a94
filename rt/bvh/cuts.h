/* cuts.h - splits a list of boxes in two, to build hierarchies of bounds.
 *
 * It uses the binned surface-area heuristic: the list is split between the bins where
 * the expected cost of the two parts is least. The builder of the hierarchy defines the
 * cost of a part. Sources: Goldsmith and Salmon 1987; for the bins Wald 2007.
 */
#ifndef RT_CUTS_H
#define RT_CUTS_H

#include <stddef.h>

struct box {
    double low[3], high[3];
};

extern const struct box box_empty;
void box_join(struct box *box, const struct box *other);

/* An object: its box, and the point that assigns it to a bin. */
struct boxed {
    struct box box;
    double place[3];
};

/* Returns the box around the objects of a list. */
struct box box_about(const struct boxed *things, const size_t *row, size_t count);

struct cut_part {
    size_t count;
    struct box box;
};

struct cutting {
    const struct boxed *things;
    /* Returns the cost of one part of a split; `whole` is the box of both parts. */
    double (*cost)(const struct cut_part *part, const struct box *whole);
    size_t *other; /* scratch space for a list */
};

/* A split between two bins along an axis. */
struct cut {
    int axis; /* negative: no split */
    double low, width;
    size_t bin; /* first bin of the upper part */
    double cost;
};

/* Returns the split with the least cost. Its axis is negative if no split costs less
 * than `cost`. */
struct cut cut_find(const struct cutting *cutting, const size_t *row, size_t count,
                    const struct box *whole, double cost);
/* Partitions a list by a split: the lower part comes first, and each part keeps its
 * order. Returns the size of the lower part. */
size_t cut_row(const struct cutting *cutting, size_t *row, size_t count,
               const struct cut *cut);

#endif
