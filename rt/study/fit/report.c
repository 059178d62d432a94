#include "rt/study/fit/report.h"

#include <math.h>
#include <string.h>

#include "base/provenance.h"

static const struct table_column observed[] = {
    { "name", "observation", TABLE_TEXT, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
    { "observed", "observed", TABLE_NUMBER, 4 },
    { "uncertainty", "+- %", TABLE_NUMBER, 0 },
    { "prior_error", "by priors %", TABLE_NUMBER, 1 },
    { "predicted", "predicted", TABLE_NUMBER, 4 },
    { "error", "error %", TABLE_NUMBER, 1 },
    { "residual", "by +-", TABLE_NUMBER, 1 },
    { "written_error", "written %", TABLE_NUMBER, 1 },
};

static const struct table_column speedups[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "of", "205 vector against", TABLE_TEXT, 0 },
    { "observed", "observed", TABLE_NUMBER, 2 },
    { "predicted", "predicted", TABLE_NUMBER, 2 },
    { "error", "error %", TABLE_NUMBER, 1 },
};

static const struct table_column constants[] = {
    { "name", "constant", TABLE_TEXT, 0 },
    { "first", "value of", TABLE_TEXT, 0 },
    { "source", "src", TABLE_TEXT, 0 },
    { "prior", "prior", TABLE_NUMBER, 2 },
    { "width", "+-", TABLE_NUMBER, 2 },
    { "least", "least", TABLE_NUMBER, 1 },
    { "most", "most", TABLE_NUMBER, 1 },
    { "fitted", "fitted", TABLE_NUMBER, 2 },
    { "standard_error", "error", TABLE_NUMBER, 2 },
    { "shift", "shift", TABLE_NUMBER, 2 },
    { "known", "known", TABLE_NUMBER, 0 },
    { "moved", "moved", TABLE_TEXT, 0 },
};

static const struct table_column left_out[] = {
    { "name", "row", TABLE_TEXT, 0 },
    { "observed", "observed", TABLE_NUMBER, 4 },
    { "error", "error % in the fit", TABLE_NUMBER, 1 },
    { "predicted", "left out: predicted", TABLE_NUMBER, 4 },
    { "left_out_error", "error %", TABLE_NUMBER, 1 },
};

static const struct table_column doubled[] = {
    { "name", "constant", TABLE_TEXT, 0 },
    { "fitted", "fitted", TABLE_NUMBER, 2 },
    { "wide", "width doubled", TABLE_NUMBER, 2 },
    { "wide_cost", "cost", TABLE_NUMBER, 2 },
    { "moved", "prior doubled", TABLE_NUMBER, 2 },
    { "moved_cost", "cost", TABLE_NUMBER, 2 },
    { "row", "row that changes most", TABLE_TEXT, 0 },
    { "change", "by %", TABLE_NUMBER, 1 },
};

static const struct table_column missing[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "scalar", "205 scalar", TABLE_NUMBER, 2 },
    { "vector", "205 vector", TABLE_NUMBER, 2 },
    { "projected", "720", TABLE_NUMBER, 2 },
};

/* ---- Observations ------------------------------------------------------- */

static void add_observation(const struct study *study, size_t i,
                            const double *written, struct table *table)
{
    const struct observation *item = &study->fit.observations->items[i];
    double error = fit_error(item, study->best.predicted[i]);

    table_text(table, item->name);
    table_text(table, item->unit);
    table_number(table, item->value);
    table_number(table, 100 * item->uncertainty);
    table_number(table, 100 * fit_error(item, study->at_prior[i]));
    table_number(table, study->best.predicted[i]);
    table_number(table, 100 * error);
    table_number(table, error / item->uncertainty);
    table_number(table, 100 * fit_error(item, written[i]));
}

static void fill_fitted(const struct study *study, const double *written,
                        struct table *table)
{
    for (size_t i = 0; i < study->fit.observations->count; i++)
        if (study_is_fitted(study, i))
            add_observation(study, i, written, table);
}

static void fill_held(const struct study *study, const double *written,
                      struct table *table)
{
    for (size_t i = 0; i < study->fit.observations->count; i++)
        if (!study_is_fitted(study, i))
            add_observation(study, i, written, table);
}

/* ---- Table 1, primitive by primitive ------------------------------------ */

static void add_speedup(const struct study *study,
                        const struct speedup_subject *subject, bool other,
                        struct table *table)
{
    double told, ratio = study_speedup(study, subject, other, &told);

    table_text(table, subject->name);
    table_text(table, other ? speedup_projections[0] : "205 scalar");
    table_number(table, told);
    table_number(table, ratio);
    table_number(table, 100 * (ratio / told - 1));
}

static void fill_speedups(const struct study *study, const double *written,
                          struct table *table)
{
    (void)written;
    for (size_t i = 0; i < study->subject_count; i++) {
        add_speedup(study, study->subjects[i], false, table);
        add_speedup(study, study->subjects[i], true, table);
    }
}

static double missing_factor(const struct study *study,
                             const struct speedup_subject *subject,
                             enum trace_mode mode, const char *machine)
{
    const struct observations *all = study->fit.observations;
    size_t i = study_row(study, subject, mode, machine);

    return i == all->count ? NAN
                           : all->items[i].value / study->best.predicted[i];
}

static void fill_missing(const struct study *study, const double *written,
                         struct table *table)
{
    (void)written;
    for (size_t i = 0; i < study->subject_count; i++) {
        const struct speedup_subject *subject = study->subjects[i];

        table_text(table, subject->name);
        table_number(table, missing_factor(study, subject, TRACE_SCALAR,
                                           "cyber205"));
        table_number(table, missing_factor(study, subject, TRACE_VECTOR,
                                           "cyber205"));
        table_number(table, missing_factor(study, subject, TRACE_SCALAR,
                                           speedup_projections[0]));
    }
}

/* ---- Constants ---------------------------------------------------------- */

/* Of the certainty about a constant how much comes from the data; and whether
 * they moved it by a tenth of the prior's width at least. */
static void add_constant(const struct study *study, size_t i,
                         struct table *table)
{
    const struct free_constant *constant = &study->fit.constants->items[i];
    const struct fit_outcome *best = &study->best;
    const char source[2] = { constant->source, '\0' };
    double width = constant->prior * constant->width;
    double left = best->raw_errors[i] * best->raw_errors[i];

    table_text(table, constant->name);
    table_text(table, constant->members[0].name);
    table_text(table, source);
    table_number(table, constant->prior);
    table_number(table, width);
    table_number(table, constant->least);
    table_number(table, constant->most);
    table_number(table, constant_value(constant, best->places[i]));
    table_number(table, best->errors[i] * width);
    table_number(table, best->places[i]);
    table_number(table, 100 * fmax(0, 1 - left));
    table_text(table, fabs(best->places[i]) >= .1 ? "yes" : "no");
}

static void fill_constants(const struct study *study, const double *written,
                           struct table *table)
{
    (void)written;
    for (size_t i = 0; i < study->fit.constants->count; i++)
        add_constant(study, i, table);
}

/* ---- The same fit in other ways ----------------------------------------- */

static void fill_left_out(const struct study *study, const double *written,
                          struct table *table)
{
    const struct observations *all = study->fit.observations;

    (void)written;
    for (size_t i = 0; i < all->count; i++) {
        const struct observation *item = &all->items[i];

        if (!study_is_fitted(study, i) || !study_is_row(item))
            continue;
        table_text(table, item->name);
        table_number(table, item->value);
        table_number(table, 100 * fit_error(item, study->best.predicted[i]));
        table_number(table, study->left_out[i]);
        table_number(table, 100 * fit_error(item, study->left_out[i]));
    }
}

/* The fitted observation that another fit shows most otherwise. */
static size_t most_changed(const struct study *study,
                           const struct fit_outcome *other, double *change)
{
    size_t which = 0;

    *change = 0;
    for (size_t i = 0; i < study->fit.observations->count; i++) {
        double here = other->predicted[i] / study->best.predicted[i] - 1;

        if (study_is_fitted(study, i) && fabs(here) > fabs(*change)) {
            *change = here;
            which = i;
        }
    }
    return which;
}

static void fill_doubled(const struct study *study, const double *written,
                         struct table *table)
{
    (void)written;
    for (size_t i = 0; i < study->fit.constants->count; i++) {
        const struct free_constant *constant = &study->fit.constants
                                                    ->items[i];
        double change;
        size_t row = most_changed(study, &study->moved[i], &change);

        table_text(table, constant->name);
        table_number(table, constant_value(constant, study->best.places[i]));
        table_number(table,
                     constant_value(constant, study->wide[i].places[i]));
        table_number(table, study->wide[i].cost);
        table_number(table,
                     constant_value(constant, study->moved[i].places[i]));
        table_number(table, study->moved[i].cost);
        table_text(table, study->fit.observations->items[row].name);
        table_number(table, 100 * change);
    }
}

/* A column for each primitive whose rows were left out. */
static const struct table_column without[] = {
    { "left_out", "rows left out", TABLE_TEXT, 0 },
    { "cost", "cost", TABLE_NUMBER, 2 },
    { "name", "row", TABLE_TEXT, 0 },
    { "error", "error % in the fit", TABLE_NUMBER, 1 },
    { "left_out_error", "error %", TABLE_NUMBER, 1 },
};

static void fill_without(const struct study *study, const double *written,
                         struct table *table)
{
    const struct observations *all = study->fit.observations;

    (void)written;
    for (size_t k = 0; k < study->subject_count; k++)
        for (size_t i = 0; i < all->count; i++) {
            const struct observation *item = &all->items[i];

            if (!study_is_fitted(study, i) || !study_is_row(item))
                continue;
            table_text(table, study->subjects[k]->name);
            table_number(table, study->without[k].cost);
            table_text(table, item->name);
            table_number(table,
                         100 * fit_error(item, study->best.predicted[i]));
            table_number(table,
                         100
                             * fit_error(item,
                                         study->without[k].predicted[i]));
        }
}

/* ---- The whole ---------------------------------------------------------- */

static const struct report_part {
    const char *key, *heading;
    const struct table_column *columns;
    size_t count;
    bool always; /* in a brief report as well */
    void (*fill)(const struct study *study, const double *written,
                 struct table *table);
} parts[] = {
    { "fitted", "What was fitted", TABLE_COLUMNS(observed), true,
      fill_fitted },
    { "held_out", "Only compared, or held out", TABLE_COLUMNS(observed), true,
      fill_held },
    { "speedups", "The speedups of Table 1", TABLE_COLUMNS(speedups), true,
      fill_speedups },
    { "constants", "The free constants", TABLE_COLUMNS(constants), true,
      fill_constants },
    { "missing",
      "Observed by predicted.  Alike on all machines: the program of"
      " 1984 did so much\nmore; in one form alone: that form, or its part of "
      "the model",
      TABLE_COLUMNS(missing), true, fill_missing },
    { "left_out", "Each row of Table 1 left out", TABLE_COLUMNS(left_out),
      false, fill_left_out },
    { "without", "All rows of a primitive left out", TABLE_COLUMNS(without),
      false, fill_without },
    { "doubled", "Priors doubled, in width and in value, one at a time",
      TABLE_COLUMNS(doubled), false, fill_doubled },
};

/* The machine's: what the first observation runs on. */
static const c205_model *fitted_model(const struct study *study)
{
    return study->fit.observations->timings[0].model;
}

static void print_head(const struct study *study,
                       const struct results *results)
{
    const struct fit_outcome *best = &study->best;

    results_say(
        results,
        "%zu observations, %zu free constants; cost %.3f after %d steps, "
        "%s.\n"
        "Residuals: relative errors of the machine's own clocks by their "
        "uncertainty, Cauchy\nloss from %g on; and the constants' "
        "distances from their priors, in widths: P 2 %%,\nD 5 %%, S 10 "
        "%%, R 40 %%.\nCycle-accounted, not cycle-accurate.  Not modelled: "
        "%s.\n",
        best->used, study->fit.constants->count, best->cost, best->steps,
        best->converged ? "converged" : "not converged", FIT_LOSS,
        provenance_left_out(fitted_model(study)));
}

static void write_head(const struct study *study, struct json *json)
{
    json_number(json, "cost", study->best.cost);
    json_count(json, "steps", (uint64_t)study->best.steps);
    json_truth(json, "converged", study->best.converged);
    json_count(json, "observations", study->best.used);
    json_text(json, "not_modelled", provenance_left_out(fitted_model(study)));
}

static bool add_part(const struct study *study,
                     const struct report_part *part, const double *written,
                     const struct results *results)
{
    struct table *table = table_new(part->columns, part->count);
    bool good;

    if (!table)
        return false;
    part->fill(study, written, table);
    good = results_part(results, table, part->key, part->heading);
    table_free(table);
    return good;
}

bool report_tell(const struct study *study, const double *written,
                 const struct results *results)
{
    print_head(study, results);
    if (results->json)
        write_head(study, results->json);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if ((parts[i].always || !study->brief)
            && !add_part(study, &parts[i], written, results))
            return false;
    return true;
}
