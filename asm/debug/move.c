/* move.c - forward and back. */
#include <inttypes.h>

#include "asm/debug/parts.h"

/* How a movement ended. */
enum moved {
    MOVED_ON,
    MOVED_TO_STOP,
    MOVED_TO_HALT,
    MOVED_INTERRUPTED,
    MOVED_TOO_FAR
};

static uint64_t here(const struct debugger *debugger)
{
    return c205_history_step(debugger->history);
}

static uint64_t clock_of(const struct debugger *debugger)
{
    return c205_clock(machine_of(debugger));
}

/* ---- Forward -------------------------------------------------------------- */

static enum moved forward(struct debugger *debugger)
{
    uint64_t before = c205_pc(machine_of(debugger));

    debugger->halted = !c205_history_forward(debugger->history,
                                             &debugger->halt);
    if (debugger->halted)
        return MOVED_TO_HALT;
    return stops_meet(debugger, before) ? MOVED_TO_STOP : MOVED_ON;
}

static bool is_interrupted(const struct debugger *debugger)
{
    return debugger->setup.interrupted && debugger->setup.interrupted();
}

/* Whether a movement that began at a clock goes on. */
static enum moved look_up(const struct debugger *debugger, uint64_t begun)
{
    enum { SELDOM = 4096 };

    if (clock_of(debugger) - begun > debugger->setup.clocks_most)
        return MOVED_TOO_FAR;
    return here(debugger) % SELDOM == 0 && is_interrupted(debugger)
               ? MOVED_INTERRUPTED
               : MOVED_ON;
}

/* What ends a movement besides stops. */
struct aim {
    uint64_t count;  /* instructions */
    bool at_address; /* or, behind one instruction at least, this: */
    uint64_t address;
    /* or likewise what a caller knows; NULL: nothing */
    bool (*is_there)(void *context, const c205 *machine);
    void *context;
};

static bool is_reached(const struct aim *aim, const c205 *machine)
{
    return (aim->at_address && c205_pc(machine) == aim->address)
           || (aim->is_there && aim->is_there(aim->context, machine));
}

static enum moved advance(struct debugger *debugger, struct aim aim)
{
    uint64_t begun = clock_of(debugger);
    enum moved moved = MOVED_ON;

    stops_sample(debugger);
    for (uint64_t i = 0; i < aim.count && moved == MOVED_ON; i++) {
        moved = forward(debugger);
        if (moved == MOVED_ON)
            moved = look_up(debugger, begun);
        if (is_reached(&aim, machine_of(debugger)))
            break;
    }
    return moved;
}

static struct aim at_most(uint64_t count)
{
    return (struct aim){ .count = count };
}

static struct aim to_address(uint64_t address)
{
    return (struct aim){ .count = UINT64_MAX,
                         .at_address = true,
                         .address = address };
}

static bool arrive(struct debugger *debugger, enum moved moved)
{
    show_end_line(debugger);
    if (moved == MOVED_TO_STOP)
        stops_pass(debugger, true);
    else if (moved == MOVED_INTERRUPTED)
        sink_put(&debugger->out, "interrupted\n");
    else if (moved == MOVED_TOO_FAR)
        sink_print(&debugger->out,
                   "%" PRIu64 " clocks have passed; continue goes on\n",
                   debugger->setup.clocks_most);
    show_place(debugger);
    return true;
}

/* 1 unless the line says another. */
static bool read_times(struct debugger *debugger, struct rest *rest,
                       uint64_t *count)
{
    *count = 1;
    return rest_end(rest)
           || (debug_count(debugger, rest, count)
               && rest_finish(debugger, rest));
}

bool verb_step(struct debugger *debugger, struct rest *rest)
{
    uint64_t count;

    return read_times(debugger, rest, &count)
           && arrive(debugger, advance(debugger, at_most(count)));
}

bool verb_continue(struct debugger *debugger, struct rest *rest)
{
    enum moved moved = MOVED_ON;
    uint64_t count;

    if (!read_times(debugger, rest, &count))
        return false;
    for (; count > 0; count--) {
        moved = advance(debugger, at_most(UINT64_MAX));
        if (moved != MOVED_TO_STOP)
            break;
        if (count > 1)
            stops_pass(debugger, false);
    }
    return arrive(debugger, moved);
}

/* A call and all that it does is one. */
static enum moved go_next(struct debugger *debugger)
{
    uint64_t pc = c205_pc(machine_of(debugger));
    enum moved moved = advance(debugger, at_most(1));
    uint64_t halves = c205_format_halves(C205_FORMAT_CALL);

    if (moved != MOVED_ON || !debugger->has_last || !debugger->last.taken
        || debugger->last.insn->format != C205_FORMAT_CALL)
        return moved;
    return advance(debugger, to_address(pc + 32 * halves));
}

bool verb_next(struct debugger *debugger, struct rest *rest)
{
    enum moved moved = MOVED_ON;
    uint64_t count;

    if (!read_times(debugger, rest, &count))
        return false;
    for (; count > 0 && moved == MOVED_ON; count--)
        moved = go_next(debugger);
    return arrive(debugger, moved);
}

bool verb_until(struct debugger *debugger, struct rest *rest)
{
    uint64_t address;

    if (!place_address(debugger, rest, &address)
        || !rest_finish(debugger, rest))
        return false;
    address = place_of(debugger, address);
    return arrive(debugger, advance(debugger, to_address(address)));
}

void debugger_seek(struct debugger *debugger,
                   bool (*is_there)(void *context, const c205 *machine),
                   void *context)
{
    const struct aim aim = { .count = UINT64_MAX,
                             .is_there = is_there,
                             .context = context };

    arrive(debugger, advance(debugger, aim));
}

/* ---- Back ----------------------------------------------------------------- */

static bool go_back(struct debugger *debugger, uint64_t step)
{
    c205_error error = { "no memory" };

    if (step < here(debugger)) {
        debugger->halted = debugger->has_end = false;
        debugger->has_last = step > 0;
    }
    if (!c205_history_back(debugger->history, step, &error))
        return debug_fault(debugger, "%s", error.message);
    stops_sample(debugger);
    return true;
}

bool verb_reverse_step(struct debugger *debugger, struct rest *rest)
{
    uint64_t count, step = here(debugger);

    if (!read_times(debugger, rest, &count))
        return false;
    if (step == 0)
        sink_put(&debugger->out, "this is the beginning\n");
    if (!go_back(debugger, count < step ? step - count : 0))
        return false;
    show_place(debugger);
    return true;
}

/* The last step with a stop behind one step, before another; 0: there is none. */
static uint64_t find_last(struct debugger *debugger, uint64_t from,
                          uint64_t end)
{
    uint64_t found = 0;

    if (!go_back(debugger, from))
        return 0;
    while (here(debugger) + 1 < end) {
        enum moved moved = forward(debugger);

        if (moved == MOVED_TO_HALT)
            break;
        if (moved != MOVED_TO_STOP)
            continue;
        found = here(debugger);
        stops_sample(debugger);
    }
    return found;
}

/* What is watched held before the change. */
static bool arrive_back(struct debugger *debugger, uint64_t step)
{
    return go_back(debugger, step - 1) && arrive(debugger, forward(debugger));
}

/* To the stop before, a stretch at a time from here back. */
bool verb_reverse_continue(struct debugger *debugger, struct rest *rest)
{
    uint64_t end = here(debugger), stretch = 64;

    if (!rest_finish(debugger, rest))
        return false;
    while (end > 0) {
        uint64_t from = stretch < end ? end - stretch : 0;
        uint64_t step = find_last(debugger, from, end);

        if (step > 0)
            return arrive_back(debugger, step);
        if (is_interrupted(debugger))
            return arrive(debugger, MOVED_INTERRUPTED);
        end = from > 0 ? from + 1 : 0;
        stretch *= 2;
    }
    if (!go_back(debugger, 0))
        return false;
    sink_put(&debugger->out, "this is the beginning\n");
    show_place(debugger);
    return true;
}

/* ---- Anywhere ------------------------------------------------------------- */

/* Forward without a look at stops. */
static enum moved go_on_to(struct debugger *debugger, uint64_t step,
                           uint64_t clock)
{
    uint64_t begun = clock_of(debugger);
    enum moved moved = MOVED_ON;

    while (moved == MOVED_ON && here(debugger) < step
           && clock_of(debugger) < clock) {
        debugger->halted = !c205_history_forward(debugger->history,
                                                 &debugger->halt);
        moved = debugger->halted ? MOVED_TO_HALT : look_up(debugger, begun);
    }
    stops_sample(debugger);
    return moved;
}

/* goto N, an instruction; goto clock N: the first that has that clock or more
 * behind it. */
bool verb_goto(struct debugger *debugger, struct rest *rest)
{
    bool by_clock = rest_take(rest, "clock");
    uint64_t number;

    if (!debug_count(debugger, rest, &number) || !rest_finish(debugger, rest)
        || !go_back(debugger, !by_clock                      ? number
                              : clock_of(debugger) >= number ? 0
                                                             : UINT64_MAX))
        return false;
    return arrive(debugger, by_clock
                                ? go_on_to(debugger, UINT64_MAX, number)
                                : go_on_to(debugger, number, UINT64_MAX));
}

/* From the beginning, to the first stop, which may be there. */
bool verb_run(struct debugger *debugger, struct rest *rest)
{
    if (!rest_finish(debugger, rest) || !go_back(debugger, 0))
        return false;
    stops_sample(debugger);
    return arrive(debugger, stops_meet(debugger, 0)
                                ? MOVED_TO_STOP
                                : advance(debugger, at_most(UINT64_MAX)));
}
