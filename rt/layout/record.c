/* record.c - writes records into the image of a machine's memory. */
#include "rt/layout/record.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "rt/layout/program.h"
#include "vm/error.h"

void layout_fail(struct record_layout *layout, const char *format, ...)
{
    va_list arguments;
    if (layout->failed)
        return;
    layout->failed = true;
    va_start(arguments, format);
    error_set_list(layout->error, format, arguments);
    va_end(arguments);
}

uint64_t layout_symbol(struct record_layout *layout, const char *name)
{
    const struct asm_symbol *found = object_symbol(layout->program, name);
    if (found)
        return (uint64_t)found->value;
    layout_fail(layout, "the program has no symbol %s", name);
    return 0;
}

void layout_words(struct record_layout *layout, uint64_t address,
                  const c205_word *words, size_t count)
{
    if (!layout->failed && !image_write(layout->image, address, words, count))
        layout_fail(layout, "out of memory");
}

void layout_word(struct record_layout *layout, const char *name, c205_word word)
{
    layout_words(layout, layout_symbol(layout, name), &word, 1);
}

uint64_t layout_reserve(struct record_layout *layout, size_t words)
{
    uint64_t address = layout->free;
    if (layout->failed || words == 0)
        return address;
    if (!image_reserve(layout->image, address, words))
        layout_fail(layout, "out of memory");
    layout->free = program_round_up(address + UINT64_C(64) * words);
    return address;
}

void layout_reserve_rows(struct record_layout *layout, const struct row_wanted *wanted,
                         size_t rows)
{
    size_t words = 0;
    uint64_t first;
    for (size_t i = 0; i < rows; i++) {
        wanted[i].row->size = (size_t)layout_symbol(layout, wanted[i].size);
        words += wanted[i].count * wanted[i].row->size;
    }
    first = layout_reserve(layout, words);
    for (size_t i = 0; i < rows; i++) {
        wanted[i].row->first = first;
        first = row_at(wanted[i].row, wanted[i].count);
    }
}

uint64_t row_at(const struct row *row, size_t i)
{
    return row->first + UINT64_C(64) * row->size * i;
}

void record_begin(struct record *record, struct record_layout *layout, const char *size,
                  size_t count, size_t more)
{
    record->layout = layout;
    record->size = (size_t)layout_symbol(layout, size);
    record->words = calloc(record->size + 1, sizeof *record->words);
    record->line = 0;
    if (!record->words)
        layout_fail(layout, "out of memory");
    record->address = layout_reserve(layout, count * record->size + more);
    record->table = record->address + UINT64_C(64) * count * record->size;
}

struct row record_row(const struct record *record)
{
    return (struct row){ record->address, record->size };
}

/* Calls go_on after every ASKED_EACH records. If it returns false, the layout fails. */
static void ask(struct record_layout *layout)
{
    enum { ASKED_EACH = 4096 };
    if (layout->go_on && ++layout->written % ASKED_EACH == 0
        && !layout->go_on(layout->context))
        layout_fail(layout, "stopped while the scene is laid out");
}

void record_write(struct record *record)
{
    ask(record->layout);
    if (record->layout->failed)
        return;
    layout_words(record->layout, record->address, record->words, record->size);
    memset(record->words, 0, record->size * sizeof *record->words);
    record->address += UINT64_C(64) * record->size;
}

void record_end(struct record *record)
{
    free(record->words);
    record->words = NULL;
}

/* Returns the position of a field of count words, or NULL if the record is too short
 * for it. */
static c205_word *find_field(struct record *record, const char *name, size_t count)
{
    uint64_t offset = layout_symbol(record->layout, name);
    if (record->words && offset + count <= record->size)
        return record->words + offset;
    layout_fail(record->layout, "field %s does not fit its record", name);
    return NULL;
}

void record_read(struct record *record, const char *name, c205_word *words,
                 size_t count)
{
    const c205_word *field = find_field(record, name, count);
    if (field)
        memcpy(words, field, count * sizeof *words);
}

static void put_word(struct record *record, const char *name, c205_word word)
{
    c205_word *field = find_field(record, name, 1);
    if (field)
        *field = word;
}

void put_numbers(c205_word *words, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        words[i] = c205_from_double(values[i]);
}

/* Checks that numbers are finite. Squares and reciprocals of a scene's numbers may
 * exceed the range of doubles, which is much smaller than the range of the machine. */
void record_check(struct record *record, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(values[i]))
            layout_fail(record->layout,
                        "the object of line %zu is too large "
                        "or too small to be traced: scale the scene",
                        record->line);
}

void record_numbers(struct record *record, const char *name, const double *values,
                    size_t count)
{
    c205_word *field;
    record_check(record, values, count);
    field = find_field(record, name, count);
    if (field)
        put_numbers(field, values, count);
}

void record_integer(struct record *record, const char *name, size_t value)
{
    put_word(record, name, c205_from_integer((int64_t)value));
}

void record_signed(struct record *record, const char *name, int value)
{
    put_word(record, name, c205_from_integer(value));
}

void record_address(struct record *record, const char *name, uint64_t address)
{
    put_word(record, name, address);
}

void record_routine(struct record *record, const char *name, const char *routine)
{
    record_address(record, name, layout_symbol(record->layout, routine));
}

void record_bound(struct record *record, const char *name, const struct bound *bound)
{
    double words[5];
    memcpy(words, bound->center, sizeof bound->center);
    words[3] = bound->radius;
    words[4] = bound->radius * bound->radius;
    record_numbers(record, name, words, 5);
}

void record_table(struct record *record, const char *name, const c205_word *table,
                  size_t count)
{
    layout_words(record->layout, record->table, table, count);
    record_address(record, name, record->table);
    record->table += UINT64_C(64) * count;
}
