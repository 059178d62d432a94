/* test_traced_solids.c - nested solids, shadows, mirrors and glass in random scenes.
 * The frames of the three stages are compared with each other and with the plain
 * tracer. A ray that one stage loses fails here. */
#define SMALL_FRAMES
#include "tests/unit/random_solids.h"

static void write_scene(char *text, size_t size, size_t count)
{
    text[0] = '\0';
    add_text(text, size,
             "#version 3.7; global_settings { assumed_gamma 1 "
             "max_trace_level %d }\nbackground { rgb <.2, .3, .5> }\n"
             "camera { location <0, 1, -6> look_at 0 angle 50 }\n"
             "light_source { <-6, 8, -7>, .7 }\n"
             "light_source { <7, 3, -4>, rgb <.3, .2, .4> }\n"
             "plane { y, -2.5 pigment { checker rgb .9 rgb .4 } }\n",
             solids.clear ? 6 : 1);
    for (size_t i = 0; i < count; i++) {
        add_text(text, size, "intersection { sphere { 0, 1.6 ");
        add_look(text, size);
        add_text(text, size, "}\n");
        add_solid(text, size, 2);
        if (solids.clear)
            add_random(text, size, "interior { ior ^21:1.6^ } ");
        add_random(text, size, "translate <^2-2:2^, ^2-1:1^, ^2-1:1^> }\n");
    }
}

/* ---- Tests -------------------------------------------------------------- */

static void check_scenes(bool clear)
{
    static char text[65536];
    solids.clear = clear;
    for (size_t i = 0; i < 10; i++) {
        write_scene(text, sizeof text, 3);
        FREED struct words *words = plain_frame(text);
        check_paper_stage(text, words);
    }
}

TEST_CALL(opaque, check_scenes(false))
TEST_CALL(clear, check_scenes(true))

/* Solids with each kind of shape. */
TEST(shapes)
{
    traced.reported = true;
    for (size_t kind = 0; kind < PRIMITIVE_KINDS; kind++)
        check_solids_with(random_shapes[kind]);
    traced.reported = false;
}

/* The CSG method of the vector form must not change the frame. */
static void check_every(const char *text)
{
    static const size_t queues[] = QUEUES;
    SCOPED(scene) *scene = read_text(text);
    for (size_t i = 0; i < COUNT(queues); i++) {
        traced.visible = VISIBLE_STEPPING;
        FREED struct words *expected = trace_words(scene, TRACE_VECTOR, queues[i]);
        traced.visible = VISIBLE_EVERY;
        FREED struct words *found = trace_words(scene, TRACE_VECTOR, queues[i]);
        traced.visible = VISIBLE_DEFAULT;
        FAIL_IF(memcmp(found, expected, sizeof *found) != 0,
                "queue %zu, every crossing: another frame of\n%s", queues[i], text);
    }
}

/* Surfaces that coincide exactly or nearly, and patches among solids. */
static const char coincident[] = HEAD
    "camera { location <0, 1, -6> look_at 0 angle 30 }\n"
    "difference { box { -1, 1 } box { -1, <0, 1, 1> } "
    "sphere { 0, .9 } sphere { 0, .9 } pigment { rgb .8 } }\n"
    "difference { merge { cylinder { -y, y, .5 } cylinder { -y, y, .5 } "
    "box { -.4, .4 } } plane { y, 1e-8 } translate 1.7*x }\n";
static const char patches[] = HEAD
    "camera { location <0, 1, -6> look_at 0 angle 30 }\n"
    "#declare Leaf = steiner_patch { <-1.2, .6, -.8>, <0, .9, 1.2>, "
    "<1.2, .3, -.7>, <-1, 1.6, .2>, <1, 1.4, .4>, <0, -.4, -1.2> }\n"
    "merge { object { Leaf } sphere { .5*y, .5 } object { Leaf } "
    "box { <-.5, 0, -.5>, <.5, .9, .5> } pigment { rgb .8 } }\n";

TEST(every)
{
    static char text[65536];
    check_every(coincident);
    check_every(patches);
    for (int i = 0; i < 8; i++) {
        solids.clear = i % 2;
        solids.gridded = i % 4 >= 2;
        write_scene(text, sizeof text, 3);
        check_every(text);
    }
}

/* There are more nested bodies than can be stored, more panes than rays in a chain, and
 * more reflections than levels with a significant weight. */
TEST(limits_of_rays)
{
    static const char *const texts[] = {
        AHEAD "global_settings { max_trace_level 60 }\n"
              "#for (I, 1, 14) sphere { .01*I*x, .5 + I/30\n"
              "    pigment { rgbt <.1, .1, 0, .9> }\n"
              "    interior { ior 1 + .02*I } } #end",
        AHEAD "global_settings { max_trace_level 3 adc_bailout 0 }\n"
              "#for (I, 1, 80) box { <-2, -2, I/9>, <2, 2, I/9 + .04>\n"
              "    pigment { rgbt <.1, .1, 0, .99> } } #end",
        AHEAD "global_settings { max_trace_level 4 adc_bailout -2 }\n"
              "sphere { 0, 1 pigment { rgbt <.1, .2, .3, .5> }\n"
              "    finish { reflection .6 } interior { ior 1.3 } }",
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        FREED struct words *frame = same_frame(texts[i]);
        check_paper_stage(texts[i], frame);
    }
}
