/* compare_states.h - a random program on the machine and on the reference,
 * step by step, and what differs first. */
#ifndef COMPARE_STATES_H
#define COMPARE_STATES_H

#include "tests/oracle/random_program.h"
#include "tests/oracle/reference.h"

enum { DIFFERENCES = 16, DIFFERENCE_TEXT = 120 };

/* After which instruction they differed, and in what. */
struct difference {
    uint64_t step, pc;
    c205_word word; /* the instruction there */
    size_t count;   /* may be more than are told */
    char texts[DIFFERENCES][DIFFERENCE_TEXT];
};

/* Machines are made once for each model and loaded again for each program. */
void compare_begin(void);
void compare_end(void);

/* True: they agree. */
bool compare_run(const struct random_program *program, struct difference *difference);

void print_program(const struct random_program *program);
void print_difference(const struct difference *difference);

#endif
