/* shape_bound.c - computes bounding spheres and boxes of primitives. */
#include "rt/shapes/shape_bound.h"

#include <math.h>

#include "rt/scene/elementary.h"
#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"
#include "rt/shapes/singular.h"

/* ---- Hulls --------------------------------------------------------------- */

void hull_point(struct hull *hull, const struct primitive *primitive,
                const double point[3])
{
    struct bound *added = &hull->points[hull->count++];
    copy3(point, added->center);
    transform_point(&primitive->to_world, added->center);
    added->radius = 0;
    copy3(added->center, added->low);
    copy3(added->center, added->high);
}

/* Adds the corners of a regular polygon around the circle. */
void hull_ring(struct hull *hull, const struct primitive *primitive,
               const double center[3], const double axis[3], double radius)
{
    double across[3] = { 0, 0, 0 }, u[3], v[3];
    across[fabs(axis[0]) <= fmax(fabs(axis[1]), fabs(axis[2])) ? 0 : 1] = 1;
    cross3(axis, across, u);
    scale3(1 / length3(u), u);
    cross3(axis, u, v);
    scale3(1 / length3(v), v);
    radius /= elementary_cos(PI / RING);
    for (int i = 0; i < RING; i++) {
        double c = radius * elementary_cos(2 * PI * i / RING);
        double s = radius * elementary_sin(2 * PI * i / RING);
        double point[3];
        for (int k = 0; k < 3; k++)
            point[k] = center[k] + c * u[k] + s * v[k];
        hull_point(hull, primitive, point);
    }
}

void hull_rings(struct hull *hull, const struct primitive *primitive,
                const double base[3], double base_radius, const double cap[3],
                double cap_radius)
{
    const double axis[3] = { cap[0] - base[0], cap[1] - base[1], cap[2] - base[2] };
    hull_ring(hull, primitive, base, axis, base_radius);
    hull_ring(hull, primitive, cap, axis, cap_radius);
}

void bound_hull(const struct hull *hull, struct bound *bound)
{
    bound_enclose(hull->points, hull->count, bound);
}

void bound_hull_box(const struct hull *hull, struct bound *bound)
{
    bound_box(hull->points, hull->count, bound);
}

/* ---- Extents of shapes --------------------------------------------------- */

double bound_stretch(const struct primitive *primitive, double x, double y, double z)
{
    const double weights[3] = { x, y, z };
    struct singular matrix = { .rows = 3, .columns = 3 };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            matrix.scaled[i][j] = primitive->to_world.rows[i][j] * weights[j];
    singular_decompose(&matrix);
    return fmax(matrix.values[0], fmax(matrix.values[1], matrix.values[2]));
}

void bound_about(const struct primitive *primitive, const double center[3],
                 double reach, struct bound *bound)
{
    copy3(center, bound->center);
    transform_point(&primitive->to_world, bound->center);
    bound->radius = reach;
    for (int i = 0; i < 3; i++) {
        bound->low[i] = bound->center[i] - reach;
        bound->high[i] = bound->center[i] + reach;
    }
}

void bound_without(const struct primitive *primitive, struct bound *bound)
{
    (void)primitive;
    *bound = bound_none;
}

void bound_primitive(const struct primitive *primitive, struct bound *bound)
{
    shape_of(primitive)->bound(primitive, bound);
    bound_add_margin(bound);
}
