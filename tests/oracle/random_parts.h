/* random_parts.h - declarations that the parts of the program generator share. */
#ifndef RANDOM_PARTS_H
#define RANDOM_PARTS_H

#include "tests/oracle/random_program.h"

enum { WORD = 64, HALF = 32 };

bool one_in(uint64_t *random, int64_t n);
/* Return counts, offsets and distances, most of which are small. */
int64_t draw_integer(uint64_t *random);
uint64_t draw_length(uint64_t *random);

/* The role of a register in an instruction selects its pool:
 *
 *     n, h     number, in a register or half register
 *     i, j     integer, in a register or half register
 *     v, w, b  vector of words, half words or bits
 *     p, o, q  the same, with the offset in the next register
 *     x        index list
 *     k        code address
 *     s        short vector for SWAP
 *     f        field of a register */
unsigned draw_register(uint64_t *random, char role);
c205_word draw_descriptor(uint64_t *random, char role);
/* Returns the address of an instruction, rarely no multiple of a half word. */
c205_word draw_code_address(uint64_t *random, const struct random_program *program);

/* Registers outside of the pools: a loop's remaining iterations and start address. */
enum { LOOP_COUNT = 250, LOOP_BEGIN = 251 };
/* Registers of the scatter with which a loop changes its code. */
enum { REWRITE_LIST = 252, REWRITE_FROM, REWRITE_TABLE };

/* Fills the program with random instructions. */
void draw_insns(uint64_t *random, struct random_program *program);

#endif
