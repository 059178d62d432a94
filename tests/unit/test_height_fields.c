/* test_height_fields.c - the triangles of a height_field are compared with the surface
 * that POV-Ray's documentation describes, point by point, over random fields. A wrong
 * diagonal, normal or water level fails here. test_height_files.c tests the kinds of
 * files.
 *
 *     test_height_fields [FIELDS [SEED]]
 */
#include "rt/shapes/shape.h"
#include "tests/oracle/plain_shapes.h"
#include "tests/unit/draw.h"
#include "tests/unit/field_reading.h"

enum { MAX_GRID = 9, SAMPLES = 100 };

static size_t field_count = 200;
/* ---- The surface --------------------------------------------------------- */

struct grid {
    int columns, rows;
    int heights[MAX_GRID][MAX_GRID]; /* indexed [z][x] */
};

/* Makes a random field and its text image, in rows of descending z. */
static struct grid draw_grid(void)
{
    struct grid grid = { .columns = (int)between(2, MAX_GRID + 1),
                         .rows = (int)between(2, MAX_GRID + 1) };
    char text[2000];
    int end = sprintf(text, "P2\n# random\n%d %d 65535", grid.columns, grid.rows);
    for (int z = 0; z < grid.rows; z++)
        for (int x = 0; x < grid.columns; x++)
            grid.heights[z][x] = (int)between(0, 65536);
    for (int z = grid.rows - 1; z >= 0; z--)
        for (int x = 0; x < grid.columns; x++)
            end += sprintf(text + end, "\n%d", grid.heights[z][x]);
    field_keep(text, (size_t)end);
    return grid;
}

static double height_of(const struct grid *grid, int x, int z)
{
    return grid->heights[z][x] / 65536.;
}

/* Returns the height of the field at a point, from 0 to 1. */
static double surface(const struct grid *grid, double x, double z)
{
    double u = x * (grid->columns - 1), v = z * (grid->rows - 1);
    int i = (int)u, j = (int)v;
    double a = height_of(grid, i, j), b = height_of(grid, i + 1, j);
    double c = height_of(grid, i, j + 1), d = height_of(grid, i + 1, j + 1);
    u -= i;
    v -= j;
    if (u + v <= 1)
        return a + u * (b - a) + v * (c - a);
    return d + (1 - u) * (c - d) + (1 - v) * (b - d);
}

TEST(surface)
{
    for (size_t i = 0; i < field_count; i++) {
        struct grid grid = draw_grid();
        double water = i % 3 ? between(-.2, .8) : 0;
        const char *words = formatted("water_level %.9f", water);
        if (water > surface(&grid, .5, .5))
            continue; /* the water may cover everything */
        SCOPED(scene) *scene = field_expect(i % 2 ? "pgm" : "",
                                            water == 0 ? "" : words);
        const struct triangles *triangles = triangles_of(scene);
        for (int k = 0; k < SAMPLES; k++) {
            double x = between(0, 1), z = between(0, 1), met = -1;
            double expected = surface(&grid, x, z);
            int count = field_meet(triangles, x, z, &met);
            if (fabs(expected - water) < 1e-6)
                continue;
            assert_int_equal(count, expected > water);
            if (count)
                assert_close(met, expected, CLOSE);
        }
    }
}

/* ---- Normals ------------------------------------------------------------- */

static void make_unit(double normal[3])
{
    double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1]
                         + normal[2] * normal[2]);
    for (int i = 0; i < 3; i++)
        normal[i] /= length;
}

/* Computes the normal as the sum of the normals of the triangles to each pair of
 * neighbours. The width of a cell is one unit of height. Components are truncated to
 * multiples of 1/32767. */
static void normal_at(const struct grid *grid, int x, int z, double normal[3])
{
    double sum[3] = { 0, 0, 0 };
    for (int corner = 0; corner < 4; corner++) {
        int to_x = x + (corner & 1 ? 1 : -1), to_z = z + (corner & 2 ? 1 : -1);
        if (to_x < 0 || to_x >= grid->columns || to_z < 0 || to_z >= grid->rows)
            continue;
        int height = grid->heights[z][x];
        double along = (to_x - x) * (grid->heights[z][to_x] - height);
        double up = (to_z - z) * (grid->heights[to_z][x] - height);
        double length = sqrt(along * along + up * up + 1);
        sum[0] -= along / length;
        sum[1] += 1 / length;
        sum[2] -= up / length;
    }
    make_unit(sum);
    for (int i = 0; i < 3; i++)
        normal[i] = trunc(sum[i] * 32767);
    normal[0] *= grid->columns - 1;
    normal[1] *= 65536;
    normal[2] *= grid->rows - 1;
}

/* Normals in world space have length one. */
TEST(normals)
{
    for (size_t i = 0; i < field_count; i++) {
        struct grid grid = draw_grid();
        double wide = between(.5, 2), high = between(1, 4000);
        const char *words = formatted("smooth scale <%.17g, %.17g, 1>", wide, high);
        SCOPED(scene) *scene = field_expect("", words);
        const struct triangles *triangles = triangles_of(scene);
        assert_int_equal(triangles->count, 2 * (grid.columns - 1) * (grid.rows - 1));
        for (size_t k = 0; k < 3 * triangles->count; k++) {
            const struct triangle *triangle = &triangles->list[k / 3];
            assert_true(triangle->smooth);
            const double *corner = triangle->corners[k % 3];
            const double *normal = triangle->normals[k % 3];
            int x = (int)lround(corner[0] / wide * (grid.columns - 1));
            int z = (int)lround(corner[2] * (grid.rows - 1));
            double exact[3];
            normal_at(&grid, x, z, exact);
            exact[0] /= wide;
            exact[1] /= high;
            make_unit(exact);
            for (int j = 0; j < 3; j++)
                assert_close(normal[j], exact[j], 1e-4); /* steps of rounding */
            assert_close(corner[1], high * height_of(&grid, x, z), 1e-9);
        }
    }
}

/* Normals from POV-Ray's trace() for a field of 16 bits, at one corner each. */
TEST(known_normals)
{
    static const char field[] = "P2\n4 3\n255\n0 50 100 150\n10 80 200 30\n"
                                "255 5 60 120\n";
    static const double known[3][2][3] = {
        { { 0, 0, 0 }, { .837165764, .000000003, .546949252 } },
        { { 1 / 3., 0, 0 }, { .326787748, .685828354, -.650268588 } },
        { { 1 / 3., 0, .5 }, { -.823625467, .558197278, -.100284039 } },
    };
    size_t found = 0;
    field_keep(field, strlen(field));
    SCOPED(scene) *scene = field_expect("pgm", "smooth");
    for (size_t k = 0; k < 3 * triangles_of(scene)->count; k++) {
        const struct triangle *triangle = &triangles_of(scene)->list[k / 3];
        for (int i = 0; i < 3; i++) {
            const double *corner = triangle->corners[k % 3];
            if (fabs(corner[0] - known[i][0][0]) > 1e-9
                || fabs(corner[2] - known[i][0][2]) > 1e-9)
                continue;
            for (int j = 0; j < 3; j++)
                assert_close(triangle->normals[k % 3][j], known[i][1][j], 1e-8);
            found++;
        }
    }
    assert_int_equal(found, 1 + 3 + 6);
}

/* ---- Functions ----------------------------------------------------------- */

/* Heights that POV-Ray computes. The y of the function decreases as z increases. */
TEST(functions)
{
    static const char slanted[] = "height_field { function 5, 3 { x*.5 + y*.25 } }";
    static const struct {
        const char *text;
        double x, z, height;
    } rows[] = {
        { slanted, 1e-9, 1e-9, 16383 },
        { slanted, 1 - 1e-9, 1e-9, 49151 },
        { slanted, .5 - 1e-9, .5 - 1e-9, 24575 },
        { slanted, 1 - 1e-9, 1 - 1e-9, 32767 },
        { "height_field { function 3, 3 { z + .123456 } }", .3, .3, 8090 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_scene(rows[i].text);
        double met = -1;
        assert_int_equal(field_meet(triangles_of(scene), rows[i].x, rows[i].z, &met),
                         1);
        assert_close(met, rows[i].height / 65536, 1e-8);
    }
    scene_free(read_with("height_field { function 3, 3 { 3*x - 1 } }", 1));
    SCOPED(scene) *below_water =
        read_with("height_field { function 3, 3 { x } water_level 1 }", 1);
    assert_int_equal(below_water->primitive_count, 0);
}

/* ---- Solids -------------------------------------------------------------- */

static bool is_edge(const struct triangles *triangles, size_t i, const double *from,
                    const double *to)
{
    const double *a = triangles->list[i / 3].corners[i % 3];
    const double *b = triangles->list[i / 3].corners[(i + 1) % 3];
    return a[0] == from[0] && a[1] == from[1] && a[2] == from[2] && b[0] == to[0]
           && b[1] == to[1] && b[2] == to[2];
}

/* Fails unless each edge belongs to an even number of triangles. */
static void assert_is_closed(const struct triangles *triangles)
{
    for (size_t i = 0; i < 3 * triangles->count; i++) {
        const double *from = triangles->list[i / 3].corners[i % 3];
        const double *to = triangles->list[i / 3].corners[(i + 1) % 3];
        size_t same = 0;
        for (size_t k = 0; k < 3 * triangles->count; k++)
            same += is_edge(triangles, k, from, to) || is_edge(triangles, k, to, from);
        assert_true(same % 2 == 0);
    }
}

/* A solid field fills its square below the slope or water to any depth. */
TEST(bodies)
{
    SCOPED(scene) *scene = read_scene(
        "difference { height_field { function 5, 4 { .2 + .5*x } water_level .35 } "
        "height_field { function 3, 3 { .2 + .5*x } smooth rotate 90*x } box { 0, 1 } }"
        "height_field { function 3, 3 { x } pigment { rgbt 1 } }");
    const struct primitive *p = scene->primitives;
    uint64_t random = 5;
    assert_int_equal(p[0].shape.mesh.triangles.count, 21);
    assert_false(shape_is_surface(&p[0]));
    assert_is_closed(&p[0].shape.mesh.body);
    assert_is_closed(&p[1].shape.mesh.body);
    assert_int_equal(p[3].shape.mesh.body.count, 0);
    for (int i = 0; i < 500; i++) {
        double x = xorshift_real(&random, -.3, 1.3);
        double y = xorshift_real(&random, i % 2 ? -99 : .1, 1);
        double z = xorshift_real(&random, -.3, 1.3);
        bool inside = x > 0 && x < 1 && z > 0 && z < 1;
        double top = fmax(.2 + .5 * x, .35);
        if (fabs(y - top) < 1e-4)
            continue;
        assert_int_equal(plain_encloses(&p[0], (double[]){ x, y, z }),
                         inside && y < top);
        top = .2 + .5 * x;
        if (fabs(y - top) > 1e-4)
            assert_int_equal(plain_encloses(&p[1], (double[]){ x, -z, y }),
                             inside && y < top);
    }
}

/* Reading a field costs at least 16 bytes for each cell. */
TEST(cost)
{
    enum { SIDE = 40 };
    char field[20 + SIDE * SIDE] = "P5 40 40 255\n";
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene_options options = with_images;
    options.reading_most = 16 * (SIDE - 1) * (SIDE - 1);
    field_keep(field, strlen(field) + SIDE * SIDE);
    assert_null(field_read("pgm", "", &options, &reports));
    assert_non_null(strstr(reports.items->message, "too long to read"));
}

TEST(errors)
{
    static const struct line_error errors[] = {
        { "height_field { pgm \"nowhere.pgm\" }", 20, "no such file" },
        { "height_field { pot \"a.pot\" }", 16, "'pot' are not supported" },
        { "height_field { 3 }", 16, "expected the kind of an image" },
        { "height_field { png 3 }", 20, "expected the name of an image" },
        { "height_field { function 1, 5 { x } }", 25, "two rows of two" },
        { "height_field { function 3, 1.9 { x } }", 25, "two rows of two" },
        { "height_field { function 3000, 3000 { x } }", 25,
          "more than 4000000 triangles" },
        { "height_field { function 3, 3 { 1/x } }", 30, "" },
        { "height_field { function 3, 3 { x*99999 } }", 30,
          "the function has the value" },
        { "height_field { function 3, 3 { pattern { agate } } }", 30,
          "'pattern' is not supported" },
        { "height_field { function 3, 3 { x } smooth on }", 43, "expected" },
        { "height_field { function 3, 3 { x } pigment { rgb 1 } smooth }", 54,
          "expected" },
    };
    for (size_t i = 0; i < COUNT(errors); i++) {
        assert_refused(errors[i].text, 2, errors[i].message);
        if (!strstr(errors[i].text, "99999"))
            assert_errors(&errors[i], 1);
    }
}

COUNT_AND_SEED(field_count, random_state);
