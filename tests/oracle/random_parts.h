/* random_parts.h - declarations that the parts of the program generator share. */
#ifndef RANDOM_PARTS_H
#define RANDOM_PARTS_H

#include "tests/oracle/random_program.h"

enum { WORD = 64, HALF = 32 };

bool one_in(uint64_t *random, int64_t n);
/* Returns counts, offsets and distances, mostly small. */
int64_t draw_integer(uint64_t *random);
uint64_t draw_length(uint64_t *random);

/* Registers are grouped in pools by their role in an instruction: n number, i integer,
 * h number and j integer in a half register, v vector of words, w of half words, b of
 * bits, x index list, k code address, s short vector for SWAP, f field of a register;
 * p, o, q vector of words, half words or bits whose offset is in the next register. */
unsigned draw_register(uint64_t *random, char role);
c205_word draw_descriptor(uint64_t *random, char role);
/* Returns the address of an instruction of the program; rarely not a multiple of a half
 * word. */
c205_word draw_code_address(uint64_t *random, const struct random_program *program);

/* Registers outside the pools: the remaining iterations of a loop, and its start. */
enum { LOOP_COUNT = 250, LOOP_BEGIN = 251 };
/* Registers of the scatter by which a loop changes the program. */
enum { REWRITE_LIST = 252, REWRITE_FROM, REWRITE_TABLE };

/* Fills the program with instructions. */
void draw_insns(uint64_t *random, struct random_program *program);

#endif
