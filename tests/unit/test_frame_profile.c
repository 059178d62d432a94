/* test_frame_profile.c - the profile of a frame, line by line of its kernels, is
 * compared with the frame's accounts, for each region and cause, and for any number of
 * concurrent bands. A clock that belongs to another line, or is lost, fails here. */
#define SMALL_FRAMES
#include "tests/unit/asm_helper.h"
#include "tests/unit/traced_frame.h"

#include "rt/view/frame_profile.h"

static uint64_t random_state = RANDOM_SEED;

/* ---- Models, and random frames ---------------------------------------- */

enum { MAX_MODELS = 16 };
static struct {
    size_t count;
    c205_model *list[MAX_MODELS]; /* models of the programs */
} models;

FIXTURE(find_models)
{
    const char *const *name = c205_model_names();
    for (; *name && models.count < MAX_MODELS; name++) {
        c205_model *model = c205_model_find(*name, &failure);
        if (model && !c205_model_is_projection(model))
            models.list[models.count++] = model;
        else
            c205_model_free(model);
    }
    return models.count < 2 || set_up_frames(test_state);
}

FIXTURE(free_models)
{
    while (models.count > 0)
        c205_model_free(models.list[--models.count]);
    return tear_down_model(test_state);
}

static struct trace_options some_options(enum trace_mode mode)
{
    uint64_t model = xorshift(&random_state) % models.count;
    return (struct trace_options){
        .mode = mode,
        .width = (size_t)xorshift_between(&random_state, 3, 12),
        .height = (size_t)xorshift_between(&random_state, 3, 9),
        .queue = (size_t)xorshift_between(&random_state, 1, 150),
        .band = (size_t)xorshift_between(&random_state, 20, 120),
        .jobs = (size_t)xorshift_between(&random_state, 1, 4),
        .order = (enum trace_order)xorshift_between(&random_state, 0, ORDERS - 1),
        .model = models.list[model]
    };
}

/* ---- Sums ---------------------------------------------------------------- */

/* ---- Frames -------------------------------------------------------------- */

/* Compares the profile with the accounts. The caller frees the returned listing. */
static char *check_frame(const struct scene *scene, struct trace_options options,
                         const char *what)
{
    SCOPED(line_profile) *profile = NULL;
    struct observer observer = frame_profile_observer(&profile);
    const struct observer *const observers[] = { &observer, NULL };
    options.observers = observers;
    SCOPED(trace) *trace = run_trace(scene, &options);
    /* Equal sums imply that all lines are in regions of the accounts. */
    const struct accounts *accounts = trace_accounts(trace);
    uint64_t clocks = 0;
    for (size_t i = 0; i < accounts->count; i++) {
        const c205_account *account = &accounts->items[i];
        c205_account sum = { .name = account->name };
        for (size_t k = 0; k < line_profile_count(profile); k++) {
            const struct profile_row *row = line_profile_row(profile, k);
            if (strcmp(row->region, account->name) != 0)
                continue;
            sum.instructions += row->executions;
            sum.elements += row->elements;
            for (int cause = 0; cause < C205_CAUSES; cause++)
                sum.clocks[cause] += row->clocks[cause];
        }
        for (int cause = 0; cause < C205_CAUSES; cause++)
            FAIL_IF(sum.clocks[cause] != account->clocks[cause],
                    "%s: %s of '%s' is %llu line by line, %llu in all", what,
                    c205_cause_name((c205_cause)cause), account->name,
                    (unsigned long long)sum.clocks[cause],
                    (unsigned long long)account->clocks[cause]);
        assert_int_equal(sum.instructions, account->instructions);
        assert_int_equal(sum.elements, account->elements);
    }
    for (size_t i = 0; i < line_profile_count(profile); i++)
        for (int cause = 0; cause < C205_CAUSES; cause++)
            clocks += line_profile_row(profile, i)->clocks[cause];
    assert_int_equal(clocks, accounts->clocks);
    SCOPED(table) *table = line_profile_table(profile,
                                              (struct profile_view){ PROFILE_HOTTEST,
                                                                     true },
                                              false);
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    assert_true(table && file && table_write(table, TABLE_CSV, file));
    fclose(file);
    return text;
}

static struct scene *read_file(const char *path)
{
    const struct scene_options reading = { .width = WIDTH,
                                           .height = HEIGHT,
                                           .read_raster = picture_read_raster };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = scene_read(path, &reading, &reports);
    FAIL_IF(!scene, "%s cannot be read", path);
    return scene;
}

static void check_scene(const char *path)
{
    static size_t count;
    const char *profiled = getenv("PROFILED");
    bool all = profiled && strcmp(profiled, "all") == 0;
    for (size_t mode = 0; mode < TRACE_MODES; mode++)
        if (all || mode == count % TRACE_MODES) {
            SCOPED(scene) *scene = read_file(path);
            free(check_frame(scene, some_options((enum trace_mode)mode), path));
        }
    count++;
}

/* Traces each scene in one of the stages, or in all stages (PROFILED=all). */
TEST_CALL(scenes, assert_true(each_file("scenes/*.pov", check_scene)
                                  + each_file("tests/scenes/*.pov", check_scene)
                              > 60))

/* All stages, for every number of concurrent bands. */
TEST(jobs)
{
    static const char *const paths[] = { "scenes/first.pov", "scenes/rings.pov",
                                         "tests/scenes/glass.pov" };
    for (size_t i = 0; i < 3 * TRACE_MODES; i++) {
        const char *path = paths[i / TRACE_MODES];
        SCOPED(scene) *scene = read_file(path);
        struct trace_options options = some_options((enum trace_mode)(i % TRACE_MODES));
        options.band = 3 * options.width;
        options.jobs = 1;
        FREED char *alone = check_frame(scene, options, path);
        options.jobs = (size_t)xorshift_between(&random_state, 2, 4);
        FREED char *several = check_frame(scene, options, path);
        assert_string_equal(alone, several);
    }
}

/* Regions, and lines of a region, are sorted by descending clocks. */
TEST(order)
{
    SCOPED(scene) *scene = read_file("scenes/first.pov");
    FREED char *text = check_frame(scene, some_options(TRACE_VECTOR), "order");
    char *line = strchr(text, '\n') + 1, region[40] = "", last[40] = "";
    unsigned long long clocks, before = 0, in_region = 0, in_last = UINT64_MAX;
    size_t regions = 0;
    for (; *line; line = strchr(line, '\n') + 1) {
        /* The form after the line is empty for instructions without one. */
        const char *form = strchr(strchr(line, ',') + 1, ',') + 1;
        assert_int_equal(sscanf(line, "%39[^,]", region), 1);
        assert_int_equal(sscanf(strchr(form, ','), ",%llu", &clocks), 1);
        if (strcmp(region, last) != 0) {
            if (regions++ > 1)
                assert_true(in_region <= in_last);
            in_last = regions > 1 ? in_region : UINT64_MAX;
            in_region = 0;
            snprintf(last, sizeof last, "%s", region);
        } else {
            assert_true(clocks <= before);
        }
        in_region += clocks;
        before = clocks;
    }
    assert_true(regions > 3 && in_region <= in_last);
}

GROUP(find_models, free_models);
