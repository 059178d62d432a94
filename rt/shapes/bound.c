/* bound.c - computes bounding spheres and boxes. */
#include "rt/shapes/bound.h"

#include <math.h>

#include "rt/scene/elementary.h"
#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"
#include "rt/shapes/singular.h"

/* Beyond this distance squares of sums are not accurate enough. */
#define GREATEST 1e12

const struct bound bound_none = {
    { 0, 0, 0 },
    BOUND_NONE,
    { -BOUND_NONE, -BOUND_NONE, -BOUND_NONE },
    { BOUND_NONE, BOUND_NONE, BOUND_NONE },
};

bool bound_is_none(const struct bound *bound)
{
    return bound->radius >= BOUND_NONE;
}

static bool is_sound(const struct bound *bound)
{
    return bound->radius <= GREATEST && length3(bound->center) <= GREATEST;
}

/* ---- Bounds of bounds ---------------------------------------------------- */

static double distance_to(const double *from, const struct bound *part)
{
    const double way[3] = { part->center[0] - from[0], part->center[1] - from[1],
                            part->center[2] - from[2] };

    return length3(way);
}

double bound_reach(const struct bound *bound, const double from[3])
{
    return distance_to(from, bound) + bound->radius;
}

/* Returns the part that reaches farthest from a point, and sets how far. */
static const struct bound *farthest(const struct bound *parts, size_t count,
                                    const double *from, double *reach)
{
    const struct bound *found = parts;

    *reach = 0;
    for (size_t i = 0; i < count; i++) {
        double far = bound_reach(&parts[i], from);

        if (far > *reach) {
            *reach = far;
            found = &parts[i];
        }
    }
    return found;
}

/* Computes the midpoint of the box around all parts. */
static void middle(const struct bound *parts, size_t count, double *center)
{
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;

        for (size_t i = 0; i < count; i++) {
            low = fmin(low, parts[i].center[axis] - parts[i].radius);
            high = fmax(high, parts[i].center[axis] + parts[i].radius);
        }
        center[axis] = (low + high) / 2;
    }
}

void bound_box(const struct bound *parts, size_t count, struct bound *whole)
{
    for (int axis = 0; axis < 3; axis++) {
        whole->low[axis] = INFINITY;
        whole->high[axis] = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            whole->low[axis] = fmin(whole->low[axis], parts[i].low[axis]);
            whole->high[axis] = fmax(whole->high[axis], parts[i].high[axis]);
        }
    }
}

/* Moves the centre towards the farthest part by decreasing steps, and keeps the best
 * centre on the way. The exact minimum is not needed. Source: Badoiu and Clarkson
 * 2003. */
void bound_enclose(const struct bound *parts, size_t count, struct bound *whole)
{
    enum { STEPS = 24 };
    double center[3], reach;

    *whole = bound_none;
    for (size_t i = 0; i < count; i++)
        if (!is_sound(&parts[i]))
            return;
    middle(parts, count, center);
    for (int step = 1; step <= STEPS && count > 0; step++) {
        const struct bound *far = farthest(parts, count, center, &reach);
        double distance = distance_to(center, far);

        if (reach < whole->radius) {
            copy3(center, whole->center);
            whole->radius = reach;
        }
        for (int i = 0; i < 3 && distance > 0; i++)
            center[i] += (far->center[i] - center[i]) * (reach / distance / (step + 1));
    }
    whole->radius *= 1 + 1e-12;
    bound_box(parts, count, whole);
}

void bound_common(const struct bound *parts, size_t count, struct bound *whole)
{
    *whole = bound_none;
    for (size_t i = 0; i < count; i++)
        if (parts[i].radius < whole->radius)
            *whole = parts[i];
    for (size_t i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++) {
            whole->low[axis] = fmax(whole->low[axis], parts[i].low[axis]);
            whole->high[axis] = fmin(whole->high[axis], parts[i].high[axis]);
        }
}

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

/* The points are the corners of a regular polygon around the circle. */
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

/* Adds 1/1000 of the radius, the rounding error of a ray that comes from far away, and
 * the distance from which an event is examined (twice k_delta, docs/solids.md): a solid
 * whose bound is missed must be on neither side of the event. */
static void add_margin(struct bound *bound)
{
    double margin = .001 * bound->radius + 1e-9 * length3(bound->center) + 2e-7;

    bound->radius += margin;
    for (int i = 0; i < 3; i++) {
        bound->low[i] -= margin;
        bound->high[i] += margin;
    }
    if (!is_sound(bound))
        *bound = bound_none;
}

void bound_primitive(const struct primitive *primitive, struct bound *bound)
{
    shape_of(primitive)->bound(primitive, bound);
    add_margin(bound);
}
