/* history.c - returns a machine to earlier steps by snapshots and repeated execution.
 *
 * A machine that is restored from a saved state repeats the same execution. The history
 * therefore stores only snapshots. To go back, it restores the last snapshot before the
 * target and runs from there.
 */
#include "vm/breakpoints.h"
#include "vm/error.h"

#include <stdlib.h>
#include <string.h>

/* A snapshot is taken after STEPS_APART instructions or CLOCKS_APART clocks, whichever
 * comes first. The limit in clocks is for long vector instructions. Running from a
 * snapshot to the next takes some milliseconds. */
enum { STEPS_APART = 512, CLOCKS_APART = 1 << 20 };
/* The distances between snapshots, in steps and in clocks, are doubled up to this
 * limit. */
#define MAX_STEPS_APART (UINT64_C(1) << 50)

struct snapshot {
    uint64_t step, clock;
    bool changed; /* modified by the host; a run that reaches this step continues from
                     this state */
    size_t size;
    unsigned char *bytes;
};

struct c205_history {
    c205 *machine;
    uint64_t step;          /* instructions since the first snapshot */
    uint64_t known;         /* the last step that has been executed and not discarded */
    bool ended;             /* the program ended after the last known step */
    c205_stop end;          /* how it ended */
    size_t budget, held;    /* bytes of snapshots: maximum, current */
    uint64_t steps, clocks; /* instructions and clocks between snapshots */
    size_t count, capacity;
    struct snapshot *list; /* in the order of steps */
};

/* ---- Snapshots ----------------------------------------------------------- */

struct saved {
    unsigned char *bytes;
    size_t size, capacity;
};

static bool add_bytes(void *context, const void *bytes, size_t count)
{
    struct saved *saved = context;
    size_t wanted = saved->size + count;
    if (wanted > saved->capacity) {
        size_t capacity = wanted + wanted / 2 + 4096;
        unsigned char *grown = realloc(saved->bytes, capacity);
        if (!grown)
            return false;
        saved->bytes = grown;
        saved->capacity = capacity;
    }
    memcpy(saved->bytes + saved->size, bytes, count);
    saved->size = wanted;
    return true;
}

static bool grow_snapshots(struct c205_history *history)
{
    size_t capacity = 2 * history->capacity + 16;
    struct snapshot *grown;
    if (history->count < history->capacity)
        return true;
    grown = realloc(history->list, capacity * sizeof *grown);
    if (!grown)
        return false;
    history->list = grown;
    history->capacity = capacity;
    return true;
}

static void drop(struct c205_history *history, size_t i)
{
    history->held -= history->list[i].size;
    free(history->list[i].bytes);
}

static void double_distances(struct c205_history *history)
{
    if (history->steps >= MAX_STEPS_APART)
        return;
    history->steps *= 2;
    history->clocks *= 2;
}

/* Drops every second snapshot and doubles the distances if it dropped any. It keeps the
 * first snapshot and snapshots after a change by the host, because a run cannot
 * reproduce them. */
static void thin(struct c205_history *history)
{
    size_t kept = 0, before = history->count;
    for (size_t i = 0; i < history->count; i++)
        if (i % 2 == 0 || history->list[i].changed)
            history->list[kept++] = history->list[i];
        else
            drop(history, i);
    history->count = kept;
    if (kept < before)
        double_distances(history);
}

static bool save_state(const struct c205_history *history, struct saved *saved,
                       c205_error *error)
{
    *saved = (struct saved){ NULL, 0, 0 };
    if (c205_save(history->machine, add_bytes, saved, error))
        return true;
    free(saved->bytes);
    return error_set(error, "out of memory");
}

/* Appends a snapshot. The list must have room for it. */
static void append(struct c205_history *history, struct saved saved, bool changed)
{
    unsigned char *shrunk;
    shrunk = realloc(saved.bytes, saved.size);
    history->list[history->count++] = (struct snapshot){
        history->step, clock_now(history->machine->clock), changed, saved.size,
        shrunk ? shrunk : saved.bytes
    };
    history->held += saved.size;
    if (history->held > history->budget && history->count > 2)
        thin(history);
}

static bool store_snapshot(struct c205_history *history, c205_error *error)
{
    struct saved saved;
    if (!grow_snapshots(history) || !save_state(history, &saved, error))
        return error_set(error, "out of memory");
    append(history, saved, false);
    return true;
}

/* Drops the snapshots of the current step and later steps, which are no longer
 * valid. */
static void forget_later(struct c205_history *history)
{
    while (history->count > 0
           && history->list[history->count - 1].step >= history->step)
        drop(history, --history->count);
    history->known = history->step;
    history->ended = false;
}

static bool is_time(const struct c205_history *history)
{
    const struct snapshot *last = &history->list[history->count - 1];
    uint64_t clock = clock_now(history->machine->clock);
    return history->step > last->step
           && (history->step - last->step >= history->steps
               || clock - last->clock >= history->clocks);
}

/* Returns the index of the last snapshot at or before a step. */
static size_t find_snapshot(const struct c205_history *history, uint64_t step)
{
    size_t low = 0, high = history->count;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (history->list[middle].step <= step)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* ---- Creation and end --------------------------------------------------- */

c205_history *c205_history_new(c205 *machine, size_t budget, c205_error *error)
{
    struct c205_history *history = calloc(1, sizeof *history);
    if (!history) {
        error_set(error, "out of memory");
        return NULL;
    }
    history->machine = machine;
    history->budget = budget;
    history->steps = STEPS_APART;
    history->clocks = CLOCKS_APART;
    if (store_snapshot(history, error))
        return history;
    free(history->list);
    free(history);
    return NULL;
}

void c205_history_free(c205_history *history)
{
    if (!history)
        return;
    while (history->count > 0)
        drop(history, --history->count);
    free(history->list);
    c205_free(history->machine);
    free(history);
}

c205 *c205_history_machine(const c205_history *history)
{
    return history->machine;
}

uint64_t c205_history_step(const c205_history *history)
{
    return history->step;
}

uint64_t c205_history_known(const c205_history *history)
{
    return history->known;
}

bool c205_history_changed(c205_history *history, c205_error *error)
{
    struct saved saved;
    if (!grow_snapshots(history) || !save_state(history, &saved, error))
        return error_set(error, "out of memory");
    forget_later(history);
    append(history, saved, true);
    return true;
}

/* ---- Replacing the machine ---------------------------------------------- */

static void replace(struct c205_history *history, c205 *machine)
{
    c205 *old = history->machine;
    memcpy(machine->listener, old->listener, sizeof machine->listener);
    machine->listener_count = old->listener_count;
    machine->breakpoints = old->breakpoints;
    old->breakpoints = NULL;
    machine->eventful = machine->listener_count > 0 || machine->breakpoints;
    if (machine->eventful)
        clock_listen(machine->clock, &machine->record);
    c205_free(history->machine);
    history->machine = machine;
}

static c205 *restore(const struct c205_history *history, const struct snapshot *from,
                     c205_error *error)
{
    return c205_restore(from->bytes, from->size, history->machine->model, error);
}

/* If the host changed the machine at this step, restores the state after the change. */
static bool take_change(struct c205_history *history)
{
    const struct snapshot *here = &history->list[find_snapshot(history, history->step)];
    c205_error error;
    c205 *machine;
    if (here->step != history->step || !here->changed)
        return true;
    machine = restore(history, here, &error);
    if (machine)
        replace(history, machine);
    return machine;
}

/* ---- Forward ------------------------------------------------------------ */

/* Executes one step. A step that was executed before has the same result again. */
static bool forward(struct c205_history *history, c205_stop *stop)
{
    bool goes_on;
    if (history->ended && history->step == history->known) {
        *stop = history->end;
        return false;
    }
    goes_on = c205_step(history->machine, stop);
    if (!goes_on && stop->trap != C205_TRAP_NONE && !trap_is_behind(stop->trap))
        return false;
    if (++history->step > history->known)
        history->known = history->step;
    else if (!take_change(history)) {
        stop->trap = C205_TRAP_NO_MEMORY;
        return false;
    }
    if (!goes_on && !trap_is_behind(stop->trap)) {
        history->ended = true;
        history->end = *stop;
    }
    return goes_on;
}

bool c205_history_forward(c205_history *history, c205_stop *stop)
{
    bool goes_on = forward(history, stop);
    c205_error error;
    if (goes_on && is_time(history) && !store_snapshot(history, &error))
        double_distances(history);
    return goes_on;
}

/* ---- Back ---------------------------------------------------------------- */

/* Runs to a step. The listeners are notified only of the last instruction. */
static bool go_from(struct c205_history *history, c205 *machine, uint64_t first,
                    uint64_t step)
{
    c205_stop stop;
    history->step = first;
    while (history->step + 1 < step && c205_step(machine, &stop))
        history->step++;
    replace(history, machine);
    if (history->step < step)
        forward(history, &stop);
    return history->step == step;
}

bool c205_history_back(c205_history *history, uint64_t step, c205_error *error)
{
    const struct snapshot *from;
    c205 *machine;
    if (step >= history->step)
        return true;
    from = &history->list[find_snapshot(history, step > 0 ? step - 1 : 0)];
    machine = restore(history, from, error);
    if (!machine || go_from(history, machine, from->step, step))
        return machine;
    return error_set(error, "out of memory");
}
