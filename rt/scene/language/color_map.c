/* color_map.c - parses color_map { [value colour] .. }, the colours of a pattern. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"
#include "rt/scene/vector3.h"

#include <string.h>

#define MAX_COLOR 1e100 /* keeps differences finite */

struct map_reading {
    struct color_map map;
    struct color_stop stops[MAX_ENTRIES];
    struct numbers first; /* colour of the first entry, with all terms */
};

static void put_stop(struct color_map *map, struct color_stop *stop, double at,
                     const double terms[COLOR_TERMS])
{
    stop->at = at;
    copy3(terms, stop->color);
    stop->filter = terms[3];
    stop->transmit = terms[4];
    map->clear += stop->filter != 0 || stop->transmit != 0;
    map->count++;
}

static bool add_stop(struct reader *reader, struct map_reading *reading, double at,
                     const struct numbers *color)
{
    struct color_map *map = &reading->map;
    struct color_stop *stop = &reading->stops[map->count];

    if (!map_has_room(reader, map->count))
        return false;
    if (greatest3(color->n) > MAX_COLOR)
        return reader_fault(reader, &reader->token,
                            "a colour of a map is out of range");
    if (map->count == 0)
        reading->first = *color;
    if (map->count > 0 && at < stop[-1].at)
        at = stop[-1].at;
    put_stop(map, stop, at, color->n);
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
        if (!read_color(reader, &color) || !add_stop(reader, reading, at[i], &color))
            return false;
        reader_comma(reader);
    }
    return count > 0 || reader_expected(reader, "a number");
}

static bool read_entries(struct reader *reader, struct map_reading *reading)
{
    struct block entry;

    do {
        bool good = block_open(reader, &entry, '[') && read_stops(reader, reading);
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
    map->stops = reader_keep(reader, stops, map->count * sizeof *stops);
    return map->stops;
}

bool color_map_gray(struct reader *reader, struct color_map *map)
{
    static const struct color_stop stops[2] = { { .at = 0, .color = { 0, 0, 0 } },
                                                { .at = 1, .color = { 1, 1, 1 } } };

    *map = (struct color_map){ .count = 2 };
    return keep_map(reader, stops, map);
}

bool color_map_round(struct reader *reader, struct color_map *map)
{
    static const struct color_stop stops[4] = { { .at = 0, .color = { 0, 1, 1 } },
                                                { .at = .333, .color = { 1, 1, 0 } },
                                                { .at = .666, .color = { 1, 0, 1 } },
                                                { .at = 1, .color = { 0, 1, 1 } } };

    *map = (struct color_map){ .count = 4 };
    return keep_map(reader, stops, map);
}

bool color_map_listed(struct reader *reader, const struct numbers *colors, size_t count,
                      struct color_map *map)
{
    struct color_stop stops[MAX_LISTED];

    *map = (struct color_map){ .count = 0 };
    for (size_t i = 0; i < count; i++)
        put_stop(map, &stops[i], (double)i, colors[i].n);
    return keep_map(reader, stops, map);
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
