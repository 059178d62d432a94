/* color_map.c - color_map { [value colour] .. }, the colours of a pattern. */
#include "rt/scene/language/expression.h"
#include "rt/scene/language/pattern.h"
#include "rt/scene/vector.h"

#include <string.h>

enum { STOPS_MOST = 256 }; /* as in POV-Ray */
#define COLOR_MOST 1e100   /* so that differences are numbers */

struct map_reading {
    struct color_map map;
    struct color_stop stops[STOPS_MOST];
    struct numbers first; /* the first one's colour, all terms */
};

static bool add_stop(struct reader *reader, struct map_reading *reading,
                     double at, const struct numbers *color)
{
    struct color_map *map = &reading->map;
    struct color_stop *stop = &reading->stops[map->count];

    if (map->count == STOPS_MOST)
        return reader_fault(reader, &reader->token,
                            "more than %d entries in a map", STOPS_MOST);
    if (greatest3(color->n) > COLOR_MOST)
        return reader_fault(reader, &reader->token,
                            "a colour of a map is out of range");
    if (map->count == 0)
        reading->first = *color;
    stop->at = map->count > 0 && at < stop[-1].at ? stop[-1].at : at;
    memcpy(stop->color, color->n, sizeof stop->color);
    map->clear += color->n[3] != 0 || color->n[4] != 0;
    map->count++;
    return true;
}

/* In the oldest form an entry has two values and two colours. */
static bool read_stops(struct reader *reader, struct map_reading *reading)
{
    struct numbers color;
    double at[2];
    int count = 0;

    while (count < 2 && starts_expression(reader) && !starts_color(reader)) {
        if (!read_number(reader, &at[count++]))
            return false;
        reader_comma(reader);
    }
    for (int i = 0; i < count; i++) {
        if (!read_color(reader, &color)
            || !add_stop(reader, reading, at[i], &color))
            return false;
        reader_comma(reader);
    }
    return count > 0 || reader_expected(reader, "a number");
}

static bool read_entries(struct reader *reader, struct map_reading *reading)
{
    struct block entry;

    do {
        bool good = block_open(reader, &entry, '[')
                    && read_stops(reader, reading);
        if (!good || !reader_at_sign(reader, ']'))
            return good ? reader_expected(reader, "']'") : false;
        if (!block_finish(reader, &entry))
            return false;
        reader_comma(reader);
    } while (reader_at_sign(reader, '['));
    return true;
}

static bool keep_map(struct reader *reader, const struct color_stop *stops,
                     struct color_map *map)
{
    size_t size = map->count * sizeof *stops;
    struct color_stop *kept = arena_take(&reader->scene->kept, size);

    if (!kept)
        return reader_no_memory(reader);
    memcpy(kept, stops, size);
    map->stops = kept;
    return true;
}

bool color_map_gray(struct reader *reader, struct color_map *map)
{
    static const struct color_stop stops[2] = { { 0, { 0, 0, 0 } },
                                                { 1, { 1, 1, 1 } } };

    *map = (struct color_map){ .count = 2 };
    return keep_map(reader, stops, map);
}

bool color_map_round(struct reader *reader, struct color_map *map)
{
    static const struct color_stop stops[4] = { { 0, { 0, 1, 1 } },
                                                { .333, { 1, 1, 0 } },
                                                { .666, { 1, 0, 1 } },
                                                { 1, { 0, 1, 1 } } };

    *map = (struct color_map){ .count = 4 };
    return keep_map(reader, stops, map);
}

bool color_map_steps(struct reader *reader, const struct numbers *colors,
                     size_t count, struct color_map *map)
{
    struct color_stop stops[2 * LISTED_MOST];

    *map = (struct color_map){ .count = 2 * count };
    for (size_t i = 0; i < 2 * count; i++) {
        const double *terms = colors[i / 2].n;

        stops[i].at = ((double)(i / 2) + (i % 2 ? .5 : -.5))
                      / (double)(count - 1);
        copy3(terms, stops[i].color);
        map->clear += terms[3] != 0 || terms[4] != 0;
    }
    return keep_map(reader, stops, map);
}

bool color_map_of_two(struct reader *reader, struct pigment *pigment)
{
    struct color_map map = { .count = 2 };
    struct color_stop stops[2];

    for (int i = 0; i < 2; i++) {
        stops[i].at = i;
        memcpy(stops[i].color, pigment->color[i], sizeof stops[i].color);
        map.clear += pigment->filter[i] != 0 || pigment->transmit[i] != 0;
    }
    if (!keep_map(reader, stops, &map))
        return false;
    pigment->map = map;
    return true;
}

static void set_first(struct pigment *pigment, const struct numbers *color)
{
    memcpy(pigment->color[0], color->n, sizeof pigment->color[0]);
    pigment->filter[0] = color->n[3];
    pigment->transmit[0] = color->n[4];
    if (!pigment_has_map(pigment))
        pigment->kind = PIGMENT_COLOR;
}

static bool read_own(struct reader *reader, struct pigment *pigment)
{
    struct map_reading reading = { .map = { .count = 0 } };

    if (!read_entries(reader, &reading)
        || !keep_map(reader, reading.stops, &reading.map))
        return false;
    pigment->map = reading.map;
    set_first(pigment, &reading.first);
    return true;
}

bool color_map_read(struct reader *reader, struct pigment *pigment)
{
    const struct scene_value *value;
    struct numbers first = { .count = 0 };
    struct block block;
    bool good = true;

    if (!block_open(reader, &block, '{'))
        return false;
    value = reader_use(reader, VALUE_COLOR_MAP);
    if (value) {
        const struct pigment *named = &value->is.pigment;
        memcpy(first.n, named->color[0], sizeof named->color[0]);
        first.n[3] = named->filter[0];
        first.n[4] = named->transmit[0];
        pigment->map = named->map;
        set_first(pigment, &first);
    } else {
        good = read_own(reader, pigment);
    }
    return block_finish(reader, &block) && good;
}
