#include "rt/shapes/shape.h"

#include <math.h>

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(box, corner), NULL, 2, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *settle(struct primitive *primitive)
{
    double *low = primitive->shape.box.corner[0];
    double *high = primitive->shape.box.corner[1];

    for (int i = 0; i < 3; i++) {
        double a = low[i], b = high[i];

        low[i] = fmin(a, b);
        high[i] = fmax(a, b);
    }
    return NULL;
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    const double(*corner)[3] = primitive->shape.box.corner;
    struct hull hull = { .count = 0 };

    for (int i = 0; i < 8; i++) {
        const double point[3] = { corner[i & 1][0], corner[i >> 1 & 1][1],
                                  corner[i >> 2][2] };
        hull_point(&hull, primitive, point);
    }
    bound_hull(&hull, bound);
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    const double *low = primitive->shape.box.corner[0];
    const double *high = primitive->shape.box.corner[1];

    for (size_t i = 0; i < 3; i++) {
        words[i] = low[i];
        words[3 + i] = high[i];
        words[6 + i] = (low[i] + high[i]) / 2;
        words[9 + i] = (high[i] - low[i]) / 2;
    }
    return 12;
}

const struct shape shape_box = {
    .fields = fields,
    .settle = settle,
    .povray = "box",
    .bound = put_bound,
    .words = put_words,
    .region = "box",
    .kernels = { .kernel = "box", .normal = "normal_box", .segments = 1 },
};
