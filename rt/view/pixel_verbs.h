/* pixel_verbs.h - debugger commands that concern a pixel. They run the debugged
 * program, which traces a band, until a queue contains a ray of the pixel, and print
 * the elements of this ray in vectors. */
#ifndef RT_PIXEL_VERBS_H
#define RT_PIXEL_VERBS_H

#include "asm/debug/debugger.h"
#include "rt/view/frame_pixel.h"

/* The debugger commands for a pixel. Their context is the struct frame_pixel. */
extern const struct debugger_verb pixel_verbs[];
/* Returns the machine of the pixel's band. */
c205 *pixel_machine(void *pixel, c205_error *error);
/* Returns the name of command i: first the commands of pixel_verbs, then those of every
 * debugger. Returns NULL after the last command. */
const char *pixel_verb(size_t i);

#endif
