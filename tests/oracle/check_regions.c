/* check_regions.c - compares frames of scenes with many regions in random
 * configurations.
 *
 *     check_regions [SCENES [OF SHARE]] [--first]        (many_scenes.h)
 *
 * Each random scene (random_scenes.h) is traced in vector form with every ray tested
 * against every region, in scalar form, and in some random configurations of modes,
 * queues, bounds, CSG methods, bands and jobs. All must give the same frame bit for bit
 * and trace the same rays. The plain tracer must agree within the tolerances of
 * check_scene, except for pixels where rounding decides.
 *
 * A failing scene is reduced while it fails in the same way, printed, and written to
 * regions_N.pov.
 */
#include "rt/trace/trace.h"
#include "tests/oracle/chance.h"
#include "tests/oracle/compare_pictures.h"
#include "tests/oracle/random_scenes.h"
#include "tests/oracle/plain_tracer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WAYS = 5 };

/* The fraction of pixels, plus one pixel, at which rounding may decide: on edges of
 * faces, shadows and checkers. It is larger than in check_scene for the small frame. */
#define ROUNDED .01

/* --- ways to trace -------------------------------------------------------- */

/* Tests every ray against every region, one after another. */
static const struct trace_options plainest = {
    .mode = TRACE_VECTOR, .queue = TRACE_QUEUE, .no_bounds = true, .order = ORDER_ROWS
};
static const struct trace_options serial = { .mode = TRACE_SCALAR, .queue = 1 };

static struct trace_options random_way(uint64_t *state, size_t pixels)
{
    static const size_t queues[] = { 1, 2, 7, 7, 77, 77, 77, TRACE_QUEUE };
    struct trace_options way = { .queue = queues[below(state, 8)] };
    if (one_in(state, 20))
        way.queue = MAX_TRACE_QUEUE;
    way.mode = (enum trace_mode)below(state, TRACE_MODES);
    way.no_bounds = one_in(state, 6);
    way.flat = one_in(state, 4);
    if (one_in(state, 3) && way.mode != TRACE_SCALAR)
        way.order = one_in(state, 2) ? ORDER_ROWS : ORDER_TILES;
    if (one_in(state, 4) && way.mode == TRACE_VECTOR)
        way.visible = VISIBLE_EVERY;
    way.band = one_in(state, 2) ? 0 : 1 + pixels / 5 + below(state, pixels);
    way.jobs = 1 + below(state, 2);
    return way;
}

/* Estimates the processor time on the host, in seconds. */
static double seconds_of(const struct trace_options *way, double work)
{
    if (way->mode == TRACE_SCALAR)
        return work * (way->no_bounds ? 2e-6 : 1e-6);
    return work * (2e-7 + 1e-5 / (double)way->queue);
}

static struct trace_options some_way(uint64_t *state, const struct random_scene *scene)
{
    size_t pixels = scene->width * scene->height;
    for (int i = 0; i < 100; i++) {
        struct trace_options way = random_way(state, pixels);
        if (seconds_of(&way, scene->work) < .04)
            return way;
    }
    return (struct trace_options){ .mode = TRACE_VECTOR, .queue = 77 };
}

/* --- against the plain tracer --------------------------------------------- */

static bool same_as_plain(const struct random_scene *regions, const struct scene *scene,
                          const struct trace *trace, char *reason)
{
    struct frame expected, found;
    bool good = true;
    need(plain_trace(scene, regions->width, regions->height, &expected)
         && frame_allocate(&found, regions->width, regions->height));
    trace_read(trace, 0, &found);
    FREED bool *inner = inner_pixels(&expected);
    for (size_t i = 0; good && i < WITH_FRAME; i++) {
        struct comparison comparison = with_frame[i];
        comparison.share = ROUNDED;
        if (regions->certainty < ALL_CERTAIN && comparison.first != CHANNEL_DEPTH)
            continue;
        struct picture_difference is = compare_pictures(&comparison, &expected, &found,
                                                        inner);
        good = (double)is.beyond <= 1 + comparison.share * (double)is.compared;
        snprintf(reason, MANY_REASON,
                 "the plain tracer has another %s at %zu of %zu pixels, by %g "
                 "at %zu, %zu",
                 comparison.name, is.beyond, is.compared, is.greatest, is.worst_x,
                 is.worst_y);
    }
    frame_free(&found);
    frame_free(&expected);
    return good;
}

/* ---- Scenes -------------------------------------------------------------- */

/* The configurations that must give the same frame, and whether the plain tracer must
 * agree. After a failure only the failing configuration remains. */
static struct ways {
    size_t count;
    struct trace_options way[WAYS];
    bool plain;
} ways;

static bool passes(struct random_scene *regions, char *reason)
{
    SCOPED(scene) *scene = scene_of(regions->text);
    SCOPED(trace) *expected = traced_in(scene, sized(plainest, regions->width,
                                                     regions->height));
    bool good = true;
    for (size_t i = 0; good && i < ways.count; i++)
        if (!same_in_form(scene, expected,
                          sized(ways.way[i], regions->width, regions->height),
                          reason)) {
            ways = (struct ways){ .count = 1, .way = { ways.way[i] } };
            good = false;
        }
    if (good && ways.plain && regions->certainty
        && !same_as_plain(regions, scene, expected, reason)) {
        ways.count = 0;
        good = false;
    }
    return good;
}

static struct random_scene draw(uint64_t *state, size_t number UNUSED)
{
    struct random_scene scene = many_regions(state);
    ways = (struct ways){ .count = WAYS, .way = { serial }, .plain = true };
    for (size_t i = 1; i < WAYS; i++)
        ways.way[i] = some_way(state, &scene);
    return scene;
}

RANDOM_CHECK("regions", UINT64_C(0xD1B54A32D192ED03), draw, passes, true, NULL, 0)
