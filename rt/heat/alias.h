/* alias.h - a table by which one of many things is chosen with its probability,
 * in one step (rt/kernels/heat/pieces.s).
 *
 * A column i is chosen evenly; then i itself with the probability share[i], else
 * alias[i].  Source: Walker 1977; Vose, "A linear algorithm for generating random
 * numbers with a given distribution" (1991).
 */
#ifndef RT_ALIAS_H
#define RT_ALIAS_H

#include <stdbool.h>
#include <stddef.h>

/* weights: as many as count, none below 0, one above; probabilities are theirs over
 * their sum.  share and alias: likewise; shares are 0 .. 1.  False: no memory. */
bool alias_build(const double *weights, size_t count, double *share, size_t *alias);

#endif
