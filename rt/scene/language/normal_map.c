/* normal_map.c - parses the maps of a normal, and the normals of a list.
 *
 *   slope_map { [value <height, slope>] .. }
 *   normal_map { [value normal] .. }
 */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"

/* Reads the value of a map entry. If it is below the value of the previous entry, it is
 * raised to that value. */
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

static bool read_slope(struct reader *reader, void *map, size_t *room)
{
    struct bump *bump = map;
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

static void take_slopes(void *map, const struct scene_value *named)
{
    struct bump *bump = map;
    bump->stop_count = named->is.bump.stop_count;
    bump->stops = named->is.bump.stops;
}

bool slope_map_read(struct reader *reader, struct bump *bump)
{
    static const struct map_kind slopes = { VALUE_SLOPE_MAP, take_slopes, read_slope };
    bump->stop_count = 0;
    return map_read(reader, &slopes, bump);
}

/* Rejects a map in a normal that has a list of normals, as POV-Ray does. */
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

/* Stores the normal of a map entry as one bump. If the normal is a list or a map, only
 * the first entry of this list or map is used. */
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

/* Reads an entry of a normal_map. In an average, the number before the normal is
 * optional. */
static bool read_entry(struct reader *reader, void *map, size_t *room)
{
    struct bump_list *list = map;
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

static void take_normals(void *map, const struct scene_value *named)
{
    struct bump_list *list = map;
    list->count = named->is.bump_list.count;
    list->entries = named->is.bump_list.entries;
}

bool normal_map_read(struct reader *reader, struct bump_list *list)
{
    static const struct map_kind normals = { VALUE_NORMAL_MAP, take_normals,
                                             read_entry };
    list->count = 0;
    return map_read(reader, &normals, list);
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
