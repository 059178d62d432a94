/* study.h - computes the fit, and tests its reliability by fits without a row, without
 * a group of rows, and with doubled priors. */
#ifndef RT_FIT_STUDY_H
#define RT_FIT_STUDY_H

#include "rt/study/fit/unidentifiable.h"

enum { MAX_STUDY_SUBJECTS = 8, MAX_STUDY_GROUPS = 8 };

/* A group of rows whose names begin with the same words, and the fit without the
 * group. */
struct study_group {
    char name[32];
    size_t rows;
    struct fit_outcome without;
};

struct study {
    struct fit fit;
    struct fit_change held; /* observations that the user omits from all fits */
    bool brief;             /* only the fit was computed, without tests */
    double at_prior[MAX_FIT_OBSERVATIONS];
    struct fit_outcome best;
    size_t subject_count; /* number of primitives of Table 1 */
    const struct speedup_subject *subjects[MAX_STUDY_SUBJECTS];
    /* For each row: its prediction by a fit without the row, which starts at the
     * priors. */
    double left_out[MAX_FIT_OBSERVATIONS];
    size_t group_count; /* number of groups of more than one row */
    struct study_group groups[MAX_STUDY_GROUPS];
    struct unidentifiable_list unidentifiable;
    /* For each constant: a fit with twice the width of its prior, and a fit with twice
     * the prior. */
    struct fit_outcome wide[MAX_FREE], moved[MAX_FREE];
};

/* Computes the fit and, unless `brief` is set, the tests. On failure sets the error and
 * returns false. */
bool study_make(struct study *study, c205_error *error);

/* Returns true if an observation is a row of Table 1: the time of a frame. */
bool study_is_row(const struct observation *observation);
/* Returns true if the observation is in the fit. */
bool study_is_fitted(const struct study *study, size_t observation);

bool study_is_of(const struct study_group *group,
                 const struct observation *observation);

/* study_known_of returns 1 - v, where v is the variance of a constant after the fit,
 * relative to the variance of its prior. study_known returns the sum for all constants:
 * the number of constants that the observations determine. */
double study_known(const struct study *study);
double study_known_of(const struct study *study, size_t constant);

/* Returns the index of the observation of a primitive in this form on this machine, or
 * the number of observations if there is none. */
size_t study_row(const struct study *study, const struct speedup_subject *subject,
                 enum trace_mode mode, const char *machine);

/* Returns the predicted speedup of the vector form over the scalar form. other: the
 * scalar form is on the CYBER 720. Returns NaN if the observations lack one of the two
 * forms. Sets *reported to the speedup in Table 1. */
double study_speedup(const struct study *study, const double *predicted,
                     const struct speedup_subject *subject, bool other,
                     double *reported);

#endif
