/* cylinder.c - the descriptor of cylinders: checks their arguments, computes their
 * bounds and the words of their records, and names their kernels. */
#include "rt/shapes/axis.h"
#include "rt/shapes/shape.h"

#include "rt/scene/vector3.h"
#include "rt/shapes/flat_faces.h"
#include "rt/shapes/quadric_face.h"

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(cylinder, base), NULL, 0, NULL },
    { TAKES_VECTOR, SHAPE_AT(cylinder, cap), NULL, 0, NULL },
    { TAKES_RADIUS, SHAPE_AT(cylinder, radius), NULL, 0, NULL },
    { TAKES_WORD, SHAPE_AT(cylinder, open), "open", 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *finish(struct primitive *primitive)
{
    if (axis_is_point(primitive->shape.cylinder.base, primitive->shape.cylinder.cap))
        return shape_empty(primitive, AXIS_IS_POINT);
    return primitive->shape.cylinder.radius > 0
               ? NULL
               : shape_empty(primitive, "the radius is 0");
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    double radius = primitive->shape.cylinder.radius;
    struct hull hull = { .count = 0 };
    hull_rings(&hull, primitive, primitive->shape.cylinder.base, radius,
               primitive->shape.cylinder.cap, radius);
    bound_hull(&hull, bound);
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    double r = primitive->shape.cylinder.radius;
    double length = axis_words(primitive->shape.cylinder.base,
                               primitive->shape.cylinder.cap, words);
    words[12] = r * r;
    words[13] = length / 2;
    words[14] = 1 / (2 * r);
    words[15] = 1 / r;
    return 16;
}

/* Writes the plane p . X + q = 0 that is perpendicular to the axis and contains the
 * point. p is the axis if `along` is 1, and the opposite of the axis if it is -1. */
static void put_end(double along, const double axis[3], const double point[3],
                    double *plane)
{
    for (size_t i = 0; i < 3; i++)
        plane[i] = along * axis[i];
    plane[3] = -dot3(plane, point);
}

static size_t put_historical_words(const struct primitive *primitive, double *words)
{
    const double *base = primitive->shape.cylinder.base;
    const double *cap = primitive->shape.cylinder.cap;
    double frame[12];
    const double *axis = frame + 9; /* unit vector along the axis */
    axis_words(base, cap, frame);
    copy3(base, words);
    copy3(axis, words + 3);
    words[6] = primitive->shape.cylinder.radius;
    put_end(-1, axis, base, words + 7);
    put_end(1, axis, cap, words + 11);
    words[15] = 1 / words[6];
    return 16;
}

static bool is_open(const struct primitive *primitive)
{
    return primitive->shape.cylinder.open;
}

static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    double radius = primitive->shape.cylinder.radius;
    return emitter_cone(primitive->shape.cylinder.base, radius,
                        primitive->shape.cylinder.cap, radius,
                        primitive->shape.cylinder.open, emitter);
}

static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    double radius = primitive->shape.cylinder.radius;
    if (!primitive->shape.cylinder.open)
        faces_add_disks(search, primitive->shape.cylinder.base, radius,
                        primitive->shape.cylinder.cap, radius);
    return true;
}

static void put_quadric(const struct primitive *primitive, double (*matrix)[4])
{
    double radius = primitive->shape.cylinder.radius;
    quadric_of_cone(primitive, primitive->shape.cylinder.base, radius,
                    primitive->shape.cylinder.cap, radius, matrix);
}

const struct shape shape_cylinder = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .flat_faces = put_faces,
    .quadric = put_quadric,
    .region = "cylinder",
    .emit = emit,
    .kernels = { .kernel = "cylinder",
                 .normal = "normal_cylinder",
                 .segments = 1,
                 .historical = "clipped_cylinder",
                 .historical_normal = "normal_clipped_cylinder" },
    .is_other = is_open,
    .other = { .kernel = "open_cylinder",
               .normal = "normal_open_cylinder",
               .segments = 1,
               .state = "cylinder",
               .historical = "open_clipped_cylinder",
               .historical_normal = "normal_open_clipped_cylinder" },
    .historical_words = put_historical_words,
};
