/* plain_mesh.c - meshes, by testing every triangle.
 *
 * The test solves origin + t direction = a + u (b - a) + v (c - a) by Cramer's rule, in
 * long doubles.
 */
#include "tests/oracle/plain_shapes.h"

#define EDGE 1e-13L     /* a point this near to a triangle is on it */
#define SAME 1e-12L     /* distances that differ by less are equal */
#define UNSURE 1e-10L   /* a ray that is nearer to an edge may miss it */
#define PARALLEL 1e-14L /* a line that is more nearly parallel misses */

typedef long double accurate[3];

static void difference(const double a[3], const double b[3], accurate result)
{
    for (int i = 0; i < 3; i++)
        result[i] = (long double)a[i] - b[i];
}

static void product(const accurate a, const accurate b, accurate result)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        result[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static long double sum_of(const accurate a, const accurate b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A line's hit with a triangle's plane, in barycentric coordinates of sum 1. */
struct meeting {
    long double distance, shares[3];
};

static bool is_parallel(long double across, const accurate normal,
                        const accurate direction)
{
    long double lengths = sqrtl(sum_of(normal, normal) * sum_of(direction, direction));
    return !(fabsl(across) > PARALLEL * lengths);
}

static bool meet_plane(const struct triangle *triangle, const struct ray *ray,
                       struct meeting *meeting)
{
    static const double zero[3] = { 0, 0, 0 };
    accurate edges[2], normal, from, direction, aside;
    difference(triangle->corners[1], triangle->corners[0], edges[0]);
    difference(triangle->corners[2], triangle->corners[0], edges[1]);
    difference(ray->origin, triangle->corners[0], from);
    difference(ray->direction, zero, direction);
    product(edges[0], edges[1], normal);
    product(from, direction, aside);
    long double across = sum_of(normal, direction);
    if (is_parallel(across, normal, direction))
        return false;
    meeting->distance = -sum_of(normal, from) / across;
    meeting->shares[1] = -sum_of(edges[1], aside) / across;
    meeting->shares[2] = sum_of(edges[0], aside) / across;
    meeting->shares[0] = 1 - meeting->shares[1] - meeting->shares[2];
    return true;
}

/* Interpolates the normals at the corners. Their lengths are ignored, as in POV-Ray. */
static void smooth_normal(const struct triangle *triangle,
                          const struct meeting *meeting, double normal[3])
{
    for (int i = 0; i < 3; i++)
        normal[i] = 0;
    for (int k = 0; k < 3; k++) {
        double corner[3];
        copy(corner, triangle->normals[k]);
        normalise(corner);
        add_scaled(normal, normal, (double)meeting->shares[k], corner);
    }
}

static void flat_normal(const struct triangle *triangle, double normal[3])
{
    accurate edges[2], across;
    difference(triangle->corners[1], triangle->corners[0], edges[0]);
    difference(triangle->corners[2], triangle->corners[0], edges[1]);
    product(edges[0], edges[1], across);
    for (int i = 0; i < 3; i++)
        normal[i] = (double)across[i];
}

static bool cross_triangle(const struct triangle *triangle, const struct ray *ray,
                           struct crossing *crossing)
{
    struct meeting meeting;
    if (!meet_plane(triangle, ray, &meeting))
        return false;
    for (int k = 0; k < 3; k++)
        if (!(meeting.shares[k] >= -EDGE))
            return false;
    crossing->distance = (double)meeting.distance;
    if (triangle->smooth)
        smooth_normal(triangle, &meeting, crossing->normal);
    else
        flat_normal(triangle, crossing->normal);
    return true;
}

/* ---- Nearest and sorted crossings ---------------------------------------- */

/* Orders crossings by distance, those ahead of the origin before the others. */
static bool goes_before(double a, double b)
{
    if ((a >= 0) != (b >= 0))
        return a >= 0;
    return fabs(a) < fabs(b);
}

/* Returns true if the list has a crossing at this distance. If a line crosses several
 * triangles at a point, as on an edge, only the first is stored. */
static bool is_known(const struct crossing *crossings, size_t count, double distance)
{
    long double within = SAME * (1 + fabsl(distance));
    for (size_t i = 0; i < count; i++)
        if (fabsl((long double)crossings[i].distance - distance) <= within)
            return true;
    return false;
}

/* Inserts a crossing. If there is no room, the last crossing is dropped. */
static size_t keep(struct crossing *crossings, size_t count,
                   const struct crossing *found)
{
    size_t at = count;
    while (at > 0 && goes_before(found->distance, crossings[at - 1].distance))
        at--;
    if (at == MAX_CROSSINGS)
        return count;
    size_t last = count < MAX_CROSSINGS ? count : MAX_CROSSINGS - 1;
    for (size_t i = last; i > at; i--)
        crossings[i] = crossings[i - 1];
    crossings[at] = *found;
    return last + 1;
}

CROSS(cross_mesh)
{
    const struct triangles *triangles = &primitive->shape.mesh.triangles;
    size_t count = 0;
    for (size_t i = 0; i < triangles->count; i++) {
        struct crossing found;
        if (cross_triangle(&triangles->list[i], ray, &found)
            && !is_known(crossings, count, found.distance))
            count = keep(crossings, count, &found);
    }
    return count;
}

/* ---- Inside -------------------------------------------------------------- */

/* Counts the crossings of a ray from a point. Returns -1 if the ray is so near to an
 * edge that the count is uncertain. */
static long count_ahead(const struct triangles *triangles, const struct ray *ray)
{
    long count = 0;
    for (size_t i = 0; i < triangles->count; i++) {
        struct meeting meeting;
        if (!meet_plane(&triangles->list[i], ray, &meeting))
            continue;
        long double least = fminl(meeting.shares[0],
                                  fminl(meeting.shares[1], meeting.shares[2]));
        if (fabsl(least) < UNSURE)
            return -1;
        count += least > 0 && meeting.distance > 0;
    }
    return count;
}

/* Returns true if a ray from the point crosses the mesh an odd number of times, as in
 * POV-Ray. The direction is arbitrary, because it does not matter for a closed mesh. */
ENCLOSE(in_mesh)
{
    enum { DIRECTIONS = 20 };
    const struct triangles *triangles = primitive->shape.mesh.solid
                                            ? &primitive->shape.mesh.triangles
                                            : &primitive->shape.mesh.body;
    struct ray ray;
    copy(ray.origin, point);
    for (int i = 0; i < DIRECTIONS; i++) {
        ray.direction[0] = sin(3 + 2.1 * i);
        ray.direction[1] = cos(1 + 3.3 * i);
        ray.direction[2] = sin(5.7 * i + .4);
        long count = count_ahead(triangles, &ray);
        if (count >= 0)
            return count % 2 != 0;
    }
    return false;
}
