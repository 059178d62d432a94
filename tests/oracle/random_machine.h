/* random_machine.h - machines loaded with random programs, and images of
 * what is to be in their memory. */
#ifndef RANDOM_MACHINE_H
#define RANDOM_MACHINE_H

#include "tests/oracle/plain_memory.h"
#include "tests/oracle/random_program.h"

/* Machines are made once for each model and loaded again for each program. */
void random_machines_begin(void);
void random_machines_end(void);

/* A message and the end: the host or the machine is at fault. */
void random_machine_fail(const char *what);

/* The machine of the program's model before its first step. */
c205 *random_machine_load(const struct random_program *program);
/* .. with pages in common with others. */
c205 *random_machine_load_shared(const struct random_program *program,
                                 struct random_shared *shared);
/* Of the words of all these pages, which the machine gives up its program for. */
uint64_t random_shared_hash(c205 *machine, const struct random_shared *shared);

/* What a machine has in its pages goes into the images, and what a program
 * finds there into memory, which is empty. */
void random_images_take(const c205 *machine, const struct random_program *program,
                        struct plain_memory *memory);

/* The word at an address, and those behind it in the same page; NULL: there
 * is no such page. */
c205_word *random_image(uint64_t address);

/* The length of the instruction at an address, in half words; 1 if there is
 * none; 0 where there is no memory. */
unsigned random_insn_halves(const c205 *machine, uint64_t address);

#endif
