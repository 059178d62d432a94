/* check_coincident.c - compares frames of bodies with coincident faces in all forms,
 * and with two other tracers.
 *
 *     check_coincident [SCENES [OF SHARE]] [--first]        (many_scenes.h)
 *
 * All forms must give the same frame of a random scene (random_scenes.h) bit for bit,
 * and the plain tracer at all pixels that are not on outlines. POV-Ray loses one of two
 * coincident faces, so it draws the scene with a ground that is higher by LIFT. Scenes
 * of other bodies are not compared with POV-Ray. A failing scene is printed and written
 * to coincident_N.pov.
 */
#include "rt/trace/trace.h"
#include "tests/oracle/chance.h"
#include "tests/oracle/compare_pictures.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/oracle/run_povray.h"
#include "tests/oracle/random_scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = COINCIDENT_WIDTH,
    HEIGHT = COINCIDENT_HEIGHT,
    PIXELS = WIDTH * HEIGHT,
    AHEAD = 4,
    PATH = 80
};

/* The height by which the ground is raised. The image of the ground, seen through a
 * body, moves by about the same distance. */
#define LIFT 1e-5

/* At edges that are seen through a body, the raised ground can decide what is visible.
 * Therefore POV-Ray's picture may differ from both other tracers at some pixels. */
static const struct comparison with_povray = { "colour", CHANNEL_RED, 3,  1,
                                               false,    1e-3,        .01 };

#define SEED UINT64_C(0x9E3779B97F4A7C15)

static uint64_t seed_of(size_t number)
{
    return RANDOM_SEED ^ (number + 1) * SEED;
}

/* ---- Forms --------------------------------------------------------------- */

/* The forms. Each form is compared with the first. */
static const struct trace_options forms[] = {
    { .mode = TRACE_SCALAR, .queue = 1 },
    { .mode = TRACE_SCALAR, .queue = 1, .no_bounds = true },
    { .mode = TRACE_VECTOR, .queue = TRACE_QUEUE },
    { .mode = TRACE_VECTOR, .queue = 7, .flat = true },
    { .mode = TRACE_VECTOR, .queue = 77, .visible = VISIBLE_EVERY },
    { .mode = TRACE_VECTOR, .queue = 333, .no_bounds = true },
    { .mode = TRACE_KERNELS, .queue = 77 },
};
enum { FORMS = sizeof forms / sizeof *forms };

/* --- Comparison with the plain tracer and POV-Ray ------------------------- */

static bool same_pictures(const struct comparison *comparison, const char *who,
                          const struct frame *expected, const struct frame *ours,
                          const bool *inner, char *reason)
{
    struct picture_difference is = compare_pictures(comparison, expected, ours, inner);
    snprintf(reason, MANY_REASON,
             "%s has another %s at %zu of %zu pixels, by %g at %zu, %zu", who,
             comparison->name, is.beyond, is.compared, is.greatest, is.worst_x,
             is.worst_y);
    return (double)is.beyond <= comparison->share * (double)is.compared;
}

/* Compares the frame with the frame of the plain tracer. No inner pixel may differ. */
static bool same_as_plain(const struct frame *plain, const struct frame *ours,
                          const bool *inner, char *reason)
{
    bool good = true;
    for (size_t i = 0; good && i < WITH_FRAME; i++) {
        struct comparison comparison = with_frame[i];
        comparison.share = 0;
        good = same_pictures(&comparison, "the plain tracer", plain, ours, inner,
                             reason);
    }
    return good;
}

/* A queue of running POV-Ray processes in a ring buffer. */
static struct povray *runs[AHEAD + 1];
static size_t begun, ended;

static void begin(size_t number)
{
    char path[PATH];
    if (coincident_scene_kind(seed_of(number)) != COINCIDENT_CLEAR)
        return;
    FREED char *text = coincident_scene_text(seed_of(number), LIFT);
    snprintf(path, PATH, "coincident_%zu_lifted.pov", number);
    runs[begun++ % (AHEAD + 1)] = povray_begin(path, text, WIDTH, HEIGHT);
}

static bool same_as_povray(size_t number, const struct frame *ours, const bool *inner,
                           char *reason)
{
    c205_error error;
    struct frame theirs;
    if (coincident_scene_kind(seed_of(number)) != COINCIDENT_CLEAR)
        return true;
    if (!povray_end(runs[ended++ % (AHEAD + 1)], &theirs, &error))
        give_up(error.message);
    bool good = same_pictures(&with_povray, "POV-Ray", &theirs, ours, inner, reason);
    frame_free(&theirs);
    return good;
}

/* ---- Scenes -------------------------------------------------------------- */

static bool same_as_others(const struct scene *scene, const struct trace *trace,
                           size_t number, char *reason)
{
    struct frame plain, ours;
    char also[MANY_REASON];
    if (!plain_trace(scene, WIDTH, HEIGHT, &plain)
        || !frame_allocate(&ours, WIDTH, HEIGHT))
        give_up("out of memory");
    trace_read(trace, 0, &ours);
    FREED bool *inner = inner_pixels(&plain);
    bool good = same_as_plain(&plain, &ours, inner, reason);
    bool by_povray = same_as_povray(number, &ours, inner, also);
    if (good)
        strcpy(reason, also);
    frame_free(&plain);
    frame_free(&ours);
    return good && by_povray;
}

static struct random_scene draw(uint64_t *state, size_t number UNUSED)
{
    return (struct random_scene){ .text = coincident_scene_text(*state, 0),
                                  .width = WIDTH,
                                  .height = HEIGHT };
}

static bool passes(struct random_scene *drawn, char *reason)
{
    SCOPED(scene) *scene = scene_of(drawn->text);
    SCOPED(trace) *expected = traced_in(scene, sized(forms[0], WIDTH, HEIGHT));
    bool good = same_as_others(scene, expected, drawn->number, reason);
    for (size_t i = 1; good && i < FORMS; i++)
        good = same_in_form(scene, expected, sized(forms[i], WIDTH, HEIGHT), reason);
    return good;
}

int main(int count, char **words)
{
    static const struct random_check check = { "coincident", SEED,  draw, passes,
                                               false,        begin, AHEAD };
    return check_random(count, words, &check);
}
