/* test_mass.c - volumes, areas, centroids and inertia of solids, computed from columns,
 * are compared with the formulas of massprops.csv. A chord that is lost, or a moment
 * about another axis, fails here.
 *
 * MASS_RAYS, a power of two, is the total number of rays of a view. With 2^18 rays the
 * errors are at most 1e-4 of a figure.
 */
#include "base/file.h"
#include "tests/oracle/many_scenes.h"
#include "tests/oracle/machine_mass.h"
#include "tests/random.h"
#include "tests/unit/csv_reading.h"

#include <math.h>

#define STUDENT 2.1314 /* Student's t for 15 degrees of freedom */

static struct columns_options usual(size_t rays_log)
{
    return (struct columns_options){ .mode = TRACE_VECTOR,
                                     .queue = 2000,
                                     .points = POINTS_LATTICE,
                                     .rays_log = rays_log,
                                     .repeats = 16,
                                     .seed = 1,
                                     .jobs = 2 };
}

static struct measured measured_of(const char *text, struct columns_options options)
{
    struct measured measured;
    FAIL_IF(!measure_scene(text, options, &measured), "%s: %s", text,
            measured.error.message);
    return measured;
}

static uint64_t checksum_of(const char *text, struct columns_options options)
{
    return measured_of(text, options).checksum;
}

/* ---- Solids that have formulas ------------------------------------------- */

static double named(const struct csv_table *table, size_t row, const char *name)
{
    for (size_t i = 0; i < table->cells[0]; i++)
        if (strcmp(table->cell[0][i], name) == 0)
            return strtod(table->cell[row][i], NULL);
    fail_msg("no column is called %s", name);
    return 0;
}

/* Fails unless the difference is within four standard errors plus a fraction. */
static void check_figure(const char *solid, const struct mass_figures *found,
                         size_t figure, double expected, double scale, double share)
{
    double off = fabs(found->value[figure] - expected);
    double most = 4 * found->error[figure] / STUDENT + 1e-9 * scale;
    FAIL_IF(off > most || off > share * scale,
            "%s: %s is %.12g, not %.12g: %.2g of the scale, %.1f standard errors",
            solid, figure_name(figure), found->value[figure], expected, off / scale,
            4 * off / most);
}

static void check_row(const struct csv_table *table, size_t row, size_t rays_log,
                      double share)
{
    static const char *const moments[] = { "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz" };
    static const char *const places[] = { "cx", "cy", "cz" };
    const char *id = table->cell[row][0];
    struct measured measured = measured_of(table->cell[row][2], usual(rays_log));
    const struct mass_figures *found = &measured.part[0];
    double volume = named(table, row, "volume"), most = 0;
    check_figure(id, found, FIGURE_VOLUME, volume, volume, share);
    check_figure(id, found, FIGURE_AREA, named(table, row, "area"),
                 named(table, row, "area"), share);
    for (size_t i = 0; i < 3; i++) {
        check_figure(id, found, FIGURE_CENTROID + i, named(table, row, places[i]),
                     cbrt(volume), share);
        most = fmax(most, named(table, row, moments[i]));
    }
    for (size_t i = 0; i < 6; i++)
        check_figure(id, found, FIGURE_CENTRAL + i, named(table, row, moments[i]), most,
                     share);
}

TEST(formulas)
{
    const char *asked = getenv("MASS_RAYS");
    double rays = asked ? strtod(asked, NULL) : 1 << 15;
    size_t rays_log = (size_t)lround(log2(rays / 16));
    FREED struct csv_table *table = NON_NULL(calloc(1, sizeof *table));
    size_t length;
    FREED char *text = NON_NULL(
        file_read("tests/unit/massprops.csv", 1 << 20, &length, &failure));
    csv_table(text, table);
    assert_true(table->rows > 5);
    for (size_t row = 1; row < table->rows; row++)
        check_row(table, row, rays_log, rays >= 1 << 18 ? 1e-4 : 1e-3);
}

/* ---- Equal results of all methods ---------------------------------------- */

/* Four objects that overlap: a union, a difference, a cylinder and a sphere. */
static const char crowd[] = "union { sphere { 0, 1 } box { -.6, <1.5, .6, .7> } }\n"
                            "difference { torus { 1.2, .4 } plane { x, .2 } }\n"
                            "cylinder { <-1, 0, .3>, <1, 1, .3>, .5 }\n"
                            "sphere { <.5, .2, 0>, .8 }\n";

TEST(same_bits)
{
    for (int points = 0; points < POINTS_KINDS; points++) {
        struct columns_options options = usual(points == POINTS_GRID ? 7 : 6);
        options.points = (enum columns_points)points;
        options.repeats = 4;
        uint64_t expected = checksum_of(crowd, options);
        options.jobs = 3;
        options.queue = 7;
        assert_true(checksum_of(crowd, options) == expected);
        options.mode = TRACE_KERNELS;
        assert_true(checksum_of(crowd, options) == expected);
        options.mode = TRACE_SCALAR;
        assert_true(checksum_of(crowd, options) == expected);
        options.seed = 2;
        assert_false(checksum_of(crowd, options) == expected);
    }
}

/* There are more rays than a packet holds, and more crossings than lanes. */
TEST(same_packets)
{
    struct columns_options options = usual(13);
    options.repeats = 2;
    uint64_t expected = checksum_of(crowd, options);
    options.queue = 4096;
    options.jobs = 1;
    assert_true(checksum_of(crowd, options) == expected);
    options.mode = TRACE_SCALAR;
    options.jobs = 2;
    assert_true(checksum_of(crowd, options) == expected);
    options.mode = TRACE_VECTOR;
    struct measured ball = measured_of("sphere { 0, 1 }", options);
    assert_true(fabs(ball.part[0].value[FIGURE_VOLUME] - 4 * acos(-1) / 3) < 1e-3);
}

/* ---- Points -------------------------------------------------------------- */

/* A solid that is not aligned to any axis. Its volume is 1.2^3 20/27. */
static const char tilted[] =
    "difference { box { -.5, .5 } box { <-1,-1/6,-1/6>, <1,1/6,1/6> }\n"
    "box { <-1/6,-1,-1/6>, <1/6,1,1/6> } box { <-1/6,-1/6,-1>, <1/6,1/6,1> }\n"
    "rotate <20, 30, 50> scale 1.2 translate <3, -2, 1> }\n";

struct tried {
    double square, sum, covered;
};

static struct tried try_seeds(enum columns_points points, size_t seeds)
{
    static const double volume = 1.2 * 1.2 * 1.2 * 20 / 27;
    struct tried tried = { 0 };
    for (size_t seed = 1; seed <= seeds; seed++) {
        struct columns_options options = usual(6);
        options.points = points;
        options.seed = seed;
        struct measured measured = measured_of(tilted, options);
        double off = measured.part[0].value[FIGURE_VOLUME] - volume;
        tried.sum += off;
        tried.square += off * off;
        tried.covered += fabs(off) <= measured.part[0].error[FIGURE_VOLUME];
    }
    return tried;
}

/* Estimates have no bias, intervals have the stated probability, and a lattice has a
 * smaller error than random points. */
TEST(points)
{
    enum { SEEDS = 16 };
    double square[POINTS_KINDS];
    for (int points = 0; points < POINTS_KINDS; points++) {
        struct tried tried = try_seeds((enum columns_points)points, SEEDS);
        double bias = tried.sum / sqrt(tried.square);
        square[points] = tried.square;
        FAIL_IF(fabs(bias) > 4 || tried.covered < .75 * SEEDS,
                "points %d: a bias of %.1f standard errors, %.0f of %d intervals hold",
                points, bias, tried.covered, SEEDS);
    }
    assert_true(square[POINTS_LATTICE] < square[POINTS_RANDOM] / 4);
    assert_true(square[POINTS_GRID] < square[POINTS_RANDOM] / 4);
}

/* ---- Parts --------------------------------------------------------------- */

/* Two balls of radius 1, at a distance of 1, share a lens. */
TEST(overlap)
{
    double lens = 5 * acos(-1) / 12;
    struct measured two = measured_of("sphere { -.5*x, 1 }\nsphere { .5*x, 1 }",
                                      usual(11));
    assert_int_equal(two.parts, 2);
    assert_true(fabs(two.overlap - lens) < 4 * two.overlap_error / STUDENT);
    assert_true(two.overlap_error < 1e-3);
    assert_true(fabs(two.part[2].value[FIGURE_VOLUME] - two.part[0].value[FIGURE_VOLUME]
                     - two.part[1].value[FIGURE_VOLUME])
                < 1e-12);
}

/* The centroid of a distant box is at its middle, and its inertia follows the parallel
 * axis theorem. */
TEST(about)
{
    struct measured box = measured_of("box { <99,199,299>, <101,201,301> }", usual(11));
    const double *value = box.part[0].value;
    assert_true(fabs(value[FIGURE_VOLUME] - 8) < 1e-3);
    assert_true(fabs(value[FIGURE_AREA] - 24) < 3e-3);
    assert_true(fabs(value[FIGURE_CENTROID + 2] - 300) < 1e-3);
    assert_true(fabs(value[FIGURE_INERTIA] / (8 * (130000 + 2. / 3)) - 1) < 1e-4);
    assert_true(fabs(value[FIGURE_INERTIA + 3] / (-8. * 20000) - 1) < 1e-4);
    assert_true(fabs(value[FIGURE_CENTRAL] - 16. / 3) < 2e-3);
}

/* The parallel axis theorem also holds if the centroid is not the centre of the box. */
TEST(parallel_axes)
{
    struct measured bored =
        measured_of("difference { box { <-1,-.5,-.25>, <1,.5,.25> }\n"
                    "cylinder { <.4,0,-1>, <.4,0,1>, .3 } translate <3,2,1> }",
                    usual(8));
    const double *value = bored.part[0].value;
    double volume = value[FIGURE_VOLUME];
    double x = value[FIGURE_CENTROID];
    double y = value[FIGURE_CENTROID + 1];
    double z = value[FIGURE_CENTROID + 2];
    assert_true(x < 2.95);
    assert_true(
        fabs(value[FIGURE_INERTIA] - value[FIGURE_CENTRAL] - volume * (y * y + z * z))
        < 1e-9);
    assert_true(
        fabs(value[FIGURE_INERTIA + 3] - value[FIGURE_CENTRAL + 3] + volume * x * y)
        < 1e-9);
}

/* The principal axes of a rotated box are in order of increasing moments. */
TEST(axes)
{
    struct measured box = measured_of("box { <-1,-.5,-.25>, <1,.5,.25> rotate 30*z }",
                                      usual(11));
    const struct mass_figures *figures = &box.part[0];
    for (size_t i = 0; i < 3; i++) {
        static const double moments[] = { 5. / 48, 17. / 48, 5. / 12 };
        assert_true(fabs(figures->value[FIGURE_PRINCIPAL + i] - moments[i]) < 1e-3);
    }
    assert_true(figures->axes[0][0] * figures->axes[0][1] > 0);
    assert_true(fabs(fabs(figures->axes[0][0]) - cos(acos(-1) / 6)) < 1e-2);
    assert_true(fabs(fabs(figures->axes[2][2]) - 1) < 1e-3);
}

/* ---- Errors -------------------------------------------------------------- */

static void refuses(const char *text, const char *why)
{
    struct measured measured;
    assert_false(measure_scene(text, usual(8), &measured));
    assert_string_equal(measured.error.message, why);
}

TEST(refused)
{
    refuses("sphere { 0, 1 }\ndisc { <0,0,3>, z, 2 }",
            "the disc of line 2 is an open surface: it has no volume");
    refuses("sphere { 0, 1 }\nplane { y, 0 }",
            "the solid of line 2 has unknown bounds: its volume cannot be computed");
    refuses("", "the scene has no objects");
    struct measured empty =
        measured_of("intersection { sphere { 0, 1 } sphere { 3*x, 1 }\n"
                    "sphere { 0, 9 } }\nbox { 2, 3 }",
                    usual(8));
    assert_true(empty.part[0].value[FIGURE_VOLUME] == 0);
    assert_true(isnan(empty.part[0].value[FIGURE_CENTROID]));
}

TEST(too_many_parts)
{
    const struct overlaps many = { .count = MAX_COLUMNS_PAIRS + 1 };
    struct columns_options options = usual(0);
    SCOPED(scene) *scene = scene_of("sphere { 0, 1 }");
    const size_t part_of[] = { 0 };
    struct columns_sums sums;
    c205_error error;
    options.model = usual_model();
    options.part_of = part_of;
    options.repeats = 1;
    options.part_count = MAX_COLUMNS_PARTS + 1;
    assert_false(columns_sum(scene, &options, &sums, &error));
    assert_string_equal(error.message, "the scene has 4468 parts; at most 4467 are "
                                       "allowed");
    options.part_count = 1;
    options.overlaps = &many;
    assert_false(columns_sum(scene, &options, &sums, &error));
    assert_string_equal(error.message, "16385 pairs of parts may overlap; at most "
                                       "16384 are allowed");
    c205_model_free((c205_model *)options.model);
}
