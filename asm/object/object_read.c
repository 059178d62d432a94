/* object_read.c - parses object files. Any input gives an object or an error. */
#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/object/address_space.h"
#include "asm/object/expectation.h"
#include "asm/object/object_file.h"
#include "asm/object/storage.h"
#include "vm/error.h"

struct object_reader {
    struct storage *storage;
    const char *at, *end;         /* the unread part */
    const char *field, *line_end; /* the next field and the end of the current line */
    size_t line;
    uint64_t words;
    const char *problem;
    char limit[60];
};

static bool wrong(struct object_reader *reader, const char *problem)
{
    if (!reader->problem)
        reader->problem = problem;
    return false;
}

static bool wrong_limit(struct object_reader *reader, const char *what, uint64_t most)
{
    snprintf(reader->limit, sizeof reader->limit, "%s: at most %" PRIu64, what, most);
    return wrong(reader, reader->limit);
}

static bool next_line(struct object_reader *reader)
{
    const char *newline;
    if (reader->at >= reader->end)
        return wrong(reader, "the end line is missing");
    newline = memchr(reader->at, '\n', (size_t)(reader->end - reader->at));
    if (!newline)
        return wrong(reader, "the last line is incomplete");
    reader->field = reader->at;
    reader->line_end = newline;
    reader->at = newline + 1;
    reader->line++;
    return true;
}

/* ---- Fields of a line, a blank between them ---- */

static bool end_field(struct object_reader *reader, const char *end)
{
    if (end < reader->line_end && *end != ' ')
        return wrong(reader, "expected a blank or the end of the line");
    reader->field = end + (end < reader->line_end);
    return true;
}

static bool take_hex(struct object_reader *reader, uint64_t *number)
{
    static const char digits[] = "0123456789ABCDEF";
    const char *at = reader->field, *found;
    *number = 0;
    while (at < reader->line_end && *at && (found = strchr(digits, *at)) != NULL) {
        *number = *number << 4 | (uint64_t)(found - digits);
        at++;
    }
    if (at == reader->field || at - reader->field > 16)
        return wrong(reader, "expected 1 to 16 hex digits");
    return end_field(reader, at);
}

static bool take_count(struct object_reader *reader, uint64_t most, size_t *count)
{
    const char *at = reader->field;
    uint64_t number = 0;
    while (at < reader->line_end && isdigit((unsigned char)*at)) {
        number = 10 * number + (uint64_t)(*at++ - '0');
        if (number > most)
            return wrong_limit(reader, "the number is too large", most);
    }
    if (at == reader->field)
        return wrong(reader, "expected a number");
    *count = (size_t)number;
    return end_field(reader, at);
}

static bool take_address(struct object_reader *reader, uint64_t *address)
{
    return take_hex(reader, address)
           && (*address >> ADDRESS_BITS == 0
               || wrong(reader, "an address must fit in 48 bits"));
}

static const char *take_rest(struct object_reader *reader)
{
    const char *field = reader->field;
    reader->field = reader->line_end;
    return arena_text(&reader->storage->arena, field,
                      (size_t)(reader->line_end - field));
}

static bool take_keyword(struct object_reader *reader, const char *keyword)
{
    size_t length = strlen(keyword);
    const char *end = reader->field + length;
    if ((size_t)(reader->line_end - reader->field) < length
        || memcmp(reader->field, keyword, length) != 0
        || (end < reader->line_end && *end != ' '))
        return false;
    return end_field(reader, end);
}

/* Reads lines of one word each. The length of the file is checked before memory is
 * allocated, so an invalid count cannot exhaust memory. */
static const c205_word *take_words(struct object_reader *reader, size_t count)
{
    enum { LINE = 17 };
    c205_word *words;
    if (count > (size_t)(reader->end - reader->at) / LINE) {
        wrong(reader, "the file ends before its last word");
        return NULL;
    }
    words = arena_take(&reader->storage->arena, count * sizeof *words);
    for (size_t i = 0; words && i < count; i++)
        if (!next_line(reader) || !take_hex(reader, &words[i]))
            return NULL;
    return words;
}

/* ---- Kinds of lines ---- */

static bool read_entry(struct object_reader *reader)
{
    return take_address(reader, &reader->storage->object.program.entry);
}

static bool read_warm(struct object_reader *reader)
{
    reader->storage->object.program.warm = true;
    return true;
}

static bool read_extent(struct object_reader *reader, c205_segment *segment)
{
    if (!segment || !take_address(reader, &segment->address)
        || !take_count(reader, MAX_WORDS, &segment->length))
        return false;
    reader->words += segment->length;
    if (segment->address % 64)
        return wrong(reader, "a segment must begin on a word");
    if (reader->words > MAX_WORDS)
        return wrong_limit(reader, "too many words", MAX_WORDS);
    if (segment->address + 64 * (uint64_t)segment->length > (uint64_t)1 << ADDRESS_BITS)
        return wrong(reader, "this segment ends beyond the last address");
    return true;
}

static bool read_segment(struct object_reader *reader)
{
    c205_segment *segment = storage_add_segment(reader->storage);
    if (!read_extent(reader, segment))
        return false;
    segment->words = take_words(reader, segment->length);
    return segment->words != NULL;
}

static bool read_zeros(struct object_reader *reader)
{
    return read_extent(reader, storage_add_segment(reader->storage));
}

static bool read_region(struct object_reader *reader)
{
    c205_region *region = storage_add_region(reader->storage);
    if (!region || !take_address(reader, &region->begin)
        || !take_address(reader, &region->end))
        return false;
    region->name = take_rest(reader);
    if (region->begin >= region->end)
        return wrong(reader, "a region must end after it begins");
    return region->name != NULL;
}

static bool read_symbol(struct object_reader *reader, bool is_label, bool is_word)
{
    struct asm_symbol *symbol = storage_add_symbol(reader->storage);
    uint64_t value;
    if (!symbol || !take_hex(reader, &value))
        return false;
    symbol->value = (int64_t)value;
    symbol->is_label = is_label;
    symbol->is_word = is_word;
    symbol->name = take_rest(reader);
    return symbol->name != NULL;
}

static bool read_label(struct object_reader *reader)
{
    return read_symbol(reader, true, false);
}

static bool read_integer(struct object_reader *reader)
{
    return read_symbol(reader, false, false);
}

static bool read_expected_word(struct object_reader *reader)
{
    return read_symbol(reader, false, true);
}

static bool take_kind(struct object_reader *reader, enum expectation_kind *kind)
{
    for (unsigned i = 0; i < EXPECT_KINDS; i++) {
        *kind = (enum expectation_kind)i;
        if (take_keyword(reader, expectation_name(*kind)))
            return true;
    }
    return wrong(reader, "expected the name of an expectation");
}

static bool read_expected_text(struct object_reader *reader, const char **text)
{
    if (!next_line(reader))
        return false;
    if (!take_keyword(reader, "text"))
        return wrong(reader, "expected a text");
    *text = take_rest(reader);
    return *text != NULL;
}

/* Reads a tolerance if the next line has one. */
static bool read_tolerance(struct object_reader *reader, struct asm_expectation *made)
{
    static const char keyword[] = "within ";
    size_t length = sizeof keyword - 1;
    if ((size_t)(reader->end - reader->at) < length
        || memcmp(reader->at, keyword, length) != 0)
        return true;
    made->has_tolerance = true;
    return next_line(reader) && take_keyword(reader, "within")
           && take_hex(reader, &made->tolerance);
}

/* Returns the number of words that follow the line of an expectation in an object
 * file. */
static size_t words_of(const struct asm_expectation *expectation)
{
    if (expectation->kind == EXPECT_BITS)
        return (expectation->count + 63) / 64;
    return expectation->count;
}

static bool check_count(struct object_reader *reader,
                        const struct asm_expectation *expectation)
{
    static const size_t counts[EXPECT_KINDS] = { [EXPECT_REGISTER] = 1,
                                                 [EXPECT_HALF_REGISTER] = 1,
                                                 [EXPECT_FLAGS] = 1,
                                                 [EXPECT_CLOCKS] = 1 };
    return expectation->kind == EXPECT_WORDS || expectation->kind == EXPECT_HALVES
           || expectation->kind == EXPECT_BITS
           || expectation->count == counts[expectation->kind]
           || wrong(reader, "wrong number of words in an expectation");
}

static bool has_text(enum expectation_kind kind)
{
    return kind >= EXPECT_TRAP;
}

static bool read_expectation(struct object_reader *reader)
{
    struct asm_expectation *made = storage_add_expectation(reader->storage);
    size_t number;
    if (!made || !take_kind(reader, &made->kind)
        || !take_count(reader, C205_REGISTERS - 1, &number)
        || !take_address(reader, &made->address)
        || !take_count(reader, 64 * MAX_WORDS, &made->count)
        || !take_count(reader, INT32_MAX, &made->line) || !check_count(reader, made))
        return false;
    made->number = (unsigned)number;
    made->file = take_rest(reader);
    made->words = take_words(reader, words_of(made));
    if (!made->file || !made->words || !read_tolerance(reader, made))
        return false;
    return !has_text(made->kind) || read_expected_text(reader, &made->text);
}

/* ---- The file ---- */

static bool read_line(struct object_reader *reader)
{
    static const struct {
        const char *keyword;
        bool (*read)(struct object_reader *);
    } kinds[] = { { "entry", read_entry },       { "warm", read_warm },
                  { "segment", read_segment },   { "zeros", read_zeros },
                  { "region", read_region },     { "label", read_label },
                  { "integer", read_integer },   { "word", read_expected_word },
                  { "expect", read_expectation } };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (take_keyword(reader, kinds[i].keyword))
            return kinds[i].read(reader);
    return wrong(reader, "unknown keyword");
}

static bool read_all(struct object_reader *reader)
{
    if (!next_line(reader) || !take_keyword(reader, "c205-object"))
        return wrong(reader, "not an object file");
    if (!take_keyword(reader, "1"))
        return wrong(reader, "unknown version of the object file format");
    while (next_line(reader)) {
        if (take_keyword(reader, "end"))
            return reader->at == reader->end
                   || wrong(reader, "expected the end of the file after the end line");
        if (!read_line(reader))
            return false;
    }
    return false;
}

struct object *object_read(const char *text, size_t length, c205_error *error)
{
    struct object_reader reader = { .line = 0 };
    reader.storage = storage_new();
    reader.at = text;
    reader.end = text + length;
    if (reader.storage && read_all(&reader)) {
        storage_sort_symbols(reader.storage);
        return &reader.storage->object;
    }
    error_set(error, "line %zu: %s", reader.line,
              reader.problem ? reader.problem : "the host is out of memory");
    if (reader.storage)
        object_free(&reader.storage->object);
    return NULL;
}
