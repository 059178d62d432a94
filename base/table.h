/* table.h - tables that are printed with aligned columns or in other formats.
 *
 * Cells are added from left to right, row after row. Text is left-aligned, numbers are
 * right-aligned. In printed tables, long text in the last column is wrapped
 * (word_wrap.h). A table can be printed, written for other programs, and written to the
 * JSON file, so each figure is computed once.
 */
#ifndef BASE_TABLE_H
#define BASE_TABLE_H

#include <stdio.h>

#include "base/json.h"

enum table_kind { TABLE_TEXT, TABLE_COUNT, TABLE_NUMBER };

struct table_column {
    const char *key;     /* heading in CSV, member in JSON */
    const char *heading; /* when printed */
    enum table_kind kind;
    int decimals; /* decimals of a printed number */
};

/* The formats in which a table can be written. Plain and Markdown round each number to
 * the decimals of its column. CSV prints all digits, and its headings are the keys of
 * the columns. */
enum table_format { TABLE_PLAIN, TABLE_CSV, TABLE_MARKDOWN };

/* Expands to an array of columns and its length. */
#define TABLE_COLUMNS(list) list, sizeof list / sizeof *list

struct table;

/* Returns an empty table. The texts of the columns must outlive it. NULL: out of
 * memory. */
struct table *table_new(const struct table_column *columns, size_t count);
void table_free(struct table *table);

/* Adds a cell with a copy of a text. */
void table_text(struct table *table, const char *text);
void table_count(struct table *table, uint64_t value);
/* Adds a cell with a number. NaN prints as an empty cell. */
void table_number(struct table *table, double value);
/* Adds a number to a column of numbers, with a sign and the given decimals, for example
 * an error in percent. */
void table_signed(struct table *table, double value, int decimals);
/* Adds a number to a column of numbers, with the given decimals and without a sign. It
 * uses an exponent if there would be more than 15 digits before or after the point. */
void table_rounded(struct table *table, double value, int decimals);
void table_gap(struct table *table);

/* Returns the number of complete rows. */
size_t table_rows(const struct table *table);
const char *table_key(const struct table *table, size_t column);
/* Returns the number in a cell, or NaN if the cell is empty or contains text. */
double table_value(const struct table *table, size_t row, size_t column);
/* Returns the length of the longest printed line before wrapping; SIZE_MAX: out of
 * memory. */
size_t table_width(const struct table *table);
/* Returns false if the host was out of memory while the table was filled. */
bool table_is_whole(const struct table *table);

/* Prints a blank line and the heading of a table. It has the form "Heading:", in CSV "#
 * Heading", in Markdown "## Heading". */
void table_heading(const char *heading, enum table_format format, FILE *file);
/* Returns the prefix for lines of text between tables, such as "# " in CSV. */
const char *table_remark(enum table_format format);

/* Writes a table. CSV is quoted as in RFC 4180, its lines end in LF, and a text that a
 * spreadsheet would evaluate as a formula begins with an apostrophe. Markdown is the
 * dialect of GitHub. Returns false if the host is out of memory, or if the table is
 * incomplete for lack of memory. */
bool table_write(const struct table *table, enum table_format format, FILE *file);
/* Writes a table as text with aligned columns. */
bool table_print(const struct table *table, FILE *file);
/* Writes an array of objects, one for each row. Returns false and writes nothing if the
 * host was out of memory while the table was filled. */
bool table_json(const struct table *table, struct json *json, const char *key);

#endif
