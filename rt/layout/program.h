/* program.h - the kernels as a program in a machine.
 *
 * The kernels are texts that this library carries with it; a program is one of
 * them and all that it includes.
 */
#ifndef RT_PROGRAM_H
#define RT_PROGRAM_H

#include "asm/assemble.h"

/* A kernel's text as a program.  The defines are constants for it, as in
 * asm_options.  NULL: the first error in it, a fault of the build. */
struct object *program_assemble(const char *kernel, const struct asm_define *defines,
                                c205_error *error);

/* Run to the program's end.  go_on is called now and then and says whether to
 * (NULL: always); when it says no, *stopped is set.  False: stopped, or a trap,
 * which the error tells. */
bool program_run(c205 *machine, bool (*go_on)(void *context, const c205 *machine),
                 void *context, bool *stopped, c205_error *error);

/* The first page that the program leaves free: its bit address. */
uint64_t program_end(const struct object *program);
/* The next page from an address on that begins at a page. */
uint64_t program_round_up(uint64_t address);

#endif
