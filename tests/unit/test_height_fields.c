/* height_field: the triangles that it becomes, against the surface that
 * POV-Ray's documentation describes, asked for one point at a time; heights of
 * files of all kinds, which POV-Ray 3.7 told of the same bytes; what is no
 * height_field.
 *
 *     test_height_fields [FIELDS [SEED]]
 */
#include "rt/shapes/primitive.h"
#include "rt/shapes/shape.h"
#include "tests/oracle/plain_shapes.h"
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

#include <stdio.h>
#include <unistd.h>

enum { GRID_MOST = 9, SAMPLES = 100 };

static size_t field_count = 200;
static uint64_t random_state = RANDOM_SEED;

static double between(double low, double high)
{
    return xorshift_real(&random_state, low, high);
}

/* ---- Files --------------------------------------------------------------- */

static char path[64];

static void keep(const char *bytes, size_t count)
{
    write_bytes(path, bytes, count);
}

static struct scene *read_field(const char *words, const char *modifiers,
                                const struct scene_options *how,
                                struct diagnostics *reports)
{
    char text[1000];

    snprintf(text, sizeof text, "height_field { %s \"%s\" %s }", words, path,
             modifiers);
    return scene_read_text("test.pov", text, how, reports);
}

static struct scene *expect_field(const char *words, const char *modifiers)
{
    struct diagnostics reports = { 0 };
    struct scene *scene = read_field(words, modifiers, &with_images,
                                     &reports);

    diagnostics_print(&reports, stderr);
    assert_non_null(scene);
    assert_int_equal(reports.count, 0);
    diagnostics_free(&reports);
    return scene;
}

static void expect_fault(const char *words, const char *modifiers,
                         size_t column, const char *message)
{
    struct diagnostics reports = { 0 };
    struct scene *scene = read_field(words, modifiers, &with_images,
                                     &reports);

    if (scene || reports.count != 1 || reports.items->column != column
        || !strstr(reports.items->message, message)) {
        diagnostics_print(&reports, stderr);
        fail_msg("not '%s' at %zu", message, column);
    }
    diagnostics_free(&reports);
}

/* ---- The surface --------------------------------------------------------- */

struct grid {
    int columns, rows;
    int heights[GRID_MOST][GRID_MOST]; /* [z][x] */
};

static struct grid random_grid(void)
{
    struct grid grid = { .columns = (int)between(2, GRID_MOST + 1),
                         .rows = (int)between(2, GRID_MOST + 1) };

    for (int z = 0; z < grid.rows; z++)
        for (int x = 0; x < grid.columns; x++)
            grid.heights[z][x] = (int)between(0, 65536);
    return grid;
}

/* As text: the highest z first. */
static void keep_grid(const struct grid *grid)
{
    char text[2000];
    int end = sprintf(text, "P2\n# by chance\n%d %d 65535", grid->columns,
                      grid->rows);

    for (int z = grid->rows - 1; z >= 0; z--)
        for (int x = 0; x < grid->columns; x++)
            end += sprintf(text + end, "\n%d", grid->heights[z][x]);
    keep(text, (size_t)end);
}

static double height_of(const struct grid *grid, int x, int z)
{
    return grid->heights[z][x] / 65536.;
}

/* Where a line along y meets the field; 0 .. 1. */
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

/* The shares of a triangle's corners at a point of the x-z plane; false: it is
 * outside. */
static bool find_shares(const struct triangle *triangle, double x, double z,
                        double shares[3])
{
    const double(*at)[3] = triangle->corners;
    double area = (at[1][0] - at[0][0]) * (at[2][2] - at[0][2])
                  - (at[2][0] - at[0][0]) * (at[1][2] - at[0][2]);

    for (int k = 0; k < 3; k++) {
        const double *a = at[(k + 1) % 3], *b = at[(k + 2) % 3];
        shares[k] = ((a[0] - x) * (b[2] - z) - (b[0] - x) * (a[2] - z))
                    / area;
    }
    return shares[0] > 0 && shares[1] > 0 && shares[2] > 0;
}

/* How many triangles a line along y meets; the height is that of the last. */
static int meet(const struct triangles *triangles, double x, double z,
                double *height)
{
    int count = 0;

    for (size_t i = 0; i < triangles->count; i++) {
        double shares[3];
        if (!find_shares(&triangles->list[i], x, z, shares))
            continue;
        *height = 0;
        for (int k = 0; k < 3; k++)
            *height += shares[k] * triangles->list[i].corners[k][1];
        count++;
    }
    return count;
}

static void check_surface(const struct grid *grid,
                          const struct triangles *triangles, double water)
{
    for (int i = 0; i < SAMPLES; i++) {
        double x = between(0, 1), z = between(0, 1), met = -1;
        double expected = surface(grid, x, z);
        int count = meet(triangles, x, z, &met);
        if (fabs(expected - water) < 1e-6)
            continue;
        assert_int_equal(count, expected > water);
        if (count)
            assert_close(met, expected, CLOSE);
    }
}

static void test_surface(void **state)
{
    (void)state;
    for (size_t i = 0; i < field_count; i++) {
        struct grid grid = random_grid();
        double water = i % 3 ? between(-.2, .8) : 0;
        char words[50];
        struct scene *scene;

        keep_grid(&grid);
        snprintf(words, sizeof words, "water_level %.9f", water);
        if (water > surface(&grid, .5, .5))
            continue; /* perhaps nothing is left */
        scene = expect_field(i % 2 ? "pgm" : "", water == 0 ? "" : words);
        check_surface(&grid, triangles_of(scene), water);
        scene_free(scene);
    }
}

/* ---- Normals ------------------------------------------------------------- */

static double slope(const struct grid *grid, int x, int z, int to_x, int to_z)
{
    return grid->heights[to_z][to_x] - grid->heights[z][x];
}

/* The sum of those of the triangles towards each two neighbours, a cell as wide
 * as a height is high; in whole parts of 32767. */
static void normal_at(const struct grid *grid, int x, int z, double normal[3])
{
    double sum[3] = { 0, 0, 0 }, length;

    for (int corner = 0; corner < 4; corner++) {
        int to_x = x + (corner & 1 ? 1 : -1),
            to_z = z + (corner & 2 ? 1 : -1);
        double along, up;
        if (to_x < 0 || to_x >= grid->columns || to_z < 0
            || to_z >= grid->rows)
            continue;
        along = (to_x - x) * slope(grid, x, z, to_x, z);
        up = (to_z - z) * slope(grid, x, z, x, to_z);
        length = sqrt(along * along + up * up + 1);
        sum[0] -= along / length;
        sum[1] += 1 / length;
        sum[2] -= up / length;
    }
    length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (int i = 0; i < 3; i++)
        normal[i] = trunc(sum[i] / length * 32767);
    normal[0] *= grid->columns - 1;
    normal[1] *= 65536;
    normal[2] *= grid->rows - 1;
}

static void make_unit(double normal[3])
{
    double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1]
                         + normal[2] * normal[2]);

    for (int i = 0; i < 3; i++)
        normal[i] /= length;
}

static void check_corner(const struct grid *grid, const double corner[3],
                         const double normal[3], double wide, double high)
{
    int x = (int)lround(corner[0] / wide * (grid->columns - 1));
    int z = (int)lround(corner[2] * (grid->rows - 1));
    double expected[3];

    normal_at(grid, x, z, expected);
    expected[0] /= wide;
    expected[1] /= high;
    make_unit(expected);
    for (int i = 0; i < 3; i++)
        assert_close(normal[i], expected[i], 1e-4); /* borders of steps */
    assert_close(corner[1], high * height_of(grid, x, z), 1e-9);
}

/* In the world they have the length one. */
static void test_normals(void **state)
{
    (void)state;
    for (size_t i = 0; i < field_count; i++) {
        struct grid grid = random_grid();
        double wide = between(.5, 2), high = between(1, 4000);
        const struct triangles *triangles;
        struct scene *scene;
        char words[80];

        keep_grid(&grid);
        snprintf(words, sizeof words, "smooth scale <%.17g, %.17g, 1>", wide,
                 high);
        scene = expect_field("", words);
        triangles = triangles_of(scene);
        assert_int_equal(triangles->count,
                         2 * (grid.columns - 1) * (grid.rows - 1));
        for (size_t k = 0; k < 3 * triangles->count; k++) {
            const struct triangle *triangle = &triangles->list[k / 3];
            assert_true(triangle->smooth);
            check_corner(&grid, triangle->corners[k % 3],
                         triangle->normals[k % 3], wide, high);
        }
        scene_free(scene);
    }
}

/* What POV-Ray's trace() told: of a field of 16 bits, one corner each. */
static void test_known_normals(void **state)
{
    static const char field[] = "P2\n4 3\n255\n0 50 100 150\n10 80 200 30\n"
                                "255 5 60 120\n";
    static const double known[3][2][3] = {
        { { 0, 0, 0 }, { .837165764, .000000003, .546949252 } },
        { { 1 / 3., 0, 0 }, { .326787748, .685828354, -.650268588 } },
        { { 1 / 3., 0, .5 }, { -.823625467, .558197278, -.100284039 } },
    };
    struct scene *scene;
    size_t found = 0;

    (void)state;
    keep(field, strlen(field));
    scene = expect_field("pgm", "smooth");
    for (size_t k = 0; k < 3 * triangles_of(scene)->count; k++) {
        const struct triangle *triangle = &triangles_of(scene)->list[k / 3];
        for (int i = 0; i < 3; i++) {
            const double *corner = triangle->corners[k % 3];
            if (fabs(corner[0] - known[i][0][0]) > 1e-9
                || fabs(corner[2] - known[i][0][2]) > 1e-9)
                continue;
            for (int j = 0; j < 3; j++)
                assert_close(triangle->normals[k % 3][j], known[i][1][j],
                             1e-8);
            found++;
        }
    }
    assert_int_equal(found, 1 + 3 + 6);
    scene_free(scene);
}

/* ---- Kinds of files ------------------------------------------------------ */

struct known_file {
    const char *word;
    const char *bytes;
    size_t count;
    int heights[6]; /* of an image of 3 x 2: the upper row, the lower one */
};
#define FILE_OF(word, bytes) word, bytes, sizeof bytes - 1

/* In all of them the grey ones have 0, 50, 100, 150, 200, 250; the coloured
 * ones the six colours of COLORS. */
#define GREYS "\x00\x32\x64\x96\xc8\xfa"
#define COLORS \
    "\xff\x00\x00\x00\xff\x00\x00\x00\xff\x0a\x14\x1e\xc8\x64\x32\xff\xff\xff"
#define BGRS \
    "\x00\x00\xff\x00\xff\x00\xff\x00\x00\x1e\x14\x0a\x32\x64\xc8\xff\xff\xff"

static const struct known_file known_files[] = {
    { FILE_OF("pgm", "P5\n3 2\n255\n" GREYS),
      { 0, 12850, 25700, 38550, 51400, 64250 } },
    { FILE_OF("pgm", "P2\n3 2\n100\n0 10 33 50 77 100\n"),
      { 0, 6553, 21626, 32767, 50461, 65535 } },
    { FILE_OF("pgm", "P2\n3 2\n1000\n0 10 333 500 777 1000"),
      { 0, 655, 21823, 32767, 50920, 65535 } },
    { FILE_OF("pgm", "P5 3 2 65535\n\0\0\x27\x10\x4e\x20\x75\x30\x9c\x40"
                     "\xc3\x50"),
      { 0, 10000, 20000, 30000, 40000, 50000 } },
    { FILE_OF("ppm", "P6\n3 2\n255\n" COLORS),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    { FILE_OF("ppm",
              "P3\n3 2\n100\n0 10 33 50 77 100 100 0 0 0 100 0 0 0 100 "
              "99 98 97\n"),
      { 25, 32836, 65280, 255, 0, 64877 } },
    { FILE_OF("ppm",
              "P3\n3 2\n65535\n65535 0 0 0 65535 0 0 0 65535 2570 5140 "
              "7710 51400 25700 12850 65535 65535 65535"),
      { 19463, 38600, 7470, 4669, 31868, 65534 } },
    { FILE_OF("tga", "\0\0\x02\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x18\x20" BGRS),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    { FILE_OF("tga", "\0\0\x02\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x18\0" BGRS),
      { 2580, 51300, 65535, 65280, 255, 0 } },
    { FILE_OF("tga", "\0\0\x02\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x10\x20\0\x7c"
                     "\xe0\x03\x1f\0\x43\x04\x86\x65\xff\x7f"),
      { 63488, 248, 0, 2064, 51296, 63736 } },
    { FILE_OF("tga", "\0\0\x03\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x08\x20" GREYS),
      { 0, 12850, 25700, 38550, 51400, 64250 } },
    { FILE_OF("tga",
              "\0\x01\x01\0\0\x06\0\x18\0\0\0\0\x03\0\x02\0\x08\x20" BGRS
              "\0\x01\x02\x03\x04\x05"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { FILE_OF("gif",
              "GIF89a\x03\0\x02\0\xf2\0\0" COLORS "\x01\x02\x03\x04\x05"
              "\x06,\0\0\0\0\x03\0\x02\0\0\x03\x05\x08\x21\x38\x54\x09"
              "\0;"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { FILE_OF("png",
              "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00"
              "\x03\x00\x00\x00\x02\x08\x00\x00\x00\x00\xb8\x1f\x39"
              "\xc6\x00\x00\x00\x13IDATx\x01\x01\x08\x00\xf7\xff\x00"
              "\x00\x32\x64\x00\x96\xc8\xfa\x07t\x02\xef\x03\x12^\x0b\x00"
              "\x00\x00\x00IEND\xae\x42`\x82"),
      { 0, 12593, 25443, 38293, 51143, 64250 } },
    { FILE_OF("png", "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00"
                     "\x03\x00\x00\x00\x02\x10\x00\x00\x00\x00\xe8\x8f\xe5"
                     "\x85\x00\x00\x00\x19IDATx\x01\x01\x0e\x00\xf1\xff\x00"
                     "\x00\x00'\x10N \x00u0\x9c@\xc3P\x0e\xcd\x03:\x8e\xf5Y"
                     "\xa5\x00\x00\x00\x00IEND\xae\x42`\x82"),
      { 0, 10000, 20000, 30000, 40000, 50000 } },
    { FILE_OF("png",
              "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00"
              "\x03\x00\x00\x00\x02\x08\x02\x00\x00\x00\x12\x16\xf1M"
              "\x00\x00\x00\x1fIDATx\x01\x01\x14\x00\xeb\xff\x00\xff"
              "\x00\x00\x00\xff\x00\x00\x00\xff\x00\x0a\x14\x1e\xc8"
              "\x64\x32\xff\xff\xff<\x19\x07\x95\x1b\xa7\xeb\xb9\x00\x00"
              "\x00\x00IEND\xae\x42`\x82"),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    { FILE_OF("png", "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00"
                     "\x03\x00\x00\x00\x02\x08\x06\x00\x00\x00\x9dtf\x1a\x00"
                     "\x00\x00%IDATx\x01\x01\x1a\x00\xe5\xff\x00\xff\x00\x00"
                     "\x80\x00\xff\x00\x80\x00\x00\xff\x80\x00\x0a\x14\x1e"
                     "\xff\xc8\x64\x32\xff\xff\xff\xff\xff{n\x0c\x12\x97M\xe1"
                     "\xd7\x00\x00\x00\x00IEND\xae\x42`\x82"),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    { FILE_OF("png", "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00"
                     "\x03\x00\x00\x00\x02\x08\x03\x00\x00\x00\xaa\xaa\x96("
                     "\x00\x00\x00\x12PLTE\xff\x00\x00\x00\xff\x00\x00\x00"
                     "\xff\x0a\x14\x1e\xc8\x64\x32\xff\xff\xff>3\xf9\xf6\x00"
                     "\x00\x00\x13IDATx\x01\x01\x08\x00\xf7\xff\x00\x00\x01"
                     "\x02\x00\x03\x04\x05\x00.\x00\x10]\xd9\xc1\x16\x00\x00"
                     "\x00\x00IEND\xae\x42`\x82"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { FILE_OF("png", "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00"
                     "\x03\x00\x00\x00\x02\x04\x03\x00\x00\x00oZ{)\x00\x00"
                     "\x00\x12PLTE\xff\x00\x00\x00\xff\x00\x00\x00\xff\x0a"
                     "\x14\x1e\xc8\x64\x32\xff\xff\xff>3\xf9\xf6\x00\x00\x00"
                     "\x11IDATx\x01\x01\x06\x00\xf9\xff\x00\x01 \x00\x34P\x01"
                     "\x43\x00\xa6\x63~\xb7\x9a\x00\x00\x00\x00IEND\xae\x42`"
                     "\x82"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { FILE_OF("bmp",
              "BM\x4e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x03\0\0\0\x02\0\0"
              "\0\x01\0\x18\0\0\0\0\0\x18\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
              "\0\0\0\0\x1e\x14\x0a\x32\x64\xc8\xff\xff\xff\0\0\0"
              "\0\0\xff\0\xff\0\xff\0\0\0\0\0"),
      { 65280, 255, 0, 2580, 51300, 65535 } },
};

static void check_file(const struct known_file *file)
{
    struct scene *scene;

    keep(file->bytes, file->count);
    scene = expect_field(file->word, "");
    for (int i = 0; i < 6; i++) {
        double x = i % 3 / 2., z = i < 3;
        double height = -1, x_in = x + (x < .5 ? 1 : -1) * 1e-9;
        if (!meet(triangles_of(scene), x_in, z + (i < 3 ? -1 : 1) * 1e-9,
                  &height))
            fail_msg("%s %d: nothing is met", file->word, i);
        if (fabs(height * 65536 - file->heights[i]) > .01)
            fail_msg("%s %d: %.3f, not %d", file->word, i, height * 65536,
                     file->heights[i]);
    }
    scene_free(scene);
}

static void test_kinds(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(known_files); i++)
        check_file(&known_files[i]);
}

/* Each colour of the table is in it twice; the second table is the image's. */
static void test_tables(void **state)
{
    static const struct known_file own_table = {
        FILE_OF("gif",
                "GIF89a\x03\0\x02\0\x72\0\0!\xfe\x02yo\0,\0\0\0\0\x03\0"
                "\x02\0\x82"
                "aaaaaabbbbbbccccccdddddd"
                "\x03\x05\x08\x21\x38\x54\x09\0;"),
        { 0, 256, 512, 768, 1024, 1280 }
    };

    (void)state;
    check_file(&own_table);
}

/* A file without its end.  Of a broken PNG file the library forgets to free what it
 * has read so far, which a leak checker would take for ours. */
static void test_broken(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(known_files); i++)
        for (size_t k = 0; k < 8 && strcmp(known_files[i].word, "png"); k++) {
            const struct known_file *file = &known_files[i];
            struct diagnostics reports = { 0 };
            struct scene *scene;
            keep(file->bytes, file->count * k / 8);
            scene = read_field(file->word, "", &with_images, &reports);
            assert_true(scene || reports.errors == 1);
            scene_free(scene);
            diagnostics_free(&reports);
        }
}

/* ---- Functions ----------------------------------------------------------- */

static void expect_height(const char *text, double x, double z, double height)
{
    struct scene *scene = read_scene(text);
    double met = -1;

    assert_int_equal(meet(triangles_of(scene), x, z, &met), 1);
    assert_close(met, height / 65536, 1e-8);
    scene_free(scene);
}

/* As POV-Ray has them; y goes down as z goes up. */
static void test_functions(void **state)
{
    static const char slanted[] = "height_field { function 5, 3 "
                                  "{ x*.5 + y*.25 } }";

    (void)state;
    expect_height(slanted, 1e-9, 1e-9, 16383);
    expect_height(slanted, 1 - 1e-9, 1e-9, 49151);
    expect_height(slanted, .5 - 1e-9, .5 - 1e-9, 24575);
    expect_height(slanted, 1 - 1e-9, 1 - 1e-9, 32767);
    expect_height("height_field { function 3, 3 { z + .123456 } }", .3, .3,
                  8090);
    scene_free(read_with("height_field { function 3, 3 { 3*x - 1 } }", 1));
}

static void test_below_water(void **state)
{
    struct scene *scene =
        read_with("height_field { function 3, 3 { x } water_level 1 }", 1);

    (void)state;
    assert_int_equal(scene->primitive_count, 0);
    scene_free(scene);
}

/* ---- What is none -------------------------------------------------------- */

static void expect_file_fault(const char *word, const char *bytes,
                              const char *message)
{
    keep(bytes, strlen(bytes));
    expect_fault(word, "", 17 + strlen(word), message);
}

static void test_faulty_files(void **state)
{
    (void)state;
    expect_file_fault("pgm", "", "empty");
    expect_file_fault("", "P2 3 1 255 1 2 3", "two rows of two heights");
    expect_file_fault("", "P2 1 3 255 1 2 3", "two rows of two heights");
    expect_file_fault("", "P2 2 2 255 1 2 3", "only 3 of its 4 samples");
    expect_file_fault("", "P5 2 2 255 123", "only 3 of its 4 samples");
    expect_file_fault("", "P2 2 2 255 1 2 3 256", "a sample is 256");
    expect_file_fault("", "P2 2 2 65536 1 2 3 4", "from 1 to 65535");
    expect_file_fault("", "P2 2 2 0 0 0 0 0", "from 1 to 65535");
    expect_file_fault("", "P2 0 2 255", "no pixels");
    expect_file_fault("", "P2 x", "first numbers are wrong");
    expect_file_fault("", "P2 9999 9999 255", "more than 8388608 pixels");
    expect_file_fault("pgm", "P3 2 2 1 1 1 1", "the file is not 'pgm'");
    expect_file_fault("png", "what is this", "the file is not 'png'");
    expect_file_fault("tga", "what is this", "cannot be read");
    expect_file_fault("gif", "GIF89a", "table of colours is broken");
}

static void test_large_file(void **state)
{
    enum { SIDE = 1500 };
    char *bytes = calloc(1, SIDE * SIDE + 100);
    int head;

    (void)state;
    assert_non_null(bytes);
    head = sprintf(bytes, "P5 %d %d 255\n", SIDE, SIDE);
    keep(bytes, (size_t)head + SIDE * SIDE);
    expect_fault("pgm", "", 20, "more than 4000000 triangles");
    free(bytes);
}

/* --- what lies below ------------------------------------------------------ */

static int compare_ends(const void *a, const void *b)
{
    const double *one = a, *other = b;

    for (int i = 0; i < 6; i++)
        if (one[i] != other[i])
            return one[i] < other[i] ? -1 : 1;
    return 0;
}

/* Each edge belongs to an even number of triangles. */
static void assert_is_closed(const struct triangles *triangles)
{
    size_t count = 3 * triangles->count, same;
    double(*edges)[6] = malloc(count * sizeof *edges);

    assert_non_null(edges);
    for (size_t i = 0; i < count; i++) {
        const struct triangle *triangle = &triangles->list[i / 3];
        double there[6], back[6];
        memcpy(there, triangle->corners[i % 3], sizeof there / 2);
        memcpy(there + 3, triangle->corners[(i + 1) % 3], sizeof there / 2);
        memcpy(back, there + 3, sizeof back / 2);
        memcpy(back + 3, there, sizeof back / 2);
        memcpy(edges[i], compare_ends(there, back) < 0 ? there : back,
               sizeof there);
    }
    qsort(edges, count, sizeof *edges, compare_ends);
    for (size_t i = 0; i < count; i += same) {
        for (same = 1; i + same < count; same++)
            if (compare_ends(edges[i], edges[i + same]) != 0)
                break;
        assert_true(same % 2 == 0);
    }
    free(edges);
}

/* In its square, below a slope or the water, however deep. */
static void test_bodies(void **state)
{
    struct scene *scene = read_scene(
        "difference { height_field { function 5, 4 { .2 + .5*x } water_level "
        ".35 } height_field { function 3, 3 { .2 + .5*x } smooth rotate 90*x "
        "} box { 0, 1 } }"
        "height_field { function 3, 3 { x } pigment { rgbt 1 } }");
    const struct primitive *p = scene->primitives;
    uint64_t random = 5;

    (void)state;
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
    scene_free(scene);
}

/* Without an adapter PGM is read, and nothing else. */
static void test_no_adapter(void **state)
{
    struct diagnostics reports = { 0 };

    (void)state;
    for (size_t i = 0; i < COUNT(known_files); i++) {
        const struct known_file *file = &known_files[i];
        bool own = *file->word == 'p' && file->word[1] != 'n';
        struct scene *scene;
        keep(file->bytes, file->count);
        scene = read_field(file->word, "", &reading_options, &reports);
        assert_int_equal(!scene, !own);
        assert_int_equal(reports.errors, !own);
        if (!own)
            assert_non_null(
                strstr(reports.items->message, "cannot be read here"));
        scene_free(scene);
        diagnostics_free(&reports);
        memset(&reports, 0, sizeof reports);
    }
}

static void test_errors(void **state)
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

    (void)state;
    for (size_t i = 0; i < COUNT(errors); i++)
        assert_refused(errors[i].text, 2, errors[i].message);
    for (size_t i = 0; i < COUNT(errors); i++)
        if (!strstr(errors[i].text, "99999"))
            assert_errors(&errors[i], 1);
}

int main(int count, char **words)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_surface),
        cmocka_unit_test(test_normals),
        cmocka_unit_test(test_known_normals),
        cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_tables),
        cmocka_unit_test(test_broken),
        cmocka_unit_test(test_functions),
        cmocka_unit_test(test_below_water),
        cmocka_unit_test(test_bodies),
        cmocka_unit_test(test_faulty_files),
        cmocka_unit_test(test_large_file),
        cmocka_unit_test(test_no_adapter),
        cmocka_unit_test(test_errors),
    };
    int result;

    if (count > 1)
        field_count = strtoul(words[1], NULL, 10);
    if (count > 2)
        random_state = strtoull(words[2], NULL, 10);
    snprintf(path, sizeof path, "/tmp/rt205-heights-%ld", (long)getpid());
    result = cmocka_run_group_tests(tests, NULL, NULL);
    remove(path);
    return result;
}
