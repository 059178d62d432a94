/* ceres_fit.h - the adapter to Ceres: least squares with bounds, robust losses and
 * a covariance. No other file of the project uses Ceres.
 *
 * The fit minimises half the sum of loss(r^2) over the residuals r.
 */
#ifndef RT_FIT_CERES_FIT_H
#define RT_FIT_CERES_FIT_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Computes the residuals at the values and, unless it is NULL, their derivatives,
 * with a row for each residual. Returns false if that is impossible; the fit then
 * ends. */
typedef bool ceres_evaluate(void *context, const double *values, double *residuals,
                            double *derivatives);

struct ceres_problem {
    size_t values, residuals;
    const double *least, *most; /* of each value; the start is moved inside */
    const double *losses;       /* of each residual: the size from which it has less
                                 * weight (Cauchy); 0: full weight */
    ceres_evaluate *evaluate;
    void *context;
};

struct ceres_outcome {
    double cost;
    int steps;
    bool converged;
    bool determined;    /* the covariance exists */
    double *covariance; /* room for values x values numbers; at the minimum, for
                         * residuals with a standard deviation of 1 */
    char message[256];
};

/* Moves the values to those of the least cost. Returns false with the reason in
 * the message. */
bool ceres_fit(const struct ceres_problem *problem, double *values,
               struct ceres_outcome *outcome);

#ifdef __cplusplus
}
#endif
#endif
