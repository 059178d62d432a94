/* random_machine.h - machines loaded with random programs. */
#ifndef RANDOM_MACHINE_H
#define RANDOM_MACHINE_H

#include "tests/oracle/give_up.h"
#include "tests/oracle/plain_memory.h"
#include "tests/oracle/random_program.h"

/* Creates a machine for each model of random_models. Programs are loaded into these
 * machines. */
void random_machines_begin(void);
void random_machines_end(void);

/* Returns the machine of the program's model before its first step. */
c205 *random_machine_load(const struct random_program *program);
/* Like random_machine_load, for a machine that shares pages with other machines. */
c205 *random_machine_load_shared(const struct random_program *program,
                                 struct random_shared *shared);
/* Returns a hash of all shared pages. Replaces the program of the machine. */
uint64_t random_shared_hash(c205 *machine, const struct random_shared *shared);

/* Saves the machine. After an error, ends the program. */
void random_machine_save(const c205 *machine, c205_writer *write, void *context);
/* Returns a hash of the complete state. */
uint64_t machine_hash(const c205 *machine);

/* Maps a program's pages in empty memory and copies the machine's initial words. */
void random_machine_memory(const c205 *machine, const struct random_program *program,
                           struct plain_memory *memory);

/* Returns the length of the instruction at an address, in half words. Returns 1 if
 * there is no instruction, and 0 if there is no memory. */
unsigned random_insn_halves(const c205 *machine, uint64_t address);

/* --- other modes than step by step ----------------------------------------------
 *
 * The modes are:
 *
 * - as a whole;
 * - in slices, each of which ends at a limit of clocks;
 * - in slices between which the machine is saved and another machine is restored;
 * - with a listener, from the start or from some clock on;
 * - on pages shared with other machines, whose contents must not change.
 *
 * Instructions that trap are skipped. All modes must end in the same state, which
 * consists of everything that a saved machine contains, including clock and accounts.
 */

/* Returns NULL if the modes agree, else the name of a mode that differs. stepped is the
 * hash of a machine that ran step by step to the end of the program. If it is NULL,
 * this machine did not reach the end, and the modes are only compared with each
 * other. */
const char *disagreeing_way(const struct random_program *program,
                            const uint64_t *stepped);

#endif
