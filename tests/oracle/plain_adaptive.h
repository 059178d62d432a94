/* plain_adaptive.h - the rule of rt/kernels/frame/adaptive.s in plain C: selects pixels
 * that differ from their neighbours, and traces more rays for them. */
#ifndef PLAIN_ADAPTIVE_H
#define PLAIN_ADAPTIVE_H

#include "rt/picture/picture.h"

struct plain_refined {
    size_t count;  /* number of refined pixels */
    double margin; /* least distance of a difference from the threshold */
};

/* Refines a picture. `first` contains the samples of rays through the pixel centres. It
 * has one column on the left and one row at the top more than the picture. `sampled`
 * contains the same pixels, with `samples` times as many rows and columns. Takes the
 * colours of the picture from `first`, or from means of `sampled`. All frames are of
 * the same scene, whose assumed_gamma is gamma. */
struct plain_refined plain_adaptive(const struct frame *first,
                                    const struct frame *sampled, size_t samples,
                                    double threshold, double gamma,
                                    struct frame *picture);

#endif
