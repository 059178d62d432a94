/* test_checked_kernels.c - scenes are traced in every form with the runtime checks of a
 * program. There must be no reports. A kernel that reads uninitialised memory, or a
 * vector that is too long, fails here. */
#include "tests/unit/asm_helper.h"

#include "asm/check/runtime_check.h"
#include "rt/picture/picture.h"
#include "rt/scene/language/scene_read.h"
#include "rt/trace/trace.h"

enum { WIDTH = 17, HEIGHT = 13 };

struct watched {
    struct runtime_checker *watch;
    bool began;
};

static const struct warning_choice choice;
static const struct sink *report;

static void *begin(void *context UNUSED, const struct object *program,
                   c205_error *error UNUSED)
{
    struct watched *watched = NON_NULL(calloc(1, sizeof *watched));
    watched->watch = NON_NULL(runtime_new(program, "kernels", &choice, report));
    return watched;
}

static void listen(void *band, const c205 *machine, const c205_event *event)
{
    struct watched *watched = band;
    if (!watched->began)
        runtime_begin(watched->watch, machine);
    watched->began = true;
    runtime_listen(watched->watch, machine, event);
}

static void merge(void *context, const void *band)
{
    const struct watched *watched = band;
    assert_true(watched->began);
    *(warning_set *)context |= runtime_warned(watched->watch);
}

static void end(void *band)
{
    FREED struct watched *watched = band;
    runtime_free(watched->watch);
}

static void check(const char *path, const c205_model *model, enum trace_mode mode,
                  enum visible visible)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    const struct scene_options reading = { .width = WIDTH,
                                           .height = HEIGHT,
                                           .read_raster = picture_read_raster };
    SCOPED(scene) *scene = scene_read(path, &reading, &reports);
    warning_set warned = 0;
    const struct observer observer = { begin, listen, merge, end, &warned };
    const struct observer *const observers[] = { &observer, NULL };
    const struct trace_options options = { .mode = mode,
                                           .width = WIDTH,
                                           .height = HEIGHT,
                                           .queue = 50,
                                           .visible = visible,
                                           .observers = observers,
                                           .model = model };
    if (!scene)
        diagnostics_print(&reports, stderr);
    assert_non_null(scene);
    SCOPED(trace) *trace = trace_new(scene, &options, &failure);
    REQUIRE(trace && trace_run(trace, &failure));
    assert_int_equal(warned, 0);
}

TEST(kernels)
{
    static const char *const scenes[] = {
        "scenes/first.pov",           "tests/scenes/csg_culled.pov",
        "scenes/bracket.pov",         "tests/scenes/csg_patches.pov",
        "scenes/glass.pov",           "tests/scenes/csg_prisms.pov",
        "scenes/rings.pov",           "tests/scenes/csg_lathes.pov",
        "scenes/steiner.pov",         "tests/scenes/quadratic_prism.pov",
        "tests/scenes/blobs.pov",     "tests/scenes/mesh_solids.pov",
        "tests/scenes/csg_blobs.pov", "tests/scenes/mesh_glass.pov",
        "tests/scenes/images.pov",    "tests/scenes/field_solids.pov",
        "tests/scenes/mesh.pov",
    };
    struct sink sink = stream_sink(stderr);
    SCOPED(c205_model) *model = NON_NULL(c205_model_find("cyber205-2pipe", &failure));
    report = &sink;
    for (size_t i = 0; i < COUNT(scenes); i++) {
        check(scenes[i], model, TRACE_SCALAR, VISIBLE_DEFAULT);
        check(scenes[i], model, TRACE_VECTOR, VISIBLE_DEFAULT);
        check(scenes[i], model, TRACE_VECTOR, VISIBLE_STEPPING);
        check(scenes[i], model, TRACE_VECTOR, VISIBLE_EVERY);
        check(scenes[i], model, TRACE_KERNELS, VISIBLE_DEFAULT);
    }
}
