/* register_owners.h - whose value a register holds, while a program runs.
 *
 * Registers are shared by names that are not in use at one time.  This
 * listener keeps for each register under which name its value was put there,
 * and finds every instruction that reads it as another thing: a value that
 * was lost to somebody else, or one that was never there.
 *
 * A value that a SWAP puts into memory keeps its name there, so that it has it
 * still when the registers that a routine saved come back.  What is put into a
 * register by its number alone may be read under any name; so may the
 * registers behind the first of a SWAP, unless names were given to them one
 * after another from the first one's on.
 */
#ifndef ORACLE_REGISTER_OWNERS_H
#define ORACLE_REGISTER_OWNERS_H

#include "asm/assemble.h"

struct register_owners;

/* NULL: no memory.  The object must outlive it. */
struct register_owners *register_owners_new(const struct object *program);
void register_owners_free(struct register_owners *owners);
/* Its context are the owners. */
c205_listener register_owners_listen;

/* Registers that were read under a name. */
uint64_t register_owners_read(const struct register_owners *owners);
/* Different instructions that read a name's register under another one. */
size_t register_owners_found(const struct register_owners *owners);
/* One line each: where, and which names. */
void register_owners_print(const struct register_owners *owners,
                           const struct sink *sink);

#endif
