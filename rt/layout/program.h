/* program.h - assembles kernels and runs them on a machine.
 *
 * The sources of the kernels are compiled into this library. A program is one kernel
 * and the files that it includes.
 */
#ifndef RT_PROGRAM_H
#define RT_PROGRAM_H

#include "asm/text/assemble.h"

/* Assembles a kernel with the constants in `defines`, as in asm_options. If the kernel
 * has an error, sets the first error and returns NULL; the build of the program is then
 * defective. */
struct object *program_assemble(const char *kernel, const struct asm_define *defines,
                                c205_error *error);

/* Runs a program to its end. go_on may be NULL. It is called at intervals and returns
 * whether to continue; if it returns false, *stopped is set. Returns false if the run
 * was stopped, or after a trap, which the error describes. */
bool program_run(c205 *machine, bool (*go_on)(void *context, const c205 *machine),
                 void *context, bool *stopped, c205_error *error);

/* Returns the bit address of the first page after the program. */
uint64_t program_end(const struct object *program);
/* Rounds an address up to the start of a page. */
uint64_t program_round_up(uint64_t address);

#endif
