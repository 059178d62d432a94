/* record.c - records: constants for the positions of their fields.
 *
 * A record occupies no memory. Each field is a constant with its position in words.
 * NAME_SIZE is the size of the record.
 */
#include <string.h>

#include "asm/text/statement.h"

static bool is_in_record(struct cursor *cursor)
{
    return cursor->assembler->record.line
           || report_at(cursor, cursor->line->begin,
                        "expected .record before this line");
}

static bool define_place(struct cursor *cursor, const char *at, const char *name,
                         size_t length, int64_t place)
{
    struct value value = { VALUE_INTEGER, (uint64_t)place };
    return symbol_define(cursor->assembler, cursor->line, at,
                         symbol_intern(cursor->assembler, name, length),
                         SYMBOL_CONSTANT, value);
}

static void go_to(struct open_record *record, int64_t place)
{
    record->next = place;
    if (place > record->size)
        record->size = place;
}

bool parse_record(struct cursor *cursor)
{
    struct assembler *assembler = cursor->assembler;
    struct open_record *open = &assembler->record;
    const char *name;
    size_t length;
    if (open->line)
        return report_at(cursor, cursor->line->begin,
                         "expected .endrecord first, for the .record in %s:%zu",
                         open->line->file, open->line->number);
    memset(open, 0, sizeof *open);
    if (!expect_name(cursor, "the record's name", &name, &length))
        return false;
    open->name = arena_text(assembler->arena, name, length);
    open->line = cursor->line;
    return open->name != NULL;
}

/* Parses NAME [, count]. */
bool parse_field(struct cursor *cursor)
{
    struct open_record *open = &cursor->assembler->record;
    const char *name;
    size_t length;
    int64_t count = 1;
    if (!is_in_record(cursor)
        || !expect_name(cursor, "the field's name", &name, &length)
        || (cursor_take(cursor, ',')
            && !parse_integer(cursor, 0, (int64_t)MAX_WORDS - open->next,
                              "a number of words", &count))
        || !define_place(cursor, name, name, length, open->next))
        return false;
    go_to(open, open->next + count);
    return true;
}

/* Parses .at, which sets the position of the next field. Fields that share words need a
 * smaller position. */
bool parse_at(struct cursor *cursor)
{
    int64_t place;
    if (!is_in_record(cursor)
        || !parse_integer(cursor, 0, MAX_WORDS, "a position in the record", &place))
        return false;
    go_to(&cursor->assembler->record, place);
    return true;
}

bool parse_endrecord(struct cursor *cursor)
{
    static const char suffix[] = "_SIZE";
    struct open_record *open = &cursor->assembler->record;
    size_t length;
    char *name;
    if (!is_in_record(cursor))
        return false;
    open->line = NULL;
    length = strlen(open->name);
    name = arena_take(cursor->assembler->arena, length + sizeof suffix);
    if (!name)
        return false;
    memcpy(name, open->name, length);
    memcpy(name + length, suffix, sizeof suffix);
    return define_place(cursor, cursor->line->begin, name, strlen(name), open->size);
}
