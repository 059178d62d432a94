/* check_faces.c - compares all forms of the tracer on solids whose faces coincide.
 *
 *     check_faces [SCENES [OF SHARE]] [--first]
 *
 * Traces random scenes (grid_scene.h), or every OF-th of them from number SHARE on: in
 * scalar form, in vector form and in the form of 1984, with several queue lengths, with
 * both methods for the visible surface of solids, with and without bounding spheres.
 * The test fails unless all frames are equal bit for bit.
 *
 * It also fails if parts in another order change a depth.  Depths must be equal bit for
 * bit, or nearly equal if faces of two regions may coincide, because then the order
 * decides which of them is visible.  If the camera looks at faces obliquely, the plain
 * tracer must see the same objects at the same depths.
 *
 * A failing scene is reduced while it fails, printed, and written to faces_N.pov.  With
 * --first the test stops at the first failure without reducing it.  Exit status 1: a
 * scene failed.
 */
#include "rt/platform/threads.h"
#include "rt/layout/bumps.h"
#include "rt/layout/interiors.h"
#include "rt/layout/lights.h"
#include "rt/layout/program.h"
#include "rt/layout/trees.h"
#include "rt/trace/trace.h"
#include "tests/oracle/grid_scene.h"
#include "tests/oracle/many_scenes.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = GRID_WIDTH,
    HEIGHT = GRID_HEIGHT,
    PIXELS = WIDTH * HEIGHT,
    WORDS = FRAME_CHANNELS * PIXELS
};

/* ---- Forms --------------------------------------------------------------- */

static bool is_orthographic(const struct scene *scene)
{
    return scene->camera.orthographic;
}

static bool has_kind(const struct scene *scene, enum primitive_kind kind)
{
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (scene->primitives[i].kind == kind)
            return true;
    return false;
}

static bool has_lathes(const struct scene *scene)
{
    return has_kind(scene, PRIMITIVE_LATHE);
}

static bool has_quadratic_prisms(const struct scene *scene)
{
    return has_kind(scene, PRIMITIVE_QUADRATIC_PRISM);
}

/* A feature of a scene that needs code in the program, and a text that has it. */
static const struct feature {
    bool (*is_in)(const struct scene *scene);
    const char *text;
} features[] = {
    { is_orthographic, "camera { orthographic }" },
    { scene_has_beams, "light_source { y, 1 parallel }" },
    { scene_has_areas, "light_source { y, 1 area_light x, z, 2, 2 }" },
    { has_lathes, "lathe { 2, x, x + y }" },
    { has_quadratic_prisms, "prism { quadratic_spline 0, 1, 5, 0, x, y, 0, x }" },
    { scene_has_bumps, "sphere { 0, 1 normal { onion } }" },
    { scene_has_interiors, "sphere { 0, 1 pigment { rgbt 1 } }" },
    { scene_has_crossed_meshes, "merge { triangle { 0, x, y } sphere { 0, 1 } }" },
};
enum { FEATURES = sizeof features / sizeof *features, FEATURE_SETS = 1 << FEATURES };

/* The forms; each is compared with the first one. */
static struct form {
    enum trace_mode mode;
    size_t queue;
    enum bounding bounding;
    enum visible visible;
    bool tiles;
    struct trace *trace[FEATURE_SETS]; /* programs for each set of features */
    struct band_tracer tracer;         /* contains their machine */
} forms[] = {
    { .mode = TRACE_SCALAR, .queue = 1 },
    { .mode = TRACE_SCALAR, .queue = 1, .bounding = BOUNDING_FLAT },
    { .mode = TRACE_SCALAR, .queue = 1, .bounding = BOUNDING_NONE },
    { .mode = TRACE_VECTOR, .queue = 7, .tiles = true },
    { .mode = TRACE_VECTOR, .queue = 77 },
    { .mode = TRACE_VECTOR, .queue = 2000, .tiles = true },
    { .mode = TRACE_VECTOR, .queue = 2000, .bounding = BOUNDING_FLAT },
    { .mode = TRACE_VECTOR, .queue = 77, .bounding = BOUNDING_NONE },
    { .mode = TRACE_VECTOR, .queue = 77, .tiles = true },
    { .mode = TRACE_VECTOR, .queue = 77, .visible = VISIBLE_EVERY },
    { .mode = TRACE_VECTOR,
      .queue = 2000,
      .bounding = BOUNDING_NONE,
      .visible = VISIBLE_EVERY },
    { .mode = TRACE_KERNELS, .queue = 77 },
    { .mode = TRACE_KERNELS, .queue = 33, .tiles = true },
    { .mode = TRACE_KERNELS, .queue = 2000, .bounding = BOUNDING_NONE },
};
enum { FORMS = sizeof forms / sizeof *forms, ANY_ORDER = 4 };

/* Returns a bit for each feature of the scene. */
static size_t features_of(const struct scene *scene)
{
    size_t set = 0;
    for (size_t i = 0; i < FEATURES; i++)
        set |= (size_t)features[i].is_in(scene) << i;
    return set;
}

/* Assembles a program once for all scenes with the same features. */
static struct trace *assemble(const struct form *form, size_t set)
{
    char text[50 * FEATURES] = "";
    for (size_t i = 0; i < FEATURES; i++)
        if (set >> i & 1)
            strcat(text, features[i].text);
    struct scene *scene = scene_of(text);
    const struct trace_options options = { .mode = form->mode,
                                           .queue = form->queue,
                                           .visible = form->visible,
                                           .width = WIDTH,
                                           .height = HEIGHT,
                                           .model = check_model };
    c205_error error;
    struct trace *trace = trace_new(scene, &options, &error);
    if (!trace)
        give_up(error.message);
    scene_free(scene);
    return trace;
}

static const struct object *program_for(struct form *form, const struct scene *scene)
{
    struct trace **trace = &form->trace[features_of(scene)];
    if (!*trace)
        *trace = assemble(form, features_of(scene));
    return trace_program(*trace);
}

static void free_forms(void)
{
    for (size_t i = 0; i < FORMS; i++) {
        for (size_t k = 0; k < FEATURE_SETS; k++)
            trace_free(forms[i].trace[k]);
        c205_free(forms[i].tracer.machine);
    }
}

static void trace_form(struct form *form, const struct scene *scene,
                       c205_word words[WORDS])
{
    c205_error error;
    const struct object *program = program_for(form, scene);
    struct scene_layout *layout = layout_new(program, scene, form->bounding, NULL, NULL,
                                             &error);
    const struct band_work work = { .program = program,
                                    .layout = layout,
                                    .model = check_model,
                                    .width = WIDTH,
                                    .height = HEIGHT,
                                    .tiles = form->tiles,
                                    .rays_a_call = form->queue };
    struct band band = { .rows = HEIGHT };
    bool stopped;
    form->tracer.work = &work;
    form->tracer.lock = lock_new();
    if (!layout || !form->tracer.lock
        || !band_trace(&form->tracer, &band, NULL, &stopped, &error))
        give_up(error.message);
    lock_free(form->tracer.lock);
    memcpy(words, band.words, WORDS * sizeof *words);
    band_free(&band);
    layout_free(layout);
}

/* ---- Comparisons --------------------------------------------------------- */

static size_t first_other(const c205_word *words, const c205_word *expected,
                          size_t count)
{
    size_t i = 0;
    while (i < count && words[i] == expected[i])
        i++;
    return i;
}

static const char *const options[] = {
    [BOUNDING_NONE] = " --no-bounds",
    [BOUNDING_FLAT] = " --flat",
    [BOUNDING_HIERARCHY] = "",
};

static bool same_in_all_forms(const struct scene *scene, const c205_word *expected,
                              char *reason)
{
    static c205_word words[WORDS];
    for (size_t i = 1; i < FORMS; i++) {
        struct form *form = &forms[i];
        trace_form(form, scene, words);
        size_t other = first_other(words, expected, WORDS);
        if (other < WORDS) {
            snprintf(reason, MANY_REASON,
                     "--mode %s --queue %zu%s%s%s: another frame than "
                     "--mode scalar, channel %zu, pixel %zu",
                     trace_mode_name(form->mode), form->queue,
                     form->tiles ? " --order tiles" : "", options[form->bounding],
                     form->visible == VISIBLE_EVERY ? " --visible every" : "",
                     other / PIXELS, other % PIXELS);
            return false;
        }
    }
    return true;
}

/* Compares depths with a tolerance: of two coincident faces the later one is visible,
 * and their depths may differ in the last bits. */
static size_t first_apart(const c205_word *depth, const c205_word *expected)
{
    size_t i = 0;
    while (i < PIXELS
           && fabs(c205_to_double(depth[i]) - c205_to_double(expected[i])) <= 2e-7)
        i++;
    return i;
}

static bool has_offsets(const struct scene *scene)
{
    for (size_t i = 0; i < scene->region_count; i++)
        if (scene->regions[i].yield > 0)
            return true;
    return scene_has_interiors(scene);
}

static bool same_in_any_order(const struct random_scene *grid,
                              const c205_word *expected, char *reason)
{
    static c205_word words[WORDS];
    if (!grid->other)
        return true;
    struct scene *scene = scene_of(grid->other);
    trace_form(&forms[ANY_ORDER], scene, words);
    size_t depth = (size_t)CHANNEL_DEPTH * PIXELS;
    size_t other = has_offsets(scene)
                       ? first_apart(words + depth, expected + depth)
                       : first_other(words + depth, expected + depth, PIXELS);
    if (other < PIXELS)
        snprintf(reason, MANY_REASON,
                 "parts in another order: another depth at pixel %zu", other);
    scene_free(scene);
    return other == PIXELS;
}

/* Where two opaque regions touch, rounding decides which is nearer and thus visible. */
static bool in_one_region(const struct scene *scene, size_t id, size_t other)
{
    for (size_t i = 0; i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        size_t first = region->first_primitive;
        size_t last = first + region->primitive_count;
        if (id > first && id <= last)
            return other > first && other <= last;
    }
    return false;
}

static bool is_opaque(const struct scene *scene, size_t id)
{
    return id > 0 && !pigment_is_clear(&scene->primitives[id - 1].pigment);
}

static bool same_sight(const struct scene *scene, const struct frame *plain,
                       const c205_word *words, size_t k)
{
    double depth = c205_to_double(words[CHANNEL_DEPTH * PIXELS + k]);
    double expected = ldexp(plain->channel[CHANNEL_DEPTH][k], -scene->unit_log);
    size_t id = (size_t)c205_to_integer(words[CHANNEL_ID * PIXELS + k]);
    size_t other = (size_t)plain->channel[CHANNEL_ID][k];
    return fabs(depth - expected) <= 1e-6 * (1 + depth)
           && (id == other
               || (is_opaque(scene, id) && is_opaque(scene, other)
                   && !in_one_region(scene, id, other)));
}

/* Allows 1 % of different pixels: rounding decides at edges and outlines. */
static bool same_as_plain(const struct scene *scene, const c205_word *expected,
                          char *reason)
{
    struct frame plain;
    size_t others = 0, worst = 0;
    if (!plain_trace(scene, WIDTH, HEIGHT, &plain))
        give_up("out of memory");
    for (size_t k = 0; k < PIXELS; k++) {
        if (!same_sight(scene, &plain, expected, k)) {
            others++;
            worst = k;
        }
    }
    frame_free(&plain);
    snprintf(reason, MANY_REASON,
             "the plain tracer sees something else at %zu pixels, %zu among "
             "them",
             others, worst);
    return others <= PIXELS / 100;
}

static bool passes(struct random_scene *grid, char *reason)
{
    static c205_word expected[WORDS];
    struct scene *scene = scene_of(grid->text);
    trace_form(&forms[0], scene, expected);
    bool good = same_in_all_forms(scene, expected, reason)
                && same_in_any_order(grid, expected, reason)
                && (grid->certainty == NOTHING_CERTAIN
                    || same_as_plain(scene, expected, reason));
    scene_free(scene);
    return good;
}

static struct random_scene draw(uint64_t *state, size_t number)
{
    (void)number;
    return grid_scene(state);
}

int main(int count, char **words)
{
    static const struct random_check check = {
        "faces", UINT64_C(0x9E3779B97F4A7C15), draw, passes, true, NULL, 0
    };
    int code = check_random(count, words, &check);
    free_forms();
    return code;
}
