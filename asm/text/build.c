/* build.c - builds the object from the results of the passes. */
#include <string.h>

#include "asm/object/storage.h"
#include "asm/text/data_map.h"
#include "asm/text/expression.h"
#include "asm/text/shown_line.h"

enum { WORD_BITS = 64 };

static char *store_text(struct storage *storage, const char *text)
{
    return arena_text(&storage->arena, text, strlen(text));
}

static bool add_regions(struct assembler *assembler, struct storage *storage)
{
    for (size_t i = 0; i < assembler->region_count; i++) {
        c205_region *region = storage_add_region(storage);
        if (!region)
            return false;
        region->name = store_text(storage, assembler->regions[i].name);
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
    kept->name = store_text(storage, symbol->name);
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
    for (size_t i = 0; i < SYMBOL_BUCKETS; i++)
        for (symbol = assembler->symbols.buckets[i]; symbol; symbol = symbol->next)
            if (!add_symbol(storage, symbol))
                return false;
    storage_sort_symbols(storage);
    symbols = (struct asm_symbol *)(uintptr_t)storage->object.symbols;
    if (!data_map_fill(assembler, symbols, storage->object.symbol_count))
        storage->arena.failed = true;
    return !storage->arena.failed;
}

/* Stores the place of a line. `before` is the line of the previous code, or NULL. The
 * source of a line of a macro is the text of the definition, because each call of the
 * macro can produce another text. */
static struct asm_place keep_place(struct storage *storage, const struct line *line,
                                   const struct line *before)
{
    const char *text = line->written ? line->written : line->text;
    const char *end = line->written ? line->written_end : line->text_end;
    return (struct asm_place){
        .file = store_text(storage, line->file),
        .number = line->number,
        .source = arena_text(&storage->arena, text, (size_t)(end - text)),
        .begins = line != before,
    };
}

/* Adds the source line of an item. `before` is the previous item, or NULL. */
static bool add_line(struct storage *storage, const struct layout_item *item,
                     const struct layout_item *before)
{
    struct asm_line *line = storage_add_line(storage);
    const struct line *from = item->line, *last = NULL;
    if (!line)
        return false;
    line->address = item->address;
    line->halves = item->halves;
    line->number = from->number;
    line->is_code = item->kind == ITEM_INSTRUCTION;
    line->file = store_text(storage, from->file);
    line->source = arena_text(&storage->arena, from->text,
                              (size_t)(from->text_end - from->text));
    if (before && before->kind == ITEM_INSTRUCTION)
        last = before->line;
    line->shown = keep_place(storage, shown_line(from), last ? shown_line(last) : NULL);
    line->call = keep_place(storage, outermost_line(from),
                            last ? outermost_line(last) : NULL);
    line->reported = keep_place(storage, reported_line(from), NULL);
    line->form = form_of_line(from);
    return !storage->arena.failed;
}

/* Adds the lines. Adjacent items of a line become one entry. */
static bool add_lines(struct assembler *assembler, struct storage *storage)
{
    const struct layout_item *items = assembler->items;
    size_t next;
    for (size_t i = 0; i < assembler->item_count; i = next) {
        struct layout_item whole = items[i];
        for (next = i + 1;
             next < assembler->item_count && items[next].line == whole.line
             && items[next].address == layout_end(&whole);
             next++)
            whole.halves += items[next].halves;
        if (!add_line(storage, &whole, i > 0 ? &items[i - 1] : NULL))
            return false;
    }
    return true;
}

static bool add_registers(struct assembler *assembler, struct storage *storage)
{
    for (size_t i = 0; i < assembler->registers.count; i++) {
        const struct naming *naming = &assembler->registers.namings[i];
        struct asm_register *kept = storage_add_register(storage);
        if (!kept)
            return false;
        kept->name = store_text(storage, naming->symbol->name);
        kept->half = naming->named.half;
        kept->number = naming->named.number;
        kept->file = store_text(storage, naming->line->file);
        kept->line = naming->line->number;
        kept->owner = naming->owner;
    }
    return true;
}

static bool add_mentions(struct assembler *assembler, struct storage *storage)
{
    const struct layout_item *item = assembler->items;
    for (size_t i = 0; i < assembler->item_count; i++, item++) {
        if (item->kind != ITEM_INSTRUCTION)
            continue;
        for (size_t j = 0; j < item->of.instruction->mentions; j++) {
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
    made->text = expectation->text ? store_text(storage, expectation->text) : NULL;
    made->file = store_text(storage, expectation->line->file);
    made->line = expectation->line->number;
    made->has_tolerance = expectation->tolerance != NULL;
    grant_tolerance(assembler, expectation, made);
    if (expectation->address)
        evaluate_address(assembler, expectation->line, expectation->address,
                         &made->address);
    for (i = 0; i < size; i++)
        if (expectation->bits)
            words[i] = expectation->bits[i];
        else
            value(assembler, expectation->line, expectation->values[i], &words[i]);
    return true;
}

static bool add_expectations(struct assembler *assembler, struct storage *storage)
{
    for (size_t i = 0; i < assembler->expectation_count; i++)
        if (!grant(assembler, storage, &assembler->expectations[i]))
            return false;
    return true;
}

static void set_entry(struct assembler *assembler, struct storage *storage)
{
    uint64_t entry = CODE_ORIGIN;
    size_t first = assembler->item_count;
    if (assembler->entry) {
        evaluate_address(assembler, assembler->entry_line, assembler->entry, &entry);
        storage->object.program.entry = entry;
        return;
    }
    for (size_t i = 0; i < assembler->item_count;
         i++) /* finds the first in the order of the text */
        if (assembler->items[i].kind == ITEM_INSTRUCTION
            && (first == assembler->item_count
                || assembler->items[i].order < assembler->items[first].order))
            first = i;
    if (first < assembler->item_count)
        entry = assembler->items[first].address;
    storage->object.program.entry = entry;
}

/* Stores the words, symbols and lines in the object. Continues after errors in values,
 * so that all of them are reported. */
static bool fill_storage(struct assembler *assembler, struct storage *storage)
{
    return encode_segments(assembler, storage) && add_regions(assembler, storage)
           && add_symbols(assembler, storage) && add_lines(assembler, storage)
           && add_registers(assembler, storage) && add_mentions(assembler, storage)
           && add_expectations(assembler, storage);
}

struct object *build_object(struct assembler *assembler)
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
    layout_sort(assembler);
    set_entry(assembler, storage);
    storage->object.program.warm = assembler->warm;
    good = fill_storage(assembler, storage)
           && assembler->diagnostics->errors == assembler->first_error;
    if (good) {
        check_ends(assembler);
        check_first_reads(assembler, storage->object.program.entry);
    }
    storage->object.warned = report_pending_warnings(assembler);
    if (good && !storage->arena.failed
        && assembler->diagnostics->errors == assembler->first_error)
        return &storage->object;
    assembler->arena->failed |= storage->arena.failed;
    object_free(&storage->object);
    return NULL;
}
