/* csv.c - reads tables whose fields are separated by commas. */
#include "rt/study/fit/csv.h"

#include "base/array.h"
#include "base/text_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reports an error at a position of the text. If `at` is NULL, the error concerns the
 * whole file. */
static bool csv_fail(const struct csv *csv, size_t line, const char *at,
                     const char *message, struct diagnostics *diagnostics)
{
    struct position position = { .file = csv->path };
    if (at) {
        const char *place = csv->source + (at - csv->text), *begin = place;
        while (begin > csv->source && begin[-1] != '\n')
            begin--;
        position.line = line;
        position.column = (size_t)(place - begin) + 1;
        position.source = begin;
        position.source_length = strcspn(begin, "\n");
    }
    diagnostics_add(diagnostics, SEVERITY_ERROR, &position, message);
    return false;
}

static bool fail_whole(const struct csv *csv, const char *message,
                       struct diagnostics *diagnostics)
{
    return csv_fail(csv, 0, NULL, message, diagnostics);
}

static bool read_source(struct csv *csv, struct diagnostics *diagnostics)
{
    c205_error error;
    size_t length;
    csv->source = text_file_read(csv->path, FILE_LARGEST, &length, &error);
    if (!csv->source)
        return fail_whole(csv, error.message, diagnostics);
    csv->text = malloc(length + 1);
    if (!csv->text)
        return fail_whole(csv, "out of memory", diagnostics);
    memcpy(csv->text, csv->source, length + 1);
    return true;
}

/* Returns the next field and removes it from the line. The line becomes NULL after the
 * last field. */
static char *next_field(char **line)
{
    char *field = *line, *end;
    if (*field == '"') {
        field++;
        end = strchr(field, '"');
        if (!end)
            end = field + strlen(field);
        else
            *end++ = '\0';
        end += strcspn(end, ",");
    } else {
        end = field + strcspn(field, ",");
    }
    *line = *end == ',' ? end + 1 : NULL;
    *end = '\0';
    return field;
}

static bool cut(struct csv *csv, char *line, size_t number, char **fields,
                struct diagnostics *diagnostics)
{
    const char *begin = line;
    for (size_t i = 0; i < csv->columns; i++) {
        if (!line)
            return csv_fail(csv, number, begin,
                            "this row has fewer fields than the heading", diagnostics);
        fields[i] = next_field(&line);
    }
    return !line
           || csv_fail(csv, number, line, "this row has more fields than the heading",
                       diagnostics);
}

static bool add_row(struct csv *csv, char *line, size_t number,
                    struct diagnostics *diagnostics)
{
    struct csv_row row = { number, calloc(csv->columns, sizeof *row.fields) };
    if (!row.fields || !array_add(&csv->rows, &csv->count, &row, sizeof row)) {
        free(row.fields);
        return fail_whole(csv, "out of memory", diagnostics);
    }
    return cut(csv, line, number, row.fields, diagnostics);
}

static bool check_head(const struct csv *csv, const char *const *columns,
                       struct diagnostics *diagnostics)
{
    if (csv->count == 0)
        return fail_whole(csv, "the file has no table", diagnostics);
    for (size_t i = 0; i < csv->columns; i++)
        if (strcmp(csv->rows[0].fields[i], columns[i]) != 0) {
            char message[80];
            snprintf(message, sizeof message, "expected the column '%s'", columns[i]);
            return csv_wrong(csv, &csv->rows[0], i, message, diagnostics);
        }
    return true;
}

static bool read_rows(struct csv *csv, struct diagnostics *diagnostics)
{
    size_t number = 0;
    for (char *line = csv->text, *next; line != NULL; line = next) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        number++;
        if (*line != '\0' && *line != '#' && !add_row(csv, line, number, diagnostics))
            return false;
    }
    return true;
}

bool csv_read(struct csv *csv, const char *path, const char *const *columns,
              size_t count, struct diagnostics *diagnostics)
{
    *csv = (struct csv){ .columns = count };
    csv->path = malloc(strlen(path) + 1);
    if (!csv->path) {
        csv->path = NULL;
        return false;
    }
    strcpy(csv->path, path);
    if (!read_source(csv, diagnostics) || !read_rows(csv, diagnostics)
        || !check_head(csv, columns, diagnostics))
        return false;
    free(csv->rows[0].fields);
    csv->count--;
    memmove(csv->rows, csv->rows + 1, csv->count * sizeof *csv->rows);
    return true;
}

void csv_free(struct csv *csv)
{
    for (size_t i = 0; i < csv->count; i++)
        free(csv->rows[i].fields);
    free(csv->rows);
    free(csv->text);
    free(csv->source);
    free(csv->path);
    *csv = (struct csv){ 0 };
}

bool csv_wrong(const struct csv *csv, const struct csv_row *row, size_t field,
               const char *message, struct diagnostics *diagnostics)
{
    return csv_fail(csv, row->line, row->fields[field], message, diagnostics);
}

bool csv_positive(const struct csv *csv, const struct csv_row *row, size_t field,
                  double *value, struct diagnostics *diagnostics)
{
    char *end;
    *value = strtod(row->fields[field], &end);
    return (end != row->fields[field] && *end == '\0' && *value > 0)
           || csv_wrong(csv, row, field, "expected a positive number", diagnostics);
}
