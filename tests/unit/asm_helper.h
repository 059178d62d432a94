/* asm_helper.h - texts to programs, for the tests of the assembler. */
#ifndef TESTS_ASM_HELPER_H
#define TESTS_ASM_HELPER_H

#undef expect_check /* ours is another */

#include "asm/assemble.h"
#include "tests/unit/unit.h"

/* A text without errors. */
struct object *good(const char *text);

/* The word at an address, 0 where there is none. */
c205_word word_of(const c205_program *program, uint64_t address);
void assert_same_program(const c205_program *a, const c205_program *b);

#endif
