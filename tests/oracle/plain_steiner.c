/* plain_steiner.c - quadratic triangular patches with weights.
 *
 * Two planes through the line intersect the patch in two conics of its parameters. If
 * all Bezier coefficients of a conic on a triangle have the same sign, the conic does
 * not cross the triangle, and neither does the line (convex hull property). The
 * triangles that remain after some subdivisions are the starting points of Newton's
 * method.
 */
#include "tests/oracle/plain_shapes.h"

#include <stdbool.h>

enum {
    HALVINGS = 12,
    STEPS = 60 /* number of Newton steps; near a tangent each step adds one bit */
};
#define CONVERGED 1e-15L /* length of the last step */
#define SAME 1e-9L       /* roots that are nearer are equal */
#define EDGE 1e-14L      /* a point this near to the patch is on it */

/* Bezier coefficients, in the order of the control points. */
struct conic {
    long double c[STEINER_POINTS];
};

/* Barycentric coordinates s, t, u, whose sum is 1. */
struct place {
    long double p[3];
};

struct search {
    struct conic conics[2];
    size_t count;
    struct place found[MAX_CROSSINGS];
};

static const int first_index[STEINER_POINTS] = { 0, 1, 2, 0, 1, 0 };
static const int second_index[STEINER_POINTS] = { 0, 1, 2, 1, 2, 2 };

static const struct place corners[3] = { { { 1, 0, 0 } },
                                         { { 0, 1, 0 } },
                                         { { 0, 0, 1 } } };

/* The polar form is linear in both places. For two equal places, its value is the value
 * of the conic. */
static long double polar(const struct conic *conic, const struct place *a,
                         const struct place *b)
{
    long double sum = 0;
    for (int k = 0; k < STEINER_POINTS; k++) {
        int i = first_index[k], j = second_index[k];
        sum += conic->c[k] * a->p[i] * b->p[j];
        if (i != j)
            sum += conic->c[k] * a->p[j] * b->p[i];
    }
    return sum;
}

/* ---- The conics ---------------------------------------------------------- */

/* Computes two directions perpendicular to the ray and to each other. */
static void plane_normals(const struct ray *ray, double normals[2][3])
{
    const double *d = ray->direction;
    double axis[3] = { 0, 0, 0 };
    int least = fabs(d[0]) < fabs(d[1]) ? 0 : 1;
    if (fabs(d[2]) < fabs(d[least]))
        least = 2;
    axis[least] = 1;
    cross_product(d, axis, normals[0]);
    normalise(normals[0]);
    cross_product(d, normals[0], normals[1]);
    normalise(normals[1]);
}

/* The coefficient of a control point is its height above the plane times its weight. */
static struct conic conic_of(const struct primitive *primitive, const struct ray *ray,
                             const double normal[3])
{
    struct conic conic;
    for (int k = 0; k < STEINER_POINTS; k++) {
        const double *point = primitive->shape.steiner_patch.points[k];
        conic.c[k] = 0;
        for (int i = 0; i < 3; i++)
            conic.c[k] += (long double)normal[i]
                          * ((long double)point[i] - ray->origin[i]);
        conic.c[k] *= primitive->shape.steiner_patch.weights[k];
    }
    return conic;
}

/* ---- The search ---------------------------------------------------------- */

static void note(struct search *search, const struct place *place)
{
    for (int i = 0; i < 3; i++)
        if (!(place->p[i] >= -EDGE))
            return;
    for (size_t k = 0; k < search->count; k++) {
        const long double *p = search->found[k].p;
        if (fabsl(p[0] - place->p[0]) + fabsl(p[1] - place->p[1]) < SAME)
            return;
    }
    if (search->count < MAX_CROSSINGS)
        search->found[search->count++] = *place;
}

/* Computes a conic's value and derivatives in s and t, where u = 1 - s - t. */
static void linearise(const struct conic *conic, const struct place *at,
                      long double terms[3])
{
    long double last = polar(conic, at, &corners[2]);
    terms[0] = polar(conic, at, at);
    terms[1] = 2 * (polar(conic, at, &corners[0]) - last);
    terms[2] = 2 * (polar(conic, at, &corners[1]) - last);
}

static void refine(struct search *search, struct place place)
{
    for (int i = 0; i < STEPS; i++) {
        long double a[3], b[3];
        linearise(&search->conics[0], &place, a);
        linearise(&search->conics[1], &place, b);
        long double determinant = a[1] * b[2] - a[2] * b[1];
        long double ds = (a[2] * b[0] - a[0] * b[2]) / determinant;
        long double dt = (a[0] * b[1] - a[1] * b[0]) / determinant;
        if (!(fabsl(ds) + fabsl(dt) < 2))
            return;
        place.p[0] += ds;
        place.p[1] += dt;
        place.p[2] = 1 - place.p[0] - place.p[1];
        if (fabsl(ds) + fabsl(dt) < CONVERGED) {
            note(search, &place);
            return;
        }
    }
}

static bool one_sign(const struct conic *conic, const struct place of[3])
{
    int above = 0, below = 0;
    for (int k = 0; k < STEINER_POINTS; k++) {
        long double value = polar(conic, &of[first_index[k]], &of[second_index[k]]);
        above += value > 0;
        below += value < 0;
    }
    return above == STEINER_POINTS || below == STEINER_POINTS;
}

static struct place middle(const struct place *a, const struct place *b)
{
    struct place place;
    for (int i = 0; i < 3; i++)
        place.p[i] = (a->p[i] + b->p[i]) / 2;
    return place;
}

static void look_within(struct search *search, const struct place of[3], int halvings)
{
    if (one_sign(&search->conics[0], of) || one_sign(&search->conics[1], of))
        return;
    const struct place half[3] = { middle(&of[1], &of[2]), middle(&of[2], &of[0]),
                                   middle(&of[0], &of[1]) };
    if (halvings == 0) {
        refine(search, middle(&half[0], &half[1]));
        return;
    }
    look_within(search, half, halvings - 1);
    for (int i = 0; i < 3; i++) {
        const struct place part[3] = { of[i], half[(i + 2) % 3], half[(i + 1) % 3] };
        look_within(search, part, halvings - 1);
    }
}

/* ---- Normals and distances ----------------------------------------------- */

/* H is the sum of the rows times s, t and u. A row is half of a derivative. */
struct homogeneous {
    double xyz[3], w;
};

static struct homogeneous row_of(const struct primitive *primitive, int row,
                                 const struct place *at)
{
    struct homogeneous sum = { { 0 }, 0 };
    for (int k = 0; k < STEINER_POINTS; k++) {
        int i = first_index[k], j = second_index[k];
        double weight = primitive->shape.steiner_patch.weights[k];
        if (i != row && j != row)
            continue;
        double share = (double)at->p[i == row ? j : i] * weight;
        add_scaled(sum.xyz, sum.xyz, share, primitive->shape.steiner_patch.points[k]);
        sum.w += share;
    }
    return sum;
}

/* Computes the point's derivative in s (or t), relative to u, divided by 2 / w. */
static void tangent(const struct homogeneous *by, const struct homogeneous *against,
                    const double point[3], double result[3])
{
    add_scaled(result, by->xyz, -1, against->xyz);
    add_scaled(result, result, against->w - by->w, point);
}

static struct crossing crossing_at(const struct primitive *primitive,
                                   const struct ray *ray, const struct place *at)
{
    struct homogeneous rows[3], sum = { { 0 }, 0 };
    struct crossing crossing;
    double from[3], tangents[2][3];
    for (int i = 0; i < 3; i++) {
        rows[i] = row_of(primitive, i, at);
        add_scaled(sum.xyz, sum.xyz, (double)at->p[i], rows[i].xyz);
        sum.w += (double)at->p[i] * rows[i].w;
    }
    scale_by(sum.xyz, 1 / sum.w);
    add_scaled(from, sum.xyz, -1, ray->origin);
    crossing.distance = dot(from, ray->direction) / dot(ray->direction, ray->direction);
    tangent(&rows[0], &rows[2], sum.xyz, tangents[0]);
    tangent(&rows[1], &rows[2], sum.xyz, tangents[1]);
    cross_product(tangents[0], tangents[1], crossing.normal);
    return crossing;
}

CROSS(cross_steiner_patch)
{
    struct search search = { .count = 0 };
    double normals[2][3];
    plane_normals(ray, normals);
    for (int i = 0; i < 2; i++)
        search.conics[i] = conic_of(primitive, ray, normals[i]);
    look_within(&search, corners, HALVINGS);
    for (size_t i = 0; i < search.count; i++)
        crossings[i] = crossing_at(primitive, ray, &search.found[i]);
    return search.count;
}
