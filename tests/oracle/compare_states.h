/* compare_states.h - runs a random program on the machine and on the reference, step by
 * step, and reports the first difference. */
#ifndef COMPARE_STATES_H
#define COMPARE_STATES_H

#include "tests/oracle/random_program.h"
#include "tests/oracle/reference.h"

enum { DIFFERENCES = 16, DIFFERENCE_TEXT = 120 };

/* The instruction after which the states differ, and the differences. */
struct difference {
    uint64_t step, pc;
    c205_word word; /* the instruction at pc */
    size_t count;   /* may exceed the number of stored texts */
    char texts[DIFFERENCES][DIFFERENCE_TEXT];
};

/* compare_begin creates a machine for each model. compare_run loads each program into
 * these machines. compare_end frees them. */
void compare_begin(void);
void compare_end(void);

/* Returns true if the machine and the reference agree. */
bool compare_run(const struct random_program *program, struct difference *difference);

void print_program(const struct random_program *program);
void print_difference(const struct difference *difference);

#endif
