/* register_owners.h - tracks under which name each register was written, while a
 * program runs.
 *
 * Names that are not in use at the same time share registers.  This listener records
 * for each register the name under which its value was written.  It reports every
 * instruction that reads the register under another name: the value was overwritten by
 * another name, or was never written.
 *
 * A value that a SWAP saves in memory keeps its name, and has it again after a routine
 * restores its registers.  A value that was written to a register by number may be read
 * under any name.  So may the registers after the first of a SWAP, unless names were
 * declared one after another from the first one.
 */
#ifndef ORACLE_REGISTER_OWNERS_H
#define ORACLE_REGISTER_OWNERS_H

#include "asm/object/object.h"

struct register_owners;

/* Returns NULL if memory is short.  The object must outlive the result. */
struct register_owners *register_owners_new(const struct object *program);
void register_owners_free(struct register_owners *owners);
/* The listener; its context is the register_owners. */
c205_listener register_owners_listen;

/* Returns the number of register reads under a name. */
uint64_t register_owners_read(const struct register_owners *owners);
/* Returns the number of different instructions that read a register under another name
 * than that of its value. */
size_t register_owners_found(const struct register_owners *owners);
/* Prints one line for each, with the place and the names. */
void register_owners_print(const struct register_owners *owners,
                           const struct sink *sink);

#endif
