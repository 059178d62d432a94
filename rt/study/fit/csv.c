#include "rt/study/fit/csv.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool fail(const struct csv *csv, size_t line, const char *what,
                 c205_error *error)
{
    snprintf(error->message, sizeof error->message, "%.120s:%zu: %.100s",
             csv->path, line, what);
    return false;
}

static bool fail_to_read(const struct csv *csv, c205_error *error)
{
    snprintf(error->message, sizeof error->message, "%.120s: %.100s",
             csv->path, errno != 0 ? strerror(errno) : "cannot be read");
    return false;
}

static bool read_text(struct csv *csv, c205_error *error)
{
    FILE *file;
    long size = -1;

    errno = 0;
    file = fopen(csv->path, "rb");
    if (file && fseek(file, 0, SEEK_END) == 0)
        size = ftell(file);
    if (size >= 0 && fseek(file, 0, SEEK_SET) == 0)
        csv->text = calloc((size_t)size + 1, 1);
    if (csv->text
        && fread(csv->text, 1, (size_t)size, file) != (size_t)size) {
        free(csv->text);
        csv->text = NULL;
    }
    if (file)
        fclose(file);
    if (!csv->text)
        return fail_to_read(csv, error);
    return true;
}

/* Cut the next field off a line; the line becomes NULL after the last. */
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
                c205_error *error)
{
    for (size_t i = 0; i < csv->columns; i++) {
        if (!line)
            return fail(csv, number, "fields are missing", error);
        fields[i] = next_field(&line);
    }
    return !line || fail(csv, number, "too many fields", error);
}

static bool add_row(struct csv *csv, char *line, size_t number,
                    c205_error *error)
{
    struct csv_row *rows = realloc(csv->rows,
                                   (csv->count + 1) * sizeof *rows);
    char **fields = calloc(csv->columns, sizeof *fields);

    if (rows)
        csv->rows = rows;
    if (!rows || !fields) {
        free(fields);
        return fail(csv, number, "no memory", error);
    }
    rows[csv->count++] = (struct csv_row){ number, fields };
    return cut(csv, line, number, fields, error);
}

static bool check_head(const struct csv *csv, const char *const *columns,
                       c205_error *error)
{
    if (csv->count == 0)
        return fail(csv, 0, "holds no table", error);
    for (size_t i = 0; i < csv->columns; i++)
        if (strcmp(csv->rows[0].fields[i], columns[i]) != 0)
            return fail(csv, csv->rows[0].line, "other columns are expected",
                        error);
    return true;
}

static bool read_rows(struct csv *csv, c205_error *error)
{
    size_t number = 0;

    for (char *line = csv->text, *next; line != NULL; line = next) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        number++;
        if (*line != '\0' && *line != '#'
            && !add_row(csv, line, number, error))
            return false;
    }
    return true;
}

bool csv_read(struct csv *csv, const char *path, const char *const *columns,
              size_t count, c205_error *error)
{
    *csv = (struct csv){ .columns = count };
    csv->path = malloc(strlen(path) + 1);
    if (!csv->path) {
        snprintf(error->message, sizeof error->message, "no memory");
        return false;
    }
    strcpy(csv->path, path);
    if (!read_text(csv, error) || !read_rows(csv, error)
        || !check_head(csv, columns, error))
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
    free(csv->path);
    *csv = (struct csv){ 0 };
}

bool csv_positive(const struct csv *csv, const struct csv_row *row,
                  size_t field, double *value, c205_error *error)
{
    char *end;

    *value = strtod(row->fields[field], &end);
    return (end != row->fields[field] && *end == '\0' && *value > 0)
           || fail(csv, row->line, "a positive number is expected", error);
}
