/* record.h - writing records into the image of a machine's memory.
 *
 * Where a field lies is written once, in rt/kernels/frame/records.s; it is found
 * here by its name among the program's symbols.
 */
#ifndef RT_RECORD_H
#define RT_RECORD_H

#include "asm/assemble.h"
#include "rt/layout/bounds.h"
#include "rt/layout/image.h"

/* The state of one layout: errors stay in it, and make the rest idle. */
struct record_layout {
    struct image *image;
    const struct object *program;
    c205_error *error;
    bool failed;
    uint64_t free;                /* the next address that nothing uses */
    size_t written;               /* records */
    bool (*go_on)(void *context); /* as in layout_new */
    void *context;
};

void layout_fail(struct record_layout *layout, const char *format, ...);
/* A value of the program's; a symbol that is not there is a failure. */
uint64_t layout_symbol(struct record_layout *layout, const char *name);
void layout_words(struct record_layout *layout, uint64_t address,
                  const c205_word *words, size_t count);
/* One word, to the place of that name. */
void layout_word(struct record_layout *layout, const char *name, c205_word word);
/* Room for words from a page of its own on. */
uint64_t layout_reserve(struct record_layout *layout, size_t words);

/* Things of one size, one after another. */
struct row {
    uint64_t first; /* the address of the first */
    size_t size;    /* words of each */
};

/* Room for so many in each of some rows, one behind the other, from a page of its
 * own on; the sizes are symbols of the program's. */
struct row_wanted {
    struct row *row;
    const char *size;
    size_t count;
};
void layout_reserve_rows(struct record_layout *layout, const struct row_wanted *wanted,
                         size_t rows);
uint64_t row_at(const struct row *row, size_t i);

/* A row of records of one size, written one after another: the words of the
 * next one, and its fields by name. */
struct record {
    struct record_layout *layout;
    c205_word *words;
    size_t size;
    uint64_t address;
    size_t line;    /* of the scene, for messages */
    uint64_t table; /* the next address of what a record has no room for */
};

/* With the program's symbol for the size, and room for that many records and
 * more words behind them, where the table begins. */
void record_begin(struct record *record, struct record_layout *layout, const char *size,
                  size_t count, size_t more);
/* Where they go; before the first is written. */
struct row record_row(const struct record *record);
void record_write(struct record *record);
void record_end(struct record *record);

/* Each number must be finite: else it is a failure. */
void record_check(struct record *record, const double *values, size_t count);
void record_numbers(struct record *record, const char *name, const double *values,
                    size_t count);
void record_integer(struct record *record, const char *name, size_t value);
/* Below 0, too. */
void record_signed(struct record *record, const char *name, int value);
/* So many words of a field that has been put. */
void record_read(struct record *record, const char *name, c205_word *words,
                 size_t count);
void record_address(struct record *record, const char *name, uint64_t address);
/* The address of a routine. */
void record_routine(struct record *record, const char *name, const char *routine);
void record_bound(struct record *record, const char *name, const struct bound *bound);
/* Words to the table, their address to the field. */
void record_table(struct record *record, const char *name, const c205_word *table,
                  size_t count);

void put_numbers(c205_word *words, const double *values, size_t count);

#endif
