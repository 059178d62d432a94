/* run_povray.h - renders a scene file with POV-Ray. */
#ifndef RUN_POVRAY_H
#define RUN_POVRAY_H

#include "rt/picture/picture.h"

/* POV-Ray's sampling method 1 without jitter. Pixels that differ from a neighbour by
 * more than the threshold get samples x samples rays. */
struct antialiasing {
    size_t samples;
    double threshold;
};

/* Renders the scene. Samples are linear light from 0 to 1, in steps of 1/65535. Only
 * the colours of the frame are set. how: NULL for one ray per pixel. POV-Ray's files
 * are in a temporary folder, which is removed. The caller frees the frame. After a
 * failure the error is the end of POV-Ray's output. */
bool run_povray(const char *scene, size_t width, size_t height,
                const struct antialiasing *how, struct frame *frame, c205_error *error);

/* These functions do the same for a text, with one ray per pixel. POV-Ray runs in
 * parallel between the two calls. It mostly waits for its own threads, so several
 * simultaneous runs cost little. povray_begin writes the text to a file in the current
 * folder; after an error it ends the program. povray_end removes the file and frees the
 * run. */
struct povray;
struct povray *povray_begin(const char *path, const char *text, size_t width,
                            size_t height);
bool povray_end(struct povray *run, struct frame *frame, c205_error *error);

#endif
