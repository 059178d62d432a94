/* lights.c - writes a scene's lights into the machine's memory. */
#include "rt/layout/lights.h"

#include "rt/scene/elementary.h"
#include "rt/scene/vector3.h"

/* The smallest width of the soft edge of a beam. A sharper edge gets this width. */
#define MIN_EDGE 1e-9

static bool fades(const struct light *light)
{
    return light->fade_power > 0 && light->fade_distance != 0;
}

/* Returns true if the light's intensity varies with direction or distance. */
static bool dims(const struct light *light)
{
    return light->beam != BEAM_NONE || fades(light);
}

/* Returns the number of points of an area light that casts shadows. 0: the light casts
 * shadows from its position. */
static size_t points_of(const struct light *light)
{
    size_t count = light->area_size[0] * light->area_size[1];
    return count > 1 && !light->shadowless ? count : 0;
}

bool light_shadows_from_point(const struct light *light)
{
    return !light->shadowless && !light->parallel && points_of(light) == 0;
}

static bool has_beam(const struct light *light)
{
    return dims(light) || light->parallel || points_of(light) > 0;
}

static size_t count_beams(const struct scene *scene)
{
    size_t count = 0;
    for (size_t i = 0; i < scene->light_count; i++)
        count += has_beam(&scene->lights[i]);
    return count;
}

bool scene_has_beams(const struct scene *scene)
{
    return count_beams(scene) > 0;
}

static size_t count_points(const struct scene *scene)
{
    size_t count = 0;
    for (size_t i = 0; i < scene->light_count; i++)
        count += points_of(&scene->lights[i]);
    return count;
}

bool scene_has_areas(const struct scene *scene)
{
    return count_points(scene) > 0;
}

/* ---- Areas --------------------------------------------------------------- */

/* Returns the weight of point `at` among the points first .. last. As in POV-Ray, the
 * points are halved recursively until two points are left, and each half gets half of
 * the weight. A middle point belongs to both halves. */
static double weight_of(size_t first, size_t last, size_t at)
{
    size_t sum = first + last;
    if (at < first || at > last)
        return 0;
    if (last - first < 2)
        return last == first ? 1 : .5;
    return (weight_of(first, sum / 2, at) + weight_of((sum + 1) / 2, last, at)) / 2;
}

/* Returns the position of point `at` of the `size` points along a side of an area
 * light, from -.5 to .5. */
static double place_on_side(size_t at, size_t size)
{
    return size > 1 ? (double)at / (double)(size - 1) - .5 : 0;
}

/* Maps a point of the square from -.5 to .5 to the inscribed disk, as in POV-Ray. The
 * border of the square is mapped to the circle, and each line from the centre is scaled
 * evenly. The added .001 avoids a division by 0 at the centre. */
static void draw_together(double place[2])
{
    double most;
    place[0] += .001;
    place[1] += .001;
    most = fmax(fabs(place[0]), fabs(place[1]));
    most /= sqrt(place[0] * place[0] + place[1] * place[1]);
    place[0] *= most;
    place[1] *= most;
}

static void put_point(struct record *record, const struct light *light, size_t i,
                      size_t k)
{
    const size_t *size = light->area_size;
    double place[2] = { place_on_side(i, size[0]), place_on_side(k, size[1]) };
    double weight = weight_of(0, size[0] - 1, i) * weight_of(0, size[1] - 1, k);
    double position[3];
    if (light->circular)
        draw_together(place);
    for (int axis = 0; axis < 3; axis++)
        position[axis] = light->position[axis] + place[0] * light->area_axes[0][axis]
                         + place[1] * light->area_axes[1][axis];
    record_numbers(record, "LIGHT_POINT_POSITION", position, 3);
    record_numbers(record, "LIGHT_POINT_WEIGHT", &weight, 1);
    record_write(record);
}

static void layout_points(struct record_layout *layout, const struct scene *scene,
                          size_t count, struct row *row)
{
    struct record record;
    record_begin(&record, layout, "LIGHT_POINT_SIZE", count, 0);
    *row = record_row(&record);
    for (size_t light = 0; light < scene->light_count; light++) {
        const size_t *size = scene->lights[light].area_size;
        if (points_of(&scene->lights[light]) == 0)
            continue;
        for (size_t i = 0; i < size[0]; i++)
            for (size_t k = 0; k < size[1]; k++)
                put_point(&record, &scene->lights[light], i, k);
    }
    record_end(&record);
}

/* ---- Beams --------------------------------------------------------------- */

/* Writes the value of q (light/beam.s) at which the soft edge of the beam begins, and
 * the reciprocal of the width of the edge in q. */
static void put_edge(struct record *record, const struct light *light)
{
    double edge[2] = { -1, 1 }; /* no edge */
    double low = 0, high = 0;
    bool soft = false;
    if (light->beam == BEAM_CONE) {
        low = elementary_cos(light->falloff * PI / 180);
        high = elementary_cos(light->radius * PI / 180);
        soft = high > 0;
    } else if (light->beam == BEAM_CYLINDER) {
        high = fmax(1 - light->radius / light->falloff, -1); /* q is positive */
        soft = light->radius > 0;
    }
    if (soft) {
        edge[0] = fmin(low, high - MIN_EDGE);
        edge[1] = 1 / (high - edge[0]);
    }
    record_numbers(record, "BEAM_EDGE", edge, 2);
}

static void put_beam(struct record *record, const struct light *light, uint64_t points)
{
    double way[3], falloff = 1 / light->falloff;
    double fade[2] = { 1 / fabs(light->fade_distance), light->fade_power };
    subtract3(light->position, light->point_at, way);
    scale3(1 / length3(way), way);
    record_integer(record, "BEAM_ATTENUATES", dims(light));
    record_integer(record, "BEAM_PARALLEL", light->parallel);
    record_integer(record, "BEAM_KIND", light->beam);
    if (light->beam != BEAM_NONE || light->parallel)
        record_numbers(record, "BEAM_AXIS", way, 3);
    if (light->beam == BEAM_CYLINDER)
        record_numbers(record, "BEAM_NARROW", &falloff, 1);
    put_edge(record, light);
    record_numbers(record, "BEAM_TIGHTNESS", &light->tightness, 1);
    if (fades(light))
        record_numbers(record, "BEAM_FADE", fade, 2);
    if (points_of(light) > 0) {
        record_address(record, "BEAM_POINTS", points);
        record_integer(record, "BEAM_POINT_COUNT", points_of(light));
    }
    record_write(record);
}

static void put_light(struct record *record, const struct light *light)
{
    double gleams = light->shadowless ? 0 : 1;
    record_numbers(record, "LIGHT_POSITION", light->position, 3);
    record_numbers(record, "LIGHT_COLOR", light->color, 3);
    record_numbers(record, "LIGHT_HIGHLIGHTS", &gleams, 1);
}

static void layout_beams(struct record_layout *layout, const struct scene *scene,
                         size_t count, struct row *row)
{
    struct record record;
    struct row points = { 0, 0 };
    size_t point_count = count_points(scene), point = 0;
    if (point_count > 0)
        layout_points(layout, scene, point_count, &points);
    record_begin(&record, layout, "BEAM_SIZE", count, 0);
    *row = record_row(&record);
    for (size_t i = 0; i < scene->light_count; i++) {
        const struct light *light = &scene->lights[i];
        if (has_beam(light))
            put_beam(&record, light, row_at(&points, point));
        point += points_of(light);
    }
    record_end(&record);
}

void layout_lights(struct record_layout *layout, const struct scene *scene)
{
    size_t beams = count_beams(scene), beam = 0;
    struct record record;
    struct row row = { 0, 0 };
    if (beams > 0)
        layout_beams(layout, scene, beams, &row);
    record_begin(&record, layout, "LIGHT_SIZE", scene->light_count, 0);
    layout_word(layout, "scene_lights", record.address);
    for (size_t i = 0; i < scene->light_count; i++) {
        put_light(&record, &scene->lights[i]);
        if (has_beam(&scene->lights[i]))
            record_address(&record, "LIGHT_BEAM", row_at(&row, beam++));
        record_write(&record);
    }
    record_end(&record);
    layout_word(layout, "scene_light_count",
                c205_from_integer((int64_t)scene->light_count));
}
