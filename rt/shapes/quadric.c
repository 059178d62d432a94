/* quadric.c - the descriptor of quadrics: checks their arguments, computes the words of
 * their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include "rt/shapes/quadric_face.h"
#include "rt/shapes/singular.h"
#include "rt/shapes/terms.h"

/* The arguments are three vectors and the constant. */
static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(quadric, coefficients), NULL, 3, NULL },
    { TAKES_NUMBER, SHAPE_AT(quadric, coefficients[9]), NULL, 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *finish(struct primitive *primitive)
{
    return terms_finish(primitive, primitive->shape.quadric.coefficients,
                        QUADRIC_TERMS);
}

/* Writes X A X + 2 g X + k relative to the centre c, which solves A c = -g. If there
 * are many centres, c is closest to the origin. If there is none, c is the
 * least-squares solution. */
static size_t put_words(const struct primitive *primitive, double *words)
{
    enum { CENTER = 0, MATRIX = 3, LINEAR = 9, CONSTANT = 12 };
    static const size_t place[3][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 } };
    const double *terms = primitive->shape.quadric.coefficients;
    struct singular matrix = { .rows = 3, .columns = 3 };
    double *center = words + CENTER, against[3];
    for (size_t i = 0; i < 6; i++)
        words[MATRIX + i] = i < 3 ? terms[i] : terms[i] / 2;
    for (size_t i = 0; i < 3; i++)
        against[i] = -terms[6 + i] / 2;
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            matrix.scaled[i][j] = words[MATRIX + place[i][j]];
    singular_decompose(&matrix);
    singular_solve(&matrix, 1e-6, against, center);
    words[CONSTANT] = terms[9];
    for (size_t i = 0; i < 3; i++) {
        double product = 0;
        for (size_t j = 0; j < 3; j++)
            product += words[MATRIX + place[i][j]] * center[j];
        words[LINEAR + i] = product - against[i];
        words[CONSTANT] += center[i] * (words[LINEAR + i] - against[i]);
    }
    return 13;
}

static void put_quadric(const struct primitive *primitive, double (*matrix)[4])
{
    quadric_of_terms(primitive, primitive->shape.quadric.coefficients, matrix);
}

const struct shape shape_quadric = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = bound_without,
    .words = put_words,
    .quadric = put_quadric,
    .region = "quadric",
    .kernels = { .kernel = "quadric",
                 .normal = "normal_quadric",
                 .segments = 2,
                 .solid = "quadric_solid" },
};
