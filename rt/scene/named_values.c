/* named_values.c - reads the values that are assigned to parts by name, and looks them
 * up. */
#include "rt/scene/named_values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "vm/error.h"
#include "base/text_file.h"
#include "base/visible_text.h"

/* ---- Options ------------------------------------------------------------- */

void named_begin(struct named_values *given, const struct value_kind *kind)
{
    *given = (struct named_values){ .kind = kind, .others = NAN };
}

static bool store_value(struct named_values *given, const char *name, size_t length,
                        double value)
{
    struct named_value kept = { arena_text(&given->kept, name, length), value };
    return kept.name && array_add(&given->list, &given->count, &kept, sizeof kept);
}

/* Reads a number in range, or the accepted word of the kind. */
static bool is_value(const struct value_kind *kind, const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    if (end > text && !*end)
        return kind->allows(*value);
    *value = kind->word_value;
    return kind->word && strcmp(text, kind->word) == 0;
}

bool named_add(struct named_values *given, const char *text, c205_error *error)
{
    const char *sign = strchr(text, '=');
    double value;
    if (!sign || sign == text || !is_value(given->kind, sign + 1, &value)) {
        bool vowel = strchr("aeiou", given->kind->name[0]);
        return error_set(error,
                         "expected NAME=VALUE with %s %s that is %s, found '%.100s'",
                         vowel ? "an" : "a", given->kind->name, given->kind->range,
                         text);
    }
    if (sign - text == 7 && !strncmp(text, "default", 7)) {
        given->others = value;
        return true;
    }
    return store_value(given, text, (size_t)(sign - text), value)
           || error_set(error, "out of memory");
}

bool named_add_scene(struct named_values *given, const struct scene *scene,
                     c205_error *error)
{
    const char *ending = given->kind->ending;
    size_t behind = strlen(ending);
    for (size_t i = 0; i < scene->float_count; i++) {
        const struct declared_float *declared = &scene->floats[i];
        size_t length = strlen(declared->name);
        if (length <= behind || strcmp(declared->name + length - behind, ending) != 0)
            continue;
        if (!given->kind->allows(declared->value))
            return error_set(error, "%.100s must be %s", declared->name,
                             given->kind->range);
        if (!store_value(given, declared->name, length - behind, declared->value))
            return error_set(error, "out of memory");
    }
    return true;
}

void named_free(struct named_values *given)
{
    free(given->list);
    arena_free(&given->kept);
}

/* ---- Files of values ----------------------------------------------------- */

static bool is_blank(char letter)
{
    return letter == ' ' || letter == '\t' || letter == '"';
}

/* Skips a number and the blanks after it. Returns false if there is no number. */
static bool skip_number(char **text, double *value)
{
    char *end;
    *value = strtod(*text, &end);
    if (end == *text || !is_blank(*end))
        return false;
    for (*text = end; is_blank(**text); (*text)++)
        ;
    return true;
}

/* Adds the value of a line. An empty line has no value. If the line is wrong, sets the
 * error and returns false. */
static bool take_line(struct named_values *given, char *line, c205_error *error)
{
    char *remark = strchr(line, '#');
    double number, value;
    size_t length;
    if (remark)
        *remark = '\0';
    while (is_blank(*line))
        line++;
    for (length = strlen(line); length > 0 && is_blank(line[length - 1]);)
        line[--length] = '\0';
    if (length == 0)
        return true;
    if (!skip_number(&line, &number) || !skip_number(&line, &value) || !*line)
        return error_set(error, "expected a line with a number, a %s and a name",
                         given->kind->name);
    if (!given->kind->allows(value))
        return error_set(error, "the %s must be %s", given->kind->name,
                         given->kind->range);
    return store_value(given, line, strlen(line), value)
           || error_set(error, "out of memory");
}

bool named_read(struct named_values *given, const char *path,
                struct diagnostics *reports)
{
    enum { LARGEST = 1 << 24 };
    struct position position = { .file = path };
    size_t length;
    c205_error error;
    char *text = text_file_read(path, LARGEST, &length, &error);
    bool good = true;
    const char *hidden;
    unsigned long code;
    if (!text) {
        diagnostics_add(reports, SEVERITY_ERROR, &position, error.message);
        return false;
    }
    for (char *line = text, *next; line; line = next) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        position.line++;
        position.source = line;
        if (!take_line(given, line, &error)) {
            hidden = invisible_find(line, &code);
            position.column = hidden ? (size_t)(hidden - line) + 1 : 1;
            position.source_length = strlen(line);
            diagnostics_add(reports, SEVERITY_ERROR, &position, error.message);
            good = false;
        }
    }
    free(text);
    return good;
}

/* ---- Which has which ----------------------------------------------------- */

bool named_check(const struct named_values *given, const struct named_parts *parts,
                 const char *besides, c205_error *error)
{
    for (size_t i = 0; i < given->count; i++) {
        const char *name = given->list[i].name;
        if (besides && strcmp(name, besides) == 0)
            continue;
        if (!named_parts_check(parts, name, error))
            return false;
    }
    return true;
}

double named_of_name(const struct named_values *given, const char *name)
{
    for (size_t i = 0; name && i < given->count; i++)
        if (strcmp(given->list[i].name, name) == 0)
            return given->list[i].value;
    return NAN;
}

double named_of_part(const struct named_values *given, const struct named_part *part)
{
    double value = named_of_name(given, part->name);
    if (isnan(value) && !part->mixed)
        value = named_of_name(given, part->material);
    return isnan(value) ? given->others : value;
}
