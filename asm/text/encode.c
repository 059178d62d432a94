/* encode.c - converts items to words, and words to segments. */
#include <inttypes.h>
#include <string.h>

#include "asm/object/storage.h"
#include "asm/object/syntax.h"
#include "asm/text/expression.h"

enum {
    WORD_BITS = 64,
    HALF_BITS = 32,
    ZERO_RUN = 64 /* minimum words of .space that become a separate segment */
};

/* ---- Instructions ---- */

/* Encodes a branch target. A relative branch counts half words from its address. */
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

/* Encodes a half word. It accepts signed and unsigned integers of 32 bits. */
static c205_word encode_half(struct assembler *assembler,
                             const struct layout_item *item)
{
    int64_t integer = 0;
    evaluate_range(assembler, item->line, item->of.values[0], INT32_MIN, UINT32_MAX,
                   "an integer of 32 bits", &integer);
    return (c205_word)integer << HALF_BITS;
}

/* Returns the word of an item. The value of a half-word item is in the high half. */
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

/* Reports overlapping items in one pass over the items, which are sorted by address.
 * `last` is the item with the greatest end so far. A run of overlapping items that are
 * consecutive in the text is reported once, at its first item. */
static bool check_overlap(struct assembler *assembler)
{
    const struct layout_item *items = assembler->items;
    size_t last = 0, before = assembler->diagnostics->errors;
    const struct layout_item *run = NULL; /* the last overlap; reported at its first
                                             item */

    for (size_t i = 1; i < assembler->item_count; i++) {
        if (items[i].address < layout_end(&items[last])) {
            if (!run || items[i].order != run->order + 1
                || items[i].address != layout_end(run))
                report(assembler, items[i].line, items[i].line->begin,
                       "address %" PRIX64 " is already used, by %s:%zu",
                       items[i].address, items[last].line->file,
                       items[last].line->number);
            run = &items[i];
        }
        if (layout_end(&items[i]) > layout_end(&items[last]))
            last = i;
    }
    return assembler->diagnostics->errors == before;
}

static bool is_zero_run(const struct layout_item *item)
{
    return item->kind == ITEM_SPACE && item->halves >= 2 * (uint64_t)ZERO_RUN;
}

/* Returns the number of items from this item on that form one segment, without a free
 * word between them. */
static size_t count_together(const struct layout_item *item, size_t count)
{
    uint64_t end = layout_end(item);
    size_t i;
    if (is_zero_run(item))
        return 1;
    for (i = 1; i < count && !is_zero_run(&item[i]); i++) {
        uint64_t boundary = (end + WORD_BITS - 1) / WORD_BITS * WORD_BITS;
        if (item[i].address > boundary)
            break;
        end = layout_end(&item[i]);
    }
    return i;
}

static bool add_segment(struct assembler *assembler, struct storage *storage,
                        const struct layout_item *items, size_t count)
{
    uint64_t begin = items->address / WORD_BITS * WORD_BITS;
    uint64_t end = layout_end(&items[count - 1]);
    c205_segment *segment = storage_add_segment(storage);
    c205_word *words = NULL;
    if (!segment)
        return false;
    segment->address = begin;
    segment->length = (size_t)((end - begin + WORD_BITS - 1) / WORD_BITS);
    if (!is_zero_run(items)) {
        words = arena_take(&storage->arena, segment->length * sizeof *words);
        if (!words)
            return false;
    }
    for (size_t i = 0; i < count; i++)
        encode_item(assembler, &items[i], words, begin);
    segment->words = words;
    return true;
}

bool encode_segments(struct assembler *assembler, struct storage *storage)
{
    size_t count;
    if (!check_overlap(assembler))
        return false;
    for (size_t i = 0; i < assembler->item_count; i += count) {
        count = count_together(&assembler->items[i], assembler->item_count - i);
        if (!add_segment(assembler, storage, &assembler->items[i], count))
            return false;
    }
    return true;
}
