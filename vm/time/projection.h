/* projection.h - computes the time that another machine would take for a program.
 *
 * The program runs on this machine. Each scalar instruction that it executes is charged
 * the other machine's time for the same operation. The other machine is not emulated,
 * and its compiler would have produced another program.
 *
 * An operation takes time.CLASS. An instruction without a counterpart is charged as
 * several operations: a SWAP as a load or store for each word, a branch that compares
 * numbers as a subtraction and a branch, and a branch that adds to an index as an index
 * addition and a branch. A taken branch takes branch.taken if its target is at most
 * branch.stack_halves back, and otherwise branch.out_of_stack.
 *
 * The operations follow one another if machine.overlap is 0. They pass through units
 * under a scoreboard if it is 1. An instruction issues, in order and at most one per
 * issue.interval, when a unit of its kind is free and no result is pending for its
 * result register. The unit begins when its operands are ready. It ends after the time
 * of the operation, but not before earlier instructions have read its result register.
 * A branch waits for its operands and blocks issue until it has ended. Source: J. E.
 * Thornton, Design of a Computer: the Control Data 6600 (1970).
 */
#ifndef C205_PROJECTION_H
#define C205_PROJECTION_H

#include "vm/decode.h"

/* Charges an executed instruction. */
void projection_charge(c205_projection *projection, const struct decoded *decoded,
                       const struct effect *effect);

/* Returns the number of vector instructions in a region. The clocks of the region are
 * meaningless unless this number is 0. */
uint64_t projection_strangers(const c205_projection *projection, size_t region);
/* Returns false, with the error, if the host ran out of memory. */
bool projection_complete(const c205_projection *projection, c205_error *error);

#endif
