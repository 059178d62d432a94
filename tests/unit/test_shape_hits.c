/* test_shape_hits.c - the hit of a picture's middle ray with each shape is compared
 * with the primitive and the distance that follow from geometry, in both forms and with
 * several queue lengths. A kernel that confuses two cases of a shape fails here. Such
 * cases are an origin inside the shape, a ray along its axis, in its plane or through
 * its edge, and a hit on its rim. */
#include "tests/unit/traced_frame.h"

/* A scene, the id of the primitive from 1 (0: no hit), and the distance. */
struct sight {
    const char *text;
    int64_t id;
    double depth;
};

/* Reports all rows that fail. */
static void check_sights(const char *view, const struct sight *sights, size_t count)
{
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2, failed = 0;
    for (size_t i = 0; i < count; i++) {
        FREED struct words *words = same_frame(formatted("%s%s", view, sights[i].text));
        int64_t id = c205_to_integer(words->channel[CHANNEL_ID][middle]);
        double depth = c205_to_double(words->channel[CHANNEL_DEPTH][middle]);
        if (id == sights[i].id && fabs(depth - sights[i].depth) <= 1e-10)
            continue;
        print_error("%s: %d at %.12g\n", sights[i].text, (int)id, depth);
        failed++;
    }
    assert_int_equal(failed, 0);
}

#define GLOSSY "no_shadow finish { phong .5 specular .5 } }"

/* A cone of 45 degrees with its apex at the origin, open at the top. */
#define FUNNEL "cone { 0, 0, 2*y, 2 "

/* Objects behind the camera fix the scene's unit of length for small objects. */
#define ORDINARY "#declare Far = sphere { -9*z, 1 }\n"
#define FAR " object { Far } object { Far translate -z }"

/* Coefficients in the order of POV-Ray. Most of them are 0. */
#define ZEROS "0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, "
#define Z4 "<" ZEROS "0,0,0,0,0, 1,"

#define SQUARE "4, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>"
#define HOLED \
    "10, <-2, -2>, <2, -2>, <2, 2>, <-2, 2>, <-2, -2>," \
    " <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"

/* Its points from <-1, -1> to <1, -1> are <w^2 + w - 1, w^2 - w - 1>. */
#define PRISM "prism { quadratic_spline "
#define ROUNDED "6, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"
#define W ((1 + sqrt(.6)) / 2) /* W^2 - W = -.1 */

#define TUBE "2, <1, -1>, <1, 1>"
#define DRUM "4, <0, -1>, <1, -1>, <1, 1>, <0, 1>"
#define RING "5, <1, -1>, <2, -1>, <2, 1>, <1, 1>, <1, -1>"
#define CONE "3, <0, 1>, <1, 0>, <0, -1>"

/* (1 - 3/4)^2 = 1/16, so a ball of radius r appears with the radius r sqrt 3 / 2. */
#define BLOB "blob { threshold .0625 "
#define SEEN 0.86602540378443865

#define CORNERS "<-1, -1, 0>, <2, -1, 0>, <-1, 2, 0>"
#define LEANING \
    "smooth_triangle { <-1, -1, 0>, <3, 0, -4>, <2, -1, 0>, -z, " \
    "<-1, 2, 0>, -2*z }"
#define FLAT "triangle { " CORNERS " }"
/* TINY has an area where it is written, but no area in world space. The sphere keeps
 * the unit of length of the scene at 1. */
#define TINY "triangle { 0, 1e-10*x, 1e-10*y } "
#define SPHERE " sphere { <3, 3, 0>, .1 }"

TEST(ahead)
{
    const struct sight sights[] = {
        /* ---- spheres, boxes, planes, cylinders */
        /* parallel rays */
        { "box { -1, 1 }", 1, 4 },
        { "box { <1, -1, -1>, <2, 1, 1> }", 0, 0 },
        { "cylinder { -z, z, 1 }", 1, 4 },
        { "cylinder { -z, z, 1 open } sphere { 0, .5 }", 2, 4.5 },
        { "cylinder { <2, 0, -1>, <2, 0, 1>, 1 }", 0, 0 },
        { "cylinder { -x, x, 1 }", 1, 4 },
        { "cylinder { <-1, 3, 0>, <1, 3, 0>, 1 open }", 0, 0 },
        { "plane { y, -1 }", 0, 0 },
        { "plane { y, 1 }", 0, 0 },
        { "plane { -z, 1 }", 1, 4 },
        { "plane { z, 3 }", 1, 8 },
        { "sphere { 0, 1 scale <1, 1, 2> }", 1, 3 },
        /* from inside */
        { "box { -8, 7 }", 1, 12 },
        { "sphere { <0, 0, -5>, 2 }", 1, 2 },
        { "cylinder { <0, -1, -5>, <0, 1, -5>, 3 }", 1, 3 },
        { "sphere { <0, 0, -5>, 1 scale <1, 1, 2> }", 0, 0 },
        { "sphere { <0, 0, -9>, 1 }", 0, 0 },
        /* an open cylinder shows its inside */
        { "cylinder { <0, .7, 0>, <0, 3, 0>, 1 open rotate -30*x }", 0, 0 },
        { "cylinder { -y, y, 1 open }", 1, 4 },
        { "cylinder { -y, y, 1 open rotate 45*x translate -y }", 1, 5 + 1 - sqrt(2) },
        /* Of two coincident faces the face of the later object is visible. */
        { "box { -1, 1 } box { -1, 1 } plane { z, 9 }", 2, 4 },
        { "plane { z, 9 } sphere { 0, 1 } box { -1, 1 }", 2, 4 },
        /* ---- cones and quadrics */
        /* cones */
        { "cone { -y, 1.5, y, .5 }", 1, 4 },
        { "cone { -y, 1.5, y, .5 open }", 1, 4 },
        { "cone { -y, 0, y, 2 scale <1, 1, 2> }", 1, 3 },
        { FUNNEL "translate -y }", 1, 4 },
        { FUNNEL "translate .5*y }", 0, 0 },
        { "cone { <0, -3, 0>, 1, <0, -1, 0>, 2 }", 0, 0 },
        /* rays along a cone */
        { "cone { -z, 1, z, 2 }", 1, 4 },
        { "cone { -z, 1, z, 2 open }", 0, 0 },
        { "cone { -z, 0, z, 2 }", 1, 4 },
        { "cone { -z, 2, z, 0 }", 1, 4 },
        { "cone { -z, 2, z, 0 open }", 1, 6 },
        { "cone { -z, 2, z, 0 translate -5*z }", 1, 1 },
        { "cone { -z, .1, z, .3 translate .2*x }", 1, 5 },
        /* quadrics */
        { "quadric { 1, 0, 0, -1 }", 1, 4 },
        { "quadric { 1, 0, 0, -1 translate -5*z }", 1, 1 },
        { "quadric { 1, 0, -2*z, 0 }", 1, 5 },
        { "quadric { 1, 0, 0, 1 }", 0, 0 },
        { "quadric { <-1, -1, 1>, 0, 0, -1 }", 1, 4 },
        { "quadric { <1, 1, -1>, 0, 0, -1 }", 0, 0 },
        { "quadric { <1, 1, -1>, 0, 0, 1 }", 1, 4 },
        /* The camera is inside, at the apex, or within tmin of the surface. */
        { "cone { <0, -1, -5>, 2, <0, 1, -5>, 2.5 }", 1, 2.25 },
        { "cone { -5*z, 0, 5*z, 1 }", 1, 10 },
        { "quadric { 1, 0, 0, -25 }", 1, 10 },
        { "quadric { <1, 1, -1>, 0, -10*z, -24 }", 1, 1 },
        /* ---- tori and quartics */
        /* tori */
        { "torus { 1, .5 }", 1, 3.5 },
        { "torus { 1, .5 rotate 90*x }", 0, 0 },
        { "torus { 1, .5 translate -4*z }", 1, .5 },
        { "torus { 5, .25 }", 1, .25 },
        { "torus { 1, .5 scale <1, 1, 2> }", 1, 2 },
        { "torus { 1, .5 translate .6*y }", 0, 0 },
        { "torus { .5, 1 rotate 90*x }", 1, 5 - sqrt(.75) },
        { "elliptical_torus { 1, .5, .1 }", 1, 3.5 },
        { "elliptical_torus { 1, .5, .1 rotate 90*x translate x }", 1, 4.9 },
        /* The camera is in the middle of the tube, on its surface, or in the hole. */
        { "torus { 1, .5 translate <0, 0, -4> }", 1, .5 },
        { "torus { 1, .5 translate <0, 0, -3.5> }", 1, 1 },
        { "torus { 1, .5 translate <0, 0, -5> }", 1, .5 },
        { "torus { 1, .5 scale 2 translate <0, 0, -2> }", 1, 2 },
        { "torus { 1, .5 translate <0, 0, -7> }", 0, 0 },
        /* The nearest crossing at a distance above 1e-6 in world space is the hit, at
         * every scale. A crossing at twice this distance is a hit, a crossing at half
         * of it is not. */
        { ORDINARY "torus { 1, .5 scale 1000 translate (1500 - 5 + 2e-6)*z }" FAR, 1,
          2e-6 },
        { ORDINARY "torus { 1, .5 scale 1000 translate (1500 - 5 + .5e-6)*z }" FAR, 1,
          1000 + .5e-6 },
        { ORDINARY "torus { 1, .5 scale .001 translate (.0015 - 5 + 2e-6)*z }" FAR, 1,
          2e-6 },
        { ORDINARY "torus { 1, .5 scale .001 translate (.0015 - 5 + .5e-6)*z }" FAR, 1,
          .0010005 },
        /* quartic surfaces */
        { "quartic { " Z4 "0,0,0,-1> }", 1, 4 },
        { "quartic { " Z4 "0,-5,0,4> }", 1, 3 },
        { "quartic { " Z4 "0,-5,0,4> translate -5*z }", 1, 1 },
        { "quartic { " Z4 "0,0,0,1> }", 0, 0 },
        { "quartic { <0,0,0,1,0, " ZEROS "0,0,0,1,-3> }", 1, 8 },
        { "quartic { <" ZEROS "0,0,0,0,0, 0,1,0,0,-8> }", 1, 7 },
        /* ---- prisms */
        { "prism { -1, 1, " SQUARE " }", 1, 4 },
        { "prism { 1, -1, " SQUARE " }", 1, 4 },
        { "prism { 1, 2, " SQUARE " }", 0, 0 },
        { "prism { -1, 1, " SQUARE " translate -5*z }", 1, 1 },
        { "prism { -1, 1, " HOLED " translate -5*z }", 1, 1 },
        { "prism { -1, 1, " HOLED " open scale <1, 1, 2> }", 1, 1 },
        { "prism { -1, 1, 3, <-1, -2>, <1, -2>, <0, 4> }", 1, 3 },
        /* along the axis of the prism */
        { "prism { -3, 1, " SQUARE " rotate 90*x }", 1, 2 },
        { "prism { -3, 1, " SQUARE " open rotate 90*x }", 0, 0 },
        { "prism { -3, 1, " HOLED " rotate 90*x }", 0, 0 },
        { "prism { -3, 1, " HOLED " rotate 90*x translate 1.5*y }", 1, 2 },
        /* in solids */
        { "intersection { prism { -3, 1, " SQUARE " rotate 90*x } plane { -z, 1 } }", 2,
          4 },
        { "difference { sphere { 0, 3 } prism { -4, 4, " SQUARE " rotate 90*x } }", 0,
          0 },
        { "difference { prism { -1, 1, " HOLED " } plane { z, 0 } }", 1, 6 },
        /* ---- prisms of quadratic splines */
        { PRISM "-1, 1, " ROUNDED " }", 1, 6 - sqrt(5) },
        { PRISM "1, -1, " ROUNDED " open }", 1, 6 - sqrt(5) },
        { PRISM "-1, 1, " ROUNDED " translate -5*z }", 1, sqrt(5) - 1 },
        { PRISM "1, 2, " ROUNDED " }", 0, 0 },
        /* along the axis of the prism */
        { PRISM "-3, 1, " ROUNDED " rotate 90*x }", 1, 2 },
        { PRISM "-3, 1, " ROUNDED " open rotate 90*x }", 0, 0 },
        { PRISM "-3, 1, " ROUNDED " rotate 90*x translate 1.1*y }", 1, 2 },
        /* through a corner */
        { PRISM "-1, 1, " ROUNDED " translate x }", 1, 4 },
        /* in solids */
        { "intersection { " PRISM "-1, 1, " ROUNDED " } plane { -z, 1.1 } }", 2, 3.9 },
        { "difference { " PRISM "-1, 1, " ROUNDED " } sphere { -z, .5 } }", 2, 4.5 },
        /* twice through the same edge */
        { PRISM "-1, 1, " ROUNDED " translate 1.1*x }", 1, 6 - W - W * W },
        { "intersection { " PRISM "-1, 1, " ROUNDED
          " translate 1.1*x } plane { -z, 0 } }",
          2, 5 },
        /* ---- blobs */
        { BLOB "sphere { 0, 2, 1 } }", 1, 5 - 2 * SEEN },
        /* components below and beside the ray, too weak, and cancelled */
        { BLOB "sphere { 2*y, 2, 1 } }", 0, 0 },
        { BLOB "sphere { 0, 2, .0624 } sphere { 9*y, 1, .0624 } }", 0, 0 },
        { BLOB "sphere { 0, 2, 1 } sphere { 0, 2.5, -1 } }", 0, 0 },
        /* sums of components */
        { BLOB "sphere { 0, 2, .04 } sphere { 0, 2, .04 } sphere { 0, 2, .92 } }", 1,
          5 - 2 * SEEN },
        /* a hemisphere, the side and the other end, in both orders */
        { BLOB "cylinder { 0, 2*z, 2, 1 } }", 1, 5 - 2 * SEEN },
        { BLOB "cylinder { 2*z, 0, 2, 1 } }", 1, 5 - 2 * SEEN },
        { BLOB "cylinder { -x, x, 2, 1 } }", 1, 5 - 2 * SEEN },
        { BLOB "cylinder { x, 3*x, 2, 1 } }", 1, 5 - sqrt(2) },
        /* in the plane of an end, which belongs to two pieces */
        { BLOB "cylinder { 0, 3*x, 2, 1 } }", 1, 5 - 2 * SEEN },
        { BLOB "cylinder { -3*y, 0, 2, 1 } }", 1, 5 - 2 * SEEN },
        /* moved and stretched components */
        { BLOB "sphere { x, 1, 1 translate -x scale <1, 1, 2> } }", 1, 5 - 2 * SEEN },
        { BLOB "cylinder { -x, x, 1, 1 scale 2 rotate 90*z } rotate 30*y }", 1,
          5 - 2 * SEEN },
        /* from inside, and behind the camera */
        { BLOB "sphere { -5*z, 2, 1 } }", 1, 2 * SEEN },
        { BLOB "sphere { -8*z, 2, 1 } }", 0, 0 },
        /* in solids */
        { "intersection { " BLOB "sphere { 0, 2, 1 } } plane { -z, 1 } }", 2, 4 },
        { "difference { sphere { 0, 3 } " BLOB "cylinder { -4*z, 0, 2, 1 } } }", 2,
          5 + 2 * SEEN },
    };
    check_sights(AHEAD, sights, COUNT(sights));
}

TEST(straight)
{
    const struct sight sights[] = {
        /* ---- spheres, boxes, planes, cylinders */
        /* tangent rays */
        { "sphere { x, 1 }", 1, 5 },
        { "sphere { <.75, -1, 3>, 1.25 }", 1, 8 },
        /* the light or the highlight has no direction */
        { "light_source { -z, rgb 1 } box { -1, 1 " GLOSSY, 1, 4 },
        { "light_source { <0, 1e-9, 10>, rgb 1 } box { -1, <1, 0, 1> " GLOSSY, 1, 4 },
        { "light_source { <0, 0, -5>, rgb 1 }"
          " sphere { 0, 1 scale <1, 1, 1e-20> " GLOSSY,
          1, 5 },
        /* ---- cones and quadrics */
        /* along a line of the surface: a = 0 */
        { "quadric { 0, z, 0, 0 translate -y }", 1, 5 },
        { "quadric { <1, 1, 0>, 0, -z, 0 }", 1, 5 },
        { "quadric { <1, 1, 0>, 0, 0, -1 }", 0, 0 },
        { "quadric { <0, 0, 1>, 0, 0, -1 }", 1, 4 },
        /* ---- discs */
        { "disc { 0, z, 1 }", 1, 5 },
        { "disc { <.5, 0, 1>, -z, 1 }", 1, 6 },
        { "disc { <0, 0, 1>, <0, 1, 1>, 1 }", 1, 6 },
        { "disc { <.5, 0, 0>, <1, 0, 1>, 1 }", 1, 5.5 },
        { "disc { .5*x, z, .25 scale <3, 1, 1> }", 0, 0 },
        { "disc { .5*x, z, .25 scale <.5, 1, 1> }", 0, 0 },
        { "disc { 0, z, 1, .25 }", 0, 0 },
        { "disc { .5*x, z, 1, .25 }", 1, 5 },
        /* on the edge of the disc, and on the edge of its hole */
        { "disc { .5*x, z, .5 }", 1, 5 },
        { "disc { .5*x, z, 1, .5 }", 1, 5 },
        /* rays in the plane of the disc, and the camera in its plane */
        { "disc { 0, y, 1 }", 0, 0 },
        { "disc { 0, x, 1, .5 }", 0, 0 },
        /* parallel within the tolerance, and not parallel */
        { "disc { 0, <0, 1, 1e-13>, 1 }", 0, 0 },
        { "disc { 0, <0, 1, 1e-11>, 1 }", 1, 5 },
        { "disc { 0, y, 1 } disc { 3*z, z, 1 }", 2, 8 },
        { "disc { -5*z, z, 1 }", 0, 0 },
        { "disc { -6*z, z, 1 }", 0, 0 },
        /* The inside of a disc is the half-space below, its visible face the disc. */
        { "difference { sphere { 0, 2 } disc { 0, z, 1 } }", 2, 5 },
        { "difference { sphere { 0, 2 } disc { 0, z, 1, .5 } }", 1, 7 },
        { "difference { sphere { 0, 2 } disc { 9*x, z, 1 } }", 1, 7 },
        { "intersection { sphere { 0, 2 } disc { 9*x, z, 1 } }", 1, 3 },
        { "merge { sphere { 0, 2 } disc { -3*z, -z, 1 } }", 2, 2 },
        /* ---- lathes */
        { "lathe { " TUBE " }", 1, 4 },
        { "lathe { linear_spline " DRUM " }", 1, 4 },
        { "lathe { " DRUM " translate -5*z }", 1, 1 },
        { "lathe { " RING " translate -5*z }", 1, 1 },
        { "lathe { " DRUM " translate 2*y }", 0, 0 },
        { "lathe { 2, <2, -1>, <1, 1> translate 1e-9*y }", 1, 3.5 - .5e-9 },
        /* level, through a corner; along the axis; outside */
        { "lathe { " CONE " }", 1, 4 },
        { "lathe { " CONE " rotate 90*x }", 1, 4 },
        { "lathe { " DRUM " rotate 90*x }", 1, 4 },
        { "lathe { " TUBE " rotate 90*x }", 0, 0 },
        { "lathe { " RING " rotate 90*x }", 0, 0 },
        { "lathe { " RING " rotate 90*x translate 1.5*y }", 1, 4 },
        { "lathe { " CONE " rotate 90*x translate .5*y }", 1, 4.5 },
        /* level, in a ring, and at a point that is the lowest */
        { "lathe { " DRUM " translate y }", 1, 4 },
        { "lathe { " DRUM " translate -y }", 0, 0 },
        { "lathe { 3, <1, 1>, <2, 0>, <1.5, 2> }", 1, 3 },
        /* from inside an open tube */
        { "lathe { 2, <3, -1>, <3, 1> translate -5*z }", 1, 3 },
        /* in solids */
        { "intersection { lathe { " DRUM " } plane { -z, 0 } }", 2, 5 },
        /* a tube has no inside, but is visible inside other solids */
        { "intersection { lathe { " TUBE " } plane { -z, .5 } }", 1, 6 },
        { "lathe { " TUBE " clipped_by { plane { -z, .5 } } }", 1, 6 },
        { "lathe { 3, <1, 0>, <.5, 0>, <.5, 1> rotate 90*x"
          " translate .75*y clipped_by { box { -2, 2 } } }",
          1, 5 },
        { "intersection { lathe { 3, <0, -1>, <1, -1>, <1, 1> } plane { -z, .5 } }", 2,
          4.5 },
        { "difference { sphere { 0, 3 } lathe { " DRUM " scale 4 } }", 0, 0 },
        { "difference { lathe { " RING " } plane { z, 0 } }", 1, 6 },
        /* through corners; level at the lowest point */
        { "intersection { lathe { " CONE " } plane { -z, .5 } }", 2, 4.5 },
        { "intersection { lathe { 4, <1, 1>, <2, 0>, <1.5, 2>, <1, 1> }"
          " plane { -z, .5 } }",
          0, 0 },
        { "difference { box { -2, 2 } lathe { " CONE " rotate 45*x translate -2*z } }",
          2, 3 + sqrt(.5) },
        /* ---- meshes */
        { "mesh { " FLAT " }", 1, 5 },
        { "mesh { " FLAT FLAT " }", 1, 5 },
        { "mesh { " LEANING " }", 1, 5 },
        { "mesh { " FLAT " rotate 180*y }", 1, 5 },
        { "mesh { " FLAT " translate <1.5, 0, 0> }", 0, 0 },
        { "mesh { " FLAT " translate <-.7, -.4, 0> }", 0, 0 },
        /* through a corner or an edge, and along its plane */
        { "mesh { " FLAT " translate <1, 1, 0> }", 1, 5 },
        { "mesh { " FLAT " translate <-.5, -.5, 0> }", 1, 5 },
        { "mesh { " FLAT " translate <0, 1, 0> }", 1, 5 },
        { "mesh { triangle { <0, -1, -1>, <0, -1, 2>, <0, 2, -1> } }", 0, 0 },
        /* the triangle is at the origin of the ray */
        { "mesh { " FLAT " translate -5*z }", 0, 0 },
        { "mesh { " FLAT " translate -4*z }", 1, 1 },
        { "mesh { " FLAT " translate -6*z }", 0, 0 },
        { "mesh { " FLAT FLAT " translate -6*z } mesh { " FLAT " }", 2, 5 },
        { "mesh { " FLAT " translate -.01*z scale 1000 translate 6*z }", 1, 1 },
        /* no area in world space */
        { "mesh { " TINY "triangle { <-10000001, -1, 0>, "
          "<-9999999, -1, 0>, <-10000000, 2, 0> } translate 1e7*x }" SPHERE,
          1, 5 },
        { "mesh { " TINY "translate 1e7*x } mesh { " FLAT "translate -z }", 2, 4 },
    };
    check_sights(STRAIGHT, sights, COUNT(sights));
}
