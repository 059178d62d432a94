/* asm_helper.h - assembles texts and checks the results for the assembler's tests. */
#ifndef TESTS_ASM_HELPER_H
#define TESTS_ASM_HELPER_H

#include "asm/text/assemble.h"
#include "tests/unit/unit.h"

/* Assembles a text or a file. If there is an error, the test fails. */
struct object *good(const char *text);
struct object *good_file(const char *path);
/* Calls `use` with each path that matches the pattern. Returns their number. */
size_t each_file(const char *pattern, void (*use)(const char *path));
size_t count_of(const char *text, const char *part);

/* Returns the clocks of a cause, summed over all regions. */
uint64_t clocks_of_cause(const c205 *machine, c205_cause cause);
/* Fails unless the clocks of all causes sum to the machine's time. */
void assert_sum(const c205 *machine);

/* The only error of a text. Column 0 matches any column. */
struct asm_error {
    const char *text;
    size_t line, column;
    const char *message;
};

void assert_one_error(const struct diagnostics *errors, const char *text, size_t line,
                      size_t column, const char *message);
/* Fails unless each text has exactly one error, the given one. */
void assert_asm_errors(const struct asm_error *error, size_t count);
/* Fails unless each text has exactly the given warning, or none for line 0. */
void assert_asm_warnings(const struct asm_error *warning, size_t count);

/* Returns the word at an address, or 0 if the program has no word there. */
c205_word word_of(const c205_program *program, uint64_t address);
void assert_same_program(const c205_program *a, const c205_program *b);

#endif
