/* random_debug_program.h - program random texts that end: a start, vectors, a loop. */
#ifndef TESTS_DRAWN_PROGRAM_H
#define TESTS_DRAWN_PROGRAM_H

#include <stdint.h>

enum { DRAWN_TEXT = 4096 };

/* Vectors of n elements, n turns of the loop; n is the caller's to define. */
void draw_program(uint64_t *state, char text[DRAWN_TEXT]);

#endif
