/* alias.h - builds an alias table, which picks one of many items by its
 * probability in one step (rt/kernels/heat/pieces.s).
 *
 * A column i is picked uniformly. The item is i with the probability share[i],
 * else alias[i]. Sources: Walker 1977; Vose, "A linear algorithm for generating
 * random numbers with a given distribution" (1991).
 */
#ifndef RT_ALIAS_H
#define RT_ALIAS_H

#include <stdbool.h>
#include <stddef.h>

/* Builds the table. There are `count` weights, none negative, at least one
 * positive. An item's probability is its weight over their sum. share and alias
 * have `count` elements; shares are from 0 to 1. Returns false if out of memory. */
bool alias_build(const double *weights, size_t count, double *share, size_t *alias);

#endif
