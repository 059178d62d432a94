/* breakpoints.c - breakpoints and watchpoints: lists of addresses, and copies of the
 * watched words.
 */
#include "vm/breakpoints.h"

#include <stdlib.h>
#include <string.h>

struct watched {
    uint64_t address;
    size_t words;
    c205_word *held;
};

struct machine_breakpoints {
    size_t break_count, watch_count;
    uint64_t *breaks;
    struct watched *watches;
};

void machine_free_breakpoints(struct machine_breakpoints *breakpoints)
{
    if (!breakpoints)
        return;
    for (size_t i = 0; i < breakpoints->watch_count; i++)
        free(breakpoints->watches[i].held);
    free(breakpoints->watches);
    free(breakpoints->breaks);
    free(breakpoints);
}

/* Makes room for one more element. Returns false if the host is out of memory. */
static bool grow_array(void *array, size_t count, size_t size)
{
    void *grown = realloc(*(void **)array, (count + 1) * size);
    if (grown)
        *(void **)array = grown;
    return grown;
}

static struct machine_breakpoints *all_stops(struct c205 *machine)
{
    if (!machine->breakpoints)
        machine->breakpoints = calloc(1, sizeof *machine->breakpoints);
    machine->eventful |= machine->breakpoints != NULL;
    return machine->breakpoints;
}

/* Frees the lists if no breakpoint or watchpoint is left, so that the machine no longer
 * checks for them. */
static void leave_none(struct c205 *machine)
{
    struct machine_breakpoints *breakpoints = machine->breakpoints;
    if (breakpoints->break_count + breakpoints->watch_count > 0)
        return;
    machine_free_breakpoints(breakpoints);
    machine->breakpoints = NULL;
    machine->eventful = machine->listener_count > 0;
}

/* ---- Setting ------------------------------------------------------------- */

bool c205_break(c205 *machine, uint64_t address, bool set)
{
    struct machine_breakpoints *breakpoints;
    size_t i = 0;
    if (!set && !machine->breakpoints)
        return true;
    breakpoints = all_stops(machine);
    if (!breakpoints)
        return false;
    while (i < breakpoints->break_count && breakpoints->breaks[i] != address)
        i++;
    if (set == (i < breakpoints->break_count))
        return true;
    if (!set) {
        breakpoints->breaks[i] = breakpoints->breaks[--breakpoints->break_count];
        leave_none(machine);
        return true;
    }
    if (!grow_array(&breakpoints->breaks, i, sizeof *breakpoints->breaks)) {
        leave_none(machine);
        return false;
    }
    breakpoints->breaks[breakpoints->break_count++] = address;
    return true;
}

static void forget(struct machine_breakpoints *breakpoints, size_t i)
{
    free(breakpoints->watches[i].held);
    breakpoints->watches[i] = breakpoints->watches[--breakpoints->watch_count];
}

bool c205_watch(c205 *machine, uint64_t address, size_t words, bool set)
{
    struct machine_breakpoints *breakpoints;
    struct watched watched = { address, words, NULL };
    size_t i = 0;
    if (!set && !machine->breakpoints)
        return true;
    breakpoints = all_stops(machine);
    if (!breakpoints)
        return false;
    while (i < breakpoints->watch_count
           && (breakpoints->watches[i].address != address
               || breakpoints->watches[i].words != words))
        i++;
    if (set == (i < breakpoints->watch_count))
        return true;
    if (!set) {
        forget(breakpoints, i);
        leave_none(machine);
        return true;
    }
    watched.held = malloc((words + !words) * sizeof *watched.held);
    if (!watched.held || !c205_read(machine, address, watched.held, words)
        || !grow_array(&breakpoints->watches, i, sizeof *breakpoints->watches)) {
        free(watched.held);
        leave_none(machine);
        return false;
    }
    breakpoints->watches[breakpoints->watch_count++] = watched;
    return true;
}

/* ---- Checks ------------------------------------------------------------- */

void machine_sample_watchpoints(struct c205 *machine)
{
    struct machine_breakpoints *breakpoints = machine->resume.interrupted
                                                  ? NULL
                                                  : machine->breakpoints;
    for (size_t i = 0; breakpoints && i < breakpoints->watch_count; i++)
        c205_read(machine, breakpoints->watches[i].address,
                  breakpoints->watches[i].held, breakpoints->watches[i].words);
}

/* Compares watched words with their copy. A copy is valid for one run: a change ends
 * the run, and the next run takes a new copy. */
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

/* Returns true if the last instruction may have stored anything. */
static bool stored(const struct effect *effect)
{
    for (unsigned i = 0; i < effect->touch_count; i++)
        if (effect->touch[i].stored)
            return true;
    return effect->indices != NULL; /* a gather also has indices */
}

c205_trap machine_hits_breakpoint(struct c205 *machine, uint64_t *address)
{
    struct machine_breakpoints *breakpoints = machine->breakpoints;
    if (stored(&machine->effect))
        for (size_t i = 0; i < breakpoints->watch_count; i++)
            if (is_changed(machine, &breakpoints->watches[i])) {
                *address = breakpoints->watches[i].address;
                return C205_TRAP_WATCHPOINT;
            }
    for (size_t i = 0; i < breakpoints->break_count; i++)
        if (breakpoints->breaks[i] == machine->pc) {
            *address = machine->pc;
            return C205_TRAP_BREAKPOINT;
        }
    return C205_TRAP_NONE;
}
