/* run_povray.h - renders a scene file with POV-Ray. */
#ifndef RUN_POVRAY_H
#define RUN_POVRAY_H

#include "rt/picture/picture.h"

/* POV-Ray's sampling method 1, without jitter: pixels that differ from a neighbour by
 * the threshold get samples x samples rays. */
struct antialiasing {
    size_t samples;
    double threshold;
};

/* Renders the scene in linear light between 0 and 1 in steps of 1/65535; only colours
 * are set.  how: NULL for one ray per pixel.  Its files are in a temporary folder,
 * which is removed.  The caller frees the frame.  After a failure the error is the end
 * of POV-Ray's output. */
bool run_povray(const char *scene, size_t width, size_t height,
                const struct antialiasing *how, struct frame *frame, c205_error *error);

/* Does the same for a text, with one ray per pixel, in two steps, between which POV-Ray
 * runs in parallel.  POV-Ray mostly waits for its own threads, so several simultaneous
 * runs cost little.  povray_begin writes the text to a file in the current folder, and
 * gives up after an error; povray_end removes the file and frees the run. */
struct povray;
struct povray *povray_begin(const char *path, const char *text, size_t width,
                            size_t height);
bool povray_end(struct povray *run, struct frame *frame, c205_error *error);

#endif
