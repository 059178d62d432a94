/* events.c - builds events and notifies the listeners. */
#include "vm/events.h"
#include "vm/time/projection.h"
#include "vm/time/recording.h"

#include <string.h>

static void notify_listeners(const struct c205 *machine, const c205_event *event)
{
    for (unsigned i = 0; i < machine->listener_count; i++)
        machine->listener[i].call(machine->listener[i].context, machine, event);
}

static c205_event make_event(const struct c205 *machine, c205_event_kind kind,
                             uint64_t before)
{
    c205_event event;
    memset(&event, 0, sizeof event);
    event.kind = kind;
    event.clocks = clock_now(machine->clock) - before;
    return event;
}

static void describe_register(c205_event *event, unsigned slot)
{
    if (slot > 0 && slot < C205_REGISTERS)
        event->written[slot / 64] |= UINT64_C(1) << slot % 64;
}

/* Returns the range from the lowest to the highest address that an instruction with an
 * index list accesses. */
static c205_range indexed_range(const struct effect *effect)
{
    uint64_t least = UINT64_MAX, greatest = 0;
    for (size_t i = 0; i < effect->index_count; i++) {
        uint64_t at = LOW(effect->table + effect->indices[i] * effect->table_step);
        least = at < least ? at : least;
        greatest = at > greatest ? at : greatest;
    }
    return (c205_range){ least, greatest - least + effect->table_step };
}

static void describe_changes(const struct c205 *machine, const struct decoded *decoded,
                             c205_event *event)
{
    const struct effect *effect = &machine->effect;
    for (unsigned i = 0; i < decoded->result_count; i++)
        describe_register(event, decoded->result[i]);
    for (size_t i = 0; i < effect->swapped - effect->saved; i++)
        describe_register(event, decoded->b + (unsigned)i);
    for (unsigned i = 0; i < effect->touch_count; i++)
        if (effect->touch[i].stored && event->store_count < C205_STORES)
            event->store[event->store_count++] = (c205_range){ effect->touch[i].address,
                                                               effect->touch[i].bits };
    if (decoded->insn->timing == C205_TIMING_vscatter && effect->index_count > 0
        && event->store_count < C205_STORES)
        event->store[event->store_count++] = indexed_range(effect);
}

void machine_notify_instruction(struct c205 *machine, const struct decoded *decoded,
                                uint64_t before)
{
    machine->executed = decoded;
    bool request = machine->request != NO_REQUEST && machine->request != REQUEST_EXIT;
    c205_event event = make_event(machine,
                                  request ? C205_EVENT_REQUEST : C205_EVENT_INSTRUCTION,
                                  before);
    event.pc = decoded->pc;
    event.issued = clock_issued(machine->clock);
    event.record = &machine->record;
    event.insn = decoded->insn;
    event.fields = decoded->fields;
    event.region = decoded->region;
    event.elements = machine->effect.elements;
    event.recurrent = machine->effect.recurrent;
    event.taken = machine->effect.taken;
    describe_changes(machine, decoded, &event);
    if (request) {
        event.request = machine->request;
        event.r = machine->slot[decoded->a];
        event.s = machine->slot[decoded->b];
    }
    notify_listeners(machine, &event);
}

void machine_notify_stop(struct c205 *machine, const c205_stop *stop, uint64_t before,
                         bool drained)
{
    c205_event event = make_event(machine,
                                  stop->trap ? C205_EVENT_TRAP : C205_EVENT_STOP,
                                  before);
    event.pc = stop->pc;
    event.record = drained ? &machine->record : NULL;
    event.insn = stop->insn;
    event.region = machine_region(machine, stop->pc);
    event.trap = stop->trap;
    notify_listeners(machine, &event);
}

bool c205_listen(c205 *machine, c205_listener *listener, void *context)
{
    if (machine->listener_count == C205_LISTENERS)
        return false;
    machine->listener[machine->listener_count].call = listener;
    machine->listener[machine->listener_count++].context = context;
    machine->eventful = true;
    clock_listen(machine->clock, &machine->record);
    return true;
}

/* ---- The machine's own listeners ---------------------------------------- */

/* Returns true for the events that charge clocks. For them, c205_project and
 * c205_record use the decoded instruction and its effect, which other listeners cannot
 * access. */
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
