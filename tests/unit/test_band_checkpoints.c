/* test_band_checkpoints.c - frames that are stopped and continued, and bands from
 * files, are compared with complete frames. An incomplete row, or a band of another
 * frame or place that is accepted, fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

#include "rt/jobs/job_set.h"
#include "rt/trace/band_words.h"

#include <unistd.h>

enum { TALL = 120, ROWS = 40, BANDS = TALL / ROWS };

#define BEFORE "camera { location -5*z look_at 0 } light_source { <3, 5, -9>, 1 }\n"
#define TORI \
    "#for (I, 1, 30) torus { 1 + I / 20, .1 rotate I*21*x\n" \
    "  pigment { rgb <1, I / 30, 0> } } #end "
static const char plain[] = BEFORE TORI;
static const char mirrors[] = "#default { finish { reflection .3 } }" BEFORE TORI;

static char path[40];

static enum trace_order order;

/* Stops after the number of calls that the context contains. */
static bool wait_on(void *context, size_t done UNUSED, size_t all UNUSED)
{
    size_t *left = context;
    return *left > 0 && --*left > 0;
}

static struct trace_options how(enum trace_mode mode)
{
    return (struct trace_options)ON_PRIOR(.mode = mode, .order = order, .width = WIDTH,
                                          .height = TALL, .queue = 2 * WIDTH,
                                          .band = ROWS * WIDTH, .jobs = 2);
}

static struct trace *begin(const struct scene *scene,
                           const struct trace_options *options)
{
    return NON_NULL(trace_new(scene, options, &failure));
}

/* ---- Stopped ------------------------------------------------------------- */

/* Compares a row of two frames. If b is NULL, the row must be zeros. */
static bool same_row(const struct trace *a, const struct trace *b, size_t row)
{
    static const c205_word zeros[WIDTH];
    for (int i = 0; i < FRAME_CHANNELS; i++) {
        enum frame_channel channel = (enum frame_channel)i;
        if (memcmp(trace_channel(a, channel) + row * WIDTH,
                   b ? trace_channel(b, channel) + row * WIDTH : zeros, sizeof zeros)
            != 0)
            return false;
    }
    return true;
}

/* Fails unless each row is empty or complete. Returns the number of complete rows. */
static size_t check_stopped(const struct scene *scene, const struct trace *whole,
                            enum trace_mode mode, size_t jobs, size_t patience)
{
    struct trace_options options = how(mode);
    c205_error error = { "" };
    size_t same = 0, done;
    options.jobs = jobs;
    options.progress = wait_on;
    options.context = &patience;
    SCOPED(trace) *trace = begin(scene, &options);
    if (!trace_run(trace, &error))
        assert_non_null(strstr(error.message, "stopped after"));
    assert_int_equal(patience == 0, trace_rows_done(trace) < TALL);
    done = trace_rows_done(trace);
    for (size_t row = 0; row < TALL; row++) {
        FAIL_IF(!same_row(trace, NULL, row) && !same_row(trace, whole, row),
                "%d row %zu done %zu bands %zu", mode, row, done,
                trace_bands_done(trace));
        same += same_row(trace, whole, row);
    }
    assert_int_equal(same, done);
    assert_true(done >= ROWS * trace_bands_done(trace));
    return done;
}

static void check_stops(const char *text, bool rows)
{
    SCOPED(scene) *scene = read_text(text);
    for (int mode = 0; mode < TRACE_MODES; mode++) {
        struct trace_options options = how((enum trace_mode)mode);
        SCOPED(trace) *whole = run_trace(scene, &options);
        size_t done = 0;
        assert_int_equal(trace_rows_done(whole), TALL);
        assert_int_equal(trace_bands_done(whole), trace_bands(whole));
        for (size_t patience = 1; patience < 6; patience += 2) {
            /* with two threads the progress depends on their timing */
            check_stopped(scene, whole, (enum trace_mode)mode, 2, patience);
            done += check_stopped(scene, whole, (enum trace_mode)mode, 1, patience);
        }
        if (rows || mode == TRACE_SCALAR)
            assert_true(done > 0 && done % ROWS > 0);
    }
}

TEST(stopped)
{
    for (order = ORDER_ROWS; order <= ORDER_TILES; order++)
        check_stops(plain, true);
    order = ORDER_DEFAULT;
    check_stops(mirrors, false); /* reflected rays wait in queues */
}

/* ---- Saved --------------------------------------------------------------- */

/* Writes a unit like a run's, with samples of no frame and perhaps a wrong height. */
static void plant(struct trace *trace, struct job_set *job_set, uint64_t unit,
                  size_t rows)
{
    SCOPED_VALUE(band) band = { .rows = rows };
    size_t count = FRAME_CHANNELS * rows * WIDTH;
    FREED_BY(result_free) struct serialized_result words = { .items = NULL };
    assert_true(trace_keep(trace, &failure));
    band.words = NON_NULL(malloc(count * sizeof *band.words));
    for (size_t i = 0; i < count; i++)
        band.words[i] = c205_from_integer(205);
    band_put(&band, WIDTH, &words);
    assert_true(checkpoint_add(job_set->file, unit, &words, &failure));
}

/* Adds a unit of plant() to a file. A valid unit changes the frame, an invalid one does
 * not. */
static void check_planted(const struct scene *scene, const struct trace *whole,
                          uint64_t unit, size_t rows, bool taken)
{
    const char *const paths[] = { path };
    struct job_set job_set = { .paths = paths, .path_count = 1 };
    struct trace_options options = how(TRACE_VECTOR);
    options.job_set = &job_set;
    SCOPED(trace) *trace = begin(scene, &options);
    plant(trace, &job_set, unit, rows);
    assert_true(trace_run(trace, &failure));
    assert_int_equal(trace_rows_done(trace), TALL);
    assert_int_equal(trace_checksum(trace) == trace_checksum(whole), !taken);
    assert_int_equal(trace_accounts(trace)->clocks == trace_accounts(whole)->clocks,
                     !taken);
    trace_forget(trace);
    assert_int_not_equal(access(path, F_OK), 0);
}

TEST(planted)
{
    SCOPED(scene) *scene = read_text(AHEAD "sphere { 0, 1 }");
    struct trace_options options = how(TRACE_VECTOR);
    SCOPED(trace) *whole = run_trace(scene, &options);
    check_planted(scene, whole, 1, ROWS, true);
    check_planted(scene, whole, 1, ROWS - 1, false);
    check_planted(scene, whole, 1, ROWS + 1, false);
    check_planted(scene, whole, BANDS, ROWS, false);
    check_planted(scene, whole, UINT64_MAX, ROWS, false);
}

/* The second scene must accept the bands of the first if and only if both scenes are
 * the same. */
static void check_kept(const char *one, const char *other, bool same,
                       enum trace_mode mode)
{
    const char *const paths[] = { path };
    for (size_t i = 0; i < 2; i++) {
        struct job_set job_set = { .paths = paths, .path_count = 1 };
        struct trace_options options = how(mode);
        SCOPED(scene) *scene = read_text(i == 0 ? one : other);
        c205_error error = { "" };
        options.job_set = &job_set;
        SCOPED(trace) *trace = begin(scene, &options);
        if (i == 0)
            plant(trace, &job_set, 1, ROWS);
        else
            assert_int_equal(trace_keep(trace, &error), same);
        FAIL_IF(i == 1 && !same && !strstr(error.message, "another scene"), "%s",
                error.message);
        job_set_close(&job_set, false);
    }
    remove(path);
}

/* Each scene differs from the first scene in one number or word. */
TEST(other_scene)
{
#define BALL(sky, place, light, color, radius, more) \
    "background { rgb " sky " } camera { location <0, 0, " place "> }\n" \
    "light_source { " light ", 1 } sphere { 0, " radius " pigment { rgb " color \
    " } } " more
    static const char *const scenes[] = {
        BALL("0", "-5", "<3, 5, -9>", ".5", "1", ""),
        BALL(".1", "-5", "<3, 5, -9>", ".5", "1", ""),
        BALL("0", "-5.001", "<3, 5, -9>", ".5", "1", ""),
        BALL("0", "-5", "<3, 5, -9.001>", ".5", "1", ""),
        BALL("0", "-5", "<3, 5, -9>", ".501", "1", ""),
        BALL("0", "-5", "<3, 5, -9>", ".5", "1.001", ""),
        BALL("0", "-5", "<3, 5, -9>", ".5", "1", "sphere { 9*z, 1 }"),
        BALL("0", "-5", "<3, 5, -9>", ".5", "1",
             "#default { finish { reflection .1 } } sphere { 9*z, 1 }"),
    };

    for (int mode = 0; mode < TRACE_MODES; mode++)
        for (size_t i = 0; i < COUNT(scenes); i++)
            check_kept(scenes[0], scenes[i], i == 0, (enum trace_mode)mode);
}

FIXTURE(name_path)
{
    snprintf(path, sizeof path, "/tmp/rt205-bands-%ld", (long)getpid());
    return set_up_frames(test_state);
}

GROUP(name_path, tear_down_model);
