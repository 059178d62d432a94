/* plain_quadratic_prism.c - prisms of quadratic splines. Each side is a parabola that
 * is extruded along y. A cap covers the points that an odd number of loops encloses. */
#include "tests/oracle/plain_shapes.h"

/* The curve from (1 - w)^2 + 2 handle w (1 - w) + to w^2. */
struct arc {
    const double *from, *handle, *to;
};
struct arcs {
    const struct outline *path;
    size_t next, first;
};

static bool take_arc(struct arcs *arcs, struct arc *arc)
{
    const double(*points)[2] = (const double(*)[2])arcs->path->points;
    const double *first = points[arcs->first];
    if (arcs->next + 2 >= arcs->path->count)
        return false;
    *arc = (struct arc){ points[arcs->next], points[arcs->next + 1],
                         points[arcs->next + 2] };
    arcs->next += 2;
    if (arc->to[0] == first[0] && arc->to[1] == first[1])
        arcs->first = ++arcs->next;
    return true;
}

static double place_at(const struct arc *arc, int k, double w)
{
    return arc->from[k] * (1 - w) * (1 - w) + 2 * arc->handle[k] * w * (1 - w)
           + arc->to[k] * w * w;
}

static double slope_at(const struct arc *arc, int k, double w)
{
    return 2 * (arc->handle[k] - arc->from[k]) * (1 - w)
           + 2 * (arc->to[k] - arc->handle[k]) * w;
}

/* Computes the parameters w at which x nx + z nz = c. If both ends are on the same side
 * of the line, there are two or none. Otherwise there is one. */
static size_t meet_line(const struct arc *arc, double nx, double nz, double c,
                        double w[2])
{
    double p0 = nx * arc->from[0] + nz * arc->from[1] - c;
    double p1 = nx * arc->handle[0] + nz * arc->handle[1] - c;
    double p2 = nx * arc->to[0] + nz * arc->to[1] - c;
    double a = p0 - 2 * p1 + p2, b = p1 - p0, root = sqrt(b * b - a * p0);
    double q = b < 0 ? root - b : -root - b;
    w[0] = q / a;
    w[1] = q == 0 ? w[0] : p0 / q;
    if ((p0 > 0) == (p2 > 0))
        return w[0] > 0 && w[0] < 1 && w[1] > 0 && w[1] < 1 ? 2 : 0;
    if (!(fabs(w[0] - .5) < fabs(w[1] - .5)))
        w[0] = w[1];
    return 1;
}

/* Returns true if the number of crossings at z with a greater x is odd: inside. */
static bool is_round(const struct outline *path, double x, double z)
{
    struct arcs arcs = { .path = path };
    struct arc arc;
    bool inside = false;
    while (take_arc(&arcs, &arc)) {
        double w[2];
        size_t count = meet_line(&arc, 0, 1, z, w);
        for (size_t i = 0; i < count; i++)
            inside ^= place_at(&arc, 0, w[i]) > x;
    }
    return inside;
}

ENCLOSE(in_quadratic_prism)
{
    return point[1] > primitive->shape.quadratic_prism.low
           && point[1] < primitive->shape.quadratic_prism.high
           && is_round(&primitive->shape.quadratic_prism.path, point[0], point[2]);
}

static size_t cross_sides(const struct primitive *primitive, const struct arc *arc,
                          const struct ray *ray, struct crossing *crossings)
{
    const double *o = ray->origin, *d = ray->direction;
    double w[2], level = d[0] * d[0] + d[2] * d[2];
    double apart = d[2] * o[0] - d[0] * o[2];
    size_t count = 0, roots = meet_line(arc, d[2], -d[0], apart, w);
    for (size_t i = 0; i < roots; i++) {
        double x = place_at(arc, 0, w[i]) - o[0];
        double z = place_at(arc, 1, w[i]) - o[2];
        double distance = (x * d[0] + z * d[2]) / level;
        double y = o[1] + distance * d[1];
        crossings[count] = (struct crossing){
            distance, { slope_at(arc, 1, w[i]), 0, -slope_at(arc, 0, w[i]) }
        };
        count += y >= primitive->shape.quadratic_prism.low
                 && y <= primitive->shape.quadratic_prism.high;
    }
    return count;
}

static size_t cross_cap(const struct primitive *primitive, double height,
                        const struct ray *ray, struct crossing *crossing)
{
    double point[3];
    return cross_level(height, ray, crossing, point)
           && is_round(&primitive->shape.quadratic_prism.path, point[0], point[2]);
}

CROSS(cross_quadratic_prism)
{
    struct arcs arcs = { .path = &primitive->shape.quadratic_prism.path };
    struct arc arc;
    size_t count = 0;
    while (count < MAX_CROSSINGS - 3 && take_arc(&arcs, &arc))
        count += cross_sides(primitive, &arc, ray, &crossings[count]);
    if (primitive->shape.quadratic_prism.open)
        return count;
    count += cross_cap(primitive, primitive->shape.quadratic_prism.low, ray,
                       &crossings[count]);
    return count
           + cross_cap(primitive, primitive->shape.quadratic_prism.high, ray,
                       &crossings[count]);
}
