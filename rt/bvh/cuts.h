/* cuts.h - splits a list of boxes in two, for building hierarchies of bounds.
 *
 * The surface-area heuristic over bins: the list is split where the expected cost of
 * both parts is least. The builder of the hierarchy defines the cost of a part. Source:
 * Goldsmith and Salmon 1987; bins: Wald 2007.
 */
#ifndef RT_CUTS_H
#define RT_CUTS_H

#include <stddef.h>

struct box {
    double low[3], high[3];
};

extern const struct box box_empty;
void box_join(struct box *box, const struct box *other);

/* An object with its box, and the point that assigns it to a bin. */
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
    /* Returns the cost of a part of a list with the box `whole`. */
    double (*cost)(const struct cut_part *part, const struct box *whole);
    size_t *other; /* scratch space for a list */
};

/* A split between two bins along an axis. */
struct cut {
    int axis; /* below 0: no split */
    double low, width;
    size_t bin; /* first bin of the upper part */
    double cost;
};

/* Returns the best split whose cost is below `cost`. */
struct cut cut_find(const struct cutting *cutting, const size_t *row, size_t count,
                    const struct box *whole, double cost);
/* Partitions the list, lower part first, preserving the order in each part. Returns the
 * size of the lower part. */
size_t cut_row(const struct cutting *cutting, size_t *row, size_t count,
               const struct cut *cut);

#endif
