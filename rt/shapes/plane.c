/* plane.c - the descriptor of planes: checks their arguments, computes the words of
 * their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/axis.h"
#include "rt/shapes/flat_faces.h"

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(plane, normal), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(plane, distance), NULL, 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* Normalises the normal, along which the distance of a plane is measured. */
static const char *finish(struct primitive *primitive)
{
    return axis_make_normal(primitive->shape.plane.normal);
}

/* Writes the plane in world space. Its normal n becomes P^T n, where P is the inverse
 * map. */
static size_t put_words(const struct primitive *primitive, double *words)
{
    const struct transform *back = &primitive->to_local;
    const double *normal = primitive->shape.plane.normal;
    double length;
    copy3(normal, words);
    transform_normal(back, words);
    words[3] = primitive->shape.plane.distance;
    for (size_t i = 0; i < 3; i++)
        words[3] -= normal[i] * back->rows[i][3];
    length = length3(words);
    for (size_t i = 0; i < 4; i++)
        words[i] /= length;
    return 4;
}

static bool carry(const struct primitive *primitive, double *words)
{
    (void)primitive;
    (void)words;
    return true;
}

static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    (void)primitive;
    (void)emitter;
    return "a plane is infinite and cannot emit";
}

static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    const double *normal = primitive->shape.plane.normal;
    double point[3];
    copy3(normal, point);
    scale3(primitive->shape.plane.distance, point);
    faces_add_flat(search, normal, point, true, &bound_none);
    return false;
}

const struct shape shape_plane = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = bound_without,
    .words = put_words,
    .carry = carry,
    .flat_faces = put_faces,
    .region = "plane",
    .emit = emit,
    .kernels = { .kernel = "plane", .normal = "normal_plane", .segments = 1 },
};
