/* test_plot.c - plots: the data, the script and the picture of a table are compared
 * with the table, with unusual names, values that are not numbers, and a gnuplot that
 * is missing or fails. A file that is left incomplete, or a row or curve that is lost,
 * fails here.
 */
#include "rt/study/plot/plot.h"

#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

#include "rt/study/plot/plot_axis.h"
#include "tests/unit/temporary_folder.h"

enum { QUEUE, STREAM, STARTUP, REMARK, COLUMNS };

static const struct table_column columns[COLUMNS] = {
    { "queue", "queue", TABLE_COUNT, 0 },
    { "stream", "stream", TABLE_NUMBER, 1 },
    { "startup", "start-up", TABLE_NUMBER, 1 },
    { "remark", "remark", TABLE_TEXT, 0 },
};

static const struct plot_curve curves[] = {
    { STREAM, "vector stream" },
    { STARTUP, "vector start-up" },
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

static struct table *table; /* of the current test */

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
    return make_folder(test_state);
}

/* A test removes the files that it made. */
FIXTURE(tear_down)
{
    table_free(table);
    return remove_folder(test_state);
}

static void remove_file(const char *name)
{
    assert_int_equal(unlink(in_folder(name)), 0);
}

static void remove_plot(void)
{
    remove_file("a b'c.svg");
    remove_file("a b'c.dat");
    remove_file("a b'c.gp");
}

static bool write_plot(const struct plot *plot, const char *name, c205_error *error)
{
    return plot_write(plot, table, in_folder(name), error);
}

/* Draws a plot. Returns the text of one of its files, which the caller frees. */
static char *drawn(const struct plot *plot, const char *name)
{
    REQUIRE(write_plot(plot, "a b'c.svg", &failure));
    return text_of_file(name);
}

static void expect_error(const struct plot *plot, const char *name, const char *part)
{
    c205_error error = { "" };
    assert_false(write_plot(plot, name, &error));
    if (!strstr(error.message, part))
        fail_msg("\"%s\" without \"%s\"", error.message, part);
}

/* ---- Plots ------------------------------------------------------------ */

TEST_WITH(data_is_reported, set_up, tear_down)
{
    FREED char *text = drawn(&lines, "a b'c.dat");
    assert_string_equal(text, "# Clocks per ray\n"
                              "# model cyber205-2pipe\n"
                              "# a_b & <c>, it's \"so\" \\\n"
                              "# queue stream startup\n"
                              "1 10 33.333333333333336\n"
                              "2 10 0.1\n"
                              "4 NaN 8\n"
                              "8 NaN 4\n");
    remove_plot();
}

static void expect_picture(const char *text)
{
    static const char end[] = "</svg>";
    const char *last = strstr(text, end);
    assert_non_null(strstr(text, "<svg"));
    assert_non_null(last);
    assert_int_equal(strspn(last + strlen(end), "\n"), strlen(last + strlen(end)));
    assert_non_null(strstr(text, "Clocks per ray"));
    assert_non_null(strstr(text, "a_b &amp; &lt;c"));
    assert_non_null(strstr(text, "the paper's 3.5"));
    assert_non_null(strstr(text, "vector start-up"));
    assert_null(strstr(text, "nowhere"));
    assert_null(strstr(text, "nothing"));
}

/* A user runs gnuplot NAME.gp in the folder. */
TEST_WITH(script_draws_again, set_up, tear_down)
{
    const enum plot_form forms[] = { PLOT_LINES, PLOT_AREAS };
    for (size_t i = 0; i < 2; i++) {
        struct plot plot = lines;
        plot.form = forms[i];
        FREED char *first = drawn(&plot, "a b'c.svg");
        expect_picture(first);
        remove_file("a b'c.svg");
        setenv("FOLDER", temporary_folder, 1);
        assert_int_equal(system("cd \"$FOLDER\" && gnuplot \"a b'c.gp\""), 0);
        FREED char *second = text_of_file("a b'c.svg");
        assert_string_equal(first, second);
        remove_plot();
    }
}

/* Names that gnuplot would read as commands, options or its own data. */
TEST_WITH(names_are_names, set_up, tear_down)
{
    static const char *const names[] = { "<ls", "|cat", "-x", "~", "+", "`" };
    static const char *const ends[] = { "svg", "dat", "gp" };
    char name[16];
    for (size_t i = 0; i < COUNT(names); i++) {
        snprintf(name, sizeof name, "%s.svg", names[i]);
        if (!write_plot(&lines, name, &failure))
            fail_msg("%s: %s", name, failure.message);
        for (size_t j = 0; j < 3; j++) {
            snprintf(name, sizeof name, "%s.%s", names[i], ends[j]);
            remove_file(name);
        }
    }
}

TEST_WITH(bad_paths, set_up, tear_down)
{
    expect_error(&lines, "plot.pdf", "must end in .svg or .png");
    expect_error(&lines, ".svg", "must end in .svg");
    expect_error(&lines, "two\nlines.svg", "one line");
    expect_error(&lines, "none/plot.svg", "No such file");
    assert_false(plot_check_path(in_folder("none/plot.svg"), &failure));
    assert_true(plot_check_path(in_folder("plot.svg"), &failure));
    assert_true(plot_check_path("plot.svg", &failure));
}

/* If one file cannot be written, none is. */
TEST_WITH(name_is_taken, set_up, tear_down)
{
    static const char *const names[] = { "plot.dat", "plot.gp", "plot.svg" };
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(mkdir(in_folder(names[i]), 0777), 0);
        expect_error(&lines, "plot.svg", "Is a directory");
        assert_int_equal(rmdir(in_folder(names[i])), 0);
    }
}

TEST_WITH(bad_values, set_up, tear_down)
{
    const struct plot_curve remarks = { REMARK, "a text" };
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

/* ---- Gnuplot ---------------------------------------------------------- */

/* The path contains the folder alone; an old picture exists and must not change. The
 * script is the folder's gnuplot; without one there is none. */
static void expect_failure(const char *script, const char *part)
{
    FREED char *path = strdup(getenv("PATH"));
    if (script) {
        write_file("gnuplot", script);
        assert_int_equal(chmod(in_folder("gnuplot"), 0777), 0);
    }
    write_file("a b'c.svg", "old");
    setenv("PATH", temporary_folder, 1);
    expect_error(&lines, "a b'c.svg", part);
    setenv("PATH", path, 1);
    FREED char *picture = text_of_file("a b'c.svg");
    assert_string_equal(picture, "old");
    remove_plot();
    if (script)
        remove_file("gnuplot");
}

TEST_WITH(gnuplot_fails, set_up, tear_down)
{
    expect_failure(NULL, "gnuplot-nox");
    expect_failure("#!/bin/sh\necho half; echo 'line 7: wrong' >&2; exit 3\n",
                   "gnuplot: line 7: wrong");
    expect_failure("#!/bin/sh\nexit 0\n", "no picture");
    expect_failure("#!/bin/sh\necho half; kill -9 $$\n", "no picture");
}

/* ---- Marks and axes --------------------------------------------------- */

/* Returns the height of a mark's label in the picture, from 0 to 1. */
static double height_of(const char *script, const char *label)
{
    const char *at = strstr(script, label);
    assert_non_null(at);
    at = strstr(at, "screen ");
    assert_non_null(at);
    return strtod(at + strlen("screen "), NULL);
}

TEST_WITH(marks_have_rows, set_up, tear_down)
{
    const struct plot_mark many[] = { { 8, "far from the others" },
                                      { 1.1, "near" },
                                      { 1, "at one" } };
    struct plot plot = lines;
    plot.marks = many;
    plot.mark_count = 3;
    FREED char *script = drawn(&plot, "a b'c.gp");
    assert_true(height_of(script, "'far") == height_of(script, "'near"));
    assert_true(height_of(script, "'at one") > height_of(script, "'near"));
    remove_plot();
}

/* Fails unless the labels of an axis, each with a blank after it, are as expected. */
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

/* If the y axis is cut off, the levels are still drawn, and the caption states it. */
TEST_WITH(curves_are_cut, set_up, tear_down)
{
    struct plot plot = lines;
    FREED char *whole = drawn(&plot, "a b'c.gp");
    assert_non_null(strstr(whole, "set yrange [0:35]"));
    assert_null(strstr(whole, "cut off"));
    plot.y_most = 5;
    FREED char *cut = drawn(&plot, "a b'c.gp");
    assert_non_null(strstr(cut, "set yrange [0:12]"));
    assert_non_null(strstr(cut, "cut off at 12; the highest value is 33.3333"));
    remove_plot();
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
