/* projection.h - the time that another machine would take for a program.
 *
 * The program runs on this machine. Each scalar instruction that it executes is charged
 * the other machine's time for the same operation. The other machine is not emulated,
 * and its compiler would have produced another program.
 *
 * An operation takes time.CLASS. An instruction without a counterpart is charged as its
 * parts. A SWAP is a load or a store for each word. A branch that compares numbers is a
 * subtraction and a branch. A branch that adds to an index is an index addition and a
 * branch. A taken branch takes branch.taken if its target is at most
 * branch.stack_halves back, and otherwise branch.out_of_stack.
 *
 * With machine.overlap 0 the operations follow one another. With 1 they pass through
 * units under a scoreboard. An instruction issues, in order and at most one per
 * issue.interval, when a unit of its kind is free and no result is pending for its
 * result register. The unit begins when its operands are ready. It ends after its time,
 * but not before earlier instructions have read the register that it writes. A branch
 * waits for its operands and blocks issue until it has ended. Source: J. E. Thornton,
 * Design of a Computer: the Control Data 6600 (1970).
 */
#ifndef C205_PROJECTION_H
#define C205_PROJECTION_H

#include "vm/decode.h"

/* Charges an instruction that has executed. */
void projection_charge(c205_projection *projection, const struct decoded *decoded,
                       const struct effect *effect);

/* Returns the number of vector instructions in a region. If it is not 0, the clocks of
 * the region are meaningless. */
uint64_t projection_strangers(const c205_projection *projection, size_t region);
bool projection_complete(const c205_projection *projection, c205_error *error);

#endif
