#include "vm/stops.h"

#include <stdlib.h>
#include <string.h>

struct watched {
    uint64_t address;
    size_t words;
    c205_word *held;
};

struct machine_stops {
    size_t break_count, watch_count;
    uint64_t *breaks;
    struct watched *watches;
};

void machine_free_stops(struct machine_stops *stops)
{
    if (!stops)
        return;
    for (size_t i = 0; i < stops->watch_count; i++)
        free(stops->watches[i].held);
    free(stops->watches);
    free(stops->breaks);
    free(stops);
}

/* Room for one more; false: no memory. */
static bool make_room(void *array, size_t count, size_t size)
{
    void *grown = realloc(*(void **)array, (count + 1) * size);
    if (grown)
        *(void **)array = grown;
    return grown;
}

static struct machine_stops *all_stops(struct c205 *machine)
{
    if (!machine->stops)
        machine->stops = calloc(1, sizeof *machine->stops);
    machine->eventful |= machine->stops != NULL;
    return machine->stops;
}

/* Without any the machine goes as fast as before. */
static void leave_none(struct c205 *machine)
{
    struct machine_stops *stops = machine->stops;
    if (stops->break_count + stops->watch_count > 0)
        return;
    machine_free_stops(stops);
    machine->stops = NULL;
    machine->eventful = machine->listener_count > 0;
}

/* ---- Setting ------------------------------------------------------------- */

bool c205_break(c205 *machine, uint64_t address, bool set)
{
    struct machine_stops *stops;
    size_t i = 0;
    if (!set && !machine->stops)
        return true;
    stops = all_stops(machine);
    if (!stops)
        return false;
    while (i < stops->break_count && stops->breaks[i] != address)
        i++;
    if (set == (i < stops->break_count))
        return true;
    if (!set) {
        stops->breaks[i] = stops->breaks[--stops->break_count];
        leave_none(machine);
        return true;
    }
    if (!make_room(&stops->breaks, i, sizeof *stops->breaks)) {
        leave_none(machine);
        return false;
    }
    stops->breaks[stops->break_count++] = address;
    return true;
}

static void forget(struct machine_stops *stops, size_t i)
{
    free(stops->watches[i].held);
    stops->watches[i] = stops->watches[--stops->watch_count];
}

bool c205_watch(c205 *machine, uint64_t address, size_t words, bool set)
{
    struct machine_stops *stops;
    struct watched watched = { address, words, NULL };
    size_t i = 0;
    if (!set && !machine->stops)
        return true;
    stops = all_stops(machine);
    if (!stops)
        return false;
    while (
        i < stops->watch_count
        && (stops->watches[i].address != address || stops->watches[i].words != words))
        i++;
    if (set == (i < stops->watch_count))
        return true;
    if (!set) {
        forget(stops, i);
        leave_none(machine);
        return true;
    }
    watched.held = malloc((words + !words) * sizeof *watched.held);
    if (!watched.held || !c205_read(machine, address, watched.held, words)
        || !make_room(&stops->watches, i, sizeof *stops->watches)) {
        free(watched.held);
        leave_none(machine);
        return false;
    }
    stops->watches[stops->watch_count++] = watched;
    return true;
}

/* ---- Meeting ------------------------------------------------------------- */

void machine_sample_stops(struct c205 *machine)
{
    struct machine_stops *stops = machine->resume.interrupted ? NULL : machine->stops;
    for (size_t i = 0; stops && i < stops->watch_count; i++)
        c205_read(machine, stops->watches[i].address, stops->watches[i].held,
                  stops->watches[i].words);
}

/* It is as it was held until the run ends, which a change makes it do. */
static bool is_changed(const struct c205 *machine, const struct watched *watched)
{
    for (size_t i = 0; i < watched->words; i++) {
        c205_word word;
        if (c205_read(machine, watched->address + i * WORD_BITS, &word, 1)
            && word != watched->held[i])
            return true;
    }
    return false;
}

/* Whether the last instruction stored anything. */
static bool stored(const struct effect *effect)
{
    for (unsigned i = 0; i < effect->touch_count; i++)
        if (effect->touch[i].stored)
            return true;
    return effect->indices != NULL; /* a gather stores as well */
}

c205_trap machine_meets_stop(struct c205 *machine, uint64_t *address)
{
    struct machine_stops *stops = machine->stops;
    if (stored(&machine->effect))
        for (size_t i = 0; i < stops->watch_count; i++)
            if (is_changed(machine, &stops->watches[i])) {
                *address = stops->watches[i].address;
                return C205_TRAP_WATCHPOINT;
            }
    for (size_t i = 0; i < stops->break_count; i++)
        if (stops->breaks[i] == machine->pc) {
            *address = machine->pc;
            return C205_TRAP_BREAKPOINT;
        }
    return C205_TRAP_NONE;
}
