/* breaks.c - the verbs that make and delete stops. */
#include <inttypes.h>

#include "asm/debug/debug_internal.h"

/* "if CONDITION", or nothing. */
static bool add(struct debugger *debugger, struct rest *rest, struct stop_point *stop)
{
    if (rest_take(rest, "if")) {
        if (rest_end(rest))
            return debug_grammar(debugger, rest);
        if (!stops_condition(debugger, stop, rest->at))
            return false;
    } else if (!rest_finish(debugger, rest)) {
        return false;
    }
    if (!stops_add(debugger, stop))
        return false;
    sink_print(&debugger->out, "%s %zu: %s%s%s\n",
               stop->kind == STOP_WATCH ? "watch" : "break", stop->number, stop->text,
               *stop->condition ? " if " : "", stop->condition);
    return true;
}

static bool make_break(struct debugger *debugger, struct rest *rest, bool once)
{
    struct stop_point stop = { .once = once };

    return place_read(debugger, rest, &stop) && add(debugger, rest, &stop);
}

bool verb_break(struct debugger *debugger, struct rest *rest)
{
    return make_break(debugger, rest, false);
}

bool verb_tbreak(struct debugger *debugger, struct rest *rest)
{
    return make_break(debugger, rest, true);
}

/* watch ADDRESS [, WORDS] [if CONDITION] */
bool verb_watch(struct debugger *debugger, struct rest *rest)
{
    struct stop_point stop = { .number = 0 };

    return stops_watch(debugger, rest, &stop) && add(debugger, rest, &stop);
}

/* One, or all. */
bool verb_delete(struct debugger *debugger, struct rest *rest)
{
    uint64_t number;

    if (rest_end(rest)) {
        debugger->stop_count = 0;
        return true;
    }
    if (!debug_count(debugger, rest, &number) || !rest_finish(debugger, rest))
        return false;
    return stops_delete(debugger, number)
           || debug_fault(debugger, "there is no stop %" PRIu64, number);
}
