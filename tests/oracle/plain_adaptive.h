/* plain_adaptive.h - the rule of rt/kernels/frame/adaptive.s in plain C: selects the
 * pixels that differ from their neighbours, and computes their colours from more
 * rays. */
#ifndef PLAIN_ADAPTIVE_H
#define PLAIN_ADAPTIVE_H

#include "rt/picture/picture.h"

struct plain_refined {
    size_t count;  /* pixels that are refined */
    double margin; /* smallest difference of a distance from the threshold */
};

/* Refines a picture.  first: the samples of rays through the pixel centres, with one
 * more column on the left and one more row on top than the picture.  sampled: the same
 * pixels with samples times as many rows and columns.  Sets the picture's colours to
 * those of first, or to means of sampled.  All frames are of one scene, whose
 * assumed_gamma is gamma. */
struct plain_refined plain_adaptive(const struct frame *first,
                                    const struct frame *sampled, size_t samples,
                                    double threshold, double gamma,
                                    struct frame *picture);

#endif
