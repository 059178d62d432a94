/* ceres_fit.h - the adapter to Ceres: least squares with bounds, robust losses
 * and a covariance.  Nothing else of the project knows Ceres.
 *
 * Minimised is 1/2 the sum of loss(r^2) over the residuals r.
 */
#ifndef RT_FIT_CERES_FIT_H
#define RT_FIT_CERES_FIT_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Residuals at the values, and unless it is NULL their derivatives, a row for
 * each residual.  False: it cannot be done, and the fit ends. */
typedef bool ceres_evaluate(void *context, const double *values, double *residuals,
                            double *derivatives);

struct ceres_problem {
    size_t values, residuals;
    const double *least, *most; /* of each value; the start is moved inside */
    const double *losses;       /* of each residual: the size from which it counts
                             less (Cauchy); 0: it always counts */
    ceres_evaluate *evaluate;
    void *context;
};

struct ceres_outcome {
    double cost;
    int steps;
    bool converged;
    bool determined;    /* the covariance exists */
    double *covariance; /* room for values x values: at the minimum, of
                           residuals with a standard deviation of 1 */
    char message[256];
};

/* From the values given to those of the least cost.  False: the message says
 * why. */
bool ceres_fit(const struct ceres_problem *problem, double *values,
               struct ceres_outcome *outcome);

#ifdef __cplusplus
}
#endif
#endif
