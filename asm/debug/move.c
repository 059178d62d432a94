/* move.c - forward and back. */
#include <inttypes.h>

#include "asm/debug/parts.h"

/* How a movement ended. */
enum moved { MOVED_ON, MOVED_TO_STOP, MOVED_TO_HALT, MOVED_INTERRUPTED };

static uint64_t here(const struct debugger *debugger)
{
    return c205_history_step(debugger->history);
}

static enum moved forward(struct debugger *debugger, struct stop_point **stop)
{
    uint64_t before = c205_pc(machine_of(debugger));

    debugger->halted = !c205_history_forward(debugger->history,
                                             &debugger->halt);
    if (debugger->halted)
        return MOVED_TO_HALT;
    *stop = stops_met(debugger, before);
    return *stop ? MOVED_TO_STOP : MOVED_ON;
}

static bool is_interrupted(const struct debugger *debugger)
{
    return debugger->setup.interrupted && debugger->setup.interrupted();
}

/* So many instructions, unless something is in the way. */
static enum moved advance(struct debugger *debugger, uint64_t count,
                          struct stop_point **stop)
{
    enum { SELDOM = 4096 };
    enum moved moved = MOVED_ON;

    stops_sample(debugger);
    for (uint64_t i = 0; i < count && moved == MOVED_ON; i++) {
        moved = forward(debugger, stop);
        if (moved == MOVED_ON && i % SELDOM == SELDOM - 1
            && is_interrupted(debugger))
            moved = MOVED_INTERRUPTED;
    }
    return moved;
}

static bool arrive(struct debugger *debugger, enum moved moved,
                   struct stop_point *stop)
{
    show_end_line(debugger);
    if (moved == MOVED_TO_STOP)
        stops_tell(debugger, stop);
    else if (moved == MOVED_INTERRUPTED)
        sink_put(&debugger->out, "interrupted\n");
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

static bool move_on(struct debugger *debugger, uint64_t count)
{
    struct stop_point *stop = NULL;
    enum moved moved = advance(debugger, count, &stop);

    return arrive(debugger, moved, stop);
}

/* ---- Forward -------------------------------------------------------------- */

bool verb_step(struct debugger *debugger, struct rest *rest)
{
    uint64_t count;

    return read_times(debugger, rest, &count) && move_on(debugger, count);
}

bool verb_continue(struct debugger *debugger, struct rest *rest)
{
    uint64_t count;
    enum moved moved = MOVED_ON;
    struct stop_point *stop = NULL;

    if (!read_times(debugger, rest, &count))
        return false;
    while (count-- > 0) {
        moved = advance(debugger, UINT64_MAX, &stop);
        if (moved != MOVED_TO_STOP)
            break;
        if (count > 0)
            stop->hits++;
    }
    return arrive(debugger, moved, stop);
}

/* Stops at an address, too. */
static bool run_to(struct debugger *debugger, uint64_t address)
{
    enum moved moved = MOVED_ON;
    struct stop_point *stop = NULL;

    do
        moved = advance(debugger, 1, &stop);
    while (moved == MOVED_ON && c205_pc(machine_of(debugger)) != address
           && !is_interrupted(debugger));
    return arrive(debugger, moved, stop);
}

/* A call and all that it does is one. */
bool verb_next(struct debugger *debugger, struct rest *rest)
{
    c205 *machine = machine_of(debugger);
    uint64_t pc = c205_pc(machine);
    struct stop_point *stop = NULL;
    enum moved moved;
    uint64_t count;

    if (!read_times(debugger, rest, &count))
        return false;
    for (; count > 0; count--) {
        moved = advance(debugger, 1, &stop);
        if (moved == MOVED_ON && debugger->has_last
            && debugger->last.insn->format == C205_FORMAT_CALL
            && debugger->last.taken)
            return run_to(debugger, pc
                                        + 32
                                              * (uint64_t)c205_format_halves(
                                                  C205_FORMAT_CALL));
        if (moved != MOVED_ON)
            break;
        pc = c205_pc(machine_of(debugger));
    }
    return arrive(debugger, count > 0 ? moved : MOVED_ON, stop);
}

bool verb_until(struct debugger *debugger, struct rest *rest)
{
    uint64_t address;

    return place_address(debugger, rest, &address)
           && rest_finish(debugger, rest) && run_to(debugger, address);
}

/* ---- Back ----------------------------------------------------------------- */

static bool go_back(struct debugger *debugger, uint64_t step)
{
    c205_error error;

    debugger->halted = false;
    if (step < here(debugger))
        debugger->has_last = step > 0;
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

/* The last stop from one step on, before another; false: there was none. */
static bool find_last(struct debugger *debugger, uint64_t from, uint64_t end,
                      uint64_t *step, size_t *number)
{
    struct stop_point *stop = NULL;
    bool found = false;

    if (!go_back(debugger, from))
        return false;
    while (here(debugger) + 1 < end) {
        enum moved moved = forward(debugger, &stop);

        if (moved == MOVED_TO_HALT)
            break;
        if (moved != MOVED_TO_STOP)
            continue;
        found = true;
        *step = here(debugger);
        *number = stop->number;
        stops_sample(debugger);
    }
    return found;
}

/* What is watched held before the change. */
static void sample_before(struct debugger *debugger, uint64_t step)
{
    struct stop_point *stop;

    if (go_back(debugger, step - 1))
        forward(debugger, &stop);
}

static void arrive_at(struct debugger *debugger, uint64_t step, size_t number)
{
    sample_before(debugger, step);
    for (size_t i = 0; i < debugger->stop_count; i++)
        if (debugger->stops[i].number == number)
            stops_tell(debugger, &debugger->stops[i]);
    stops_sample(debugger);
    show_place(debugger);
}

/* To the stop before, a stretch at a time from here back. */
bool verb_reverse_continue(struct debugger *debugger, struct rest *rest)
{
    uint64_t end = here(debugger), stretch = 64, step = 0;
    size_t number = 0;

    if (!rest_finish(debugger, rest))
        return false;
    while (end > 0) {
        uint64_t from = stretch < end ? end - stretch : 0;

        if (find_last(debugger, from, end, &step, &number)) {
            arrive_at(debugger, step, number);
            return true;
        }
        if (is_interrupted(debugger))
            break;
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
static void go_on_to(struct debugger *debugger, uint64_t step, uint64_t clock)
{
    debugger->halted = false;
    while (!debugger->halted && here(debugger) < step
           && c205_clock(machine_of(debugger)) < clock
           && !is_interrupted(debugger))
        debugger->halted = !c205_history_forward(debugger->history,
                                                 &debugger->halt);
    stops_sample(debugger);
}

/* goto N, an instruction; goto clock N: the first that has that clock or more
 * behind it. */
bool verb_goto(struct debugger *debugger, struct rest *rest)
{
    bool by_clock = rest_take(rest, "clock");
    uint64_t number;

    if (!debug_count(debugger, rest, &number) || !rest_finish(debugger, rest))
        return false;
    if (by_clock) {
        if (c205_clock(machine_of(debugger)) >= number
            && !go_back(debugger, 0))
            return false;
        go_on_to(debugger, UINT64_MAX, number);
    } else {
        if (!go_back(debugger, number))
            return false;
        go_on_to(debugger, number, UINT64_MAX);
    }
    show_place(debugger);
    return true;
}

/* From the beginning, to the first stop. */
bool verb_run(struct debugger *debugger, struct rest *rest)
{
    return rest_finish(debugger, rest) && go_back(debugger, 0)
           && move_on(debugger, UINT64_MAX);
}
