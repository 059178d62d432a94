/* random_machine.h - machines loaded with random programs, and images of their initial
 * memory. */
#ifndef RANDOM_MACHINE_H
#define RANDOM_MACHINE_H

#include "tests/oracle/give_up.h"
#include "tests/oracle/plain_memory.h"
#include "tests/oracle/random_program.h"

/* Machines are created once for each model and loaded again for each program. */
void random_machines_begin(void);
void random_machines_end(void);

/* Returns the machine of the program's model before its first step. */
c205 *random_machine_load(const struct random_program *program);
/* Returns that machine with shared pages. */
c205 *random_machine_load_shared(const struct random_program *program,
                                 struct random_shared *shared);
/* Returns a hash of all these pages; the machine's program is replaced. */
uint64_t random_shared_hash(c205 *machine, const struct random_shared *shared);

/* Saves the machine; gives up after an error. */
void random_machine_save(const c205 *machine, c205_writer *write, void *context);
/* Returns a hash of the complete state. */
uint64_t machine_hash(const c205 *machine);

/* Copies the machine's pages to the images, and the initial memory of a program to
 * memory, which is empty. */
void random_images_take(const c205 *machine, const struct random_program *program,
                        struct plain_memory *memory);

/* Returns the word at an address and those after it in the same page; NULL: there is no
 * such page. */
c205_word *random_image(uint64_t address);

/* Returns the length of the instruction at an address in half words: 1 if there is
 * none, 0 if there is no memory. */
unsigned random_insn_halves(const c205 *machine, uint64_t address);

#endif
