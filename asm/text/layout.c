/* layout.c - the location counters of the two sections, and the items at their
 * addresses. */
#include "asm/text/statement.h"

#include <stdio.h>
#include <stdlib.h>

enum { WORD_HALVES = 2, HALF_BITS = 32 };

/* Reports an overflow once for a section, because all later items are out of range,
 * too. */
static bool report_full(struct cursor *cursor, const char *message)
{
    struct section *section = cursor->assembler->section;
    if (!section->full)
        report_at(cursor, cursor->line->begin, "%s", message);
    section->full = true;
    return false;
}

static bool check_words(struct cursor *cursor, uint64_t halves)
{
    struct assembler *assembler = cursor->assembler;
    char message[80];
    assembler->words += (halves + 1) / WORD_HALVES;
    if (assembler->words <= MAX_WORDS)
        return true;
    assembler->words = MAX_WORDS;
    snprintf(message, sizeof message, "the program has more than %lu words",
             (unsigned long)MAX_WORDS);
    return report_full(cursor, message);
}

static bool check_room(struct cursor *cursor, uint64_t halves)
{
    const struct assembler *assembler = cursor->assembler;
    const struct section *section = assembler->section;
    uint64_t end = section->at + halves * HALF_BITS;
    if (section->full || !check_words(cursor, halves))
        return false;
    if (end > (uint64_t)1 << ADDRESS_BITS)
        return report_full(cursor, "this is beyond the last address");
    if (section == &assembler->sections[0] && !section->moved && end > DATA_ORIGIN
        && section->at <= DATA_ORIGIN)
        return report_full(
            cursor,
            "the code is larger than its page and overlaps the data; move it with "
            ".org");
    return true;
}

struct layout_item *layout_add(struct cursor *cursor, enum item_kind kind,
                               uint64_t halves)
{
    struct assembler *assembler = cursor->assembler;
    struct layout_item *item;
    if (!check_room(cursor, halves))
        return NULL;
    item = arena_add(assembler->arena, &assembler->items, &assembler->item_count,
                     &assembler->item_capacity, NULL, sizeof *item);
    if (!item)
        return NULL;
    item->kind = kind;
    item->contents = kind == ITEM_INSTRUCTION ? ASM_CODE : assembler->contents;
    item->line = cursor->line;
    item->address = assembler->section->at;
    item->halves = halves;
    item->order = assembler->item_count - 1;
    assembler->section->at += halves * HALF_BITS;
    layout_resolve(assembler);
    return item;
}

void layout_align(struct assembler *assembler, uint64_t bits)
{
    uint64_t at = assembler->section->at;
    at = (at + bits - 1) / bits * bits;
    assembler->section->at = at;
    for (size_t i = 0; i < assembler->waiting_count; i++)
        assembler->waiting[i]->value.bits = at;
}

bool layout_label(struct cursor *cursor, const char *name, size_t length,
                  const char *at)
{
    struct assembler *assembler = cursor->assembler;
    struct symbol *symbol = symbol_intern(assembler, name, length);
    struct value value = { VALUE_INTEGER, 0 };
    value.bits = assembler->section->at;
    return symbol_define(assembler, cursor->line, at, symbol, SYMBOL_LABEL, value)
           && arena_add(assembler->arena, &assembler->waiting,
                        &assembler->waiting_count, &assembler->waiting_capacity,
                        &symbol, sizeof symbol);
}

void layout_resolve(struct assembler *assembler)
{
    assembler->waiting_count = 0;
}

bool layout_known(struct cursor *cursor, const c205_word *words, uint64_t count)
{
    struct layout_item *item;
    if (count == 0)
        return true;
    item = layout_add(cursor, ITEM_WORDS, 2 * count);
    if (!item)
        return false;
    item->of.words = words;
    return true;
}

uint64_t layout_end(const struct layout_item *item)
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

void layout_sort(struct assembler *assembler)
{
    if (assembler->item_count > 0)
        qsort(assembler->items, assembler->item_count, sizeof *assembler->items,
              compare_items);
}
