/* quartic.c - the descriptor of quartics: computes the words of their records, and
 * names their kernels. Also checks the coefficients of all polynomial surfaces
 * (terms.h). */
#include "rt/shapes/shape.h"

#include <math.h>
#include <string.h>

#include "rt/shapes/terms.h"

static const struct shape_field fields[] = {
    { TAKES_TERMS, SHAPE_AT(quartic, coefficients), NULL, QUARTIC_TERMS, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

const char *terms_finish(struct primitive *primitive, const double *coefficients,
                         size_t count)
{
    for (size_t i = 0; i + 1 < count; i++)
        if (coefficients[i] != 0)
            return NULL;
    return shape_empty(primitive, "all coefficients of the surface are 0");
}

static const char *finish(struct primitive *primitive)
{
    return terms_finish(primitive, primitive->shape.quartic.coefficients,
                        QUARTIC_TERMS);
}

/* Replaces x, y and z by x / 2^log, y / 2^log and z / 2^log, and multiplies all terms
 * by 2^(4 log). */
void quartic_enlarge(struct primitive *quartic, int log)
{
    double *coefficient = quartic->shape.quartic.coefficients;
    struct transform *to_world = &quartic->to_world;
    for (int x = 4; x >= 0; x--)
        for (int y = 4 - x; y >= 0; y--)
            for (int z = 4 - x - y; z >= 0; z--, coefficient++)
                *coefficient = ldexp(*coefficient, log * (4 - x - y - z));
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++) {
            if (k < 3)
                to_world->rows[i][k] = ldexp(to_world->rows[i][k], -log);
            quartic->to_local.rows[i][k] = ldexp(quartic->to_local.rows[i][k], log);
        }
}

/* Writes the largest distance of a root, which is POV-Ray's limit, and the accuracy of
 * a root. */
static size_t put_words(const struct primitive *primitive, double *words)
{
    (void)primitive;
    words[0] = 1e7;
    words[1] = ROOT_RESOLUTION;
    return 2;
}

static size_t put_table(const struct primitive *primitive,
                        const struct viewpoints *viewpoints, double *table)
{
    (void)viewpoints;
    if (table)
        memcpy(table, primitive->shape.quartic.coefficients,
               QUARTIC_TERMS * sizeof *table);
    return QUARTIC_TERMS;
}

const struct shape shape_quartic = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = bound_without,
    .words = put_words,
    .table = put_table,
    .region = "quartic_surface",
    .kernels = { .kernel = "quartic_surface",
                 .normal = "normal_quartic",
                 .segments = 3,
                 .solid = "quartic_solid" },
};
