#include "rt/layout/lights.h"

#include "rt/scene/vector.h"

/* What is narrower is a sharp edge, which is drawn so wide. */
#define EDGE_LEAST 1e-9

static bool fades(const struct light *light)
{
    return light->fade_power > 0 && light->fade_distance != 0;
}

/* Not the same in all directions and everywhere on them. */
static bool dims(const struct light *light)
{
    return light->beam != BEAM_NONE || fades(light);
}

static bool has_beam(const struct light *light)
{
    return dims(light) || light->parallel;
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

/* Where q is (light/beam.s) the edge begins, and how it grows from there. */
static void put_edge(struct record *record, const struct light *light)
{
    double edge[2] = { -1, 1 }; /* none */
    double low = 0, high = 0;
    bool soft = false;

    if (light->beam == BEAM_CONE) {
        low = cos(light->falloff * PI / 180);
        high = cos(light->radius * PI / 180);
        soft = high > 0;
    } else if (light->beam == BEAM_CYLINDER) {
        high = fmax(1 - light->radius / light->falloff,
                    -1); /* q is above 0 */
        soft = light->radius > 0;
    }
    if (soft) {
        edge[0] = fmin(low, high - EDGE_LEAST);
        edge[1] = 1 / (high - edge[0]);
    }
    record_numbers(record, "BEAM_EDGE", edge, 2);
}

static void put_beam(struct record *record, const struct light *light)
{
    double way[3], falloff = 1 / light->falloff;
    double fade[2] = { 1 / fabs(light->fade_distance), light->fade_power };

    subtract3(light->position, light->point_at, way);
    scale3(1 / length3(way), way);
    record_integer(record, "BEAM_DIMS", dims(light));
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
    record_write(record);
}

static void put_light(struct record *record, const struct light *light)
{
    double gleams = light->shadowless ? 0 : 1;

    record_numbers(record, "LIGHT_POSITION", light->position, 3);
    record_numbers(record, "LIGHT_COLOR", light->color, 3);
    record_numbers(record, "LIGHT_GLEAMS", &gleams, 1);
}

static void layout_beams(struct record_layout *layout,
                         const struct scene *scene, size_t count,
                         struct row *row)
{
    struct record record;

    record_begin(&record, layout, "BEAM_SIZE", count, 0);
    *row = record_row(&record);
    for (size_t i = 0; i < scene->light_count; i++)
        if (has_beam(&scene->lights[i]))
            put_beam(&record, &scene->lights[i]);
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
