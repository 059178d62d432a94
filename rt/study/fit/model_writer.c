/* model_writer.c - writes a fitted model to a file. */
#include "rt/study/fit/model_writer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/atomic_file.h"
#include "vm/error.h"

/* ---- The constants ------------------------------------------------------ */

/* Returns the model NAME-prior that contains the priors for a file NAME.model. */
static const c205_model *prior_of(const struct observations *all, const char *path,
                                  c205_error *error)
{
    const char *slash = strrchr(path, '/');
    const char *file = slash ? slash + 1 : path;
    size_t length = strcspn(file, ".");
    if (strcmp(file + length, ".model") != 0) {
        error_set(error, "%.100s: the name of a model file must end in .model", path);
        return NULL;
    }
    for (size_t i = 0; i < all->model_count; i++) {
        const char *name = c205_model_name(all->models[i]);
        if (strncmp(file, name, length) == 0
            && strcmp(name + length, PRIOR_SUFFIX) == 0)
            return all->models[i];
    }
    error_set(error,
              "%.100s: expected NAME.model, with priors in the model NAME" PRIOR_SUFFIX,
              path);
    return NULL;
}

static int decimals(const c205_constant *prior)
{
    return strcmp(prior->unit, "clk") == 0 ? 0 : 4;
}

/* Lists the free constants of a model with the values in its file, which are rounded.
 * Returns the number of constants. */
static size_t written_settings(const struct study *study, const c205_model *model,
                               c205_setting settings[MAX_SETTINGS])
{
    size_t count = constants_settings(study->fit.constants, study->best.places, model,
                                      settings);
    for (size_t i = 0; i < count; i++) {
        char text[64];
        snprintf(text, sizeof text, "%.*f",
                 decimals(c205_model_lookup(model, settings[i].name)),
                 settings[i].value);
        settings[i].value = strtod(text, NULL);
    }
    return count;
}

static bool time_all(const struct study *study, double (*clocks)[MAX_RUN_REGIONS],
                     c205_error *error)
{
    const struct observations *all = study->fit.observations;
    c205_setting settings[MAX_SETTINGS];
    bool good = true;
    for (size_t i = 0; good && i < all->timing_count; i++) {
        const struct run_timing *timing = &all->timings[i];
        size_t count = written_settings(study, timing->model, settings);
        good = run_time(timing->run, timing->model, settings, count, RUN_WHOLE,
                        clocks[i], error);
    }
    return good;
}

bool written_predict(const struct study *study, double predicted[MAX_FIT_OBSERVATIONS],
                     c205_error *error)
{
    const struct observations *all = study->fit.observations;
    double(*clocks)[MAX_RUN_REGIONS] = calloc(all->timing_count, sizeof *clocks);
    bool good = clocks != NULL;

    if (!good)
        error_set(error, "out of memory");
    good = good && time_all(study, clocks, error);
    for (size_t i = 0; good && i < all->count; i++)
        predicted[i] = observation_predict(all, &all->items[i], clocks);
    free(clocks);
    return good;
}

/* ---- The file ----------------------------------------------------------- */

bool written_check(const struct study *study, const char *path, c205_error *error)
{
    return prior_of(study->fit.observations, path, error) != NULL
           && atomic_file_check(path, error);
}

/* Returns the length of the machine's name within a model's name, such as "cyber205" in
 * "cyber205-2pipe". */
static size_t machine_length(const char *name)
{
    return strcspn(name, "-");
}

/* Returns true if the machine of an observation is the machine of the model or a
 * variant of it. */
static bool is_of(const struct observations *all, const struct observation *item,
                  const c205_model *model)
{
    const char *name = c205_model_name(model);
    for (size_t i = 0; i < item->term_count; i++) {
        size_t timing = item->terms[i].timing;
        if (model_is_of(all->timings[timing].model, name, machine_length(name) + 1))
            return true;
    }
    return false;
}

/* Writes "KEYWORD N figures, at most E % off: NAME", which is a line of model files. */
static void write_belief(const struct study *study, const c205_model *model,
                         const double *predicted, bool fitted, FILE *file)
{
    const struct observations *all = study->fit.observations;
    size_t figures = 0;
    double largest = 0;
    const char *worst = "";
    for (size_t i = 0; i < all->count; i++) {
        const struct observation *item = &all->items[i];
        double error = 100 * fit_error(item, predicted[i]);
        if (study_is_fitted(study, i) != fitted || item->use == OBSERVATION_RANGE
            || !is_of(all, item, model))
            continue;
        figures++;
        if (fabs(error) >= fabs(largest)) {
            largest = error;
            worst = item->name;
        }
    }
    if (figures > 0)
        fprintf(file, "%s %zu figures, at most %.1f %% off: %s\n",
                fitted ? "fitted" : "compared", figures, largest, worst);
}

static void write_model_head(const struct study *study, const c205_model *model,
                             const double *predicted, FILE *file)
{
    const struct observations *all = study->fit.observations;
    const char *title = c205_model_title(model);
    fprintf(file, "title %.*s: fitted\n", (int)strcspn(title, ":"), title);
    write_belief(study, model, predicted, true, file);
    write_belief(study, model, predicted, false, file);
    fprintf(file,
            "# Written by fit205 (docs/timing.md): %zu observations, %zu free "
            "constants,\n# cost %.2f.\n",
            study->best.used, study->fit.constants->count, study->best.cost);
    for (size_t i = 0; i < all->count; i++)
        if (is_of(all, &all->items[i], model) && all->items[i].use != OBSERVATION_RANGE)
            fprintf(file, "#   %-16s %10.4f %-12s %+6.1f %%%s\n", all->items[i].name,
                    all->items[i].value, all->items[i].unit,
                    100 * fit_error(&all->items[i], predicted[i]),
                    study_is_fitted(study, i) ? "" : "  (not fitted)");
    fprintf(file, "like %s\n", c205_model_name(model));
}

static void write_setting(const c205_setting *setting, const c205_model *model,
                          FILE *file)
{
    const c205_constant *prior = c205_model_lookup(model, setting->name);
    fprintf(file, "%-22s %-8.*f %-16s  F  # prior %s %c\n", prior->name,
            decimals(prior), setting->value, prior->unit, prior->text, prior->source);
}

bool written_model(const struct study *study,
                   const double predicted[MAX_FIT_OBSERVATIONS], const char *path,
                   c205_error *error)
{
    const c205_model *model = prior_of(study->fit.observations, path, error);
    struct atomic_file *whole = !model ? NULL : atomic_file_open(path, error);
    c205_setting settings[MAX_SETTINGS];
    size_t count;
    if (!whole)
        return false;
    write_model_head(study, model, predicted, whole->file);
    count = written_settings(study, model, settings);
    for (size_t i = 0; i < count; i++)
        write_setting(&settings[i], model, whole->file);
    return atomic_file_commit(whole, error);
}
