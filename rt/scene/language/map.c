/* map.c - reads maps: all entries, only the first entry, or the name of a map. */
#include "rt/scene/language/pattern.h"
#include "rt/scene/language/scene_expression.h"

#include <string.h>

bool map_has_room(struct reader *reader, size_t count)
{
    return count < MAX_ENTRIES
           || reader_fault(reader, &reader->token, "more than %d entries in a map",
                           MAX_ENTRIES);
}

bool map_read(struct reader *reader, const struct map_kind *kind, void *map)
{
    const struct scene_value *named;
    struct block block;
    size_t room = 0;
    bool good = true;
    if (!block_open(reader, &block, '{'))
        return false;
    named = reader_use(reader, kind->kind);
    if (named) {
        kind->take(map, named);
        return block_finish(reader, &block);
    }
    do {
        good = kind->entry(reader, map, &room);
        if (good)
            reader_comma(reader);
    } while (good && reader_at_sign(reader, '['));
    return block_finish(reader, &block) && good;
}

/* Reads the first entry of a map. In the oldest form of maps, an entry has two numbers.
 * An entry of an average may have no number. */
static bool read_entry(struct reader *reader, body_reader *body, void *subject)
{
    struct block entry;
    bool good = true, more;
    double at;
    if (!block_open(reader, &entry, '['))
        return false;
    for (more = starts_expression(reader) && !starts_color(reader); good && more;
         more = reader->token.kind == TOKEN_NUMBER) {
        good = read_number(reader, &at);
        reader_comma(reader);
    }
    if (good)
        return body(reader, &entry, subject);
    block_finish(reader, &entry);
    return false;
}

bool map_first(struct reader *reader, enum scene_value_kind kind, body_reader *body,
               void *subject, size_t size)
{
    const struct scene_value *value;
    struct block map;
    bool good;
    if (!block_open(reader, &map, '{'))
        return false;
    value = reader_use(reader, kind);
    if (value)
        memcpy(subject, &value->is, size);
    good = value || read_entry(reader, body, subject);
    return block_finish(reader, &map) && good;
}
