/* test_program_sweep.c - the points of a sweep are compared with plain runs, its fitted
 * line with an independent computation, and its crossings with runs of all values. A
 * point of another value, or a crossing that is lost, fails here. */
#include <math.h>

#include "asm/sweep/swept.h"
#include "base/accounts.h"
#include "tests/unit/draw.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/random_debug_program.h"
#include "tests/unit/prior_model.h"

/* ---- Sweeps ---------------------------------------------------------------- */

static const struct asm_options no_options = { .defines = NULL };

static struct text_line reported; /* the first warnings of random programs */

static struct program_sweep sweep_of(const char *constant, uint64_t from, uint64_t to)
{
    return (struct program_sweep){ .constant = constant,
                                   .range = { .from = from, .to = to },
                                   .model = prior_model,
                                   .options = &no_options,
                                   .report = text_line_sink(&reported),
                                   .clocks_most = 1000000000 };
}

static void add_text(struct program_sweep *sweep, const char *path, const char *text)
{
    sweep->programs[sweep->program_count++] = (struct swept_program){
        .path = path, .text = text, .length = strlen(text)
    };
}

static char *file_text(const char *path)
{
    FILE *file = NON_NULL(fopen(path, "r"));
    char *text = calloc(1, 65536);
    assert_true(fread(text, 1, 65535, file) > 0);
    fclose(file);
    return text;
}

static void run(struct program_sweep *sweep)
{
    FAIL_IF(!swept_run(sweep, &failure), "%s", failure.message);
}

/* ---- Plain runs ------------------------------------------------------------ */

/* Returns the machine after a run of the program that was assembled with this value. */
static c205 *run_plainly(const struct program_sweep *sweep, int which, uint64_t value)
{
    const struct swept_program *program = &sweep->programs[which];
    struct asm_define defines[] = { { sweep->constant, (int64_t)value }, { NULL, 0 } };
    struct asm_options options = { .defines = defines };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    SCOPED(object) *object = NON_NULL(
        assemble_text(program->path, program->text, &options, &errors));
    c205 *machine = c205_new(prior_model, &failure);
    assert_true(c205_load(machine, &object->program, &failure));
    if (sweep->warm)
        c205_warm(machine);
    assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
    return machine;
}

static uint64_t plain_clocks(const struct program_sweep *sweep, int which,
                             uint64_t value)
{
    SCOPED(c205) *machine = run_plainly(sweep, which, value);
    return c205_clock(machine);
}

/* Compares clocks, for each cause and in total, and operations. */
static void check_point(const struct program_sweep *sweep, int which,
                        const struct swept_point *point)
{
    SCOPED(c205) *machine = run_plainly(sweep, which, point->value);
    const c205_account *found = &point->runs[which];
    c205_account sum = { .name = "" };
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        sum.operations += account->operations;
        sum.instructions += account->instructions;
    }
    for (int cause = 0; cause < C205_CAUSES; cause++)
        assert_int_equal(found->clocks[cause],
                         clocks_of_cause(machine, (c205_cause)cause));
    assert_int_equal(found->operations, sum.operations);
    assert_int_equal(found->instructions, sum.instructions);
    assert_int_equal(accounts_clocks(found), c205_clock(machine));
}

static void check_points(const struct program_sweep *sweep)
{
    for (size_t i = 0; i < sweep->count; i++)
        for (size_t k = 0; k < sweep->program_count; k++)
            check_point(sweep, (int)k, &sweep->points[i]);
}

TEST(examples)
{
    static const struct {
        const char *path, *constant;
        uint64_t from, to;
    } examples[] = {
        { "asm/examples/saxpy_scalar.s", "n", 1, 500 },
        { "asm/examples/saxpy_vector.s", "n", 8, 65535 },
        { "asm/examples/saxpy_linked.s", "n", 8, 65535 },
        { "asm/examples/sieve.s", "limit", 64, 3000 },
        { "asm/examples/profiling/matrix_1.s", "n", 1, 12 },
        { "asm/examples/profiling/matrix_2.s", "n", 1, 12 },
        { "asm/examples/profiling/matrix_3.s", "n", 1, 12 },
        { "asm/examples/profiling/matrix_4.s", "n", 1, 12 },
    };
    static const char *const folders[] = { "asm/examples", "asm/examples/profiling",
                                           NULL };
    static const struct asm_options options = { .search = folders };
    for (size_t i = 0; i < COUNT(examples); i++) {
        FREED_BY(swept_free)
        struct program_sweep sweep = sweep_of(examples[i].constant, examples[i].from,
                                              examples[i].to);
        FREED char *text = file_text(examples[i].path);

        sweep.options = &options;
        sweep.asked = 9;
        sweep.warm = i % 2;
        add_text(&sweep, examples[i].path, text);
        run(&sweep);
        assert_true(sweep.count > 5);
        check_points(&sweep);
    }
}

static size_t tried, ended;

/* Sweeps a constant without effect. Programs that trap on purpose are skipped. */
static void try_program(const char *path)
{
    FREED_BY(swept_free) struct program_sweep sweep = sweep_of("no_change", 1, 2);
    SCOPED_VALUE(text_buffer) report = { 0 };
    FREED char *text = file_text(path);

    strcat(text, "\n        .ifdef no_change\n        .endif\n");
    sweep.report = text_buffer_sink(&report);
    sweep.warm = tried++ % 2;
    add_text(&sweep, path, text);
    if (swept_run(&sweep, &failure)) {
        check_points(&sweep);
        ended++;
    }
}

TEST(programs)
{
    assert_true(each_file("tests/programs/*.s", try_program) > 0);
    assert_true(10 * ended > 9 * tried);
}

/* ---- Random programs ---------------------------------------------------- */

TEST(random_programs)
{
    for (int i = 0; i < 60; i++) {
        FREED_BY(swept_free)
        struct program_sweep sweep = sweep_of("n", 1 + below(20), 30 + below(2000));
        char text[DRAWN_TEXT];

        draw_program(&random_state, text);
        sweep.asked = 2 + below(10);
        sweep.warm = below(2);
        add_text(&sweep, "drawn.s", text);
        run(&sweep);
        check_points(&sweep);
    }
}

/* ---- Crossings ------------------------------------------------------------- */

/* Runs both programs for every value to find where the faster one changes. */
static void check_crossings(const struct program_sweep *sweep)
{
    size_t found = 0;
    bool before = false;
    for (uint64_t n = sweep->range.from; n <= sweep->range.to; n++) {
        bool faster = plain_clocks(sweep, SWEPT_SECOND, n)
                      < plain_clocks(sweep, SWEPT_FIRST, n);
        if (n > sweep->range.from && faster != before) {
            const struct swept_crossing *crossing = &sweep->crossings[found];
            assert_true(found++ < sweep->crossing_count);
            assert_int_equal(crossing->at.value, n);
            assert_int_equal(crossing->faster, faster);
            check_point(sweep, SWEPT_FIRST, &crossing->at);
            check_point(sweep, SWEPT_SECOND, &crossing->at);
        }
        before = faster;
    }
    assert_int_equal(found, sweep->crossing_count);
}

/* Writes a fixed number of instructions with one clock each, and a number that is a
 * multiple of n. The result is an exact line. */
static void write_line(char text[DRAWN_TEXT], uint64_t fixed, uint64_t slope)
{
    snprintf(text, DRAWN_TEXT,
             "        .rept %d + %d * n\n        ES r10, 1\n        .endr\n"
             "        EXIT\n",
             (int)fixed, (int)slope);
}

static void draw_line(char text[DRAWN_TEXT])
{
    uint64_t slope = below(5);
    write_line(text, below(120), slope);
}

TEST(crossings)
{
    size_t crossed = 0;
    for (int i = 0; i < 50; i++) {
        FREED_BY(swept_free)
        struct program_sweep sweep = sweep_of("n", 1 + below(10), 30 + below(60));
        char first[DRAWN_TEXT], second[DRAWN_TEXT];

        draw_line(first);
        draw_line(second);
        sweep.asked = 2 + below(8);
        add_text(&sweep, "first.s", first);
        add_text(&sweep, "second.s", second);
        run(&sweep);
        check_crossings(&sweep);
        crossed += sweep.crossing_count;
    }
    assert_true(crossed > 9);
}

/* Values between two steps of a range are not run. */
TEST(steps)
{
    FREED_BY(swept_free) struct program_sweep sweep = sweep_of("n", 8, 1000);
    char first[DRAWN_TEXT], second[DRAWN_TEXT];

    write_line(first, 100, 0);
    write_line(second, 0, 1);
    sweep.range.factor = 2;
    add_text(&sweep, "first.s", first);
    add_text(&sweep, "second.s", second);
    run(&sweep);
    assert_int_equal(sweep.count, 7);
    assert_int_equal(sweep.points[6].value, 512);
    assert_int_equal(sweep.crossing_count, 1);
    assert_int_equal(sweep.crossings[0].at.value, 128);
    assert_false(sweep.crossings[0].faster);
    check_points(&sweep);
}

/* ---- The line -------------------------------------------------------------- */

/* Makes points with clocks of one cause, without programs. */
static void make_points(struct program_sweep *sweep, double startup, double slope,
                        double noise)
{
    uint64_t values[MAX_SWEPT_POINTS];
    sweep->program_count = 1;
    sweep->count = swept_values(&sweep->range, 0, values);
    sweep->points = calloc(sweep->count, sizeof *sweep->points);
    for (size_t i = 0; i < sweep->count; i++) {
        double clocks = (startup + slope * (double)values[i])
                        * (1 + xorshift_real(&random_state, -noise, noise));
        c205_account *run = &sweep->points[i].runs[SWEPT_FIRST];
        sweep->points[i].value = values[i];
        run->clocks[below(C205_CAUSES)] = (uint64_t)llround(clocks);
        run->operations = 7 + 3 * values[i];
    }
}

/* Solves the normal equations for the least ((s + b x - t) / t)^2 in long double. */
static void solve(const struct program_sweep *sweep, long double *startup,
                  long double *slope)
{
    long double w = 0, wx = 0, wxx = 0, wt = 0, wxt = 0;
    for (size_t i = 0; i < sweep->count; i++) {
        long double x = sweep->points[i].value;
        long double t = accounts_clocks(&sweep->points[i].runs[0]);
        w += 1 / (t * t);
        wx += x / (t * t);
        wxx += x * x / (t * t);
        wt += 1 / t;
        wxt += x / t;
    }
    *slope = (w * wxt - wx * wt) / (w * wxx - wx * wx);
    *startup = (wt - *slope * wx) / w;
}

static void check_line(const struct program_sweep *sweep, double noise)
{
    struct swept_line line = swept_line_of(sweep, SWEPT_FIRST);
    long double startup, slope, farthest = 0;
    solve(sweep, &startup, &slope);
    for (size_t i = 0; i < sweep->count; i++) {
        const struct swept_point *point = &sweep->points[i];
        long double t = accounts_clocks(&point->runs[0]);
        long double off = (startup + slope * point->value - t) / t;
        farthest = fmaxl(farthest, fabsl(off));
        if (point->value == line.off_at)
            assert_true(fabsl(off - line.off) < 1e-9L);
    }
    assert_true(fabsl(line.clocks.slope / slope - 1) < 1e-9L);
    assert_true(fabsl(line.clocks.at_zero - startup)
                < 1e-9L * (fabsl(startup) + slope * sweep->range.from));
    assert_true(fabsl(fabsl(line.off) - farthest) < 1e-9L);
    assert_true(fabs(swept_half_length(&line) - (double)(startup / slope))
                < 1e-6 * (1 + fabs((double)(startup / slope))));
    assert_true(fabs(line.flops - 3) < 1e-9);
    assert_int_equal(line.good, line.grows && farthest <= SWEPT_FAR);
    if (noise <= .02)
        assert_true(line.good || !line.grows);
}

TEST(lines)
{
    static const double noises[] = { 0, .001, .02, .3 };
    for (size_t i = 0; i < 400; i++) {
        uint64_t from = 1 + below(100);
        FREED_BY(swept_free)
        struct program_sweep sweep = sweep_of("n", from, from * (2 + below(1000)));
        double noise = noises[i % COUNT(noises)];

        make_points(&sweep, (double)(50 + below(100000)), (double)(1 + below(500)),
                    noise);
        check_line(&sweep, noise);
        if (noise <= 0)
            assert_true(fabs(swept_line_of(&sweep, SWEPT_FIRST).off) < 1e-9);
    }
}

TEST(no_line)
{
    FREED_BY(swept_free) struct program_sweep sweep = sweep_of("n", 10, 1000);

    make_points(&sweep, 500, 0, 0);
    struct swept_line line = swept_line_of(&sweep, SWEPT_FIRST);
    assert_true(!line.grows && !line.good);
    for (size_t i = 0; i < sweep.count; i++) {
        uint64_t n = sweep.points[i].value;
        sweep.points[i].runs[0] = (c205_account){ .clocks = { n * n * n } };
    }
    line = swept_line_of(&sweep, SWEPT_FIRST);
    assert_true(line.grows && !line.good && !(line.flops > 0));
    assert_true(fabs(swept_power(&sweep, SWEPT_FIRST) - 3) < 1e-9);
}

/* ---- Ranges ---------------------------------------------------------------- */

TEST(ranges)
{
    static const char bad[] =
        ",8,8:,:8,0:8,8:8,9:8,-1:8,8:9:,8:9:0,8:9:x,8:9:x1,8:9:x0,"
        "8:9:2:3,8:9 , 8:9,8:9:1.5,8:9:xx2,a:b,8:9:-1,8:0x,8 : 9,"
        "1:140737488355328,1:99999999999999999999,";
    struct swept_range range;
    for (const char *at = bad, *end; (end = strchr(at, ',')); at = end + 1) {

        const char *text = formatted("%.*s", (int)(end - at), at);
        FAIL_IF(swept_take_range(text, &range), "'%s' is a range", text);
    }
    assert_true(swept_take_range("8:0xFFFF", &range));
    assert_true(range.from == 8 && range.to == 65535 && range.step == 0
                && range.factor == 0);
    assert_true(swept_take_range("1:9:3", &range) && range.step == 3);
    assert_true(swept_take_range("1:9:x3", &range) && range.factor == 3);
}

static void check_spread(const uint64_t *values, size_t count,
                         const struct swept_range *range, size_t points)
{
    double ratio = (double)range->to / (double)range->from;
    assert_true(count >= 2 && count <= points);
    assert_int_equal(values[0], range->from);
    assert_int_equal(values[count - 1], range->to);
    for (size_t i = 1; i < count; i++) {
        double factor = pow(ratio, 1 / (double)(points - 1));
        assert_true(values[i] > values[i - 1]);
        assert_true((double)values[i] <= (double)(values[i - 1] + 1) * factor + 1);
    }
}

/* Either the requested ratio separates all values, or both ends are included. */
TEST(values)
{
    static uint64_t values[MAX_SWEPT_POINTS];
    struct swept_range far = { UINT64_C(1) << 40, UINT64_C(1) << 46, 0,
                               UINT64_C(1) << 40 };
    assert_int_equal(swept_values(&far, 0, values), 1);
    for (int i = 0; i < 2000; i++) {
        struct swept_range range = { .from = 1 + below(UINT64_C(1) << below(20)) };
        size_t points = 2 + below(MAX_SWEPT_POINTS - 1);
        range.to = range.from + 1 + below(UINT64_C(1) << below(46));
        check_spread(values, swept_values(&range, points, values), &range, points);
        double octaves = log2((double)range.to / (double)range.from);
        check_spread(values, swept_values(&range, 0, values), &range,
                     octaves > 3 ? 25 : 1 + (size_t)ceil(8 * octaves));
        range.step = 1 + below(range.to - range.from);
        size_t count = swept_values(&range, 0, values);
        assert_int_equal(count == 0,
                         (range.to - range.from) / range.step + 1 > MAX_SWEPT_POINTS);
        for (size_t k = 0; k < count; k++)
            assert_int_equal(values[k], range.from + k * range.step);
        range.step = 0;
        range.factor = 2 + below(UINT64_C(1) << below(46));
        count = swept_values(&range, 0, values);
        assert_true(values[0] == range.from
                    && values[count - 1] * range.factor > range.to);
        for (size_t k = 1; k < count; k++)
            assert_int_equal(values[k], values[k - 1] * range.factor);
    }
}

/* ---- Faults ---------------------------------------------------------------- */

static void check_fault(const char *text, const char *said)
{
    FREED_BY(swept_free) struct program_sweep sweep = sweep_of("n", 1, 64);
    SCOPED_VALUE(text_buffer) report = { 0 };
    c205_error error;

    sweep.report = text_buffer_sink(&report);
    sweep.range.factor = 2;
    sweep.clocks_most = 20000;
    add_text(&sweep, "fault.s", text);
    assert_false(swept_run(&sweep, &error));
    FAIL_IF(!strstr(error.message, said), "'%s', not '%s'", error.message, said);
    assert_int_equal(sweep.count > 0, sweep.points[0].runs[0].clocks[0] > 0);
}

static bool never(void *context UNUSED, size_t done, size_t all)
{
    assert_true(done <= all);
    return done < 7;
}

TEST(faults)
{
    static const char good_text[] = "        ES r1, n\n        EXIT\n";
    FREED_BY(swept_free) struct program_sweep sweep = sweep_of("n", 1, 64);
    c205_error error;

    check_fault("        EX r10, 64 * (n & 8)\n        .if n == 8\n"
                "        LOD [r10], r11\n        .endif\n        EXIT\n",
                "fault.s with n = 8: trap unmapped-address");
    check_fault("        .if n > 20\n        NOPE\n        .endif\n"
                "        EXIT\n",
                "fault.s with n = 32: the program cannot be assembled");
    check_fault("        .if n > 2\nloop:   BIM loop\n        .endif\n"
                "        EXIT\n",
                "fault.s with n = 4: trap clock-limit");
    check_fault("        ES r1, n / 16\n        EXIT r1, r0, 0\n",
                "fault.s with n = 16: the program ended with status 1");
    sweep.range.factor = 2;
    sweep.goes_on = never;
    add_text(&sweep, "good.s", good_text);
    assert_false(swept_run(&sweep, &error));
    assert_string_equal(error.message, "good.s with n = 4: interrupted");
}

/* ---- The picture ----------------------------------------------------------- */

/* Fails unless the picture has every point, half length and crossing within its
 * borders. */
static void check_picture(const struct program_sweep *sweep)
{
    SCOPED_VALUE(text_buffer) svg = { 0 };
    struct sink sink = text_buffer_sink(&svg);
    size_t halves = 0, circles = 0;
    double x, y, width, height;
    for (size_t k = 0; k < sweep->program_count; k++) {
        struct swept_line line = swept_line_of(sweep, (int)k);
        double half = swept_half_length(&line);
        halves += line.good && half >= (double)sweep->range.from
                  && half <= (double)sweep->range.to;
    }
    REQUIRE(swept_svg(sweep, "a < b & c", &sink, &failure));
    assert_int_equal(sscanf(svg.text,
                            "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                            "width=\"%lf\" height=\"%lf\"",
                            &width, &height),
                     2);
    for (const char *at = svg.text; (at = strstr(at, "<circle ")) != NULL; at++) {
        assert_int_equal(sscanf(at, "<circle cx=\"%lf\" cy=\"%lf\"", &x, &y), 2);
        assert_true(x > 0 && x < width && y > 0 && y < height);
        circles++;
    }
    assert_int_equal(circles, sweep->program_count * (sweep->count + 1));
    assert_int_equal(count_of(svg.text, "class=\"mark\""),
                     halves + sweep->crossing_count);
    assert_int_equal(count_of(svg.text, "n-half"), halves);
    assert_int_equal(count_of(svg.text, " on the second is "), sweep->crossing_count);
    assert_int_equal(count_of(svg.text, "a &lt; b &amp; c"), 1);
    assert_int_equal(count_of(svg.text, "<text"), count_of(svg.text, "</text>"));
    assert_null(strstr(svg.text, "nan"));
    assert_null(strstr(svg.text, "inf"));
}

TEST(pictures)
{
    for (int i = 0; i < 60; i++) {
        FREED_BY(swept_free)
        struct program_sweep sweep = sweep_of("n", 1 + below(100),
                                              102 + below(UINT64_C(1) << below(12)));
        char first[DRAWN_TEXT], second[DRAWN_TEXT];

        draw_program(&random_state, first);
        draw_line(second);
        add_text(&sweep, "first.s", first);
        if (below(3) > 0)
            add_text(&sweep, "second.s", second);
        sweep.asked = 2 + below(20);
        run(&sweep);
        check_picture(&sweep);
    }
}
