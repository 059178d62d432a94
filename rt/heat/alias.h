/* alias.h - builds alias tables. An alias table selects a random item in one step, with
 * given probabilities (rt/kernels/heat/pieces.s).
 *
 * A column i is selected uniformly. The selected item is i with the probability
 * share[i], else alias[i]. Sources: Walker 1977; Vose, "A linear algorithm for
 * generating random numbers with a given distribution" (1991).
 */
#ifndef RT_ALIAS_H
#define RT_ALIAS_H

#include <stdbool.h>
#include <stddef.h>

/* Builds the alias table for `count` items. `weights` contains the weight of each item:
 * none is negative, and at least one is positive. The probability of an item is its
 * weight divided by the sum of the weights. `share` and `alias` have `count` elements.
 * Shares are from 0 to 1. Returns false if out of memory. */
bool alias_build(const double *weights, size_t count, double *share, size_t *alias);

#endif
