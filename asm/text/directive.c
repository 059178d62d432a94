/* directive.c - the directives that the parser executes: symbols, addresses, regions
 * and data. */
#include "asm/text/statement.h"
#include "asm/text/suggest.h"
#include "base/plural.h"

enum { WORD_BITS = 64, HALF_BITS = 32, WORD_HALVES = 2 };

static bool comma(struct cursor *cursor)
{
    return expect_operator(cursor, ',', "','");
}

/* ---- Names ---- */

static bool parse_equ(struct cursor *cursor)
{
    const char *name;
    size_t length;
    struct value value;
    return expect_name(cursor, "a name", &name, &length) && comma(cursor)
           && parse_value(cursor, &value)
           && symbol_define(cursor->assembler, cursor->line, name,
                            symbol_intern(cursor->assembler, name, length),
                            SYMBOL_CONSTANT, value);
}

/* ---- Places ---- */

static bool parse_code(struct cursor *cursor)
{
    cursor->assembler->section = &cursor->assembler->sections[0];
    return true;
}

static bool parse_data(struct cursor *cursor)
{
    cursor->assembler->section = &cursor->assembler->sections[1];
    return true;
}

static bool parse_org(struct cursor *cursor)
{
    struct assembler *assembler = cursor->assembler;
    const char *at = cursor->token.begin;
    int64_t address;
    if (!parse_integer(cursor, 0, ((int64_t)1 << ADDRESS_BITS) - 1, "a bit address",
                       &address))
        return false;
    if (address % HALF_BITS)
        return report_at(cursor, at, "expected a multiple of %d", HALF_BITS);
    if (assembler->open_region.line && assembler->region_section == assembler->section)
        return report_at(cursor, at, ".org cannot be used inside a .kernel");
    assembler->section->at = (uint64_t)address;
    assembler->section->moved = true;
    assembler->section->full = false;
    return true;
}

static bool parse_align(struct cursor *cursor)
{
    const char *at = cursor->token.begin;
    int64_t bits;
    if (!parse_integer(cursor, HALF_BITS, (int64_t)1 << ADDRESS_BITS,
                       "a number of bits", &bits))
        return false;
    if (bits % HALF_BITS)
        return report_at(cursor, at, "expected a multiple of %d", HALF_BITS);
    layout_align(cursor->assembler, (uint64_t)bits);
    return true;
}

static bool parse_entry(struct cursor *cursor)
{
    struct assembler *assembler = cursor->assembler;
    if (assembler->entry)
        return report_at(cursor, cursor->line->begin,
                         ".entry is already defined, in %s:%zu",
                         assembler->entry_line->file, assembler->entry_line->number);
    assembler->entry = parse_expression(cursor);
    assembler->entry_line = cursor->line;
    return assembler->entry != NULL;
}

static bool parse_warm(struct cursor *cursor)
{
    cursor->assembler->warm = true;
    return true;
}

/* ---- Regions of the accounts ---- */

static const char *parse_region_name(struct cursor *cursor)
{
    const char *name;
    size_t length;
    if (cursor->token.kind == TOKEN_STRING) {
        const char *at = cursor->token.begin;
        name = expect_string(cursor, &length);
        if (name && !*name)
            report_at(cursor, at, "a kernel must have a name");
        return name && *name ? name : NULL;
    }
    if (!expect_name(cursor, "the kernel's name", &name, &length))
        return NULL;
    return arena_text(cursor->assembler->arena, name, length);
}

static bool parse_kernel(struct cursor *cursor)
{
    struct assembler *assembler = cursor->assembler;
    struct asm_region *open = &assembler->open_region;
    if (open->line)
        return report_at(cursor, cursor->line->begin,
                         "expected .endkernel first, for the .kernel in %s:%zu",
                         open->line->file, open->line->number);
    open->name = parse_region_name(cursor);
    if (!open->name)
        return false;
    open->line = cursor->line;
    open->begin = assembler->section->at;
    assembler->region_section = assembler->section;
    return true;
}

static bool parse_endkernel(struct cursor *cursor)
{
    struct assembler *assembler = cursor->assembler;
    struct asm_region *open = &assembler->open_region, region = *open;
    if (!open->line)
        return report_at(cursor, cursor->line->begin, ".endkernel without a .kernel");
    open->line = NULL;
    region.end = assembler->region_section->at;
    return region.begin == region.end
           || arena_add(assembler->arena, &assembler->regions, &assembler->region_count,
                        &assembler->region_capacity, &region, sizeof region);
}

/* ---- Data ---- */

static bool add_values(struct cursor *cursor, enum item_kind kind, uint64_t halves,
                       uint64_t *count)
{
    bool good = true;
    do {
        struct cursor start = *cursor;
        const struct expression *value = parse_expression(cursor);
        struct layout_item *item = layout_add(cursor, kind, halves);
        if (!value)
            cursor_skip(cursor, &start);
        if (!item)
            return false;
        item->of.values[0] = value;
        good = good && value;
        ++*count;
    } while (cursor_take(cursor, ','));
    return good;
}

static bool parse_word(struct cursor *cursor)
{
    uint64_t count = 0;
    layout_align(cursor->assembler, WORD_BITS);
    return add_values(cursor, ITEM_VALUE, WORD_HALVES, &count);
}

static bool parse_half(struct cursor *cursor)
{
    uint64_t count = 0;
    return add_values(cursor, ITEM_HALF, 1, &count);
}

static bool parse_halfword(struct cursor *cursor)
{
    uint64_t count = 0;
    return add_values(cursor, ITEM_HALF_WORD, 1, &count);
}

static bool parse_descriptor(struct cursor *cursor)
{
    const struct expression *length, *address;
    struct layout_item *item;
    layout_align(cursor->assembler, WORD_BITS);
    if (!(length = parse_expression(cursor)) || !comma(cursor)
        || !(address = parse_expression(cursor))
        || !(item = layout_add(cursor, ITEM_DESCRIPTOR, WORD_HALVES)))
        return false;
    item->of.values[0] = length;
    item->of.values[1] = address;
    return true;
}

static bool add_space(struct cursor *cursor, uint64_t halves)
{
    return halves == 0 || layout_add(cursor, ITEM_SPACE, halves);
}

/* Adds zeros, which may begin and end within a word. The whole words become one
 * item. */
static bool add_half_space(struct cursor *cursor, uint64_t halves)
{
    uint64_t odd = cursor->assembler->section->at % WORD_BITS != 0;
    uint64_t first = odd < halves ? odd : halves;
    uint64_t last = (halves - first) % WORD_HALVES;
    return add_space(cursor, first) && add_space(cursor, halves - first - last)
           && add_space(cursor, last);
}

static bool parse_space(struct cursor *cursor)
{
    int64_t words;
    layout_align(cursor->assembler, WORD_BITS);
    return parse_integer(cursor, 0, MAX_WORDS, "a number of words", &words)
           && add_space(cursor, WORD_HALVES * (uint64_t)words);
}

/* Parses NAME, n: a label and its number of elements. */
static bool parse_head(struct cursor *cursor, uint64_t most, int64_t *count)
{
    struct symbol *symbol;
    const char *name;
    size_t length;
    if (!expect_name(cursor, "a name", &name, &length) || !comma(cursor)
        || !parse_integer(cursor, 0, (int64_t)most, "a length", count)
        || !layout_label(cursor, name, length, name))
        return false;
    symbol = symbol_intern(cursor->assembler, name, length);
    symbol->counted = true;
    symbol->contents = cursor->assembler->contents;
    symbol->count = (uint64_t)*count;
    return true;
}

/* Parses NAME, n, values. Sets *rest to the number of elements without a value. */
static bool parse_elements(struct cursor *cursor, enum item_kind kind, uint64_t halves,
                           uint64_t *rest)
{
    const char *at;
    int64_t length;
    uint64_t given = 0;
    if (!parse_head(cursor, WORD_HALVES * MAX_WORDS / halves, &length))
        return false;
    at = cursor->token.begin;
    if (cursor_take(cursor, ',') && !add_values(cursor, kind, halves, &given))
        return false;
    *rest = (uint64_t)length - given;
    return given <= (uint64_t)length
           || report_at(cursor, at, "%lu value%s, but the vector holds only %lu",
                        (unsigned long)given, plural(given), (unsigned long)length);
}

static bool parse_vector(struct cursor *cursor)
{
    uint64_t rest;
    layout_align(cursor->assembler, WORD_BITS);
    return parse_elements(cursor, ITEM_VALUE, WORD_HALVES, &rest)
           && add_space(cursor, WORD_HALVES * rest);
}

static bool parse_halfvector(struct cursor *cursor)
{
    uint64_t rest;
    return parse_elements(cursor, ITEM_HALF_WORD, 1, &rest)
           && add_half_space(cursor, rest);
}

/* Parses a string of the digits 0 and 1. Blanks are ignored. */
static bool set_bits(struct cursor *cursor, c205_word *words, uint64_t size,
                     uint64_t *count)
{
    const char *begin = cursor->token.begin, *text;
    size_t length;
    text = expect_string(cursor, &length);
    if (!text)
        return false;
    for (size_t i = 0; i < length; i++) {
        if (text[i] == ' ')
            continue;
        if (text[i] != '0' && text[i] != '1')
            return report_at(cursor, begin, "expected a string of the digits 0 and 1");
        if (*count == size)
            return report_at(cursor, begin, "more bits than the vector holds");
        words[*count / WORD_BITS] |= (c205_word)(text[i] == '1')
                                     << (WORD_BITS - 1 - *count % WORD_BITS);
        ++*count;
    }
    return true;
}

static bool parse_bitvector(struct cursor *cursor)
{
    int64_t size;
    uint64_t count = 0, length, given;
    c205_word *words;
    layout_align(cursor->assembler, WORD_BITS);
    if (!parse_head(cursor, MAX_WORDS, &size))
        return false;
    length = ((uint64_t)size + WORD_BITS - 1) / WORD_BITS;
    words = arena_take(cursor->assembler->arena, (size_t)length * sizeof *words);
    if (!words)
        return false;
    while (cursor_take(cursor, ','))
        if (!set_bits(cursor, words, (uint64_t)size, &count))
            return false;
    given = (count + WORD_BITS - 1) / WORD_BITS;
    return layout_known(cursor, words, given)
           && add_space(cursor, WORD_HALVES * (length - given));
}

/* Packs a text into words of eight bytes. The last word is filled with zeros. */
static bool parse_text(struct cursor *cursor)
{
    uint64_t count;
    size_t length;
    c205_word *words;
    const char *text;
    layout_align(cursor->assembler, WORD_BITS);
    text = expect_string(cursor, &length);
    if (!text)
        return false;
    count = ((uint64_t)length + 7) / 8;
    words = arena_take(cursor->assembler->arena, (size_t)count * sizeof *words);
    if (!words)
        return false;
    for (size_t i = 0; i < length; i++)
        words[i / 8] |= (c205_word)(unsigned char)text[i]
                        << (WORD_BITS - 8 - i % 8 * 8);
    return layout_known(cursor, words, count);
}

static bool parse_error(struct cursor *cursor)
{
    size_t length;
    const char *text = expect_string(cursor, &length);
    return text && report_at(cursor, cursor->line->begin, "%s", text);
}

static const struct directive directives[] = {
    { ".equ", parse_equ, ASM_NOTHING },
    { ".reg", parse_reg, ASM_NOTHING },
    { ".regs", parse_regs, ASM_NOTHING },
    { ".share", parse_share, ASM_NOTHING },
    { ".endshare", parse_endshare, ASM_NOTHING },
    { ".code", parse_code, ASM_NOTHING },
    { ".data", parse_data, ASM_NOTHING },
    { ".org", parse_org, ASM_NOTHING },
    { ".align", parse_align, ASM_WORDS },
    { ".entry", parse_entry, ASM_NOTHING },
    { ".warm", parse_warm, ASM_NOTHING },
    { ".record", parse_record, ASM_NOTHING },
    { ".field", parse_field, ASM_NOTHING },
    { ".at", parse_at, ASM_NOTHING },
    { ".endrecord", parse_endrecord, ASM_NOTHING },
    { ".kernel", parse_kernel, ASM_NOTHING },
    { ".endkernel", parse_endkernel, ASM_NOTHING },
    { ".word", parse_word, ASM_WORDS },
    { ".half", parse_half, ASM_HALF_WORDS },
    { ".halfword", parse_halfword, ASM_HALF_WORDS },
    { ".descriptor", parse_descriptor, ASM_WORDS },
    { ".space", parse_space, ASM_WORDS },
    { ".vector", parse_vector, ASM_WORDS },
    { ".halfvector", parse_halfvector, ASM_HALF_WORDS },
    { ".bitvector", parse_bitvector, ASM_BITS },
    { ".text", parse_text, ASM_BYTES },
    { ".incfile", parse_incfile, ASM_WORDS },
    { ".error", parse_error, ASM_NOTHING }
};

const char *directive_name(size_t i)
{
    return i < sizeof directives / sizeof *directives ? directives[i].name : NULL;
}

const struct directive *find_directive(const struct token *token)
{
    for (size_t i = 0; i < sizeof directives / sizeof *directives; i++)
        if (token_is(token, directives[i].name))
            return &directives[i];
    return NULL;
}
