/* pixel_verbs.h - debugger commands that concern a pixel. They continue to a queue with
 * a ray of the pixel, and show the elements of this ray in vectors. The debugged
 * program traces a band. */
#ifndef RT_PIXEL_VERBS_H
#define RT_PIXEL_VERBS_H

#include "asm/debug/debugger.h"
#include "rt/view/frame_pixel.h"

/* The commands. Their context is the pixel. */
extern const struct debugger_verb pixel_verbs[];
/* Returns the machine of the pixel's band. */
c205 *pixel_machine(void *pixel, c205_error *error);
/* Returns the name of command i. The commands of every debugger follow these commands.
 * Returns NULL after the last command. */
const char *pixel_verb(size_t i);

#endif
