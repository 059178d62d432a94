/* test_shape_words.c - the words that the host computes for each primitive are compared
 * with definitions. Examples are a quadric about its centre, and the kind of a Steiner
 * patch. A wrong word, kernel or number of crossings fails here. */

#include "rt/shapes/moving_planes.h"
#include "rt/shapes/shape_words.h"
#include "rt/shapes/singular.h"
#include "rt/shapes/steiner.h"
#include "tests/unit/draw.h"
#include "tests/unit/scene_reading.h"

static void fill(struct singular *singular, size_t rows, size_t columns)
{
    singular->rows = rows;
    singular->columns = columns;
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < columns; j++)
            singular->scaled[i][j] = between(-1, 1);
}

/* A V = U S. The columns of U S are orthogonal with the singular values as lengths. */
TEST(singular_values)
{
    for (size_t rows = 1; rows <= MAX_SINGULAR; rows++) {
        struct singular before;
        fill(&before, rows, 7);
        struct singular after = before;
        singular_decompose(&after);
        assert_int_equal(singular_nullity(&after, 1e-12), rows < 7 ? 7 - rows : 0);
        for (size_t j = 0; j < 7; j++)
            for (size_t k = 0; k < 7; k++) {
                double product = 0;
                for (size_t i = 0; i < rows; i++) {
                    double sum = 0;
                    for (size_t l = 0; l < 7; l++)
                        sum += before.scaled[i][l] * after.right[l][k];
                    assert_close(after.scaled[i][k], sum, 1e-14);
                    product += after.scaled[i][j] * after.scaled[i][k];
                }
                assert_close(product, j == k ? after.values[j] * after.values[j] : 0,
                             1e-13);
            }
    }
}

TEST(least_squares)
{
    struct singular singular;
    double x[7], b[4] = { 1, -2, .5, 3 };
    fill(&singular, 4, 7);
    struct singular matrix = singular;
    singular_decompose(&singular);
    singular_solve(&singular, 1e-12, b, x);
    for (size_t i = 0; i < 4; i++) {
        double sum = 0;
        for (size_t j = 0; j < 7; j++)
            sum += matrix.scaled[i][j] * x[j];
        assert_close(sum, b[i], 1e-13);
    }
}

/* The words of a shape, and its table. */
struct words {
    struct shape_words shape;
    size_t table_count;
    double table[MAX_STEINER_TABLE];
};

static struct words words_of(const struct primitive *primitive)
{
    struct words words;
    shape_words(primitive, &words.shape);
    words.table_count = shape_table_count(primitive, NULL);
    FREED double *table = shape_table(primitive, NULL, words.table_count);
    assert_true(table && words.table_count <= MAX_STEINER_TABLE);
    memcpy(words.table, table, words.table_count * sizeof *table);
    return words;
}

static void set_quadric(struct primitive *primitive, const double terms[10])
{
    memset(primitive, 0, sizeof *primitive);
    primitive->kind = PRIMITIVE_QUADRIC;
    memcpy(primitive->shape.quadric.coefficients, terms, QUADRIC_TERMS * sizeof *terms);
}

/* An ellipsoid about (1, 2, 3), a cylinder about x = 1, y = 2, a paraboloid. */
TEST(centers_of_quadrics)
{
    static const double terms[3][10] = {
        { 1, 4, 9, 0, 0, 0, -2, -16, -54, 97 },
        { 1, 1, 0, 0, 0, 0, -2, -4, 0, 4 },
        { 1, 1, 0, 0, 0, 0, 0, 0, -1, 0 },
    };
    static const double expected[3][13] = {
        { 1, 2, 3, 1, 4, 9, 0, 0, 0, 0, 0, 0, -1 },
        { 1, 2, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, -1 },
        { 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, -.5, 0 },
    };
    for (size_t k = 0; k < 3; k++) {
        struct primitive primitive;
        set_quadric(&primitive, terms[k]);
        struct words words = words_of(&primitive);
        assert_int_equal(words.shape.count, 13);
        assert_numbers("quadric", words.shape.words, expected[k], 13, 1e-13);
    }
}

/* The value of the quadric at a point must equal the value computed from its words. */
TEST(quadrics_keep_their_values)
{
    for (int try = 0; try < 100; try++) {
        double terms[10], x[3], y[3];
        struct primitive primitive;
        struct words words;
        const double *w = words.shape.words;
        for (size_t i = 0; i < 10; i++)
            terms[i] = try % 3 == 0 && i % 2 == 0 ? 0 : between(-1, 1);
        set_quadric(&primitive, terms);
        words = words_of(&primitive);
        for (size_t i = 0; i < 3; i++) {
            x[i] = between(-2, 2);
            y[i] = x[i] - w[i];
        }
        double value = terms[0] * x[0] * x[0] + terms[1] * x[1] * x[1]
                       + terms[2] * x[2] * x[2] + terms[3] * x[0] * x[1]
                       + terms[4] * x[0] * x[2] + terms[5] * x[1] * x[2]
                       + terms[6] * x[0] + terms[7] * x[1] + terms[8] * x[2] + terms[9];
        double again = w[3] * y[0] * y[0] + w[4] * y[1] * y[1] + w[5] * y[2] * y[2]
                       + 2
                             * (w[6] * y[0] * y[1] + w[7] * y[0] * y[2]
                                + w[8] * y[1] * y[2] + w[9] * y[0] + w[10] * y[1]
                                + w[11] * y[2])
                       + w[12];
        assert_close(again, value,
                     1e-9 * (1 + w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    }
}

static const int factors[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 },
                                   { 0, 1 }, { 1, 2 }, { 2, 0 } };

static void point_at(const double points[6][4], const double p[3], double h[4])
{
    for (int c = 0; c < 4; c++) {
        h[c] = 0;
        for (int m = 0; m < 6; m++)
            h[c] += (m < 3 ? 1 : 2) * points[m][c] * p[factors[m][0]]
                    * p[factors[m][1]];
    }
}

/* Every plane contains its point, and all planes contain the triple point. */
static void check_planes(const double points[6][4], const struct moving_planes *planes)
{
    for (int try = 0; try < 20; try++) {
        double p[3], h[4];
        for (int i = 0; i < 3; i++)
            p[i] = between(-1, 1);
        point_at(points, p, h);
        for (int which = 0; which < 2; which++) {
            double at = 0, triple = 0;
            for (int i = 0; i < 3; i++)
                for (int c = 0; c < 4; c++) {
                    double l = planes->l[which][i][c];
                    at += p[i] * l * h[c];
                    triple += p[i] * l * planes->triple[c];
                }
            assert_close(at, 0, 1e-13);
            assert_close(triple, 0, 1e-13);
        }
    }
}

static enum surface_type type_of(const double points[6][4])
{
    struct moving_planes planes;
    moving_planes_find(points, &planes);
    if (planes.type == SURFACE_STEINER)
        check_planes(points, &planes);
    return planes.type;
}

TEST(types_of_surfaces)
{
    /* The surface (tu, su, st, s^2 + t^2 + u^2), a sphere by stereographic projection,
     * a cone with two parameters for each point, and a plane with curved edges. */
    static const double roman[6][4] = { { 0, 0, 0, 1 },  { 0, 0, 0, 1 },
                                        { 0, 0, 0, 1 },  { 0, 0, .5, 0 },
                                        { .5, 0, 0, 0 }, { 0, .5, 0, 0 } };
    static const double sphere[6][4] = { { 0, 0, 1, 1 },  { 0, 0, 1, 1 },
                                         { 0, 0, -1, 1 }, { 0, 0, 0, 0 },
                                         { 0, 1, 0, 0 },  { 1, 0, 0, 0 } };
    static const double cone[6][4] = { { 0, 0, 0, 1 },    { 1, 1, 0, 1 },
                                       { 1, -1, 0, 1 },   { 0, 0, 0, 1 },
                                       { 1.6, 0, -1, 1 }, { 0, 0, 0, 1 } };
    static const double plane[6][4] = { { 1, 0, 0, 1 },    { 0, 1, 0, 1 },
                                        { 0, 0, 0, 1 },    { .7, .8, 0, 1 },
                                        { -.2, .4, 0, 1 }, { .5, .1, 0, 1 } };
    double points[6][4];

    assert_int_equal(type_of(roman), SURFACE_STEINER);
    assert_int_equal(type_of(sphere), SURFACE_QUADRIC);
    assert_int_equal(type_of(cone), SURFACE_QUADRIC);
    assert_int_equal(type_of(plane), SURFACE_PLANE);
    for (int try = 0; try < 50; try++) {
        for (int m = 0; m < 6; m++)
            for (int c = 0; c < 4; c++)
                points[m][c] = between(-1, 1);
        assert_int_equal(type_of((const double(*)[4])points), SURFACE_STEINER);
        memset(points[0], 0, sizeof points[0]); /* a base point */
        assert_int_equal(type_of((const double(*)[4])points), SURFACE_CUBIC);
    }
}

static void set_patch(struct primitive *primitive)
{
    memset(primitive, 0, sizeof *primitive);
    primitive->kind = PRIMITIVE_STEINER_PATCH;
    for (int i = 0; i < STEINER_POINTS; i++) {
        for (int axis = 0; axis < 3; axis++)
            primitive->shape.steiner_patch.points[i][axis] = between(-9, 9);
        primitive->shape.steiner_patch.weights[i] = between(.5, 2);
    }
}

/* Returns the kernel of 1984, or NULL. */
static const char *historical_kernel(const struct primitive *primitive)
{
    struct shape_words words;
    return shape_words_historical(primitive, &words) ? words.kernel : NULL;
}

TEST(kernels_of_patches)
{
    struct primitive patch;
    set_patch(&patch);
    struct words words = words_of(&patch);
    assert_string_equal(words.shape.kernel, "rational_steiner");
    assert_string_equal(words.shape.solid, "rational_steiner_crossings");
    assert_string_equal(historical_kernel(&patch), "rational_steiner_implicit");
    assert_true(words.shape.on_patch);
    for (int i = 0; i < STEINER_POINTS; i++)
        patch.shape.steiner_patch.weights[i] = 3;
    words = words_of(&patch);
    assert_string_equal(words.shape.kernel, "steiner");
    assert_string_equal(words.shape.solid, "steiner_crossings");
    assert_string_equal(historical_kernel(&patch), "steiner_implicit");
    for (int i = 0; i < STEINER_POINTS; i++)
        patch.shape.steiner_patch.points[i][1] = 2;
    words = words_of(&patch);
    assert_null(historical_kernel(&patch));
    assert_int_equal(words.table_count, STEINER_TABLE);
}

/* A surface, a solid, a clipping mesh, and a mesh with a body. Each has room for a
 * crossing with every triangle, and for the state at the ray's origin. */
TEST(sorts_of_meshes)
{
    struct triangle list[3] = { { .corners = { { 0 }, { 1 }, { 0, 1 } } },
                                { .corners = { { 0 }, { 1 }, { 0, 1 } } },
                                { .corners = { { 0 }, { 1 }, { 0, 1 } } } };
    struct primitive mesh = { .kind = PRIMITIVE_MESH,
                              .shape.mesh.triangles = { 3, list } };
    struct shape_words words;
    shape_words(&mesh, &words);
    assert_true(words.on_mesh && words.on_patch && !words.state);
    assert_int_equal(words.segments, 0);
    assert_int_equal(words.events, 4);
    assert_string_equal(words.kernel, "mesh");
    assert_string_equal(words.solid, "mesh_crossings");
    mesh.shape.mesh.solid = true;
    shape_words(&mesh, &words);
    assert_int_equal(words.segments, 2);
    assert_int_equal(words.events, 4);
    assert_string_equal(words.solid, "mesh_solid");
    mesh.invisible = true;
    shape_words(&mesh, &words);
    assert_int_equal(words.events, 2);
    assert_string_equal(words.solid, "invisible");
    assert_string_equal(words.state, "mesh_solid");
    mesh.invisible = mesh.shape.mesh.solid = false;
    mesh.shape.mesh.body = (struct triangles){ 2, list };
    shape_words(&mesh, &words);
    assert_int_equal(words.segments, 1);
    assert_int_equal(words.events, 4);
    assert_string_equal(words.solid, "mesh_crossings");
    assert_string_equal(words.state, "mesh_body");
}

/* The kernel of 1984 needs the base, the axis, the radius, and the planes of both ends.
 * A hit has the surfaces of entry and exit. */
TEST(historical_cylinders)
{
    static const double expected[] = { 1, 2,   3, .6, 0, .8, .5,  -.6,
                                       0, -.8, 3, .6, 0, .8, -13, 2 };
    struct primitive cylinder = {
        .kind = PRIMITIVE_CYLINDER,
        .shape.cylinder = { .base = { 1, 2, 3 }, .cap = { 7, 2, 11 }, .radius = .5 },
    };
    struct shape_words words, today;
    assert_true(shape_words_historical(&cylinder, &words));
    assert_string_equal(words.kernel, "clipped_cylinder");
    assert_string_equal(words.normal, "normal_clipped_cylinder");
    assert_string_equal(words.solid, "cylinder");
    assert_true(words.on_patch);
    assert_int_equal(words.count, COUNT(expected));
    assert_numbers("cylinder", words.words, expected, words.count, 1e-14);
    cylinder.shape.cylinder.open = true;
    assert_true(shape_words_historical(&cylinder, &words));
    assert_string_equal(words.kernel, "open_clipped_cylinder");
    shape_words(&cylinder, &today);
    assert_string_equal(today.kernel, "open_cylinder");
    assert_false(today.on_patch);
}

/* For every order of the corners, H(0, 0), H(1, 0) and H(0, 1) are corners after the
 * centre is added, and the whole patch is inside the bound. */
TEST(polynomials_of_patches)
{
    for (int try = 0; try < 50; try++) {
        struct primitive patch;
        struct words words;
        const double *k = words.table;
        int corners = 0;
        set_patch(&patch);
        words = words_of(&patch);
        for (int i = 0; i < 3; i++) {
            const double *corner = patch.shape.steiner_patch.points[i];
            double distance = 0;
            for (int axis = 0; axis < 3; axis++)
                distance += fabs(k[axis] / k[18] + words.shape.words[axis]
                                 - corner[axis]);
            corners += distance < 1e-12;
            distance = 0;
            for (int axis = 0; axis < 3; axis++)
                distance += pow(corner[axis] - words.shape.words[axis], 2);
            assert_true(distance < words.shape.words[3]);
        }
        assert_int_equal(corners, 1);
    }
}

/* A plane through a parallel ray needs a second vector in another direction if all
 * curves s = const have the same direction. */
TEST(other_planes)
{
    static const double straight[][3 * STEINER_POINTS] = {
        { 0, 0, 1, 2, 0, 0, 0, 0, 0, -.5, .5, 0, -1, 0, 0, .5, 0, 0 },
        { -1, 0, 1, 2, 0, 0, 0, 0, 0, -1, .5, 0, -1, 0, 0, 0, 0, 0 },
        { 0, 2, 0, 1, 4, 0, 2, 2, 0, 0, 2, 0, 1, 4, 0, 2, 2, 0 },
        { 0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 },
    };
    for (size_t i = 0; i < COUNT(straight); i++) {
        struct primitive patch;
        set_patch(&patch);
        for (int j = 0; j < STEINER_POINTS; j++)
            patch.shape.steiner_patch.weights[j] = 1;
        memcpy(patch.shape.steiner_patch.points, straight[i], sizeof straight[i]);
        struct words words = words_of(&patch);
        const double *last = words.table + 15;
        const double *other = words.table + 24;
        assert_close(other[0] * other[0] + other[1] * other[1] + other[2] * other[2],
                     words.shape.words[3], 1e-12);
        assert_close(last[0] * other[0] + last[1] * other[1] + last[2] * other[2], 0,
                     1e-12);
    }
}

/* The same patch has other weights if s, t and u are scaled. */
TEST(weights_of_one_patch)
{
    static const double by[] = { 100, 1, .01 };
    struct primitive patch;
    set_patch(&patch);
    struct words words = words_of(&patch);
    for (int i = 0; i < STEINER_POINTS; i++)
        patch.shape.steiner_patch.weights[i] *= by[factors[i][0]] * by[factors[i][1]];
    struct words other = words_of(&patch);
    assert_numbers("table", other.table, words.table, STEINER_TABLE, 1e-12);
}
