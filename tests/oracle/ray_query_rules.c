/* ray_query_rules.c - generates lines, and checks hits of the all-hits ray query. */
#include "tests/oracle/ray_query_rules.h"

#include "tests/oracle/chance.h"
#include "tests/oracle/many_scenes.h"
#include "tests/oracle/plain_regions.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MIN_DISTANCE 1e-6 /* k_tmin of the kernels: nearer hits are ignored */
enum { ROUNDED_EACH = 50 };

/* ---- Lines --------------------------------------------------------------- */

void draw_camera_lines(uint64_t *state, const struct scene *scene,
                       struct scene_ray *list, size_t count)
{
    const struct camera *camera = &scene->camera;
    for (size_t i = 0; i < count; i++) {
        double u = between(state, -.5, .5), v = between(state, -.5, .5);
        double *point = camera->orthographic ? list[i].origin : list[i].direction;
        copy(list[i].origin, camera->location);
        copy(list[i].direction, camera->direction);
        add_scaled(point, point, u, camera->right);
        add_scaled(point, point, v, camera->up);
        scale_by(list[i].direction, of_any_size(state, .1, 10));
    }
}

void draw_grid_lines(uint64_t *state, struct scene_ray *list, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct scene_ray *line = &list[i];
        double far = 0;
        for (int k = 0; k < 3; k++) {
            line->origin[k] = (double)below(state, 5) / 2 - 1;
            line->direction[k] = one_in(state, 3) ? (double)below(state, 3) - 1 : 0;
            far = fmax(far, fabs(line->direction[k]));
        }
        if (far == 0)
            line->direction[below(state, 3)] = 1;
        add_scaled(line->origin, line->origin, -8, line->direction);
    }
}

struct ray_hits find_lines(const struct scene *scene,
                           const struct ray_query_options *options,
                           const struct scene_ray *list, size_t count)
{
    struct ray_hits found;
    SCOPED(ray_query) *lines = ray_query_new(scene, options, &last_error);
    need(lines && ray_query_find(lines, list, count, &found, &last_error));
    return found;
}

/* ---- Comparison of two forms --------------------------------------------- */

static bool is_same(const struct ray_hit *a, const struct ray_hit *b)
{
    return a->distance == b->distance && a->primitive == b->primitive
           && a->object == b->object && a->triangle == b->triangle
           && a->crossing == b->crossing && a->object_depth == b->object_depth
           && a->scene_depth == b->scene_depth
           && memcmp(a->normal, b->normal, sizeof a->normal) == 0;
}

static bool is_as_far(const struct ray_hit *a, const struct ray_hit *b)
{
    return a->distance == b->distance;
}

static bool same_by(const struct ray_hits *expected, const struct ray_hits *found,
                    bool (*same)(const struct ray_hit *a, const struct ray_hit *b),
                    char *reason)
{
    for (size_t i = 0; i < expected->line_count; i++) {
        size_t first = expected->first[i], next = expected->first[i + 1];
        if (found->first[i + 1] != next) {
            snprintf(reason, LINE_REASON, "line %zu has %zu crossings, not %zu", i,
                     found->first[i + 1] - first, next - first);
            return false;
        }
        for (size_t k = first; k < next; k++)
            if (!same(&expected->list[k], &found->list[k])) {
                snprintf(reason, LINE_REASON, "crossing %zu of line %zu is another",
                         k - first, i);
                return false;
            }
    }
    return true;
}

bool same_crossings(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason)
{
    return same_by(expected, found, is_same, reason);
}

bool same_distances(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason)
{
    return same_by(expected, found, is_as_far, reason);
}

/* ---- Rules --------------------------------------------------------------- */

/* A line, its hits, and the distance of its start before its origin. */
struct along {
    const struct scene *scene;
    const struct scene_ray *line;
    const struct ray_hit *list;
    size_t count;
    double behind;
};

static bool are_in_order(const struct along *along)
{
    for (size_t k = 1; k < along->count; k++) {
        const struct ray_hit *here = &along->list[k];
        double before = c205_to_double(here[-1].distance);
        double distance = c205_to_double(here->distance);
        if (before > distance
            || (before == distance && here[-1].primitive >= here->primitive))
            return false;
    }
    return true;
}

static bool are_counted(const struct along *along)
{
    int scene_depth = 0;
    for (size_t k = 0; k < along->count; k++) {
        int object_depth = 0;
        scene_depth += along->list[k].crossing;
        for (size_t i = 0; i <= k; i++)
            if (along->list[i].object == along->list[k].object)
                object_depth += along->list[i].crossing;
        if (along->list[k].object_depth != object_depth
            || along->list[k].scene_depth != scene_depth)
            return false;
    }
    return true;
}

static bool is_endless(enum primitive_kind kind)
{
    return kind == PRIMITIVE_PLANE || kind == PRIMITIVE_QUADRIC
           || kind == PRIMITIVE_QUARTIC;
}

static bool is_bounded(const struct scene *scene, const struct region *region)
{
    for (size_t i = 0; i < region->primitive_count; i++)
        if (is_endless(scene->primitives[region->first_primitive + i].kind))
            return false;
    return true;
}

static struct ray ray_of(const struct scene_ray *line)
{
    struct ray ray;
    copy(ray.origin, line->origin);
    copy(ray.direction, line->direction);
    normalise(ray.direction);
    return ray;
}

static bool begins_inside(const struct along *along, const struct region *region)
{
    struct ray ray = ray_of(along->line);
    return plain_is_inside(along->scene, region, &ray, MIN_DISTANCE - along->behind);
}

/* Returns true if the region is a complement, so that it contains distant points. */
static bool is_complement(const struct along *along, const struct region *region)
{
    struct ray ray = ray_of(along->line);
    return plain_is_inside(along->scene, region, &ray, 1e9);
}

/* Checks the hits of one region. */
static bool region_keeps_rules(const struct along *along, const struct region *region)
{
    bool closed = plain_is_closed(along->scene, region);
    bool object_depth = closed && begins_inside(along, region);
    double last = -INFINITY;
    for (size_t k = 0; k < along->count; k++) {
        const struct ray_hit *here = &along->list[k];
        double distance = c205_to_double(here->distance);
        if (here->primitive - region->first_primitive >= region->primitive_count)
            continue;
        if (distance - last < .999 * PLAIN_DELTA - 1e-12 * fabs(distance)
            || here->crossing
                   != (!closed        ? 0
                       : object_depth ? -1
                                      : 1))
            return false;
        last = distance;
        object_depth = !object_depth;
    }
    return !closed || !is_bounded(along->scene, region)
           || object_depth == is_complement(along, region);
}

/* Returns true if a hit is in the plane of its triangle. */
static bool is_on_triangle(const struct along *along, const struct ray_hit *seen)
{
    const struct primitive *mesh = &along->scene->primitives[seen->primitive];
    double point[3], edges[2][3], away[3], normal[3];
    struct ray ray = ray_of(along->line);
    if (mesh->kind != PRIMITIVE_MESH)
        return seen->triangle == 0;
    const struct triangle *triangle = &mesh->shape.mesh.triangles.list[seen->triangle];
    point_on(&ray, c205_to_double(seen->distance), point);
    to_other_space(&mesh->to_local, point, away);
    add_scaled(away, away, -1, triangle->corners[0]);
    for (int i = 0; i < 2; i++)
        add_scaled(edges[i], triangle->corners[1 + i], -1, triangle->corners[0]);
    cross_product(edges[0], edges[1], normal);
    double volume = dot(away, normal);
    return fabs(volume)
           <= 1e-5 * greatest(edges[0]) * greatest(edges[1]) * (1 + greatest(point));
}

static bool has_normal(const struct along *along, const struct ray_hit *seen)
{
    double normal[3], size = sqrt(dot(along->line->direction, along->line->direction));
    for (int i = 0; i < 3; i++)
        normal[i] = c205_to_double(seen->normal[i]);
    return fabs(dot(normal, normal) - 1) < 1e-7
           && dot(normal, along->line->direction) <= 1e-7 * size;
}

static const char *broken_rule(const struct along *along)
{
    if (!are_in_order(along))
        return "is out of order";
    if (!are_counted(along))
        return "counts its bodies wrongly";
    for (size_t k = 0; k < along->count; k++) {
        if (!is_on_triangle(along, &along->list[k]))
            return "has another triangle";
        if (!has_normal(along, &along->list[k]))
            return "has a normal that is none";
    }
    for (size_t i = 0; i < along->scene->region_count; i++)
        if (!region_keeps_rules(along, &along->scene->regions[i]))
            return "does not go in and out of a region in turn";
    return NULL;
}

bool keep_line_rules(const struct scene *scene, const struct scene_ray *list,
                     const struct ray_hits *found, double behind, char *reason)
{
    for (size_t i = 0; i < found->line_count; i++) {
        const struct along along = { scene, &list[i], found->list + found->first[i],
                                     found->first[i + 1] - found->first[i], behind };
        const char *broken = broken_rule(&along);
        if (broken) {
            snprintf(reason, LINE_REASON, "line %zu %s", i, broken);
            return false;
        }
    }
    return true;
}

/* ---- The plain tracer ---------------------------------------------------- */

static bool is_plain(const struct ray_hit *seen, const struct plain_crossing *plain,
                     bool certain)
{
    double distance = c205_to_double(seen->distance), off = 0;
    if (fabs(distance - plain->distance) > 1e-6 * (1 + fabs(distance)))
        return false;
    for (int i = 0; i < 3; i++)
        off = fmax(off, fabs(c205_to_double(seen->normal[i]) - plain->normal[i]));
    return !certain
           || (seen->primitive == plain->primitive && seen->crossing == plain->crossing
               && off < 1e-5);
}

static bool is_plain_line(const struct along *along, bool certain)
{
    size_t room = along->count + 1;
    FREED struct plain_crossing *plain = calloc(room, sizeof *plain);
    struct ray ray = ray_of(along->line);
    need(plain);
    bool same = plain_line(along->scene, &ray, MIN_DISTANCE - along->behind, plain,
                           room)
                == along->count;
    for (size_t k = 0; same && k < along->count; k++)
        same = is_plain(&along->list[k], &plain[k], certain);
    return same;
}

bool same_as_plain_lines(const struct scene *scene, const struct scene_ray *list,
                         const struct ray_hits *found, double behind, bool certain,
                         char *reason)
{
    size_t others = 0;
    for (size_t i = 0; i < found->line_count; i++) {
        const struct along along = { scene, &list[i], found->list + found->first[i],
                                     found->first[i + 1] - found->first[i], behind };
        if (is_plain_line(&along, certain))
            continue;
        others++;
        snprintf(reason, LINE_REASON,
                 "the plain tracer sees something else along %zu lines, %zu among them",
                 others, i);
    }
    return others <= 1 + found->line_count / ROUNDED_EACH;
}
