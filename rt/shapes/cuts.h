/* cuts.h - where a row of boxes is cut in two: what hierarchies of bounds are
 * made by.
 *
 * The surface-area heuristic over bins: the row is cut where what is expected
 * of both parts costs least; who builds a hierarchy says what a part costs.
 * Source: Goldsmith and Salmon 1987; bins: Wald 2007.
 */
#ifndef RT_CUTS_H
#define RT_CUTS_H

#include <stddef.h>

struct box {
    double low[3], high[3];
};

extern const struct box box_empty;
void box_join(struct box *box, const struct box *other);

/* A thing with a box, and the place by which it belongs to a bin. */
struct boxed {
    struct box box;
    double place[3];
};

/* Of the things that a row names. */
struct box box_about(const struct boxed *things, const size_t *row, size_t count);

struct cut_part {
    size_t count;
    struct box box;
};

struct cutting {
    const struct boxed *things;
    /* Of a part of a row that has the box `whole`. */
    double (*cost)(const struct cut_part *part, const struct box *whole);
    size_t *other; /* room for a row while it is cut */
};

/* Between bins of an axis. */
struct cut {
    int axis; /* below 0: nowhere */
    double low, width;
    size_t bin; /* the first of the upper part */
    double cost;
};

/* The best one of those that cost less than that. */
struct cut cut_find(const struct cutting *cutting, const size_t *row, size_t count,
                    const struct box *whole, double cost);
/* The lower part first, each in its order; how many it has. */
size_t cut_row(const struct cutting *cutting, size_t *row, size_t count,
               const struct cut *cut);

#endif
