/* record.h - writes records into the image of a machine's memory.
 *
 * Only rt/kernels/frame/records.s defines the offsets of fields. They are looked up by
 * name among the program's symbols.
 */
#ifndef RT_RECORD_H
#define RT_RECORD_H

#include "asm/object/object.h"
#include "rt/layout/bounds.h"
#include "rt/layout/image.h"

/* The state of a layout. After the first error all functions return without effect. */
struct record_layout {
    struct image *image;
    const struct object *program;
    c205_error *error;
    bool failed;
    uint64_t free;                /* the next unused address */
    size_t written;               /* number of records */
    bool (*go_on)(void *context); /* as in layout_new */
    void *context;
};

void layout_fail(struct record_layout *layout, const char *format, ...);
/* Returns the value of a symbol of the program. A missing symbol is an error. */
uint64_t layout_symbol(struct record_layout *layout, const char *name);
void layout_words(struct record_layout *layout, uint64_t address,
                  const c205_word *words, size_t count);
/* Writes one word to the address of a symbol of the program. */
void layout_word(struct record_layout *layout, const char *name, c205_word word);
/* Reserves words that are zero, starting at a new page. Returns their address. */
uint64_t layout_reserve(struct record_layout *layout, size_t words);

/* Items of one size at consecutive addresses. */
struct row {
    uint64_t first; /* the address of the first item */
    size_t size;    /* words of each item */
};

/* A row that layout_reserve_rows reserves. All rows have consecutive addresses, from
 * the start of a page on. `size` is the name of the program's symbol that defines the
 * size of an item. */
struct row_wanted {
    struct row *row;
    const char *size;
    size_t count;
};
void layout_reserve_rows(struct record_layout *layout, const struct row_wanted *wanted,
                         size_t rows);
uint64_t row_at(const struct row *row, size_t i);

/* The state while a row of records of the same size is written. It contains the words
 * of the next record, whose fields are set by name. */
struct record {
    struct record_layout *layout;
    c205_word *words;
    size_t size;
    uint64_t address;
    size_t line;    /* line in the scene file, for messages */
    uint64_t table; /* next free address of the tables */
};

/* Starts a row of `count` records, and reserves memory for them and for `more` words of
 * tables after them. `size` is the name of the program's symbol that defines the size
 * of a record. */
void record_begin(struct record *record, struct record_layout *layout, const char *size,
                  size_t count, size_t more);
/* Returns the row of the records. Call this before the first call of record_write,
 * which advances the address. */
struct row record_row(const struct record *record);
void record_write(struct record *record);
void record_end(struct record *record);

/* Checks numbers. A number that is not finite is an error. */
void record_check(struct record *record, const double *values, size_t count);
void record_numbers(struct record *record, const char *name, const double *values,
                    size_t count);
void record_integer(struct record *record, const char *name, size_t value);
/* Sets a field to an integer, which may be negative. */
void record_signed(struct record *record, const char *name, int value);
/* Reads words of a field that has been set. */
void record_read(struct record *record, const char *name, c205_word *words,
                 size_t count);
void record_address(struct record *record, const char *name, uint64_t address);
/* Sets the field to the address of a routine. */
void record_routine(struct record *record, const char *name, const char *routine);
void record_bound(struct record *record, const char *name, const struct bound *bound);
/* Appends words to the tables after the records, and sets the field to the address of
 * these words. */
void record_table(struct record *record, const char *name, const c205_word *table,
                  size_t count);

void put_numbers(c205_word *words, const double *values, size_t count);

#endif
