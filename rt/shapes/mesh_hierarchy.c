#include "rt/shapes/mesh_hierarchy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The surface-area heuristic over bins: a row of triangles is cut where the
 * boxes of both parts have the least surface, each times the number of its
 * triangles.  Source: Goldsmith and Salmon 1987; bins: Wald 2007. */

enum {
    BINS = 16,
    HALVED_FROM = 64, /* as deep as this a row is cut in halves */
};

struct mesh_build {
    const struct box *boxes;
    struct mesh_hierarchy *hierarchy;
    size_t *other; /* room for a row while it is cut */
};

/* Between bins of an axis. */
struct mesh_cut {
    int axis; /* below 0: nowhere */
    double low, width;
    size_t bin; /* the first of the upper part */
    double cost;
};

/* ---- Boxes --------------------------------------------------------------- */

static const struct box box_empty = {
    { INFINITY, INFINITY, INFINITY },
    { -INFINITY, -INFINITY, -INFINITY },
};

static void box_join(struct box *box, const struct box *other)
{
    for (int i = 0; i < 3; i++) {
        box->low[i] = fmin(box->low[i], other->low[i]);
        box->high[i] = fmax(box->high[i], other->high[i]);
    }
}

/* Twice its middle. */
static double box_place(const struct box *box, int axis)
{
    return box->low[axis] + box->high[axis];
}

/* Half of it. */
static double box_surface(const struct box *box)
{
    double x = box->high[0] - box->low[0], y = box->high[1] - box->low[1],
           z = box->high[2] - box->low[2];

    return x * y + y * z + z * x;
}

/* ---- Cuts ---------------------------------------------------------------- */

struct bin {
    size_t count;
    struct box box;
};

static size_t bin_of(const struct mesh_cut *cut, const struct box *box)
{
    double place = (box_place(box, cut->axis) - cut->low) / cut->width;

    return place >= BINS ? BINS - 1 : place > 0 ? (size_t)place : 0;
}

static void bin_join(struct bin *bin, const struct bin *other)
{
    bin->count += other->count;
    box_join(&bin->box, &other->box);
}

static double bin_cost(const struct bin *bin)
{
    return (double)bin->count * box_surface(&bin->box);
}

static void fill_bins(const struct mesh_build *build, const size_t *row,
                      size_t count, const struct mesh_cut *cut,
                      struct bin *bins)
{
    for (size_t i = 0; i < BINS; i++)
        bins[i] = (struct bin){ 0, box_empty };
    for (size_t i = 0; i < count; i++) {
        const struct bin one = { 1, build->boxes[row[i]] };

        bin_join(&bins[bin_of(cut, &one.box)], &one);
    }
}

/* The best place on one axis, if it is better than any before. */
static void try_axis(const struct mesh_build *build, const size_t *row,
                     size_t count, struct mesh_cut cut, struct mesh_cut *best)
{
    struct bin bins[BINS], below = { 0, box_empty }, above[BINS + 1];

    fill_bins(build, row, count, &cut, bins);
    above[BINS] = below;
    for (size_t i = BINS; i-- > 0;) {
        above[i] = above[i + 1];
        bin_join(&above[i], &bins[i]);
    }
    for (cut.bin = 1; cut.bin < BINS; cut.bin++) {
        bin_join(&below, &bins[cut.bin - 1]);
        if (below.count == 0 || above[cut.bin].count == 0)
            continue;
        cut.cost = bin_cost(&below) + bin_cost(&above[cut.bin]);
        if (cut.cost < best->cost)
            *best = cut;
    }
}

static struct mesh_cut find_cut(const struct mesh_build *build,
                                const size_t *row, size_t count)
{
    struct mesh_cut best = { .axis = -1, .cost = INFINITY };

    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        struct mesh_cut cut = { .axis = axis };

        for (size_t i = 0; i < count; i++) {
            low = fmin(low, box_place(&build->boxes[row[i]], axis));
            high = fmax(high, box_place(&build->boxes[row[i]], axis));
        }
        cut.low = low;
        cut.width = (high - low) / BINS;
        if (cut.width > 0)
            try_axis(build, row, count, cut, &best);
    }
    return best;
}

/* ---- Parts --------------------------------------------------------------- */

/* The lower part first, each in its order; how many it has. */
static size_t part(const struct mesh_build *build, size_t *row, size_t count,
                   const struct mesh_cut *cut)
{
    size_t lower = 0, upper = 0;

    for (size_t i = 0; i < count; i++)
        if (bin_of(cut, &build->boxes[row[i]]) < cut->bin)
            row[lower++] = row[i];
        else
            build->other[upper++] = row[i];
    memcpy(row + lower, build->other, upper * sizeof *row);
    return lower;
}

/* The least of the upper part joins the lower one. */
static void lift(const struct mesh_build *build, size_t *row, size_t count,
                 size_t lower, int axis)
{
    size_t least = lower, kept;

    for (size_t i = lower; i < count; i++)
        if (box_place(&build->boxes[row[i]], axis)
            < box_place(&build->boxes[row[least]], axis))
            least = i;
    kept = row[least];
    row[least] = row[lower];
    row[lower] = kept;
}

/* Whole leaves in the lower part. */
static size_t part_leaves(const struct mesh_build *build, size_t *row,
                          size_t count, const struct mesh_cut *cut)
{
    size_t lower = part(build, row, count, cut);

    while (lower % TRIANGLES_IN_LEAF != 0 && lower + 1 < count)
        lift(build, row, count, lower++, cut->axis);
    return lower - lower % TRIANGLES_IN_LEAF;
}

static size_t half_of(size_t count)
{
    size_t leaves = (count + TRIANGLES_IN_LEAF - 1) / TRIANGLES_IN_LEAF;

    return leaves / 2 * TRIANGLES_IN_LEAF;
}

/* ---- Nodes --------------------------------------------------------------- */

static struct box box_about(const struct mesh_build *build, const size_t *row,
                            size_t count)
{
    struct box box = box_empty;

    for (size_t i = 0; i < count; i++)
        box_join(&box, &build->boxes[row[i]]);
    return box;
}

/* The node of triangles first .. first + count of the order, all below it. */
static void build_node(const struct mesh_build *build, size_t first,
                       size_t count, size_t depth)
{
    struct mesh_hierarchy *hierarchy = build->hierarchy;
    size_t *row = hierarchy->order + first, lower = 0;
    struct mesh_node *node = &hierarchy->nodes[hierarchy->node_count++];
    struct mesh_cut cut;

    *node = (struct mesh_node){ box_about(build, row, count), 0, first, count,
                                0 };
    if (count > TRIANGLES_IN_LEAF) {
        cut = find_cut(build, row, count);
        node->count = 0;
        node->axis = cut.axis < 0 ? 0 : cut.axis;
        if (cut.axis >= 0 && depth < HALVED_FROM)
            lower = part_leaves(build, row, count, &cut);
        if (lower == 0)
            lower = half_of(count);
        build_node(build, first, lower, depth + 1);
        build_node(build, first + lower, count - lower, depth + 1);
    }
    node->next = hierarchy->node_count;
}

size_t mesh_hierarchy_nodes(size_t triangles)
{
    return 2 * ((triangles + TRIANGLES_IN_LEAF - 1) / TRIANGLES_IN_LEAF) - 1;
}

bool mesh_hierarchy_build(const struct box *boxes, size_t count,
                          struct mesh_hierarchy *hierarchy)
{
    struct mesh_build build = {
        .boxes = boxes,
        .hierarchy = hierarchy,
        .other = malloc((count + 1) * sizeof *build.other),
    };

    bool good;

    hierarchy->node_count = 0;
    hierarchy->nodes = malloc((mesh_hierarchy_nodes(count) + 1)
                              * sizeof *hierarchy->nodes);
    hierarchy->order = malloc((count + 1) * sizeof *hierarchy->order);
    good = build.other && hierarchy->nodes && hierarchy->order;
    for (size_t i = 0; good && i < count; i++)
        hierarchy->order[i] = i;
    if (good)
        build_node(&build, 0, count, 1);
    free(build.other);
    return good;
}

void mesh_hierarchy_free(struct mesh_hierarchy *hierarchy)
{
    free(hierarchy->nodes);
    free(hierarchy->order);
    *hierarchy = (struct mesh_hierarchy){ 0 };
}
