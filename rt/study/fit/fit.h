/* fit.h - the constants of the timing model, fitted to observations.
 *
 * Residuals: of each observation in use, the relative error of the machine's
 * own clocks for its program, by its uncertainty, with a Cauchy loss of
 * FIT_LOSS, where a group of rows shares a part of the uncertainty the shared
 * error counting once; of each free constant, how far it is from its prior, in the
 * prior's widths.  Derivatives are differences between programs timed again.
 *
 * Everything is the same in every run: threads only share the timing out.
 */
#ifndef RT_FIT_FIT_H
#define RT_FIT_FIT_H

#include "rt/study/fit/constants.h"
#include "rt/study/fit/observations.h"

enum { MAX_FIT_OBSERVATIONS = 64, MAX_FIT_TIMINGS = 64, MAX_FIT_JOBS = 64 };
#define FIT_LOSS 2.0 /* standard deviations */

struct fit {
    const struct observations *observations;
    const struct constants *constants;
    size_t jobs;
    /* Which constants have no part in a program. */
    bool idle[MAX_FIT_TIMINGS][MAX_FREE];
};

/* What is other than in the fit proper. */
struct fit_change {
    bool held[MAX_FIT_OBSERVATIONS]; /* observations left out */
    double wider[MAX_FREE];          /* priors' widths times this; 0: as is */
    double center[MAX_FREE];         /* priors moved, in widths */
};

struct fit_outcome {
    double places[MAX_FREE];     /* of the constants, in prior widths */
    double errors[MAX_FREE];     /* standard, likewise; NaN: undetermined */
    double raw_errors[MAX_FREE]; /* as if all uncertainties were right */
    double predicted[MAX_FIT_OBSERVATIONS];
    double cost;
    size_t used; /* observations */
    int steps;
    bool converged;
};

/* False: the error says why. */
bool fit_begin(struct fit *fit, c205_error *error);

/* places: where to begin. */
bool fit_solve(const struct fit *fit, const struct fit_change *change,
               const double *places, struct fit_outcome *outcome, c205_error *error);

/* What the machine shows with the constants at these places. */
bool fit_predict(const struct fit *fit, const double *places,
                 double predicted[MAX_FIT_OBSERVATIONS], c205_error *error);

/* (predicted - value) / value */
double fit_error(const struct observation *observation, double predicted);

#endif
