/* fit.h - fits the constants of the timing model to observations.
 *
 * There are two kinds of residuals. For each observation in use, the residual is
 * the relative error of the machine's own clocks for its program, divided by the
 * uncertainty, with a Cauchy loss of FIT_LOSS. The error that a group of rows
 * shares counts once. For each free constant, the residual is its distance from
 * its prior, in widths of the prior. Derivatives are differences between programs
 * timed again.
 *
 * The result is the same in every run: threads only distribute the timing.
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
    /* True if a constant has no influence on a program. */
    bool idle[MAX_FIT_TIMINGS][MAX_FREE];
};

/* The differences from the standard fit. */
struct fit_change {
    bool held[MAX_FIT_OBSERVATIONS]; /* observations left out */
    double wider[MAX_FREE];          /* factors of the priors' widths; 0: unchanged */
    double center[MAX_FREE];         /* shifts of the priors, in widths */
};

struct fit_outcome {
    double places[MAX_FREE];     /* of the constants, in prior widths */
    double errors[MAX_FREE];     /* standard errors in prior widths; NaN:
                                  * undetermined */
    double raw_errors[MAX_FREE]; /* the errors if all uncertainties are correct */
    double predicted[MAX_FIT_OBSERVATIONS];
    double cost;
    size_t used; /* number of observations */
    int steps;
    bool converged;
};

/* Prepares the fit. Returns false with the reason in the error. */
bool fit_begin(struct fit *fit, c205_error *error);

/* Solves the fit from the given places. */
bool fit_solve(const struct fit *fit, const struct fit_change *change,
               const double *places, struct fit_outcome *outcome, c205_error *error);

/* Predicts the observations with the constants at these places. */
bool fit_predict(const struct fit *fit, const double *places,
                 double predicted[MAX_FIT_OBSERVATIONS], c205_error *error);

/* Returns (predicted - value) / value. */
double fit_error(const struct observation *observation, double predicted);

#endif
