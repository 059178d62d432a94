/* go.c - the request `go`, which executes the program slice by slice, and the request
 * `say`.
 */
#include <string.h>

#include "web/engine/engine_internal.h"

/* ---- Executions --------------------------------------------------------------- */

static enum execution_end go_to_end(struct engine *engine)
{
    return execution_to_step(engine->debugger, UINT64_MAX);
}

static enum execution_end go_to_stop(struct engine *engine)
{
    return execution_steps(engine->debugger, UINT64_MAX);
}

static enum execution_end go_steps(struct engine *engine)
{
    return execution_steps(engine->debugger,
                           engine->execution.step - debugger_step(engine->debugger));
}

/* Executes execution.left instructions, each call as one of them. An interrupted call
 * continues up to its return. */
static enum execution_end go_next(struct engine *engine)
{
    struct execution *execution = &engine->execution;
    enum execution_end ended = EXECUTION_COMPLETE;
    while (execution->left > 0 && ended == EXECUTION_COMPLETE) {
        if (!execution->inside)
            execution->inside = execution_is_call(engine->debugger, &execution->behind);
        ended = execution->inside ? execution_to(engine->debugger, execution->behind)
                                  : execution_steps(engine->debugger, 1);
        if (ended == EXECUTION_INTERRUPTED)
            break;
        execution->inside = false;
        execution->left--;
        if (execution->left > 0 && ended == EXECUTION_COMPLETE && slice_is_over(engine))
            ended = EXECUTION_INTERRUPTED;
    }
    return ended;
}

static enum execution_end go_back(struct engine *engine)
{
    return execution_back(engine->debugger, engine->execution.left);
}

static enum execution_end go_back_to_stop(struct engine *engine)
{
    return execution_search_back(engine->debugger, &engine->execution.search);
}

static enum execution_end go_to_step(struct engine *engine)
{
    return execution_to_step(engine->debugger, engine->execution.step);
}

static enum execution_end go_to_clock(struct engine *engine)
{
    return execution_to_clock(engine->debugger, engine->execution.clock);
}

static const struct {
    const char *how;
    enum execution_end (*move)(struct engine *engine);
} ways[] = {
    { "end", go_to_end },      { "continue", go_to_stop },
    { "step", go_steps },      { "next", go_next },
    { "back", go_back },       { "reverse-continue", go_back_to_stop },
    { "step-to", go_to_step }, { "clock-to", go_to_clock },
    { "start", go_to_step },
};
enum { WAYS = sizeof ways / sizeof *ways };

/* ---- The reply ----------------------------------------------------------------- */

static const char *why(const struct engine *engine, enum execution_end ended)
{
    const c205_stop *halt = debugger_halt(engine->debugger);
    switch (ended) {
    case EXECUTION_AT_STOP: return "breakpoint";
    case EXECUTION_HALTED: return halt && halt->trap != C205_TRAP_NONE ? "trap" : "end";
    case EXECUTION_AT_START: return "start";
    case EXECUTION_INTERRUPTED: return "limit";
    default: return "moved";
    }
}

static void put_place(const struct engine *engine, struct json *reply)
{
    json_count(reply, "step", debugger_step(engine->debugger));
    json_count(reply, "steps", debugger_known(engine->debugger));
    json_count(reply, "clock", c205_clock(engine_machine(engine)));
}

static bool arrive(struct engine *engine, enum execution_end ended, struct json *reply,
                   c205_error *error)
{
    json_bool(reply, "done", true);
    json_text(reply, "why", why(engine, ended));
    put_place(engine, reply);
    if (ended == EXECUTION_AT_STOP)
        breakpoints_pass(engine->debugger, true);
    else if (ended == EXECUTION_HALTED)
        show_halt(engine->debugger);
    return put_said(engine, reply, "message", error);
}

static bool continue_walk(struct engine *engine, struct json *reply, c205_error *error)
{
    enum execution_end ended = engine->execution.move(engine);
    engine->goes_on = NULL;
    if (ended == EXECUTION_FAILED)
        return refuse_with_report(engine, error);
    if (ended != EXECUTION_INTERRUPTED || engine->slice.to_the_limit)
        return arrive(engine, ended, reply, error);
    engine->goes_on = continue_walk;
    json_bool(reply, "done", false);
    json_text(reply, "why", "running");
    put_place(engine, reply);
    json_text(reply, "message", "");
    return true;
}

/* ---- go -------------------------------------------------------------------------- */

/* Returns a sum, or UINT64_MAX if it is too large. */
static uint64_t plus(uint64_t a, uint64_t b)
{
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}

static bool take_movement(struct engine *engine, const struct json_value *request,
                          c205_error *error)
{
    const char *how;
    uint64_t n = UINT64_MAX, limit = ENGINE_LIMIT;
    bool given;
    size_t i = 0;
    if (!take_text(request, "how", &how, error) || !take_count(request, "n", &n, error)
        || !take_limit(engine, request, &limit, error))
        return false;
    while (i < WAYS && strcmp(ways[i].how, how) != 0)
        i++;
    if (i == WAYS)
        return error_set(error, "unknown value of \"how\": \"%.40s\"", how);
    given = n != UINT64_MAX;
    if (!given && strstr(how, "-to"))
        return error_set(error, "\"n\" is missing: expected a step or a clock");
    n = given ? n : 1;
    engine->execution = (struct execution){
        .move = ways[i].move, .step = n, .clock = n, .left = n
    };
    if (ways[i].move == go_steps)
        engine->execution.step = plus(debugger_step(engine->debugger), n);
    if (strcmp(how, "start") == 0)
        engine->execution.step = 0;
    engine->slice.ends_at = plus(c205_clock(engine_machine(engine)), limit);
    return true;
}

bool answer_go(struct engine *engine, const struct json_value *request,
               struct json *reply, c205_error *error)
{
    return take_slice(engine, request, error) && take_movement(engine, request, error)
           && continue_walk(engine, reply, error);
}

/* ---- say ----------------------------------------------------------------- */

/* Executes a debugger command. A command that runs the program for longer than the
 * slice is interrupted, and the reply reports this. */
bool answer_command(struct engine *engine, const struct json_value *request,
                    struct json *reply, c205_error *error)
{
    const char *line;
    uint64_t limit = ENGINE_LIMIT;
    if (!take_slice(engine, request, error)
        || !take_limit(engine, request, &limit, error)
        || !take_text(request, "line", &line, error))
        return false;
    if (strpbrk(line, "\r\n"))
        return error_set(error, "\"line\" must be one line");
    engine->slice.ends_at = plus(c205_clock(engine_machine(engine)), limit);
    debugger_obey(engine->debugger, line);
    printed_forget(&engine->printed, debugger_known(engine->debugger));
    put_place(engine, reply);
    return put_said(engine, reply, "text", error);
}
