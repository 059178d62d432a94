/* estimate.c - computes means and ratios with their standard errors. */
#include "rt/heat/estimate.h"

#include <math.h>

static double mean_of(const double *values, size_t count)
{
    double sum = 0;
    for (size_t k = 0; k < count; k++)
        sum += values[k];
    return sum / (double)count;
}

/* Returns the standard error of the mean of count values. `squares` is the sum of their
 * squared deviations. */
static double error_of(double squares, size_t count)
{
    double n = (double)count;
    return sqrt(squares / (n * (n - 1)));
}

struct estimate estimate_mean(const double *values, size_t count)
{
    double mean = mean_of(values, count), squares = 0;
    for (size_t k = 0; k < count; k++)
        squares += (values[k] - mean) * (values[k] - mean);
    return (struct estimate){ mean, error_of(squares, count) };
}

struct estimate estimate_ratio(const double *shares, const double *wholes, size_t count)
{
    double whole = mean_of(wholes, count);
    double ratio = mean_of(shares, count) / whole, squares = 0;
    for (size_t k = 0; k < count; k++) {
        double beside = shares[k] - ratio * wholes[k];
        squares += beside * beside;
    }
    return (struct estimate){ ratio, error_of(squares, count) / whole };
}
