/* events.h - what listeners are told; see c205.h. */
#ifndef C205_EVENTS_H
#define C205_EVENTS_H

#include "vm/machine.h"

/* Of an instruction that has been executed; before: the clock then. */
void machine_notify_instruction(struct c205 *machine, const struct decoded *decoded,
                                uint64_t before);
/* Of the end of a run that had been charged up to a clock; drained: with all that was in
 * flight. */
void machine_notify_stop(struct c205 *machine, const c205_stop *stop, uint64_t before,
                         bool drained);

#endif
