/* test_coincident_faces.c - faces that coincide or nearly coincide, and rays in a face.
 * The frames of all stages are compared with each other and with the rules of
 * docs/solids.md. A face that differs between stages, or a missed event, fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

/* The middle ray follows the z axis from z = -5. A light is also on the axis. */
#define VIEW STRAIGHT "light_source { -4.5*z, .5 }\n"

static struct words *frame_of_all(const char *text)
{
    SCOPED(scene) *scene = read_text(text);
    struct words *words = same_frame_of(scene, text);
    traced.visible = VISIBLE_STEPPING;
    FREED struct words *stepping = trace_words(scene, TRACE_VECTOR, WIDTH);
    traced.visible = VISIBLE_EVERY;
    FREED struct words *every = trace_words(scene, TRACE_VECTOR, WIDTH);
    traced.visible = VISIBLE_DEFAULT;
    FAIL_IF(memcmp(stepping, words, sizeof *stepping) != 0
                || memcmp(every, words, sizeof *every) != 0,
            "another way to the nearest gives another frame of\n%s", text);
    check_paper_stage(text, words);
    return words;
}

/* Boxes above and below y = 0, from z = -1 to 1. */
#define ABOVE "box { <-1, 0, -1>, 1 } "
#define BELOW "box { -1, <1, 0, 1> } "

/* A thin box, and a box beside the ray with a face that coincides with its face. */
#define THIN "box { <-1, -1, 0>, <1, 1, 5e-8> } "
#define CORNER "box { <.5, .5, 0>, 1 } "

/* A box with a floor that has the given slope along z. If the ray crosses the floor, it
 * is above the floor from z = 0 on, or up to z = 0. */
#define SLANTED(slope) \
    "box { <-1, 0, -2>, 2 matrix <1, 0, 0, 0, 1, 0, 0, " slope ", 1, " \
    "0, 0, 0> } "

/* The hit of the middle ray: the primitive from 1 (0: none), and the distance. */
static const struct {
    const char *text;
    int64_t id;
    double depth;
} sights[] = {
    /* Faces that coincide. k_delta is between 5e-8 and 2e-7: faces at a distance of
     * 5e-8 coincide, faces at a distance of 2e-7 do not. */
    { "difference { box { -1, 1 } box { -1, 1 } }", 0, 0 },
    { "difference { box { -1, 1 } box { -1, <1, 1, 0> } }", 2, 5 },
    { "difference { box { -1, 1 } box { -1.00000005, <1, 1, 0> } }", 2, 5 },
    { "difference { box { -1, 1 } box { -.99999995, <1, 1, 0> } }", 2, 5 },
    { "difference { box { -1, 1 } box { -.9999998, <1, 1, 0> } }", 1, 4 },
    { "difference { box { -1, 1 } box { -2, <1, 1, .99999995> } }", 0, 0 },
    { "difference { box { -1, 1 } box { -2, <1, 1, .9999998> } }", 2, 5.9999998 },
    { "intersection { box { -1, 1 } box { <-1, -1, 1>, 3 } }", 0, 0 },
    { "intersection { box { -1, 1 } box { <-1, -1, .99999995>, 3 } }", 0, 0 },
    { "intersection { box { -1, 1 } box { <-1, -1, .9999998>, 3 } }", 2, 5.9999998 },
    { "difference { box { -3, 3 } merge { box { -6, <1, 1, 0> } "
      "box { <-1, -1, 5e-8>, 1 } } }",
      3, 6 },
    { "difference { box { -3, 3 } merge { box { -6, <1, 1, 0> } "
      "box { <-1, -1, 2e-7>, 1 } } }",
      2, 5 },

    /* An object that is thinner than k_delta is seen, also if it has a yield. */
    { THIN, 1, 5 },
    { CORNER THIN, 2, 5 },
    { THIN CORNER, 1, 5 },

    /* Rays in a face of a single object. */
    { ABOVE, 1, 4 },
    { BELOW, 1, 4 },
    { "box { <0, 0, -1>, 1 }", 1, 4 }, /* an edge of the box */
    { "box { <-1, 1e-9, -1>, 1 }", 0, 0 },
    { "box { -1, <1, -1e-9, 1> }", 0, 0 },
    { "cylinder { -y, 0, 1 }", 1, 4 },
    { "cylinder { <0, 1, -1>, <0, 1, 1>, 1 }", 1, 4 },
    { "cone { -y, 1, 0, .5 }", 1, 4.5 },
    /* rays along a line of the cone's side */
    { "cone { <1, .5, -4>, 0, <1, .625, -4>, 1 }", 0, 0 },
    { "plane { y, 0 }", 0, 0 }, /* the ray never enters */
    { "plane { -y, 0 }", 0, 0 },

    /* A face that two parts share belongs to both parts. */
    { "intersection { " ABOVE "box { <-1, -1, 0>, 2 } }", 2, 5 },
    { "intersection { " ABOVE BELOW "}", 1, 4 },
    { "intersection { " ABOVE "box { <-1, -1, -.5>, <1, 0, 2> } }", 2, 4.5 },
    { "intersection { plane { y, 0 } box { -1, 1 } }", 2, 4 },
    { "intersection { plane { -y, 0 } box { -1, 1 } }", 2, 4 },
    { "intersection { plane { y, 0 } plane { -y, 0 } box { -1, 1 } }", 3, 4 },
    { "intersection { plane { y, -1e-9 } box { -1, 1 } }", 0, 0 },
    { "intersection { cylinder { -y, 0, 1 } box { -.5, 1 } }", 2, 4.5 },

    /* A subtracted part removes the faces that coincide with its faces. */
    { "difference { " ABOVE "box { <-.5, -1, -2>, <.5, 1, .5> } }", 2, 5.5 },
    { "difference { box { -1, 1 } box { <-.5, 0, -2>, <.5, 2, .5> } }", 2, 5.5 },
    { "difference { box { -1, 1 } box { <-.5, -2, -2>, <.5, 0, .5> } }", 2, 5.5 },
    { "difference { " ABOVE "box { <-1, -1, -2>, <1, 0, .5> } }", 2, 5.5 },
    { "difference { " BELOW "box { <-.5, -1, -2>, <.5, 0, .5> } }", 2, 5.5 },
    { "difference { " BELOW "box { <-.5, -1, 0>, <.5, 0, 2> } }", 1, 4 },
    { "difference { " ABOVE BELOW "}", 0, 0 },
    { "difference { box { -1, 1 } plane { y, 0 } }", 0, 0 },
    { "difference { box { -1, 1 } plane { -y, 0 } }", 0, 0 },
    { "difference { box { -1, 1 } plane { y, -1e-9 } }", 1, 4 },
    { "intersection { box { -1, 1 } box { <-.5, 0, -2>, <.5, 2, .5> inverse } }", 2,
      5.5 },
    { "difference { box { <-9, 0, -1>, 9 } merge { sphere { 5*x, .2 } "
      "box { <-.5, -1, -2>, <.5, 0, .5> } } }",
      3, 5.5 },

    /* Merged parts. */
    { "merge { " ABOVE "box { <-1, -1, -2>, <1, 0, .5> } }", 2, 3 },
    { "merge { " ABOVE "plane { y, 0 } }", 0, 0 }, /* the ray is always inside */
    { "difference { box { -2, 2 } merge { " ABOVE
      "box { <-1, -1, -3>, <1, 0, -.5> } } }",
      2, 6 },

    /* A ray whose slope is below k_tiny counts as parallel. Its origin decides. */
    { SLANTED("1e-11"), 1, 3 },
    { SLANTED("-1e-11"), 1, 5 },
    { SLANTED("1e-13"), 1, 3 },
    { SLANTED("-1e-13"), 0, 0 },
    { "intersection { " SLANTED("1e-11") "plane { -z, -1 } }", 0, 0 },
    { "intersection { " SLANTED("-1e-11") "plane { -z, -1 } }", 2, 6 },
    { "intersection { " SLANTED("1e-13") "plane { -z, -1 } }", 2, 6 },
    { "intersection { " SLANTED("-1e-13") "plane { -z, -1 } }", 0, 0 },
    { "difference { box { <-.5, -1, -1>, 1 } " SLANTED("1e-11") "}", 2, 5 },
    { "difference { box { <-.5, -1, -1>, 1 } " SLANTED("-1e-11") "}", 1, 4 },
    { "difference { box { <-.5, -1, -1>, 1 } " SLANTED("1e-13") "}", 0, 0 },
    { "difference { box { <-.5, -1, -1>, 1 } " SLANTED("-1e-13") "}", 1, 4 },
    { "intersection { plane { <0, 1, 1e-11>, 0 } box { -1, 1 } }", 2, 4 },
    { "intersection { plane { <0, 1, -1e-11>, 0 } box { -1, 1 } }", 1, 5 },
    { "intersection { plane { <0, 1, 1e-13>, 0 } box { -1, 1 } }", 2, 4 },
    { "intersection { plane { <0, 1, -1e-13>, 0 } box { -1, 1 } }", 0, 0 },
    { "difference { box { -1, 1 } plane { <0, 1, 1e-11>, 0 } }", 2, 5 },
    { "difference { box { -1, 1 } plane { <0, 1, 1e-13>, 0 } }", 0, 0 },
};

TEST(sights)
{
    for (size_t i = 0; i < COUNT(sights); i++) {
        size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
        const char *text = formatted(VIEW "%s", sights[i].text);
        FREED struct words *bounded = frame_of_all(text);
        traced.no_bounds = true;
        FREED struct words *words = frame_of_all(text);
        traced.no_bounds = false;
        FAIL_IF(memcmp(bounded, words, sizeof *words) != 0,
                "bounds change the frame of\n%s", text);
        int64_t id = c205_to_integer(words->channel[CHANNEL_ID][middle]);
        double depth = c205_to_double(words->channel[CHANNEL_DEPTH][middle]);
        FAIL_IF(id != sights[i].id || !(fabs(depth - sights[i].depth) <= 1e-10),
                "%s: primitive %lld at %.12g", sights[i].text, (long long)id, depth);
    }
}
