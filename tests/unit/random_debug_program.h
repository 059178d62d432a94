/* random_debug_program.h - makes random programs of scalar and vector instructions, some
 * with a loop that ends. */
#ifndef TESTS_RANDOM_DEBUG_PROGRAM_H
#define TESTS_RANDOM_DEBUG_PROGRAM_H

#include <stdint.h>

enum { DRAWN_TEXT = 4096 };

/* Writes a program with vectors of n elements and loops of n iterations. The caller
 * defines n. */
void draw_program(uint64_t *state, char text[DRAWN_TEXT]);

#endif
