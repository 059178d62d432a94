/* test_patch_crossings.c - patches that are in trees or are transparent are compared
 * with the plain tracer in all stages. If the nearest crossing is cut away or transmits
 * light, the next crossing is visible. A crossing that is lost, or written outside of
 * its area of memory, fails here. */
#define SMALL_FRAMES
#include "rt/layout/program.h"
#include "rt/layout/trees.h"
#include "tests/unit/traced_frame.h"

#define BENT \
    "steiner_patch { <-1, 0, 0>, <0, 2, 0>, <1, 0, 0>, <-1, 1, -.2238>," \
    " <1, 1, .4063>, <0, -.5, -.7516> "
#define WEIGHTS "weights 1, 1, 1, 1.2, .5, 1 "
#define ABOUT "scale <.75, 1.18, 1.37> translate <-.337, -.273, -.257> "

/* A plane across the ray from the camera cuts the patch. */
#define CUT \
    "#version 3.7; global_settings { assumed_gamma 1 }\n" \
    "light_source { <9, 3, -3>, 1 shadowless }\n" \
    "camera { location <7, 3, -3> look_at <-.433, .05, -.548> angle 3 }\n"
#define AWAY "plane { <.8, .6, 0>, -.4 }"

#define GLASS "pigment { rgbft <.2, .8, .5, .4, .1> } "

/* A patch with two sheets is in front of other objects. */
#define SHEETS \
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 }\n" \
    "background { rgb <.2, .3, .5> } light_source { <-1.9, 8, -7>, .7 }\n" \
    "light_source { <7, 3, -3>, rgb <.3, .2, .4> }\n" \
    "camera { location <-.637, -1.652, -5> look_at <-.06, -.116, 0>" \
    " angle 30 }\n" \
    "plane { <.6, -.68, -.75>, -.06 pigment { checker rgb .9 rgb .4 } }\n"

static void check_stages(const char *text)
{
    FREED struct words *words = plain_frame(text);
    assert_true(hits(words) > 0);
    check_paper_stage(text, words);
}

TEST(holes_in_solids)
{
    check_stages(CUT "intersection { " BENT ABOUT "} " AWAY " }");
    check_stages(CUT "intersection { " BENT WEIGHTS ABOUT "} " AWAY " }");
    check_stages(CUT "intersection { " AWAY " merge { box { -9, -8 } " BENT "} " ABOUT
                     "} }");
    check_stages(CUT "difference { " BENT ABOUT "} " AWAY " sphere { 0, .6 } }");
}

TEST(shadows_and_glass)
{
    check_stages(SHEETS BENT GLASS ABOUT "}");
    check_stages(SHEETS BENT WEIGHTS GLASS ABOUT "}");
    check_stages(SHEETS "merge { " BENT GLASS "} sphere { .5*y, .3 " GLASS "} " ABOUT
                        "}");
    /* only a few rays come near the patch */
    check_stages(SHEETS "merge { " BENT GLASS "scale .3 } sphere { -2*z, .3 " GLASS
                        "} torus { 2, .1 rotate 60*x } " ABOUT "}");
    check_stages(SHEETS "intersection { " BENT WEIGHTS "} sphere { 0, 1.2 }"
                        " no_shadow " ABOUT "}");
}

/* Rays in the planes of curves s = const. They cross the patch twice. */
TEST(pairs_of_lines)
{
    static const char *const turns[] = { "", "rotate 120*z", "rotate 90*y",
                                         "rotate <30, 0, 90>" };
    for (size_t i = 0; i < COUNT(turns); i++) {
        char text[1024] = "";
        add_text(text, sizeof text,
                 "%sintersection { plane { -z, .3 }"
                 " steiner_patch { <2, 0, 1>, <0, 2, 1>, 0, <1, 1, 0>, <0, 1, -1>,"
                 " <1, 0, -1> translate <-.5, -.5, 0> %s } }",
                 STRAIGHT, turns[i]);
        check_stages(text);
    }
}

/* A plane cuts each patch. The second patch is transparent. */
TEST(random_patches)
{
    for (int i = 0; i < 6; i++) {
        char text[4096] = HEAD "light_source { <3, 9, -6>, .5 }\n"
                               "camera { location <0, 1, -7> look_at 0 angle 50 }\n"
                               "plane { z, 4 pigment { checker rgb .9 rgb .4 } }\n";
        for (int k = 0; k < 2; k++) {
            add_text(text, sizeof text, "intersection { ");
            add_steiner_patch(text, sizeof text, 3);
            add_text(text, sizeof text, " } plane { ");
            add_point(text, sizeof text, 1);
            add_text(text, sizeof text, ", %.3f } %s }\n", between(-.3, .6),
                     k ? GLASS : "pigment { rgb .8 }");
        }
        check_stages(text);
    }
}

/* Fails unless the words after the crossings of all regions, the first data of a scene,
 * are zeros. */
static void check_behind_crossings(const struct scene *scene, const struct trace *trace,
                                   c205 *machine, const char *text)
{
    const struct object *program = trace_program(trace);
    FREED struct leaf_plan *plans = NON_NULL(
        calloc(scene->primitive_count, sizeof *plans));
    uint64_t at = program_round_up(program_end(program));
    at += UINT64_C(64) * plan_leaves(scene, plans)
          * (uint64_t)object_symbol(program, "CROSSING_SIZE")->value;
    uint64_t end = program_round_up(at);
    assert_true(at < end);
    for (c205_word word; at < end; at += 64) {
        assert_true(c205_read(machine, at, &word, 1));
        FAIL_IF(word != 0, "%llX is written, which is behind the crossings, by\n%s",
                (unsigned long long)at, text);
    }
}

/* All rays are in one queue, and no ray is finished before the last region. A tree's
 * data in memory is therefore still there when the next kernel writes crossings. */
static void check_memory(const char *text)
{
    SCOPED(scene) *scene = read_text(text);
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .width = WIDTH,
                                            .height = HEIGHT, .queue = PIXELS,
                                            .no_bounds = true);
    SCOPED(trace) *trace = trace_new(scene, &options, &failure);
    SCOPED(c205) *machine = trace ? trace_machine(trace, 0, &failure) : NULL;
    REQUIRE(machine && program_run(machine, NULL, NULL, NULL, &failure));
    check_behind_crossings(scene, trace, machine, text);
}

static void add_flat(char *text, size_t size)
{
    add_text(text, size, "polygon { 4");
    for (int i = 0; i < 4; i++)
        add_text(text, size, ", <%.3f, %.3f>", between(-9, 9), between(-9, 9));
}

/* Trees that no ray hits, so that no ray is finished, and meshes after them. */
TEST(memory)
{
    for (int i = 0; i < 12; i++) {
        char text[4096] = HEAD "camera { location <0, 1, -7> look_at 0 angle 50 }\n";
        for (size_t k = among(1, 2); k > 0; k--) {
            bool before = xorshift(&traced.random) % 2;
            add_text(text, sizeof text, "intersection { %s",
                     before ? "sphere { 99*y, 9 inverse } " : "");
            if (xorshift(&traced.random) % 2)
                add_steiner_patch(text, sizeof text, 3);
            else
                add_flat(text, sizeof text);
            add_text(text, sizeof text, " } %s translate -30*z }\n",
                     before ? "" : "sphere { 99*y, 9 inverse } ");
        }
        add_text(text, sizeof text, "mesh { triangle { -9, 9*x, 9*y } }\n");
        add_text(text, sizeof text, "mesh { triangle { 9, -9*x, -9*y } }\n");
        check_memory(text);
    }
}

TEST(the_way_of_1984)
{
    traced.historical = true;
    test_holes_in_solids(test_state);
    test_shadows_and_glass(test_state);
    test_random_patches(test_state);
    traced.historical = false;
}

/* A patch has no inside, which causes a report. */
FIXTURE(set_up_reported)
{
    traced.reported = true;
    return set_up_frames(test_state);
}

GROUP(set_up_reported, tear_down_model);
