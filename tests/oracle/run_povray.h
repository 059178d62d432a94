/* run_povray.h - POV-Ray's picture of a scene file. */
#ifndef RUN_POVRAY_H
#define RUN_POVRAY_H

#include "rt/picture/picture.h"

/* Its sampling method 1, without jitter: pixels that differ from a neighbour by the
 * threshold get so many samples, across and down. */
struct antialiasing {
    size_t samples;
    double threshold;
};

/* As linear light between 0 and 1 in steps of 1/65535; colours only.  how: NULL for
 * one ray a pixel.  Its files stay in a temporary folder that is removed.  The
 * caller frees the frame.  Fails with POV-Ray's own last words. */
bool run_povray(const char *scene, size_t width, size_t height,
                const struct antialiasing *how, struct frame *frame,
                struct picture_error *error);

/* The same, of one ray a pixel, in two steps: between them POV-Ray is at work by itself.  It waits
 * for its own threads most of the time, so several runs at once cost little.
 * povray_begin: NULL, and the error says why; povray_end frees the run. */
struct povray;
struct povray *povray_begin(const char *scene, size_t width, size_t height,
                            struct picture_error *error);
bool povray_end(struct povray *run, struct frame *frame, struct picture_error *error);

#endif
