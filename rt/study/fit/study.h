/* study.h - makes the fit and tests its reliability: the same fit without a row or
 * a group of rows, and with doubled priors. */
#ifndef RT_FIT_STUDY_H
#define RT_FIT_STUDY_H

#include "rt/study/fit/unidentifiable.h"

enum { MAX_STUDY_SUBJECTS = 8, MAX_STUDY_GROUPS = 8 };

/* Rows of the fit that share the first words of their names, and the fit without
 * them. */
struct study_group {
    char name[32];
    size_t rows;
    struct fit_outcome without;
};

struct study {
    struct fit fit;
    struct fit_change held; /* observations that the user leaves out of all fits */
    bool brief;             /* only the fit was made */
    double at_prior[MAX_FIT_OBSERVATIONS];
    struct fit_outcome best;
    size_t subject_count; /* primitives of Table 1 */
    const struct speedup_subject *subjects[MAX_STUDY_SUBJECTS];
    /* For each row, the prediction of a fit without it, started from the priors. */
    double left_out[MAX_FIT_OBSERVATIONS];
    size_t group_count; /* of more than one row */
    struct study_group groups[MAX_STUDY_GROUPS];
    struct unidentifiable_list unidentifiable;
    /* Fits with the width of each constant's prior doubled, and with the prior itself
     * doubled. */
    struct fit_outcome wide[MAX_FREE], moved[MAX_FREE];
};

/* Makes the fit and, unless brief is set, the tests. Returns false with the reason
 * in the error. */
bool study_make(struct study *study, c205_error *error);

/* Returns true if an observation is a row of Table 1, which is the time of a
 * frame. */
bool study_is_row(const struct observation *observation);
/* Returns true if the observation is in the fit. */
bool study_is_fitted(const struct study *study, size_t observation);

bool study_is_of(const struct study_group *group,
                 const struct observation *observation);

/* Return the number of constants that the data determine. A constant counts with
 * the part of its certainty that does not come from its prior. */
double study_known(const struct study *study);
double study_known_of(const struct study *study, size_t constant);

/* Returns the row of a primitive in a form on a machine, or the number of
 * observations if there is none. */
size_t study_row(const struct study *study, const struct speedup_subject *subject,
                 enum trace_mode mode, const char *machine);

/* Returns the predicted speedup of the vector form over the scalar one, which may
 * be on the other machine, and sets the value of Table 1. NaN: none. */
double study_speedup(const struct study *study, const double *predicted,
                     const struct speedup_subject *subject, bool other,
                     double *reported);

#endif
