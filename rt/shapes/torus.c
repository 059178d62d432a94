#include "rt/shapes/shape.h"

#include <math.h>

#include "rt/shapes/torus_words.h"

static const struct shape_field fields[] = {
    { TAKES_SIZE, SHAPE_AT(torus, major), "major radius", 0, NULL },
    { TAKES_SIZE, SHAPE_AT(torus, minor), "minor radius", 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* A circle about y, and from there the tube. */
static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    static const double origin[3] = { 0, 0, 0 };
    double major = primitive->shape.torus.major;
    double minor = primitive->shape.torus.minor;

    bound_about(primitive, origin,
                bound_stretch(primitive, major, 0, major)
                    + bound_stretch(primitive, minor, minor, minor),
                bound);
}

/* (x^2 + z^2 + rho y^2 + b0)^2 = a0 (x^2 + z^2) of the half axes p, n of the
 * tube, and a sphere and two planes about it that rounding cannot reach. */
size_t torus_words(double major, double p, double n, double *words)
{
    double bound = 1.001 * (major + fmax(p, n));

    words[0] = (p / n) * (p / n);
    words[1] = (major - p) * (major + p);
    words[2] = 4 * major * major;
    words[3] = 2 * major * major;
    words[4] = bound * bound;
    words[5] = major * major + p * p;
    words[6] = p * p;
    words[7] = 8 * major * major;
    words[8] = bound * ROOT_RESOLUTION;
    words[9] = 1.001 * n;
    return 10;
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    double minor = primitive->shape.torus.minor;

    return torus_words(primitive->shape.torus.major, minor, minor, words);
}

const struct shape shape_torus = {
    .fields = fields,
    .settle = shape_as_read,
    .povray = "torus",
    .bound = put_bound,
    .words = put_words,
    .region = "torus",
    .kernels = { .kernel = "torus",
                 .normal = "normal_torus",
                 .segments = 2,
                 .solid = "torus_solid" },
};
