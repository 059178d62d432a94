/* compare_pictures.h - how far two frames of one scene differ.
 *
 * On a silhouette one rounding decides which primitive a pixel shows, so a
 * pixel counts only where it and its eight neighbours show one primitive.
 */
#ifndef COMPARE_PICTURES_H
#define COMPARE_PICTURES_H

#include "rt/picture/picture.h"

/* What is compared, and what is allowed. */
struct comparison {
    const char *name;
    enum frame_channel first;
    size_t channels;
    double ceiling;   /* greater samples count as this; POV-Ray's PNG ends
                         at 1 */
    bool relative;    /* differences of samples beyond 1 are divided by them */
    double tolerance; /* a pixel that differs more is beyond ... */
    double share;     /* ... as this share of the pixels may be */
};

/* Pixels where one rounding decides: the edge between two faces of one box,
 * between two squares of a checker, of a shadow; the primitive, where two of
 * them touch face to face. */
#define DECIDED_BY_ROUNDING .0005

/* What a frame of rt205 must have in common with the plain tracer's. */
enum { WITH_FRAME = 4 };
extern const struct comparison with_frame[WITH_FRAME];

struct picture_difference {
    size_t compared, ignored, beyond; /* pixels */
    double mean, greatest;            /* of all samples */
    size_t worst_x, worst_y;          /* where the greatest is */
};

/* Which pixels of the frame count: height x width flags, to be freed; NULL
 * when memory is short. */
bool *inner_pixels(const struct frame *frame);

/* Frames of one size. */
struct picture_difference compare_pictures(const struct comparison *comparison,
                                           const struct frame *expected,
                                           const struct frame *found,
                                           const bool *inner);

bool within(const struct comparison *comparison,
            const struct picture_difference *difference);

#endif
