/* patch.c - tests whether quadratic triangular patches have an area. */
#include "rt/shapes/patch.h"

#include "rt/scene/vector3.h"

struct homogeneous {
    double xyz[3], w;
};

/* Returns corner i of the last triangle of de Casteljau's algorithm at p, in
 * homogeneous coordinates: the sum of p[j] times the control point between corners i
 * and j. */
static struct homogeneous row_at(const struct primitive *patch, int i,
                                 const double p[3])
{
    static const int index[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };
    struct homogeneous sum = { { 0, 0, 0 }, 0 };
    for (int j = 0; j < 3; j++) {
        int k = index[i][j];
        double share = p[j] * patch->shape.steiner_patch.weights[k];
        for (int axis = 0; axis < 3; axis++)
            sum.xyz[axis] += share * patch->shape.steiner_patch.points[k][axis];
        sum.w += share;
    }
    return sum;
}

/* Returns true if the patch has a tangent plane at p: if the corners of the last
 * triangle of de Casteljau's algorithm (row_at), which is in this plane, are not
 * collinear. The edges are scaled to the size of the triangle, because products of
 * small edges may underflow. */
static bool is_regular(const struct primitive *patch, const double p[3])
{
    double least = 1e-12; /* least height relative to the length */
    struct homogeneous rows[3];
    double edges[2][3], normal[3], size = 0;
    for (int i = 0; i < 3; i++)
        rows[i] = row_at(patch, i, p);
    for (int i = 0; i < 2; i++)
        for (int axis = 0; axis < 3; axis++) {
            edges[i][axis] = rows[i].xyz[axis] / rows[i].w
                             - rows[2].xyz[axis] / rows[2].w;
            size = fmax(size, fabs(edges[i][axis]));
        }
    scale3(1 / size, edges[0]);
    scale3(1 / size, edges[1]);
    cross3(edges[0], edges[1], normal);
    return length3(normal) > least;
}

/* Tests a grid of ten points with spacing 1/3. If the last triangles of de Casteljau's
 * algorithm have no area there, they have none anywhere, because the determinant of
 * their corners is a cubic polynomial in s, t and u. */
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
