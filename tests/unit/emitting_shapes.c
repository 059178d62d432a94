/* emitting_shapes.c - makes random shapes that can emit. */
#include "tests/unit/emitting_shapes.h"

#include "rt/shapes/shape.h"
#include "tests/unit/plain_surface.h"
#include "tests/unit/scene_reading.h"

const enum primitive_kind emitting_kinds[EMITTING_KINDS] = { PRIMITIVE_SPHERE,
                                                             PRIMITIVE_BOX,
                                                             PRIMITIVE_CYLINDER,
                                                             PRIMITIVE_DISC,
                                                             PRIMITIVE_CONE,
                                                             PRIMITIVE_TORUS,
                                                             PRIMITIVE_ELLIPTICAL_TORUS,
                                                             PRIMITIVE_STEINER_PATCH,
                                                             PRIMITIVE_MESH };

static uint64_t *state;

static double some(double low, double high)
{
    return number_between(state, low, high);
}

static size_t between(size_t low, size_t high)
{
    return (size_t)xorshift_between(state, (int64_t)low, (int64_t)high);
}

static void some_place(double point[3])
{
    for (int i = 0; i < 3; i++)
        point[i] = some(-1, 1);
}

/* ---- Kinds of shapes ------------------------------------------------------ */

enum { TRIANGLES = 7 };
static struct triangle triangle_store[TRIANGLES];

static void draw_mesh(struct primitive *primitive)
{
    primitive->shape.mesh.triangles = (struct triangles){ between(1, TRIANGLES),
                                                          triangle_store };
    for (size_t i = 0; i < primitive->shape.mesh.triangles.count; i++)
        for (int k = 0; k < 3; k++)
            some_place(triangle_store[i].corners[k]);
}

static void draw_patch(struct primitive *primitive)
{
    static const double about[STEINER_POINTS][3] = { { 1, 0, 0 },  { 0, 1, 0 },
                                                     { 0, 0, 0 },  { .5, .5, 0 },
                                                     { 0, .5, 0 }, { .5, 0, 0 } };
    for (int k = 0; k < STEINER_POINTS; k++) {
        for (int i = 0; i < 3; i++)
            primitive->shape.steiner_patch.points[k][i] = about[k][i] + some(-.2, .2);
        primitive->shape.steiner_patch.weights[k] = 1;
    }
    if (between(0, 1))
        for (int k = 0; k < STEINER_POINTS; k++)
            primitive->shape.steiner_patch.weights[k] = some(.5, 2);
}

static void draw_axis(double base[3], double cap[3])
{
    some_place(base);
    some_place(cap);
    cap[between(0, 2)] += 1.5;
}

static void draw_cone(struct primitive *primitive)
{
    double radii[2] = { some(.1, 1), some(.1, 1) };
    if (between(0, 2) == 0)
        radii[between(0, 1)] = 0;
    draw_axis(primitive->shape.cone.base, primitive->shape.cone.cap);
    primitive->shape.cone.base_radius = radii[0];
    primitive->shape.cone.cap_radius = radii[1];
    primitive->shape.cone.open = between(0, 1);
}

static void draw_disc(struct primitive *primitive)
{
    double radius = some(.3, 1);
    some_place(primitive->shape.disc.center);
    random_direction(state, primitive->shape.disc.normal);
    primitive->shape.disc.radius = radius;
    primitive->shape.disc.hole = between(0, 1) ? some(.1, .9) * radius : 0;
}

static void draw_shape(struct primitive *primitive)
{
    switch (primitive->kind) {
    case PRIMITIVE_SPHERE:
        some_place(primitive->shape.sphere.center);
        primitive->shape.sphere.radius = some(.2, 1.5);
        break;
    case PRIMITIVE_BOX:
        draw_axis(primitive->shape.box.corner[0], primitive->shape.box.corner[1]);
        break;
    case PRIMITIVE_CYLINDER:
        draw_axis(primitive->shape.cylinder.base, primitive->shape.cylinder.cap);
        primitive->shape.cylinder.radius = some(.1, 1);
        primitive->shape.cylinder.open = between(0, 1);
        break;
    case PRIMITIVE_DISC: draw_disc(primitive); break;
    case PRIMITIVE_CONE: draw_cone(primitive); break;
    case PRIMITIVE_TORUS:
        primitive->shape.torus.major = some(.8, 1.5);
        primitive->shape.torus.minor = some(.1, .8);
        break;
    case PRIMITIVE_ELLIPTICAL_TORUS:
        primitive->shape.elliptical_torus.major = some(.8, 1.5);
        primitive->shape.elliptical_torus.radial = some(.1, .8);
        primitive->shape.elliptical_torus.axial = some(.1, 1);
        break;
    case PRIMITIVE_STEINER_PATCH: draw_patch(primitive); break;
    default: draw_mesh(primitive);
    }
}

void move_shape(struct primitive *primitive, const struct placement *placement)
{
    primitive->to_world = placement->to_world;
    primitive->to_local = placement->to_local;
    primitive->transformed = !placement_is_none(placement);
}

/* Rotates and moves a shape. Stretches or mirrors some shapes. */
static void draw_placement(struct primitive *primitive)
{
    double scale[3], angles[3], by[3];
    for (int i = 0; i < 3; i++) {
        scale[i] = some(.5, 2) * (between(0, 4) == 0 ? -1 : 1);
        angles[i] = some(-180, 180);
        by[i] = some(-2, 2);
    }
    struct placement placement = placement_rotation(angles);
    struct placement step = placement_scaling(scale);
    placement = placement_then(&placement, &step);
    step = placement_rotation(by);
    placement = placement_then(&placement, &step);
    step = placement_translation(by);
    placement = placement_then(&placement, &step);
    move_shape(primitive, &placement);
}

struct primitive draw_emitting(enum primitive_kind kind, uint64_t *random)
{
    struct primitive primitive = { .kind = kind, .line = 1 };
    state = random;
    draw_shape(&primitive);
    assert_null(shape_of(&primitive)->finish(&primitive));
    move_shape(&primitive, &placement_none);
    if (between(0, 3) > 0)
        draw_placement(&primitive);
    return primitive;
}
