/* test_plot.c - plots. The picture of a table is compared with the table, with unusual
 * names, values that are not numbers, and a converter that is missing or fails. A file
 * that is left incomplete, or a row or curve that is lost, fails here. */
#include "rt/study/sweep/plot_file.h"

#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/plot_axis.h"
#include "tests/unit/temporary_folder.h"

enum { QUEUE, STREAM, STARTUP, REMARK, COLUMNS };

static const struct table_column columns[COLUMNS] = {
    { "queue", "queue", TABLE_COUNT, 0 },
    { "stream", "stream", TABLE_NUMBER, 1 },
    { "startup", "start-up", TABLE_NUMBER, 1 },
    { "remark", "remark", TABLE_TEXT, 0 },
};

static const struct plot_curve curves[] = {
    { STREAM, "vector stream", NULL },
    { STARTUP, "vector start-up", NULL },
};

static const char *const subtitles[] = { "model cyber205-2pipe",
                                         "a_b & <c>, it's \"so\" \\" };

static const struct plot_mark marks[] = { { 3, "best 3" },
                                          { 3.5, "the paper's 3.5" },
                                          { NAN, "nowhere" } };
static const struct plot_mark levels[] = { { 12, "scalar" }, { NAN, "nothing" } };

static const struct plot lines = {
    .title = "Clocks per ray",
    .subtitles = subtitles,
    .subtitle_count = 2,
    .x = { "rays in a queue", PLOT_LOG2 },
    .y = { "clocks per ray", PLOT_LINEAR },
    .x_column = QUEUE,
    .curves = curves,
    .curve_count = 2,
    .marks = marks,
    .mark_count = 3,
    .levels = levels,
    .level_count = 2,
};

/* ---- A table for a test ----------------------------------------------- */

static struct table *table; /* table of the current test */

static void add_row(uint64_t queue, double stream, double startup)
{
    table_count(table, queue);
    table_number(table, stream);
    table_number(table, startup);
    table_text(table, "some");
}

FIXTURE(set_up)
{
    table = table_new(columns, COLUMNS);
    add_row(1, 10, 100.0 / 3);
    add_row(2, 10, 0.1);
    add_row(4, NAN, 8);
    add_row(8, INFINITY, 4);
    return 0;
}

/* A test removes the files that it made. */
FIXTURE(tear_down)
{
    table_free(table);
    return (int)empty_folder();
}

static void remove_file(const char *name)
{
    assert_int_equal(unlink(in_folder(name)), 0);
}

static bool write_plot(const struct plot *plot, const char *name, c205_error *error)
{
    return plot_write(plot, table, in_folder(name), error);
}

/* Draws a plot. Returns the picture, which the caller frees. */
static char *drawn(const struct plot *plot)
{
    char *text;
    REQUIRE(write_plot(plot, "a b'c.svg", &failure));
    text = text_of_file("a b'c.svg");
    remove_file("a b'c.svg");
    return text;
}

static void expect_error(const struct plot *plot, const char *name, const char *part)
{
    c205_error error = { "" };
    assert_false(write_plot(plot, name, &error));
    if (!strstr(error.message, part))
        fail_msg("\"%s\" without \"%s\"", error.message, part);
}

/* ---- Plots ------------------------------------------------------------ */

static void expect_picture(const char *text)
{
    static const char end[] = "</svg>\n";
    assert_ptr_equal(strstr(text, "<svg"), text);
    assert_string_equal(text + strlen(text) - strlen(end), end);
    assert_non_null(strstr(text, ">Clocks per ray<"));
    assert_non_null(strstr(text, ">a_b &amp; &lt;c&gt;, it's \"so\" \\<"));
    assert_non_null(strstr(text, ">the paper's 3.5<"));
    assert_non_null(strstr(text, ">vector start-up<"));
    assert_null(strstr(text, "nowhere"));
    assert_null(strstr(text, "nothing"));
    assert_null(strstr(text, "nan"));
    assert_null(strstr(text, "inf"));
}

/* Returns the position of the point with this tooltip. */
static void point_of(const char *text, const char *tooltip, double place[2])
{
    const char *at = strstr(text, tooltip);
    if (!at)
        fail_msg("no point %s", tooltip);
    while (strncmp(at, "<circle ", 8) != 0)
        at--;
    assert_int_equal(sscanf(at, "<circle cx=\"%lf\" cy=\"%lf\"", &place[0], &place[1]),
                     2);
}

/* Fails unless the curve with this colour has this path. */
static void expect_path(const char *text, const char *color, const char *expected)
{
    char path[256];
    snprintf(path, sizeof path, "%s d=\"%s\"/>", color, expected);
    if (!strstr(text, path))
        fail_msg("no path %s in %s", path, text);
}

TEST_WITH(points_are_drawn, set_up, tear_down)
{
    FREED char *text = drawn(&lines);
    double one[2], two[2], four[2];
    char path[128];
    expect_picture(text);
    point_of(text, "vector stream: 1, 10<", one);
    point_of(text, "vector stream: 2, 10<", two);
    assert_true(one[1] == two[1] && one[0] < two[0]);
    assert_null(strstr(text, "vector stream: 4"));
    assert_null(strstr(text, "vector stream: 8"));
    snprintf(path, sizeof path, "M%.1f %.1fL%.1f %.1f", one[0], one[1], two[0], two[1]);
    expect_path(text, "stroke=\"#0072B2\" stroke-width=\"1.8\"", path);
    point_of(text, "vector start-up: 1, 33.3333<", one);
    point_of(text, "vector start-up: 2, 0.1<", two);
    point_of(text, "vector start-up: 4, 8<", four);
    assert_true(one[1] < four[1] && four[1] < two[1]);
    assert_true(fabs((four[0] - two[0]) - (two[0] - one[0])) < 0.15);
    assert_non_null(strstr(text, "vector start-up: 8, 4<"));
}

/* A point without a number ends a line. The line continues after it. */
TEST_WITH(lines_have_gaps, set_up, tear_down)
{
    double two[2], sixteen[2], more[2];
    char path[128];
    add_row(16, 10, 4);
    add_row(32, 5, 4);
    FREED char *text = drawn(&lines);
    point_of(text, "vector stream: 2, 10<", two);
    point_of(text, "vector stream: 16, 10<", sixteen);
    point_of(text, "vector stream: 32, 5<", more);
    snprintf(path, sizeof path, "L%.1f %.1fM%.1f %.1fL%.1f %.1f\"/>", two[0], two[1],
             sixteen[0], sixteen[1], more[0], more[1]);
    assert_non_null(strstr(text, path));
}

/* Areas are stacked. A row with a gap in any curve belongs to no area. */
TEST_WITH(areas_are_stacked, set_up, tear_down)
{
    struct plot plot = lines;
    double bottom, ten, all, x[2], none;
    plot.form = PLOT_AREAS;
    plot.levels = NULL;
    plot.level_count = 0;
    FREED char *text = drawn(&plot);
    expect_picture(text);
    const char *first = strstr(text, "<path fill=\"#0072B2\" d=\"");
    const char *second = strstr(text, "<path fill=\"#D55E00\" d=\"");
    assert_int_equal(sscanf(first,
                            "<path fill=\"#0072B2\" d=\"M%lf %lfL%lf %lfL%*f %lf",
                            &x[0], &ten, &x[1], &none, &bottom),
                     5);
    assert_true(ten == none && x[0] < x[1] && bottom > ten);
    assert_int_equal(sscanf(second, "<path fill=\"#D55E00\" d=\"M%*f %lf", &all), 1);
    assert_true(fabs((bottom - all) / (bottom - ten) - (10 + 100.0 / 3) / 10) < 0.01);
    assert_ptr_equal(strchr(strstr(first, "d=\""), 'Z') + 1,
                     strstr(strstr(first, "d=\"") + 3, "\"/>"));
}

/* A fitted line is drawn instead of the segments between the points. */
TEST_WITH(lines_are_fitted, set_up, tear_down)
{
    const struct plot_line line = { 8, 1 };
    const struct plot_curve fitted = { STREAM, "fitted", &line };
    struct plot plot = lines;
    double one[2], two[2], begin[2];
    plot.curves = &fitted;
    plot.curve_count = 1;
    FREED char *text = drawn(&plot);
    point_of(text, "fitted: 1, 10<", one);
    point_of(text, "fitted: 2, 10<", two);
    const char *path = strstr(text, "stroke-width=\"1.8\" d=\"M");
    assert_int_equal(sscanf(path, "stroke-width=\"1.8\" d=\"M%lf %lf", &begin[0],
                            &begin[1]),
                     2);
    assert_true(begin[0] == one[0] && begin[1] > one[1]);
}

TEST_WITH(bad_paths, set_up, tear_down)
{
    expect_error(&lines, "plot.pdf", "must end in .svg or .png");
    expect_error(&lines, ".svg", "must end in .svg");
    expect_error(&lines, "none/plot.svg", "No such file");
    assert_false(plot_check_path(in_folder("none/plot.svg"), &failure));
    assert_true(plot_check_path(in_folder("plot.svg"), &failure));
    assert_true(plot_check_path("plot.svg", &failure));
}

/* Neither file is written if one of them cannot be written. */
TEST_WITH(name_is_taken, set_up, tear_down)
{
    static const char *const names[] = { "plot.svg", "plot.png" };
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(mkdir(in_folder(names[i]), 0777), 0);
        expect_error(&lines, "plot.png", "Is a directory");
        assert_int_equal(rmdir(in_folder(names[i])), 0);
    }
}

TEST_WITH(bad_values, set_up, tear_down)
{
    const struct plot_curve remarks = { REMARK, "a text", NULL };
    const struct plot_mark zero = { 0, "zero" };
    struct plot plot = lines;
    plot.marks = &zero;
    plot.mark_count = 1;
    expect_error(&plot, "x.svg", "zero: 0 cannot be drawn on a logarithmic");
    plot = lines;
    plot.curves = &remarks;
    plot.curve_count = 1;
    expect_error(&plot, "x.svg", "nothing to draw");
    plot = lines;
    add_row(16, 1, -2);
    plot.form = PLOT_AREAS;
    expect_error(&plot, "x.svg", "startup: an area of -2");
    plot.form = PLOT_LINES;
    plot.y.scale = PLOT_LOG10;
    expect_error(&plot, "x.svg", "startup: -2 cannot be drawn on");
}

/* ---- The converter ---------------------------------------------------- */

/* Writes the plot as a .png. PATH contains only the folder. The script becomes
 * rsvg-convert in the folder; NULL: there is no converter. */
static bool write_png(const char *script, const char *name, c205_error *error)
{
    FREED char *path = strdup(getenv("PATH"));
    bool good;
    if (script) {
        write_file("rsvg-convert", script);
        assert_int_equal(chmod(in_folder("rsvg-convert"), 0777), 0);
    }
    setenv("PATH", temporary_folder, 1);
    good = write_plot(&lines, name, error);
    setenv("PATH", path, 1);
    if (script)
        remove_file("rsvg-convert");
    return good;
}

/* Writes a .png whose conversion fails. The old .png must not change, and the .svg must
 * be complete. */
static void expect_failure(const char *script, const char *part)
{
    c205_error error = { "" };
    write_file("a b'c.png", "old");
    assert_false(write_png(script, "a b'c.png", &error));
    if (!strstr(error.message, part))
        fail_msg("\"%s\" without \"%s\"", error.message, part);
    FREED char *picture = text_of_file("a b'c.png");
    assert_string_equal(picture, "old");
    FREED char *svg = text_of_file("a b'c.svg");
    expect_picture(svg);
    remove_file("a b'c.png");
    remove_file("a b'c.svg");
}

TEST_WITH(converter_fails, set_up, tear_down)
{
    expect_failure(NULL, "librsvg2-bin");
    expect_failure("#!/bin/sh\necho half; echo 'line 7: wrong' >&2; exit 3\n",
                   "rsvg-convert: line 7: wrong");
    expect_failure("#!/bin/sh\nexit 0\n", "no picture");
    expect_failure("#!/bin/sh\necho half; kill -9 $$\n", "no picture");
}

/* The picture has the bytes that the converter writes from the .svg. */
TEST_WITH(converter_is_used, set_up, tear_down)
{
    REQUIRE(
        write_png("#!/bin/sh\nwhile read -r line; do echo \"$line\"; done <\"$1\"\n",
                  "a b'c.png", &failure));
    FREED char *svg = text_of_file("a b'c.svg");
    FREED char *png = text_of_file("a b'c.png");
    assert_string_equal(png, svg);
    remove_file("a b'c.png");
    remove_file("a b'c.svg");
}

/* ---- Marks and axes --------------------------------------------------- */

/* Returns the y coordinate of a mark's label in the picture. y increases downwards. */
static double height_of(const char *picture, const char *label)
{
    const char *at = strstr(picture, label);
    double y;
    assert_non_null(at);
    while (strncmp(at, "<text ", 6) != 0)
        at--;
    assert_int_equal(sscanf(at, "<text x=\"%*f\" y=\"%lf\"", &y), 1);
    return y;
}

TEST_WITH(marks_have_rows, set_up, tear_down)
{
    const struct plot_mark many[] = { { 8, "far from the others" },
                                      { 1.1, "near" },
                                      { 1, "at one" } };
    struct plot plot = lines;
    plot.marks = many;
    plot.mark_count = 3;
    FREED char *picture = drawn(&plot);
    assert_true(height_of(picture, ">far") == height_of(picture, ">near"));
    assert_true(height_of(picture, ">at one") < height_of(picture, ">near"));
}

/* Fails unless the labels of an axis, each followed by a blank, are as expected. */
static void expect_labels(struct axis axis, const char *expected)
{
    struct axis_tic tics[AXIS_TICS];
    size_t count = axis_tics(&axis, tics);
    char text[256] = "";
    for (size_t i = 0; i < count; i++)
        if (tics[i].label[0] != '\0')
            strcat(strcat(text, tics[i].label), " ");
    assert_string_equal(text, expected);
}

TEST(axes_are_labelled)
{
    expect_labels((struct axis){ PLOT_LOG2, 1, 65536 },
                  "1 4 16 64 256 1,024 4,096 16,384 65,536 ");
    expect_labels((struct axis){ PLOT_LOG2, 0.25, 3 }, "0.25 0.5 1 2 ");
    expect_labels((struct axis){ PLOT_LOG10, 10, 1000 }, "10 20 50 100 200 500 1,000 ");
    expect_labels((struct axis){ PLOT_LOG10, 0.01, 1e7 },
                  "0.01 0.1 1 10 100 1,000 10,000 100,000 1,000,000 10,000,000 ");
    expect_labels((struct axis){ PLOT_LOG10, 1200, 1800 },
                  "1,200 1,300 1,400 1,500 1,600 1,700 1,800 ");
    expect_labels((struct axis){ PLOT_LINEAR, -123456, 400000 },
                  "-100,000 0 100,000 200,000 300,000 400,000 ");
    expect_labels((struct axis){ PLOT_LINEAR, 0, 0.35 },
                  "0 0.05 0.1 0.15 0.2 0.25 0.3 0.35 ");
    expect_labels((struct axis){ PLOT_LINEAR, 0, 4e13 },
                  "0 5e+12 1e+13 1.5e+13 2e+13 2.5e+13 3e+13 3.5e+13 4e+13 ");
}

/* Returns the y coordinate of the top of the frame. */
static double frame_top(const char *picture)
{
    double top;
    const char *frame = NON_NULL(strstr(picture, "<svg x="));
    assert_int_equal(sscanf(frame, "<svg x=\"%*f\" y=\"%lf\"", &top), 1);
    return top;
}

/* The levels are drawn if the y axis is cut off. The caption states the cut and moves
 * the frame down by a line, which is 16 pixels high. */
TEST_WITH(curves_are_cut, set_up, tear_down)
{
    struct plot plot = lines;
    FREED char *whole = drawn(&plot);
    assert_non_null(strstr(whole, "class=\"up\">35<"));
    assert_non_null(strstr(whole, "overflow=\"visible\""));
    assert_null(strstr(whole, "cut off"));
    plot.y_most = 5;
    FREED char *cut = drawn(&plot);
    assert_non_null(strstr(cut, "class=\"up\">12<"));
    assert_non_null(strstr(cut, "overflow=\"hidden\""));
    assert_non_null(strstr(cut, "cut off at 12; the highest value is 33.3333"));
    assert_true(fabs(frame_top(cut) - frame_top(whole) - 16) < 1e-9);
}

static void expect_rounded(enum plot_scale scale, double value, double more, double low,
                           double high)
{
    struct axis axis = axis_new(scale);
    axis_reach(&axis, value);
    axis_reach(&axis, more);
    axis_widen(&axis);
    axis_round(&axis);
    assert_true(fabs(axis.low - low) <= 1e-12 * fabs(low));
    assert_true(fabs(axis.high - high) <= 1e-12 * fabs(high));
}

TEST(axes_are_round)
{
    expect_rounded(PLOT_LINEAR, 410, 9012, 0, 10000);
    expect_rounded(PLOT_LINEAR, -3, 4, -3, 4);
    expect_rounded(PLOT_LINEAR, 0, 0, -1, 1);
    expect_rounded(PLOT_LOG10, 410, 9012, 200, 10000);
    expect_rounded(PLOT_LOG10, 1000, 1000, 100, 10000);
    expect_rounded(PLOT_LOG2, 3, 1024, 2, 1024);
}
