/* constants.c - reads the constants that the fit may change. */
#include "rt/study/fit/constants.h"
#include "vm/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME, MACHINE, MEMBERS, SOURCE, MIN, MAX, WHY, FIELDS };
static const char *const columns[FIELDS] = { "name",  "machine", "constants", "source",
                                             "least", "most",    "why" };

/* The relative width of a prior depends on its source. */
static const struct {
    char source;
    double width;
} widths[] = { { 'P', .02 }, { 'D', .05 }, { 'S', .1 }, { 'R', .4 } };

/* For each machine, the model that contains its priors. */
static const struct {
    const char *machine, *model;
} priors[] = {
    { "cyber205", "cyber205-2pipe-prior" },
    { "cyber720", "cyber720-prior" },
    { "cdc6600", "cdc6600" },
};

static bool constants_fail(c205_error *error, const char *what, const char *name)
{
    return error_set(error, what, name);
}

static bool add_member(struct free_constant *constant, const char *name, size_t length,
                       const c205_model *model, c205_error *error)
{
    size_t i = constant->member_count;
    const c205_constant *found;
    if (i == MAX_MEMBERS)
        return constants_fail(error,
                              "%s has more than " LIMIT_TEXT(MAX_MEMBERS) " members",
                              constant->name);
    snprintf(constant->members[i].name, sizeof constant->members[i].name, "%.*s",
             (int)length, name);
    found = c205_model_lookup(model, constant->members[i].name);
    if (!found)
        return constants_fail(error, "unknown constant '%s'",
                              constant->members[i].name);
    constant->members[i].prior = found->value;
    if (i == 0) {
        constant->prior = found->value;
        constant->unit = found->unit;
    }
    constant->member_count++;
    return true;
}

static bool add_members(struct free_constant *constant, const char *names,
                        const c205_model *model, c205_error *error)
{
    for (size_t length; *names != '\0'; names += length) {
        names += strspn(names, " ");
        length = strcspn(names, " ");
        if (!add_member(constant, names, length, model, error))
            return false;
    }
    return constant->member_count > 0
           || constants_fail(error, "%s has no members", constant->name);
}

static bool set_width(struct free_constant *constant, const char *source,
                      c205_error *error)
{
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++)
        if (source[0] == widths[i].source && source[1] == '\0') {
            constant->source = widths[i].source;
            constant->width = widths[i].width;
            return true;
        }
    return constants_fail(error, "unknown source '%.20s'", source);
}

const c205_model *constants_prior(const struct constants *constants,
                                  const char *machine)
{
    for (size_t i = 0; i < FREE_MACHINES; i++)
        if (strcmp(priors[i].machine, machine) == 0)
            return constants->priors[i];
    return NULL;
}

static bool read_row(struct constants *constants, const struct csv_row *row,
                     struct diagnostics *diagnostics)
{
    const struct csv *file = &constants->file;
    struct free_constant *constant = &constants->items[constants->count];
    c205_error error;
    const c205_model *prior = constants_prior(constants, row->fields[MACHINE]);
    if (!prior)
        return csv_wrong(file, row, MACHINE, "this machine has no priors", diagnostics);
    if (constants->count == MAX_FREE)
        return csv_wrong(file, row, NAME,
                         "more than " LIMIT_TEXT(MAX_FREE) " constants", diagnostics);
    constants->count++;
    constant->name = row->fields[NAME];
    constant->machine = row->fields[MACHINE];
    return csv_positive(file, row, MIN, &constant->least, diagnostics)
           && csv_positive(file, row, MAX, &constant->most, diagnostics)
           && (set_width(constant, row->fields[SOURCE], &error)
               || csv_wrong(file, row, SOURCE, error.message, diagnostics))
           && (add_members(constant, row->fields[MEMBERS], prior, &error)
               || csv_wrong(file, row, MEMBERS, error.message, diagnostics));
}

bool constants_read(struct constants *constants, const char *path,
                    struct diagnostics *diagnostics)
{
    const struct position whole = { .file = path };
    c205_error error;
    bool good = true;
    memset(constants, 0, sizeof *constants);
    for (size_t i = 0; i < FREE_MACHINES; i++) {
        constants->priors[i] = c205_model_find(priors[i].model, &error);
        if (!constants->priors[i]) {
            diagnostics_add(diagnostics, SEVERITY_ERROR, &whole, error.message);
            return false;
        }
    }
    if (!csv_read(&constants->file, path, columns, FIELDS, diagnostics))
        return false;
    for (size_t i = 0; i < constants->file.count; i++)
        good = read_row(constants, &constants->file.rows[i], diagnostics) && good;
    if (good && constants->count == 0)
        diagnostics_add(diagnostics, SEVERITY_ERROR, &whole,
                        "the file has no constants");
    return good && constants->count > 0;
}

void constants_free(struct constants *constants)
{
    csv_free(&constants->file);
    for (size_t i = 0; i < FREE_MACHINES; i++)
        c205_model_free(constants->priors[i]);
}

static double factor_at(const struct free_constant *constant, double place)
{
    return 1 + constant->width * place;
}

double constant_value(const struct free_constant *constant, double place)
{
    return constant->prior * factor_at(constant, place);
}

double constant_place(const struct free_constant *constant, double value)
{
    return (value / constant->prior - 1) / constant->width;
}

bool model_is_of(const c205_model *model, const char *machine, size_t length)
{
    while (model && strncmp(c205_model_name(model), machine, length) != 0)
        model = c205_model_like(model);
    return model != NULL;
}

bool constant_is_of(const struct free_constant *constant, const c205_model *model)
{
    return model_is_of(model, constant->machine, strlen(constant->machine));
}

size_t constants_settings(const struct constants *constants, const double *places,
                          const c205_model *model, c205_setting settings[MAX_SETTINGS])
{
    size_t count = 0;
    for (size_t i = 0; i < constants->count; i++) {
        const struct free_constant *constant = &constants->items[i];
        double factor = factor_at(constant, places[i]);
        for (size_t k = 0;
             constant_is_of(constant, model) && k < constant->member_count; k++)
            settings[count++] = (c205_setting){ constant->members[k].name,
                                                constant->members[k].prior * factor };
    }
    return count;
}
