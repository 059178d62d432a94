/* plain_ray_query.c - the sorted visible crossings of a line (plain_regions.h). */
#include "tests/oracle/plain_regions.h"

#include <stdlib.h>
#include <string.h>

/* ---- Bodies -------------------------------------------------------------- */

/* Returns true if a lathe's path ends where it starts, or if both of its ends are on
 * the axis. No surface is then missing. */
static bool path_is_closed(const struct outline *path)
{
    const double *first = path->points[0];
    const double *last = path->points[path->count - 1];
    return memcmp(first, last, 2 * sizeof *first) == 0
           || (first[0] == 0 && last[0] == 0);
}

static bool is_closed(const struct primitive *primitive)
{
    switch (primitive->kind) {
    case PRIMITIVE_CYLINDER: return !primitive->shape.cylinder.open;
    case PRIMITIVE_CONE: return !primitive->shape.cone.open;
    case PRIMITIVE_PRISM: return !primitive->shape.prism.open;
    case PRIMITIVE_QUADRATIC_PRISM: return !primitive->shape.quadratic_prism.open;
    case PRIMITIVE_LATHE: return path_is_closed(&primitive->shape.lathe.path);
    case PRIMITIVE_MESH: return primitive->shape.mesh.solid;
    case PRIMITIVE_DISC:
    case PRIMITIVE_STEINER_PATCH: return false;
    default: return true;
    }
}

bool plain_is_closed(const struct scene *scene, const struct region *region)
{
    for (size_t i = 0; i < region->primitive_count; i++) {
        const struct primitive
            *primitive = &scene->primitives[region->first_primitive + i];
        if (primitive->invisible || !is_closed(primitive))
            return false;
    }
    return true;
}

bool plain_is_inside(const struct scene *scene, const struct region *region,
                     const struct ray *line, double distance)
{
    struct crossing_list *crossings = crossing_list_new(scene);
    if (!crossings)
        return false;
    plain_cross_region(crossings, scene, region, line);
    bool inside = plain_holds(crossings, distance);
    crossing_list_free(crossings);
    return inside;
}

/* ---- Lines --------------------------------------------------------------- */

struct seen_list {
    struct plain_crossing *list;
    size_t count, room;
};

/* Inserts a crossing after those that are not farther. A region's arrive in order. */
static void insert(struct seen_list *seen, const struct plain_crossing *crossing)
{
    size_t at = seen->count++;
    if (seen->count > seen->room)
        return;
    for (; at > 0 && seen->list[at - 1].distance > crossing->distance; at--)
        seen->list[at] = seen->list[at - 1];
    seen->list[at] = *crossing;
}

static void see_region(struct seen_list *seen, const struct scene *scene, size_t region,
                       const struct crossing_list *crossings, double least)
{
    bool closed = plain_is_closed(scene, &scene->regions[region]);
    struct plain_hit hit;
    while (plain_next_hit(crossings, least, INFINITY, &hit)) {
        struct plain_crossing crossing = {
            .distance = hit.distance,
            .primitive = (size_t)(hit.primitive - scene->primitives),
            .region = region,
            .crossing = !closed        ? 0
                        : hit.entering ? 1
                                       : -1,
        };
        copy(crossing.normal, hit.normal);
        insert(seen, &crossing);
        least = hit.distance + PLAIN_DELTA;
    }
}

size_t plain_line(const struct scene *scene, const struct ray *line, double least,
                  struct plain_crossing *list, size_t room)
{
    struct seen_list seen = { list, 0, room };
    struct crossing_list *crossings = crossing_list_new(scene);
    if (!crossings)
        return 0;
    for (size_t i = 0; i < scene->region_count; i++) {
        plain_cross_region(crossings, scene, &scene->regions[i], line);
        see_region(&seen, scene, i, crossings, least);
    }
    crossing_list_free(crossings);
    return seen.count;
}
