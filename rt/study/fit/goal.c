#include "rt/study/fit/goal.h"

#include <math.h>

#define TIMES_WITHIN .05
#define LEFT_OUT_WITHIN .25
#define WIDTHS_WITHIN 2.0

static void print_missed(FILE *file, size_t *missed, const char *name,
                         double error)
{
    fprintf(file, "%s\n    %s %+.1f %%", *missed > 0 ? "," : "; not", name,
            100 * error);
    ++*missed;
}

static void print_rows(const struct study *study, const double *predicted,
                       double within, const char *what, FILE *file)
{
    const struct observations *all = study->fit.observations;
    size_t good = 0, rows = 0, missed = 0;

    for (size_t i = 0; i < all->count; i++)
        if (study_is_row(&all->items[i]) && !isnan(predicted[i])) {
            rows++;
            good += fabs(fit_error(&all->items[i], predicted[i])) <= within;
        }
    fprintf(file, "%s within %.0f %%: %zu of %zu", what, 100 * within, good,
            rows);
    for (size_t i = 0; i < all->count; i++)
        if (study_is_row(&all->items[i]) && !isnan(predicted[i])
            && fabs(fit_error(&all->items[i], predicted[i])) > within)
            print_missed(file, &missed, all->items[i].name,
                         fit_error(&all->items[i], predicted[i]));
    fprintf(file, ".\n");
}

static void print_speedups(const struct study *study, FILE *file)
{
    size_t good = 0;

    for (size_t i = 0; i < 2 * study->subject_count; i++) {
        double told, found = study_speedup(study, study->subjects[i / 2],
                                           i % 2 != 0, &told);

        good += fabs(found / told - 1) <= TIMES_WITHIN;
    }
    fprintf(file, "Speedups within %.0f %%: %zu of %zu.\n",
            100 * TIMES_WITHIN, good, 2 * study->subject_count);
}

static void print_constants(const struct study *study, FILE *file)
{
    const struct constants *constants = study->fit.constants;
    size_t inside = 0, near = 0;

    for (size_t i = 0; i < constants->count; i++) {
        const struct free_constant *constant = &constants->items[i];
        double value = constant_value(constant, study->best.places[i]);

        inside += value > constant->least && value < constant->most;
        near += fabs(study->best.places[i]) <= WIDTHS_WITHIN;
    }
    fprintf(file,
            "Constants inside their bounds: %zu of %zu; within %g prior "
            "widths: %zu.\n",
            inside, constants->count, WIDTHS_WITHIN, near);
}

void goal_print(const struct study *study, FILE *file)
{
    fprintf(file, "\nThe goal:\n\n");
    print_rows(study, study->best.predicted, TIMES_WITHIN, "Times of Table 1",
               file);
    print_speedups(study, file);
    if (!study->brief)
        print_rows(study, study->left_out, LEFT_OUT_WITHIN, "Rows left out",
                   file);
    print_constants(study, file);
}
