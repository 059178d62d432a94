/* patch.c - quadratic triangular patches. */
#include "rt/scene/patch.h"

#include "rt/scene/vector.h"

struct homogeneous {
    double xyz[3], w;
};

/* Row i at p is the sum of the b_ij p_j; H is the sum of the p_i rows. */
static struct homogeneous row_at(const struct primitive *patch, int i,
                                 const double p[3])
{
    static const int index[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };
    struct homogeneous sum = { { 0, 0, 0 }, 0 };

    for (int j = 0; j < 3; j++) {
        int k = index[i][j];
        double share = p[j] * patch->shape.steiner_patch.weights[k];
        for (int axis = 0; axis < 3; axis++)
            sum.xyz[axis] +=
                share * patch->shape.steiner_patch.points[k][axis];
        sum.w += share;
    }
    return sum;
}

/* The three rows are the last triangle of de Casteljau's rule, which lies in
 * the tangent plane: are its corners off one line? */
static bool is_regular(const struct primitive *patch, const double p[3])
{
    const double least = 1e-12; /* of height to length */
    struct homogeneous rows[3];
    double edges[2][3], normal[3], length;

    for (int i = 0; i < 3; i++)
        rows[i] = row_at(patch, i, p);
    for (int axis = 0; axis < 3; axis++) {
        double last = rows[2].xyz[axis] / rows[2].w;
        edges[0][axis] = rows[0].xyz[axis] / rows[0].w - last;
        edges[1][axis] = rows[1].xyz[axis] / rows[1].w - last;
    }
    cross3(edges[0], edges[1], normal);
    length = fmax(length3(edges[0]), length3(edges[1]));
    return length3(normal) > least * length * length;
}

/* The rows' determinants are of degree three in s, t, u: they vanish
 * everywhere if they do so at the ten points of a grid of thirds. */
bool patch_has_area(const struct primitive *patch)
{
    for (int i = 0; i <= 3; i++)
        for (int j = 0; i + j <= 3; j++) {
            const double p[3] = { i / 3., j / 3., (3 - i - j) / 3. };
            if (is_regular(patch, p))
                return true;
        }
    return false;
}
