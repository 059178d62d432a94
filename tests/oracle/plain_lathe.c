/* plain_lathe.c - lathes. A segment of the path is a part of a cone or cylinder, or a
 * ring. A point is inside if the closed path winds around it an odd number of times. */
#include "tests/oracle/plain_shapes.h"

/* Returns true if y is from the segment's lower end to below its upper end. */
static bool has_height(const double from[2], const double to[2], double y)
{
    return y >= fmin(from[1], to[1]) && y < fmax(from[1], to[1]);
}

static double least_radius(const struct outline *path)
{
    double least = path->points[0][0];
    for (size_t i = 1; i < path->count; i++)
        least = fmin(least, path->points[i][0]);
    return least;
}

/* Returns the signed angle of the segment at a point. Sets `from` to its end. */
static double turn_to(const double point[2], double from[2], const double to[2])
{
    double r0 = from[0] - point[0], y0 = from[1] - point[1];
    double r1 = to[0] - point[0], y1 = to[1] - point[1];
    from[0] = to[0];
    from[1] = to[1];
    return atan2(r0 * y1 - y0 * r1, r0 * r1 + y0 * y1);
}

/* Closes the path, and returns the angle of the closing lines as seen from a point.
 * They are horizontal lines, and a vertical line at the smallest radius of the path. A
 * closing line that coincides with a segment is moved by 1e-4. */
static double turn_back(const struct outline *path, const double point[2], double at[2])
{
    const double(*points)[2] = (const double(*)[2])path->points;
    const double *first = points[0], *next = points[1];
    const double *last = points[path->count - 1];
    const double *before = points[path->count - 2];
    double low[2], high[2], least = least_radius(path), turn;
    double radius = least;
    for (size_t i = 1; i < path->count; i++)
        if (points[i - 1][0] == least && points[i][0] == least)
            radius = least * (1 - 1e-4);
    low[0] = high[0] = radius;
    low[1] = last[1];
    high[1] = first[1];
    if (before[1] == last[1] && before[0] < last[0])
        low[1] += 1e-4 * last[0];
    if (next[1] == first[1] && next[0] < first[0])
        high[1] += 1e-4 * first[0];
    turn = turn_to(point, at, low);
    turn += turn_to(point, at, high);
    return turn + turn_to(point, at, first);
}

ENCLOSE(in_lathe)
{
    const struct outline *path = &primitive->shape.lathe.path;
    const double *first = path->points[0];
    const double *last = path->points[path->count - 1];
    double here[2] = { hypot(point[0], point[2]), point[1] };
    double at[2] = { first[0], first[1] }, turn = 0;
    for (size_t i = 1; i < path->count; i++)
        turn += turn_to(here, at, path->points[i]);
    if ((first[0] == 0 && last[0] == 0) || (first[0] == last[0] && first[1] == last[1]))
        turn += turn_to(here, at, first);
    else
        turn += turn_back(path, here, at);
    return llround(turn / (2 * acos(-1))) % 2 != 0;
}

static size_t cross_ring(const double from[2], const double to[2],
                         const struct ray *ray, struct crossing *crossing)
{
    double point[3];
    if (!cross_level(from[1], ray, crossing, point))
        return 0;
    double away = hypot(point[0], point[2]);
    return (away >= from[0]) != (away >= to[0]);
}

/* Accepts the crossing at a distance if the segment includes its height, and if it is
 * on the same half of the double cone. The normal is perpendicular to the segment. */
static size_t cross_at(const double from[2], const double to[2], double distance,
                       const struct ray *ray, struct crossing *crossing)
{
    double rise = to[1] - from[1], out = to[0] - from[0], point[3];
    point_on(ray, distance, point);
    double away = hypot(point[0], point[2]);
    *crossing = (struct crossing){ distance,
                                   { rise * point[0], -out * away, rise * point[2] } };
    return has_height(from, to, point[1]);
}

/* Solves rise^2 (x^2 + z^2) = (rise r + out (y - height))^2. */
static size_t cross_segment(const double from[2], const double to[2],
                            const struct ray *ray, struct crossing *crossings)
{
    const double *o = ray->origin, *d = ray->direction;
    double rise = to[1] - from[1], out = to[0] - from[0];
    double radius = rise * from[0] + out * (o[1] - from[1]);
    double a = rise * rise * (d[0] * d[0] + d[2] * d[2]) - out * out * d[1] * d[1];
    double b = rise * rise * (o[0] * d[0] + o[2] * d[2]) - radius * out * d[1];
    double c = rise * rise * (o[0] * o[0] + o[2] * o[2]) - radius * radius;
    double root = sqrt(b * b - a * c);
    if (rise == 0)
        return cross_ring(from, to, ray, crossings);
    if (!(root >= 0))
        return 0;
    if (a == 0)
        return b == 0 ? 0 : cross_at(from, to, -c / (2 * b), ray, crossings);
    size_t count = cross_at(from, to, (-b - root) / a, ray, crossings);
    return count + cross_at(from, to, (-b + root) / a, ray, &crossings[count]);
}

CROSS(cross_lathe)
{
    const struct outline *path = &primitive->shape.lathe.path;
    size_t count = 0;
    for (size_t i = 1; i < path->count && count < MAX_CROSSINGS - 1; i++)
        count += cross_segment(path->points[i - 1], path->points[i], ray,
                               &crossings[count]);
    return count;
}
