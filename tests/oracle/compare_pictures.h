/* compare_pictures.h - measures how much two frames of one scene differ.
 *
 * On a silhouette rounding decides which primitive a pixel shows. Therefore a pixel is
 * only compared if it and its eight neighbours show the same primitive.
 */
#ifndef COMPARE_PICTURES_H
#define COMPARE_PICTURES_H

#include "rt/picture/picture.h"

/* The channels to compare, and the tolerances. */
struct comparison {
    const char *name;
    enum frame_channel first;
    size_t channels;
    double ceiling;   /* greater samples are reduced to this value, because POV-Ray's
                       * PNG ends at 1 */
    bool relative;    /* the difference of samples above 1 is relative */
    double tolerance; /* larger differences are counted */
    double share;     /* allowed fraction of pixels with larger differences */
};

/* The fraction of pixels whose colour or primitive may depend on rounding. They are on
 * an edge of a box, a checker's cell or a shadow, or where primitives touch. */
#define DECIDED_BY_ROUNDING .0005

/* The comparisons of a frame of rt205 with the plain tracer's frame. */
enum { WITH_FRAME = 4 };
extern const struct comparison with_frame[WITH_FRAME];

struct picture_difference {
    size_t compared, ignored, beyond; /* numbers of pixels */
    double mean, greatest;            /* mean and greatest difference of all samples */
    size_t worst_x, worst_y;          /* pixel with the greatest difference */
};

/* Returns height * width flags of the compared pixels. The caller frees them. */
bool *inner_pixels(const struct frame *frame);

/* Compares two frames of the same size. */
struct picture_difference compare_pictures(const struct comparison *comparison,
                                           const struct frame *expected,
                                           const struct frame *found,
                                           const bool *inner);

bool within(const struct comparison *comparison,
            const struct picture_difference *difference);

#endif
