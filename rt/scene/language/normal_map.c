/* normal_map.c - parses the maps of a normal.
 *
 *   slope_map { [value <height, slope>] .. }
 *   normal_map { [value normal] .. }
 *
 * and the normals of a list.
 */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"

bool map_has_room(struct reader *reader, size_t count)
{
    return count < MAX_ENTRIES
           || reader_fault(reader, &reader->token, "more than %d entries in a map",
                           MAX_ENTRIES);
}

/* Reads the value of an entry, which is raised to that of the entry before it. */
static bool read_place(struct reader *reader, size_t count, double before, double *at)
{
    if (!read_number(reader, at))
        return false;
    reader_comma(reader);
    if (count > 0 && *at < before)
        *at = before;
    return true;
}

/* ---- slope_map ----------------------------------------------------------- */

static bool read_slope(struct reader *reader, struct bump *bump, size_t *room)
{
    size_t count = bump->stop_count;
    struct slope_stop stop;
    double slope[3];
    struct block entry;
    bool good;

    if (!map_has_room(reader, count) || !block_open(reader, &entry, '['))
        return false;
    good = read_place(reader, count, count > 0 ? bump->stops[count - 1].at : 0,
                      &stop.at)
           && read_vector(reader, slope) && reader_require_sign(reader, ']');
    if (!block_finish(reader, &entry) || !good)
        return false;
    stop.height = slope[0];
    stop.slope = slope[1];
    return arena_add(&reader->scene->kept, &bump->stops, &bump->stop_count, room, &stop,
                     sizeof stop)
           || reader_no_memory(reader);
}

static bool read_own_slopes(struct reader *reader, struct bump *bump)
{
    size_t room = 0;

    bump->stop_count = 0;
    do {
        if (!read_slope(reader, bump, &room))
            return false;
        reader_comma(reader);
    } while (reader_at_sign(reader, '['));
    return true;
}

bool slope_map_read(struct reader *reader, struct bump *bump)
{
    const struct scene_value *value;
    struct block block;
    bool good = true;

    if (!block_open(reader, &block, '{'))
        return false;
    value = reader_use(reader, VALUE_SLOPE_MAP);
    if (value) {
        bump->stop_count = value->is.bump.stop_count;
        bump->stops = value->is.bump.stops;
    } else {
        good = read_own_slopes(reader, bump);
    }
    return block_finish(reader, &block) && good;
}

/* As in POV-Ray a list has no maps. */
static bool has_place(struct reader *reader, const struct normal_reading *reading,
                      const struct item *item)
{
    return pigment_list_count(&reading->list.bump.pattern) == 0
           || reader_fault(reader, &item->at,
                           "a list of normals cannot be combined with '%s'",
                           item->keyword->words);
}

bool read_slope_map(struct reader *reader, const struct item *item)
{
    struct normal_reading *reading = item->subject;

    if (!has_place(reader, reading, item))
        return false;
    reading->list.count = 0;
    return slope_map_read(reader, &reading->list.bump);
}

/* ---- normal_map ---------------------------------------------------------- */

/* Stores an entry. If its normal is a list or a map, the first entry of that is
 * used. */
static void take_entry(struct reader *reader, const struct normal_reading *from,
                       const struct scene_token *at, struct bump *bump)
{
    const struct bump_list *list = &from->list;

    *bump = list->bump;
    if (from->unscaled)
        reader_report(reader, at,
                      "'no_bump_scale' inside a map is not supported and is ignored");
    if (list->count == 0)
        return;
    reader_report(reader, at,
                  "a list of normals inside a map is not supported; "
                  "its first normal is used instead");
    *bump = list->entries[0].bump;
    bump->pattern.to_local = transform_then(&list->bump.pattern.to_local,
                                            &bump->pattern.to_local);
}

static void begin_entry(const struct reader *reader, struct normal_reading *reading)
{
    normal_begin(reading, &reader->default_texture.bumps);
}

/* In an average the number is optional. */
static bool read_entry(struct reader *reader, struct bump_list *list, size_t *room)
{
    size_t count = list->count;
    double before = count > 0 && !list->average ? list->entries[count - 1].at : -1e30;
    struct bump_entry entry = { .at = 1 };
    struct normal_reading reading;
    struct block block;

    if (!map_has_room(reader, count) || !block_open(reader, &block, '['))
        return false;
    begin_entry(reader, &reading);
    if ((!list->average || starts_expression(reader))
        && !read_place(reader, count, before, &entry.at)) {
        block_finish(reader, &block);
        return false;
    }
    if (!normal_body(reader, &block, &reading))
        return false;
    take_entry(reader, &reading, &block.open, &entry.bump);
    return arena_add(&reader->scene->kept, &list->entries, &list->count, room, &entry,
                     sizeof entry)
           || reader_no_memory(reader);
}

static bool read_own_entries(struct reader *reader, struct bump_list *list)
{
    size_t room = 0;

    list->count = 0;
    do {
        if (!read_entry(reader, list, &room))
            return false;
        reader_comma(reader);
    } while (reader_at_sign(reader, '['));
    return true;
}

bool normal_map_read(struct reader *reader, struct bump_list *list)
{
    const struct scene_value *value;
    struct block block;
    bool good = true;

    if (!block_open(reader, &block, '{'))
        return false;
    value = reader_use(reader, VALUE_NORMAL_MAP);
    if (value) {
        list->count = value->is.bump_list.count;
        list->entries = value->is.bump_list.entries;
    } else {
        good = read_own_entries(reader, list);
    }
    return block_finish(reader, &block) && good;
}

bool read_normal_map(struct reader *reader, const struct item *item)
{
    struct normal_reading *reading = item->subject;

    if (!has_place(reader, reading, item))
        return false;
    reading->list.bump.stop_count = 0;
    return normal_map_read(reader, &reading->list);
}

/* ---- Lists --------------------------------------------------------------- */

bool normal_list_read(struct reader *reader, struct normal_reading *reading,
                      size_t count)
{
    struct bump_entry entries[MAX_LISTED];

    if (!is_token(&reader->token, "normal"))
        return true;
    for (size_t i = 0; i < count; i++) {
        struct normal_reading entry;
        struct scene_token at = reader->token;
        struct block block;

        if (!reader_accept(reader, "normal"))
            return reader_expected(reader, "a normal");
        begin_entry(reader, &entry);
        if (!block_open(reader, &block, '{') || !normal_body(reader, &block, &entry))
            return false;
        entries[i].at = (double)i;
        take_entry(reader, &entry, &at, &entries[i].bump);
        reader_comma(reader);
    }
    reading->list.count = count;
    reading->list.entries = reader_keep(reader, entries, count * sizeof *entries);
    return reading->list.entries;
}
