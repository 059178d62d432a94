/* observations.c - reads observations, and predicts them from clocks. */
#include "rt/study/fit/observations.h"

#include "base/array.h"
#include "vm/error.h"
#include "base/named_model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME, PROGRAM, MACHINE, VALUE, UNIT, UNCERTAINTY, SHARED, SOURCE, USE, FIELDS };
static const char *const columns[FIELDS] = { "name",   "program", "machine",
                                             "value",  "unit",    "uncertainty",
                                             "shared", "source",  "use" };

enum { MAX_TEXT = 128 };

static bool observations_fail(c205_error *error, const char *what, const char *name)
{
    return error_set(error, what, name);
}

/* ---- Runs, models and timings: one of each ------------------------------ */

static const struct fit_run *find_run(struct observations *all, const char *program,
                                      const struct run_options *options,
                                      c205_error *error)
{
    struct fit_run **added;
    for (size_t i = 0; i < all->run_count; i++)
        if (strcmp(all->runs[i]->program, program) == 0)
            return all->runs[i];
    observations_fail(error, "%s", "out of memory");
    added = array_add(&all->runs, &all->run_count, NULL, sizeof *added);
    if (!added)
        return NULL;
    *added = run_new(program, options, error);
    all->run_count -= !*added;
    return *added;
}

/* Sets the name to MACHINE-prior, the model before any fit, if there is such a model.
 * Otherwise sets it to the machine. */
static void name_prior(const char *machine, char name[MAX_TEXT])
{
    const char *const *names = c205_model_names();
    snprintf(name, MAX_TEXT, "%s" PRIOR_SUFFIX, machine);
    while (*names && strcmp(*names, name) != 0)
        names++;
    if (!*names)
        snprintf(name, MAX_TEXT, "%s", machine);
}

static const c205_model *find_model(struct observations *all, const char *machine,
                                    c205_error *error)
{
    char name[MAX_TEXT];
    c205_model **added;
    name_prior(machine, name);
    for (size_t i = 0; i < all->model_count; i++)
        if (strcmp(c205_model_name(all->models[i]), name) == 0)
            return all->models[i];
    observations_fail(error, "%s", "out of memory");
    added = array_add(&all->models, &all->model_count, NULL, sizeof *added);
    if (!added)
        return NULL;
    *added = model_find(name, error);
    all->model_count -= !*added;
    return *added;
}

static bool find_timing(struct observations *all, const struct fit_run *run,
                        const c205_model *model, size_t *found, c205_error *error)
{
    struct run_timing timing = { run, model };
    for (*found = 0; *found < all->timing_count; ++*found)
        if (all->timings[*found].run == run && all->timings[*found].model == model)
            return true;
    return array_add(&all->timings, &all->timing_count, &timing, sizeof timing)
           || observations_fail(error, "%s", "out of memory");
}

/* ---- Terms -------------------------------------------------------------- */

/* Splits "A/B". Without a slash, the second part is empty. */
static void split(char *text, const char **second)
{
    char *slash = strchr(text, '/');
    *second = "";
    if (slash) {
        *slash = '\0';
        *second = slash + 1;
    }
}

/* Moves ":REGIONS" from a program's name to another string. */
static void take_regions(const char *text, char program[MAX_TEXT],
                         char regions[MAX_TEXT])
{
    const char *colon = strchr(text, ':');
    size_t begin = !colon ? strlen(text) : (size_t)(colon - text);
    size_t length = !colon ? 0 : strcspn(colon, " ");
    snprintf(program, MAX_TEXT, "%.*s%s", (int)begin, text, text + begin + length);
    snprintf(regions, MAX_TEXT, "%.*s", length > 0 ? (int)length - 1 : 0,
             text + begin + (length > 0));
}

static bool add_term(struct observations *all, struct observation *item,
                     const struct fit_run *run, const char *region, const char *machine,
                     c205_error *error)
{
    struct term *term = &item->terms[item->term_count++];
    const c205_model *model = find_model(all, machine, error);
    return model && find_timing(all, run, model, &term->timing, error)
           && run_select(run, region, term->chosen, error);
}

static bool add_terms(struct observations *all, struct observation *item,
                      const struct run_options *options, c205_error *error)
{
    const struct fit_run *run;
    char program[MAX_TEXT], regions[MAX_TEXT], machines[MAX_TEXT];
    const char *region, *machine;
    bool share = strcmp(item->unit, "%") == 0;
    take_regions(item->program, program, regions);
    snprintf(machines, sizeof machines, "%s", item->machine);
    split(regions, &region);
    split(machines, &machine);
    run = find_run(all, program, options, error);
    if (!run || !add_term(all, item, run, regions, machines, error))
        return false;
    if (*region == '\0' && *machine == '\0' && !share)
        return true;
    return add_term(all, item, run, *machine != '\0' ? regions : region,
                    *machine != '\0' ? machine : machines, error);
}

/* The quantity that a unit refers to: a constant of the program, the number of its
 * rays, or the clock period of the machine. */
enum counted { COUNTED_SYMBOL, COUNTED_RAYS, COUNTED_PERIOD, COUNTED_NOTHING };

static const struct unit {
    const char *name;
    enum counted by;
    const char *symbol;
    bool rate;
    double factor;
} units[] = {
    { "s/100000", COUNTED_RAYS, NULL, false, 1e5 },
    { "clk", COUNTED_PERIOD, NULL, false, 1e9 },
    { "ns/TIMES", COUNTED_SYMBOL, "TIMES", false, 1e9 },
    { "Mflop/s", COUNTED_SYMBOL, "FLOPS", true, 1e-6 },
    { "Melements/s", COUNTED_SYMBOL, "ELEMENTS", true, 1e-6 },
    { "%", COUNTED_NOTHING, NULL, false, 100 },
    { "ratio", COUNTED_NOTHING, NULL, false, 1 },
};

/* Finds the number to which a unit such as s/100000 or Mflop/s refers: the value of a
 * symbol of the program, the number of rays, or the clock period; otherwise 1. */
static bool find_count(const struct run_timing *timing, const struct unit *unit,
                       double *count, c205_error *error)
{
    *count = 1;
    switch (unit->by) {
    case COUNTED_SYMBOL:
        return run_symbol(timing->run, unit->symbol, count)
               || observations_fail(error, "the program does not define %s",
                                    unit->symbol);
    case COUNTED_RAYS:
        *count = (double)timing->run->rays;
        return *count > 0
               || observations_fail(error, "%s has no rays", timing->run->program);
    case COUNTED_PERIOD:
        *count = c205_model_lookup(timing->model, "clock.period")->value;
        break;
    case COUNTED_NOTHING: break;
    }
    return true;
}

static bool set_unit(const struct observations *all, struct observation *item,
                     c205_error *error)
{
    const struct run_timing *timing = &all->timings[item->terms[0].timing];
    size_t i = 0;
    double count;
    while (i < sizeof units / sizeof *units && strcmp(units[i].name, item->unit) != 0)
        i++;
    if (i == sizeof units / sizeof *units)
        return observations_fail(error, "unknown unit '%.60s'", item->unit);
    if (!find_count(timing, &units[i], &count, error))
        return false;
    item->rate = units[i].rate;
    item->factor = units[i].rate ? units[i].factor * count : units[i].factor / count;
    return true;
}

/* ---- Reading ------------------------------------------------------------ */

static bool read_use(const struct csv *file, const struct csv_row *row,
                     enum observation_use *use, struct diagnostics *diagnostics)
{
    static const char *const uses[OBSERVATION_USES] = { "fit", "compare", "range" };
    int i = 0;
    while (i < OBSERVATION_USES && strcmp(uses[i], row->fields[USE]) != 0)
        i++;
    *use = (enum observation_use)i;
    return i < OBSERVATION_USES
           || csv_wrong(file, row, USE, "expected fit, compare or range", diagnostics);
}

/* Reads a range such as "15 to 18", or a single number. */
static bool read_range(const struct csv *file, const struct csv_row *row,
                       struct observation *item, struct diagnostics *diagnostics)
{
    static const char between[] = " to ";
    char *end;
    item->least = item->most = strtod(row->fields[VALUE], &end);
    if (strncmp(end, between, strlen(between)) == 0)
        item->most = strtod(end + strlen(between), &end);
    item->value = (item->least + item->most) / 2;
    return (*end == '\0' && item->least > 0 && item->most >= item->least)
           || csv_wrong(file, row, VALUE, "expected a positive number, or MIN to MAX",
                        diagnostics);
}

static bool read_figure(const struct csv *file, const struct csv_row *row,
                        struct observation *item, struct diagnostics *diagnostics)
{
    if (item->use == OBSERVATION_RANGE)
        return read_range(file, row, item, diagnostics);
    if (!csv_positive(file, row, VALUE, &item->value, diagnostics))
        return false;
    item->least = item->most = item->value;
    return csv_positive(file, row, UNCERTAINTY, &item->uncertainty, diagnostics)
           && (*row->fields[SHARED] == '\0'
               || csv_positive(file, row, SHARED, &item->shared, diagnostics));
}

static bool read_row(struct observations *all, const struct csv *file,
                     const struct csv_row *row, const struct run_options *options,
                     struct diagnostics *diagnostics)
{
    c205_error error;
    struct observation *item = array_add(&all->items, &all->count, NULL, sizeof *item);
    if (!item)
        return csv_wrong(file, row, NAME, "out of memory", diagnostics);
    *item = (struct observation){ .name = row->fields[NAME],
                                  .program = row->fields[PROGRAM],
                                  .machine = row->fields[MACHINE],
                                  .unit = row->fields[UNIT],
                                  .source = row->fields[SOURCE] };
    return read_use(file, row, &item->use, diagnostics)
           && read_figure(file, row, item, diagnostics)
           && (add_terms(all, item, options, &error)
               || csv_wrong(file, row, PROGRAM, error.message, diagnostics))
           && (set_unit(all, item, &error)
               || csv_wrong(file, row, UNIT, error.message, diagnostics));
}

bool observations_read(struct observations *all, const char *path,
                       const struct run_options *options,
                       struct diagnostics *diagnostics)
{
    struct csv *file = array_add(&all->files, &all->file_count, NULL, sizeof *file);
    bool good = true;
    if (!file) {
        const struct position whole = { .file = path };
        diagnostics_add(diagnostics, SEVERITY_ERROR, &whole, "out of memory");
        return false;
    }
    if (!csv_read(file, path, columns, FIELDS, diagnostics))
        return false;
    for (size_t i = 0; i < file->count; i++)
        good = read_row(all, file, &file->rows[i], options, diagnostics) && good;
    return good;
}

void observations_free(struct observations *all)
{
    for (size_t i = 0; i < all->run_count; i++)
        run_free(all->runs[i]);
    for (size_t i = 0; i < all->model_count; i++)
        c205_model_free(all->models[i]);
    for (size_t i = 0; i < all->file_count; i++)
        csv_free(&all->files[i]);
    free(all->runs);
    free(all->models);
    free(all->files);
    free(all->timings);
    free(all->items);
    *all = (struct observations){ 0 };
}

static double seconds(const struct observations *all, const struct term *term,
                      double (*clocks)[MAX_RUN_REGIONS])
{
    const struct run_timing *timing = &all->timings[term->timing];
    double sum = 0;
    for (size_t i = 0; i < timing->run->region_count; i++)
        if (term->chosen[i])
            sum += clocks[term->timing][i];
    return 1e-9 * sum * c205_model_lookup(timing->model, "clock.period")->value;
}

size_t observation_group(const struct observation *observation)
{
    const char *comma = strchr(observation->name, ',');
    const char *last = comma ? comma : strrchr(observation->name, ' ');
    return !last ? strlen(observation->name) : (size_t)(last - observation->name);
}

bool observation_same_group(const struct observation *one,
                            const struct observation *other)
{
    size_t length = observation_group(one);
    return length == observation_group(other)
           && strncmp(one->name, other->name, length) == 0;
}

double observation_uncertainty(const struct observation *observation)
{
    return sqrt(observation->uncertainty * observation->uncertainty
                + observation->shared * observation->shared);
}

double observation_predict(const struct observations *all,
                           const struct observation *item,
                           double (*clocks)[MAX_RUN_REGIONS])
{
    double time = seconds(all, &item->terms[0], clocks);
    if (item->term_count == 2)
        time /= seconds(all, &item->terms[1], clocks);
    return item->rate ? item->factor / time : item->factor * time;
}
