/* run_povray.h - POV-Ray's picture of a scene file. */
#ifndef RUN_POVRAY_H
#define RUN_POVRAY_H

#include "rt/picture/picture.h"

/* Without antialiasing, as linear light between 0 and 1 in steps of 1/65535;
 * colours only.  Its files stay in a temporary folder that is removed.  The
 * caller frees the frame.  Fails with POV-Ray's own last words. */
bool run_povray(const char *scene, size_t width, size_t height,
                struct frame *frame, struct picture_error *error);

/* The same in two steps: between them POV-Ray is at work by itself.  It waits
 * for its own threads most of the time, so several runs at once cost little.
 * povray_begin: NULL, and the error says why; povray_end frees the run. */
struct povray;
struct povray *povray_begin(const char *scene, size_t width, size_t height,
                            struct picture_error *error);
bool povray_end(struct povray *run, struct frame *frame,
                struct picture_error *error);

#endif
