/* Discs: both forms meet them where geometry says, and with each other and the
 * plain tracer, alone and in solids, one or many.
 *
 *     test_discs [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/random_solids.h"

static size_t scene_count = 4;

/* Of the ray along z from -5*z. */
TEST(middle)
{
    check_middle(STRAIGHT "disc { 0, z, 1 }", 1, 5);
    check_middle(STRAIGHT "disc { <.5, 0, 1>, -z, 1 }", 1, 6);
    check_middle(STRAIGHT "disc { <0, 0, 1>, <0, 1, 1>, 1 }", 1, 6);
    check_middle(STRAIGHT "disc { <.5, 0, 0>, <1, 0, 1>, 1 }", 1, 5.5);
    check_middle(STRAIGHT "disc { .5*x, z, .25 scale <3, 1, 1> }", 0, 0);
    check_middle(STRAIGHT "disc { .5*x, z, .25 scale <.5, 1, 1> }", 0, 0);
    check_middle(STRAIGHT "disc { 0, z, 1, .25 }", 0, 0);
    check_middle(STRAIGHT "disc { .5*x, z, 1, .25 }", 1, 5);
    /* on its edge, on that of its hole */
    check_middle(STRAIGHT "disc { .5*x, z, .5 }", 1, 5);
    check_middle(STRAIGHT "disc { .5*x, z, 1, .5 }", 1, 5);
}

/* Rays in its plane, and where they start. */
TEST(beside)
{
    check_middle(STRAIGHT "disc { 0, y, 1 }", 0, 0);
    check_middle(STRAIGHT "disc { 0, x, 1, .5 }", 0, 0);
    /* so little aslant that it counts as along it */
    check_middle(STRAIGHT "disc { 0, <0, 1, 1e-13>, 1 }", 0, 0);
    check_middle(STRAIGHT "disc { 0, <0, 1, 1e-11>, 1 }", 1, 5);
    check_middle(STRAIGHT "disc { 0, y, 1 } disc { 3*z, z, 1 }", 2, 8);
    check_middle(STRAIGHT "disc { -5*z, z, 1 }", 0, 0);
    check_middle(STRAIGHT "disc { -6*z, z, 1 }", 0, 0);
}

/* What lies below its plane is taken away, as far as that reaches. */
TEST(solids)
{
    check_middle(STRAIGHT "difference { sphere { 0, 2 } disc { 0, z, 1 } }",
                 2, 5);
    check_middle(STRAIGHT
                 "difference { sphere { 0, 2 } disc { 0, z, 1, .5 } }",
                 1, 7);
    check_middle(STRAIGHT "difference { sphere { 0, 2 } disc { 9*x, z, 1 } }",
                 1, 7);
    check_middle(STRAIGHT
                 "intersection { sphere { 0, 2 } disc { 9*x, z, 1 } }",
                 1, 3);
    check_middle(STRAIGHT "merge { sphere { 0, 2 } disc { -3*z, -z, 1 } }", 2,
                 2);
}

/* So many that there is a hierarchy of them. */
static void add_discs(char *text, size_t size)
{
    size_t count = 12 + below(40);

    add_text(text, size, "union { ");
    for (size_t i = 0; i < count; i++) {
        add_text(text, size, "disc { ");
        add_point(text, size, 1.2);
        add_text(text, size, ", ");
        add_point(text, size, 1);
        add_text(text, size, ", %.4f, %.4f }\n", between(.3, 1),
                 below(2) ? between(0, .3) : 0);
    }
    add_text(text, size, "scale <%.3f, 1, %.3f> ", between(.6, 1.4),
             between(.6, 1.4));
}

TEST(many)
{
    check_random_scenes(add_discs, scene_count);
}

ARGUMENTS(argc, argv)
{
    if (argc > 1)
        scene_count = strtoul(argv[1], NULL, 10);
    if (argc > 2)
        traced.random ^= strtoull(argv[2], NULL, 10) << 13;
}

GROUP(set_up_frames, tear_down_model);
