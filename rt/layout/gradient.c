#include "rt/layout/gradient.h"

#include <stdlib.h>

#include "rt/layout/record.h"
#include "rt/scene/vector.h"

/* STOP_AT, STOP_SLOPE, STOP_COLOR, STOP_CHANGE */
enum { STOP_SIZE = 8 };
#define STEP 1e-30 /* what is nearer is in the same place */

void gradient_words(const struct pigment *pigment,
                    double words[GRADIENT_STOPS])
{
    for (int i = 0; i < GRADIENT_STOPS; i++) {
        words[i] = 0;
        for (int k = 0; k < 3; k++)
            words[i] += pigment->axis[k] * pigment->to_local.rows[k][i];
    }
}

size_t gradient_size(const struct color_map *map)
{
    return STOP_SIZE * (map->count + 1);
}

/* One with nothing behind it is the next one itself. */
static void put_stop(const struct color_stop *stop,
                     const struct color_stop *next, double row[STOP_SIZE])
{
    double far = next->at - stop->at;

    row[0] = stop->at;
    row[1] = far > STEP ? 1 / far : 0;
    copy3(stop->color, row + 2);
    for (int i = 0; i < 3; i++)
        row[5 + i] = far > STEP ? next->color[i] - stop->color[i] : 0;
}

c205_word *gradient_stops(const struct color_map *map)
{
    c205_word *words = calloc(gradient_size(map) + 1, sizeof *words);
    struct color_stop below = map->stops[0];

    below.at = -1;
    for (size_t i = 0; words && i <= map->count; i++) {
        double row[STOP_SIZE];

        if (i == 0)
            put_stop(&below, &below, row);
        else
            put_stop(&map->stops[i - 1],
                     &map->stops[i < map->count ? i : i - 1], row);
        put_numbers(words + STOP_SIZE * i, row, STOP_SIZE);
    }
    return words;
}
