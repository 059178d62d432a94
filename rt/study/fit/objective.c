/* objective.c - reports whether the models meet the goals of the fit. */
#include "rt/study/fit/objective.h"

#include <math.h>
#include <string.h>

#include "base/sink.h"

#define TIMES_WITHIN .1
#define TIMES_GOAL .05
#define LEFT_OUT_WITHIN .25
#define WIDTHS_WITHIN 2.0

static void print_missed(const struct sink *sink, size_t *missed, const char *name,
                         double error)
{
    sink_print(sink, "%s\n    %s %+.1f %%", *missed > 0 ? "," : "; not", name,
               100 * error);
    ++*missed;
}

typedef bool chosen_rows(const struct observation *observation);

static bool is_any(const struct observation *observation)
{
    (void)observation;
    return true;
}

static bool is_kernel(const struct observation *observation)
{
    static const char name[] = "Livermore ";
    return strncmp(observation->name, name, strlen(name)) == 0;
}

static void print_rows(const struct study *study, chosen_rows *is_chosen,
                       const double *predicted, double within, const char *what,
                       const struct command_output *results)
{
    const struct observations *all = study->fit.observations;
    struct text_buffer text = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&text);
    size_t good = 0, rows = 0, missed = 0;
    for (size_t i = 0; i < all->count; i++)
        if (is_chosen(&all->items[i]) && !isnan(predicted[i])) {
            rows++;
            good += fabs(fit_error(&all->items[i], predicted[i])) <= within;
        }
    sink_print(&sink, "%s within %.0f %%: %zu of %zu", what, 100 * within, good, rows);
    for (size_t i = 0; i < all->count; i++)
        if (is_chosen(&all->items[i]) && !isnan(predicted[i])
            && fabs(fit_error(&all->items[i], predicted[i])) > within)
            print_missed(&sink, &missed, all->items[i].name,
                         fit_error(&all->items[i], predicted[i]));
    output_printf(results, "%s.\n", text.text ? text.text : "");
    text_buffer_free(&text);
}

static void print_speedups(const struct study *study, const double *written,
                           double within, const struct command_output *results)
{
    size_t good = 0;
    for (size_t i = 0; i < 2 * study->subject_count; i++) {
        double reported, found = study_speedup(study, written, study->subjects[i / 2],
                                               i % 2 != 0, &reported);
        good += fabs(found / reported - 1) <= within;
    }
    output_printf(results, "Speedups within %.0f %%: %zu of %zu.\n", 100 * within, good,
                  2 * study->subject_count);
}

static void print_constants(const struct study *study,
                            const struct command_output *results)
{
    const struct constants *constants = study->fit.constants;
    size_t inside = 0, near = 0;
    for (size_t i = 0; i < constants->count; i++) {
        const struct free_constant *constant = &constants->items[i];
        double value = constant_value(constant, study->best.places[i]);
        inside += value > constant->least && value < constant->most;
        near += fabs(study->best.places[i]) <= WIDTHS_WITHIN;
    }
    output_printf(results,
                  "Constants inside their bounds: %zu of %zu; within %g prior "
                  "widths: %zu.\n",
                  inside, constants->count, WIDTHS_WITHIN, near);
}

void objective_print(const struct study *study, const double *written,
                     const struct command_output *results)
{
    static const double limits[] = { TIMES_WITHIN, TIMES_GOAL };
    output_printf(results, "\nThe goal:\n\n");
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        print_rows(study, study_is_row, written, limits[i], "Times of Table 1",
                   results);
        print_speedups(study, written, limits[i], results);
    }
    print_rows(study, is_kernel, written, TIMES_WITHIN, "Livermore kernels", results);
    if (!study->brief)
        print_rows(study, is_any, study->left_out, LEFT_OUT_WITHIN, "Rows left out",
                   results);
    print_constants(study, results);
}
