/* sphere.c - the descriptor of spheres: checks their arguments, computes their bounds
 * and the words of their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include "rt/scene/vector3.h"
#include "rt/shapes/quadric_face.h"

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(sphere, center), NULL, 0, NULL },
    { TAKES_RADIUS, SHAPE_AT(sphere, radius), NULL, 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *finish(struct primitive *primitive)
{
    return primitive->shape.sphere.radius > 0
               ? NULL
               : shape_empty(primitive, "the radius is 0");
}

/* Bounds the ellipsoid that the sphere is in world space. Its extent along an axis is
 * the length of the axis's row of the matrix, multiplied by the radius. */
static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    double r = primitive->shape.sphere.radius;
    bound_about(primitive, primitive->shape.sphere.center,
                bound_stretch(primitive, r, r, r), bound);
    for (int i = 0; i < 3; i++) {
        double reach = r * length3(primitive->to_world.rows[i]);
        bound->low[i] = bound->center[i] - reach;
        bound->high[i] = bound->center[i] + reach;
    }
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    double r = primitive->shape.sphere.radius;
    copy3(primitive->shape.sphere.center, words);
    words[3] = r * r;
    words[4] = 1 / r;
    return 5;
}

/* Returns true if the transform maps spheres to spheres. The words then describe the
 * sphere in world space. */
static bool carry(const struct primitive *primitive, double *words)
{
    const double(*rows)[4] = primitive->to_world.rows;
    double scale = length3((const double[]){ rows[0][0], rows[1][0], rows[2][0] });
    const double *center = primitive->shape.sphere.center;
    double r = primitive->shape.sphere.radius * scale;
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++) {
            double dot = rows[0][i] * rows[0][j] + rows[1][i] * rows[1][j]
                         + rows[2][i] * rows[2][j];
            double want = i == j ? scale * scale : 0;
            if (fabs(dot - want) > 1e-12 * scale * scale)
                return false;
        }
    for (size_t i = 0; i < 3; i++)
        words[i] = rows[i][0] * center[0] + rows[i][1] * center[1]
                   + rows[i][2] * center[2] + rows[i][3];
    words[3] = r * r;
    words[4] = 1 / r;
    return true;
}

/* Describes the surface for the kernels that sample it (emitter.h): as the unit sphere,
 * scaled by the radius. */
static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    emitter->kernel = "emit_sphere";
    emitter->area = 4 * PI;
    for (size_t i = 0; i < 3; i++) {
        emitter->to_own.rows[i][i] = fabs(primitive->shape.sphere.radius);
        emitter->to_own.rows[i][3] = primitive->shape.sphere.center[i];
    }
    return NULL;
}

static void put_quadric(const struct primitive *primitive, double (*matrix)[4])
{
    static const double up[3] = { 0, 1, 0 };
    double radius = primitive->shape.sphere.radius;
    quadric_about_axis(primitive, primitive->shape.sphere.center, up, 0, 0,
                       radius * radius, matrix);
}

const struct shape shape_sphere = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .carry = carry,
    .quadric = put_quadric,
    .region = "sphere",
    .emit = emit,
    .kernels = { .kernel = "sphere", .normal = "normal_sphere", .segments = 1 },
};
