/* plain_adaptive.h - which pixels get more rays because they differ from their
 * neighbours, and what these make of them: the rule of
 * rt/kernels/frame/adaptive.s, pixel after pixel. */
#ifndef PLAIN_ADAPTIVE_H
#define PLAIN_ADAPTIVE_H

#include "rt/picture/picture.h"

struct plain_refined {
    size_t count;  /* pixels that are refined */
    double margin; /* the least by which a distance was off the threshold */
};

/* first: of rays through the middles, one column and one row more than the
 * picture, which has those to the left and above besides; sampled: samples times
 * as many of both.  The picture's colours become those of first, or means.  All are
 * of a scene with that assumed_gamma. */
struct plain_refined plain_adaptive(const struct frame *first,
                                    const struct frame *sampled, size_t samples,
                                    double threshold, double gamma,
                                    struct frame *picture);

#endif
