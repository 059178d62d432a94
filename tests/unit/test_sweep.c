/* test_sweep.c - the measures of rt205 sweep are compared with rt205 speedup, with sums
 * of their parts and with expected crossovers, in small frames. A clock that is lost,
 * or a wrong length, fails here. */
#include "rt/study/sweep/sweep_types.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

static const size_t few[] = { 1, 16, 64, 200, 256 };

static struct sweep sweep_of(const char *subject, size_t width, size_t height)
{
    struct sweep sweep = {
        .base = { .trace = { .mode = TRACE_VECTOR,
                             .width = width,
                             .height = height,
                             .queue = TRACE_QUEUE,
                             .model = fitted_model },
                  .view = { .distance = 5, .angle = 37 } },
    };
    for (size_t i = 0; i < speedup_subject_count; i++)
        if (strcmp(speedup_subjects[i].name, subject) == 0)
            sweep.subject = &speedup_subjects[i];
    assert_non_null(sweep.subject);
    return sweep;
}

static void run(const struct sweep_kind *kind, struct sweep *sweep)
{
    REQUIRE(kind->measure(sweep, &failure));
}

/* Sets the lengths of a sweep to an array. */
#define SET_LENGTHS(sweep, array) \
    ((sweep).lengths = (array), (sweep).length_count = COUNT(array))

/* Each clock has one cause, which is in one group. */
static void check_sums(const struct sweep_form *form)
{
    uint64_t causes = 0, groups = 0;
    for (int i = 0; i < C205_CAUSES; i++)
        causes += form->clocks[i];
    for (int i = 0; i < SWEEP_GROUPS; i++)
        groups += sweep_group_clocks(form, (enum sweep_group)i);
    assert_true(causes == form->total);
    assert_true(groups == form->total);
    assert_true(form->total > 0);
}

static void check_all_sums(const struct sweep *sweep)
{
    for (size_t i = 0; i < sweep->count; i++)
        for (int form = 0; form < SWEEP_FORMS; form++)
            check_sums(&sweep->measures[i].forms[form]);
}

static uint64_t group(const struct sweep_measure *measure, enum sweep_group which)
{
    return sweep_group_clocks(&measure->forms[SWEEP_QUEUED], which);
}

/* ---- Queues -------------------------------------------------------------- */

TEST(usual_lengths)
{
    struct sweep sweep = { .count = 0 };
    size_t lengths[MAX_SWEEP_LENGTHS];
    size_t count = sweep_lengths(&sweep, MAX_TRACE_QUEUE, lengths);
    bool paper = false;
    assert_int_equal(count, 18);
    assert_int_equal(lengths[0], 1);
    assert_int_equal(lengths[count - 1], 65535);
    for (size_t i = 0; i < count; i++) {
        assert_true(i == 0 || lengths[i] > lengths[i - 1]);
        paper |= lengths[i] == 2000;
    }
    assert_true(paper);
    assert_int_equal(sweep_lengths(&sweep, 1999, lengths), 11);
    assert_int_equal(sweep_lengths(&sweep, 2000, lengths), 12);
}

/* The sweep gives the same measurements as rt205 speedup. */
TEST(queue)
{
    SCOPED_VALUE(sweep) sweep = sweep_of("cylinder", 16, 16);
    SET_LENGTHS(sweep, few);
    run(&sweep_queue, &sweep);
    assert_int_equal(sweep.count, 5);
    check_all_sums(&sweep);
    for (size_t i = 0; i < sweep.count; i++) {
        const struct sweep_measure *measure = &sweep.measures[i];
        struct speedup_measure other;
        assert_true(sweep_cost(sweep_best(&sweep), SWEEP_QUEUED)
                    <= sweep_cost(measure, SWEEP_QUEUED));
        struct sweep_point point = measure->point;
        assert_int_equal(point.trace.queue, few[i]);
        for (int form = 0; form < SWEEP_FORMS; form++) {
            point.trace.mode = form == SWEEP_SCALAR ? TRACE_SCALAR : TRACE_VECTOR;
            assert_true(speedup_measure(sweep.subject, &point.view, &point.trace,
                                        &other, &failure));
            assert_true(other.total == measure->forms[form].total);
            assert_int_equal(other.hits, measure->hits);
        }
    }
}

/* Fourteen balls in one solid. Each ray stores its crossings with all balls. */
static const char balls[] =
    "camera { location -9*z look_at 0 right x up y }\n"
    "light_source { <-5, 9, -9> 1 }\n"
    "difference { box { -2, 2 } #for (I, 0, 13)\n"
    "sphere { <mod(I, 7)*.6 - 2, div(I, 7)*2 - 1, -2>, .7 } #end\n"
    "pigment { color rgb 1 } }\n";

/* The real memory has some thousand words, so that long queues cause page faults. Long
 * queues also test more parts of the solid, because each part is near a ray. */
TEST(small_memory)
{
    static const c205_setting settings[] = { { "page.words", 512 },
                                             { "memory.real_words", 48 * 512 },
                                             { "translation.miss", 0 } };
    static const size_t lengths[] = { 8, 64, 256, 2500, 4096 };
    SCOPED(scene) *scene = read_scene(balls);
    SCOPED_VALUE(sweep) sweep = sweep_of("sphere", 64, 64);
    SCOPED(c205_model) *small = NON_NULL(
        c205_model_change(fitted_model, settings, 3, &failure));
    sweep.subject = NULL;
    sweep.scene = scene;
    sweep.base.trace.model = small;
    sweep.base.trace.mode = TRACE_KERNELS;
    SET_LENGTHS(sweep, lengths);
    run(&sweep_queue, &sweep);
    check_all_sums(&sweep);
    const struct sweep_measure *best = sweep_best(&sweep);
    const struct sweep_measure *longest = &sweep.measures[sweep.count - 1];
    assert_true(best > sweep.measures && best < longest);
    uint64_t more = longest->forms[SWEEP_QUEUED].total
                    - best->forms[SWEEP_QUEUED].total;
    assert_true(group(longest, SWEEP_FAULT) - group(best, SWEEP_FAULT) > more / 3);
    assert_true(group(longest, SWEEP_STARTUP) < group(best, SWEEP_STARTUP));
}

/* The memory of a third frame is predicted from two frames. It includes the crossings
 * of a tree. */
TEST(memory)
{
    SCOPED(scene) *scene = read_scene(balls);
    SCOPED_VALUE(sweep) sweep = sweep_of("sphere", 64, 64);
    struct sweep_memory memory;
    uint64_t words;
    sweep.subject = NULL;
    sweep.scene = scene;
    assert_true(sweep_memory(&sweep, &memory, &failure));
    assert_int_equal(memory.crossings, 2 * 15);
    assert_true(memory.a_ray > 2 * 15);
    struct sweep_point point = sweep.base;
    point.trace.width = point.trace.height = 96;
    point.trace.queue = 96 * 96;
    assert_true(sweep_touched(&sweep, &point, 512, &words, &failure));
    double expected = memory.fixed + 96 * 96 * memory.a_ray;
    assert_true(fabs((double)words / expected - 1) < .05);
    assert_true(fabs(memory.fixed + memory.fills * memory.a_ray - memory.real) < 1);
}

TEST(queue_report)
{
    SCOPED_VALUE(sweep) sweep = sweep_of("sphere", 64, 64);
    SCOPED_VALUE(sweep_report) report = { .part_count = 0 };
    double sum = 0;
    size_t most = 0; /* the group of causes that increases most */
    run(&sweep_queue, &sweep);
    assert_int_equal(sweep.count, 14);
    assert_true(sweep_queue.report(&sweep, &report, &failure));
    assert_int_equal(table_rows(report.parts[0].table), sweep.count);
    const struct table *difference = report.parts[2].table;
    assert_int_equal(table_rows(difference), SWEEP_GROUPS + 1);
    for (size_t i = 0; i <= SWEEP_GROUPS; i++) {
        double best = table_value(difference, i, 1);
        assert_true(table_value(difference, i, 3)
                    == table_value(difference, i, 2) - best);
        assert_true(table_value(difference, i, 5)
                    == table_value(difference, i, 4) - best);
    }
    for (size_t i = 0; i < SWEEP_GROUPS; i++) {
        double more = table_value(difference, i, 3);
        sum += more;
        most = more > table_value(difference, most, 3) ? i : most;
    }
    assert_true(fabs(sum - table_value(difference, SWEEP_GROUPS, 3)) < 1e-9);
    assert_true(table_value(difference, SWEEP_GROUPS, 3) >= 0);
    assert_non_null(strstr(report.lines[0], "Best: a queue of"));
    assert_non_null(
        strstr(report.lines[1], formatted("increase is %s (%+.2f)",
                                          sweep_group_name((enum sweep_group)most),
                                          table_value(difference, most, 3))));
}

/* ---- Pipes --------------------------------------------------------------- */

/* Twice the results per clock halve the stream time, except for work that overlaps it.
 * Other clocks do not change. Half words on n pipes take as long as words on 2 n. */
TEST(pipes)
{
    SCOPED_VALUE(sweep) sweep = sweep_of("sphere", 64, 64);
    sweep.base.trace.queue = 1024;
    run(&sweep_pipes, &sweep);
    assert_int_equal(sweep.count, 6);
    check_all_sums(&sweep);
    const struct sweep_measure *m = sweep.measures;
    for (size_t i = 0; i < 6; i++) {
        assert_true(m[i].forms[SWEEP_SCALAR].total == m[0].forms[SWEEP_SCALAR].total);
        assert_true(group(&m[i], SWEEP_STARTUP) == group(&m[0], SWEEP_STARTUP));
    }
    for (size_t i = 0; i < 2; i++) {
        double twice = 2 * (double)group(&m[i + 1], SWEEP_STREAM);
        assert_true(fabs(twice / (double)group(&m[i], SWEEP_STREAM) - 1) < 1e-3);
        assert_true(m[3 + i].forms[SWEEP_QUEUED].total
                    == m[i + 1].forms[SWEEP_QUEUED].total);
    }
    assert_true(m[5].forms[SWEEP_QUEUED].total < m[4].forms[SWEEP_QUEUED].total);
}

/* ---- Hits ---------------------------------------------------------------- */

static void check_hits(const char *subject, size_t width, size_t height)
{
    SCOPED_VALUE(sweep) sweep = sweep_of(subject, width, height);
    run(&sweep_hits, &sweep);
    assert_int_equal(sweep.count, 11);
    check_all_sums(&sweep);
    assert_int_equal(sweep.measures[0].hits, 0);
    assert_int_equal(sweep.measures[10].hits, width * height);
    for (size_t k = 1; k < sweep.count; k++)
        assert_true(sweep.measures[k].hits
                    >= sweep.measures[k - 1].hits + (width == height));
}

/* Sweeps all subjects, and then a wide and a tall frame whose views may share hits. */
TEST(hits)
{
    for (size_t i = 0; i < speedup_subject_count; i++)
        check_hits(speedup_subjects[i].name, 16, 16);
    check_hits("cylinder", 40, 8);
    check_hits("cylinder", 8, 40);
}

/* A distant camera, and a camera that is so near that no ray misses the object. */
TEST(hits_out_of_view)
{
    SCOPED_VALUE(sweep) sweep = sweep_of("sphere", 16, 16);
    c205_error error = { "" };
    sweep.base.view.distance = 500;
    assert_false(sweep_hits.measure(&sweep, &error));
    assert_non_null(strstr(error.message, "too small"));
    sweep.base.view.distance = 1.1;
    assert_false(sweep_hits.measure(&sweep, &error));
    assert_non_null(strstr(error.message, "too large"));
}

/* ---- Lengths ------------------------------------------------------------- */

/* The queued form is cheaper from the crossover on, but not before it. */
static void check_crossover(const struct sweep *sweep,
                            const struct sweep_lengths_found *found)
{
    const struct sweep_measure *before = NON_NULL(
        sweep_with_queue(sweep, found->crossover - 1));
    assert_true(found->crossover > 1);
    assert_true(before->forms[SWEEP_QUEUED].total >= before->forms[SWEEP_SCALAR].total);
    for (size_t n = found->crossover; n <= found->checked; n++) {
        const struct sweep_measure *measure = NON_NULL(sweep_with_queue(sweep, n));
        assert_true(measure->forms[SWEEP_QUEUED].total
                    < measure->forms[SWEEP_SCALAR].total);
    }
    for (size_t i = 0; i < sweep->count; i++)
        if (sweep->measures[i].rays > found->crossover)
            assert_true(sweep_speedup(&sweep->measures[i]) > 1);
    assert_true(found->checked >= 2 * found->crossover - 2);
}

TEST(length)
{
    static const char *const names[] = { "sphere", "Steiner", "cylinder",
                                         "torus, ours" };
    static const size_t lengths[] = { 1, 2, 4, 8, 16, 64, 256, 1024 };
    for (size_t i = 0; i < share_of(4); i++) {
        SCOPED_VALUE(sweep) sweep = sweep_of(names[i], 1, 1);
        SET_LENGTHS(sweep, lengths);
        run(&sweep_length, &sweep);
        check_all_sums(&sweep);
        struct sweep_lengths_found found = sweep_find_lengths(&sweep);
        check_crossover(&sweep, &found);
        assert_true(found.half_is_exact);
        assert_true(sweep_speedup(sweep_with_queue(&sweep, found.half))
                    >= found.best / 2);
        assert_true(sweep_speedup(sweep_with_queue(&sweep, found.half - 1))
                    < found.best / 2);
        for (size_t k = 0; k < sweep.count; k++) {
            assert_int_equal(sweep.measures[k].rays,
                             sweep.measures[k].point.trace.queue);
            assert_true(group(&sweep.measures[k], SWEEP_FAULT) == 0);
        }
    }
}

/* There is no crossover if one form is cheaper at every length. */
TEST(no_crossover)
{
    static const size_t shortest[] = { 1 }, longer[] = { 64, 128 };
    SCOPED_VALUE(sweep) one = sweep_of("sphere", 1, 1);
    SCOPED_VALUE(sweep) two = sweep_of("sphere", 1, 1);
    SET_LENGTHS(one, shortest);
    SET_LENGTHS(two, longer);
    run(&sweep_length, &one);
    run(&sweep_length, &two);
    assert_int_equal(sweep_find_lengths(&one).crossover, 0);
    struct sweep_lengths_found found = sweep_find_lengths(&two);
    assert_int_equal(found.crossover, 64);
    assert_int_equal(found.checked, 0);
    assert_int_equal(found.half, 64);
    assert_false(found.half_is_exact);
}

/* Returns a measurement with this queue length and speedup. */
static struct sweep_measure as_if(size_t length, uint64_t speedup)
{
    struct sweep_measure measure = { .rays = length };
    measure.point.trace.queue = length;
    measure.forms[SWEEP_SCALAR].total = speedup;
    measure.forms[SWEEP_QUEUED].total = 3;
    return measure;
}

/* Adjacent lengths are no crossover if shorter lengths were not measured. */
TEST(left_out)
{
    struct sweep_measure measures[] = { as_if(1, 1),    as_if(400, 7),  as_if(401, 7),
                                        as_if(900, 20), as_if(901, 21), as_if(902, 22),
                                        as_if(8192, 42) };
    struct sweep sweep = { .measures = measures, .count = 7 };
    struct sweep_lengths_found found = sweep_find_lengths(&sweep);
    assert_int_equal(found.crossover, 400);
    assert_int_equal(found.checked, 0);
    assert_int_equal(found.half, 901);
    assert_true(found.half_is_exact);
    measures[1] = as_if(400, 2);
    found = sweep_find_lengths(&sweep);
    assert_int_equal(found.crossover, 401);
    assert_int_equal(found.checked, 401);
    measures[3] = as_if(900, 21);
    assert_false(sweep_find_lengths(&sweep).half_is_exact);
}

/* ---- Progress ------------------------------------------------------------ */

struct watcher {
    size_t calls, stop_at, last;
    bool fell, ended;
};

static bool watch(void *context, size_t done, size_t all)
{
    struct watcher *watcher = context;
    watcher->fell |= done < watcher->last;
    watcher->last = done;
    watcher->ended |= done == all;
    watcher->calls++;
    return watcher->stop_at == 0 || watcher->calls < watcher->stop_at;
}

/* The progress increases over all frames. Any call can stop the sweep. */
TEST(progress)
{
    for (size_t stop_at = 0; stop_at < 4; stop_at++) {
        SCOPED_VALUE(sweep) sweep = sweep_of("sphere", 64, 64);
        struct watcher watcher = { .stop_at = stop_at };
        c205_error error = { "" };
        SET_LENGTHS(sweep, few);
        sweep.base.trace.progress = watch;
        sweep.base.trace.context = &watcher;
        assert_int_equal(sweep_queue.measure(&sweep, &error), stop_at == 0);
        assert_int_equal(watcher.ended, stop_at == 0);
        assert_false(watcher.fell);
        if (stop_at > 0)
            assert_non_null(strstr(error.message, "stopped"));
    }
}

GROUP(set_up_fitted, tear_down_fitted);
