/* scene_unit.c - chooses the unit of length in which a scene is traced.
 *
 * Rays start at a distance of 1e-6 from their surface, shadow rays at 1e-3, and nothing
 * beyond 1e12 is visible (rt/kernels/frame/records.s). These lengths suit a scene whose
 * objects are at distances from MIN_ORDINARY to MAX_ORDINARY. The lengths of any other
 * scene are divided by a power of two, so that the median of the distances is between 4
 * and 8. A division by a power of two does not round.
 *
 * The distance of an object is the distance of its farthest point from the camera. A
 * few objects of another size, such as a sphere for the ground or the sky, do not
 * change the median. If the median object is far away and small, its radius is used
 * instead, because the start distances of rays must be small compared with the object.
 */
#include "rt/scene/language/scene_unit.h"

#include <stdlib.h>

#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"
#include "rt/shapes/terms.h"

#define MIN_ORDINARY 0x1p-1
#define MAX_ORDINARY 0x1p22
/* An object is small if its distance exceeds SIGHT times its radius. */
#define SIGHT 64
/* Up to this distance, the rounding error of the squared distance to a light is smaller
 * than the start distance of shadow rays. */
#define LIGHT_FARTHEST 1e10
enum { MAX_SAMPLES = 1001, MAX_UNIT_LOG = 200 };

/* ---- The size of a scene ------------------------------------------------- */

struct reach {
    double distance;  /* distance of the farthest point from the camera */
    double radius;    /* radius of the object */
    double center[3]; /* centre of the object */
};

static int compare_reaches(const void *a, const void *b)
{
    const struct reach *one = a, *other = b;
    return (one->distance > other->distance) - (one->distance < other->distance);
}

/* Returns the distance and size of a plane. A plane has no farthest point, so the
 * distance of its nearest point is used, or `nearest` if this is greater. */
static struct reach reach_plane(const struct primitive *primitive, const double from[3],
                                double nearest)
{
    const double *normal = primitive->shape.plane.normal;
    struct reach reach = { 0 };
    double across[3], at[3], height;
    copy3(from, at);
    transform_point(&primitive->to_local, at);
    copy3(normal, across);
    transform_normal(&primitive->to_local, across);
    height = dot3(normal, at) - primitive->shape.plane.distance;
    reach.distance = fmax(fabs(height) / length3(across), nearest);
    reach.radius = reach.distance;
    for (int i = 0; i < 3; i++)
        reach.center[i] = from[i] - height * across[i] / dot3(across, across);
    return reach;
}

/* Computes an approximate bound of a mesh from two of its corners, because a large mesh
 * has too many corners to consider all. */
static void bound_corners(const struct primitive *mesh, struct bound *bound)
{
    const struct triangles *triangles = &mesh->shape.mesh.triangles;
    const double *first = triangles->list[0].corners[0];
    double way[3];
    subtract3(triangles->list[triangles->count - 1].corners[1], first, way);
    transform_direction(&mesh->to_world, way);
    bound_about(mesh, first, length3(way), bound);
}

/* Returns the distance and size of a primitive. The distance is 0 if the primitive has
 * no bound. A plane is not nearer than `nearest`. */
static struct reach find_reach(const struct primitive *primitive, const double from[3],
                               double nearest)
{
    struct bound bound = bound_none;
    struct reach reach = { 0 };
    if (primitive->kind == PRIMITIVE_PLANE)
        return reach_plane(primitive, from, nearest);
    if (primitive->kind == PRIMITIVE_MESH)
        bound_corners(primitive, &bound);
    else
        shape_of(primitive)->bound(primitive, &bound);
    if (bound_is_none(&bound))
        return reach;
    reach.distance = bound_reach(&bound, from);
    reach.radius = bound.radius;
    copy3(bound.center, reach.center);
    return reach;
}

/* Returns the least nonzero distance from the camera to a light or the origin. It is
 * used for planes, and for scenes in which no object has a known size. */
static double find_nearest(const struct scene *scene, const struct scene_object *world)
{
    double nearest = length3(scene->camera.location);
    for (size_t i = 0; i < world->light_count; i++) {
        double way[3], distance;
        subtract3(world->lights[i].position, scene->camera.location, way);
        distance = length3(way);
        if (distance > 0 && !(nearest > 0 && nearest < distance))
            nearest = distance;
    }
    return nearest;
}

/* Returns the distance and size of the object whose distance is the median. If the
 * number of objects is even, this is the nearer of the two middle objects. */
static struct reach find_size(const struct scene *scene,
                              const struct scene_object *world)
{
    const double *from = scene->camera.location;
    double nearest = find_nearest(scene, world);
    struct reach none = { nearest, nearest, { 0 } };
    struct reach reaches[MAX_SAMPLES];
    size_t step = world->part_count / MAX_SAMPLES + 1, count = 0;
    for (size_t i = 0; i < world->part_count; i += step) {
        reaches[count] = find_reach(&world->parts[i].primitive, from, nearest);
        count += reaches[count].distance > 0 && isfinite(reaches[count].distance);
    }
    if (count == 0)
        return none;
    qsort(reaches, count, sizeof *reaches, compare_reaches);
    return reaches[(count - 1) / 2];
}

static int unit_of(const struct reach *size)
{
    double length = size->distance;
    int log;
    if (length > MAX_ORDINARY)
        length = fmax(fmin(length, SIGHT * size->radius), 1);
    if (!(length > 0) || (length >= MIN_ORDINARY && length <= MAX_ORDINARY))
        return 0;
    frexp(length, &log);
    return log - 3 < -MAX_UNIT_LOG  ? -MAX_UNIT_LOG
           : log - 3 > MAX_UNIT_LOG ? MAX_UNIT_LOG
                                    : log - 3;
}

/* ---- All lengths --------------------------------------------------------- */

static void scale_camera(struct camera *camera, double by)
{
    scale3(by, camera->location);
    if (camera->orthographic) {
        scale3(by, camera->right);
        scale3(by, camera->up);
    }
    camera->lens_radius *= by;
    camera->focal_distance *= by;
}

/* Scales the lengths of a light that object_move does not scale. */
static void scale_light(struct light *light, double by)
{
    light->fade_distance *= by;
    if (light->beam != BEAM_CYLINDER)
        return;
    light->radius *= by;
    light->falloff *= by;
}

/* Moves a quartic to a space with the scale of the world, where its roots are most
 * accurate. */
static void place_quartic(struct primitive *primitive)
{
    const double(*rows)[4] = (const double(*)[4])primitive->to_world.rows;
    double size = 0;
    int log;
    for (int i = 0; i < 3; i++)
        size = fmax(size, greatest3(rows[i]));
    frexp(size, &log);
    quartic_enlarge(primitive, log);
}

static void scale_world(struct scene *scene, struct scene_object *world, double by)
{
    struct placement step = placement_scaling((const double[]){ by, by, by });
    object_move(world, &step);
    for (size_t i = 0; i < world->part_count; i++) {
        struct primitive *primitive = &world->parts[i].primitive;
        primitive->transformed = true;
        if (primitive->kind == PRIMITIVE_QUARTIC)
            place_quartic(primitive);
    }
    for (size_t i = 0; i < world->light_count; i++)
        scale_light(&world->lights[i], by);
    for (size_t i = 0; i < scene->fog_count; i++)
        scene->fogs[i].distance *= by;
    scale_camera(&scene->camera, by);
}

/* ---- Far lights ---------------------------------------------------------- */

/* Computes a length. Its squares neither overflow nor underflow. */
static double distance3(const double way[3])
{
    double size = greatest3(way), unit[3];
    copy3(way, unit);
    scale3(size > 0 ? 1 / size : 0, unit);
    return size * length3(unit);
}

static void shrink_about(const double center[3], double share, double point[3])
{
    for (int i = 0; i < 3; i++)
        point[i] = center[i] + (point[i] - center[i]) * share;
}

/* Moves a light to LIGHT_FARTHEST from the centre if it is farther away. Everything
 * about the light is scaled about the centre, which preserves all angles and ratios. */
static void bring_point(struct light *light, const double center[3])
{
    double way[3], share;
    subtract3(light->position, center, way);
    share = LIGHT_FARTHEST / distance3(way);
    if (!(share < 1))
        return;
    shrink_about(center, share, light->position);
    shrink_about(center, share, light->point_at);
    scale3(share, light->area_axes[0]);
    scale3(share, light->area_axes[1]);
    light->fade_distance *= share;
}

/* Moves a parallel light to at most LIGHT_FARTHEST from the centre, measured along its
 * rays. If its axis is farther than LIGHT_FARTHEST from the centre, the distance of the
 * axis is reduced, too, and a cylinder is scaled with it. */
static void bring_parallel(struct light *light, const double center[3])
{
    double beside[3], axis[3], along, near, share;
    subtract3(light->position, center, beside);
    subtract3(light->position, light->point_at, axis);
    scale3(1 / distance3(axis), axis);
    along = dot3(beside, axis);
    near = fmax(-LIGHT_FARTHEST, fmin(along, LIGHT_FARTHEST));
    for (int i = 0; i < 3; i++)
        beside[i] -= along * axis[i];
    share = fmin(LIGHT_FARTHEST / distance3(beside), 1);
    if (near == along && share == 1)
        return;
    for (int i = 0; i < 3; i++) {
        light->position[i] = center[i] + share * beside[i] + near * axis[i];
        light->point_at[i] = light->position[i] - LIGHT_FARTHEST * axis[i];
    }
    if (light->beam == BEAM_CYLINDER) {
        light->radius *= share;
        light->falloff *= share;
    }
    if (near != along)
        light->fade_distance *= near / along;
}

/* Shortens each axis of an area light to LIGHT_FARTHEST. An area with longer axes has
 * the same effect, because its points are so far away that only their directions
 * matter. */
static void shrink_area(struct light *light)
{
    for (int i = 0; i < 2; i++) {
        double share = LIGHT_FARTHEST / distance3(light->area_axes[i]);
        if (share < 1)
            scale3(share, light->area_axes[i]);
    }
}

static void bring_light(struct light *light, const double center[3])
{
    if (light->parallel)
        bring_parallel(light, center);
    else
        bring_point(light, center);
    shrink_area(light);
}

bool unit_choose(struct scene *scene, struct scene_object *world)
{
    struct reach size = find_size(scene, world);
    double by;
    scene->unit_log = unit_of(&size);
    by = ldexp(1, -scene->unit_log);
    if (by != 1)
        scale_world(scene, world, by);
    scale3(by, size.center);
    for (size_t i = 0; i < world->light_count; i++)
        bring_light(&world->lights[i], size.center);
    return abs(scene->unit_log) < MAX_UNIT_LOG;
}
