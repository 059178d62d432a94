/* cone.c - the descriptor of cones: checks their arguments, computes their bounds and
 * the words of their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include <math.h>

#include "rt/scene/vector3.h"
#include "rt/shapes/axis.h"
#include "rt/shapes/flat_faces.h"
#include "rt/shapes/quadric_face.h"

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(cone, base), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(cone, base_radius), NULL, 0, NULL },
    { TAKES_VECTOR, SHAPE_AT(cone, cap), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(cone, cap_radius), NULL, 0, NULL },
    { TAKES_WORD, SHAPE_AT(cone, open), "open", 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* Converts a cone with equal radii to a cylinder, as POV-Ray does. */
static void become_cylinder(struct primitive *primitive)
{
    struct primitive cone = *primitive;
    primitive->kind = PRIMITIVE_CYLINDER;
    copy3(cone.shape.cone.base, primitive->shape.cylinder.base);
    copy3(cone.shape.cone.cap, primitive->shape.cylinder.cap);
    primitive->shape.cylinder.radius = cone.shape.cone.base_radius;
    primitive->shape.cylinder.open = cone.shape.cone.open;
}

static const char *finish(struct primitive *primitive)
{
    double base = primitive->shape.cone.base_radius;
    double cap = primitive->shape.cone.cap_radius;
    if (axis_is_point(primitive->shape.cone.base, primitive->shape.cone.cap))
        return shape_empty(primitive, AXIS_IS_POINT);
    if (base < 0 || cap < 0)
        return shape_empty(primitive, "a radius of the cone is below 0");
    if (base == 0 && cap == 0)
        return shape_empty(primitive, "both radii of the cone are 0");
    if (base == cap)
        become_cylinder(primitive);
    return NULL;
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    struct hull hull = { .count = 0 };
    hull_rings(&hull, primitive, primitive->shape.cone.base,
               primitive->shape.cone.base_radius, primitive->shape.cone.cap,
               primitive->shape.cone.cap_radius);
    bound_hull(&hull, bound);
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    double base = primitive->shape.cone.base_radius;
    double cap = primitive->shape.cone.cap_radius;
    double length = axis_words(primitive->shape.cone.base, primitive->shape.cone.cap,
                               words);
    double slope = (cap - base) / length;
    words[12] = (base + cap) / 2;
    words[13] = slope;
    words[14] = length / 2;
    words[15] = 1 / sqrt(1 + slope * slope);
    return 16;
}

static bool is_open(const struct primitive *primitive)
{
    return primitive->shape.cone.open;
}

static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    return emitter_cone(primitive->shape.cone.base, primitive->shape.cone.base_radius,
                        primitive->shape.cone.cap, primitive->shape.cone.cap_radius,
                        primitive->shape.cone.open, emitter);
}

static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    if (!primitive->shape.cone.open)
        faces_add_disks(search, primitive->shape.cone.base,
                        primitive->shape.cone.base_radius, primitive->shape.cone.cap,
                        primitive->shape.cone.cap_radius);
    return true;
}

static void put_quadric(const struct primitive *primitive, double (*matrix)[4])
{
    quadric_of_cone(primitive, primitive->shape.cone.base,
                    primitive->shape.cone.base_radius, primitive->shape.cone.cap,
                    primitive->shape.cone.cap_radius, matrix);
}

const struct shape shape_cone = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .flat_faces = put_faces,
    .quadric = put_quadric,
    .region = "cone",
    .emit = emit,
    .kernels = { .kernel = "cone", .normal = "normal_cone", .segments = 1 },
    .is_other = is_open,
    .other = { .kernel = "open_cone",
               .normal = "normal_open_cone",
               .segments = 1,
               .state = "cone" },
};
