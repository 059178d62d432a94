/* c205.h - an emulator of a CYBER 205 style vector computer.
 *
 * The machine is "205-style, reconstructed": docs/machine.md states which parts are
 * known and which are reconstructed. Its time is cycle-accounted: every clock of a run
 * is charged to one cause, and the causes sum to the total.
 *
 * Example:
 *
 *   c205_model *model = c205_model_find("cyber205-2pipe", &error);
 *   c205 *machine = c205_new(model, &error);
 *   c205_load(machine, &program, &error);
 *   c205_stop stop = c205_run(machine, C205_NO_LIMIT);
 *
 * Library functions never print and never exit. Those that can fail take a c205_error,
 * fill its message, and return false or NULL. A machine may be used by one thread at a
 * time. Different machines share no mutable state.
 *
 * Programs that use the library include only this header.
 */
#ifndef C205_H
#define C205_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The release of the library, and the model that programs use by default. */
#define C205_VERSION "0.7.0"
#define C205_DEFAULT_MODEL "cyber205-2pipe"

/* The headers of the interface. Each may use the earlier ones. */
#include "c205_word.h"
#include "c205_model.h"
#include "c205_machine.h"
#include "c205_time.h"
#include "c205_history.h"

#ifdef __cplusplus
}
#endif
#endif
