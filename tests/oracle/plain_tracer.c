/* plain_tracer.c - see plain_tracer.h. */
#include "tests/oracle/plain_tracer.h"

#include "tests/oracle/plain_shapes.h"

#include <math.h>

/* POV-Ray 3.7's: hits nearer than this are the surface that a ray starts
 * from; lights more oblique than this, and patterns nearer than this to the
 * next cell, count as at the limit; shadows need blockers this far from the
 * point and from the light. */
#define NEAREST_HIT 1e-6
#define SMALL_ANGLE 1e-10
#define SHADOW_DISTANCE 1e-3

struct hit {
    const struct primitive *primitive; /* NULL: none */
    double distance;
    double normal[3]; /* world, unit */
};

/* --- transforms -------------------------------------------------------- */

static void transform_direction(const struct transform *transform,
                                const double in[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = dot(transform->rows[i], in);
}

static void transform_point(const struct transform *transform,
                            const double in[3], double out[3])
{
    transform_direction(transform, in, out);
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

/* --- the nearest hit ---------------------------------------------------- */

/* Crossings of one primitive beyond the limit and before the hit so far. */
static void try_primitive(const struct primitive *primitive,
                          const struct ray *ray, double limit,
                          struct hit *hit)
{
    struct crossing crossings[MOST_CROSSINGS];
    struct ray local;
    transform_point(&primitive->to_local, ray->origin, local.origin);
    transform_direction(&primitive->to_local, ray->direction,
                        local.direction);
    const size_t count = plain_crossings(primitive, &local, crossings);
    for (size_t i = 0; i < count; i++) {
        const double distance = crossings[i].distance;
        if (!(distance > limit && distance < hit->distance))
            continue;
        hit->primitive = primitive;
        hit->distance = distance;
        normal_to_world(&primitive->to_local, crossings[i].normal,
                        hit->normal);
    }
}

static struct hit nearest_hit(const struct scene *scene,
                              const struct ray *ray)
{
    struct hit hit = { .primitive = NULL, .distance = INFINITY };
    for (size_t i = 0; i < scene->primitive_count; i++)
        try_primitive(&scene->primitives[i], ray, NEAREST_HIT, &hit);
    if (hit.primitive && dot(hit.normal, ray->direction) > 0)
        scale_by(hit.normal, -1);
    return hit;
}

static bool blocked(const struct scene *scene, const struct ray *to_light,
                    double distance)
{
    struct hit hit = { NULL, distance - SHADOW_DISTANCE, { 0 } };
    for (size_t i = 0; i < scene->primitive_count && !hit.primitive; i++)
        if (!scene->primitives[i].no_shadow)
            try_primitive(&scene->primitives[i], to_light, SHADOW_DISTANCE,
                          &hit);
    return hit.primitive != NULL;
}

/* --- shading ------------------------------------------------------------ */

static const double *pigment_color(const struct pigment *pigment,
                                   const double point[3])
{
    double local[3], sum = 0;
    if (pigment->kind == PIGMENT_COLOR)
        return pigment->color[0];
    transform_point(&pigment->to_local, point, local);
    for (int i = 0; i < 3; i++)
        sum += floor(local[i] + SMALL_ANGLE);
    return pigment->color[fmod(sum, 2) != 0];
}

/* phong: the eye's ray mirrored at the surface, against the light;
 * specular: the direction halfway between eye and light, against the
 * normal.  Neither takes the surface's colour. */
static double highlight(const struct finish *finish, const double eye[3],
                        const double normal[3], const double to_light[3])
{
    double mirrored[3], halfway[3], sum = 0;
    add_scaled(mirrored, eye, -2 * dot(eye, normal), normal);
    add_scaled(halfway, to_light, -1, eye);
    normalise(halfway);
    const double phong = dot(mirrored, to_light);
    const double specular = dot(halfway, normal);
    if (finish->phong > 0 && phong > 0)
        sum += finish->phong * pow(phong, finish->phong_size);
    if (finish->specular > 0 && specular > 0)
        sum += finish->specular * pow(specular, 1 / finish->roughness);
    return sum;
}

struct surface {
    const struct ray *ray; /* what sees it */
    const struct finish *finish;
    double point[3], normal[3];
    const double *color;
};

/* A light behind the surface gives nothing, and one without shadows has no
 * highlights. */
static void add_light(const struct scene *scene, const struct light *light,
                      const struct surface *surface, bool shadows,
                      double color[3])
{
    struct ray to_light;
    copy(to_light.origin, surface->point);
    add_scaled(to_light.direction, light->position, -1, surface->point);
    const double distance = sqrt(dot(to_light.direction, to_light.direction));
    scale_by(to_light.direction, 1 / distance);
    const double cosine = dot(surface->normal, to_light.direction);
    if (cosine < SMALL_ANGLE)
        return;
    if (shadows && !light->shadowless && blocked(scene, &to_light, distance))
        return;
    const double bright = light->shadowless ? 0
        : highlight(surface->finish, surface->ray->direction, surface->normal,
                    to_light.direction);
    for (int i = 0; i < 3; i++)
        color[i] += light->color[i]
            * (surface->finish->diffuse * cosine * surface->color[i] + bright);
}

static void shade(const struct scene *scene, const struct ray *ray,
                  const struct hit *hit, bool shadows, double color[3])
{
    struct surface surface = { .ray = ray, .finish = &hit->primitive->finish };
    point_on(ray, hit->distance, surface.point);
    copy(surface.normal, hit->normal);
    surface.color = pigment_color(&hit->primitive->pigment, surface.point);
    for (int i = 0; i < 3; i++)
        color[i] = surface.finish->ambient[i] * scene->ambient_light[i]
            * surface.color[i];
    for (size_t i = 0; i < scene->light_count; i++)
        add_light(scene, &scene->lights[i], &surface, shadows, color);
}

/* --- the frame ---------------------------------------------------------- */

static struct ray camera_ray(const struct camera *camera, double u, double v)
{
    struct ray ray;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = camera->location[i];
        ray.direction[i] = camera->direction[i] + u * camera->right[i]
            + v * camera->up[i];
    }
    normalise(ray.direction);
    return ray;
}

/* Colours computed for a display of some gamma: its power of them is light. */
static double as_light(const struct scene *scene, double color)
{
    const double gamma = scene->assumed_gamma;
    return gamma > 0 && gamma != 1 ? pow(fmax(color, 0), gamma) : color;
}

static void store(const struct scene *scene, const struct frame *frame,
                  size_t pixel, const double color[3], const struct hit *hit)
{
    const double id =
        hit->primitive ? (double)(hit->primitive - scene->primitives + 1) : 0;
    for (size_t i = 0; i < 3; i++) {
        frame->channel[CHANNEL_RED + i][pixel] = as_light(scene, color[i]);
        frame->channel[CHANNEL_NORMAL_X + i][pixel] = hit->normal[i];
    }
    frame->channel[CHANNEL_DEPTH][pixel] = id > 0 ? hit->distance : 0;
    frame->channel[CHANNEL_ID][pixel] = id;
}

static void trace_pixel(const struct scene *scene, const struct frame *frame,
                        size_t x, size_t y, bool shadows)
{
    const double u = ((double)x + .5) / (double)frame->width - .5;
    const double v = .5 - ((double)y + .5) / (double)frame->height;
    const size_t pixel = y * frame->width + x;
    const struct ray ray = camera_ray(&scene->camera, u, v);
    const struct hit hit = nearest_hit(scene, &ray);
    double color[3];
    copy(color, scene->background);
    if (hit.primitive)
        shade(scene, &ray, &hit, shadows, color);
    store(scene, frame, pixel, color, &hit);
}

bool plain_trace(const struct scene *scene, size_t width, size_t height,
                 bool shadows, struct frame *frame)
{
    if (!frame_allocate(frame, width, height))
        return false;
    for (size_t y = 0; y < height; y++)
        for (size_t x = 0; x < width; x++)
            trace_pixel(scene, frame, x, y, shadows);
    return true;
}
