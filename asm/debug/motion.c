/* motion.c - forward and back. */
#include <string.h>

#include "asm/debug/engine.h"
#include "asm/operand_view.h"

static uint64_t clock_of(const struct debugger *debugger)
{
    return c205_clock(machine_of(debugger));
}

static uint64_t pc_of(const struct debugger *debugger)
{
    return c205_pc(machine_of(debugger));
}

/* ---- Forward -------------------------------------------------------------- */

static enum moved forward(struct debugger *debugger)
{
    uint64_t before = pc_of(debugger);

    debugger->halted = !c205_history_forward(debugger->history, &debugger->halt);
    if (debugger->halted)
        return MOVED_TO_HALT;
    return stops_meet(debugger, before) ? MOVED_TO_STOP : MOVED_ON;
}

/* Asked seldom: it may be a question to the system.  Vector instructions are long. */
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

/* Whether a movement that began at a clock continues. */
static enum moved look_up(struct debugger *debugger, uint64_t begun)
{
    if (clock_of(debugger) - begun > debugger->setup.clocks_most)
        return MOVED_TOO_FAR;
    return is_interrupted(debugger) ? MOVED_INTERRUPTED : MOVED_ON;
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

static bool is_reached(const struct debugger *debugger, const struct aim *aim)
{
    return (aim->at_address && pc_of(debugger) == aim->address)
           || (aim->is_there && aim->is_there(aim->context, machine_of(debugger)));
}

static enum moved advance(struct debugger *debugger, struct aim aim)
{
    uint64_t begun = clock_of(debugger);
    enum moved moved = MOVED_ON;

    stops_sample(debugger);
    for (uint64_t i = 1; i <= aim.count && moved == MOVED_ON; i++) {
        moved = forward(debugger);
        if (moved == MOVED_ON && is_reached(debugger, &aim))
            break;
        if (moved == MOVED_ON && i < aim.count)
            moved = look_up(debugger, begun);
    }
    return moved;
}

enum moved motion_steps(struct debugger *debugger, uint64_t count)
{
    return advance(debugger, (struct aim){ .count = count });
}

enum moved motion_to(struct debugger *debugger, uint64_t address)
{
    return advance(debugger, (struct aim){ .count = UINT64_MAX,
                                           .at_address = true,
                                           .address = address });
}

enum moved motion_until(struct debugger *debugger,
                        bool (*is_there)(void *context, const c205 *machine),
                        void *context)
{
    return advance(debugger, (struct aim){ .count = UINT64_MAX,
                                           .is_there = is_there,
                                           .context = context });
}

bool motion_is_call(const struct debugger *debugger, uint64_t *behind)
{
    struct instruction_view view;

    view_decode(&view, machine_of(debugger), pc_of(debugger));
    *behind = view.pc + 32 * (uint64_t)view.halves;
    return view.insn && view.insn == c205_insn_named("BSAVE", 5);
}

enum moved motion_next(struct debugger *debugger)
{
    uint64_t behind;

    return motion_is_call(debugger, &behind) ? motion_to(debugger, behind)
                                             : motion_steps(debugger, 1);
}

/* ---- Macro calls ------------------------------------------------------------ */

/* A line of the macro call in which the program stands; NULL: it is in none. */
static const struct asm_line *call_of(const struct debugger *debugger)
{
    const struct asm_line *line = object_line(debugger->setup.object, pc_of(debugger));

    return line && place_is_called(line) ? line : NULL;
}

static bool is_in(const struct debugger *debugger, const struct asm_line *call)
{
    const struct asm_line *line = call_of(debugger);

    return line && line->call_number == call->call_number
           && strcmp(line->call_file, call->call_file) == 0;
}

static bool is_behind_beginning(const struct debugger *debugger,
                                const struct asm_line *call)
{
    return is_in(debugger, call)
           && !place_begins(debugger, call->call_file, call->call_number,
                            pc_of(debugger));
}

enum moved motion_line(struct debugger *debugger)
{
    const struct asm_line *call = call_of(debugger);
    enum moved moved = motion_next(debugger);

    while (moved == MOVED_ON && call && is_behind_beginning(debugger, call))
        moved = motion_next(debugger);
    return moved;
}

static const char *region_here(const struct debugger *debugger)
{
    return object_region(debugger->setup.object, pc_of(debugger));
}

bool motion_can_go_out(struct debugger *debugger)
{
    return call_of(debugger) || *region_here(debugger)
           || debug_fault(debugger, "this is neither in a macro call nor in a "
                                    "region that could be left");
}

enum moved motion_out(struct debugger *debugger)
{
    const struct asm_line *call = call_of(debugger);
    const char *region = region_here(debugger);
    enum moved moved;

    do
        moved = motion_steps(debugger, 1);
    while (
        moved == MOVED_ON
        && (call ? is_in(debugger, call) : strcmp(region_here(debugger), region) == 0));
    return moved;
}

/* ---- Back ----------------------------------------------------------------- */

static bool go_back(struct debugger *debugger, uint64_t step)
{
    c205_error error = { "no memory" };

    if (step < step_of(debugger)) {
        debugger->halted = debugger->has_end = false;
        debugger->has_last = step > 0;
    }
    if (!c205_history_back(debugger->history, step, &error))
        return debug_fault(debugger, "%s", error.message);
    stops_sample(debugger);
    return true;
}

enum moved motion_back(struct debugger *debugger, uint64_t count)
{
    uint64_t step = step_of(debugger);

    if (!go_back(debugger, count < step ? step - count : 0))
        return MOVED_NOT;
    return step == 0 ? MOVED_TO_START : MOVED_ON;
}

enum moved motion_back_line(struct debugger *debugger)
{
    enum moved moved = motion_back(debugger, 1);
    const struct asm_line *call = call_of(debugger);

    while (moved == MOVED_ON && call && is_behind_beginning(debugger, call)
           && step_of(debugger) > 0)
        moved = motion_back(debugger, 1);
    return moved;
}

/* The last step with a stop in a stretch, before its end. */
static enum moved find_last(struct debugger *debugger, struct back_search *search)
{
    enum moved moved = MOVED_ON;

    if (!search->inside && !go_back(debugger, search->begin))
        return MOVED_NOT;
    search->inside = true;
    while (moved != MOVED_TO_HALT && step_of(debugger) + 1 < search->end) {
        moved = forward(debugger);
        if (moved == MOVED_TO_STOP) {
            search->found = step_of(debugger);
            stops_sample(debugger);
        }
        if (is_interrupted(debugger))
            return MOVED_INTERRUPTED;
    }
    search->inside = false;
    return MOVED_ON;
}

/* What is watched held before the change. */
static enum moved arrive_back(struct debugger *debugger, uint64_t step)
{
    return go_back(debugger, step - 1) ? forward(debugger) : MOVED_NOT;
}

static void begin_stretch(struct back_search *search)
{
    search->begin = search->stretch < search->end ? search->end - search->stretch : 0;
    search->found = 0;
}

/* A stretch at a time from here back. */
static enum moved search_back(struct debugger *debugger, struct back_search *search)
{
    if (!search->begun)
        *search = (struct back_search){ .begun = true,
                                        .end = step_of(debugger),
                                        .stretch = 64 };
    while (search->end > 0) {
        enum moved moved;

        if (!search->inside)
            begin_stretch(search);
        moved = find_last(debugger, search);
        if (moved != MOVED_ON)
            return moved;
        if (search->found > 0)
            return arrive_back(debugger, search->found);
        search->end = search->begin > 0 ? search->begin + 1 : 0;
        search->stretch *= 2;
    }
    return go_back(debugger, 0) ? MOVED_TO_START : MOVED_NOT;
}

enum moved motion_search_back(struct debugger *debugger, struct back_search *search)
{
    enum moved moved;

    debugger->searching = true;
    moved = search_back(debugger, search);
    debugger->searching = false;
    return moved;
}

enum moved motion_back_to_stop(struct debugger *debugger)
{
    struct back_search search = { .begun = false };

    return motion_search_back(debugger, &search);
}

/* ---- Anywhere ------------------------------------------------------------- */

static bool is_short_of(const struct debugger *debugger, uint64_t step, uint64_t clock)
{
    return step_of(debugger) < step && clock_of(debugger) < clock;
}

/* Forward without a look at stops. */
static enum moved go_on_to(struct debugger *debugger, uint64_t step, uint64_t clock)
{
    uint64_t begun = clock_of(debugger);
    enum moved moved = MOVED_ON;

    while (moved == MOVED_ON && is_short_of(debugger, step, clock)) {
        debugger->halted = !c205_history_forward(debugger->history, &debugger->halt);
        if (debugger->halted)
            moved = MOVED_TO_HALT;
        else if (is_short_of(debugger, step, clock))
            moved = look_up(debugger, begun);
    }
    stops_sample(debugger);
    return moved;
}

enum moved motion_to_step(struct debugger *debugger, uint64_t step)
{
    return go_back(debugger, step) ? go_on_to(debugger, step, UINT64_MAX) : MOVED_NOT;
}

enum moved motion_to_clock(struct debugger *debugger, uint64_t clock)
{
    return go_back(debugger, clock_of(debugger) >= clock ? 0 : UINT64_MAX)
               ? go_on_to(debugger, UINT64_MAX, clock)
               : MOVED_NOT;
}

enum moved motion_run(struct debugger *debugger)
{
    if (!go_back(debugger, 0))
        return MOVED_NOT;
    stops_sample(debugger);
    return stops_meet(debugger, 0) ? MOVED_TO_STOP : motion_steps(debugger, UINT64_MAX);
}
