/* color_map.c - parses color_map { [value colour] .. }, the colours of a pattern. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"
#include "rt/scene/vector3.h"


#define MAX_COLOR 1e100 /* keeps differences finite */

struct map_reading {
    struct color_map map;
    size_t room; /* capacity of its stops */
};

static bool put_stop(struct reader *reader, struct map_reading *reading, double at,
                     const struct numbers *color)
{
    struct color_map *map = &reading->map;
    struct color_stop stop = { at, { 0 }, color->n[3], color->n[4] };

    copy3(color->n, stop.color);
    map->clear += stop.filter != 0 || stop.transmit != 0;
    return arena_add(&reader->scene->kept, &map->stops, &map->count, &reading->room,
                     &stop, sizeof stop)
           || reader_no_memory(reader);
}

static bool add_stop(struct reader *reader, struct map_reading *reading, double at,
                     const struct numbers *color)
{
    const struct color_map *map = &reading->map;

    if (!map_has_room(reader, map->count))
        return false;
    if (greatest3(color->n) > MAX_COLOR)
        return reader_fault(reader, &reader->token,
                            "a colour of a map is out of range");
    if (map->count > 0 && at < map->stops[map->count - 1].at)
        at = map->stops[map->count - 1].at;
    return put_stop(reader, reading, at, color);
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

static const struct color_stop gray[] = { { .at = 0, .color = { 0, 0, 0 } },
                                          { .at = 1, .color = { 1, 1, 1 } } };
const struct color_map color_map_gray = { .count = 2, .stops = gray };
static const struct color_stop wheel[] = { { .at = 0, .color = { 0, 1, 1 } },
                                           { .at = .333, .color = { 1, 1, 0 } },
                                           { .at = .666, .color = { 1, 0, 1 } },
                                           { .at = 1, .color = { 0, 1, 1 } } };
const struct color_map color_map_round = { .count = 4, .stops = wheel };

bool color_map_listed(struct reader *reader, const struct numbers *colors, size_t count,
                      struct color_map *map)
{
    struct map_reading reading = { .room = 0 };

    for (size_t i = 0; i < count; i++)
        if (!put_stop(reader, &reading, (double)i, &colors[i]))
            return false;
    *map = reading.map;
    return true;
}

static bool read_own(struct reader *reader, struct color_map *map)
{
    struct map_reading reading = { .room = 0 };

    if (!read_entries(reader, &reading))
        return false;
    *map = reading.map;
    return true;
}

static void show_first(struct pigment *pigment)
{
    const struct color_stop *first = pigment->map.stops;

    copy3(first->color, pigment->color[0]);
    pigment->filter[0] = first->filter;
    pigment->transmit[0] = first->transmit;
    if (!pigment_has_map(pigment))
        pigment->kind = PIGMENT_COLOR;
}

bool color_map_read(struct reader *reader, struct pigment *pigment)
{
    const struct scene_value *value;
    struct block block;
    bool good = true;

    if (!block_open(reader, &block, '{'))
        return false;
    value = reader_use(reader, VALUE_COLOR_MAP);
    if (value)
        pigment->map = value->is.pigment.map;
    else
        good = read_own(reader, &pigment->map);
    if (good)
        show_first(pigment);
    return block_finish(reader, &block) && good;
}
