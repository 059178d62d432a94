/* break_verbs.c - the verbs of the debugger that create and delete breakpoints and
 * watchpoints. */
#include <inttypes.h>

#include "asm/debug/debug_internal.h"

/* Reads an optional "if CONDITION" up to the end of the line, adds the breakpoint and
 * prints it. */
static bool add_stop(struct debugger *debugger, struct text_cursor *cursor,
                     struct breakpoint *stop)
{
    if (text_cursor_take(cursor, "if")) {
        if (text_cursor_end(cursor))
            return debug_grammar(debugger, cursor);
        if (!breakpoints_condition(debugger, stop, cursor->at))
            return false;
    } else if (!text_cursor_finish(debugger, cursor)) {
        return false;
    }
    if (!breakpoints_add(debugger, stop))
        return false;
    sink_print(&debugger->out, "%s %zu: %s%s%s\n",
               stop->kind == BREAK_WATCH ? "watch" : "break", stop->number, stop->text,
               *stop->condition ? " if " : "", stop->condition);
    return true;
}

static bool make_break(struct debugger *debugger, struct text_cursor *cursor, bool once)
{
    struct breakpoint stop = { .once = once };
    return place_read(debugger, cursor, &stop) && add_stop(debugger, cursor, &stop);
}

bool verb_break(struct debugger *debugger, struct text_cursor *cursor)
{
    return make_break(debugger, cursor, false);
}

bool verb_tbreak(struct debugger *debugger, struct text_cursor *cursor)
{
    return make_break(debugger, cursor, true);
}

/* Executes watch ADDRESS [, WORDS] [if CONDITION], which creates a watchpoint. */
bool verb_watch(struct debugger *debugger, struct text_cursor *cursor)
{
    struct breakpoint stop = { .number = 0 };
    return breakpoints_watch(debugger, cursor, &stop)
           && add_stop(debugger, cursor, &stop);
}

/* Deletes the breakpoint with the given number, or all breakpoints if there is no
 * number. */
bool verb_delete(struct debugger *debugger, struct text_cursor *cursor)
{
    uint64_t number;
    if (text_cursor_end(cursor)) {
        debugger->breakpoint_count = 0;
        return true;
    }
    if (!debug_count(debugger, cursor, &number)
        || !text_cursor_finish(debugger, cursor))
        return false;
    return breakpoints_delete(debugger, number)
           || debug_fault(debugger, "unknown breakpoint or watchpoint %" PRIu64,
                          number);
}
