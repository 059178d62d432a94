/* pigment.c - computes the words of a pigment that has a map. */
#include "rt/layout/pigment.h"

#include <stdlib.h>

#include "rt/layout/bumps.h"
#include "rt/layout/record.h"
#include "rt/shapes/primitive.h"
#include "rt/scene/vector3.h"

/* The number of words in a row, which describes one stop by the fields STOP_AT,
 * STOP_SLOPE, STOP_COLOR and STOP_CHANGE. */
enum { STOP_SIZE = 8 };
#define STEP 1e-30 /* a smaller distance counts as 0 */

void gradient_words(const struct pigment *pigment, double words[GRADIENT_STOPS])
{
    for (int i = 0; i < GRADIENT_STOPS; i++) {
        words[i] = 0;
        for (int k = 0; k < 3; k++)
            words[i] += pigment->axis[k] * pigment->to_local.rows[k][i];
    }
}

static bool is_pattern(const struct pigment *pigment)
{
    return pigment->kind == PIGMENT_PATTERN || pigment->kind == PIGMENT_IMAGE;
}

bool scene_has_patterns(const struct scene *scene)
{
    bool found = is_pattern(&scene->sky) || scene_has_bumps(scene);
    for (size_t i = 0; i < scene->primitive_count && !found; i++)
        found = is_pattern(&scene->primitives[i].pigment);
    return found;
}

void pattern_rows(const struct pigment *pigment, double words[PATTERN_ROWS])
{
    memcpy(words, pigment->to_local.rows, PATTERN_ROWS * sizeof *words);
    if (pigment->pattern.function == PATTERN_GRADIENT)
        gradient_words(pigment, words);
}

const char *pattern_wave(const struct pigment *pigment)
{
    static const char *const routines[PATTERN_WAVES] = {
        [WAVE_RAMP] = "wave_ramp",   [WAVE_TRIANGLE] = "wave_triangle",
        [WAVE_SINE] = "wave_sine",   [WAVE_SCALLOP] = "wave_scallop",
        [WAVE_CUBIC] = "wave_cubic", [WAVE_POLY] = "wave_poly",
    };
    return pigment_list_count(pigment) > 0 ? NULL : routines[pigment->pattern.wave];
}

void pattern_numbers(const struct pattern *pattern, double numbers[MAP_NUMBERS])
{
    numbers[0] = pattern->frequency;
    numbers[1] = pattern->phase;
    numbers[2] = pattern->exponent;
    numbers[3] = 0;
    if (pattern->function != PATTERN_BRICK)
        return;
    for (int i = 0; i < 3; i++)
        numbers[i] = 1 / pattern->own.brick_size[i];
    numbers[3] = pattern->own.mortar;
}

size_t stop_count(const struct pigment *pigment)
{
    size_t listed = pigment_list_count(pigment);
    return listed > 0 ? 2 * listed : pigment->map.count;
}

bool has_stops_of(const struct pigment *pigment, const struct pigment *other)
{
    const struct pattern *a = &pigment->pattern, *b = &other->pattern;
    size_t listed = pigment_list_count(pigment);
    return pigment->map.stops == other->map.stops && listed == pigment_list_count(other)
           && (listed == 0
               || (a->wave == b->wave && a->frequency == b->frequency
                   && a->phase == b->phase && a->exponent == b->exponent));
}

size_t stops_size(const struct pigment *pigment)
{
    return STOP_SIZE * (stop_count(pigment) + 1);
}

/* Returns stop i of a list. The kernels assign equally spaced values, from 0 to 1, to
 * the entries of a list. Halfway between two entries the colour changes. */
static struct color_stop step(const struct pigment *pigment, size_t i)
{
    double last = (double)pigment_list_count(pigment) - 1;
    struct color_stop stop = pigment_listed(pigment, i / 2);
    stop.at = ((double)(i / 2) + (i % 2 ? .5 : -.5)) / last;
    return stop;
}

static struct color_stop stop_of(const struct pigment *pigment, size_t i)
{
    return pigment_list_count(pigment) > 0 ? step(pigment, i) : pigment->map.stops[i];
}

/* Writes a stop: its position, its slope (the reciprocal of the distance to the next
 * stop), its colour, and the change of colour. The slope and the change are 0 if the
 * next stop is at the same position. */
static void put_stop(const struct color_stop *stop, const struct color_stop *next,
                     double row[STOP_SIZE])
{
    double far = next->at - stop->at;
    row[0] = stop->at;
    row[1] = far > STEP ? 1 / far : 0;
    copy3(stop->color, row + 2);
    for (int i = 0; i < 3; i++)
        row[5 + i] = far > STEP ? next->color[i] - stop->color[i] : 0;
}

/* Returns the rows of the map's stops. The first row is a copy of the first stop at the
 * position -1. */
c205_word *stops_words(const struct pigment *pigment)
{
    c205_word *words = calloc(stops_size(pigment) + 1, sizeof *words);
    size_t count = stop_count(pigment);
    struct color_stop stop = stop_of(pigment, 0);
    stop.at = -1;
    for (size_t i = 0; words && i <= count; i++) {
        struct color_stop next = i < count ? stop_of(pigment, i) : stop;
        double row[STOP_SIZE];
        put_stop(&stop, i > 0 ? &next : &stop, row);
        stop = next;
        put_numbers(words + STOP_SIZE * i, row, STOP_SIZE);
    }
    return words;
}
