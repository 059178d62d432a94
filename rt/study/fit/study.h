/* study.h - the fit, and how far it can be believed: the same with a row or
 * a primitive left out and with priors doubled.
 */
#ifndef RT_FIT_STUDY_H
#define RT_FIT_STUDY_H

#include "rt/study/fit/fit.h"

enum { STUDY_SUBJECTS_MOST = 8 };

struct study {
    struct fit fit;
    struct fit_change held; /* what the user holds out, of all fits */
    bool brief;             /* the fit alone was made */
    double at_prior[FIT_OBSERVATIONS_MOST];
    struct fit_outcome best;
    /* A fit without each row of Table 1: what it predicts for that row. */
    double left_out[FIT_OBSERVATIONS_MOST];
    /* Without all rows of a primitive. */
    size_t subject_count;
    const struct speedup_subject *subjects[STUDY_SUBJECTS_MOST];
    struct fit_outcome without[STUDY_SUBJECTS_MOST];
    /* With the width of each constant's prior doubled, or the prior itself. */
    struct fit_outcome wide[FREE_MOST], moved[FREE_MOST];
};

/* The fit and, unless it is to be brief, the rest.  False: the error says
 * why. */
bool study_make(struct study *study, c205_error *error);

/* Whether an observation is a row of Table 1: a frame's time. */
bool study_is_row(const struct observation *observation);
/* Whether it is in the fit. */
bool study_is_fitted(const struct study *study, size_t observation);

/* The row of a primitive in a form on a machine; the number of observations if
 * there is none. */
size_t study_row(const struct study *study,
                 const struct speedup_subject *subject, enum trace_mode mode,
                 const char *machine);

/* By how much the vector form is faster than the scalar one, on the other
 * machine if that is wanted; and what Table 1 tells.  NaN: none. */
double study_speedup(const struct study *study,
                     const struct speedup_subject *subject, bool other,
                     double *told);

#endif
