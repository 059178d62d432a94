/* study.c - computes the fit, and tests its reliability. */
#include "rt/study/fit/study.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool study_is_row(const struct observation *observation)
{
    return strcmp(observation->unit, "s/100000") == 0;
}

bool study_is_fitted(const struct study *study, size_t i)
{
    return study->fit.observations->items[i].use == OBSERVATION_FIT
           && !study->held.held[i];
}

static const struct speedup_subject *subject_of(const struct observations *all,
                                                const struct observation *item)
{
    return all->timings[item->terms[0].timing].run->subject;
}

/* Lists the primitives that have rows in the fit. */
static void find_subjects(struct study *study)
{
    const struct observations *all = study->fit.observations;
    for (size_t i = 0; i < all->count; i++) {
        const struct speedup_subject *subject = subject_of(all, &all->items[i]);
        size_t k = 0;
        if (!study_is_fitted(study, i) || !subject)
            continue;
        while (k < study->subject_count && study->subjects[k] != subject)
            k++;
        if (k == study->subject_count && k < MAX_STUDY_SUBJECTS)
            study->subjects[study->subject_count++] = subject;
    }
}

/* ---- Rows left out ------------------------------------------------------ */

/* Fits without a row start at the priors, like the fit itself, because their start must
 * not depend on the omitted row. */
static const double priors[MAX_FREE];

static bool leave_rows_out(struct study *study, c205_error *error)
{
    const struct observations *all = study->fit.observations;
    for (size_t i = 0; i < all->count; i++) {
        struct fit_change change = study->held;
        struct fit_outcome outcome;
        study->left_out[i] = NAN;
        if (!study_is_fitted(study, i))
            continue;
        change.held[i] = true;
        if (!fit_solve(&study->fit, &change, priors, &outcome, error))
            return false;
        study->left_out[i] = outcome.predicted[i];
    }
    return true;
}

bool study_is_of(const struct study_group *group, const struct observation *item)
{
    size_t length = observation_group(item);
    return strlen(group->name) == length
           && strncmp(group->name, item->name, length) == 0;
}

static void add_to_groups(struct study *study, const struct observation *item)
{
    struct study_group *group = study->groups;
    struct study_group *end = group + study->group_count;
    while (group < end && !study_is_of(group, item))
        group++;
    if (group == study->groups + MAX_STUDY_GROUPS)
        return;
    if (group == end) {
        snprintf(group->name, sizeof group->name, "%.*s", (int)observation_group(item),
                 item->name);
        group->rows = 0;
        study->group_count++;
    }
    group->rows++;
}

/* Lists the groups of several rows. Groups of one row are omitted, because
 * leave_rows_out computes the fits without one row. */
static void find_groups(struct study *study)
{
    const struct observations *all = study->fit.observations;
    size_t kept = 0;
    study->group_count = 0;
    for (size_t i = 0; i < all->count; i++)
        if (study_is_fitted(study, i))
            add_to_groups(study, &all->items[i]);
    for (size_t k = 0; k < study->group_count; k++)
        if (study->groups[k].rows > 1)
            study->groups[kept++] = study->groups[k];
    study->group_count = kept;
}

static bool leave_groups_out(struct study *study, c205_error *error)
{
    const struct observations *all = study->fit.observations;
    for (size_t k = 0; k < study->group_count; k++) {
        struct study_group *group = &study->groups[k];
        struct fit_change change = study->held;
        for (size_t i = 0; i < all->count; i++)
            if (study_is_of(group, &all->items[i]))
                change.held[i] = true;
        if (!fit_solve(&study->fit, &change, priors, &group->without, error))
            return false;
    }
    return true;
}

/* ---- Priors doubled ----------------------------------------------------- */

static bool double_priors(struct study *study, c205_error *error)
{
    for (size_t k = 0; k < study->fit.constants->count; k++) {
        struct fit_change wide = study->held, moved = study->held;
        wide.wider[k] = 2;
        moved.center[k] = 1 / study->fit.constants->items[k].width;
        if (!fit_solve(&study->fit, &wide, study->best.places, &study->wide[k], error)
            || !fit_solve(&study->fit, &moved, study->best.places, &study->moved[k],
                          error))
            return false;
    }
    return true;
}

/* ---- The whole study ---------------------------------------------------- */

bool study_make(struct study *study, c205_error *error)
{
    find_subjects(study);
    find_groups(study);
    if (!fit_begin(&study->fit, error)
        || !fit_predict(&study->fit, priors, study->at_prior, error)
        || !fit_solve(&study->fit, &study->held, priors, &study->best, error))
        return false;
    return study->brief
           || (leave_rows_out(study, error) && leave_groups_out(study, error)
               && unidentifiable_find(&study->fit, &study->held, &study->unidentifiable,
                                      error)
               && double_priors(study, error));
}

double study_known_of(const struct study *study, size_t constant)
{
    double left = study->best.raw_errors[constant];
    return fmax(0, 1 - left * left);
}

double study_known(const struct study *study)
{
    double sum = 0;
    for (size_t i = 0; i < study->fit.constants->count; i++)
        sum += study_known_of(study, i);
    return sum;
}

size_t study_row(const struct study *study, const struct speedup_subject *subject,
                 enum trace_mode mode, const char *machine)
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

double study_speedup(const struct study *study, const double *predicted,
                     const struct speedup_subject *subject, bool other,
                     double *reported)
{
    size_t count = study->fit.observations->count;
    size_t slow = study_row(study, subject, TRACE_SCALAR,
                            other ? speedup_projections[0] : "cyber205");
    size_t fast = study_row(study, subject, TRACE_VECTOR, "cyber205");
    *reported = other ? subject->paper.projected[0].speedup : subject->paper.speedup;
    return slow == count || fast == count ? NAN : predicted[slow] / predicted[fast];
}
