#include "rt/mass/parts.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"
#include "base/file.h"

/* ---- Densities that are given -------------------------------------------- */

static bool keep_density(struct densities *densities, const char *name,
                         size_t length, double value)
{
    struct given_density *list = array_grow(densities->list, densities->count,
                                            sizeof *list);
    char *kept = arena_text(&densities->kept, name, length);

    if (list)
        densities->list = list;
    if (!list || !kept)
        return false;
    list[densities->count++] = (struct given_density){ kept, value };
    return true;
}

static bool is_density(double value)
{
    return value > 0 && isfinite(value);
}

bool densities_add(struct densities *densities, const char *text,
                   c205_error *error)
{
    const char *sign = strchr(text, '=');
    char *end;
    double value = sign ? strtod(sign + 1, &end) : 0;

    if (!sign || sign == text || end == sign + 1 || *end
        || !is_density(value)) {
        return error_say(
            error,
            "a density is NAME=VALUE with a value above 0, not '%.100s'",
            text);
    }
    if (sign - text == 7 && !strncmp(text, "default", 7)) {
        densities->others = value;
        return true;
    }
    return keep_density(densities, text, (size_t)(sign - text), value)
           || error_say(error, "no memory");
}

bool densities_add_scene(struct densities *densities,
                         const struct scene *scene, c205_error *error)
{
    static const char ending[] = "_Density";
    size_t behind = sizeof ending - 1;

    for (size_t i = 0; i < scene->float_count; i++) {
        const struct declared_float *given = &scene->floats[i];
        size_t length = strlen(given->name);

        if (length <= behind
            || strcmp(given->name + length - behind, ending) != 0)
            continue;
        if (!is_density(given->value)) {
            return error_say(error, "%.100s is not above 0", given->name);
        }
        if (!keep_density(densities, given->name, length - behind,
                          given->value))
            return error_say(error, "no memory");
    }
    return true;
}

void densities_free(struct densities *densities)
{
    free(densities->list);
    arena_free(&densities->kept);
}

/* ---- A file of them ------------------------------------------------------ */

static bool is_blank(char letter)
{
    return letter == ' ' || letter == '\t' || letter == '\r' || letter == '"';
}

/* A number and the blanks around it; false: there is none. */
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

/* NULL: it is well, or empty; else what is wrong. */
static const char *take_line(struct densities *densities, char *line)
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
        return NULL;
    if (!skip_number(&line, &number) || !skip_number(&line, &value) || !*line)
        return "a line is a number, a density and a name";
    if (!is_density(value))
        return "the density is not above 0";
    return keep_density(densities, line, strlen(line), value) ? NULL
                                                              : "no memory";
}

static void report(struct diagnostics *reports, const char *path, size_t line,
                   const char *message)
{
    const struct position position = { .file = path,
                                       .line = line,
                                       .column = line > 0 };

    diagnostics_add(reports, SEVERITY_ERROR, &position, message);
}

bool densities_read(struct densities *densities, const char *path,
                    struct diagnostics *reports)
{
    enum { LARGEST = 1 << 24 };
    size_t length, number = 0, errors = reports->errors;
    c205_error error;
    char *text = file_read(path, LARGEST, &length, &error);

    if (!text) {
        report(reports, path, 0, error.message);
        return false;
    }
    for (char *line = text, *next; line; line = next) {
        const char *wrong;

        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        wrong = take_line(densities, line);
        number++;
        if (wrong)
            report(reports, path, number, wrong);
    }
    free(text);
    return reports->errors == errors;
}

/* ---- Parts --------------------------------------------------------------- */

static bool same_text(const char *one, const char *other)
{
    return one && other ? strcmp(one, other) == 0 : one == other;
}

static const char *object_name(struct mass_parts *parts,
                               const struct world_object *object)
{
    char line[40];

    if (object->name)
        return object->name;
    snprintf(line, sizeof line, "line %zu", object->line);
    return arena_text(&parts->kept, line, strlen(line));
}

/* The number of the object's part, which may be a new one. */
static size_t find_part(struct mass_parts *parts,
                        const struct world_object *object, const char *name)
{
    size_t i = 0;

    while (i < parts->count
           && !(same_text(parts->list[i].name, name)
                && same_text(parts->list[i].material, object->material)))
        i++;
    if (i == parts->count)
        parts->list[parts->count++] = (struct mass_part){
            .name = name, .material = object->material
        };
    parts->list[i].mixed |= object->mixed;
    return i;
}

bool mass_parts_find(const struct scene *scene, struct mass_parts *parts)
{
    *parts = (struct mass_parts){ 0 };
    parts->list = calloc(scene->object_count + 1, sizeof *parts->list);
    parts->part_of = calloc(scene->object_count + 1, sizeof *parts->part_of);
    for (size_t i = 0;
         parts->list && parts->part_of && i < scene->object_count; i++) {
        const char *name = object_name(parts, &scene->objects[i]);

        if (!name)
            return false;
        parts->part_of[i] = find_part(parts, &scene->objects[i], name);
    }
    return parts->list && parts->part_of;
}

void mass_parts_free(struct mass_parts *parts)
{
    free(parts->list);
    free(parts->part_of);
    arena_free(&parts->kept);
}

/* ---- Which has which ----------------------------------------------------- */

/* Lists that are too long for a message end in dots. */
static void add_name(c205_error *error, const char *separator,
                     const char *name)
{
    size_t used = strlen(error->message), room = sizeof error->message;

    if (used + strlen(separator) + strlen(name) + 5 < room)
        snprintf(error->message + used, room - used, "%s%s", separator, name);
    else if (used + 4 < room && strcmp(error->message + used - 3, "..."))
        snprintf(error->message + used, room - used, "...");
}

static bool is_there(const struct mass_parts *parts, const char *name)
{
    for (size_t i = 0; i < parts->count; i++)
        if (same_text(parts->list[i].name, name)
            || same_text(parts->list[i].material, name))
            return true;
    return false;
}

static bool name_is_new(const struct mass_parts *parts, size_t i,
                        const char *name, bool material)
{
    for (size_t k = 0; k < i; k++)
        if (same_text(material ? parts->list[k].material
                               : parts->list[k].name,
                      name))
            return false;
    return name;
}

/* The names of all parts, or of all materials, once each. */
static void add_names(const struct mass_parts *parts, bool material,
                      const char *separator, c205_error *error)
{
    for (size_t i = 0; i < parts->count; i++) {
        const struct mass_part *part = &parts->list[i];
        const char *name = material ? part->material : part->name;

        if (!name_is_new(parts, i, name, material))
            continue;
        add_name(error, separator, name);
        separator = ", ";
    }
}

static bool check_name(const struct mass_parts *parts, const char *name,
                       c205_error *error)
{
    if (is_there(parts, name))
        return true;
    error_say(error, "no part and no material is called '%.60s'", name);
    add_names(parts, false, "; parts: ", error);
    add_names(parts, true, "; materials: ", error);
    return false;
}

bool mass_parts_check(const struct mass_parts *parts,
                      const struct densities *densities, size_t given,
                      c205_error *error)
{
    for (size_t i = 0; i < given; i++)
        if (!check_name(parts, densities->list[i].name, error))
            return false;
    return true;
}

bool mass_parts_choose(struct mass_parts *parts, const char *const *names,
                       size_t count, c205_error *error)
{
    for (size_t i = 0; i < parts->count; i++)
        parts->list[i].left_out = count > 0 || parts->list[i].endless;
    for (size_t k = 0; k < count; k++) {
        if (!check_name(parts, names[k], error))
            return false;
        for (size_t i = 0; i < parts->count; i++)
            if (same_text(parts->list[i].name, names[k])
                || same_text(parts->list[i].material, names[k]))
                parts->list[i].left_out = false;
    }
    return true;
}

/* 0: it is not given. */
static double density_of(const struct densities *densities, const char *name)
{
    for (size_t i = 0; name && i < densities->count; i++)
        if (strcmp(densities->list[i].name, name) == 0)
            return densities->list[i].value;
    return 0;
}

static void weigh(struct mass_part *part, const struct densities *densities)
{
    part->density = density_of(densities, part->name);
    if (part->density == 0 && !part->mixed)
        part->density = density_of(densities, part->material);
    if (part->density == 0)
        part->density = densities->others;
}

bool mass_parts_weigh(struct mass_parts *parts,
                      const struct densities *densities, c205_error *error)
{
    const char *separator = ": ";
    bool good = true;

    error_say(error, "no density is known of");
    for (size_t i = 0; i < parts->count; i++) {
        struct mass_part *part = &parts->list[i];

        weigh(part, densities);
        if (part->density > 0 || part->left_out)
            continue;
        good = false;
        add_name(error, separator, part->name);
        separator = ", ";
        if (part->mixed)
            add_name(error, " ", "(of several materials)");
    }
    if (!good)
        add_name(error, "; ", "--density NAME=VALUE, or --density default=1");
    return good;
}
