/* estimate.h - computes means and ratios of independent repeats, with their standard
 * errors. */
#ifndef RT_ESTIMATE_H
#define RT_ESTIMATE_H

#include <stddef.h>

struct estimate {
    double value, error;
};

/* These functions need at least 2 repeats. estimate_mean returns the mean.
 * estimate_ratio returns the mean of the shares divided by the mean of the wholes. The
 * error of the ratio is the error of the mean of share - ratio * whole, divided by the
 * mean of the wholes. */
struct estimate estimate_mean(const double *values, size_t count);
struct estimate estimate_ratio(const double *shares, const double *wholes,
                               size_t count);

#endif
