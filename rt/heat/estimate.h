/* estimate.h - figures of independent repeats, with their standard errors. */
#ifndef RT_ESTIMATE_H
#define RT_ESTIMATE_H

#include <stddef.h>

struct estimate {
    double value, error;
};

/* Of so many repeats, 2 or more: the mean; the mean of the shares over that of the
 * wholes, whose error is that of share - ratio whole. */
struct estimate estimate_mean(const double *values, size_t count);
struct estimate estimate_ratio(const double *shares, const double *wholes,
                               size_t count);

#endif
