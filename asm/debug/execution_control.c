/* execution_control.c - executes a program forward and back to breakpoints, lines,
 * steps and clocks. */
#include <string.h>

#include "asm/debug/debugger_engine.h"
#include "asm/view/operand_view.h"

static uint64_t clock_of(const struct debugger *debugger)
{
    return c205_clock(machine_of(debugger));
}

static uint64_t pc_of(const struct debugger *debugger)
{
    return c205_pc(machine_of(debugger));
}

/* ---- Forward -------------------------------------------------------------- */

static enum execution_end forward(struct debugger *debugger)
{
    uint64_t before = pc_of(debugger);
    debugger->halted = !c205_history_forward(debugger->history, &debugger->halt);
    if (debugger->halted)
        return EXECUTION_HALTED;
    return breakpoints_meet(debugger, before) ? EXECUTION_AT_STOP : EXECUTION_COMPLETE;
}

/* Returns true if the user has requested an interruption. The request is checked only
 * at every 4096th step or after 2^18 clocks, because the check may be a system call.
 * The limit of clocks is for vector instructions, which take many clocks. */
static bool is_interrupted(struct debugger *debugger)
{
    enum { STEPS = 4096, CLOCKS = 1 << 18 };
    uint64_t clock = clock_of(debugger);
    if (step_of(debugger) % STEPS != 0 && clock - debugger->asked < CLOCKS)
        return false;
    debugger->asked = clock;
    return debugger->setup.interrupted
           && debugger->setup.interrupted(debugger->setup.asked);
}

/* Checks the limits of an execution that began at clock `begun`. */
static enum execution_end look_up(struct debugger *debugger, uint64_t begun)
{
    if (clock_of(debugger) - begun > debugger->setup.clocks_most)
        return EXECUTION_OUT_OF_RANGE;
    return is_interrupted(debugger) ? EXECUTION_INTERRUPTED : EXECUTION_COMPLETE;
}

/* The conditions that end an execution, in addition to breakpoints. */
struct aim {
    uint64_t count;  /* number of instructions */
    bool at_address; /* stop at `address` after at least one instruction */
    uint64_t address;
    /* Called after each instruction; true ends the execution. NULL: none. */
    bool (*is_there)(void *context, const c205 *machine);
    void *context;
};

static bool is_reached(const struct debugger *debugger, const struct aim *aim)
{
    return (aim->at_address && pc_of(debugger) == aim->address)
           || (aim->is_there && aim->is_there(aim->context, machine_of(debugger)));
}

static enum execution_end advance(struct debugger *debugger, struct aim aim)
{
    uint64_t begun = clock_of(debugger);
    enum execution_end ended = EXECUTION_COMPLETE;
    breakpoints_sample(debugger);
    for (uint64_t i = 1; i <= aim.count && ended == EXECUTION_COMPLETE; i++) {
        ended = forward(debugger);
        if (ended == EXECUTION_COMPLETE && is_reached(debugger, &aim))
            break;
        if (ended == EXECUTION_COMPLETE && i < aim.count)
            ended = look_up(debugger, begun);
    }
    return ended;
}

enum execution_end execution_steps(struct debugger *debugger, uint64_t count)
{
    return advance(debugger, (struct aim){ .count = count });
}

enum execution_end execution_to(struct debugger *debugger, uint64_t address)
{
    return advance(debugger, (struct aim){ .count = UINT64_MAX,
                                           .at_address = true,
                                           .address = address });
}

enum execution_end execution_until(struct debugger *debugger,
                                   bool (*is_there)(void *context, const c205 *machine),
                                   void *context)
{
    return advance(debugger, (struct aim){ .count = UINT64_MAX,
                                           .is_there = is_there,
                                           .context = context });
}

bool execution_is_call(const struct debugger *debugger, uint64_t *behind)
{
    struct instruction_view view;
    view_decode(&view, machine_of(debugger), pc_of(debugger));
    *behind = view.pc + 32 * (uint64_t)view.halves;
    return view.insn && view.insn == c205_insn_named("BSAVE", 5);
}

enum execution_end execution_next(struct debugger *debugger)
{
    uint64_t behind;
    return execution_is_call(debugger, &behind) ? execution_to(debugger, behind)
                                                : execution_steps(debugger, 1);
}

/* ---- Lines and macro calls -------------------------------------------------- */

static const struct asm_line *line_here(const struct debugger *debugger)
{
    return object_line(debugger->setup.object, pc_of(debugger));
}

/* Returns true if the current instruction belongs to an expansion of the given line and
 * is not the first instruction of this expansion. */
static bool is_behind_beginning(const struct debugger *debugger,
                                const struct asm_line *line)
{
    const struct asm_line *here = line_here(debugger);
    return here && line && !here->shown.begins
           && asm_place_is(&here->shown, line->shown.file, line->shown.number);
}

enum execution_end execution_line(struct debugger *debugger)
{
    const struct asm_line *line = line_here(debugger);
    enum execution_end ended = execution_next(debugger);
    while (ended == EXECUTION_COMPLETE && is_behind_beginning(debugger, line))
        ended = execution_next(debugger);
    return ended;
}

/* Returns the current source line if it belongs to a macro call, or NULL. */
static const struct asm_line *call_of(const struct debugger *debugger)
{
    const struct asm_line *line = line_here(debugger);
    return line && asm_line_is_called(line) ? line : NULL;
}

static bool is_in(const struct debugger *debugger, const struct asm_line *call)
{
    const struct asm_line *line = call_of(debugger);
    return line && asm_place_is(&line->call, call->call.file, call->call.number);
}

static const char *region_here(const struct debugger *debugger)
{
    return object_region(debugger->setup.object, pc_of(debugger));
}

bool execution_can_go_out(struct debugger *debugger)
{
    return call_of(debugger) || *region_here(debugger)
           || debug_fault(
               debugger,
               "cannot step out: the program is not in a macro call or a region");
}

enum execution_end execution_out(struct debugger *debugger)
{
    const struct asm_line *call = call_of(debugger);
    const char *region = region_here(debugger);
    enum execution_end ended;
    do
        ended = execution_steps(debugger, 1);
    while (
        ended == EXECUTION_COMPLETE
        && (call ? is_in(debugger, call) : strcmp(region_here(debugger), region) == 0));
    return ended;
}

/* ---- Back ----------------------------------------------------------------- */

static bool go_back(struct debugger *debugger, uint64_t step)
{
    c205_error error = { "out of memory" };
    if (step < step_of(debugger)) {
        debugger->halted = debugger->has_end = false;
        debugger->has_last = step > 0;
    }
    if (!c205_history_back(debugger->history, step, &error))
        return debug_fault(debugger, "%s", error.message);
    breakpoints_sample(debugger);
    return true;
}

enum execution_end execution_back(struct debugger *debugger, uint64_t count)
{
    uint64_t step = step_of(debugger);
    if (!go_back(debugger, count < step ? step - count : 0))
        return EXECUTION_FAILED;
    return step == 0 ? EXECUTION_AT_START : EXECUTION_COMPLETE;
}

enum execution_end execution_back_line(struct debugger *debugger)
{
    enum execution_end ended = execution_back(debugger, 1);
    const struct asm_line *line = line_here(debugger);
    while (ended == EXECUTION_COMPLETE && is_behind_beginning(debugger, line)
           && step_of(debugger) > 0)
        ended = execution_back(debugger, 1);
    return ended;
}

/* Replays the current interval of the search and records the last step at which a
 * breakpoint stops the program. After an interruption, it continues the interval. */
static enum execution_end find_last(struct debugger *debugger,
                                    struct back_search *search)
{
    enum execution_end ended = EXECUTION_COMPLETE;
    if (!search->inside && !go_back(debugger, search->begin))
        return EXECUTION_FAILED;
    search->inside = true;
    while (ended != EXECUTION_HALTED && step_of(debugger) + 1 < search->end) {
        ended = forward(debugger);
        if (ended == EXECUTION_AT_STOP) {
            search->found = step_of(debugger);
            breakpoints_sample(debugger);
        }
        if (is_interrupted(debugger))
            return EXECUTION_INTERRUPTED;
    }
    search->inside = false;
    return EXECUTION_COMPLETE;
}

/* Goes to a step from the step before it, so a watchpoint has the values before the
 * change. */
static enum execution_end arrive_back(struct debugger *debugger, uint64_t step)
{
    return go_back(debugger, step - 1) ? forward(debugger) : EXECUTION_FAILED;
}

static void begin_stretch(struct back_search *search)
{
    search->begin = search->stretch < search->end ? search->end - search->stretch : 0;
    search->found = 0;
}

/* Searches back for the last stop before the current step. The machine can only be
 * executed forward from a snapshot, so intervals are replayed: the last 64 steps, then
 * the 128 steps before them, and so on with double lengths. The number of replayed
 * steps is at most about twice the distance of the result. Replaying an interval finds
 * the breakpoints after its first step and before its end, so the next interval ends at
 * begin + 1. */
static enum execution_end search_back(struct debugger *debugger,
                                      struct back_search *search)
{
    if (!search->begun)
        *search = (struct back_search){ .begun = true,
                                        .end = step_of(debugger),
                                        .stretch = 64 };
    while (search->end > 0) {
        enum execution_end ended;
        if (!search->inside)
            begin_stretch(search);
        ended = find_last(debugger, search);
        if (ended != EXECUTION_COMPLETE)
            return ended;
        if (search->found > 0)
            return arrive_back(debugger, search->found);
        search->end = search->begin > 0 ? search->begin + 1 : 0;
        search->stretch *= 2;
    }
    return go_back(debugger, 0) ? EXECUTION_AT_START : EXECUTION_FAILED;
}

enum execution_end execution_search_back(struct debugger *debugger,
                                         struct back_search *search)
{
    enum execution_end ended;
    debugger->searching = true;
    ended = search_back(debugger, search);
    debugger->searching = false;
    return ended;
}

enum execution_end execution_back_to_stop(struct debugger *debugger)
{
    struct back_search search = { .begun = false };
    return execution_search_back(debugger, &search);
}

/* ---- To a step or clock --------------------------------------------------- */

static bool is_short_of(const struct debugger *debugger, uint64_t step, uint64_t clock)
{
    return step_of(debugger) < step && clock_of(debugger) < clock;
}

/* Executes forward without checking for breakpoints. */
static enum execution_end go_on_to(struct debugger *debugger, uint64_t step,
                                   uint64_t clock)
{
    uint64_t begun = clock_of(debugger);
    enum execution_end ended = EXECUTION_COMPLETE;
    while (ended == EXECUTION_COMPLETE && is_short_of(debugger, step, clock)) {
        debugger->halted = !c205_history_forward(debugger->history, &debugger->halt);
        if (debugger->halted)
            ended = EXECUTION_HALTED;
        else if (is_short_of(debugger, step, clock))
            ended = look_up(debugger, begun);
    }
    breakpoints_sample(debugger);
    return ended;
}

enum execution_end execution_to_step(struct debugger *debugger, uint64_t step)
{
    return go_back(debugger, step) ? go_on_to(debugger, step, UINT64_MAX)
                                   : EXECUTION_FAILED;
}

enum execution_end execution_to_clock(struct debugger *debugger, uint64_t clock)
{
    return go_back(debugger, clock_of(debugger) >= clock ? 0 : UINT64_MAX)
               ? go_on_to(debugger, UINT64_MAX, clock)
               : EXECUTION_FAILED;
}

enum execution_end execution_run(struct debugger *debugger)
{
    if (!go_back(debugger, 0))
        return EXECUTION_FAILED;
    breakpoints_sample(debugger);
    return breakpoints_meet(debugger, 0) ? EXECUTION_AT_STOP
                                         : execution_steps(debugger, UINT64_MAX);
}
