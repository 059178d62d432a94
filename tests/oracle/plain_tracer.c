/* plain_tracer.c - see plain_tracer.h. */
#include "tests/oracle/plain_tracer.h"

#include "tests/oracle/plain_light.h"

#include <math.h>

/* Hits nearer than this are the surface that a ray starts from. */
#define NEAREST_HIT 1e-6
/* .. and what lies farther along a ray is not seen. */
#define FARTHEST_HIT 1e12

/* A ray on its way: how many rays led to it, itself counted, and how much of
 * the pixel's colour it may make. */
struct path {
    struct ray ray;
    int level;
    double importance;
};

static void trace_path(const struct plain_tracer *tracer,
                       const struct path *path, struct plain_hit *hit,
                       double color[3]);

/* --- the nearest hit ---------------------------------------------------- */

static void find_nearest(const struct plain_tracer *tracer,
                         const struct ray *ray, struct plain_hit *hit)
{
    const struct scene *scene = tracer->scene;
    *hit = (struct plain_hit){ .primitive = NULL, .distance = FARTHEST_HIT };
    for (size_t i = 0; i < scene->region_count; i++) {
        plain_cross_region(tracer->crossings, scene, &scene->regions[i], ray);
        plain_next_hit(tracer->crossings, NEAREST_HIT, hit->distance, hit);
    }
}

/* --- rays that come of a hit -------------------------------------------- */

/* Where a ray is hit, and what it may still add to. */
struct branching {
    const struct plain_tracer *tracer;
    const struct path *path;
    const struct plain_surface *surface;
    double *color;
};

/* Every ray counts as a level, also one that goes straight on; POV-Ray does
 * not count those. */
static void follow(const struct branching *from, const double direction[3],
                   double share, const double weight[3])
{
    const struct scene *scene = from->tracer->scene;
    struct path path = { .level = from->path->level + 1,
                         .importance = from->path->importance * share };
    struct plain_hit hit;
    double seen[3];
    if (path.level > scene->max_trace_level
        || path.importance < scene->adc_bailout)
        return;
    copy(path.ray.origin, from->surface->point);
    copy(path.ray.direction, direction);
    trace_path(from->tracer, &path, &hit, seen);
    for (int i = 0; i < 3; i++)
        from->color[i] += weight[i] * seen[i];
}

static void mirror(const struct plain_surface *surface, double direction[3])
{
    const double *d = surface->ray->direction;
    add_scaled(direction, d, -2 * dot(d, surface->normal), surface->normal);
}

/* Snell's law: across the normal the direction is `ratio` times what it was.
 * False: that is more than 1, and nothing leaves. */
static bool refract(const struct plain_surface *surface, double ratio,
                    double direction[3])
{
    const double *n = surface->normal;
    double across[3];
    copy(direction, surface->ray->direction);
    if (ratio == 1)
        return true;
    add_scaled(across, direction, -dot(direction, n), n);
    scale_by(across, ratio);
    double left = 1 - dot(across, across);
    if (left < 0)
        return false;
    add_scaled(direction, across, -sqrt(left), n);
    return true;
}

/* POV-Ray's: of what passes less than the limit, judged by its brightness,
 * nothing is followed. */
static bool is_clear(const struct scene *scene, const double passing[3])
{
    return .297 * passing[0] + .589 * passing[1] + .114 * passing[2]
           > scene->adc_bailout;
}

/* What is totally reflected keeps all of its colour, and the surface is then
 * no other mirror besides. */
static void branch(const struct branching *from, const struct plain_hit *hit)
{
    static const double all[3] = { 1, 1, 1 };
    const struct plain_surface *surface = from->surface;
    const double *passing = surface->passing;
    double index = hit->primitive->ior;
    bool clear = is_clear(from->tracer->scene, passing);
    double mirrored[3], refracted[3], reflection[3];
    bool leaves = refract(surface, hit->entering ? 1 / index : index,
                          refracted);
    mirror(surface, mirrored);
    double weight = plain_mirror(surface, hit->entering ? index : 1 / index,
                                 reflection);
    if (clear && !leaves) {
        follow(from, mirrored, greatest(passing), all);
        return;
    }
    if (weight > 0)
        follow(from, mirrored, weight, reflection);
    if (clear)
        follow(from, refracted, greatest(passing), passing);
}

/* Each fog lets e^(-depth / distance) through, tinted by its filter, but its
 * transmit at least, and is seen for the rest. */
static void see_through_fogs(const struct scene *scene, double depth,
                             double color[3])
{
    for (int i = 0; i < 3; i++) {
        double haze = 0;
        for (size_t k = 0; k < scene->fog_count; k++) {
            const struct fog *fog = &scene->fogs[k];
            double through = fmax(exp(-depth / fog->distance), fog->transmit);
            double tint = 1 + fog->filter * (fog->color[i] - 1);
            color[i] *= through * tint;
            haze += (1 - through) * fog->color[i];
        }
        color[i] += haze;
    }
}

static void trace_clearly(const struct plain_tracer *tracer,
                          const struct path *path, struct plain_hit *hit,
                          double color[3])
{
    struct plain_surface surface;
    const struct branching from = { tracer, path, &surface, color };
    find_nearest(tracer, &path->ray, hit);
    if (!hit->primitive) {
        const struct scene *scene = tracer->scene;
        copy(color, scene->background);
        if (pigment_has_map(&scene->sky))
            plain_map_color(&scene->sky, path->ray.direction, color);
        return;
    }
    plain_describe(&path->ray, hit, &surface);
    plain_shade(tracer, &surface, color);
    branch(&from, hit);
}

/* POV-Ray's background is 2e10 away. */
static void trace_path(const struct plain_tracer *tracer,
                       const struct path *path, struct plain_hit *hit,
                       double color[3])
{
    trace_clearly(tracer, path, hit, color);
    see_through_fogs(tracer->scene, hit->primitive ? hit->distance : 2e10,
                     color);
}

/* --- the frame ---------------------------------------------------------- */

static struct ray camera_ray(const struct camera *camera, double u, double v)
{
    struct ray ray;
    for (int i = 0; i < 3; i++) {
        double across = u * camera->right[i] + v * camera->up[i];
        ray.origin[i] = camera->location[i]
                        + (camera->orthographic ? across : 0);
        ray.direction[i] = camera->direction[i]
                           + (camera->orthographic ? 0 : across);
    }
    normalise(ray.direction);
    return ray;
}

/* Colours computed for a display of some gamma: its power of them is light. */
static double as_light(const struct scene *scene, double color)
{
    double gamma = scene->assumed_gamma;
    return gamma > 0 && gamma != 1 ? pow(fmax(color, 0), gamma) : color;
}

static void store(const struct scene *scene, const struct frame *frame,
                  size_t pixel, const double color[3],
                  const struct plain_hit *hit)
{
    double id = hit->primitive
                    ? (double)(hit->primitive - scene->primitives + 1)
                    : 0;
    for (size_t i = 0; i < 3; i++) {
        frame->channel[CHANNEL_RED + i][pixel] = as_light(scene, color[i]);
        frame->channel[CHANNEL_NORMAL_X + i][pixel] = hit->normal[i];
    }
    frame->channel[CHANNEL_DEPTH][pixel] = id > 0 ? hit->distance : 0;
    frame->channel[CHANNEL_ID][pixel] = id;
}

static void trace_pixel(const struct plain_tracer *tracer,
                        const struct frame *frame, size_t x, size_t y)
{
    const struct scene *scene = tracer->scene;
    double u = ((double)x + .5) / (double)frame->width - .5;
    double v = .5 - ((double)y + .5) / (double)frame->height;
    const struct path path = { camera_ray(&scene->camera, u, v), 1, 1 };
    struct plain_hit hit;
    double color[3];
    trace_path(tracer, &path, &hit, color);
    store(scene, frame, y * frame->width + x, color, &hit);
}

bool plain_trace(const struct scene *scene, size_t width, size_t height,
                 struct frame *frame)
{
    const struct plain_tracer tracer = { scene, crossing_list_new(scene) };
    if (!tracer.crossings || !frame_allocate(frame, width, height)) {
        crossing_list_free(tracer.crossings);
        return false;
    }
    for (size_t y = 0; y < height; y++)
        for (size_t x = 0; x < width; x++)
            trace_pixel(&tracer, frame, x, y);
    crossing_list_free(tracer.crossings);
    return true;
}
