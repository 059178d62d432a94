/* c205_history.h - saved machines, and the return to earlier steps of a run. */
#ifndef C205_API_HISTORY_H
#define C205_API_HISTORY_H

#include "c205_machine.h"

/* ---- Saving and restoring (vm/save.c) --------------------------------------
 *
 * A machine that is not running (not in a listener) as a list of bytes: format version,
 * model, program, registers, memory, the clock with everything in flight, and the
 * progress of an interrupted vector instruction. A restored machine continues like the
 * saved one: same results, same clocks, same accounts. Listeners are not saved.
 */

/* Takes the next bytes. Returns false if it cannot, which ends the saving. */
typedef bool c205_writer(void *context, const void *bytes, size_t count);

bool c205_save(const c205 *machine, c205_writer *write, void *context,
               c205_error *error);
/* Returns a new machine from bytes saved on a model with the same constants. NULL: the
 * bytes are damaged, not a saved machine, or of another version or model. */
c205 *c205_restore(const void *bytes, size_t count, const c205_model *model,
                   c205_error *error);

/* ---- Going back (vm/history.c) ---------------------------------------------
 *
 * A machine that executes one instruction at a time and can return to any earlier step.
 * It uses snapshots and runs again from the last one before that step. State, clock and
 * accounts are those of a run that reached the step for the first time.
 */
typedef struct c205_history c205_history;

/* Returns a history that owns the machine; its current state is step 0. budget limits
 * the bytes of the snapshots, but two snapshots and those of c205_history_changed are
 * always kept. Fewer snapshots make going back slower. NULL: out of memory; the machine
 * still belongs to the caller. */
c205_history *c205_history_new(c205 *machine, size_t budget, c205_error *error);
void c205_history_free(c205_history *history);
/* Returns the machine at this step. After going back it is another machine with the
 * same listeners. */
c205 *c205_history_machine(const c205_history *history);
/* Return the instructions since step 0: of the current step, and of the last known
 * step. */
uint64_t c205_history_step(const c205_history *history);
uint64_t c205_history_known(const c205_history *history);
/* Executes one instruction like c205_step. If the program has ended, returns the same
 * stop again. */
bool c205_history_forward(c205_history *history, c205_stop *stop);
/* Goes to an earlier step. Listeners are notified only of the last instruction that
 * runs again. Returns false if memory is exhausted; the machine is then unchanged, or
 * at a step before the requested one. */
bool c205_history_back(c205_history *history, uint64_t step, c205_error *error);
/* Must be called after the host wrote registers or memory: later steps are discarded.
 * Returns false if memory is exhausted; going back then works as before the change. */
bool c205_history_changed(c205_history *history, c205_error *error);

#endif
