/* study.h - the fit, and how far it can be believed: the same with a row or a
 * group of rows left out, and with priors doubled.
 */
#ifndef RT_FIT_STUDY_H
#define RT_FIT_STUDY_H

#include "rt/study/fit/unidentifiable.h"

enum { MAX_STUDY_SUBJECTS = 8, MAX_STUDY_GROUPS = 8 };

/* Rows of the fit that share the first words of their names, and the fit
 * without them. */
struct study_group {
    char name[32];
    size_t rows;
    struct fit_outcome without;
};

struct study {
    struct fit fit;
    struct fit_change held; /* what the user holds out, of all fits */
    bool brief;             /* the fit alone was made */
    double at_prior[MAX_FIT_OBSERVATIONS];
    struct fit_outcome best;
    size_t subject_count; /* primitives of Table 1 */
    const struct speedup_subject *subjects[MAX_STUDY_SUBJECTS];
    /* A fit without each row, from the priors: what it predicts for it. */
    double left_out[MAX_FIT_OBSERVATIONS];
    size_t group_count; /* of more than one row */
    struct study_group groups[MAX_STUDY_GROUPS];
    struct untouched_list untouched;
    /* With the width of each constant's prior doubled, or the prior itself. */
    struct fit_outcome wide[MAX_FREE], moved[MAX_FREE];
};

/* The fit and, unless it is to be brief, the rest.  False: the error says
 * why. */
bool study_make(struct study *study, c205_error *error);

/* Whether an observation is a row of Table 1: a frame's time. */
bool study_is_row(const struct observation *observation);
/* Whether it is in the fit. */
bool study_is_fitted(const struct study *study, size_t observation);

bool study_is_of(const struct study_group *group,
                 const struct observation *observation);

/* How many constants' worth the data tell: of each that part of the certainty
 * about it that is not its prior's. */
double study_known(const struct study *study);
double study_known_of(const struct study *study, size_t constant);

/* The row of a primitive in a form on a machine; the number of observations if
 * there is none. */
size_t study_row(const struct study *study, const struct speedup_subject *subject,
                 enum trace_mode mode, const char *machine);

/* By how much the vector form is faster than the scalar one, on the other
 * machine if that is wanted, by what is predicted; and what Table 1 tells.
 * NaN: none. */
double study_speedup(const struct study *study, const double *predicted,
                     const struct speedup_subject *subject, bool other,
                     double *reported);

#endif
