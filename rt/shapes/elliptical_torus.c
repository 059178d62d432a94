/* elliptical_torus.c - the descriptor of elliptical tori: checks their arguments,
 * computes their bounds and the words of their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include "rt/shapes/tori.h"

static const struct shape_field fields[] = {
    { TAKES_NUMBER, SHAPE_AT(elliptical_torus, major), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(elliptical_torus, radial), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(elliptical_torus, axial), NULL, 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *finish(struct primitive *primitive)
{
    return primitive->shape.elliptical_torus.major > 0
                   && primitive->shape.elliptical_torus.radial > 0
                   && primitive->shape.elliptical_torus.axial > 0
               ? NULL
               : shape_empty(primitive, "a radius is not above 0");
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    torus_bound(primitive, primitive->shape.elliptical_torus.major,
                primitive->shape.elliptical_torus.radial,
                primitive->shape.elliptical_torus.axial, bound);
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    return torus_words(primitive->shape.elliptical_torus.major,
                       primitive->shape.elliptical_torus.radial,
                       primitive->shape.elliptical_torus.axial, words);
}

static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    return emitter_torus(primitive->shape.elliptical_torus.major,
                         primitive->shape.elliptical_torus.radial,
                         primitive->shape.elliptical_torus.axial, emitter);
}

const struct shape shape_elliptical_torus = {
    .fields = fields,
    .finish = finish,
    .bound = put_bound,
    .words = put_words,
    .region = "torus",
    .emit = emit,
    .kernels = { .kernel = "elliptical_torus",
                 .normal = "normal_torus",
                 .segments = 2,
                 .solid = "elliptical_torus_solid" },
};
