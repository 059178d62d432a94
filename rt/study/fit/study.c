#include "rt/study/fit/study.h"

#include <math.h>
#include <string.h>

bool study_is_row(const struct observation *observation)
{
    return strcmp(observation->unit, "s/100000") == 0;
}

bool study_is_fitted(const struct study *study, size_t i)
{
    return study->fit.observations->items[i].fit && !study->held.held[i];
}

static const struct speedup_subject *
subject_of(const struct observations *all, const struct observation *item)
{
    return all->timings[item->terms[0].timing].run->subject;
}

/* The primitives that have rows in the fit. */
static void find_subjects(struct study *study)
{
    const struct observations *all = study->fit.observations;

    for (size_t i = 0; i < all->count; i++) {
        const struct speedup_subject *subject = subject_of(all,
                                                           &all->items[i]);
        size_t k = 0;

        if (!study_is_fitted(study, i) || !subject)
            continue;
        while (k < study->subject_count && study->subjects[k] != subject)
            k++;
        if (k == study->subject_count && k < STUDY_SUBJECTS_MOST)
            study->subjects[study->subject_count++] = subject;
    }
}

static bool leave_rows_out(struct study *study, c205_error *error)
{
    const struct observations *all = study->fit.observations;

    for (size_t i = 0; i < all->count; i++) {
        struct fit_change change = study->held;
        struct fit_outcome outcome;

        study->left_out[i] = NAN;
        if (!study_is_fitted(study, i) || !study_is_row(&all->items[i]))
            continue;
        change.held[i] = true;
        if (!fit_solve(&study->fit, &change, study->best.places, &outcome,
                       error))
            return false;
        study->left_out[i] = outcome.predicted[i];
    }
    return true;
}

static bool leave_subjects_out(struct study *study, c205_error *error)
{
    const struct observations *all = study->fit.observations;

    for (size_t k = 0; k < study->subject_count; k++) {
        struct fit_change change = study->held;

        for (size_t i = 0; i < all->count; i++)
            if (subject_of(all, &all->items[i]) == study->subjects[k])
                change.held[i] = true;
        if (!fit_solve(&study->fit, &change, study->best.places,
                       &study->without[k], error))
            return false;
    }
    return true;
}

static bool double_priors(struct study *study, c205_error *error)
{
    for (size_t k = 0; k < study->fit.constants->count; k++) {
        struct fit_change wide = study->held, moved = study->held;

        wide.wider[k] = 2;
        moved.center[k] = 1 / study->fit.constants->items[k].width;
        if (!fit_solve(&study->fit, &wide, study->best.places,
                       &study->wide[k], error)
            || !fit_solve(&study->fit, &moved, study->best.places,
                          &study->moved[k], error))
            return false;
    }
    return true;
}

bool study_make(struct study *study, c205_error *error)
{
    static const double priors[FREE_MOST];

    find_subjects(study);
    if (!fit_begin(&study->fit, error)
        || !fit_predict(&study->fit, priors, study->at_prior, error)
        || !fit_solve(&study->fit, &study->held, priors, &study->best, error))
        return false;
    return study->brief
           || (leave_rows_out(study, error)
               && leave_subjects_out(study, error)
               && double_priors(study, error));
}

size_t study_row(const struct study *study,
                 const struct speedup_subject *subject, enum trace_mode mode,
                 const char *machine)
{
    const struct observations *all = study->fit.observations;
    size_t i = 0;

    for (; i < all->count; i++) {
        const struct observation *item = &all->items[i];

        if (study_is_row(item) && subject_of(all, item) == subject
            && strncmp(item->machine, machine, strlen(machine)) == 0
            && strstr(item->program, trace_mode_name(mode)) != NULL)
            break;
    }
    return i;
}

double study_speedup(const struct study *study,
                     const struct speedup_subject *subject, bool other,
                     double *told)
{
    size_t count = study->fit.observations->count;
    size_t slow = study_row(study, subject, TRACE_SCALAR,
                            other ? speedup_projections[0] : "cyber205");
    size_t fast = study_row(study, subject, TRACE_VECTOR, "cyber205");

    *told = other ? subject->paper.projected[0].speedup
                  : subject->paper.speedup;
    return slow == count || fast == count
               ? NAN
               : study->best.predicted[slow] / study->best.predicted[fast];
}
