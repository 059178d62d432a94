/* plain_regions.c - see plain_regions.h. */
#include "tests/oracle/plain_regions.h"

#include <stdlib.h>

struct place {
    const struct primitive *primitive;
    double distance;
    double normal[3]; /* in the primitive's space, of either side */
};

struct crossing_list {
    const struct scene *scene;
    const struct region *region;
    const struct ray *ray;
    size_t count;
    struct place places[]; /* from near to far */
};

/* --- transforms -------------------------------------------------------- */

static void turn(const struct transform *transform, const double in[3],
                 double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = dot(transform->rows[i], in);
}

void to_other_space(const struct transform *transform, const double in[3],
                    double out[3])
{
    turn(transform, in, out);
    for (int i = 0; i < 3; i++)
        out[i] += transform->rows[i][3];
}

/* Normals go by the transpose of the inverse. */
static void normal_to_world(const struct transform *to_local,
                            const double in[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = to_local->rows[0][i] * in[0] + to_local->rows[1][i] * in[1]
                 + to_local->rows[2][i] * in[2];
    normalise(out);
}

/* --- crossings ---------------------------------------------------------- */

struct crossing_list *crossing_list_new(const struct scene *scene)
{
    struct crossing_list *list;
    size_t most = 0;
    for (size_t i = 0; i < scene->region_count; i++)
        if (scene->regions[i].primitive_count > most)
            most = scene->regions[i].primitive_count;
    list = malloc(sizeof *list
                  + most * MOST_CROSSINGS * sizeof *list->places);
    return list;
}

void crossing_list_free(struct crossing_list *list)
{
    free(list);
}

/* Of places at one distance the earlier in the scene stays first. */
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
    struct crossing crossings[MOST_CROSSINGS];
    struct ray local;
    to_other_space(&primitive->to_local, list->ray->origin, local.origin);
    turn(&primitive->to_local, list->ray->direction, local.direction);
    const size_t count = plain_crossings(primitive, &local, crossings);
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
        cross_primitive(list,
                        &scene->primitives[region->first_primitive + i]);
}

/* --- the tree ----------------------------------------------------------- */

/* A point of the ray; a patch, which has no inside, counts as solid behind the
 * crossing with it and nowhere else. */
struct probe {
    const struct scene *scene;
    double point[3];
    const struct primitive *behind; /* the crossing with this one */
};

static bool is_inside(const struct probe *probe,
                      const struct primitive *primitive)
{
    double local[3];
    to_other_space(&primitive->to_local, probe->point, local);
    return primitive->kind == PRIMITIVE_STEINER_PATCH
               ? primitive == probe->behind
               : plain_encloses(primitive, local);
}

static bool value_of(const struct probe *probe, size_t at)
{
    const struct tree_node *const node = &probe->scene->nodes[at];
    if (node->operation == TREE_LEAF)
        return is_inside(probe, &probe->scene->primitives[node->primitive]);
    if (node->operation == TREE_NOT)
        return !value_of(probe, at + 1);
    const bool decides = node->operation == TREE_OR;
    for (size_t child = at + 1; child < node->next;
         child = probe->scene->nodes[child].next)
        if (value_of(probe, child) == decides)
            return decides;
    return !decides;
}

static bool is_solid(const struct crossing_list *list, double distance,
                     const struct primitive *behind)
{
    struct probe probe = { list->scene, { 0 }, behind };
    point_on(list->ray, distance, probe.point);
    const struct primitive *const first =
        &list->scene->primitives[list->region->first_primitive];
    return list->region->primitive_count > 1
               ? value_of(&probe, list->region->first_node)
               : is_inside(&probe, first) != first->inverted;
}

/* --- what is seen ------------------------------------------------------- */

/* A patch alone has a side that its normal points to. */
static void describe(const struct place *place, bool solid_behind,
                     const double direction[3], struct plain_hit *hit)
{
    hit->primitive = place->primitive;
    hit->distance = place->distance;
    normal_to_world(&place->primitive->to_local, place->normal, hit->normal);
    const double along = dot(hit->normal, direction);
    hit->entering = place->primitive->kind == PRIMITIVE_STEINER_PATCH
                        ? (along < 0) != place->primitive->inverted
                        : solid_behind;
    if (along > 0)
        scale_by(hit->normal, -1);
}

/* Of a primitive alone every crossing is seen. */
static bool look_at(const struct crossing_list *list,
                    const struct place *place, struct plain_hit *hit)
{
    const double distance = place->distance;
    const bool before = is_solid(list, distance - PLAIN_DELTA, NULL);
    const bool after = is_solid(list, distance + PLAIN_DELTA,
                                place->primitive);
    if (before == after && list->region->primitive_count > 1)
        return false;
    describe(place, after, list->ray->direction, hit);
    return true;
}

bool plain_next_hit(const struct crossing_list *list, double last,
                    double limit, struct plain_hit *hit)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct place *const place = &list->places[i];
        if (place->distance > last && place->distance < limit
            && look_at(list, place, hit))
            return true;
    }
    return false;
}
