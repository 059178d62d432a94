/* environment.c - writes a scene's sky and fogs into the machine's memory. */
#include "rt/layout/environment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rt/layout/images.h"
#include "rt/layout/pigment.h"
#include "rt/scene/elementary.h"

/* Writes the routines and the numbers of a sky's map, in the order that sky.s
 * defines. */
static void put_sky_map(struct record_layout *layout, const struct pigment *sky,
                        const char *function, const char *wave, const double *numbers,
                        const c205_word stops[2])
{
    double rows[PATTERN_ROWS];
    c205_word words[PATTERN_ROWS];
    pattern_rows(sky, rows);
    put_numbers(words, rows, PATTERN_ROWS);
    layout_words(layout, layout_symbol(layout, "sky_pattern"), words, PATTERN_ROWS);
    words[0] = layout_symbol(layout, function);
    words[1] = wave ? layout_symbol(layout, wave) : 0;
    put_numbers(words + 2, numbers, MAP_NUMBERS);
    memcpy(words + 2 + MAP_NUMBERS, stops, 2 * sizeof *stops);
    layout_words(layout, layout_symbol(layout, "sky_map"), words, 2 + MAP_NUMBERS + 2);
}

/* Writes a sky whose pattern is not a gradient. `stops` contains the address and the
 * number of the colour stops. */
static void layout_sky_pattern(struct record_layout *layout, const struct pigment *sky,
                               const c205_word stops[2])
{
    double numbers[MAP_NUMBERS];
    pattern_numbers(&sky->pattern, numbers);
    put_sky_map(layout, sky, pattern_rules[sky->pattern.function].routine,
                pattern_wave(sky), numbers, stops);
}

/* Writes a sky that is an image. The image's address is written in place of the
 * stops. */
static void layout_sky_image(struct record_layout *layout, const struct pigment *sky,
                             const uint64_t *images)
{
    const struct image_map *image = &sky->image;
    const c205_word stops[2] = { images[image->table->number], 0 };
    double numbers[MAP_NUMBERS];
    image_numbers(image, numbers);
    put_sky_map(layout, sky, image_routine(image), image_sampler(image), numbers,
                stops);
    layout_words(layout, layout_symbol(layout, "scene_sky") + 64 * GRADIENT_STOPS,
                 stops, 1);
}

void layout_sky(struct record_layout *layout, const struct scene *scene,
                const uint64_t *images)
{
    size_t size = stops_size(&scene->sky);
    double numbers[GRADIENT_STOPS];
    c205_word words[GRADIENT_STOPS + 2], *stops;
    if (scene->sky.kind == PIGMENT_IMAGE)
        layout_sky_image(layout, &scene->sky, images);
    if (!pigment_has_map(&scene->sky))
        return;
    stops = stops_words(&scene->sky);
    if (!stops) {
        layout_fail(layout, "out of memory");
        return;
    }
    gradient_words(&scene->sky, numbers);
    put_numbers(words, numbers, GRADIENT_STOPS);
    words[GRADIENT_STOPS] = layout_reserve(layout, size);
    words[GRADIENT_STOPS + 1] = c205_from_integer((int64_t)stop_count(&scene->sky));
    layout_words(layout, layout_symbol(layout, "scene_sky"), words, GRADIENT_STOPS + 2);
    layout_words(layout, words[GRADIENT_STOPS], stops, size);
    if (scene->sky.kind == PIGMENT_PATTERN)
        layout_sky_pattern(layout, &scene->sky, words + GRADIENT_STOPS);
    free(stops);
}

/* Writes the numbers of a fog that the formula in light/fog.s uses. */
static void put_fog(struct record *record, const struct fog *fog)
{
    double scale = -1 / (fog->distance * elementary_log(2)), pass[3];
    for (size_t i = 0; i < 3; i++)
        pass[i] = 1 - fog->filter + fog->filter * fog->color[i];
    record_numbers(record, "FOG_SCALE", &scale, 1);
    record_numbers(record, "FOG_MIN", &fog->transmit, 1);
    record_numbers(record, "FOG_COLOR", fog->color, 3);
    record_numbers(record, "FOG_PASS", pass, 3);
    record_write(record);
}

void layout_fogs(struct record_layout *layout, const struct scene *scene)
{
    struct record record;
    if (scene->fog_count == 0)
        return;
    record_begin(&record, layout, "FOG_SIZE", scene->fog_count, 0);
    layout_word(layout, "scene_fogs", record.address);
    layout_word(layout, "scene_fog_count",
                c205_from_integer((int64_t)scene->fog_count));
    for (size_t i = 0; i < scene->fog_count; i++)
        put_fog(&record, &scene->fogs[i]);
    record_end(&record);
}
