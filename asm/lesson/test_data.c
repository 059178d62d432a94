/* test_data.c - copies the data of a test to the memory of the answer and compares the
 * results. */
#include <inttypes.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "asm/view/vector_view.h"
#include "vm/error.h"

/* ---- Elements -------------------------------------------------------------- */

static unsigned contents_width(enum asm_contents contents)
{
    return contents == ASM_BYTES ? 8 : vector_width(contents);
}

static const char *kind_name(enum asm_contents contents)
{
    return contents == ASM_CODE      ? "instructions"
           : contents == ASM_NOTHING ? "nothing"
                                     : asm_contents_name(contents);
}

/* Returns the mask of an element in a word. Elements are left-aligned, followed by
 * zeros. */
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

void test_data_read(const c205 *machine, uint64_t at, const struct test_item *item,
                    c205_word *words)
{
    unsigned width = contents_width(item->contents);
    for (size_t i = 0; i < item->count; i++)
        words[i] = get_element(machine, at + i * width, width);
}

static void put_elements(const struct lesson_test_data *test_data,
                         const struct test_item *item)
{
    unsigned width = contents_width(item->contents);
    for (size_t i = 0; i < item->count; i++)
        set_element(test_data->machine, item->actual_at + i * width, width,
                    get_element(test_data->data, item->expected_at + i * width, width));
}

/* ---- Labels ---------------------------------------------------------------- */

bool test_holds_data(const struct asm_symbol *symbol)
{
    return symbol->is_label && symbol->contents != ASM_NOTHING
           && symbol->contents != ASM_CODE;
}

/* Checks that the data at a label of the answer have the same type as the data of the
 * test and are not shorter. */
static bool check_room(struct lesson_test_data *test_data,
                       const struct asm_symbol *ours, const struct asm_symbol *theirs)
{
    const char *kind = kind_name(ours->contents);
    if (ours->contents != theirs->contents) {
        report_printf(test_data->general,
                      "Expected %s at the answer's label %s, but there %s %s.", kind,
                      theirs->name, theirs->contents == ASM_NOTHING ? "is" : "are",
                      kind_name(theirs->contents));
        return false;
    }
    if (ours->count > theirs->count) {
        report_printf(test_data->report,
                      "%s has room for %" PRIu64 " %s, and this test needs "
                      "%" PRIu64 ": the constants of the test give the number.",
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

static void begin_wanted(struct lesson_test_data *test_data, struct test_item *item)
{
    size_t size = (item->count + 1) * sizeof *item->expected;
    item->tolerance = find_tolerance(test_data->notes, item->label);
    item->expected = arena_take(test_data->kept, size);
    item->initial = arena_take(test_data->kept, size);
    item->actual = arena_take(test_data->kept, size);
    if (!test_data->kept->failed)
        test_data_read(test_data->data, item->expected_at, item, item->expected);
}

/* Adds an item for the data at a label of the test: an input, or expected results.
 * Returns false with a report if the answer has no label for results, or if its label
 * has other data. */
static bool begin_label(struct lesson_test_data *test_data,
                        const struct asm_symbol *ours)
{
    const char *expected = lesson_wanted(ours->name);
    const char *label = expected ? expected : ours->name;
    const struct asm_symbol *theirs = object_symbol(test_data->answer, label);
    struct test_item *item = &test_data->items[test_data->count];
    if (!theirs || !theirs->is_label) {
        if (expected)
            report_printf(test_data->general,
                          "The answer has no label %s, which must hold results.",
                          label);
        return !expected;
    }
    if (!check_room(test_data, ours, theirs))
        return false;
    *item = (struct test_item){ .label = label,
                                .contents = ours->contents,
                                .count = (size_t)ours->count,
                                .expected_at = (uint64_t)ours->value,
                                .actual_at = (uint64_t)theirs->value };
    test_data->count++;
    if (expected)
        begin_wanted(test_data, item);
    return true;
}

/* Returns true if the test has initial data for the results at a label. */
static bool is_set(const struct lesson_test_data *test_data, const char *label)
{
    const struct asm_symbol *symbol = object_symbol(test_data->test, label);
    return symbol && test_holds_data(symbol);
}

static void poison_elements(const struct lesson_test_data *test_data,
                            const struct test_item *item)
{
    unsigned width = contents_width(item->contents);
    for (size_t i = 0; i < item->count; i++) {
        uint64_t at = item->actual_at + i * width;
        set_element(test_data->machine, at, width,
                    LESSON_POISON << at % 64 & mask_of(width));
    }
}

/* Writes the data before the run. Inputs come last, because results of the answer may
 * share their storage. */
static void set_items(const struct lesson_test_data *test_data)
{
    for (size_t i = 0; i < test_data->count; i++) {
        struct test_item *item = &test_data->items[i];
        item->poisoned = item->expected && !is_set(test_data, item->label);
        if (item->poisoned)
            poison_elements(test_data, item);
    }
    for (size_t i = 0; i < test_data->count; i++)
        if (!test_data->items[i].expected)
            put_elements(test_data, &test_data->items[i]);
}

bool test_data_begin(struct lesson_test_data *test_data)
{
    const struct object *test = test_data->test;
    bool good = true;
    test_data->items = arena_take(test_data->kept,
                                  (test->symbol_count + 1) * sizeof *test_data->items);
    if (!test_data->items)
        return false;
    for (size_t i = 0; i < test->symbol_count; i++)
        if (test_holds_data(&test->symbols[i]))
            good = begin_label(test_data, &test->symbols[i]) && good;
    if (!good || test_data->kept->failed)
        return false;
    set_items(test_data);
    for (size_t i = 0; i < test_data->count; i++)
        if (test_data->items[i].expected)
            test_data_read(test_data->machine, test_data->items[i].actual_at,
                           &test_data->items[i], test_data->items[i].initial);
    return true;
}

void test_data_spoil(const struct lesson_test_data *test_data, const char *label)
{
    for (size_t i = 0; i < test_data->count; i++)
        if (!test_data->items[i].expected
            && strcmp(test_data->items[i].label, label) == 0)
            poison_elements(test_data, &test_data->items[i]);
}

/* Reports inputs for which the answer has no label, because this may explain wrong
 * results. */
static void print_missing(struct lesson_test_data *test_data)
{
    for (size_t i = 0; i < test_data->test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test_data->test->symbols[i];
        if (test_holds_data(symbol) && !lesson_wanted(symbol->name)
            && !object_symbol(test_data->answer, symbol->name))
            report_printf(
                test_data->report,
                "The answer has no label %s, which would receive the test's data.",
                symbol->name);
    }
}

bool test_data_end(struct lesson_test_data *test_data)
{
    bool good = true;
    for (size_t i = 0; i < test_data->count; i++) {
        struct test_item *item = &test_data->items[i];
        if (!item->expected)
            continue;
        test_data_read(test_data->machine, item->actual_at, item, item->actual);
        good = mismatch_report(item, test_data->report) && good;
    }
    if (!good)
        print_missing(test_data);
    return good;
}

/* Returns true if results are poison after the run. Bits and bytes may equal those of
 * the poison by coincidence. */
static bool is_unstored(const struct lesson_test_data *test_data,
                        const struct test_item *item)
{
    unsigned width = contents_width(item->contents);
    size_t i = 0;
    while (i < item->count
           && get_element(test_data->machine, item->actual_at + i * width, width)
                  != item->initial[i])
        i++;
    return i < item->count && item->poisoned && width >= 32;
}

bool test_data_keep(const struct lesson_test_data *test_data, c205 *data,
                    c205_error *error)
{
    for (size_t i = 0; i < test_data->count; i++) {
        const struct test_item *item = &test_data->items[i];
        unsigned width = contents_width(item->contents);
        if (item->expected && is_unstored(test_data, item))
            return error_set(error,
                             "solution.s fails in %.48s: it stores nothing at %s",
                             test_data->notes->file, item->label);
        for (size_t k = 0; item->expected && k < item->count; k++)
            set_element(data, item->expected_at + k * width, width,
                        get_element(test_data->machine, item->actual_at + k * width,
                                    width));
    }
    return true;
}
