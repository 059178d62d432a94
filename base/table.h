/* table.h - tables that are printed with aligned columns or in other formats.
 *
 * Cells are added from left to right, row after row. Text is left-aligned, numbers are
 * right-aligned. In printed tables, long text in the last column is wrapped
 * (word_wrap.h). The same table is printed, read by other programs and written to the
 * JSON file, so each figure is computed once.
 */
#ifndef BASE_TABLE_H
#define BASE_TABLE_H

#include <stdio.h>

#include "base/json.h"

enum table_kind { TABLE_TEXT, TABLE_COUNT, TABLE_NUMBER };

struct table_column {
    const char *key;     /* in JSON */
    const char *heading; /* when printed */
    enum table_kind kind;
    int decimals; /* of a printed number */
};

/* The formats. Plain and Markdown show numbers with the decimals of their columns. CSV
 * has the keys, and all digits that JSON has. */
enum table_format { TABLE_PLAIN, TABLE_CSV, TABLE_MARKDOWN };

/* Expands to an array of columns and their number. */
#define TABLE_COLUMNS(list) list, sizeof list / sizeof *list

struct table;

/* Returns an empty table. The texts of the columns must outlive it. NULL: out of
 * memory. */
struct table *table_new(const struct table_column *columns, size_t count);
void table_free(struct table *table);

/* Adds a copy of a text. */
void table_text(struct table *table, const char *text);
void table_count(struct table *table, uint64_t value);
/* Adds a number. NaN prints as an empty cell. */
void table_number(struct table *table, double value);
/* Adds a number to a column of numbers, with a sign and its own decimals, for example
 * an error in percent. */
void table_signed(struct table *table, double value, int decimals);
/* Adds a number to a column of numbers, with its own decimals and without a sign. It
 * uses an exponent if there would be more than 15 digits before or after the point. */
void table_rounded(struct table *table, double value, int decimals);
void table_gap(struct table *table);

/* Returns the number of complete rows. */
size_t table_rows(const struct table *table);
const char *table_key(const struct table *table, size_t column);
/* Returns the number in a cell, or NaN if the cell is empty or holds text. */
double table_value(const struct table *table, size_t row, size_t column);
/* Returns the length of a printed line before wrapping; SIZE_MAX: out of memory. */
size_t table_width(const struct table *table);
/* Returns false if memory was exhausted while the table was filled. */
bool table_is_whole(const struct table *table);

/* Prints a blank line and the heading of a table: "Heading:", in CSV "# Heading", in
 * Markdown "## Heading". */
void table_heading(const char *heading, enum table_format format, FILE *file);
/* Returns the prefix of a line of text between tables. */
const char *table_remark(enum table_format format);

/* Writes a table. CSV is quoted as in RFC 4180, its lines end in LF, and a text that a
 * spreadsheet would evaluate as a formula begins with an apostrophe. Markdown is
 * GitHub's. Returns false if memory was exhausted, now or while the table was
 * filled. */
bool table_write(const struct table *table, enum table_format format, FILE *file);
/* Writes a table in plain format. */
bool table_print(const struct table *table, FILE *file);
/* Writes an array of objects, one for each row. Returns false and writes nothing if
 * memory was exhausted while the table was filled. */
bool table_json(const struct table *table, struct json *json, const char *key);

#endif
