/* steiner_patch.c - the descriptor of Steiner patches: checks their arguments, computes
 * their bounds and the words of their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include <string.h>

#include "rt/shapes/patch.h"
#include "rt/shapes/steiner.h"

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(steiner_patch, points), NULL, STEINER_POINTS, NULL },
    { TAKES_SIZE, SHAPE_AT(steiner_patch, weights), "weight", STEINER_POINTS,
      "weights" },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* Sets all weights to 1 if none is specified. */
static const char *finish(struct primitive *primitive)
{
    double *weights = primitive->shape.steiner_patch.weights;
    for (size_t i = 0; i < STEINER_POINTS && weights[i] == 0; i++)
        weights[i] = 1;
    return patch_has_area(primitive) ? NULL
                                     : shape_empty(primitive, "the patch has no area");
}

/* Bounds the hull of the control points. The patch is inside this hull, because its
 * weights are above 0. */
static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    struct hull hull = { .count = 0 };
    for (int i = 0; i < STEINER_POINTS; i++)
        hull_point(&hull, primitive, primitive->shape.steiner_patch.points[i]);
    bound_hull(&hull, bound);
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    steiner_shape(primitive, words);
    return STEINER_SHAPE;
}

static size_t put_table(const struct primitive *primitive,
                        const struct viewpoints *viewpoints, double *table)
{
    double found[MAX_STEINER_TABLE];
    size_t count = steiner_table(primitive, found);
    (void)viewpoints;
    if (table)
        memcpy(table, found, count * sizeof *table);
    return count;
}

/* Returns true if the patch has an implicit form, as only surfaces of degree four
 * have. */
static bool is_historical(const struct primitive *primitive)
{
    return put_table(primitive, NULL, NULL) > STEINER_TABLE;
}

/* Describes the surface by the coefficients K0 .. K5 of its polynomial: six for x, then
 * for y, z and w. rt/kernels/heat/emit_steiner_patch.s expects twice K3 and K5, the
 * coefficients of the squares. */
static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    static const double times[STEINER_POINTS] = { 1, 1, 1, 2, 1, 2 };
    double shape[STEINER_SHAPE], table[MAX_STEINER_TABLE];
    steiner_shape(primitive, shape);
    steiner_table(primitive, table);
    for (int k = 0; k < STEINER_POINTS; k++) {
        for (int axis = 0; axis < 3; axis++)
            emitter->form[6 * axis + k] = times[k] * table[3 * k + axis];
        emitter->form[18 + k] = times[k] * table[18 + k];
    }
    for (int axis = 0; axis < 3; axis++)
        emitter->to_own.rows[axis][3] = shape[axis];
    emitter->kernel = "emit_steiner_patch";
    emitter->area = .5;
    return NULL;
}

const struct shape shape_steiner_patch = {
    .fields = fields,
    .finish = finish,
    .bound = put_bound,
    .words = put_words,
    .table = put_table,
    .region = "steiner",
    .emit = emit,
    .kernels = { .kernel = "rational_steiner",
                 .normal = "normal_rational_steiner",
                 .solid = "rational_steiner_crossings",
                 .historical = "rational_steiner_implicit" },
    .is_other = steiner_is_polynomial,
    .other = { .kernel = "steiner",
               .normal = "normal_steiner",
               .solid = "steiner_crossings",
               .historical = "steiner_implicit" },
    .is_historical = is_historical,
};
