/* fit_report.c - prints the results of a study. */
#include "rt/study/fit/fit_report.h"

#include <math.h>
#include <string.h>

#include "base/plural.h"
#include "base/provenance.h"

static const struct table_column observed[] = {
    { "name", "observation", TABLE_TEXT, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
    { "observed", "observed", TABLE_NUMBER, 4 },
    { "uncertainty", "+- %", TABLE_NUMBER, 0 },
    { "shared", "shared", TABLE_NUMBER, 0 },
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
    { "written_error", "written %", TABLE_NUMBER, 1 },
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

static const struct table_column ranges[] = {
    { "name", "observation", TABLE_TEXT, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
    { "least", "from", TABLE_NUMBER, 2 },
    { "most", "to", TABLE_NUMBER, 2 },
    { "predicted", "predicted", TABLE_NUMBER, 2 },
    { "error", "outside by %", TABLE_NUMBER, 1 },
    { "written", "written", TABLE_NUMBER, 2 },
};

static const struct table_column spans[] = {
    { "name", "observation", TABLE_TEXT, 0 },
    { "ways", "ways", TABLE_COUNT, 0 },
    { "least", "from", TABLE_NUMBER, 2 },
    { "most", "to", TABLE_NUMBER, 2 },
    { "least_predicted", "predicted from", TABLE_NUMBER, 2 },
    { "most_predicted", "to", TABLE_NUMBER, 2 },
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

static const struct table_column unidentifiable[] = {
    { "machine", "machine", TABLE_TEXT, 0 },
    { "constant", "constant", TABLE_TEXT, 0 },
    { "prior", "prior", TABLE_NUMBER, 2 },
    { "source", "src", TABLE_TEXT, 0 },
    { "moved_by", "scaled with", TABLE_TEXT, 0 },
};

/* ---- Observations ------------------------------------------------------- */

static void add_observation(const struct study *study, size_t i, const double *written,
                            struct table *table)
{
    const struct observation *item = &study->fit.observations->items[i];
    double error = fit_error(item, study->best.predicted[i]);
    table_text(table, item->name);
    table_text(table, item->unit);
    table_number(table, item->value);
    table_number(table, 100 * item->uncertainty);
    table_number(table, item->shared > 0 ? 100 * item->shared : NAN);
    table_number(table, 100 * fit_error(item, study->at_prior[i]));
    table_number(table, study->best.predicted[i]);
    table_number(table, 100 * error);
    table_number(table, error / observation_uncertainty(item));
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
        if (!study_is_fitted(study, i)
            && study->fit.observations->items[i].use != OBSERVATION_RANGE)
            add_observation(study, i, written, table);
}

/* Returns the relative distance of a figure from a range, or 0 if it is inside. */
static double outside(const struct observation *item, double predicted)
{
    return predicted < item->least  ? predicted / item->least - 1
           : predicted > item->most ? predicted / item->most - 1
                                    : 0;
}

static void fill_ranges(const struct study *study, const double *written,
                        struct table *table)
{
    for (size_t i = 0; i < study->fit.observations->count; i++) {
        const struct observation *item = &study->fit.observations->items[i];
        double predicted = study->best.predicted[i];
        if (item->use != OBSERVATION_RANGE)
            continue;
        table_text(table, item->name);
        table_text(table, item->unit);
        table_number(table, item->least);
        table_number(table, item->most);
        table_number(table, predicted);
        table_number(table, 100 * outside(item, predicted));
        table_number(table, written[i]);
    }
}

/* Adds the range of a figure that has several rows, one for each alternative program.
 * The rows are consecutive, starting with row `first`. Returns their number. */
static size_t add_span(const struct study *study, size_t first, struct table *table)
{
    const struct observations *all = study->fit.observations;
    const struct observation *item = &all->items[first];
    size_t length = observation_group(item), ways = 0;
    double least = INFINITY, most = 0;
    for (; first + ways < all->count && observation_same_group(item, &item[ways]);
         ways++) {
        least = fmin(least, study->best.predicted[first + ways]);
        most = fmax(most, study->best.predicted[first + ways]);
    }
    if (ways > 1) {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)length, item->name);
        table_text(table, name);
        table_count(table, ways);
        table_number(table, item->least);
        table_number(table, item->most);
        table_number(table, least);
        table_number(table, most);
    }
    return ways;
}

static void fill_spans(const struct study *study, const double *written,
                       struct table *table)
{
    const struct observations *all = study->fit.observations;
    (void)written;
    for (size_t i = 0; i < all->count;)
        i += all->items[i].use == OBSERVATION_RANGE ? add_span(study, i, table) : 1;
}

/* ---- Table 1, by primitive ---------------------------------------------- */

static void add_speedup(const struct study *study, const double *written,
                        const struct speedup_subject *subject, bool other,
                        struct table *table)
{
    double reported;
    double ratio = study_speedup(study, study->best.predicted, subject, other,
                                 &reported);
    double shown = study_speedup(study, written, subject, other, &reported);
    table_text(table, subject->name);
    table_text(table, other ? speedup_projections[0] : "205 scalar");
    table_number(table, reported);
    table_number(table, ratio);
    table_number(table, 100 * (ratio / reported - 1));
    table_number(table, 100 * (shown / reported - 1));
}

static void fill_speedups(const struct study *study, const double *written,
                          struct table *table)
{
    for (size_t i = 0; i < study->subject_count; i++) {
        add_speedup(study, written, study->subjects[i], false, table);
        add_speedup(study, written, study->subjects[i], true, table);
    }
}

/* ---- Constants ---------------------------------------------------------- */

/* Adds a constant. The column "known" is the fraction of the certainty that comes from
 * the data. "moved" means that the constant has changed by at least a tenth of the
 * prior's width. */
static void add_constant(const struct study *study, size_t i, struct table *table)
{
    const struct free_constant *constant = &study->fit.constants->items[i];
    const struct fit_outcome *best = &study->best;
    const char source[2] = { constant->source, '\0' };
    double width = constant->prior * constant->width;
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
    table_number(table, 100 * study_known_of(study, i));
    table_text(table, fabs(best->places[i]) >= .1 ? "yes" : "no");
}

static void fill_constants(const struct study *study, const double *written,
                           struct table *table)
{
    (void)written;
    for (size_t i = 0; i < study->fit.constants->count; i++)
        add_constant(study, i, table);
}

/* ---- Variants of the fit ------------------------------------------------ */

static void fill_left_out(const struct study *study, const double *written,
                          struct table *table)
{
    const struct observations *all = study->fit.observations;
    (void)written;
    for (size_t i = 0; i < all->count; i++) {
        const struct observation *item = &all->items[i];
        if (!study_is_fitted(study, i))
            continue;
        table_text(table, item->name);
        table_number(table, item->value);
        table_number(table, 100 * fit_error(item, study->best.predicted[i]));
        table_number(table, study->left_out[i]);
        table_number(table, 100 * fit_error(item, study->left_out[i]));
    }
}

/* Returns the fitted observation whose prediction differs most in another fit. */
static size_t most_changed(const struct study *study, const struct fit_outcome *other,
                           double *change)
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
        const struct free_constant *constant = &study->fit.constants->items[i];
        double change;
        size_t row = most_changed(study, &study->moved[i], &change);
        table_text(table, constant->name);
        table_number(table, constant_value(constant, study->best.places[i]));
        table_number(table, constant_value(constant, study->wide[i].places[i]));
        table_number(table, study->wide[i].cost);
        table_number(table, constant_value(constant, study->moved[i].places[i]));
        table_number(table, study->moved[i].cost);
        table_text(table, study->fit.observations->items[row].name);
        table_number(table, 100 * change);
    }
}

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
    for (size_t k = 0; k < study->group_count; k++) {
        const struct study_group *group = &study->groups[k];
        for (size_t i = 0; i < all->count; i++) {
            const struct observation *item = &all->items[i];
            double predicted = group->without.predicted[i];
            if (!study_is_fitted(study, i) || !study_is_of(group, item))
                continue;
            table_text(table, group->name);
            table_number(table, group->without.cost);
            table_text(table, item->name);
            table_number(table, 100 * fit_error(item, study->best.predicted[i]));
            table_number(table, 100 * fit_error(item, predicted));
        }
    }
}

static void fill_untouched(const struct study *study, const double *written,
                           struct table *table)
{
    (void)written;
    for (size_t i = 0; i < study->unidentifiable.count; i++) {
        const struct unidentifiable *item = &study->unidentifiable.items[i];
        const char source[2] = { item->constant->source, '\0' };
        table_text(table, item->machine);
        table_text(table, item->constant->name);
        table_number(table, item->constant->value);
        table_text(table, source);
        table_text(table, item->moved_by ? item->moved_by->name : "");
    }
}

/* ---- The whole report --------------------------------------------------- */

static const struct report_part {
    const char *key, *heading;
    const struct table_column *columns;
    size_t count;
    bool always; /* printed in a brief report, too */
    void (*fill)(const struct study *study, const double *written, struct table *table);
} parts[] = {
    { "fitted", "What was fitted", TABLE_COLUMNS(observed), true, fill_fitted },
    { "held_out", "Only compared, or held out", TABLE_COLUMNS(observed), true,
      fill_held },
    { "speedups", "The speedups of Table 1", TABLE_COLUMNS(speedups), true,
      fill_speedups },
    { "ranges", "Known as a range, or of programs that can be written in several ways",
      TABLE_COLUMNS(ranges), true, fill_ranges },
    { "spans", "The range of these ways", TABLE_COLUMNS(spans), true, fill_spans },
    { "constants", "The free constants", TABLE_COLUMNS(constants), true,
      fill_constants },
    { "left_out", "Each row left out", TABLE_COLUMNS(left_out), false, fill_left_out },
    { "without", "All rows of a group left out", TABLE_COLUMNS(without), false,
      fill_without },
    { "untouched", "Constants on which no row depends", TABLE_COLUMNS(unidentifiable),
      false, fill_untouched },
    { "doubled", "Priors doubled, in width and in value, one at a time",
      TABLE_COLUMNS(doubled), false, fill_doubled },
};

/* Returns the model of the first observation's machine. */
static const c205_model *fitted_model(const struct study *study)
{
    return study->fit.observations->timings[0].model;
}

static void print_head(const struct study *study, const struct command_output *results)
{
    const struct fit_outcome *best = &study->best;
    double known = study_known(study);
    output_printf(results,
                  "%zu observation%s, %zu free constant%s; cost %.3f after %d "
                  "step%s, %s.\n"
                  "The data determine %.1f of the constants; %.1f degrees of freedom "
                  "are left.\n"
                  "Residuals: relative errors of the machine's own clocks by their "
                  "uncertainty, Cauchy\n"
                  "loss from %g on; and the constants' distances from their priors, "
                  "in widths: P 2 %%,\n"
                  "D 5 %%, S 10 %%, R 40 %%.\n"
                  "Cycle-accounted, not cycle-accurate.  Not modelled: %s.\n",
                  best->used, plural(best->used), study->fit.constants->count,
                  plural(study->fit.constants->count), best->cost, best->steps,
                  plural((uint64_t)best->steps),
                  best->converged ? "converged" : "not converged", known,
                  (double)best->used - known, FIT_LOSS,
                  provenance_left_out(fitted_model(study)));
}

static void write_fit_head(const struct study *study, struct json *json)
{
    json_number(json, "cost", study->best.cost);
    json_count(json, "steps", (uint64_t)study->best.steps);
    json_bool(json, "converged", study->best.converged);
    json_count(json, "observations", study->best.used);
    json_number(json, "known", study_known(study));
    json_text(json, "not_modelled", provenance_left_out(fitted_model(study)));
}

static bool add_part(const struct study *study, const struct report_part *part,
                     const double *written, const struct command_output *results)
{
    struct table *table = table_new(part->columns, part->count);
    if (table)
        part->fill(study, written, table);
    return output_part(results, table, part->key, part->heading);
}

bool report_print(const struct study *study, const double *written,
                  const struct command_output *results)
{
    print_head(study, results);
    if (results->json)
        write_fit_head(study, results->json);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if ((parts[i].always || !study->brief)
            && !add_part(study, &parts[i], written, results))
            return false;
    return true;
}
