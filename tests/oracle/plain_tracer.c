/* plain_tracer.c - recursive ray tracing by POV-Ray's rules (plain_tracer.h). */
#include "tests/oracle/plain_tracer.h"

#include "tests/oracle/plain_light.h"

#include <assert.h>
#include <math.h>

/* Nearer hits are ignored, because they are on the surface where the ray starts. */
#define NEAREST_HIT 1e-6
/* Surfaces farther along a ray are invisible. */
#define FARTHEST_HIT 1e12
/* POV-Ray's limit: if the ratio of indices is nearer to 1, a ray is not bent. */
#define SAME_INDEX 1e-10

/* The interiors that contain a ray. The outermost is the first. Each interior is
 * represented by a primitive that has it. */
enum { MAX_INTERIORS = 64 };
struct interiors {
    bool known; /* false for rays from the camera */
    size_t count;
    const struct primitive *of[MAX_INTERIORS];
};

/* A ray. level: number of rays from the camera to this ray, both included, without
 * straight transmitted rays. importance: largest part of the colour. */
struct path {
    struct ray ray;
    int level;
    double importance;
    struct interiors interiors;
    size_t passed;  /* rank of the region that the ray has passed at its start; 0:
                     * none */
    bool reflected; /* the ray has been reflected since the camera */
};

static void trace_path(const struct plain_tracer *tracer, const struct path *path,
                       struct plain_hit *hit, double color[3]);

/* ---- The nearest hit ----------------------------------------------------- */

static bool has_clear_part(const struct scene *scene, size_t region)
{
    size_t first = scene->regions[region].first_primitive;
    for (size_t i = 0; i < scene->regions[region].primitive_count; i++)
        if (pigment_is_clear(&scene->primitives[first + i].pigment))
            return true;
    return false;
}

/* The index of a region from 1, among all or among those with transparent parts. */
struct rank {
    size_t place, count;
};

/* Returns the amount that is added to the distance of a hit for comparisons. It is less
 * for later regions, and more for a transparent surface than for any opaque surface. */
static double yield_of(const struct plain_hit *hit, struct rank all, struct rank clear)
{
    bool is_clear = pigment_is_clear(&hit->primitive->pigment);
    struct rank rank = is_clear ? clear : all;
    return (1 + is_clear - (double)rank.place / (double)rank.count) * PLAIN_DELTA;
}

/* By POV-Ray's rule, refraction does not change which objects a ray sees. */
static bool is_seen(const struct scene *scene, const struct region *region,
                    const struct path *path)
{
    unsigned from = path->reflected ? HIDDEN_FROM_REFLECTIONS : HIDDEN_FROM_IMAGE;
    for (size_t i = 0; i < region->primitive_count; i++)
        if (!(scene->primitives[region->first_primitive + i].hidden_from & from))
            return true;
    return false;
}

/* Finds the nearest hit. Returns its region's rank among transparent ones, or 0. */
static size_t find_nearest(const struct plain_tracer *tracer, const struct path *path,
                           struct plain_hit *hit)
{
    const struct scene *scene = tracer->scene;
    double nearest = INFINITY;
    struct rank all = { 0, scene->region_count }, rank = { 0, 0 };
    size_t found = 0;
    for (size_t i = 0; i < scene->region_count; i++)
        rank.count += has_clear_part(scene, i);
    *hit = (struct plain_hit){ .primitive = NULL, .distance = FARTHEST_HIT };
    for (size_t i = 0; i < scene->region_count; i++) {
        bool clear = has_clear_part(scene, i);
        struct plain_hit here;
        all.place++;
        rank.place += clear;
        bool passed = path->passed <= (clear ? rank.place : 0);
        if (!is_seen(scene, &scene->regions[i], path))
            continue;
        plain_cross_region(tracer->crossings, scene, &scene->regions[i], &path->ray);
        if (!plain_next_hit(tracer->crossings, passed ? NEAREST_HIT : -PLAIN_DELTA,
                            FARTHEST_HIT, &here)
            || here.distance + yield_of(&here, all, rank) >= nearest)
            continue;
        *hit = here;
        nearest = here.distance + yield_of(&here, all, rank);
        found = clear ? rank.place : 0;
    }
    return found;
}

/* ---- Bodies that contain a ray ------------------------------------------- */

/* Initialises a camera ray's interiors: none, or the one that it leaves first. */
static void find_interiors(struct interiors *in, const struct plain_hit *hit)
{
    if (!in->known && !hit->entering)
        in->of[in->count++] = hit->primitive;
    in->known = true;
}

static double innermost_index(const struct interiors *in)
{
    return in->count ? in->of[in->count - 1]->ior : 1;
}

/* Returns the index of an interior, or the number of interiors if it is absent. */
static size_t find(const struct interiors *in, size_t interior)
{
    size_t at = 0;
    while (at < in->count && in->of[at]->interior != interior)
        at++;
    return at;
}

/* Removes the interior of the surface if it contains the ray. Otherwise adds it.
 * Returns the refractive index before the surface divided by the index after it. If the
 * removed interior was not the innermost, the result is 1. */
static double cross(struct interiors *in, const struct primitive *surface)
{
    double from = innermost_index(in);
    size_t at = find(in, surface->interior);
    if (at == in->count) {
        assert(in->count < MAX_INTERIORS);
        in->of[in->count++] = surface;
    } else {
        in->count--;
        for (; at < in->count; at++)
            in->of[at] = in->of[at + 1];
    }
    return from / innermost_index(in);
}

/* Returns the relative index for Fresnel's formulas, by POV-Ray's rule. Where a ray
 * leaves the innermost of several interiors, it is 1, and the reflection is minimal. */
static double mirror_index(const struct interiors *in, const struct primitive *surface)
{
    double innermost = innermost_index(in);
    if (find(in, surface->interior) == in->count)
        return surface->ior / innermost;
    return (in->count > 1 ? innermost : 1) / surface->ior;
}

/* ---- Spawned rays -------------------------------------------------------- */

/* A hit, and the colour to which the colours of its rays are added. */
struct branching {
    const struct plain_tracer *tracer;
    const struct path *path;
    const struct plain_surface *surface;
    double *color;
    size_t rank; /* rank of the region of the hit */
};

/* Traces a secondary ray, unless it would add too little, and adds its colour times
 * `weight`. The direction, level and interiors of the ray have been set. */
static void follow(const struct branching *from, struct path *path, double share,
                   const double weight[3])
{
    const struct scene *scene = from->tracer->scene;
    struct plain_hit hit;
    double seen[3];
    path->importance = from->path->importance * share;
    if (from->path->level >= scene->max_trace_level
        || path->importance < scene->adc_bailout)
        return;
    copy(path->ray.origin, from->surface->point);
    trace_path(from->tracer, path, &hit, seen);
    for (int i = 0; i < 3; i++)
        from->color[i] += weight[i] * seen[i];
}

/* Computes the reflected direction. If bumps have changed the normal, the direction may
 * point below the surface. POV-Ray then reflects it again at the original normal. If
 * the result points below the changed normal, POV-Ray reflects the original ray at the
 * original normal instead. */
static void mirror(const struct plain_surface *surface, double direction[3])
{
    const double *d = surface->ray->direction;
    add_scaled(direction, d, -2 * dot(d, surface->normal), surface->normal);
    double ahead = dot(direction, surface->before);
    if (ahead >= 0 || !bumps_show(surface->bumps))
        return;
    if (dot(direction, surface->normal) >= 0)
        d = direction;
    add_scaled(direction, d, -2 * dot(d, surface->before), surface->before);
}

static bool goes_straight(double ratio)
{
    return fabs(ratio - 1) < SAME_INDEX;
}

/* Applies Snell's law: scales the component of the direction that is perpendicular to
 * the normal by `ratio`. Returns false if its length exceeds 1, by total reflection. */
static bool refract(const struct plain_surface *surface, double ratio,
                    double direction[3])
{
    double n[3], across[3];
    copy(n, surface->normal);
    copy(direction, surface->ray->direction);
    if (goes_straight(ratio))
        return true;
    if (dot(direction, n) > 0) /* the ray comes from the far side */
        scale_by(n, -1);
    add_scaled(across, direction, -dot(direction, n), n);
    scale_by(across, ratio);
    double left = 1 - dot(across, across);
    if (left < 0)
        return false;
    add_scaled(direction, across, -sqrt(left), n);
    return true;
}

/* By POV-Ray's rule, no ray is refracted if its brightness is below the limit. */
static bool is_clear(const struct scene *scene, const double passing[3])
{
    return .297 * passing[0] + .589 * passing[1] + .114 * passing[2]
           > scene->adc_bailout;
}

/* Traces the reflected and the refracted ray. A total reflection keeps its whole
 * colour, and the surface then has no other reflection. In a scene without transparent
 * objects, each surface determines on which side a ray is. */
static void branch(const struct branching *from, const struct plain_hit *hit)
{
    static const double all[3] = { 1, 1, 1 };
    const struct plain_surface *surface = from->surface;
    const double *passing = surface->passing;
    struct path mirrored = { .level = from->path->level + 1,
                             .interiors = from->path->interiors };
    double reflection[3];
    bool clear = is_clear(from->tracer->scene, passing);
    if (clear || surface->finish->fresnel)
        find_interiors(&mirrored.interiors, hit);
    struct path refracted = mirrored;
    double index = mirror_index(&mirrored.interiors, hit->primitive);
    double ratio = cross(&refracted.interiors, hit->primitive);
    if (goes_straight(ratio))
        refracted.level--;
    if (!from->tracer->clear)
        mirrored.interiors = from->path->interiors;
    bool leaves = refract(surface, ratio, refracted.ray.direction);
    refracted.passed = from->rank;
    refracted.reflected = from->path->reflected;
    mirrored.reflected = true;
    mirror(surface, mirrored.ray.direction);
    double weight = plain_mirror(surface, index, reflection);
    if (clear && !leaves) {
        follow(from, &mirrored, greatest(passing), all);
        return;
    }
    if (weight > 0)
        follow(from, &mirrored, weight, reflection);
    if (clear)
        follow(from, &refracted, greatest(passing), passing);
}

/* Applies the fogs. A fog transmits e^(-depth / distance), but at least its transmit.
 * The transmitted light is tinted by its filter. The rest is the colour of the fog. */
static void see_through_fogs(const struct scene *scene, double depth, double color[3])
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

static void trace_clearly(const struct plain_tracer *tracer, const struct path *path,
                          struct plain_hit *hit, double color[3])
{
    struct plain_surface surface;
    struct branching from = { tracer, path, &surface, color, 0 };
    from.rank = find_nearest(tracer, path, hit);
    if (!hit->primitive) {
        const struct scene *scene = tracer->scene;
        copy(color, scene->background);
        if (pigment_makes_sky(&scene->sky))
            plain_map_color(&scene->sky, path->ray.direction, color);
        return;
    }
    plain_describe(tracer->scene, &path->ray, hit, &surface);
    plain_shade(tracer, &surface, color);
    branch(&from, hit);
    copy(hit->normal, surface.normal);
}

/* Traces a ray, and applies the fogs to its colour. The background of POV-Ray is at a
 * distance of 2e10. */
static void trace_path(const struct plain_tracer *tracer, const struct path *path,
                       struct plain_hit *hit, double color[3])
{
    trace_clearly(tracer, path, hit, color);
    see_through_fogs(tracer->scene, hit->primitive ? hit->distance : 2e10, color);
}

/* ---- The frame ----------------------------------------------------------- */

/* Converts a colour that was computed for a display with a gamma to linear light. */
static double as_light(const struct scene *scene, double color)
{
    double gamma = scene->assumed_gamma;
    return gamma > 0 && gamma != 1 ? pow(fmax(color, 0), gamma) : color;
}

static void store(const struct scene *scene, const struct frame *frame, size_t pixel,
                  const double light[3], const struct plain_hit *hit)
{
    double id = hit->primitive ? (double)(hit->primitive - scene->primitives + 1) : 0;
    for (size_t i = 0; i < 3; i++) {
        frame->channel[CHANNEL_RED + i][pixel] = light[i];
        frame->channel[CHANNEL_NORMAL_X + i][pixel] = hit->normal[i];
    }
    frame->channel[CHANNEL_DEPTH][pixel] = id > 0
                                               ? ldexp(hit->distance, scene->unit_log)
                                               : 0;
    frame->channel[CHANNEL_ID][pixel] = id;
}

/* Adds the fraction of one sample to the light of a pixel. */
static struct plain_hit trace_sample(const struct plain_tracer *tracer,
                                     const struct frame *frame, size_t samples,
                                     size_t x, size_t y, double light[3])
{
    const struct scene *scene = tracer->scene;
    const struct path path = { .ray = plain_camera_ray(&scene->camera,
                                                       frame->width * samples,
                                                       frame->height * samples, x, y),
                               .level = 1,
                               .importance = 1 };
    struct plain_hit hit;
    double color[3];
    trace_path(tracer, &path, &hit, color);
    for (int i = 0; i < 3; i++)
        light[i] += as_light(scene, color[i]) / (double)(samples * samples);
    return hit;
}

/* Traces a pixel. Its depth, normal and number are those of the sample at half the rows
 * and columns. */
static void trace_pixel(const struct plain_tracer *tracer, const struct frame *frame,
                        size_t x, size_t y)
{
    size_t samples = plain_samples(&tracer->scene->camera);
    double light[3] = { 0, 0, 0 };
    struct plain_hit middle = { .primitive = NULL };
    for (size_t i = 0; i < samples * samples; i++) {
        size_t row = i / samples, column = i % samples;
        struct plain_hit hit = trace_sample(tracer, frame, samples,
                                            x * samples + column, y * samples + row,
                                            light);
        if (row == samples / 2 && column == samples / 2)
            middle = hit;
    }
    store(tracer->scene, frame, y * frame->width + x, light, &middle);
}

static bool lets_light_pass(const struct scene *scene)
{
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (pigment_is_clear(&scene->primitives[i].pigment))
            return true;
    return false;
}

bool plain_trace(const struct scene *scene, size_t width, size_t height,
                 struct frame *frame)
{
    const struct plain_tracer tracer = { scene, crossing_list_new(scene),
                                         lets_light_pass(scene) };
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
