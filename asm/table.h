/* table.h - a table, printed with its columns in line or written as JSON.
 *
 * Cells are added from left to right, row after row.  Text stands at the left
 * of its column, numbers at the right.  The same table goes to the reader and
 * to the JSON file, so that no figure is worked out twice.
 */
#ifndef ASM_TABLE_H
#define ASM_TABLE_H

#include <stdio.h>

#include "asm/json.h"

enum table_kind { TABLE_TEXT, TABLE_COUNT, TABLE_NUMBER };

struct table_column {
    const char *key;     /* in JSON */
    const char *heading; /* in print */
    enum table_kind kind;
    int decimals;        /* of a number, in print */
};

struct table;

/* The columns must outlive the table.  NULL: no memory. */
struct table *table_new(const struct table_column *columns, size_t count);
void table_free(struct table *table);

/* The text is copied. */
void table_text(struct table *table, const char *text);
void table_count(struct table *table, uint64_t value);
/* NaN prints as an empty cell. */
void table_number(struct table *table, double value);
void table_gap(struct table *table);

/* False: memory ran out while it was filled. */
bool table_print(const struct table *table, FILE *file);
/* An array of objects, one a row. */
void table_json(const struct table *table, struct json *json,
                const char *key);

#endif
