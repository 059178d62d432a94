/* pixel_verbs.h - what a debugger of a band's program can be told of a pixel: to continue to a
 * queue that a ray of it is in, and to show what its vectors have of that ray. */
#ifndef RT_PIXEL_VERBS_H
#define RT_PIXEL_VERBS_H

#include "asm/debug/debugger.h"
#include "rt/view/frame_pixel.h"

/* Their context is the pixel. */
extern const struct debugger_verb pixel_verbs[];
/* The machine of its band; likewise. */
c205 *pixel_machine(void *pixel, c205_error *error);
/* These verbs, then those of every debugger; NULL behind the last. */
const char *pixel_verb(size_t i);

#endif
