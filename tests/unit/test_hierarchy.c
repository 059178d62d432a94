/* test_hierarchy.c - hierarchies over regions with random, equal, nested and missing
 * bounds are compared with their rules: every region occurs once, spheres enclose their
 * regions, and the machine's stack is large enough. A region that is lost or outside of
 * its node fails here. */
#include <math.h>

#include "rt/bvh/hierarchy.h"
#include "tests/unit/draw.h"
#include "tests/unit/unit.h"

enum { MAX = 3000 };

/* ---- Rows of bounds ------------------------------------------------------ */

static struct bound ball(double x, double y, double z, double radius)
{
    return (struct bound){ .center = { x, y, z },
                           .radius = radius,
                           .low = { x - radius, y - radius, z - radius },
                           .high = { x + radius, y + radius, z + radius } };
}

/* Sizes of SMALLER decrease by a factor, so that bins separate only a few. */
enum kind {
    ANYWHERE,
    SAME_POINT,
    WHOLE_NUMBERS,
    SMALLER,
    FAR,
    SOME_MISSING,
    MISSING,
    KINDS
};

static struct bound draw_bound(enum kind kind, size_t i)
{
    double size = ldexp(1e9, -(int)(i % 60));
    switch (kind) {
    case SAME_POINT: return ball(1, 2, 3, 1);
    case WHOLE_NUMBERS:
        return ball((double)below(3), (double)below(3), (double)below(3), .5);
    case SMALLER: return ball(size, 0, 0, size / 100);
    case FAR: return ball(i % 2 ? 1e12 : -1e12, 0, (double)i, 1e3);
    case SOME_MISSING: return below(4) == 0 ? bound_none : draw_bound(ANYWHERE, i);
    case MISSING: return bound_none;
    default:
        return ball(between(-9, 9), between(-9, 9), between(-9, 9), between(1e-3, 2));
    }
}

/* ---- Rules for every hierarchy ------------------------------------------- */

static void check_order(const struct hierarchy *hierarchy, size_t count)
{
    FREED bool *seen = calloc(count + 1, sizeof *seen);
    assert_int_equal(hierarchy->count, count);
    for (size_t i = 0; i < count; i++) {
        assert_true(hierarchy->order[i] < count);
        assert_false(seen[hierarchy->order[i]]);
        seen[hierarchy->order[i]] = true;
    }
}

/* Checks a node and its descendants, whose regions begin at `place` of the order.
 * Returns the place after their last region. */
static size_t check_node(const struct hierarchy *hierarchy, const struct bound *bounds,
                         size_t i, size_t place, size_t depth)
{
    const struct hierarchy_node *node = &hierarchy->nodes[i];
    size_t end = place;
    assert_true(depth <= HIERARCHY_DEPTH);
    assert_true(node->next > i && node->next <= hierarchy->node_count);
    if (node->count > 0) {
        assert_int_equal(node->first, place);
        assert_int_equal(node->next, i + 1);
        end = place + node->count;
    } else {
        size_t second = hierarchy->nodes[i + 1].next;
        double way[3];
        end = check_node(hierarchy, bounds, i + 1, place, depth + 1);
        end = check_node(hierarchy, bounds, second, end, depth + 1);
        assert_int_equal(hierarchy->nodes[second].next, node->next);
        for (int k = 0; k < 3; k++)
            way[k] = hierarchy->nodes[second].bound.center[k]
                     - hierarchy->nodes[i + 1].bound.center[k];
        assert_memory_equal(node->way, way, sizeof way);
    }
    assert_true(end > place);
    for (size_t k = place; k < end; k++) {
        const struct bound *whole = &node->bound;
        const struct bound *part = &bounds[hierarchy->order[k]];
        assert_true(bound_reach(part, whole->center) <= whole->radius * (1 + 1e-12));
        for (int j = 0; j < 3; j++)
            assert_true(whole->low[j] <= part->low[j]
                        && part->high[j] <= whole->high[j]);
    }
    return end;
}

static size_t check(const struct bound *bounds, size_t count)
{
    SCOPED_VALUE(hierarchy) hierarchy;
    assert_true(hierarchy_build(bounds, count, &hierarchy));
    check_order(&hierarchy, count);
    /* Loose regions have no bound, or are all regions. They come first, in order. */
    bool all = hierarchy.loose == hierarchy.count;
    assert_true(all == (hierarchy.node_count == 0));
    for (size_t i = 0; i < hierarchy.count; i++)
        assert_true(
            all || bound_is_none(&bounds[hierarchy.order[i]]) == (i < hierarchy.loose));
    for (size_t i = 1; i < hierarchy.loose; i++) {
        size_t last = hierarchy.order[i - 1], next = hierarchy.order[i];
        bool missing = bound_is_none(&bounds[last]);
        assert_true(missing == bound_is_none(&bounds[next]) ? last < next : missing);
    }
    if (hierarchy.node_count > 0) {
        assert_int_equal(check_node(&hierarchy, bounds, 0, hierarchy.loose, 1), count);
        assert_int_equal(hierarchy.nodes[0].next, hierarchy.node_count);
    }
    return hierarchy.node_count;
}

TEST(random)
{
    FREED struct bound *bounds = malloc(MAX * sizeof *bounds);
    for (int turn = 0; turn < 300; turn++) {
        size_t count = turn % 10 ? below(40) : below(MAX);
        enum kind kind = (enum kind)below(KINDS), other = (enum kind)below(KINDS);
        for (size_t i = 0; i < count; i++)
            bounds[i] = draw_bound(below(5) ? kind : other, i);
        check(bounds, count);
    }
}

/* Separate bounds are divided into nodes. Coincident bounds stay together. */
TEST(nodes)
{
    struct bound bounds[64];
    for (size_t i = 0; i < 64; i++)
        bounds[i] = ball(10. * (double)i, 0, 0, 1);
    assert_int_equal(check(bounds, 64), 63); /* leaves of two regions */
    assert_int_equal(check(bounds, 1), 0);
    assert_int_equal(check(bounds, 0), 0);
    for (size_t i = 0; i < 64; i++)
        bounds[i] = draw_bound(SAME_POINT, i);
    assert_int_equal(check(bounds, 64), 0);
    SCOPED_VALUE(hierarchy) none;
    assert_true(hierarchy_none(5, &none));
    assert_int_equal(none.loose, 5);
    assert_int_equal(none.node_count, 0);
    check_order(&none, 5);
}

/* The sizes decrease so quickly that bins separate only the largest bound from the
 * others. Without a limit, there would be a node for each bound except the last two. */
TEST(depth)
{
    /* Lists at this depth are halved. Above it each level has two nodes. */
    enum { COUNT = 120, HALVED_FROM = 64 };
    struct bound bounds[COUNT];
    double size = 1e11;
    for (size_t i = 0; i < COUNT; i++, size /= 20)
        bounds[i] = ball(size, 0, 0, size / 100);
    assert_in_range(check(bounds, COUNT), 2 * HALVED_FROM, 2 * COUNT - 5);
}
