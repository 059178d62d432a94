/* box.c - the descriptor of boxes: checks their arguments, computes their bounds and
 * the words of their records, and names their kernels. */
#include "rt/shapes/shape.h"

#include <math.h>

#include "rt/shapes/flat_faces.h"

static const struct shape_field fields[] = {
    { TAKES_VECTOR, SHAPE_AT(box, corner), NULL, 2, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

static const char *finish(struct primitive *primitive)
{
    double *low = primitive->shape.box.corner[0];
    double *high = primitive->shape.box.corner[1];
    int flat = 0;
    for (int i = 0; i < 3; i++) {
        double a = low[i], b = high[i];
        low[i] = fmin(a, b);
        high[i] = fmax(a, b);
        flat += a == b;
    }
    return flat < 2 ? NULL : shape_empty(primitive, "the box has no area");
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

/* Adds the face that is perpendicular to axis i, at the upper or the lower end. */
static void emit_face(const double (*corner)[3], int i, int end,
                      struct emitter *emitter)
{
    static const int around[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
    double corners[4][3];
    for (int k = 0; k < 4; k++) {
        double *at = corners[end ? k : 3 - k];
        at[i] = corner[end][i];
        at[(i + 1) % 3] = corner[around[k][0]][(i + 1) % 3];
        at[(i + 2) % 3] = corner[around[k][1]][(i + 2) % 3];
    }
    emitter_add_triangle(emitter, corners[0], corners[1], corners[2]);
    emitter_add_triangle(emitter, corners[0], corners[2], corners[3]);
}

static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    if (!emitter_begin(emitter, "emit_triangle", 12, TRIANGLE_WORDS))
        return emitter_no_memory;
    for (int i = 0; i < 6; i++)
        emit_face(primitive->shape.box.corner, i / 2, i % 2, emitter);
    return NULL;
}

static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    const double(*corner)[3] = primitive->shape.box.corner;
    for (int i = 0; i < 6; i++) {
        int axis = i / 2, end = i % 2;
        double normal[3] = { 0 }, point[3];
        struct hull hull = { .count = 0 };
        normal[axis] = end ? 1 : -1;
        for (int k = 0; k < 4; k++) {
            point[axis] = corner[end][axis];
            point[(axis + 1) % 3] = corner[k & 1][(axis + 1) % 3];
            point[(axis + 2) % 3] = corner[k >> 1][(axis + 2) % 3];
            hull_point(&hull, primitive, point);
        }
        faces_add_hull(search, normal, point, true, &hull);
    }
    return false;
}

const struct shape shape_box = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .flat_faces = put_faces,
    .region = "box",
    .emit = emit,
    .kernels = { .kernel = "box", .normal = "normal_box", .segments = 1 },
};
