/* cuts.c - finds the best split of a list of boxes. */
#include "rt/bvh/cuts.h"

#include <math.h>
#include <string.h>

enum { BINS = 16 };

/* ---- Boxes --------------------------------------------------------------- */

const struct box box_empty = {
    { INFINITY, INFINITY, INFINITY },
    { -INFINITY, -INFINITY, -INFINITY },
};

void box_join(struct box *box, const struct box *other)
{
    for (int i = 0; i < 3; i++) {
        box->low[i] = fmin(box->low[i], other->low[i]);
        box->high[i] = fmax(box->high[i], other->high[i]);
    }
}

struct box box_about(const struct boxed *things, const size_t *row, size_t count)
{
    struct box box = box_empty;
    for (size_t i = 0; i < count; i++)
        box_join(&box, &things[row[i]].box);
    return box;
}

/* ---- Bins ---------------------------------------------------------------- */

static size_t bin_of(const struct cut *cut, const struct boxed *thing)
{
    double place = (thing->place[cut->axis] - cut->low) / cut->width;
    return place >= BINS ? BINS - 1 : place > 0 ? (size_t)place : 0;
}

static void join_parts(struct cut_part *part, const struct cut_part *other)
{
    part->count += other->count;
    box_join(&part->box, &other->box);
}

static void fill_bins(const struct cutting *cutting, const size_t *row, size_t count,
                      const struct cut *cut, struct cut_part *bins)
{
    for (size_t i = 0; i < BINS; i++)
        bins[i] = (struct cut_part){ 0, box_empty };
    for (size_t i = 0; i < count; i++) {
        const struct boxed *thing = &cutting->things[row[i]];
        struct cut_part one = { 1, thing->box };
        join_parts(&bins[bin_of(cut, thing)], &one);
    }
}

/* Tries all splits along one axis and updates *best. above[i] is the union of the bins
 * from i on, so each split needs only two evaluations of the cost. */
static void try_axis(const struct cutting *cutting, const size_t *row, size_t count,
                     const struct box *whole, struct cut cut, struct cut *best)
{
    struct cut_part bins[BINS], below = { 0, box_empty }, above[BINS + 1];
    fill_bins(cutting, row, count, &cut, bins);
    above[BINS] = below;
    for (size_t i = BINS; i-- > 0;) {
        above[i] = above[i + 1];
        join_parts(&above[i], &bins[i]);
    }
    for (cut.bin = 1; cut.bin < BINS; cut.bin++) {
        join_parts(&below, &bins[cut.bin - 1]);
        if (below.count == 0 || above[cut.bin].count == 0)
            continue;
        cut.cost = cutting->cost(&below, whole) + cutting->cost(&above[cut.bin], whole);
        if (cut.cost < best->cost)
            *best = cut;
    }
}

/* ---- Cuts ---------------------------------------------------------------- */

/* Returns a cut without a position, which divides the range of the points along an axis
 * into bins of equal width. */
static struct cut cut_along(const struct cutting *cutting, const size_t *row,
                            size_t count, int axis)
{
    struct cut cut = { .axis = axis, .low = INFINITY };
    double high = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        double place = cutting->things[row[i]].place[axis];
        cut.low = fmin(cut.low, place);
        high = fmax(high, place);
    }
    cut.width = (high - cut.low) / BINS;
    return cut;
}

struct cut cut_find(const struct cutting *cutting, const size_t *row, size_t count,
                    const struct box *whole, double cost)
{
    struct cut best = { .axis = -1, .cost = cost };
    for (int axis = 0; axis < 3; axis++) {
        struct cut cut = cut_along(cutting, row, count, axis);
        if (cut.width > 0)
            try_axis(cutting, row, count, whole, cut, &best);
    }
    return best;
}

size_t cut_row(const struct cutting *cutting, size_t *row, size_t count,
               const struct cut *cut)
{
    size_t lower = 0, upper = 0;
    for (size_t i = 0; i < count; i++)
        if (bin_of(cut, &cutting->things[row[i]]) < cut->bin)
            row[lower++] = row[i];
        else
            cutting->other[upper++] = row[i];
    memcpy(row + lower, cutting->other, upper * sizeof *row);
    return lower;
}
