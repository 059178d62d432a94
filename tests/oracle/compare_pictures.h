/* compare_pictures.h - measures how much two frames of one scene differ.
 *
 * On a silhouette rounding decides which primitive a pixel shows.  So a pixel counts
 * only if it and its eight neighbours show the same primitive.
 */
#ifndef COMPARE_PICTURES_H
#define COMPARE_PICTURES_H

#include "rt/picture/picture.h"

/* The channels to compare, and the tolerances. */
struct comparison {
    const char *name;
    enum frame_channel first;
    size_t channels;
    double ceiling;   /* greater samples count as this; POV-Ray's PNG ends at 1 */
    bool relative;    /* differences of samples above 1 are divided by them */
    double tolerance; /* a pixel that differs more is beyond */
    double share;     /* allowed share of such pixels */
};

/* The share of pixels at which rounding decides: on the edge between two faces of a
 * box, between two squares of a checker, or of a shadow; the primitive, where two touch
 * face to face. */
#define DECIDED_BY_ROUNDING .0005

/* The comparisons of a frame of rt205 with the plain tracer's. */
enum { WITH_FRAME = 4 };
extern const struct comparison with_frame[WITH_FRAME];

struct picture_difference {
    size_t compared, ignored, beyond; /* pixels */
    double mean, greatest;            /* over all samples */
    size_t worst_x, worst_y;          /* pixel with the greatest difference */
};

/* Returns height * width flags of the pixels that count; the caller frees
 * them. */
bool *inner_pixels(const struct frame *frame);

/* Compares two frames of one size. */
struct picture_difference compare_pictures(const struct comparison *comparison,
                                           const struct frame *expected,
                                           const struct frame *found,
                                           const bool *inner);

bool within(const struct comparison *comparison,
            const struct picture_difference *difference);

#endif
