/* fit.h - fits the constants of the timing model to observations.
 *
 * There are two kinds of residuals. The residual of an observation is the relative
 * error of the predicted time, divided by the uncertainty of the observation. A Cauchy
 * loss with the scale FIT_LOSS limits the effect of outliers. An error that all rows of
 * a group have in common is counted once, not once per row. The residual of a free
 * constant is its distance from its prior, in widths of the prior.
 *
 * Derivatives are approximated by differences of times. The clock computes these times
 * with changed constants.
 *
 * The result is the same in every run, because threads only compute the timings.
 */
#ifndef RT_FIT_FIT_H
#define RT_FIT_FIT_H

#include "rt/study/fit/constants.h"
#include "rt/study/fit/observations.h"

enum { MAX_FIT_OBSERVATIONS = 64, MAX_FIT_TIMINGS = 64, MAX_FIT_JOBS = 64 };
#define FIT_LOSS 2.0 /* in standard deviations */

struct fit {
    const struct observations *observations;
    const struct constants *constants;
    size_t jobs;
    /* idle[i][k]: constant k does not affect the clocks of timing i */
    bool idle[MAX_FIT_TIMINGS][MAX_FREE];
};

/* The differences of a fit from the standard fit. */
struct fit_change {
    bool held[MAX_FIT_OBSERVATIONS]; /* observations that are omitted */
    double wider[MAX_FREE];          /* factors for the widths of the priors; 0:
                                      * unchanged */
    double center[MAX_FREE];         /* shifts of the priors, in widths */
};

struct fit_outcome {
    double places[MAX_FREE];     /* places of the constants, in prior widths */
    double errors[MAX_FREE];     /* standard errors, in prior widths; NaN:
                                  * undetermined */
    double raw_errors[MAX_FREE]; /* errors under the assumption that all uncertainties
                                  * are correct */
    double predicted[MAX_FIT_OBSERVATIONS];
    double cost;
    size_t used; /* number of observations in the fit */
    int steps;
    bool converged;
};

/* Prepares the fit: finds the constants that do not affect a timing. On failure sets
 * the error and returns false. */
bool fit_begin(struct fit *fit, c205_error *error);

/* Computes the fit. `places` are the start values of the free constants, as places
 * (constants.h). On failure sets the error and returns false. */
bool fit_solve(const struct fit *fit, const struct fit_change *change,
               const double *places, struct fit_outcome *outcome, c205_error *error);

/* Predicts the observations with the free constants at these places (constants.h). On
 * failure sets the error and returns false. */
bool fit_predict(const struct fit *fit, const double *places,
                 double predicted[MAX_FIT_OBSERVATIONS], c205_error *error);

/* Returns the relative error of a prediction, (predicted - value) / value. */
double fit_error(const struct observation *observation, double predicted);

#endif
