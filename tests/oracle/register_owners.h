/* register_owners.h - tracks the names under which registers are written while a
 * program runs.
 *
 * Names that are not in use at the same time share registers.  This listener records
 * for each register the name under which its value was written.  It reports every
 * instruction that reads the register under another name. In this case another value
 * has overwritten the expected value, or the expected value was never written.
 *
 * A value that a SWAP saves in memory has the same name when the routine has restored
 * its registers. A value that was written to a register by number may be read under any
 * name. This is also true of the registers after the first register of a SWAP, unless
 * their names were declared in sequence from the first one.
 */
#ifndef ORACLE_REGISTER_OWNERS_H
#define ORACLE_REGISTER_OWNERS_H

#include "asm/object/object.h"

struct register_owners;

/* Returns a listener's state. NULL: out of memory. The object must outlive the
 * state. */
struct register_owners *register_owners_new(const struct object *program);
void register_owners_free(struct register_owners *owners);
/* The listener. Its context is a struct register_owners. */
c205_listener register_owners_listen;

/* Returns the number of register reads under a name. */
uint64_t register_owners_read(const struct register_owners *owners);
/* Returns the number of instructions that read a value under another name. */
size_t register_owners_found(const struct register_owners *owners);
/* Prints a line for each of these instructions, with the place and the names. */
void register_owners_print(const struct register_owners *owners,
                           const struct sink *sink);

#endif
