/* torus.c - the descriptor of tori: checks their arguments, computes their bounds and
 * the words of their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include <math.h>

#include "rt/shapes/tori.h"

static const struct shape_field fields[] = {
    { TAKES_NUMBER, SHAPE_AT(torus, major), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(torus, minor), NULL, 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *finish(struct primitive *primitive)
{
    double major = primitive->shape.torus.major;
    double minor = primitive->shape.torus.minor;
    if (major < 0 || minor <= 0)
        return shape_empty(primitive, "a radius is not above 0");
    if (major == 0) {
        primitive->kind = PRIMITIVE_SPHERE;
        primitive->shape.sphere.radius = minor;
        for (int i = 0; i < 3; i++)
            primitive->shape.sphere.center[i] = 0;
    }
    return NULL;
}

/* Bounds a torus by a sphere about its centre, and by the box around a cylinder that
 * contains the torus. */
void torus_bound(const struct primitive *primitive, double major, double radial,
                 double axial, struct bound *bound)
{
    static const double origin[3] = { 0, 0, 0 };
    const double base[3] = { 0, -axial, 0 }, cap[3] = { 0, axial, 0 };
    struct hull hull = { .count = 0 };
    bound_about(primitive, origin,
                bound_stretch(primitive, major, 0, major)
                    + bound_stretch(primitive, radial, axial, radial),
                bound);
    hull_rings(&hull, primitive, base, major + radial, cap, major + radial);
    bound_hull_box(&hull, bound);
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    double minor = primitive->shape.torus.minor;
    torus_bound(primitive, primitive->shape.torus.major, minor, minor, bound);
}

/* Writes the words of (x^2 + z^2 + rho y^2 + b0)^2 = a0 (x^2 + z^2): the coefficients,
 * values computed from them, a bounding sphere and two bounding planes. The bounds have
 * a margin for rounding errors. */
size_t torus_words(double major, double radial, double axial, double *words)
{
    double bound = 1.001 * (major + fmax(radial, axial));
    words[0] = (radial / axial) * (radial / axial);
    words[1] = (major - radial) * (major + radial);
    words[2] = 4 * major * major;
    words[3] = 2 * major * major;
    words[4] = bound * bound;
    words[5] = major * major + radial * radial;
    words[6] = radial * radial;
    words[7] = 8 * major * major;
    words[8] = bound * ROOT_RESOLUTION;
    words[9] = 1.001 * axial;
    return 10;
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    double minor = primitive->shape.torus.minor;
    return torus_words(primitive->shape.torus.major, minor, minor, words);
}

static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    double minor = primitive->shape.torus.minor;
    return emitter_torus(primitive->shape.torus.major, minor, minor, emitter);
}

const struct shape shape_torus = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .region = "torus",
    .emit = emit,
    .kernels = { .kernel = "torus",
                 .normal = "normal_torus",
                 .segments = 2,
                 .solid = "torus_solid" },
};
