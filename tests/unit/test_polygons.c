/* test_polygons.c - polygons become triangles that cover what lies inside of an odd
 * number of outlines, once. */
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

#include <math.h>

enum { POLYGONS = 300, POINTS_MOST = 12, PARTS_MOST = 3, SAMPLES = 300 };

/* Parts one behind the other, each with its first point again. */
struct outlines {
    size_t count, parts, ends[PARTS_MOST];
    double points[PARTS_MOST * (POINTS_MOST + 1)][2];
};

static double place(uint64_t *seed)
{
    return (double)xorshift_between(seed, -1000, 1000) / 500;
}

static void draw(struct outlines *outlines, uint64_t *seed)
{
    outlines->count = 0;
    outlines->parts = 1 + xorshift(seed) % PARTS_MOST;
    for (size_t part = 0; part < outlines->parts; part++) {
        size_t first = outlines->count;
        for (size_t i = 3 + xorshift(seed) % (POINTS_MOST - 2); i > 0; i--) {
            outlines->points[outlines->count][0] = place(seed);
            outlines->points[outlines->count++][1] = place(seed);
        }
        outlines->points[outlines->count][0] = outlines->points[first][0];
        outlines->points[outlines->count++][1] = outlines->points[first][1];
        outlines->ends[part] = outlines->count;
    }
}

/* By how often a line to the right crosses the outlines. */
static bool is_inside(const struct outlines *outlines, double x, double y)
{
    bool inside = false;
    size_t i = 0;

    for (size_t part = 0; part < outlines->parts; part++, i++)
        for (; i + 1 < outlines->ends[part]; i++) {
            const double *a = outlines->points[i];
            const double *b = outlines->points[i + 1];
            if ((a[1] > y) != (b[1] > y)
                && x < a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
                inside = !inside;
        }
    return inside;
}

static double side(const double a[3], const double b[3], double x, double y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/* As they stand before the polygon is moved: seen along z. */
static size_t count_covering(const struct triangles *triangles, double x,
                             double y)
{
    size_t count = 0;

    for (size_t i = 0; i < triangles->count; i++) {
        double(*c)[3] = triangles->list[i].corners;
        double u = side(c[0], c[1], x, y), v = side(c[1], c[2], x, y);
        double w = side(c[2], c[0], x, y);
        count += (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
    }
    return count;
}

/* aslant: z = x/2 - y/4 + 1. */
static void check_polygon(const struct outlines *outlines, bool aslant,
                          uint64_t *seed)
{
    char text[8000] = "";
    size_t length = 0;
    struct scene *scene;

    length += (size_t)sprintf(text, "polygon { %zu", outlines->count);
    for (size_t i = 0; i < outlines->count; i++) {
        double x = outlines->points[i][0], y = outlines->points[i][1];
        if (aslant)
            length += (size_t)sprintf(text + length,
                                      ", <%.17g, %.17g, %.17g>", x, y,
                                      x / 2 - y / 4 + 1);
        else
            length += (size_t)sprintf(text + length, ", <%.17g, %.17g>", x,
                                      y);
    }
    strcpy(text + length, " }");
    scene = read_scene(text);
    assert_int_equal(scene->primitive_count, 1);
    assert_int_equal(scene->primitives[0].kind, PRIMITIVE_MESH);
    for (int i = 0; i < SAMPLES; i++) {
        double x = place(seed) + 1e-4, y = place(seed) + 1.7e-4;
        size_t covering =
            count_covering(&scene->primitives[0].shape.mesh.triangles, x, y);
        if (covering != is_inside(outlines, x, y))
            fail_msg("%.17g, %.17g is covered by %zu triangles in\n%s", x, y,
                     covering, text);
    }
    scene_free(scene);
}

static void test_polygons_by_chance(void **state)
{
    uint64_t seed = RANDOM_SEED;
    struct outlines outlines;
    (void)state;

    for (int i = 0; i < POLYGONS; i++) {
        draw(&outlines, &seed);
        check_polygon(&outlines, i % 2, &seed);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_polygons_by_chance),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
