/* test_blobs.c - blobs of random spheres and cylinders. Both forms of the tracer are
 * compared with each other and with the plain tracer, for blobs alone and in solids, on
 * and off a grid on which their faces coincide. A piece of the field that is missed at
 * a seam, a missing hump, or a normal that points inside fails here.
 *
 *     test_blobs [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/random_solids.h"

#include "rt/shapes/shape_words.h"
#include "tests/oracle/plain_shapes.h"

static size_t scene_count = 4; /* number of scenes of each kind */

/* ---- Components ---------------------------------------------------------- */

/* On a grid, ends, planes and axes of components coincide, some with rays. */
static void add_motions(char *text, size_t size)
{
    if (below(3) == 0)
        add_random(text, size, "scale <^4s.5:1.5^, ^4s.5:1.5^, ^4s.5:1.5^> ");
    if (below(3) == 0)
        add_random(text, size, "rotate <^2a^, ^2a^, ^2a^> ");
    if (below(3) == 0)
        add_random(text, size, "translate <^4p-.5:.5^, ^4p-.5:.5^, ^4p-.5:.5^>");
}

static void add_cylinder_part(char *text, size_t size)
{
    double from[3], way[3];
    for (int i = 0; i < 3; i++) {
        from[i] = place_between(-1, .5);
        way[i] = solids.gridded && below(2) ? 0 : size_between(.25, 1);
    }
    if (way[0] + way[1] + way[2] == 0)
        way[below(3)] = .75;
    add_text(text, size, "cylinder { <%.4f, %.4f, %.4f>, <%.4f, %.4f, %.4f>, ", from[0],
             from[1], from[2], from[0] + way[0], from[1] + way[1], from[2] + way[2]);
}

static void add_component(char *text, size_t size)
{
    if (below(2))
        add_cylinder_part(text, size);
    else
        add_random(text, size, "sphere { <^4p-1:1^, ^4p-1:1^, ^4p-1:1^>, ");
    /* every fifth strength is negative */
    add_random(text, size, "^4s.4:1^$., $2[|strength ]$5[-|]^4.5:2^ ");
    if (below(2))
        add_motions(text, size);
    add_text(text, size, "} ");
}

/* Adds a blob with one to six components. */
static void add_any_blob(char *text, size_t size)
{
    add_random(
        text, size,
        "blob { threshold ^4.2:.8^ sphere { $.<^4p-.5:.5^, ^4p-.5:.5^, ^4p-.5:.5^>"
        "$., ^4s.5:1^, 1.5 } ");
    for (size_t i = below(6); i > 0; i--)
        add_component(text, size);
}

static void add_moved_blob(char *text, size_t size)
{
    add_any_blob(text, size);
    add_random(text, size,
               " scale <1.6, ^21:2^, 1.4> rotate <^2a^, ^2a^, ^2a^> translate @1.3@ ");
}

TEST(random_scenes)
{
    for (int gridded = 0; gridded < 2; gridded++) {
        solids.gridded = gridded;
        check_random_scenes(add_moved_blob, scene_count);
    }
    solids.gridded = false;
}

/* ---- Solids -------------------------------------------------------------- */

TEST(solids)
{
    for (size_t i = 0; i < 2 * scene_count; i++) {
        solids.clear = i % 2;
        solids.gridded = i % 4 >= 2;
        check_solids_with(add_any_blob);
    }
    solids.gridded = solids.clear = false;
}

/* ---- Expected geometry --------------------------------------------------- */

/* Two balls with three humps along a line, which is the maximum for two components. Let
 * a be the distance between each centre and the middle. From there the field decreases
 * to s^2 = 1 - 3 a^2, and it has a hump at a. */
#define HUMPS \
    "blob { threshold .997 sphere { -.52*z, 1, 1 } sphere { .52*z, 1, 1 }" \
    " scale 2 "

TEST(humps)
{
    static const char *const cuts[] = { "-1.06", "-.9", "0", ".9", "1.06" };
    static const struct ray ray = { { 0, 0, -5 }, { 0, 0, 1 } };
    struct crossing crossings[MAX_CROSSINGS];
    SCOPED(scene) *scene = read_text(HUMPS "}");
    struct shape_words words;
    shape_words(scene->primitives, &words);
    assert_int_equal(words.segments, 3);
    assert_int_equal(plain_crossings(scene->primitives, &ray, crossings), 6);
    for (int i = 0; i < 5; i++) {
        free(plain_frame(formatted(AHEAD "intersection { " HUMPS
                                         "} plane { -z, -(%s) } }",
                                   cuts[i])));
    }
}

/* ---- Normals ------------------------------------------------------------- */

TEST(inside)
{
    for (int try = 0; try < 200; try++) {
        char text[4000] = "";
        const struct ray ray = { { between(-1, 1), between(-1, 1), -9 },
                                 { between(-.1, .1), between(-.1, .1), 1 } };
        struct crossing crossings[MAX_CROSSINGS];
        add_any_blob(text, sizeof text);
        add_text(text, sizeof text, "}");
        SCOPED(scene) *scene = read_text(text);
        size_t count = plain_crossings(scene->primitives, &ray, crossings);
        assert_int_equal(count % 2, 0);
        for (size_t i = 0; i < count; i++) {
            double point[3], out[3];
            point_on(&ray, crossings[i].distance, point);
            normalise(crossings[i].normal);
            add_scaled(out, point, 1e-6, crossings[i].normal);
            assert_false(plain_encloses(scene->primitives, out));
            add_scaled(out, point, -1e-6, crossings[i].normal);
            assert_true(plain_encloses(scene->primitives, out));
        }
    }
}

COUNT_AND_SEED(scene_count, traced.random);
