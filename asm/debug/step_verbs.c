/* step_verbs.c - the debugger's verbs that execute the program. */
#include <inttypes.h>

#include "asm/debug/debug_internal.h"
#include "base/plural.h"

static bool arrive(struct debugger *debugger, enum execution_end ended)
{
    if (ended == EXECUTION_FAILED)
        return false;
    line_tracker_close(&debugger->printed);
    if (ended == EXECUTION_AT_STOP)
        breakpoints_pass(debugger, true);
    else if (ended == EXECUTION_AT_START)
        sink_put(&debugger->out, "at the beginning of the program\n");
    else if (ended == EXECUTION_INTERRUPTED)
        sink_put(&debugger->out, "interrupted\n");
    else if (ended == EXECUTION_OUT_OF_RANGE)
        sink_print(&debugger->out,
                   "stopped after %" PRIu64 " clock%s; continue resumes the run\n",
                   debugger->setup.clocks_most, plural(debugger->setup.clocks_most));
    show_place(debugger);
    return true;
}

/* Reads an optional count. The default is 1. */
static bool read_times(struct debugger *debugger, struct text_cursor *cursor,
                       uint64_t *count)
{
    *count = 1;
    return text_cursor_end(cursor)
           || (debug_count(debugger, cursor, count)
               && text_cursor_finish(debugger, cursor));
}

bool verb_step(struct debugger *debugger, struct text_cursor *cursor)
{
    uint64_t count;
    return read_times(debugger, cursor, &count)
           && arrive(debugger, execution_steps(debugger, count));
}

bool verb_continue(struct debugger *debugger, struct text_cursor *cursor)
{
    enum execution_end ended = EXECUTION_COMPLETE;
    uint64_t count;
    if (!read_times(debugger, cursor, &count))
        return false;
    for (; count > 0; count--) {
        ended = execution_steps(debugger, UINT64_MAX);
        if (ended != EXECUTION_AT_STOP)
            break;
        if (count > 1)
            breakpoints_pass(debugger, false);
    }
    return arrive(debugger, ended);
}

bool verb_next(struct debugger *debugger, struct text_cursor *cursor)
{
    enum execution_end ended = EXECUTION_COMPLETE;
    uint64_t count;
    if (!read_times(debugger, cursor, &count))
        return false;
    for (; count > 0 && ended == EXECUTION_COMPLETE; count--)
        ended = execution_next(debugger);
    return arrive(debugger, ended);
}

bool verb_until(struct debugger *debugger, struct text_cursor *cursor)
{
    uint64_t address;
    return place_code(debugger, cursor, &address)
           && text_cursor_finish(debugger, cursor)
           && arrive(debugger, execution_to(debugger, place_of(debugger, address)));
}

void debugger_seek(struct debugger *debugger,
                   bool (*is_there)(void *context, const c205 *machine), void *context)
{
    arrive(debugger, execution_until(debugger, is_there, context));
}

bool verb_reverse_step(struct debugger *debugger, struct text_cursor *cursor)
{
    uint64_t count;
    return read_times(debugger, cursor, &count)
           && arrive(debugger, execution_back(debugger, count));
}

bool verb_reverse_continue(struct debugger *debugger, struct text_cursor *cursor)
{
    return text_cursor_finish(debugger, cursor)
           && arrive(debugger, execution_back_to_stop(debugger));
}

/* Goes to a step or a clock: goto N, goto clock N. */
bool verb_goto(struct debugger *debugger, struct text_cursor *cursor)
{
    bool by_clock = text_cursor_take(cursor, "clock");
    uint64_t number;
    return debug_count(debugger, cursor, &number)
           && text_cursor_finish(debugger, cursor)
           && arrive(debugger, by_clock ? execution_to_clock(debugger, number)
                                        : execution_to_step(debugger, number));
}

/* Runs from the start to the first breakpoint, which may be at the first
 * instruction. */
bool verb_run(struct debugger *debugger, struct text_cursor *cursor)
{
    return text_cursor_finish(debugger, cursor)
           && arrive(debugger, execution_run(debugger));
}
