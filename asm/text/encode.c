/* encode.c - turns items into words, and builds the object from them. */
#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "asm/object/storage.h"
#include "asm/object/syntax.h"
#include "asm/text/data_map.h"
#include "asm/text/expression.h"

enum {
    WORD_BITS = 64,
    HALF_BITS = 32,
    ZERO_RUN = 64 /* minimum words of .space that make a segment of their own */
};

/* ---- Instructions ---- */

/* A relative branch counts in half words from its own address. */
static bool encode_target(struct assembler *assembler, const struct layout_item *item,
                          const struct instruction *instruction, c205_fields *fields)
{
    uint64_t target;

    if (!evaluate_address(assembler, item->line, instruction->value, &target))
        return false;
    fields->immediate = ((int64_t)target - (int64_t)item->address) / HALF_BITS;
    if (target % HALF_BITS)
        return report(assembler, item->line, item->line->begin,
                      "expected a branch target on a half word, found"
                      " address %" PRIX64,
                      target);
    if (fields->immediate < INT16_MIN || fields->immediate > INT16_MAX)
        return report(
            assembler, item->line, item->line->begin,
            "the branch target is %" PRId64
            " half words away, too far for 16 bits; give its address in registers [y, "
            "b]",
            fields->immediate);
    return true;
}

static bool encode_immediate(struct assembler *assembler,
                             const struct layout_item *item,
                             const struct instruction *instruction, c205_fields *fields)
{
    struct operand operands[MAX_OPERANDS];
    size_t i, count = syntax_operands(instruction->insn, false, operands);

    for (i = 0; i < count; i++)
        if (operands[i].kind == OPERAND_IMMEDIATE)
            return evaluate_range(assembler, item->line, instruction->value,
                                  operands[i].low, operands[i].high,
                                  instruction->insn == c205_insn_named("ELEN", 4)
                                      ? "a length, of at most 65535 elements,"
                                      : "an integer",
                                  &fields->immediate);
    return true;
}

static c205_word encode_instruction(struct assembler *assembler,
                                    const struct layout_item *item)
{
    const struct instruction *instruction = item->of.instruction;
    c205_fields fields = instruction->fields;

    if (instruction->value && instruction->relative)
        encode_target(assembler, item, instruction, &fields);
    else if (instruction->value)
        encode_immediate(assembler, item, instruction, &fields);
    return c205_encode(instruction->insn, &fields);
}

/* ---- Data ---- */

static c205_word encode_descriptor(struct assembler *assembler,
                                   const struct layout_item *item)
{
    int64_t length = 0;
    uint64_t address = 0;

    if (evaluate_range(assembler, item->line, item->of.values[0], 0, C205_MAX_LENGTH,
                       "a length, of at most 65535 elements,", &length))
        evaluate_address(assembler, item->line, item->of.values[1], &address);
    return (c205_word)length << ADDRESS_BITS | address;
}

/* Accepts integers of 32 bits, signed or unsigned. */
static c205_word encode_half(struct assembler *assembler,
                             const struct layout_item *item)
{
    int64_t integer = 0;

    evaluate_range(assembler, item->line, item->of.values[0], INT32_MIN, UINT32_MAX,
                   "an integer of 32 bits", &integer);
    return (c205_word)integer << HALF_BITS;
}

/* Returns the word of an item; an item of one half is in the high half. */
static c205_word encode_one(struct assembler *assembler, const struct layout_item *item)
{
    c205_word word = 0;

    if (item->kind != ITEM_INSTRUCTION && !item->of.values[0])
        return 0; /* the error has been reported */
    switch (item->kind) {
    case ITEM_INSTRUCTION: return encode_instruction(assembler, item);
    case ITEM_DESCRIPTOR: return encode_descriptor(assembler, item);
    case ITEM_HALF: return encode_half(assembler, item);
    case ITEM_HALF_WORD:
        evaluate_half(assembler, item->line, item->of.values[0], &word);
        return word;
    default:
        evaluate_word(assembler, item->line, item->of.values[0], &word);
        return word;
    }
}

static void put_half(c205_word *words, uint64_t bits, c205_word half)
{
    words[bits / WORD_BITS] |= bits % WORD_BITS ? half : half << HALF_BITS;
}

static void encode_item(struct assembler *assembler, const struct layout_item *item,
                        c205_word *words, uint64_t origin)
{
    uint64_t bits = item->address - origin;
    c205_word word;

    if (item->kind == ITEM_SPACE)
        return;
    if (item->kind == ITEM_WORDS) {
        memcpy(words + bits / WORD_BITS, item->of.words,
               (size_t)(item->halves / 2) * sizeof *words);
        return;
    }
    word = encode_one(assembler, item);
    put_half(words, bits, word >> HALF_BITS);
    if (item->halves == 2)
        put_half(words, bits + HALF_BITS, word & UINT32_MAX);
}

/* ---- Segments ---- */

static uint64_t end_of(const struct layout_item *item)
{
    return item->address + item->halves * HALF_BITS;
}

static int compare_items(const void *a, const void *b)
{
    const struct layout_item *first = a, *second = b;

    if (first->address != second->address)
        return first->address < second->address ? -1 : 1;
    return (first->order > second->order) - (first->order < second->order);
}

/* Reports items that overlap, in one pass over the items sorted by address. `last`
 * is the item with the greatest end so far. Consecutive items of the text that
 * overlap are reported once, at the first of them. */
static bool check_overlap(struct assembler *assembler)
{
    const struct layout_item *items = assembler->items;
    size_t i, last = 0, before = assembler->diagnostics->errors;
    const struct layout_item *run = NULL; /* the last overlap, which is
                                           * reported at its first item */

    for (i = 1; i < assembler->item_count; i++) {
        if (items[i].address < end_of(&items[last])) {
            if (!run || items[i].order != run->order + 1
                || items[i].address != end_of(run))
                report(assembler, items[i].line, items[i].line->begin,
                       "address %" PRIX64 " is already used, by %s:%zu",
                       items[i].address, items[last].line->file,
                       items[last].line->number);
            run = &items[i];
        }
        if (end_of(&items[i]) > end_of(&items[last]))
            last = i;
    }
    return assembler->diagnostics->errors == before;
}

static bool is_zero_run(const struct layout_item *item)
{
    return item->kind == ITEM_SPACE && item->halves >= 2 * (uint64_t)ZERO_RUN;
}

/* Returns the number of items from this one on that form one segment: those without a
 * free word between them. */
static size_t count_together(const struct layout_item *item, size_t count)
{
    uint64_t end = end_of(item);
    size_t i;

    if (is_zero_run(item))
        return 1;
    for (i = 1; i < count && !is_zero_run(&item[i]); i++) {
        uint64_t boundary = (end + WORD_BITS - 1) / WORD_BITS * WORD_BITS;

        if (item[i].address > boundary)
            break;
        end = end_of(&item[i]);
    }
    return i;
}

static bool add_segment(struct assembler *assembler, struct storage *storage,
                        const struct layout_item *items, size_t count)
{
    uint64_t begin = items->address / WORD_BITS * WORD_BITS;
    uint64_t end = end_of(&items[count - 1]);
    c205_segment *segment = storage_add_segment(storage);
    c205_word *words = NULL;
    size_t i;

    if (!segment)
        return false;
    segment->address = begin;
    segment->length = (size_t)((end - begin + WORD_BITS - 1) / WORD_BITS);
    if (!is_zero_run(items)) {
        words = arena_take(&storage->arena, segment->length * sizeof *words);
        if (!words)
            return false;
    }
    for (i = 0; i < count; i++)
        encode_item(assembler, &items[i], words, begin);
    segment->words = words;
    return true;
}

static bool add_segments(struct assembler *assembler, struct storage *storage)
{
    size_t i, count;

    for (i = 0; i < assembler->item_count; i += count) {
        count = count_together(&assembler->items[i], assembler->item_count - i);
        if (!add_segment(assembler, storage, &assembler->items[i], count))
            return false;
    }
    return true;
}

/* ---- The rest of the object ---- */

static char *keep(struct storage *storage, const char *text)
{
    return arena_text(&storage->arena, text, strlen(text));
}

static bool add_regions(struct assembler *assembler, struct storage *storage)
{
    size_t i;

    for (i = 0; i < assembler->region_count; i++) {
        c205_region *region = storage_add_region(storage);

        if (!region)
            return false;
        region->name = keep(storage, assembler->regions[i].name);
        region->begin = assembler->regions[i].begin;
        region->end = assembler->regions[i].end;
    }
    return true;
}

static bool add_symbol(struct storage *storage, const struct symbol *symbol)
{
    struct asm_symbol *kept;

    if (symbol->kind != SYMBOL_LABEL && symbol->kind != SYMBOL_CONSTANT)
        return true;
    kept = storage_add_symbol(storage);
    if (!kept)
        return false;
    kept->name = keep(storage, symbol->name);
    kept->value = (int64_t)symbol->value.bits;
    kept->is_label = symbol->kind == SYMBOL_LABEL;
    kept->is_word = symbol->value.kind != VALUE_INTEGER;
    kept->is_used = symbol->used;
    kept->contents = symbol->counted ? symbol->contents : ASM_NOTHING;
    kept->counted = symbol->kind == SYMBOL_LABEL && symbol->counted;
    kept->count = kept->counted ? symbol->count : 0;
    return kept->name != NULL;
}

static bool add_symbols(struct assembler *assembler, struct storage *storage)
{
    const struct symbol *symbol;
    struct asm_symbol *symbols;
    size_t i;

    for (i = 0; i < SYMBOL_BUCKETS; i++)
        for (symbol = assembler->symbols.buckets[i]; symbol; symbol = symbol->next)
            if (!add_symbol(storage, symbol))
                return false;
    storage_sort_symbols(storage);
    symbols = (struct asm_symbol *)(uintptr_t)storage->object.symbols;
    if (!data_map_fill(assembler, symbols, storage->object.symbol_count))
        storage->arena.failed = true;
    return !storage->arena.failed;
}

/* A line in a .rept belongs to its own position, not to that of the .rept. */
static bool is_repetition(const struct line *line)
{
    const char *at = line->begin;

    while (at < line->end && isspace((unsigned char)*at))
        at++;
    return at < line->end && *at == '.';
}

/* Returns the outermost macro call, or the line itself. */
static const struct line *call_of(const struct line *line)
{
    const struct line *call = line, *caller;

    for (caller = line->caller; caller; caller = caller->caller)
        if (!is_repetition(caller))
            call = caller;
    return call;
}

static const char *keep_source(struct storage *storage, const struct line *line)
{
    return arena_text(&storage->arena, line->text,
                      (size_t)(line->text_end - line->text));
}

static bool add_line(struct storage *storage, const struct layout_item *item)
{
    struct asm_line *line = storage_add_line(storage);
    const struct line *from = item->line, *call = call_of(from);

    if (!line)
        return false;
    line->address = item->address;
    line->halves = item->halves;
    line->number = from->number;
    line->is_code = item->kind == ITEM_INSTRUCTION;
    line->file = keep(storage, from->file);
    line->source = line->call_source = keep_source(storage, from);
    line->call_file = keep(storage, call->file);
    line->call_number = call->number;
    if (call != from)
        line->call_source = keep_source(storage, call);
    return line->source && line->call_source;
}

/* Adjacent items of one line become one entry. */
static bool add_lines(struct assembler *assembler, struct storage *storage)
{
    const struct layout_item *items = assembler->items;
    size_t i, next;

    for (i = 0; i < assembler->item_count; i = next) {
        struct layout_item whole = items[i];

        for (next = i + 1;
             next < assembler->item_count && items[next].line == whole.line
             && items[next].address == end_of(&whole);
             next++)
            whole.halves += items[next].halves;
        if (!add_line(storage, &whole))
            return false;
    }
    return true;
}

static bool add_registers(struct assembler *assembler, struct storage *storage)
{
    size_t i;

    for (i = 0; i < assembler->registers.count; i++) {
        const struct naming *naming = &assembler->registers.namings[i];
        struct asm_register *kept = storage_add_register(storage);

        if (!kept)
            return false;
        kept->name = keep(storage, naming->symbol->name);
        kept->half = naming->named.half;
        kept->number = naming->named.number;
        kept->file = keep(storage, naming->line->file);
        kept->line = naming->line->number;
        kept->owner = naming->owner;
    }
    return true;
}

static bool add_mentions(struct assembler *assembler, struct storage *storage)
{
    const struct layout_item *item = assembler->items;
    size_t i, j;

    for (i = 0; i < assembler->item_count; i++, item++) {
        if (item->kind != ITEM_INSTRUCTION)
            continue;
        for (j = 0; j < item->of.instruction->mentions; j++) {
            struct asm_mention *kept = storage_add_mention(storage);

            if (!kept)
                return false;
            kept->address = item->address;
            kept->name = assembler->registers
                             .mentions[item->of.instruction->mention + j];
        }
    }
    return true;
}

static void grant_tolerance(struct assembler *assembler,
                            const struct expectation *expectation,
                            struct asm_expectation *made)
{
    if (expectation->tolerance
        && evaluate_word(assembler, expectation->line, expectation->tolerance,
                         &made->tolerance)
        && !(c205_to_double(made->tolerance) >= 0))
        report(assembler, expectation->line, expectation->line->begin,
               "a tolerance must be a number and must not be negative");
}

typedef bool evaluator(struct assembler *, const struct line *,
                       const struct expression *, c205_word *);

static bool grant(struct assembler *assembler, struct storage *storage,
                  const struct expectation *expectation)
{
    struct asm_expectation *made = storage_add_expectation(storage);
    size_t i, size = expectation->bits ? expectation->count / WORD_BITS + 1
                                       : expectation->count;
    bool half = expectation->kind == EXPECT_HALF_REGISTER
                || expectation->kind == EXPECT_HALVES;
    evaluator *value = half ? evaluate_half : evaluate_word;
    c205_word *words = arena_take(&storage->arena, size * sizeof *words);

    if (!made || !words)
        return false;
    made->kind = expectation->kind;
    made->number = expectation->number;
    made->count = expectation->count;
    made->words = words;
    made->text = expectation->text ? keep(storage, expectation->text) : NULL;
    made->file = keep(storage, expectation->line->file);
    made->line = expectation->line->number;
    made->has_tolerance = expectation->tolerance != NULL;
    grant_tolerance(assembler, expectation, made);
    if (expectation->address)
        evaluate_address(assembler, expectation->line, expectation->address,
                         &made->address);
    for (i = 0; i < size; i++) {
        if (expectation->bits)
            words[i] = expectation->bits[i];
        else
            value(assembler, expectation->line, expectation->values[i], &words[i]);
    }
    return true;
}

static bool add_expectations(struct assembler *assembler, struct storage *storage)
{
    size_t i;

    for (i = 0; i < assembler->expectation_count; i++)
        if (!grant(assembler, storage, &assembler->expectations[i]))
            return false;
    return true;
}

static void set_entry(struct assembler *assembler, struct storage *storage)
{
    uint64_t entry = CODE_ORIGIN;
    size_t i, first = assembler->item_count;

    if (assembler->entry) {
        evaluate_address(assembler, assembler->entry_line, assembler->entry, &entry);
        storage->object.program.entry = entry;
        return;
    }
    for (i = 0; i < assembler->item_count; i++) /* the first in the order of the text */
        if (assembler->items[i].kind == ITEM_INSTRUCTION
            && (first == assembler->item_count
                || assembler->items[i].order < assembler->items[first].order))
            first = i;
    if (first < assembler->item_count)
        entry = assembler->items[first].address;
    storage->object.program.entry = entry;
}

/* Continues after errors of values, so that all of them are reported. */
static bool fill(struct assembler *assembler, struct storage *storage)
{
    return check_overlap(assembler) && add_segments(assembler, storage)
           && add_regions(assembler, storage) && add_symbols(assembler, storage)
           && add_lines(assembler, storage) && add_registers(assembler, storage)
           && add_mentions(assembler, storage) && add_expectations(assembler, storage);
}

struct object *encode_program(struct assembler *assembler)
{
    struct storage *storage = storage_new();
    const struct asm_region *open = &assembler->open_region;
    bool good;

    if (!storage) {
        assembler->arena->failed = true;
        return NULL;
    }
    if (open->line)
        report(assembler, open->line, open->line->begin,
               "this .kernel has no .endkernel");
    if (assembler->registers.share)
        report(assembler, assembler->registers.share->line,
               assembler->registers.share->line->begin, "this .share has no .endshare");
    if (assembler->record.line)
        report(assembler, assembler->record.line, assembler->record.line->begin,
               "this .record has no .endrecord");
    if (assembler->item_count > 0)
        qsort(assembler->items, assembler->item_count, sizeof *assembler->items,
              compare_items);
    set_entry(assembler, storage);
    storage->object.program.warm = assembler->warm;
    good = fill(assembler, storage)
           && assembler->diagnostics->errors == assembler->first_error;
    if (good)
        check_ends(assembler);
    storage->object.warned = report_pending_warnings(assembler);
    if (good && !storage->arena.failed
        && assembler->diagnostics->errors == assembler->first_error)
        return &storage->object;
    assembler->arena->failed |= storage->arena.failed;
    object_free(&storage->object);
    return NULL;
}
