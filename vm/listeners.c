/* listeners.c - the machine's own listeners. They pass on the input of the clock, which
 * other listeners cannot access.
 */
#include "vm/machine.h"
#include "vm/time/projection.h"
#include "vm/time/recording.h"

static bool was_executed(const c205_event *event)
{
    return event->kind == C205_EVENT_INSTRUCTION || event->kind == C205_EVENT_REQUEST;
}

void c205_project(void *projection, const c205 *machine, const c205_event *event)
{
    if (was_executed(event))
        projection_charge(projection, machine->executed, &machine->effect);
}

void c205_record(void *recording, const c205 *machine, const c205_event *event)
{
    if (was_executed(event))
        recording_add(recording, machine->executed, &machine->effect, event->region);
}
