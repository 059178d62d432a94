/* test_data.c - the data of a test go into the answer's memory, and its results are looked
 * at. */
#include <inttypes.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"

/* ---- Elements -------------------------------------------------------------- */

static unsigned width_of(enum asm_contents contents)
{
    switch (contents) {
    case ASM_BITS: return 1;
    case ASM_BYTES: return 8;
    case ASM_HALF_WORDS: return 32;
    default: return 64;
    }
}

static const char *kind_name(enum asm_contents contents)
{
    switch (contents) {
    case ASM_CODE: return "instructions";
    case ASM_WORDS: return "words";
    case ASM_HALF_WORDS: return "half words";
    case ASM_BITS: return "bits";
    case ASM_BYTES: return "bytes";
    default: return "nothing";
    }
}

/* Its leftmost bits are the element's; the others are zero. */
static c205_word mask_of(unsigned width)
{
    return ~(c205_word)0 << (64 - width);
}

static c205_word get_element(const c205 *machine, uint64_t at, unsigned width)
{
    c205_word word = 0;

    c205_read(machine, at / 64 * 64, &word, 1);
    return word << at % 64 & mask_of(width);
}

static void set_element(c205 *machine, uint64_t at, unsigned width, c205_word element)
{
    c205_word word = 0;

    c205_read(machine, at / 64 * 64, &word, 1);
    word = (word & ~(mask_of(width) >> at % 64)) | element >> at % 64;
    c205_write(machine, at / 64 * 64, &word, 1);
}

static void get_elements(const c205 *machine, uint64_t at,
                         const struct test_data *exchanged, c205_word *words)
{
    unsigned width = width_of(exchanged->contents);

    for (size_t i = 0; i < exchanged->count; i++)
        words[i] = get_element(machine, at + i * width, width);
}

static void put_elements(const struct lesson_exchange *exchange,
                         const struct test_data *exchanged)
{
    unsigned width = width_of(exchanged->contents);

    for (size_t i = 0; i < exchanged->count; i++)
        set_element(exchange->machine, exchanged->there + i * width, width,
                    get_element(exchange->data, exchanged->here + i * width, width));
}

/* ---- Labels ---------------------------------------------------------------- */

static bool holds_data(const struct asm_symbol *symbol)
{
    return symbol->is_label && symbol->contents != ASM_NOTHING
           && symbol->contents != ASM_CODE;
}

/* What the answer has at a label of the test. */
static bool check_room(struct lesson_exchange *exchange, const struct asm_symbol *ours,
                       const struct asm_symbol *theirs)
{
    const char *kind = kind_name(ours->contents);

    if (ours->contents != theirs->contents) {
        report_printf(exchange->general,
                      "There should be %s at the answer's label %s, and there "
                      "%s %s.",
                      kind, theirs->name,
                      theirs->contents == ASM_NOTHING ? "is" : "are",
                      kind_name(theirs->contents));
        return false;
    }
    if (ours->count > theirs->count) {
        report_printf(exchange->report,
                      "%s has room for %" PRIu64 " %s, and this test needs "
                      "%" PRIu64 ": the constants of the test say how many there are.",
                      theirs->name, theirs->count, kind, ours->count);
        return false;
    }
    return true;
}

static const struct lesson_tolerance *find_tolerance(const struct lesson_test *test,
                                                     const char *label)
{
    const struct lesson_tolerance *found = test->tolerances;

    while (found && strcmp(found->label, label) != 0)
        found = found->next;
    return found;
}

static void begin_wanted(struct lesson_exchange *exchange, struct test_data *item)
{
    size_t size = (item->count + 1) * sizeof *item->wanted;

    item->tolerance = find_tolerance(exchange->notes, item->label);
    item->wanted = arena_take(exchange->kept, size);
    item->before = arena_take(exchange->kept, size);
    item->found = arena_take(exchange->kept, size);
    if (!exchange->kept->failed)
        get_elements(exchange->data, item->here, item, item->wanted);
}

/* A label of the test that holds data. */
static bool begin_label(struct lesson_exchange *exchange, const struct asm_symbol *ours)
{
    const char *wanted = lesson_wanted(ours->name);
    const char *label = wanted ? wanted : ours->name;
    const struct asm_symbol *theirs = object_symbol(exchange->answer, label);
    struct test_data *item = &exchange->items[exchange->count];

    if (!theirs || !theirs->is_label) {
        if (wanted)
            report_printf(exchange->general,
                          "The answer has no label %s, where results are looked "
                          "for.",
                          label);
        return !wanted;
    }
    if (!check_room(exchange, ours, theirs))
        return false;
    *item = (struct test_data){ .label = label,
                                .contents = ours->contents,
                                .count = (size_t)ours->count,
                                .here = (uint64_t)ours->value,
                                .there = (uint64_t)theirs->value };
    exchange->count++;
    if (wanted)
        begin_wanted(exchange, item);
    else
        put_elements(exchange, item);
    return true;
}

bool exchange_begin(struct lesson_exchange *exchange)
{
    const struct object *test = exchange->test;
    bool good = true;

    exchange->items = arena_take(exchange->kept,
                                 (test->symbol_count + 1) * sizeof *exchange->items);
    if (!exchange->items)
        return false;
    for (size_t i = 0; i < test->symbol_count; i++)
        if (holds_data(&test->symbols[i]))
            good = begin_label(exchange, &test->symbols[i]) && good;
    if (!good || exchange->kept->failed)
        return false;
    for (size_t i = 0; i < exchange->count; i++)
        if (exchange->items[i].wanted)
            get_elements(exchange->machine, exchange->items[i].there,
                         &exchange->items[i], exchange->items[i].before);
    return true;
}

/* Inputs that the answer calls otherwise. */
static void print_missing(struct lesson_exchange *exchange)
{
    for (size_t i = 0; i < exchange->test->symbol_count; i++) {
        const struct asm_symbol *symbol = &exchange->test->symbols[i];

        if (holds_data(symbol) && !lesson_wanted(symbol->name)
            && !object_symbol(exchange->answer, symbol->name))
            report_printf(exchange->report,
                          "The answer has no label %s, where the test's data "
                          "would have gone.",
                          symbol->name);
    }
}

bool exchange_end(struct lesson_exchange *exchange)
{
    bool good = true;

    for (size_t i = 0; i < exchange->count; i++) {
        struct test_data *item = &exchange->items[i];

        if (!item->wanted)
            continue;
        get_elements(exchange->machine, item->there, item, item->found);
        good = mismatch_report(item, exchange->report) && good;
    }
    if (!good)
        print_missing(exchange);
    return good;
}
