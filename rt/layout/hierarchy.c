#include "rt/layout/hierarchy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The surface-area heuristic over bins: a row of regions is cut where the
 * tests that a ray is expected to need are fewest.  The chance that a ray
 * which comes near a sphere also comes near one within it is the ratio of
 * their surfaces.  Source: Goldsmith and Salmon 1987; bins: Wald 2007. */

enum {
    BINS = 16,
    EXACT = 64,       /* more parts have a sphere about their box */
    HALVED_FROM = 64, /* as deep as this a row is cut in halves */
};

/* A box that grows, of spheres. */
struct enclosure {
    size_t count;
    double low[3], high[3];
};

struct build {
    const struct bound *bounds;
    struct hierarchy *hierarchy;
    size_t *other;       /* room for a row while it is cut */
    struct bound *parts; /* .. for the bounds of EXACT */
};

/* Where a row is cut: between bins of an axis. */
struct cut {
    int axis; /* below 0: nowhere */
    double low, width;
    size_t bin; /* the first of the upper part */
    double cost;
};

/* --- extents ------------------------------------------------------------- */

static void enclosure_clear(struct enclosure *enclosure)
{
    enclosure->count = 0;
    for (int i = 0; i < 3; i++) {
        enclosure->low[i] = INFINITY;
        enclosure->high[i] = -INFINITY;
    }
}

static void enclosure_add(struct enclosure *enclosure,
                          const struct bound *bound)
{
    enclosure->count++;
    for (int i = 0; i < 3; i++) {
        enclosure->low[i] = fmin(enclosure->low[i],
                                 bound->center[i] - bound->radius);
        enclosure->high[i] = fmax(enclosure->high[i],
                                  bound->center[i] + bound->radius);
    }
}

static void enclosure_join(struct enclosure *enclosure,
                           const struct enclosure *other)
{
    enclosure->count += other->count;
    for (int i = 0; i < 3; i++) {
        enclosure->low[i] = fmin(enclosure->low[i], other->low[i]);
        enclosure->high[i] = fmax(enclosure->high[i], other->high[i]);
    }
}

/* In proportion to the surface of the sphere about the box. */
static double surface_of(const struct enclosure *enclosure)
{
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        double side = enclosure->high[i] - enclosure->low[i];

        sum += side * side;
    }
    return sum;
}

/* Tests below a node, of a ray that comes near it. */
static double cost_of(const struct enclosure *enclosure, double surface)
{
    double chance = surface > 0 ? surface_of(enclosure) / surface : 1;

    return enclosure->count == 1 ? 1 : 1 + chance * (double)enclosure->count;
}

/* --- cuts ---------------------------------------------------------------- */

static size_t bin_of(const struct cut *cut, const struct bound *bound)
{
    double place = (bound->center[cut->axis] - cut->low) / cut->width;

    return place >= BINS ? BINS - 1 : place > 0 ? (size_t)place : 0;
}

static void fill_bins(const struct build *build, const size_t *row,
                      size_t count, const struct cut *cut,
                      struct enclosure *bins)
{
    for (size_t i = 0; i < BINS; i++)
        enclosure_clear(&bins[i]);
    for (size_t i = 0; i < count; i++) {
        const struct bound *bound = &build->bounds[row[i]];

        enclosure_add(&bins[bin_of(cut, bound)], bound);
    }
}

/* The best place on one axis, if it is better than any before. */
static void try_axis(const struct build *build, const size_t *row,
                     size_t count, struct cut cut, double surface,
                     struct cut *best)
{
    struct enclosure bins[BINS], below, above[BINS + 1];

    fill_bins(build, row, count, &cut, bins);
    enclosure_clear(&above[BINS]);
    for (size_t i = BINS; i-- > 0;) {
        above[i] = above[i + 1];
        enclosure_join(&above[i], &bins[i]);
    }
    enclosure_clear(&below);
    for (cut.bin = 1; cut.bin < BINS; cut.bin++) {
        enclosure_join(&below, &bins[cut.bin - 1]);
        if (below.count == 0 || above[cut.bin].count == 0)
            continue;
        cut.cost = cost_of(&below, surface)
                   + cost_of(&above[cut.bin], surface);
        if (cut.cost < best->cost)
            *best = cut;
    }
}

static struct cut find_cut(const struct build *build, const size_t *row,
                           size_t count)
{
    struct cut best = { .axis = -1, .cost = (double)count };
    struct enclosure whole, centers;

    enclosure_clear(&whole);
    enclosure_clear(&centers);
    for (size_t i = 0; i < count; i++) {
        struct bound center = build->bounds[row[i]];

        enclosure_add(&whole, &center);
        center.radius = 0;
        enclosure_add(&centers, &center);
    }
    for (int axis = 0; axis < 3; axis++) {
        struct cut cut = { .axis = axis, .low = centers.low[axis] };

        cut.width = (centers.high[axis] - cut.low) / BINS;
        if (cut.width > 0)
            try_axis(build, row, count, cut, surface_of(&whole), &best);
    }
    return best;
}

/* The lower part first, each in its order; how many it has. */
static size_t part(const struct build *build, size_t *row, size_t count,
                   const struct cut *cut)
{
    size_t lower = 0, upper = 0;

    for (size_t i = 0; i < count; i++)
        if (bin_of(cut, &build->bounds[row[i]]) < cut->bin)
            row[lower++] = row[i];
        else
            build->other[upper++] = row[i];
    memcpy(row + lower, build->other, upper * sizeof *row);
    return lower;
}

/* --- nodes --------------------------------------------------------------- */

static void bound_many(const struct build *build, const size_t *row,
                       size_t count, struct bound *whole)
{
    struct enclosure enclosure;
    double reach = 0;

    enclosure_clear(&enclosure);
    for (size_t i = 0; i < count; i++)
        enclosure_add(&enclosure, &build->bounds[row[i]]);
    for (int i = 0; i < 3; i++)
        whole->center[i] = (enclosure.low[i] + enclosure.high[i]) / 2;
    for (size_t i = 0; i < count; i++)
        reach = fmax(reach,
                     bound_reach(&build->bounds[row[i]], whole->center));
    whole->radius = reach * (1 + 1e-12);
    memcpy(whole->low, enclosure.low, sizeof whole->low);
    memcpy(whole->high, enclosure.high, sizeof whole->high);
}

static void bound_row(const struct build *build, const size_t *row,
                      size_t count, struct bound *whole)
{
    if (count > EXACT) {
        bound_many(build, row, count, whole);
        return;
    }
    for (size_t i = 0; i < count; i++)
        build->parts[i] = build->bounds[row[i]];
    bound_enclose(build->parts, count, whole);
}

static void find_way(struct hierarchy_node *nodes, size_t node)
{
    const struct bound *first = &nodes[node + 1].bound;
    const struct bound *second = &nodes[nodes[node + 1].next].bound;

    for (int i = 0; i < 3; i++)
        nodes[node].way[i] = second->center[i] - first->center[i];
}

/* The node of regions first .. first + count of the order and all below it. */
static void build_node(const struct build *build, size_t first, size_t count,
                       size_t depth)
{
    struct hierarchy *hierarchy = build->hierarchy;
    size_t *row = hierarchy->order + first;
    size_t number = hierarchy->node_count++;
    struct hierarchy_node *node = &hierarchy->nodes[number];
    struct cut cut = find_cut(build, row, count);

    *node = (struct hierarchy_node){ .first = first, .count = count };
    bound_row(build, row, count, &node->bound);
    if (cut.axis >= 0) {
        size_t lower = depth >= HALVED_FROM ? count / 2
                                            : part(build, row, count, &cut);

        node->count = 0;
        build_node(build, first, lower, depth + 1);
        build_node(build, first + lower, count - lower, depth + 1);
        find_way(hierarchy->nodes, number);
    }
    node->next = hierarchy->node_count;
}

/* --- the whole ----------------------------------------------------------- */

/* Those without a bound first. */
static void put_loose(struct hierarchy *hierarchy, const struct bound *bounds)
{
    size_t bound = 0, loose = 0;

    for (size_t i = 0; i < hierarchy->count; i++)
        loose += bound_is_none(&bounds[i]);
    hierarchy->loose = loose;
    loose = 0;
    for (size_t i = 0; i < hierarchy->count; i++)
        if (bound_is_none(&bounds[i]))
            hierarchy->order[loose++] = i;
        else
            hierarchy->order[hierarchy->loose + bound++] = i;
}

bool hierarchy_none(size_t count, struct hierarchy *hierarchy)
{
    *hierarchy = (struct hierarchy){
        .count = count,
        .loose = count,
        .order = malloc((count + 1) * sizeof *hierarchy->order),
    };
    for (size_t i = 0; hierarchy->order && i < count; i++)
        hierarchy->order[i] = i;
    return hierarchy->order;
}

/* A hierarchy of one leaf is none. */
static void build_all(const struct build *build)
{
    struct hierarchy *hierarchy = build->hierarchy;
    size_t left;

    put_loose(hierarchy, build->bounds);
    left = hierarchy->count - hierarchy->loose;
    if (left > 0)
        build_node(build, hierarchy->loose, left, 1);
    if (hierarchy->node_count == 1) {
        hierarchy->node_count = 0;
        hierarchy->loose = hierarchy->count;
    }
}

bool hierarchy_build(const struct bound *bounds, size_t count,
                     struct hierarchy *hierarchy)
{
    struct build build = {
        .bounds = bounds,
        .hierarchy = hierarchy,
        .other = malloc((count + 1) * sizeof *build.other),
        .parts = malloc(EXACT * sizeof *build.parts),
    };
    bool good = hierarchy_none(count, hierarchy);

    hierarchy->nodes = malloc((2 * count + 1) * sizeof *hierarchy->nodes);
    good = good && build.other && build.parts && hierarchy->nodes;
    if (good)
        build_all(&build);
    free(build.other);
    free(build.parts);
    return good;
}

void hierarchy_free(struct hierarchy *hierarchy)
{
    free(hierarchy->order);
    free(hierarchy->nodes);
    *hierarchy = (struct hierarchy){ 0 };
}
