/* color_map.c - parses color_map { [value colour] .. }, the colours of a pattern. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"
#include "rt/scene/vector3.h"

#define MAX_COLOR 1e100 /* so that differences are finite */

static bool put_stop(struct reader *reader, struct color_map *map, size_t *room,
                     double at, const struct numbers *color)
{
    struct color_stop stop = { at, { 0 }, color->n[3], color->n[4] };
    copy3(color->n, stop.color);
    map->clear += stop.filter != 0 || stop.transmit != 0;
    return arena_add(&reader->scene->kept, &map->stops, &map->count, room, &stop,
                     sizeof stop)
           || reader_no_memory(reader);
}

static bool add_stop(struct reader *reader, struct color_map *map, size_t *room,
                     double at, const struct numbers *color)
{
    if (!map_has_room(reader, map->count))
        return false;
    if (greatest3(color->n) > MAX_COLOR)
        return reader_fault(reader, &reader->token,
                            "a colour of a map is out of range");
    if (map->count > 0 && at < map->stops[map->count - 1].at)
        at = map->stops[map->count - 1].at;
    return put_stop(reader, map, room, at, color);
}

/* Reads the stops of a color_map entry: one, or in the oldest form two, with two values
 * and two colours. */
static bool read_stops(struct reader *reader, struct color_map *map, size_t *room)
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
        if (!read_color(reader, &color) || !add_stop(reader, map, room, at[i], &color))
            return false;
        reader_comma(reader);
    }
    return count > 0 || reader_expected(reader, "a number");
}

static bool read_entry(struct reader *reader, void *map, size_t *room)
{
    struct block entry;
    return block_open(reader, &entry, '[') && read_stops(reader, map, room)
           && reader_require_sign(reader, ']') && block_finish(reader, &entry);
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
    struct color_map made = { .count = 0 };
    size_t room = 0;
    for (size_t i = 0; i < count; i++)
        if (!put_stop(reader, &made, &room, (double)i, &colors[i]))
            return false;
    *map = made;
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

static void take_colors(void *map, const struct scene_value *named)
{
    *(struct color_map *)map = named->is.pigment.map;
}

bool color_map_read(struct reader *reader, struct pigment *pigment)
{
    static const struct map_kind colors = { VALUE_COLOR_MAP, take_colors, read_entry };
    struct color_map map = { .count = 0 };
    if (!map_read(reader, &colors, &map))
        return false;
    pigment->map = map;
    show_first(pigment);
    return true;
}
