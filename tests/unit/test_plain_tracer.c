/* test_plain_tracer.c - the plain tracer's colours of scenes of one ray are compared
 * with values computed by hand, and frames with each other. A missing term of the
 * lighting fails here. */
#include "tests/oracle/compare_pictures.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/unit/unit.h"

#include <math.h>

#define CLOSE 1e-12

static const struct transform identity = {
    { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } }
};

/* A white primitive with diffuse light only. */
static struct primitive primitive_of(enum primitive_kind kind)
{
    return (struct primitive){
        .kind = kind,
        .to_world = identity,
        .to_local = identity,
        .ior = 1,
        .pigment = { .color = { { 1, 1, 1 } }, .to_local = identity },
        .finish = { .reflection_falloff = 1,
                    .diffuse = 1,
                    .brilliance = 1,
                    .phong_size = 40,
                    .roughness = .05 },
    };
}

static struct primitive unit_sphere(void)
{
    struct primitive sphere = primitive_of(PRIMITIVE_SPHERE);
    sphere.shape.sphere.radius = 1;
    return sphere;
}

static struct primitive cube_to(double corner)
{
    struct primitive box = primitive_of(PRIMITIVE_BOX);
    for (int i = 0; i < 3; i++) {
        box.shape.box.corner[0][i] = -corner;
        box.shape.box.corner[1][i] = corner;
    }
    return box;
}

/* A cylinder of radius 1 about the z axis, from -1 to 1. */
static struct primitive tube(bool open)
{
    struct primitive cylinder = primitive_of(PRIMITIVE_CYLINDER);
    cylinder.shape.cylinder.base[2] = -1;
    cylinder.shape.cylinder.cap[2] = 1;
    cylinder.shape.cylinder.radius = 1;
    cylinder.shape.cylinder.open = open;
    return cylinder;
}

/* The plane y = height. */
static struct primitive floor_at(double height)
{
    struct primitive plane = primitive_of(PRIMITIVE_PLANE);
    plane.shape.plane.normal[1] = 1;
    plane.shape.plane.distance = height;
    return plane;
}

enum { MAX_PRIMITIVES = 3 };

/* Makes each primitive a separate region. */
static void each_alone(struct scene *scene, struct region regions[MAX_PRIMITIVES])
{
    assert_true(scene->primitive_count <= MAX_PRIMITIVES);
    scene->region_count = scene->primitive_count;
    scene->regions = regions;
    scene->max_trace_level = 1;
    for (size_t i = 0; i < scene->region_count; i++)
        regions[i] = (struct region){ .first_primitive = i, .primitive_count = 1 };
}

struct sample {
    double values[FRAME_CHANNELS];
};

/* Traces a single pixel from a point in a direction. */
static struct sample look(struct scene *scene, double x, double y, double z, double dx,
                          double dy, double dz)
{
    struct region regions[MAX_PRIMITIVES];
    SCOPED_VALUE(frame) frame;
    struct sample sample;
    each_alone(scene, regions);
    scene->camera = (struct camera){ .location = { x, y, z },
                                     .direction = { dx, dy, dz } };
    assert_true(plain_trace(scene, 1, 1, &frame));
    for (size_t i = 0; i < FRAME_CHANNELS; i++)
        sample.values[i] = frame.channel[i][0];
    return sample;
}

static void assert_close(double found, double expected)
{
    if (!(fabs(found - expected) <= CLOSE))
        fail_msg("%.17g is not %.17g", found, expected);
}

static void assert_hit(struct sample sample, double id, double depth, double x,
                       double y, double z)
{
    assert_close(sample.values[CHANNEL_ID], id);
    assert_close(sample.values[CHANNEL_DEPTH], depth);
    assert_close(sample.values[CHANNEL_NORMAL_X], x);
    assert_close(sample.values[CHANNEL_NORMAL_Y], y);
    assert_close(sample.values[CHANNEL_NORMAL_Z], z);
}

static void assert_miss(struct sample sample)
{
    assert_hit(sample, 0, 0, 0, 0, 0);
}

/* ---- Shapes ------------------------------------------------------------ */

TEST(sphere)
{
    struct primitive sphere = unit_sphere();
    struct scene scene = { .primitive_count = 1, .primitives = &sphere };
    assert_hit(look(&scene, 0, 0, -5, 0, 0, 1), 1, 4, 0, 0, -1);
    assert_hit(look(&scene, .6, 0, -5, 0, 0, 9), 1, 4.2, .6, 0, -.8);
    assert_hit(look(&scene, 0, 0, 0, 0, 3, 0), 1, 1, 0, -1, 0);
    assert_miss(look(&scene, 0, 0, -5, 0, 0, -1));
    assert_miss(look(&scene, 1.001, 0, -5, 0, 0, 1));
}

TEST(box)
{
    struct primitive box = cube_to(2);
    struct scene scene = { .primitive_count = 1, .primitives = &box };
    assert_hit(look(&scene, 0, 1, -5, 0, 0, 1), 1, 3, 0, 0, -1);
    assert_hit(look(&scene, 1, 0, 0, 1, 0, 0), 1, 1, -1, 0, 0);
    assert_hit(look(&scene, 5, 5, 0, -3, -4, 0), 1, 5, 1, 0, 0);
    assert_miss(look(&scene, 0, 2.001, -5, 0, 0, 1));
    assert_miss(look(&scene, 0, 5, -5, 0, 1, 1));
}

TEST(cylinder)
{
    struct primitive closed = tube(false), open = tube(true);
    struct scene scene = { .primitive_count = 1, .primitives = &closed };
    assert_hit(look(&scene, .5, 0, -5, 0, 0, 1), 1, 4, 0, 0, -1);
    assert_hit(look(&scene, .6, 5, 0, 0, -1, 0), 1, 4.2, .6, .8, 0);
    assert_hit(look(&scene, 0, 0, 0, 0, 0, 1), 1, 1, 0, 0, -1);
    assert_miss(look(&scene, 1.5, 0, -5, 0, 0, 1));
    assert_miss(look(&scene, 0, 5, 1.5, 0, -1, 0));
    scene.primitives = &open;
    assert_miss(look(&scene, .5, 0, -5, 0, 0, 1));
    assert_hit(look(&scene, 0, -2, -3, 0, 3, 4), 1, 5, 0, -1, 0);
    assert_hit(look(&scene, 0, -.5, -2, 0, 3, 4), 1, 2.5, 0, -1, 0);
}

TEST(plane)
{
    struct primitive plane = floor_at(-1);
    struct scene scene = { .primitive_count = 1, .primitives = &plane };
    assert_hit(look(&scene, 0, 2, 0, 4, -3, 0), 1, 5, 0, 1, 0);
    assert_hit(look(&scene, 0, -4, 0, 4, 3, 0), 1, 5, 0, -1, 0);
    assert_miss(look(&scene, 0, 2, 0, 1, 0, 0));
    assert_miss(look(&scene, 0, 2, 0, 0, 1, 0));
}

/* x / 2 + z replaces z: a sheared, flattened sphere at height 3. Its top is at y = 3 +
 * 1 / 2; there the shear has no effect. */
TEST(transform)
{
    struct primitive sphere = unit_sphere();
    struct scene scene = { .primitive_count = 1, .primitives = &sphere };
    sphere.to_local = (struct transform){
        { { 1, 0, 0, 0 }, { 0, 2, 0, -6 }, { .5, 0, 1, 0 } }
    };
    assert_hit(look(&scene, 0, 9, 0, 0, -2, 0), 1, 5.5, 0, 1, 0);
    double length = sqrt(1.25);
    assert_hit(look(&scene, 0, 3, -9, 0, 0, 1), 1, 8, -.5 / length, 0, -1 / length);
}

TEST(nearest)
{
    struct primitive both[] = { cube_to(1), unit_sphere(), floor_at(5) };
    struct scene scene = { .primitive_count = 3, .primitives = both };
    both[1].shape.sphere.center[2] = -1;
    assert_hit(look(&scene, 0, 0, -5, 0, 0, 1), 2, 3, 0, 0, -1);
    assert_hit(look(&scene, 0, 0, 5, 0, 0, -1), 1, 4, 0, 0, 1);
    assert_hit(look(&scene, 0, 9, 0, 0, -1, 0), 3, 4, 0, 1, 0);
}

/* ---- The camera -------------------------------------------------------- */

TEST(pixel_centres)
{
    struct region regions[MAX_PRIMITIVES];
    struct primitive plane = floor_at(0);
    SCOPED_VALUE(frame) frame;
    struct scene scene = {
        .camera = { { 0, 1, 0 }, { 0, -1, 0 }, { 4, 0, 0 }, { 0, 0, 2 } },
        .primitive_count = 1,
        .primitives = &plane,
    };
    each_alone(&scene, regions);
    assert_true(plain_trace(&scene, 4, 2, &frame));
    for (size_t i = 0; i < 8; i++) {
        double x = (double)(i % 4) - 1.5, z = i < 4 ? .5 : -.5;
        assert_close(frame.channel[CHANNEL_DEPTH][i], sqrt(1 + x * x + z * z));
    }
}

/* ---- Shading ----------------------------------------------------------- */

static double red(struct sample sample)
{
    return sample.values[CHANNEL_RED];
}

/* A floor at 0, seen from <-3, 4, 0> at the origin. The light at <3, 4, 0> is in the
 * mirror direction of the eye's ray. */
struct stage {
    struct primitive primitives[2];
    struct light light;
    struct scene scene;
};

static void set_stage(struct stage *stage)
{
    *stage = (struct stage){
        .primitives = { floor_at(0) },
        .light = { .position = { 3, 4, 0 }, .color = { .5, 1, 1 } },
        .scene = { .ambient_light = { 2, 1, 1 },
                   .background = { .25, 0, 0 },
                   .light_count = 1,
                   .primitive_count = 1 },
    };
    stage->scene.lights = &stage->light;
    stage->scene.primitives = stage->primitives;
    stage->primitives[0].pigment.color[0][0] = .8;
}

static double seen(struct stage *stage)
{
    return red(look(&stage->scene, -3, 4, 0, 3, -4, 0));
}

TEST(ambient_and_diffuse)
{
    struct stage stage;
    set_stage(&stage);
    assert_close(seen(&stage), .5 * .8 * .8);
    stage.primitives[0].finish.ambient[0] = .1;
    assert_close(seen(&stage), .5 * .8 * .8 + .1 * 2 * .8);
    stage.light.position[1] = -4;
    assert_close(seen(&stage), .1 * 2 * .8);
    assert_close(red(look(&stage.scene, 0, 1, 0, 0, 1, 0)), .25);
}

TEST(highlights)
{
    struct stage stage;
    set_stage(&stage);
    struct finish *finish = &stage.primitives[0].finish;
    finish->diffuse = 0;
    finish->phong = .5;
    assert_close(seen(&stage), .5 * .5);
    finish->specular = .25;
    assert_close(seen(&stage), .5 * (.5 + .25));
    stage.light.position[0] = 0; /* cosine .8; half the angle for specular */
    assert_close(seen(&stage), .5 * (.5 * pow(.8, 40) + .25 * pow(sqrt(.9), 20)));
    stage.light.shadowless = true;
    assert_close(seen(&stage), 0);
}

TEST(shadows)
{
    struct stage stage;
    set_stage(&stage);
    double lit = .5 * .8 * .8;
    stage.primitives[1] = unit_sphere();
    stage.primitives[1].shape.sphere.center[0] = 1.5;
    stage.primitives[1].shape.sphere.center[1] = 2;
    assert_close(seen(&stage), lit);
    stage.scene.primitive_count = 2;
    assert_close(seen(&stage), 0);
    stage.light.shadowless = true;
    assert_close(seen(&stage), lit);
    stage.light.shadowless = false;
    stage.primitives[1].no_shadow = true;
    assert_close(seen(&stage), lit);
    stage.primitives[1].no_shadow = false;
    stage.light.position[0] = .75; /* in front of the sphere */
    stage.light.position[1] = 1;
    assert_close(seen(&stage), lit);
}

TEST(checker)
{
    struct primitive plane = floor_at(0);
    struct light light = { .position = { 0, 1e9, 0 }, .color = { 1, 1, 1 } };
    struct scene scene = {
        .light_count = 1, .lights = &light, .primitive_count = 1, .primitives = &plane
    };
    plane.pigment.kind = PIGMENT_CHECKER;
    plane.pigment.to_local.rows[0][0] = .5; /* squares with a width of 2 in x */
    for (int x = -3; x < 4; x++)
        for (int z = -3; z < 4; z++) {
            bool odd = (x + z) % 2 != 0;
            struct sample sample = look(&scene, 2 * x + 1, 1, z + .5, 0, -1, 0);
            assert_true(fabs(red(sample) - !odd) < 1e-6);
        }
}

/* ---- Frames compared --------------------------------------------------- */

TEST(compare)
{
    struct frame a, b;
    const struct comparison all = { "colour", CHANNEL_RED, 3, 1, false, .1, .05 };
    assert_true(frame_allocate(&a, 8, 5) && frame_allocate(&b, 8, 5));
    for (size_t i = 0; i < 40; i++)
        a.channel[CHANNEL_ID][i] = i % 8 < 4;
    FREED bool *inner = inner_pixels(&a);
    b.channel[CHANNEL_RED][3] = 9;    /* on the edge: ignored */
    b.channel[CHANNEL_GREEN][15] = 9; /* counts as 1 */
    b.channel[CHANNEL_BLUE][0] = .05; /* within the tolerance */
    struct picture_difference is = compare_pictures(&all, &a, &b, inner);
    assert_int_equal(is.compared, 30);
    assert_int_equal(is.ignored, 10);
    assert_int_equal(is.beyond, 1);
    assert_int_equal(is.worst_x, 7);
    assert_int_equal(is.worst_y, 1);
    assert_close(is.greatest, 1);
    assert_close(is.mean, 1.05 / 90);
    assert_true(within(&all, &is));
    b.channel[CHANNEL_RED][16] = NAN;
    is = compare_pictures(&all, &a, &b, inner);
    assert_int_equal(is.beyond, 2);
    assert_false(within(&all, &is));
    frame_free(&a);
    frame_free(&b);
}
