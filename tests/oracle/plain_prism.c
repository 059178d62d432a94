/* plain_prism.c - prisms of linear splines. Each side is a rectangle. A cap covers the
 * points that an odd number of loops encloses. */
#include "tests/oracle/plain_shapes.h"

/* Iterates over the edges of a path. Each loop ends with its first point. There is no
 * edge from there to the next loop. */
struct edges {
    const struct outline *path;
    size_t next, first;
    const double *from, *to;
};

static bool take_edge(struct edges *edges)
{
    const struct outline *path = edges->path;
    if (edges->next + 1 >= path->count)
        return false;
    edges->from = path->points[edges->next];
    edges->to = path->points[edges->next + 1];
    edges->next++;
    if (edges->to[0] == path->points[edges->first][0]
        && edges->to[1] == path->points[edges->first][1])
        edges->first = ++edges->next;
    return true;
}

/* Returns true if the path encloses a point. The edges of a loop around the point
 * subtend angles whose sum is a full turn. */
static bool is_round(const struct outline *path, double x, double z)
{
    struct edges edges = { .path = path };
    double sum = 0;
    while (take_edge(&edges)) {
        double x0 = edges.from[0] - x, z0 = edges.from[1] - z;
        double x1 = edges.to[0] - x, z1 = edges.to[1] - z;
        sum += atan2(x0 * z1 - z0 * x1, x0 * x1 + z0 * z1);
    }
    return llround(sum / (2 * acos(-1))) % 2 != 0;
}

ENCLOSE(in_prism)
{
    return point[1] > primitive->shape.prism.low
           && point[1] < primitive->shape.prism.high
           && is_round(&primitive->shape.prism.path, point[0], point[2]);
}

/* Intersects the line with the plane of the side and tests the rectangle's bounds. */
static bool cross_side(const struct edges *edge, double low, double high,
                       const struct ray *ray, struct crossing *crossing)
{
    const double along[3] = { edge->to[0] - edge->from[0], 0,
                              edge->to[1] - edge->from[1] };
    const double corner[3] = { edge->from[0], 0, edge->from[1] };
    const double normal[3] = { along[2], 0, -along[0] };
    double rate = dot(normal, ray->direction);
    double from[3], point[3];
    if (rate == 0)
        return false;
    add_scaled(from, corner, -1, ray->origin);
    crossing->distance = dot(normal, from) / rate;
    copy(crossing->normal, normal);
    point_on(ray, crossing->distance, point);
    add_scaled(from, point, -1, corner);
    double share = dot(from, along) / dot(along, along);
    return share >= 0 && share < 1 && point[1] >= low && point[1] <= high;
}

static bool cross_cap(const struct primitive *primitive, double height,
                      const struct ray *ray, struct crossing *crossing)
{
    double point[3];
    return cross_level(height, ray, crossing, point)
           && is_round(&primitive->shape.prism.path, point[0], point[2]);
}

CROSS(cross_prism)
{
    struct edges edges = { .path = &primitive->shape.prism.path };
    double low = primitive->shape.prism.low;
    double high = primitive->shape.prism.high;
    size_t count = 0;
    while (take_edge(&edges) && count < MAX_CROSSINGS - 2)
        count += cross_side(&edges, low, high, ray, &crossings[count]);
    if (primitive->shape.prism.open)
        return count;
    count += cross_cap(primitive, low, ray, &crossings[count]);
    return count + cross_cap(primitive, high, ray, &crossings[count]);
}
