/* c205_history.h - saves machines, and returns a run to earlier steps. */
#ifndef C205_API_HISTORY_H
#define C205_API_HISTORY_H

#include "c205_machine.h"

/* ---- Saving and restoring (vm/save.c) --------------------------------------
 *
 * A saved machine is a list of bytes: format version, model, program, registers,
 * memory, the clock with everything in flight, and the progress of an interrupted
 * vector instruction. A listener must not save its machine. A restored machine
 * continues with the same results, clocks and accounts as the original. Listeners are
 * not saved.
 */

/* Receives the next `count` bytes of a saved machine. Returns false on failure, which
 * ends the saving. */
typedef bool c205_writer(void *context, const void *bytes, size_t count);

/* Saves a machine: passes its bytes to `write`. Returns false if `write` fails. */
bool c205_save(const c205 *machine, c205_writer *write, void *context,
               c205_error *error);
/* Returns a new machine from saved bytes. Returns NULL if the bytes are damaged, are
 * not a saved machine, or come from another version or from a model with other
 * constants. */
c205 *c205_restore(const void *bytes, size_t count, const c205_model *model,
                   c205_error *error);

/* ---- Going back (vm/history.c) ---------------------------------------------
 *
 * A machine that executes one instruction at a time and can return to any earlier step.
 * To go back, it restores the last snapshot before the step and runs again. State,
 * clock and accounts are the same as when the run first reached the step.
 */
typedef struct c205_history c205_history;

/* Returns a history that owns the machine; its current state is step 0. `budget` is the
 * maximum number of bytes of all snapshots. Two snapshots and the snapshots of
 * c205_history_changed are always kept. Fewer snapshots make going back slower. Returns
 * NULL if the host is out of memory; the machine then still belongs to the caller. */
c205_history *c205_history_new(c205 *machine, size_t budget, c205_error *error);
void c205_history_free(c205_history *history);
/* Returns the machine at the current step. Going back replaces the machine; the new one
 * has the same listeners. */
c205 *c205_history_machine(const c205_history *history);
/* Return numbers of steps: the current step, and the last step that has been
 * executed. */
uint64_t c205_history_step(const c205_history *history);
uint64_t c205_history_known(const c205_history *history);
/* Executes one instruction like c205_step. Returns the same stop again if the program
 * has ended. */
bool c205_history_forward(c205_history *history, c205_stop *stop);
/* Goes to an earlier step. Listeners are notified only of the last instruction that
 * runs again. Returns false if the host is out of memory. The machine is then unchanged
 * or at a step before the requested step. */
bool c205_history_back(c205_history *history, uint64_t step, c205_error *error);
/* Stores the state after the host has written registers or memory, and discards later
 * steps. Must be called after each such change. Returns false if the host is out of
 * memory; going back then leads to the state before the change. */
bool c205_history_changed(c205_history *history, c205_error *error);

#endif
