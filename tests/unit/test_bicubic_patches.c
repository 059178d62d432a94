/* test_bicubic_patches.c - the triangles of a bicubic_patch are compared with pieces
 * computed by its blossom, over random patches, steps and flatness. A wrong
 * subdivision, a corner or normal of another piece, or a missing triangle fails here.
 *
 *     test_bicubic_patches [PATCHES [SEED]]
 */
#include "tests/oracle/plain_shapes.h"
#include "tests/unit/draw.h"
#include "tests/unit/scene_reading.h"

static size_t patch_count = 400;
#define SQUARE \
    "<0, 0, 0>, <1, 0, 0>, <2, 0, 0>, <3, 0, 0>," \
    "<0, 1, 0>, <1, 1, 0>, <2, 1, 0>, <3, 1, 0>," \
    "<0, 2, 0>, <1, 2, 0>, <2, 2, 0>, <3, 2, 0>," \
    "<0, 3, 0>, <1, 3, 0>, <2, 3, 0>, <3, 3, 0>"

/* ---- The oracle ---------------------------------------------------------- */

struct patch {
    double points[4][4][3];
    double flatness;
    int steps[2];
};

struct cell {
    double from[2], to[2];
    int depth;
};

/* The blossom of a cubic: symmetric, and linear in each of three parameters. */
static double blossom(const double p[4], const double t[3])
{
    double sum = 0;
    for (int choice = 0; choice < 8; choice++) {
        double weight = 1;
        int index = 0;
        for (int k = 0; k < 3; k++) {
            bool on = choice >> k & 1;
            weight *= on ? t[k] : 1 - t[k];
            index += on;
        }
        sum += weight * p[index];
    }
    return sum;
}

/* Computes the blossom arguments of control point i of a piece. i of them are the end
 * of the piece, the others are its start. */
static void arguments(double from, double to, int i, double t[3])
{
    for (int k = 0; k < 3; k++)
        t[k] = k < i ? to : from;
}

static void blossom_point(const struct patch *patch, const double u[3],
                          const double v[3], double point[3])
{
    for (int k = 0; k < 3; k++) {
        double rows[4];
        for (int i = 0; i < 4; i++) {
            double row[4];
            for (int j = 0; j < 4; j++)
                row[j] = patch->points[i][j][k];
            rows[i] = blossom(row, v);
        }
        point[k] = blossom(rows, u);
    }
}

static void cell_point(const struct patch *patch, const struct cell *cell, int i, int j,
                       double point[3])
{
    double u[3], v[3];
    arguments(cell->from[0], cell->to[0], i, u);
    arguments(cell->from[1], cell->to[1], j, v);
    blossom_point(patch, u, v, point);
}

/* The derivative of a cubic is three times the difference of its blossom at 1 and at 0.
 * The other two arguments are the parameter of the point. */
static void oracle_normal(const struct patch *patch, double u, double v,
                          double normal[3])
{
    double at[2][3] = { { u, u, u }, { v, v, v } }, along[2][3];
    for (int axis = 0; axis < 2; axis++) {
        double ends[2][3];
        for (int end = 0; end < 2; end++) {
            double bent[3] = { axis ? v : u, axis ? v : u, end };
            blossom_point(patch, axis == 0 ? bent : at[0], axis == 1 ? bent : at[1],
                          ends[end]);
        }
        add_scaled(along[axis], ends[1], -1, ends[0]);
    }
    cross_product(along[0], along[1], normal);
    normalise(normal);
}

static bool oracle_is_flat(const struct patch *patch, const struct cell *cell)
{
    double corners[3][3], a[3], b[3], normal[3], most = 0;
    cell_point(patch, cell, 0, 0, corners[0]);
    cell_point(patch, cell, 0, 3, corners[1]);
    cell_point(patch, cell, 3, 0, corners[2]);
    add_scaled(a, corners[1], -1, corners[0]);
    add_scaled(b, corners[2], -1, corners[0]);
    cross_product(a, b, normal);
    normalise(normal);
    for (int i = 0; i < 16; i++) {
        double point[3];
        cell_point(patch, cell, i / 4, i % 4, point);
        add_scaled(point, point, -1, corners[0]);
        most = fmax(most, fabs(dot(point, normal)));
    }
    return most < patch->flatness;
}

struct expected {
    size_t count;
    struct triangle list[1024];
};

static void expect_triangle(const struct patch *patch, const struct cell *cell,
                            const int corners[3], struct expected *expected)
{
    struct triangle *triangle = &expected->list[expected->count++];
    for (int k = 0; k < 3; k++) {
        bool high[2] = { corners[k] & 2, corners[k] & 1 };
        cell_point(patch, cell, high[0] ? 3 : 0, high[1] ? 3 : 0, triangle->corners[k]);
        oracle_normal(patch, high[0] ? cell->to[0] : cell->from[0],
                      high[1] ? cell->to[1] : cell->from[1], triangle->normals[k]);
    }
}

static void expect_cell(const struct patch *patch, struct cell cell,
                        struct expected *expected)
{
    static const int two[2][3] = { { 0, 1, 3 }, { 0, 2, 3 } };
    bool cut[2] = { cell.depth < patch->steps[0], cell.depth < patch->steps[1] };
    if ((!cut[0] && !cut[1]) || oracle_is_flat(patch, &cell)) {
        for (int i = 0; i < 2; i++)
            expect_triangle(patch, &cell, two[i], expected);
        return;
    }
    for (int part = 0; part < 4; part++) {
        struct cell child = cell;
        bool there = true;
        for (int axis = 0; axis < 2; axis++) {
            double middle = (cell.from[axis] + cell.to[axis]) / 2;
            bool high = part >> axis & 1;
            if (cut[axis])
                *(high ? &child.from[axis] : &child.to[axis]) = middle;
            there = there && (cut[axis] || !high);
        }
        child.depth++;
        if (there)
            expect_cell(patch, child, expected);
    }
}

/* ---- Random cases ----------------------------------------------------------- */

static struct patch random_patch(void)
{
    struct patch patch = { .flatness = pow(10, between(-3, .3)) };
    for (int i = 0; i < 2; i++)
        patch.steps[i] = (int)xorshift_between(&random_state, 0, 4);
    for (int i = 0; i < 48; i++) {
        double grid[3] = { i / 12, i / 3 % 4, 0 };
        patch.points[i / 12][i / 3 % 4][i % 3] = grid[i % 3] + between(-.45, .45);
    }
    return patch;
}

static void write_patch(const struct patch *patch, const double scale[3], char *text)
{
    text += sprintf(text,
                    "bicubic_patch { type %d flatness %.17g u_steps %d v_steps %d\n",
                    (int)xorshift_between(&random_state, 0, 2), patch->flatness,
                    patch->steps[0], patch->steps[1]);
    for (int i = 0; i < 16; i++) {
        const double *p = patch->points[i / 4][i % 4];
        text += sprintf(text, "%s<%.17g, %.17g, %.17g>\n", i ? ", " : "", p[0], p[1],
                        p[2]);
    }
    sprintf(text, "scale <%.17g, %.17g, %.17g> translate <1, -2, 3> }\n", scale[0],
            scale[1], scale[2]);
}

static bool is_near(const double a[3], const double b[3])
{
    for (int k = 0; k < 3; k++)
        if (!(fabs(a[k] - b[k]) < 1e-9))
            return false;
    return true;
}

static bool is_same(const struct triangle *a, const struct triangle *b)
{
    for (int k = 0; k < 3; k++) {
        bool found = false;
        for (int m = 0; m < 3; m++)
            found = found
                    || (is_near(a->corners[k], b->corners[m])
                        && is_near(a->normals[k], b->normals[m]));
        if (!found)
            return false;
    }
    return true;
}

static bool has_all(const struct triangles *triangles, const struct expected *expected)
{
    if (triangles->count != expected->count)
        return false;
    for (size_t i = 0; i < expected->count; i++) {
        size_t same = 0;
        for (size_t k = 0; k < triangles->count; k++)
            same += triangles->list[k].smooth
                    && is_same(&triangles->list[k], &expected->list[i]);
        if (same != 1)
            return false;
    }
    return true;
}

TEST(random_patches)
{
    static struct expected expected;
    char text[4096];
    for (size_t i = 0; i < patch_count; i++) {
        struct patch patch = random_patch();
        double scale[3];
        for (int k = 0; k < 3; k++)
            scale[k] = between(.4, 2.5) * (xorshift(&random_state) & 1 ? 1 : -1);
        write_patch(&patch, scale, text);
        for (int k = 0; k < 48; k++) {
            double *x = &patch.points[k / 12][k / 3 % 4][k % 3];
            *x = *x * scale[k % 3] + (k % 3 == 0 ? 1 : k % 3 == 1 ? -2 : 3);
        }
        expected.count = 0;
        expect_cell(&patch, (struct cell){ .to = { 1, 1 } }, &expected);
        SCOPED(scene) *scene = read_scene(text);
        FAIL_IF(!has_all(triangles_of(scene), &expected),
                "patch %zu: %zu triangles, not these %zu, of\n%s", i,
                triangles_of(scene)->count, expected.count, text);
    }
}

/* ---- Words and errors ---------------------------------------------------- */

TEST(words)
{
    static const struct {
        const char *text;
        size_t triangles;
    } cases[] = {
        /* A flat patch is not divided, unless its flatness parameter is 0. */
        { "bicubic_patch { type 0 " SQUARE " }", 2 },
        { "bicubic_patch { v_steps 1.9 type 1 u_steps 2, " SQUARE " scale 2 }", 2 * 8 },
        { "bicubic_patch { type 1 u_steps 3 v_steps 3 flatness .1 " SQUARE " }", 2 },
        { "bicubic_patch { u_steps -3 type 3 u_steps 1 "
          "uv_vectors <0, 0> x <1, 1> y " SQUARE " inverse }",
          4 },
        { "#declare P = bicubic_patch { type 1 u_steps 1 v_steps 1 flatness .5 " SQUARE
          " matrix <1,0,0, 0,1,0, 0,0,1, 0,0,0> } object { P rotate x }",
          2 },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        SCOPED(scene) *scene = read_scene(cases[i].text);
        FAIL_IF(triangles_of(scene)->count != cases[i].triangles, "%zu triangles of %s",
                triangles_of(scene)->count, cases[i].text);
    }
}

/* Flatness is measured in world space, for each copy. */
TEST(copies)
{
    SCOPED(scene) *scene = read_scene(
        "#declare P = bicubic_patch { type 1 u_steps 1 v_steps 1 flatness .1\n"
        "<0, 0, .5>, <1, 0, 0>, <2, 0, 0>, <3, 0, 0>,"
        "<0, 1, 0>, <1, 1, 0>, <2, 1, 0>, <3, 1, 0>,"
        "<0, 2, 0>, <1, 2, 0>, <2, 2, 0>, <3, 2, 0>,"
        "<0, 3, 0>, <1, 3, 0>, <2, 3, 0>, <3, 3, 0> }\n"
        "union { object { P } object { P scale .1 } scale 1 }\n"
        "object { P scale .1 scale 10 }");
    const struct primitive *p = scene->primitives;
    assert_int_equal(scene->primitive_count, 3);
    assert_int_equal(p[0].shape.mesh.triangles.count, 8);
    assert_int_equal(p[1].shape.mesh.triangles.count, 2);
    assert_int_equal(p[2].shape.mesh.triangles.count, 8);
    assert_vector(p[1].shape.mesh.triangles.list[0].corners[2], .3, .3, 0);
}

static const struct line_error errors[] = {
    { "bicubic_patch { " SQUARE " }", 17, "expected 'type'" },
    { "bicubic_patch { flatness 1 u_steps 2 " SQUARE " }", 38, "expected 'type'" },
    { "bicubic_patch { type -1 " SQUARE " }", 22, "at least 0" },
    { "bicubic_patch { type 1 u_steps 21 " SQUARE " }", 32,
      "'u_steps' must be at most 20" },
    { "bicubic_patch { type 1 v_steps 1e9 " SQUARE " }", 32,
      "'v_steps' must be at most 20" },
    { "bicubic_patch { type 1 x, y }", 29, "expected a number" },
    { "bicubic_patch { type 1 " SQUARE ", x }", 195, "found \',\'" },
};

TEST_CALL(errors, assert_errors(errors, COUNT(errors)))

COUNT_AND_SEED(patch_count, random_state);
