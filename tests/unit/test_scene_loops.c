/* test_scene_loops.c - random nests of directives at every position of every list are
 * compared with the same text without directives. A directive that ends a list, or a
 * lost iteration, fails here.
 *
 * The test reads thousands of scenes, so it is slow with the leak sanitizer.
 */
#include "tests/unit/scene_reading.h"

#include "tests/random.h"
#include "tests/unit/random_nest.h"

enum { CASES = 6000 };

#define SAME(a, b) (memcmp(&(a), &(b), sizeof(a)) == 0)

static bool same_look(const struct primitive *a, const struct primitive *b)
{
    return a->pigment.kind == b->pigment.kind
           && SAME(a->pigment.color, b->pigment.color)
           && SAME(a->pigment.to_local, b->pigment.to_local)
           && SAME(a->finish, b->finish);
}

static bool same_primitive(const struct primitive *a, const struct primitive *b)
{
    return a->kind == PRIMITIVE_SPHERE && b->kind == PRIMITIVE_SPHERE
           && SAME(a->shape.sphere, b->shape.sphere) && SAME(a->to_world, b->to_world)
           && a->inverted == b->inverted && same_look(a, b);
}

static bool same_tree(const struct scene *a, const struct scene *b)
{
    bool same = a->node_count == b->node_count && a->region_count == b->region_count;
    for (size_t i = 0; same && i < a->node_count; i++)
        same = a->nodes[i].operation == b->nodes[i].operation
               && a->nodes[i].next == b->nodes[i].next
               && a->nodes[i].primitive == b->nodes[i].primitive;
    for (size_t i = 0; same && i < a->region_count; i++)
        same = memcmp(&a->regions[i], &b->regions[i], offsetof(struct region, line))
               == 0;
    return same;
}

static bool same_scene(const struct scene *a, const struct scene *b)
{
    bool same = a->primitive_count == b->primitive_count && same_tree(a, b);
    for (size_t i = 0; same && i < a->primitive_count; i++)
        same = same_primitive(&a->primitives[i], &b->primitives[i]);
    return same;
}

static void compare(const struct text_buffer *written,
                    const struct text_buffer *carried_out, size_t *read)
{
    SCOPED_VALUE(diagnostics) found = { 0 };
    SCOPED_VALUE(diagnostics) wanted = { 0 };
    SCOPED(scene) *is = scene_read_text("test.pov", written->text, &reading_options,
                                        &found);
    SCOPED(scene) *should_be = scene_read_text("test.pov", carried_out->text,
                                               &reading_options, &wanted);
    if (!is != !should_be || (is && !same_scene(is, should_be))
        || (found.count > 0) != (wanted.count > 0)) {
        diagnostics_print(&found, stderr);
        diagnostics_print(&wanted, stderr);
        fail_msg("%s: is not %s", written->text, carried_out->text);
    }
    *read += is != NULL && is->primitive_count > 0;
}

TEST(nests)
{
    uint64_t seed = RANDOM_SEED;
    size_t read = 0;
    for (size_t i = 0; i < CASES; i++) {
        xorshift(&seed);
        SCOPED_VALUE(text_buffer) written = random_nest(seed, true);
        SCOPED_VALUE(text_buffer) carried_out = random_nest(seed, false);
        compare(&written, &carried_out, &read);
    }
    assert_true(read > CASES / 4);
}
