/* events.h - notifies the listeners of executed instructions and of the end of a run;
 * see c205_machine.h. */
#ifndef C205_EVENTS_H
#define C205_EVENTS_H

#include "vm/machine.h"

/* Notifies the listeners of an executed instruction. before: the clock before the
 * instruction. */
void machine_notify_instruction(struct c205 *machine, const struct decoded *decoded,
                                uint64_t before);
/* Notifies the listeners of the end of a run. before: the clock up to which the run was
 * charged. drained: the clock has waited for everything in flight, and the record of
 * the event contains this wait. */
void machine_notify_stop(struct c205 *machine, const c205_stop *stop, uint64_t before,
                         bool drained);

#endif
