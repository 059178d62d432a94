/* shrink_program.h - shrinks a program on which the machine and the reference
 * differ. */
#ifndef SHRINK_PROGRAM_H
#define SHRINK_PROGRAM_H

#include "tests/oracle/random_program.h"

/* Removes instructions and simplifies registers while the machine and the reference
 * still differ. */
void shrink_program(struct random_program *program);

#endif
