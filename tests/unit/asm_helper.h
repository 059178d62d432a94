/* asm_helper.h - texts to programs, for the tests of the assembler. */
#ifndef TESTS_ASM_HELPER_H
#define TESTS_ASM_HELPER_H

#include "asm/assemble.h"
#include "tests/unit/unit.h"

/* A text without errors, or a file. */
struct object *good(const char *text);
struct object *good_file(const char *path);
/* Calls a function with the path of each file of a pattern; how many there are. */
size_t each_file(const char *pattern, void (*use)(const char *path));
size_t count_of(const char *text, const char *part);

/* The clocks of a cause in all regions. */
uint64_t clocks_of_cause(const c205 *machine, c205_cause cause);
/* The clocks of all causes sum to the time. */
void assert_sum(const c205 *machine);

/* One error of a text: its place and a part of its message.  Column 0 matches any. */
struct asm_error {
    const char *text;
    size_t line, column;
    const char *message;
};

void assert_one_error(const struct diagnostics *errors, const char *text, size_t line,
                      size_t column, const char *message);
/* Each text has this one error. */
void assert_asm_errors(const struct asm_error *error, size_t count);
/* Each is assembled with this one warning; with none where the line is 0. */
void assert_asm_warnings(const struct asm_error *warning, size_t count);

/* The word at an address, 0 where there is none. */
c205_word word_of(const c205_program *program, uint64_t address);
void assert_same_program(const c205_program *a, const c205_program *b);

#endif
