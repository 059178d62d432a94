/* ceres_fit.h - the interface to Ceres: least squares with bounds, robust losses and a
 * covariance. No other file of the project uses Ceres.
 *
 * The fit minimises half the sum of loss(r^2) over all residuals r.
 */
#ifndef RT_FIT_CERES_FIT_H
#define RT_FIT_CERES_FIT_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Computes the residuals at `values`. If `derivatives` is not NULL, also computes them,
 * with a row for each residual. Returns false if this is impossible; the fit then
 * ends. */
typedef bool ceres_evaluate(void *context, const double *values, double *residuals,
                            double *derivatives);

struct ceres_problem {
    size_t values, residuals;
    const double *least, *most; /* bounds of each value; the fit moves the start
                                 * inside */
    const double *losses;       /* for each residual: the size from which its weight
                                 * decreases (Cauchy); 0: full weight */
    ceres_evaluate *evaluate;
    void *context;
};

struct ceres_outcome {
    double cost;
    int steps;
    bool converged;
    bool determined;    /* the covariance has been computed */
    double *covariance; /* values x values numbers: the covariance at the minimum if the
                         * residuals have a standard deviation of 1 */
    char message[256];
};

/* Replaces the values by those with the least cost. On failure sets outcome->message
 * and returns false. */
bool ceres_fit(const struct ceres_problem *problem, double *values,
               struct ceres_outcome *outcome);

#ifdef __cplusplus
}
#endif
#endif
