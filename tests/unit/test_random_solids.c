/* test_random_solids.c - random solids of all shapes, half of them with faces that
 * coincide. The frames of all stages, with and without bounds, are compared with each
 * other and with the plain tracer. A crossing that one stage loses fails here.
 *
 *     test_random_solids [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/random_solids.h"

static size_t scene_count = 4; /* number of scenes of each kind */
static bool along;             /* rays are in faces and hit edges, so that rounding
                                * decides */

static void add_view(char *text, size_t size)
{
    along = solids.gridded && below(2);
    add_random(text, size,
               along ? "camera { location <0, 0, -^2s4:6^> " STRAIGHT_AHEAD " }\n"
                     : "camera { location <^3-2:2^, ^3-2:2^, -5> "
                       "look_at <^3-.2:.2^, ^3-.2:.2^, 0> angle 45 }\n");
}

static void write_scene(char *text, size_t size)
{
    text[0] = '\0';
    add_random(text, size,
               "#version 3.7; global_settings { assumed_gamma 1 "
               "max_trace_level 4 }\nbackground { rgb <.2, .3, .5> }\n"
               "light_source { <^1-7:7^, 8, -7>, .7 }\n"
               "light_source { <7, 3, -^22:6^>, rgb <.3, .2, .4> }\n");
    if (below(2)) {
        add_text(text, size, "sky_sphere { pigment { ");
        add_gradient(text, size);
        add_random(text, size, "scale ^3.3:2^ } rotate ^2-90:90^*x }\n");
    }
    add_view(text, size);
    for (size_t i = 1 + below(2); i > 0; i--)
        add_solid(text, size, 1 + below(2));
}

/* ---- Comparisons -------------------------------------------------------- */

/* Rounding decides which of two coincident surfaces is visible, but not its depth. */
static void check_depths(const struct scene *scene, const char *text,
                         const struct words *words)
{
    size_t others = 0;
    SCOPED_VALUE(frame) plain;
    assert_true(plain_trace(scene, WIDTH, HEIGHT, &plain));
    for (size_t k = 0; k < PIXELS; k++) {
        double found = c205_to_double(words->channel[CHANNEL_DEPTH][k]);
        double expected = plain.channel[CHANNEL_DEPTH][k];
        bool close = fabs(found - expected) <= 1e-6 * (1 + expected);
        others += close ? 0 : 1;
        FAIL_IF(others > PIXELS / 100, "pixel %zu: %.9f deep, not %.9f, in\n%s", k,
                found, expected, text);
    }
}

static void check_scenes(bool gridded, bool clear)
{
    static char text[1 << 18];
    solids.gridded = gridded;
    solids.clear = clear;
    solids.surfaces = true;
    for (size_t i = 0; i < scene_count; i++) {
        write_scene(text, sizeof text);
        SCOPED(scene) *scene = read_text(text);
        FREED struct words *words = solids.gridded ? same_frame_of(scene, text)
                                                   : plain_frame(text);
        if (solids.gridded && !along)
            check_depths(scene, text, words);
        check_paper_stage(text, words);
        traced.no_bounds = true;
        FREED struct words *others = same_frame_of(scene, text);
        traced.no_bounds = false;
        FAIL_IF(memcmp(others, words, sizeof *words) != 0,
                "another frame without bounds of\n%s", text);
    }
}

/* ---- Tests -------------------------------------------------------------- */

TEST_CALL(opaque, check_scenes(false, false))
TEST_CALL(clear, check_scenes(false, true))
TEST_CALL(coincident, check_scenes(true, false))
TEST_CALL(coincident_clear, check_scenes(true, true))

ARGUMENTS(argc, argv)
{
    traced.reported = true; /* some patches are in intersections */
    scene_count = argument(argc, argv, 1, share_of(scene_count));
    traced.random ^= argument(argc, argv, 2, 0) << 13;
}
