/* random_stepping.h - random programs for a debugger to step through: loops with vector
 * instructions, calls, stores and prints. */
#ifndef TESTS_RANDOM_STEPPING_H
#define TESTS_RANDOM_STEPPING_H

#include <stdint.h>

#include "base/sink.h"

/* Makes a program. The caller frees the text. */
void draw_walk(uint64_t *state, struct text_buffer *text);

#endif
