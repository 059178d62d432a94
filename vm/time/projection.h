/* projection.h - the time that another machine would take for a program.
 *
 * The program runs on this machine; each scalar instruction that it executes
 * is charged the other machine's time for the same operation.  Nothing of that
 * machine is emulated, and its compiler would have made another program.
 *
 * An operation takes time.CLASS.  What has no counterpart there is what it is
 * made of: a SWAP is a load or a store for each word; a branch that compares
 * numbers is a subtraction and a branch, one that adds to an index an addition
 * of indices and a branch.  A taken branch takes branch.taken where its target
 * lies no more than branch.stack_halves back, else branch.out_of_stack.
 *
 * With machine.overlap 0 they follow one another.  With 1 they go through
 * units under a scoreboard: an instruction issues, in order and at most one
 * each issue.interval, when a unit of its kind is free and no result is on its
 * way to its register; the unit begins when its operands are there, ends after
 * its time, and no sooner than earlier instructions have read the register
 * that it writes.  A branch waits for its operands and holds up issue until it
 * has ended.  Source: J. E. Thornton, Design of a Computer: the Control Data
 * 6600 (1970).
 */
#ifndef C205_PROJECTION_H
#define C205_PROJECTION_H

#include "vm/decode.h"

/* Charge an instruction that has executed. */
void projection_charge(c205_projection *projection, const struct decoded *decoded,
                       const struct effect *effect);

/* Vector instructions in a region: its clocks say nothing if there are any. */
uint64_t projection_strangers(const c205_projection *projection, size_t region);
bool projection_complete(const c205_projection *projection, c205_error *error);

#endif
