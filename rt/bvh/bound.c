/* bound.c - computes spheres and boxes that enclose other bounds. */
#include "rt/bvh/bound.h"

#include <math.h>

#include "rt/scene/vector3.h"

/* The largest radius of a bound, and the largest distance of its centre from the
 * origin. Beyond these, sums of squares are not accurate enough, and the bound becomes
 * bound_none. */
#define MAX_BOUND 1e12

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
    return bound->radius <= MAX_BOUND && length3(bound->center) <= MAX_BOUND;
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

/* Returns the part that reaches farthest from a point, and sets *reach to its reach. */
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

/* Moves the centre towards the farthest part in decreasing steps, and returns the best
 * sphere of all steps. The exact minimum is not needed. Source: Badoiu and Clarkson
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

/* Enlarges the bound by the sum of three margins: 1/1000 of the radius; the rounding
 * error of a ray that comes from far away; twice k_delta (docs/solids.md). CSG tests
 * points up to k_delta before and after a crossing. If a ray misses the bound of a
 * solid, the solid must contain none of these points. */
void bound_add_margin(struct bound *bound)
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
