/* plain_tracer.c - see plain_tracer.h. */
#include "tests/oracle/plain_tracer.h"

#include <math.h>

/* POV-Ray 3.7's: hits nearer than this are the surface that a ray starts
 * from; lights more oblique than this, and patterns nearer than this to the
 * next cell, count as at the limit; shadows need blockers this far from the
 * point and from the light. */
#define NEAREST_HIT 1e-6
#define SMALL_ANGLE 1e-10
#define SHADOW_DISTANCE 1e-3

struct ray {
    double origin[3], direction[3];
};

/* Where a ray crosses a surface, in the shape's own space. */
struct crossing {
    double distance;
    double normal[3];
};

struct hit {
    const struct primitive *primitive; /* NULL: none */
    double distance;
    double normal[3]; /* world, unit */
};

/* --- vectors ----------------------------------------------------------- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* result = a + scale b; result may be either. */
static void add_scaled(double result[3], const double a[3], double scale,
                       const double b[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] + scale * b[i];
}

static void copy(double to[3], const double from[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

static void scale_by(double a[3], double scale)
{
    for (int i = 0; i < 3; i++)
        a[i] *= scale;
}

static void normalise(double a[3])
{
    scale_by(a, 1 / sqrt(dot(a, a)));
}

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

static void point_on(const struct ray *ray, double distance, double point[3])
{
    add_scaled(point, ray->origin, distance, ray->direction);
}

/* --- shapes: every crossing of a line ----------------------------------- */

enum { MOST_CROSSINGS = 4 };

/* The real roots of a t^2 + 2 b t + c, by the form that does not cancel. */
static size_t quadratic(double a, double b, double c, double roots[2])
{
    const double discriminant = b * b - a * c;
    if (discriminant < 0 || a == 0)
        return 0;
    const double q = -(b + copysign(sqrt(discriminant), b));
    roots[0] = q / a;
    roots[1] = q == 0 ? 0 : c / q;
    return 2;
}

static size_t cross_sphere(const struct primitive *primitive,
                           const struct ray *ray,
                           struct crossing crossings[MOST_CROSSINGS])
{
    const double *const center = primitive->shape.sphere.center;
    const double radius = primitive->shape.sphere.radius;
    double from[3], roots[2], point[3];
    add_scaled(from, ray->origin, -1, center);
    const size_t count =
        quadratic(dot(ray->direction, ray->direction),
                  dot(from, ray->direction),
                  dot(from, from) - radius * radius, roots);
    for (size_t i = 0; i < count; i++) {
        crossings[i].distance = roots[i];
        point_on(ray, roots[i], point);
        add_scaled(crossings[i].normal, point, -1, center);
    }
    return count;
}

static void face_crossing(struct crossing *crossing, double distance, int axis)
{
    *crossing = (struct crossing) { .distance = distance };
    crossing->normal[axis] = 1;
}

/* The part of the line between each pair of faces; the box is what all three
 * have in common. */
static size_t cross_box(const struct primitive *primitive,
                        const struct ray *ray,
                        struct crossing crossings[MOST_CROSSINGS])
{
    const double (*const corner)[3] = primitive->shape.box.corner;
    crossings[0].distance = -INFINITY;
    crossings[1].distance = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        const double from = ray->origin[axis], along = ray->direction[axis];
        if (along == 0 && (from < corner[0][axis] || from > corner[1][axis]))
            return 0;
        if (along == 0)
            continue;
        const double a = (corner[0][axis] - from) / along;
        const double b = (corner[1][axis] - from) / along;
        if (fmin(a, b) > crossings[0].distance)
            face_crossing(&crossings[0], fmin(a, b), axis);
        if (fmax(a, b) < crossings[1].distance)
            face_crossing(&crossings[1], fmax(a, b), axis);
    }
    return crossings[0].distance <= crossings[1].distance ? 2 : 0;
}

/* The axis, its length, and a ray taken apart along and across it. */
struct cylinder_view {
    double axis[3], length;
    double height, rise;           /* of origin and direction */
    double from[3], direction[3];  /* across, from the axis */
};

static void view_cylinder(const struct primitive *primitive,
                          const struct ray *ray, struct cylinder_view *view)
{
    const double *const base = primitive->shape.cylinder.base;
    add_scaled(view->axis, primitive->shape.cylinder.cap, -1, base);
    view->length = sqrt(dot(view->axis, view->axis));
    normalise(view->axis);
    add_scaled(view->from, ray->origin, -1, base);
    view->height = dot(view->from, view->axis);
    view->rise = dot(ray->direction, view->axis);
    add_scaled(view->from, view->from, -view->height, view->axis);
    add_scaled(view->direction, ray->direction, -view->rise, view->axis);
}

static size_t cross_wall(const struct cylinder_view *view, double radius,
                         struct crossing *crossings)
{
    double roots[2];
    size_t count = 0;
    const size_t found = quadratic(dot(view->direction, view->direction),
                                   dot(view->from, view->direction),
                                   dot(view->from, view->from)
                                       - radius * radius, roots);
    for (size_t i = 0; i < found; i++) {
        const double height = view->height + roots[i] * view->rise;
        if (height < 0 || height > view->length)
            continue;
        crossings[count].distance = roots[i];
        add_scaled(crossings[count++].normal, view->from, roots[i],
                   view->direction);
    }
    return count;
}

static size_t cross_disk(const struct cylinder_view *view, double radius,
                         double height, struct crossing *crossing)
{
    double across[3];
    if (view->rise == 0)
        return 0;
    crossing->distance = (height - view->height) / view->rise;
    add_scaled(across, view->from, crossing->distance, view->direction);
    copy(crossing->normal, view->axis);
    return dot(across, across) <= radius * radius;
}

static size_t cross_cylinder(const struct primitive *primitive,
                             const struct ray *ray,
                             struct crossing crossings[MOST_CROSSINGS])
{
    const double radius = primitive->shape.cylinder.radius;
    struct cylinder_view view;
    view_cylinder(primitive, ray, &view);
    size_t count = cross_wall(&view, radius, crossings);
    if (primitive->shape.cylinder.open)
        return count;
    count += cross_disk(&view, radius, 0, &crossings[count]);
    return count + cross_disk(&view, radius, view.length, &crossings[count]);
}

static size_t cross_plane(const struct primitive *primitive,
                          const struct ray *ray,
                          struct crossing crossings[MOST_CROSSINGS])
{
    const double *const normal = primitive->shape.plane.normal;
    const double along = dot(normal, ray->direction);
    if (along == 0)
        return 0;
    crossings[0].distance =
        (primitive->shape.plane.distance - dot(normal, ray->origin)) / along;
    copy(crossings[0].normal, normal);
    return 1;
}

typedef size_t cross_shape(const struct primitive *primitive,
                           const struct ray *ray,
                           struct crossing crossings[MOST_CROSSINGS]);

static cross_shape *const cross[PRIMITIVE_KINDS] = {
    [PRIMITIVE_SPHERE] = cross_sphere,
    [PRIMITIVE_BOX] = cross_box,
    [PRIMITIVE_CYLINDER] = cross_cylinder,
    [PRIMITIVE_PLANE] = cross_plane,
};

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
    const size_t count = cross[primitive->kind](primitive, &local, crossings);
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
