/* pixel_verbs.h - the verbs of a debugger of a band's program that concern a
 * pixel: continue to a queue with a ray of the pixel, and show the vectors'
 * elements of that ray. */
#ifndef RT_PIXEL_VERBS_H
#define RT_PIXEL_VERBS_H

#include "asm/debug/debugger.h"
#include "rt/view/frame_pixel.h"

/* The verbs. Their context is the pixel. */
extern const struct debugger_verb pixel_verbs[];
/* Returns the machine of the pixel's band. */
c205 *pixel_machine(void *pixel, c205_error *error);
/* Returns the i-th verb: these, then those of every debugger; NULL after the last. */
const char *pixel_verb(size_t i);

#endif
