#include "rt/fit/written.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/whole.h"

/* The model of the observations with whose name that of the file begins. */
static const c205_model *model_for(const struct study *study,
                                   const char *path, c205_error *error)
{
    const struct observations *all = study->fit.observations;
    const char *slash = strrchr(path, '/');
    const char *file = slash != NULL ? slash + 1 : path;

    for (size_t i = 0; i < all->model_count; i++) {
        const char *name = c205_model_name(all->models[i]);

        if (strncmp(file, name, strlen(name)) == 0)
            return all->models[i];
    }
    snprintf(error->message, sizeof error->message,
             "%.150s does not begin with the name of a model", file);
    return NULL;
}

/* The largest of the errors of what was fitted, and their mean square. */
static size_t find_worst(const struct study *study, double *mean)
{
    const struct observations *all = study->fit.observations;
    double worst = 0, sum = 0;
    size_t which = 0;

    for (size_t i = 0; i < all->count; i++) {
        double error = fit_error(&all->items[i], study->best.predicted[i]);

        if (!study_is_fitted(study, i))
            continue;
        sum += error * error;
        if (fabs(error) >= worst) {
            worst = fabs(error);
            which = i;
        }
    }
    *mean = sqrt(sum / (double)study->best.used);
    return which;
}

static void write_head(const struct study *study, const c205_model *model,
                       FILE *file)
{
    const struct observations *all = study->fit.observations;
    double mean;
    size_t worst = find_worst(study, &mean);

    fprintf(file, "title %s, fitted\n", c205_model_title(model));
    fprintf(file,
            "# Written by fit205 (docs/timing.md): fitted to %zu observations "
            "with\n# %zu free constants.  Cost %.2f; root mean square of the "
            "errors %.1f %%,\n# the largest %+.1f %%: %s.\n",
            study->best.used, study->fit.constants->count, study->best.cost,
            100 * mean,
            100 * fit_error(&all->items[worst],
                            study->best.predicted[worst]),
            all->items[worst].name);
    for (size_t i = 0; i < all->count; i++)
        if (study_is_fitted(study, i))
            fprintf(file, "#   %-16s %10.4f %-12s %+6.1f %%\n",
                    all->items[i].name, all->items[i].value,
                    all->items[i].unit,
                    100 * fit_error(&all->items[i],
                                    study->best.predicted[i]));
    fprintf(file, "like %s\n", c205_model_name(model));
}

static void write_member(const struct free_constant *constant, size_t member,
                         double place, const c205_model *model, FILE *file)
{
    const c205_constant *prior =
        c205_model_lookup(model, constant->members[member].name);
    double value = prior->value * constant_value(constant, place)
                   / constant->prior;
    bool whole = strcmp(prior->unit, "clk") == 0;

    fprintf(file, "%-22s %-8.*f %-16s  F  # prior %s %c\n", prior->name,
            whole ? 0 : 4, value, prior->unit, prior->text, prior->source);
}

bool written_model(const struct study *study, const char *path,
                   c205_error *error)
{
    const struct constants *constants = study->fit.constants;
    const c205_model *model = model_for(study, path, error);
    struct whole *whole = model == NULL ? NULL : whole_open(path, error);

    if (whole == NULL)
        return false;
    write_head(study, model, whole->file);
    for (size_t i = 0; i < constants->count; i++) {
        const struct free_constant *constant = &constants->items[i];

        for (size_t k = 0; constant_is_of(constant, model)
                           && k < constant->member_count;
             k++)
            write_member(constant, k, study->best.places[i], model,
                         whole->file);
    }
    return whole_commit(whole, error);
}

/* Clocks of all programs of a model, with another in its place. */
static bool time_with(const struct observations *all, const c205_model *old,
                      const c205_model *model,
                      double (*clocks)[RUN_REGIONS_MOST], c205_error *error)
{
    for (size_t i = 0; i < all->timing_count; i++)
        if (all->timings[i].model == old
            && !run_time(all->timings[i].run, model, NULL, 0, clocks[i],
                         error))
            return false;
    return true;
}

bool written_predict(const struct study *study, const char *path,
                     double predicted[FIT_OBSERVATIONS_MOST],
                     c205_error *error)
{
    const struct observations *all = study->fit.observations;
    const c205_model *old = model_for(study, path, error);
    c205_model *model = old == NULL ? NULL : c205_model_find(path, error);
    double (*clocks)[RUN_REGIONS_MOST] = calloc(all->timing_count,
                                                sizeof *clocks);
    bool good = model != NULL && clocks != NULL
                && time_with(all, old, model, clocks, error);

    for (size_t i = 0; good && i < all->count; i++) {
        const struct observation *item = &all->items[i];
        bool its = strcmp(item->machine, c205_model_name(old)) == 0;

        predicted[i] = its ? observation_predict(all, item, clocks) : NAN;
    }
    free(clocks);
    c205_model_free(model);
    return good;
}
