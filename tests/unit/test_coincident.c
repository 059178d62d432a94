/* test_coincident.c - the yields that the reader assigns to the regions of a scene are
 * compared with expected yields. The scenes have all kinds of pairs of faces:
 * coincident, resting on each other, and apart. A missed pair, whose visible face
 * rounding then decides, or a superfluous pair, which costs clocks, fails here. */
#include "tests/oracle/many_scenes.h"
#include "tests/unit/unit.h"

/* Fails unless the regions have these yields, as digits in tenths. */
static void expect(const char *yields, const char *objects)
{
    char text[2000], found[20] = "";
    snprintf(text, sizeof text,
             "#version 3.7; global_settings { assumed_gamma 1 }\n"
             "camera { location <1, 3, -9> look_at 0 }\n%s",
             objects);
    SCOPED(scene) *scene = scene_of(text);
    for (size_t i = 0; i < scene->region_count && i < 19; i++)
        found[i] = (char)('0' + (int)(10 * scene->regions[i].yield + .01));
    FAIL_IF(strcmp(found, yields) != 0, "%s, not %s: %s", found, yields, objects);
}

TEST(coincident_faces_give_earlier_regions_a_yield)
{
    expect("50", "box { 0, 1 } box { <.5, 0, .5>, <2, 1, 2> }");
    expect("630", "box { 0, 1 } box { <.5, .1, .5>, <2, 1, 2> } "
                  "cylinder { <1, .5, 1>, <1, 1, 1>, .9 }");
    expect("50", "union { box { 0, 1 } box { <.5, 0, .5>, <2, 1, 2> } }");
    expect("50", "disc { 0, y, 1 } plane { y, 0 }");
    expect("50", "plane { y, 0 } triangle { 0, x, z }");
    expect("50", "sphere { 0, 1 } sphere { 0, 1 pigment { rgb 1 } }");
    expect("50", "sphere { 0, 1 scale 2 rotate 30*x } sphere { 0, 2 }");
    expect("50", "cylinder { 0, y, 1 } cylinder { .5*y, 2*y, 1 open }");
    expect("50", "cone { 0, 1, y, .5 } cone { -y, 1.5, .5*y, .75 open }");
    expect("50", "torus { 1, .2 } torus { 1, .2 rotate 20*y }");
    expect("50", "box { 0, 1 rotate 30*y } "
                 "prism { .2, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> rotate 30*y }");
    expect("50", "difference { box { -1, 1 } cylinder { -2*z, 2*z, .5 } } "
                 "box { <-.9, -2, -1>, <.9, 1.5, .1> }");
    expect("50", "mesh { triangle { 0, x, z } triangle { x, z, y } } "
                 "box { <0, -1, 0>, <1, 0, 1> }");
}

/* In the last scene the camera is inside the room. */
TEST(faces_that_rest_on_each_other_need_none)
{
    expect("00", "plane { y, 0 } box { 0, 1 }");
    expect("000", "box { 0, 1 } cylinder { y, 2*y, .5 } cone { 2*y, .5, 3*y, 0 }");
    expect("00", "difference { box { -1, 1 } sphere { y, .5 } } sphere { y, .5 }");
    expect("50", "plane { y, 0 } box { 0, 1 clipped_by { plane { x, .5 } } }");
    expect("50", "plane { y, 0 } box { <-20, 0, -20>, 20 }");
}

TEST(apart_faces_have_none)
{
    expect("00", "box { 0, 1 } box { <1, 0, 0>, <2, 1, 1> }");
    expect("00", "disc { 0, y, 1 } disc { 1e-5*y, y, 1 }");
    expect("00", "sphere { 0, 1 } sphere { 0, 1.00001 }");
    expect("00", "sphere { 0, 1 pigment { rgbt 1 } } sphere { 0, 1 }");
    expect("00", "difference { box { 0, 1 } box { <-1, .5, -1>, 2 } } "
                 "box { <3, 0, 0>, <4, 2, 1> }");
}
