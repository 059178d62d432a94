/* shrink_program.h - the smallest program found on which they differ. */
#ifndef SHRINK_PROGRAM_H
#define SHRINK_PROGRAM_H

#include "tests/oracle/random_program.h"

/* Leaves out instructions and makes registers simpler as long as the machine
 * and the reference still differ somewhere. */
void shrink_program(struct random_program *program);

#endif
