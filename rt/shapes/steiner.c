/* steiner.c - computes the polynomials of a Steiner patch. */
#include "rt/shapes/steiner.h"

#include <string.h>

#include "rt/shapes/moving_planes.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"

/* The six control points, in the order of the monomials ss, tt, uu, st, tu and us. A
 * control point has x, y and z, relative to the centre and multiplied by the weight,
 * and the weight w. */
struct patch {
    double point[STEINER_POINTS][4];
    double center[3], bound;
};

/* The coefficients of H(s, t) = K0 + K1 s + K2 t + K3 s^2 + K4 s t + K5 t^2. Each has
 * the elements x, y, z and w. */
struct patch_polynomials {
    double k[6][4];
};

bool steiner_is_polynomial(const struct primitive *primitive)
{
    const double *weights = primitive->shape.steiner_patch.weights;
    for (int i = 1; i < STEINER_POINTS; i++)
        if (weights[i] != weights[0])
            return false;
    return true;
}

/* Computes weights that are 1 at the corners, by scaling s, t and u. The surface does
 * not change, but no part of it is then compressed into a corner of the parameter
 * space. The weights are finally divided by the greatest weight. */
static void read_weights(const struct primitive *primitive, double *weights)
{
    static const int ends[STEINER_POINTS][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 },
                                                 { 0, 1 }, { 1, 2 }, { 2, 0 } };
    const double *given = primitive->shape.steiner_patch.weights;
    double greatest = 0;
    for (int i = 0; i < STEINER_POINTS; i++) {
        double first = given[ends[i][0]], second = given[ends[i][1]];
        weights[i] = first == second ? given[i] / first
                                     : given[i] / sqrt(first) / sqrt(second);
        greatest = fmax(greatest, weights[i]);
    }
    for (int i = 0; i < STEINER_POINTS; i++)
        weights[i] /= greatest;
}

/* Reads the points and weights of a patch, relative to its centre, and computes its
 * bound. The weights are above 0, so the patch is inside the hull of its control
 * points. */
static void read_patch(const struct primitive *primitive, struct patch *patch)
{
    const double(*points)[3] = primitive->shape.steiner_patch.points;
    double weights[STEINER_POINTS];
    memset(patch, 0, sizeof *patch);
    read_weights(primitive, weights);
    for (int i = 0; i < STEINER_POINTS; i++)
        for (int axis = 0; axis < 3; axis++)
            patch->center[axis] += points[i][axis] / STEINER_POINTS;
    for (int i = 0; i < STEINER_POINTS; i++) {
        double *point = patch->point[i];
        for (int axis = 0; axis < 3; axis++)
            point[axis] = points[i][axis] - patch->center[axis];
        patch->bound = fmax(patch->bound, 1.001 * length3(point));
        point[3] = weights[i];
        for (int axis = 0; axis < 3; axis++)
            point[axis] *= point[3];
    }
}

/* Rotates the control points so that corner `first` becomes the first corner. */
static void turn_patch(const struct patch *patch, int first, struct patch *turned)
{
    *turned = *patch;
    for (int i = 0; i < 3; i++) {
        memcpy(turned->point[i], patch->point[(first + i) % 3],
               sizeof turned->point[i]);
        memcpy(turned->point[3 + i], patch->point[3 + (first + i) % 3],
               sizeof turned->point[i]);
    }
}

static void form_polynomials(const struct patch *patch,
                             struct patch_polynomials *polynomials)
{
    const double *ss = patch->point[0], *tt = patch->point[1];
    const double *uu = patch->point[2], *st = patch->point[3];
    const double *tu = patch->point[4], *us = patch->point[5];
    double(*k)[4] = polynomials->k;

    for (int i = 0; i < 4; i++) {
        k[0][i] = uu[i];
        k[1][i] = 2 * (us[i] - uu[i]);
        k[2][i] = 2 * (tu[i] - uu[i]);
        k[3][i] = ss[i] - 2 * us[i] + uu[i];
        k[4][i] = 2 * (st[i] - us[i] - tu[i] + uu[i]);
        k[5][i] = tt[i] - 2 * tu[i] + uu[i];
    }
}

/* Reads the patch in the rotation in which K5 is longest, and its polynomials. K5 is
 * the second difference along the edge from the second to the third corner. */
static void read_best(const struct primitive *primitive, struct patch *best,
                      struct patch_polynomials *polynomials)
{
    struct patch patch, turned;
    struct patch_polynomials other;
    read_patch(primitive, &patch);
    *best = patch;
    form_polynomials(&patch, polynomials);
    for (int first = 1; first < 3; first++) {
        turn_patch(&patch, first, &turned);
        form_polynomials(&turned, &other);
        if (length3(other.k[5]) > 1.001 * length3(polynomials->k[5])) {
            *best = turned;
            *polynomials = other;
        }
    }
}

/* Computes a vector perpendicular to K5 and to the first of K2, K4, K1, K3 and K0 that
 * is not parallel to K5. Returns false if there is no such coefficient. */
static bool square_to_last(const double (*k)[3], double *square)
{
    static const int order[] = { 2, 4, 1, 3, 0 };
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        const double *of = k[order[i]];
        cross3(of, k[5], square);
        if (length3(square) > 1e-9 * length3(of) * length3(k[5]))
            return true;
    }
    return false;
}

/* Computes a vector for rays that are parallel to K5. The kernel uses the plane through
 * the ray and the vector, which must cross the curves of constant s. The vector is
 * therefore perpendicular to K5 and K2, or to K5 and K4 if K2 is parallel to K5. If K5
 * is 0, every ray uses the vector; it is then perpendicular to K2, in the plane of the
 * patch. */
static void other_plane(const struct patch_polynomials *polynomials, double bound,
                        double *other)
{
    double k[6][3], normal[3], length;
    for (int i = 0; i < 6; i++)
        for (int axis = 0; axis < 3; axis++)
            k[i][axis] = polynomials->k[i][axis] / bound;
    if (!square_to_last((const double(*)[3])k, other)) {
        cross3(k[1], k[2], normal);
        cross3(k[2], normal, other);
    }
    if (length3(other) == 0)
        memcpy(other, length3(k[1]) > 0 ? k[1] : k[2], sizeof normal);
    length = length3(other);
    for (int i = 0; i < 3; i++)
        other[i] *= bound / length;
}

void steiner_shape(const struct primitive *primitive, double *shape)
{
    struct patch patch;
    struct patch_polynomials best;
    read_best(primitive, &patch, &best);
    memcpy(shape, patch.center, sizeof patch.center);
    shape[3] = patch.bound * patch.bound;
    shape[4] = 0x1p-72;
    if (steiner_is_polynomial(primitive))
        shape[4] *= length3(best.k[5]) * length3(best.k[5]);
    shape[5] = 0x1p-20 * patch.bound * patch.bound;
    shape[6] = ROOT_RESOLUTION * patch.bound;
}

/* Writes the implicit form (rt/kernels/shapes/steiner_implicit.s): the moving planes L1
 * and L2, the triple point T, and the quadratic forms of x, y, z and w. L1, L2 and T
 * are computed for the patch scaled to size 1, and then scaled back. Returns 0 if the
 * degree of the surface is not four. */
static size_t put_implicit(const struct patch *patch, double *table)
{
    struct moving_planes planes;
    double scaled[STEINER_POINTS][4];
    double *next = table;
    for (int i = 0; i < STEINER_POINTS; i++)
        for (int c = 0; c < 4; c++)
            scaled[i][c] = patch->point[i][c] / (c < 3 ? patch->bound : 1);
    moving_planes_find((const double(*)[4])scaled, &planes);
    if (planes.type != SURFACE_STEINER)
        return 0;
    for (int row = 0; row < 6; row++)
        for (int c = 0; c < 4; c++)
            *next++ = planes.l[row / 3][row % 3][c] / (c < 3 ? patch->bound : 1);
    for (int c = 0; c < 4; c++)
        *next++ = planes.triple[c] * (c < 3 ? patch->bound : 1);
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < STEINER_POINTS; i++)
            *next++ = patch->point[i][c];
    return (size_t)(next - table);
}

size_t steiner_table(const struct primitive *primitive, double *table)
{
    struct patch patch;
    struct patch_polynomials best;
    read_best(primitive, &patch, &best);
    for (int k = 0; k < 6; k++) {
        memcpy(table + 3 * k, best.k[k], 3 * sizeof *table);
        table[18 + k] = best.k[k][3];
    }
    other_plane(&best, patch.bound, table + 24);
    return STEINER_TABLE + put_implicit(&patch, table + STEINER_TABLE);
}
