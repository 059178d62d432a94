/* random_walk.h - random programs for a debugger to walk through: loops with vectors, calls
 * and what is stored and printed among them.
 */
#ifndef TESTS_DRAWN_WALK_H
#define TESTS_DRAWN_WALK_H

#include <stdint.h>

#include "base/sink.h"

/* The text is to be freed. */
void draw_walk(uint64_t *state, struct text_buffer *text);

#endif
