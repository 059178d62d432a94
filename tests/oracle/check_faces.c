/* check_faces.c - compares all forms of the tracer on solids whose faces coincide.
 *
 *     check_faces [SCENES [OF SHARE]] [--first]        (many_scenes.h)
 *
 * Each random scene (random_scenes.h) is traced in scalar form, in vector form and in
 * the form of 1984, with several queue lengths, both CSG methods, and with and without
 * bounding spheres. All frames must be equal bit for bit.
 *
 * It also fails if another order of the parts changes a depth. Depths must be equal bit
 * for bit. If faces of two regions may coincide, the order decides which face is
 * visible, and the depths need only be nearly equal. If the camera looks at faces
 * obliquely, the plain tracer must see the same objects at the same depths.
 *
 * A failing scene is reduced while it fails, printed, and written to faces_N.pov.
 */
#include "rt/layout/interiors.h"
#include "rt/trace/trace.h"
#include "tests/oracle/random_scenes.h"
#include "tests/oracle/plain_tracer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = GRID_WIDTH, HEIGHT = GRID_HEIGHT, PIXELS = WIDTH * HEIGHT };

/* ---- Forms --------------------------------------------------------------- */

/* The forms. Each form is compared with the first. */
static const struct trace_options forms[] = {
    { .mode = TRACE_SCALAR, .queue = 1 },
    { .mode = TRACE_SCALAR, .queue = 1, .flat = true },
    { .mode = TRACE_SCALAR, .queue = 1, .no_bounds = true },
    { .mode = TRACE_VECTOR, .queue = 7, .order = ORDER_TILES },
    { .mode = TRACE_VECTOR, .queue = 77, .order = ORDER_ROWS },
    { .mode = TRACE_VECTOR, .queue = 2000, .order = ORDER_TILES },
    { .mode = TRACE_VECTOR, .queue = 2000, .order = ORDER_ROWS, .flat = true },
    { .mode = TRACE_VECTOR, .queue = 77, .order = ORDER_ROWS, .no_bounds = true },
    { .mode = TRACE_VECTOR, .queue = 77, .order = ORDER_TILES },
    { .mode = TRACE_VECTOR,
      .queue = 77,
      .order = ORDER_ROWS,
      .visible = VISIBLE_EVERY },
    { .mode = TRACE_VECTOR,
      .queue = 2000,
      .no_bounds = true,
      .visible = VISIBLE_EVERY },
    { .mode = TRACE_KERNELS, .queue = 77, .order = ORDER_ROWS },
    { .mode = TRACE_KERNELS, .queue = 33, .order = ORDER_TILES },
    { .mode = TRACE_KERNELS, .queue = 2000, .order = ORDER_ROWS, .no_bounds = true },
};
enum { FORMS = sizeof forms / sizeof *forms, ANY_ORDER = 4 };

/* --- comparisons ---------------------------------------------------------- */

/* Returns the first pixel whose depth differs. If `nearly` is true, depths may differ
 * in the last bits, because the later of two coincident faces is visible. */
static size_t first_apart(const c205_word *depth, const c205_word *expected,
                          bool nearly)
{
    size_t i = 0;
    while (i < PIXELS
           && (depth[i] == expected[i]
               || (nearly
                   && fabs(c205_to_double(depth[i]) - c205_to_double(expected[i]))
                          <= 2e-7)))
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
                              const struct trace *expected, char *reason)
{
    if (!grid->other)
        return true;
    SCOPED(scene) *scene = scene_of(grid->other);
    SCOPED(trace) *trace = traced_in(scene, sized(forms[ANY_ORDER], WIDTH, HEIGHT));
    const c205_word *depth = trace_channel(trace, CHANNEL_DEPTH);
    const c205_word *first = trace_channel(expected, CHANNEL_DEPTH);
    size_t other = first_apart(depth, first, has_offsets(scene));
    if (other < PIXELS)
        snprintf(reason, MANY_REASON,
                 "parts in another order: another depth at pixel %zu", other);
    return other == PIXELS;
}

/* Returns true if two primitives belong to one region. Where opaque primitives of
 * different regions touch, rounding decides which is nearer. */
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
                       const struct trace *trace, size_t k)
{
    double depth = c205_to_double(trace_channel(trace, CHANNEL_DEPTH)[k]);
    double expected = ldexp(plain->channel[CHANNEL_DEPTH][k], -scene->unit_log);
    size_t id = (size_t)c205_to_integer(trace_channel(trace, CHANNEL_ID)[k]);
    size_t other = (size_t)plain->channel[CHANNEL_ID][k];
    return fabs(depth - expected) <= 1e-6 * (1 + depth)
           && (id == other
               || (is_opaque(scene, id) && is_opaque(scene, other)
                   && !in_one_region(scene, id, other)));
}

/* Compares a frame with the plain tracer. Up to 1 % of the pixels may differ, because
 * rounding decides at edges. */
static bool same_as_plain(const struct scene *scene, const struct trace *expected,
                          char *reason)
{
    struct frame plain;
    size_t others = 0, worst = 0;
    need(plain_trace(scene, WIDTH, HEIGHT, &plain));
    for (size_t k = 0; k < PIXELS; k++) {
        if (!same_sight(scene, &plain, expected, k)) {
            others++;
            worst = k;
        }
    }
    frame_free(&plain);
    snprintf(reason, MANY_REASON,
             "the plain tracer sees something else at %zu pixels, %zu among them",
             others, worst);
    return others <= PIXELS / 100;
}

static bool passes(struct random_scene *grid, char *reason)
{
    SCOPED(scene) *scene = scene_of(grid->text);
    SCOPED(trace) *expected = traced_in(scene, sized(forms[0], WIDTH, HEIGHT));
    bool good = true;
    for (size_t i = 1; good && i < FORMS; i++)
        good = same_in_form(scene, expected, sized(forms[i], WIDTH, HEIGHT), reason);
    good = good && same_in_any_order(grid, expected, reason)
           && (grid->certainty == NOTHING_CERTAIN
               || same_as_plain(scene, expected, reason));
    return good;
}

static struct random_scene draw(uint64_t *state, size_t number UNUSED)
{
    return grid_scene(state);
}

RANDOM_CHECK("faces", UINT64_C(0x9E3779B97F4A7C15), draw, passes, true, NULL, 0)
