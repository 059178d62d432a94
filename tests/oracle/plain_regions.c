/* plain_regions.c - crossings of a ray with a CSG tree (plain_regions.h). */
#include "tests/oracle/plain_regions.h"

#include "rt/shapes/shape.h"

#include <stdlib.h>

struct place {
    const struct primitive *primitive;
    double distance;
    double normal[3]; /* in the primitive's space, on either side */
};

struct crossing_list {
    const struct scene *scene;
    const struct region *region;
    const struct ray *ray;
    size_t count;
    struct place places[]; /* from near to far */
};

static void turn(const struct transform *transform, const double in[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = dot(transform->rows[i], in);
}

/* --- crossings ---------------------------------------------------------- */

struct crossing_list *crossing_list_new(const struct scene *scene)
{
    struct crossing_list *list;
    size_t most = 0;
    for (size_t i = 0; i < scene->region_count; i++)
        if (scene->regions[i].primitive_count > most)
            most = scene->regions[i].primitive_count;
    list = malloc(sizeof *list + most * MAX_CROSSINGS * sizeof *list->places);
    return list;
}

void crossing_list_free(struct crossing_list *list)
{
    free(list);
}

/* Inserts a crossing by distance, and at equal distances by the primitive's order. */
static void insert(struct crossing_list *list, const struct place *place)
{
    size_t at = list->count++;
    for (; at > 0 && list->places[at - 1].distance > place->distance; at--)
        list->places[at] = list->places[at - 1];
    list->places[at] = *place;
}

static void cross_primitive(struct crossing_list *list,
                            const struct primitive *primitive)
{
    struct crossing crossings[MAX_CROSSINGS];
    struct ray local;
    to_other_space(&primitive->to_local, list->ray->origin, local.origin);
    turn(&primitive->to_local, list->ray->direction, local.direction);
    size_t count = primitive->invisible ? 0
                                        : plain_crossings(primitive, &local, crossings);
    for (size_t i = 0; i < count; i++) {
        struct place place = { primitive, crossings[i].distance, { 0 } };
        copy(place.normal, crossings[i].normal);
        insert(list, &place);
    }
}

void plain_cross_region(struct crossing_list *list, const struct scene *scene,
                        const struct region *region, const struct ray *ray)
{
    list->scene = scene;
    list->region = region;
    list->ray = ray;
    list->count = 0;
    for (size_t i = 0; i < region->primitive_count; i++)
        cross_primitive(list, &scene->primitives[region->first_primitive + i]);
}

/* ---- The tree ------------------------------------------------------------ */

/* A point of the ray just before a crossing, or just after it. */
struct probe {
    const struct crossing_list *list;
    double crossing;
    bool behind;
    double point[3];
};

static struct probe probe_at(const struct crossing_list *list, double crossing,
                             bool behind)
{
    struct probe probe = { list, crossing, behind, { 0 } };
    point_on(list->ray, crossing + (behind ? PLAIN_DELTA : -PLAIN_DELTA), probe.point);
    return probe;
}

static bool is_near(const struct place *place, double distance)
{
    return fabs(place->distance - distance) <= PLAIN_DELTA;
}

/* Returns true if a patch counts as solid at the probe. A patch has no inside. It is
 * therefore solid only just after a crossing with it. */
static bool is_behind(const struct probe *probe, const struct primitive *patch)
{
    for (size_t i = 0; probe->behind && i < probe->list->count; i++)
        if (probe->list->places[i].primitive == patch
            && is_near(&probe->list->places[i], probe->crossing))
            return true;
    return false;
}

static bool is_inside(const struct probe *probe, const struct primitive *primitive)
{
    double local[3];
    to_other_space(&primitive->to_local, probe->point, local);
    return shape_is_surface(primitive) ? is_behind(probe, primitive)
                                       : plain_encloses(primitive, local);
}

static bool value_of(const struct probe *probe, size_t at)
{
    const struct scene *scene = probe->list->scene;
    const struct tree_node *node = &scene->nodes[at];
    if (node->operation == TREE_LEAF)
        return is_inside(probe, &scene->primitives[node->primitive]);
    if (node->operation == TREE_NOT)
        return !value_of(probe, at + 1);
    bool decides = node->operation == TREE_OR;
    for (size_t child = at + 1; child < node->next; child = scene->nodes[child].next)
        if (value_of(probe, child) == decides)
            return decides;
    return !decides;
}

static bool is_alone(const struct region *region)
{
    return region->primitive_count == 1;
}

static bool is_solid(const struct probe *probe)
{
    const struct region *region = probe->list->region;
    const struct primitive *first = &probe->list->scene
                                         ->primitives[region->first_primitive];
    return is_alone(region) ? is_inside(probe, first) != first->inverted
                            : value_of(probe, region->first_node);
}

bool plain_holds(const struct crossing_list *list, double distance)
{
    struct probe probe = { list, INFINITY, false, { 0 } };
    point_on(list->ray, distance, probe.point);
    return is_solid(&probe);
}

/* ---- Visible crossings --------------------------------------------------- */

/* The points just before and just after a crossing. */
struct sides {
    struct probe before, behind;
};

/* Returns true if a crossing is visible below a node. The states of the primitive, and
 * of every node that contains it, must change at the crossing. */
static bool shows_below(const struct sides *sides, size_t at,
                        const struct primitive *primitive)
{
    const struct scene *scene = sides->before.list->scene;
    const struct tree_node *node = &scene->nodes[at];
    if (value_of(&sides->before, at) == value_of(&sides->behind, at))
        return false;
    if (node->operation == TREE_LEAF)
        return primitive == &scene->primitives[node->primitive];
    for (size_t child = at + 1; child < node->next; child = scene->nodes[child].next)
        if (shows_below(sides, child, primitive))
            return true;
    return false;
}

/* Returns true if a crossing is visible. All crossings with a region of one primitive
 * are visible. */
static bool shows(const struct sides *sides, const struct primitive *primitive)
{
    const struct region *region = sides->before.list->region;
    return is_alone(region) || shows_below(sides, region->first_node, primitive);
}

/* Finds the first primitive that is visible within the tolerance, and returns its
 * crossing. If it has several crossings there, returns the nearest. */
static const struct place *first_shown(const struct crossing_list *list,
                                       const struct sides *sides,
                                       const struct place *seen)
{
    double distance = seen->distance;
    for (size_t i = 0; i < list->count; i++) {
        const struct place *place = &list->places[i];
        bool nearer = place->primitive == seen->primitive
                      && fabs(place->distance - distance)
                             < fabs(seen->distance - distance);
        if (is_near(place, distance) && (place->primitive < seen->primitive || nearer)
            && shows(sides, place->primitive))
            seen = place;
    }
    return seen;
}

/* Returns true if the ray enters a solid. A ray always enters a mesh without an inside.
 * If such a mesh is opaque and alone, its normal decides, as for a patch. */
static bool comes_into(const struct crossing_list *list, const struct place *place,
                       double along)
{
    const struct primitive *primitive = place->primitive;
    return (primitive->kind == PRIMITIVE_MESH
            && (!is_alone(list->region) || pigment_is_clear(&primitive->pigment)))
           || (along < 0) != primitive->inverted;
}

static void describe(const struct crossing_list *list, const struct place *place,
                     bool solid_behind, struct plain_hit *hit)
{
    const double *direction = list->ray->direction;
    hit->primitive = place->primitive;
    /* by the transposed inverse */
    transposed(&place->primitive->to_local, place->normal, hit->normal);
    normalise(hit->normal);
    double along = dot(hit->normal, direction);
    hit->entering = shape_is_surface(place->primitive) ? comes_into(list, place, along)
                                                       : solid_behind;
    if (along > 0)
        scale_by(hit->normal, -1);
}

static bool look_at(const struct crossing_list *list, const struct place *place,
                    struct plain_hit *hit)
{
    const struct sides sides = { probe_at(list, place->distance, false),
                                 probe_at(list, place->distance, true) };
    if (!shows(&sides, place->primitive))
        return false;
    hit->distance = place->distance;
    describe(list, first_shown(list, &sides, place), is_solid(&sides.behind), hit);
    return true;
}

bool plain_next_hit(const struct crossing_list *list, double last, double limit,
                    struct plain_hit *hit)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct place *place = &list->places[i];
        if (place->distance > last && place->distance < limit
            && look_at(list, place, hit))
            return true;
    }
    return false;
}
