/* table.h - a table, printed with its columns in line or in other formats.
 *
 * Cells are added from left to right, row after row.  Text is at the left
 * of its column, numbers at the right.  In print
 * text in the last column is folded where its line would be long (word_wrap.h).  The same table goes to the reader, to
 * other programs and to the JSON file, so that no figure is worked out twice.
 */
#ifndef BASE_TABLE_H
#define BASE_TABLE_H

#include <stdio.h>

#include "base/json.h"

enum table_kind { TABLE_TEXT, TABLE_COUNT, TABLE_NUMBER };

struct table_column {
    const char *key;     /* in JSON */
    const char *heading; /* in print */
    enum table_kind kind;
    int decimals; /* of a number, in print */
};

/* How a table is written.  Plain and Markdown show numbers with the decimals
 * of their columns; CSV has the names and all the digits that JSON has. */
enum table_format { TABLE_PLAIN, TABLE_CSV, TABLE_MARKDOWN };

/* Columns that are in an array, and their number. */
#define TABLE_COLUMNS(list) list, sizeof list / sizeof *list

struct table;

/* The texts of the columns must outlive the table.  NULL: no memory. */
struct table *table_new(const struct table_column *columns, size_t count);
void table_free(struct table *table);

/* The text is copied. */
void table_text(struct table *table, const char *text);
void table_count(struct table *table, uint64_t value);
/* NaN prints as an empty cell. */
void table_number(struct table *table, double value);
/* The same in a column of numbers, with its sign and decimals of its own: an
 * error in percent, say. */
void table_signed(struct table *table, double value, int decimals);
/* The same without the sign; with an exponent if there would be more than 15 digits
 * before or after the point. */
void table_rounded(struct table *table, double value, int decimals);
void table_gap(struct table *table);

/* What was put in; a row counts once all its cells are there. */
size_t table_rows(const struct table *table);
const char *table_key(const struct table *table, size_t column);
/* NaN: the cell is empty or holds text. */
double table_value(const struct table *table, size_t row, size_t column);
/* How long a line of print is before text is folded; SIZE_MAX: no memory. */
size_t table_width(const struct table *table);
/* False: memory ran out while it was filled. */
bool table_is_whole(const struct table *table);

/* The line above a table, after a blank one: "Heading:", in CSV "# Heading",
 * in Markdown "## Heading". */
void table_heading(const char *heading, enum table_format format, FILE *file);
/* What a line of text among the tables begins with. */
const char *table_remark(enum table_format format);

/* CSV quotes as RFC 4180 says, its lines end in LF; a text that a spreadsheet
 * would evaluate as a formula begins with an apostrophe.  Markdown is GitHub's.
 * False: memory ran out, now or while the table was filled. */
bool table_write(const struct table *table, enum table_format format, FILE *file);
/* The same, plain. */
bool table_print(const struct table *table, FILE *file);
/* An array of objects, one a row.  False, and nothing is written: memory ran
 * out while it was filled. */
bool table_json(const struct table *table, struct json *json, const char *key);

#endif
