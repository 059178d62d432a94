/* plain_blob.c - blobs. The field at a point is computed from the distance to each
 * component. A line is divided at the distances at which it enters or leaves a
 * component, or passes an end plane of a cylinder. Between two of these distances the
 * field is a quartic, which is computed from five values of the field. */
#include "tests/oracle/plain_roots.h"
#include "tests/oracle/plain_shapes.h"

#include <stdlib.h>

enum { NODES = HIGHEST_DEGREE + 1 };

/* ---- The field ----------------------------------------------------------- */

/* Computes the vector to a point from the nearest point of the axis or the centre. */
static void way_from(const struct blob_part *part, const double own[3], double way[3])
{
    double axis[3];
    add_scaled(way, own, -1, part->base);
    if (!part->cylinder)
        return;
    add_scaled(axis, part->cap, -1, part->base);
    double share = dot(way, axis) / dot(axis, axis);
    add_scaled(way, way, -fmin(fmax(share, 0), 1), axis);
}

/* Returns 1 - (distance / radius)^2 at a point in a component's space. */
static double nearness(const struct blob_part *part, const double own[3])
{
    double way[3];
    way_from(part, own, way);
    return fmax(0, 1 - dot(way, way) / (part->radius * part->radius));
}

static double field_at(const struct primitive *primitive, const double point[3])
{
    const struct blob_parts *parts = &primitive->shape.blob.parts;
    double sum = -primitive->shape.blob.threshold;
    for (size_t i = 0; i < parts->count; i++) {
        double own[3];
        to_other_space(&parts->list[i].to_local, point, own);
        double near = nearness(&parts->list[i], own);
        sum += parts->list[i].strength * near * near;
    }
    return sum;
}

ENCLOSE(in_blob)
{
    return field_at(primitive, point) > 0;
}

/* Computes the normal, which is opposite to the gradient of the field. */
static void blob_normal(const struct primitive *primitive, const double point[3],
                        double normal[3])
{
    const struct blob_parts *parts = &primitive->shape.blob.parts;
    normal[0] = normal[1] = normal[2] = 0;
    for (size_t i = 0; i < parts->count; i++) {
        const struct blob_part *part = &parts->list[i];
        double own[3], way[3];
        to_other_space(&part->to_local, point, own);
        way_from(part, own, way);
        scale_by(way,
                 part->strength * nearness(part, own) / (part->radius * part->radius));
        for (int k = 0; k < 3; k++)
            add_scaled(normal, normal, way[k], part->to_local.rows[k]);
    }
}

/* ---- Ends of the intervals ----------------------------------------------- */

struct places {
    size_t count;
    double *at;
};

static void add_place(struct places *places, double at)
{
    places->at[places->count++] = at;
}

/* Adds the solutions of |from + t along| = radius. */
static void add_ball(struct places *places, const double from[3], const double along[3],
                     double radius)
{
    double a = dot(along, along), b = dot(from, along) / a;
    double nearest[3];
    add_scaled(nearest, from, -b, along);
    double disc = (radius * radius - dot(nearest, nearest)) / a;
    if (a > 0 && disc > 0) {
        add_place(places, -b - sqrt(disc));
        add_place(places, -b + sqrt(disc));
    }
}

/* Computes the part of a vector that is perpendicular to a unit vector. */
static void across(const double a[3], const double unit[3], double part[3])
{
    add_scaled(part, a, -dot(a, unit), unit);
}

static void add_cylinder(struct places *places, const struct blob_part *part,
                         const double from[3], const double along[3])
{
    double unit[3], cap[3], side[3], side_along[3];
    add_scaled(unit, part->cap, -1, part->base);
    add_scaled(cap, from, -1, unit);
    add_ball(places, cap, along, part->radius);
    normalise(unit);
    if (fabs(dot(along, unit)) > 1e-12) {
        add_place(places, -dot(from, unit) / dot(along, unit));
        add_place(places, -dot(cap, unit) / dot(along, unit));
    }
    across(from, unit, side);
    across(along, unit, side_along);
    if (dot(side_along, side_along) > 1e-24)
        add_ball(places, side, side_along, part->radius);
}

static int by_place(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Adds up to eight distances for each component. */
static void find_places(const struct primitive *primitive, const struct ray *ray,
                        struct places *places)
{
    const struct blob_parts *parts = &primitive->shape.blob.parts;
    for (size_t i = 0; i < parts->count; i++) {
        const struct blob_part *part = &parts->list[i];
        double from[3], along[3];
        to_other_space(&part->to_local, ray->origin, from);
        add_scaled(from, from, -1, part->base);
        for (int k = 0; k < 3; k++)
            along[k] = dot(part->to_local.rows[k], ray->direction);
        add_ball(places, from, along, part->radius);
        if (part->cylinder)
            add_cylinder(places, part, from, along);
    }
    qsort(places->at, places->count, sizeof *places->at, by_place);
}

/* ---- Roots in an interval ------------------------------------------------ */

/* Computes the polynomial that has the given values at the nodes. Its variable is -1 at
 * one end of the interval and 1 at the other. */
static void interpolate(const long double nodes[NODES], const long double values[NODES],
                        long double c[NODES])
{
    for (int i = 0; i < NODES; i++)
        c[i] = 0;
    for (int i = 0; i < NODES; i++) {
        long double basis[NODES] = { values[i] };
        int degree = 0;
        for (int j = 0; j < NODES; j++) {
            if (j == i)
                continue;
            long double by = 1 / (nodes[i] - nodes[j]);
            degree++;
            for (int k = degree; k >= 0; k--)
                basis[k] = by
                           * ((k > 0 ? basis[k - 1] : 0)
                              - (k < degree ? nodes[j] * basis[k] : 0));
        }
        for (int k = 0; k < NODES; k++)
            c[k] += basis[k];
    }
}

static size_t cross_between(const struct primitive *primitive, const struct ray *ray,
                            double from, double to, struct crossing *crossings,
                            size_t room)
{
    static const long double nodes[NODES] = { -.95L, -.59L, 0, .59L, .95L };
    long double values[NODES], c[NODES], roots[HIGHEST_DEGREE];
    size_t count = 0;
    for (int i = 0; i < NODES; i++) {
        double point[3];
        point_on(ray, (from + to) / 2 + (double)nodes[i] * (to - from) / 2, point);
        values[i] = field_at(primitive, point);
    }
    interpolate(nodes, values, c);
    size_t found = plain_roots(c, HIGHEST_DEGREE, roots);
    for (size_t i = 0; i < found && count < room; i++)
        if (roots[i] >= -1 && roots[i] < 1) {
            double point[3];
            crossings[count].distance = (double)((from + to) / 2
                                                 + roots[i] * (to - from) / 2);
            point_on(ray, crossings[count].distance, point);
            blob_normal(primitive, point, crossings[count++].normal);
        }
    return count;
}

CROSS(cross_blob)
{
    struct places places = { 0, malloc((8 * primitive->shape.blob.parts.count + 1)
                                       * sizeof *places.at) };
    size_t count = 0;
    if (!places.at)
        abort();
    find_places(primitive, ray, &places);
    for (size_t i = 0; i + 1 < places.count; i++)
        if (places.at[i] < places.at[i + 1])
            count += cross_between(primitive, ray, places.at[i], places.at[i + 1],
                                   &crossings[count], MAX_CROSSINGS - count);
    free(places.at);
    return count;
}
