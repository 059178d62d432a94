/* plain_light.c - shading, highlights and shadows by POV-Ray's rules. */
#include "tests/oracle/plain_light.h"

/* The limits of POV-Ray 3.7. SMALL_ANGLE: a light that is more oblique adds nothing,
 * and a point that is nearer to the next cell of a pattern is in that cell.
 * SHADOW_DISTANCE: the least distance of a surface that casts a shadow from the point,
 * from the light and, within a solid, from the next surface. */
#define SMALL_ANGLE 1e-10
#define SHADOW_DISTANCE 1e-3

/* ---- Surfaces ------------------------------------------------------------ */

/* Returns the cell of a checker at a point, or 1 outside of an image. */
static int pigment_cell(const struct pigment *pigment, const double point[3])
{
    double local[3], sum = 0;
    to_other_space(&pigment->to_local, point, local);
    if (pigment->kind == PIGMENT_IMAGE)
        return plain_image_misses(&pigment->image, local);
    if (pigment->kind != PIGMENT_CHECKER)
        return 0;
    for (int i = 0; i < 3; i++)
        sum += floor(local[i] + SMALL_ANGLE);
    return fmod(sum, 2) != 0;
}

void plain_map_color(const struct pigment *pigment, const double point[3],
                     double color[3])
{
    const struct color_stop *stops = pigment->map.stops;
    size_t last = pigment->map.count - 1, above = 0;
    double local[3];
    to_other_space(&pigment->to_local, point, local);
    if (pigment->kind == PIGMENT_IMAGE) {
        plain_image(&pigment->image, local, color);
        return;
    }
    double along = dot(local, pigment->axis);
    double value = pigment->kind == PIGMENT_GRADIENT ? along - floor(along)
                                                     : plain_pattern(pigment, local);
    while (above <= last && stops[above].at <= value)
        above++;
    if (above == 0 || above > last) {
        copy(color, stops[above ? last : 0].color);
        return;
    }
    double share = (value - stops[above - 1].at)
                   / (stops[above].at - stops[above - 1].at);
    for (int i = 0; i < 3; i++)
        color[i] = (1 - share) * stops[above - 1].color[i]
                   + share * stops[above].color[i];
}

static void passing_color(const struct pigment *pigment, int cell, double passing[3])
{
    for (int i = 0; i < 3; i++)
        passing[i] = pigment->color[cell][i] * pigment->filter[cell]
                     + pigment->transmit[cell];
}

void plain_describe(const struct scene *scene, const struct ray *ray,
                    const struct plain_hit *hit, struct plain_surface *surface)
{
    const struct pigment *pigment = &hit->primitive->pigment;
    surface->ray = ray;
    surface->finish = &hit->primitive->finish;
    surface->bumps = &hit->primitive->bumps;
    point_on(ray, hit->distance, surface->point);
    copy(surface->before, hit->normal);
    copy(surface->normal, hit->normal);
    plain_bumps(&hit->primitive->bumps, ldexp(1, scene->unit_log), surface->point,
                surface->normal);
    int cell = pigment_cell(pigment, surface->point);
    passing_color(pigment, cell, surface->passing);
    copy(surface->pigment, pigment->color[cell]);
    copy(surface->color, pigment->color[cell]);
    scale_by(surface->color, 1 - pigment->filter[cell] - pigment->transmit[cell]);
    if (pigment_makes_sky(pigment) && cell == 0) {
        plain_map_color(pigment, surface->point, surface->color);
        copy(surface->pigment, surface->color);
    }
}

/* phong uses the angle between the reflected eye ray and the light. specular uses the
 * angle between the normal and the direction halfway between eye and light. Neither
 * depends on the colour or the transparency of the surface. */
static double highlight(const struct finish *finish, const double eye[3],
                        const double normal[3], const double to_light[3])
{
    double mirrored[3], halfway[3], sum = 0;
    add_scaled(mirrored, eye, -2 * dot(eye, normal), normal);
    add_scaled(halfway, to_light, -1, eye);
    normalise(halfway);
    double phong = dot(mirrored, to_light);
    double specular = dot(halfway, normal);
    if (finish->phong > 0 && phong > 0)
        sum += finish->phong * pow(phong, finish->phong_size);
    if (finish->specular > 0 && specular > 0)
        sum += finish->specular * pow(specular, 1 / finish->roughness);
    return sum;
}

/* By POV-Ray's rule, a metal shows less of its colour at oblique angles. */
static void add_metal(double metallic, double cosine, const double pigment[3],
                      double color[3])
{
    double angle = acos(fmin(cosine, 1)) / acos(0);
    double fresnel = .014567225 / ((angle - 1.12) * (angle - 1.12)) - .011612903;
    double own = metallic * (1 - fmin(fmax(fresnel, 0), 1));
    for (int i = 0; i < 3; i++)
        color[i] *= 1 - own + own * pigment[i];
}

/* Returns the fraction of unpolarised light that a border of media reflects. */
static double fresnel_share(double index, double cosine)
{
    double inside = sqrt(fmax(1 - (1 - cosine * cosine) / (index * index), 0));
    double across = (cosine - index * inside) / (cosine + index * inside);
    double along = (index * cosine - inside) / (index * cosine + inside);
    return fmin((across * across + along * along) / 2, 1);
}

double plain_mirror(const struct plain_surface *surface, double index, double color[3])
{
    const struct finish *finish = surface->finish;
    double cosine = -dot(surface->ray->direction, surface->normal);
    double share = finish->fresnel
                       ? fresnel_share(index, cosine)
                       : pow(fmax(1 - cosine, 0), finish->reflection_falloff);
    for (int i = 0; i < 3; i++)
        color[i] = (1 - share) * finish->reflection[i]
                   + share * finish->reflection_most[i];
    double weight = finish->fresnel ? greatest(color)
                                    : fmax(greatest(finish->reflection),
                                           greatest(finish->reflection_most));
    add_metal(finish->reflection_metallic, cosine, surface->pigment, color);
    return weight;
}

/* ---- Shadows ------------------------------------------------------------- */

static bool casts_shadow(const struct scene *scene, const struct region *region)
{
    for (size_t i = 0; i < region->primitive_count; i++)
        if (!scene->primitives[region->first_primitive + i].no_shadow)
            return true;
    return false;
}

/* Multiplies the colour by the transmission of each surface between the point and the
 * light, both where the ray enters and where it leaves. */
static void pass_region(const struct plain_tracer *tracer, const struct region *region,
                        const struct ray *ray, double distance, double color[3])
{
    double last = SHADOW_DISTANCE;
    struct plain_hit hit;
    plain_cross_region(tracer->crossings, tracer->scene, region, ray);
    while (plain_next_hit(tracer->crossings, last, distance - SHADOW_DISTANCE, &hit)) {
        const struct pigment *pigment = &hit.primitive->pigment;
        double point[3], passing[3];
        point_on(ray, hit.distance, point);
        passing_color(pigment, pigment_cell(pigment, point), passing);
        for (int i = 0; i < 3; i++)
            color[i] *= passing[i];
        last = hit.distance + SHADOW_DISTANCE;
    }
}

static void pass_scene(const struct plain_tracer *tracer, const struct ray *ray,
                       double distance, double color[3])
{
    const struct scene *scene = tracer->scene;
    for (size_t i = 0; i < scene->region_count; i++)
        if (dot(color, color) > 0 && casts_shadow(scene, &scene->regions[i]))
            pass_region(tracer, &scene->regions[i], ray, distance, color);
}

/* ---- Light --------------------------------------------------------------- */

/* Computes the vector from a point to the light. Parallel rays start on a plane. */
static double way_to_light(const struct light *light, const double point[3],
                           double way[3])
{
    double axis[3];
    add_scaled(way, light->position, -1, point);
    if (!light->parallel) {
        double distance = sqrt(dot(way, way));
        scale_by(way, 1 / distance);
        return distance;
    }
    add_scaled(axis, light->position, -1, light->point_at);
    scale_by(axis, 1 / sqrt(dot(axis, axis)));
    double distance = dot(way, axis);
    copy(way, axis);
    return distance;
}

/* Returns 3 t^2 - 2 t^3, where t is 0 at low and 1 at high, and 1 above high. */
static double spline(double low, double high, double at)
{
    if (at >= high)
        return 1;
    if (at <= low)
        return 0;
    double t = (at - low) / (high - low);
    return t * t * (3 - 2 * t);
}

static double cosine_of(double degrees)
{
    return cos(degrees * acos(-1) / 180);
}

static double share_in_cone(const struct light *light, const double way[3])
{
    double axis[3];
    if (light->parallel)
        return 1;
    add_scaled(axis, light->position, -1, light->point_at);
    double cosine = dot(way, axis) / sqrt(dot(axis, axis));
    double full = cosine_of(light->radius);
    if (cosine <= 0)
        return 0;
    return pow(cosine, light->tightness)
           * (full > 0 ? spline(cosine_of(light->falloff), full, cosine) : 1);
}

static double share_in_cylinder(const struct light *light, const double point[3],
                                const double axis[3], double distance)
{
    double foot[3], across[3];
    if (distance <= 0)
        return 0;
    add_scaled(foot, point, distance, axis);
    add_scaled(across, foot, -1, light->position);
    double inner = 1 - sqrt(dot(across, across)) / light->falloff;
    if (inner <= 0)
        return 0;
    return pow(inner, light->tightness)
           * (light->radius > 0 ? spline(0, 1 - light->radius / light->falloff, inner)
                                : 1);
}

/* Returns the fraction of a light that remains after POV-Ray's attenuation. */
static double share_of_light(const struct light *light, const double point[3],
                             const double way[3], double distance)
{
    double share = 1;
    if (light->beam == BEAM_CONE)
        share = share_in_cone(light, way);
    if (light->beam == BEAM_CYLINDER)
        share = share_in_cylinder(light, point, way, distance);
    if (light->fade_power > 0 && light->fade_distance != 0)
        share *= 2
                 / (1 + pow(fabs(distance / light->fade_distance), light->fade_power));
    return share;
}

/* Returns the weight of a point on one side of an area light. Each of two points has
 * the weight 1/2. Longer ranges are bisected. */
static double side_share(int from, int to, int place)
{
    if (place < from || place > to)
        return 0;
    if (from == to)
        return 1;
    if (to - from == 1)
        return .5;
    double middle = (from + to) / 2.0;
    return .5 * side_share(from, (int)floor(middle), place)
           + .5 * side_share((int)ceil(middle), to, place);
}

static void area_place(const struct light *light, int u, int v, double place[3])
{
    int across = (int)light->area_size[0], down = (int)light->area_size[1];
    double a = across > 1 ? u / (across - 1.0) - .5 : 0;
    double b = down > 1 ? v / (down - 1.0) - .5 : 0;
    if (light->circular) {
        a += .001;
        b += .001;
        double scale = fmax(fabs(a), fabs(b)) / hypot(a, b);
        a *= scale;
        b *= scale;
    }
    add_scaled(place, light->position, a, light->area_axes[0]);
    add_scaled(place, place, b, light->area_axes[1]);
}

/* Sums the light of all points of an area light, attenuated by surfaces before it. */
static void pass_from_area(const struct plain_tracer *tracer, const struct light *light,
                           const struct ray *to_light, double color[3])
{
    int across = (int)light->area_size[0], down = (int)light->area_size[1];
    double sum[3] = { 0, 0, 0 };
    for (int i = 0; i < across * down; i++) {
        struct ray ray = *to_light;
        struct light there = *light;
        double left[3], share = side_share(0, across - 1, i / down)
                                * side_share(0, down - 1, i % down);
        area_place(light, i / down, i % down, there.position);
        double distance = way_to_light(&there, ray.origin, ray.direction);
        copy(left, color);
        pass_scene(tracer, &ray, distance + SHADOW_DISTANCE, left);
        add_scaled(sum, sum, share, left);
    }
    copy(color, sum);
}

/* Adds one light, unless it is behind the surface. A shadowless light has no
 * highlights. */
static void add_light(const struct plain_tracer *tracer, const struct light *light,
                      const struct plain_surface *surface, double color[3])
{
    struct ray to_light;
    double left[3];
    copy(to_light.origin, surface->point);
    double distance = way_to_light(light, surface->point, to_light.direction);
    double cosine = dot(surface->normal, to_light.direction);
    if (cosine < SMALL_ANGLE)
        return;
    copy(left, light->color);
    scale_by(left, share_of_light(light, surface->point, to_light.direction, distance));
    if (!light->shadowless && light->area_size[0] > 0)
        pass_from_area(tracer, light, &to_light, left);
    else if (!light->shadowless)
        pass_scene(tracer, &to_light, distance, left);
    double bright = light->shadowless
                        ? 0
                        : highlight(surface->finish, surface->ray->direction,
                                    surface->normal, to_light.direction);
    double lit = surface->finish->diffuse * pow(cosine, surface->finish->brilliance);
    double gleam[3] = { bright, bright, bright };
    add_metal(surface->finish->metallic, cosine, surface->pigment, gleam);
    for (int i = 0; i < 3; i++)
        color[i] += left[i] * (lit * surface->color[i] + gleam[i]);
}

void plain_shade(const struct plain_tracer *tracer, const struct plain_surface *surface,
                 double color[3])
{
    const struct scene *scene = tracer->scene;
    for (int i = 0; i < 3; i++)
        color[i] = (surface->finish->ambient[i] * scene->ambient_light[i]
                    + surface->finish->emission[i])
                   * surface->color[i];
    for (size_t i = 0; i < scene->light_count; i++)
        add_light(tracer, &scene->lights[i], surface, color);
}
