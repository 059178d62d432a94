/* go.c - movements, a slice at a time. */
#include <string.h>

#include "web/engine/engine_internal.h"

/* ---- Ways to go -------------------------------------------------------------- */

static enum moved go_to_end(struct engine *engine)
{
    return motion_to_step(engine->debugger, UINT64_MAX);
}

static enum moved go_to_stop(struct engine *engine)
{
    return motion_steps(engine->debugger, UINT64_MAX);
}

static enum moved go_steps(struct engine *engine)
{
    return motion_steps(engine->debugger,
                        engine->movement.step - debugger_step(engine->debugger));
}

/* A call that was interrupted continues to where it comes back. */
static enum moved go_next(struct engine *engine)
{
    struct movement *movement = &engine->movement;
    enum moved moved = MOVED_ON;

    while (movement->left > 0 && moved == MOVED_ON) {
        if (!movement->inside)
            movement->inside = motion_is_call(engine->debugger, &movement->behind);
        moved = movement->inside ? motion_to(engine->debugger, movement->behind)
                                 : motion_steps(engine->debugger, 1);
        if (moved == MOVED_INTERRUPTED)
            break;
        movement->inside = false;
        movement->left--;
        if (movement->left > 0 && moved == MOVED_ON && slice_is_over(engine))
            moved = MOVED_INTERRUPTED;
    }
    return moved;
}

static enum moved go_back(struct engine *engine)
{
    return motion_back(engine->debugger, engine->movement.left);
}

static enum moved go_back_to_stop(struct engine *engine)
{
    return motion_search_back(engine->debugger, &engine->movement.search);
}

static enum moved go_to_step(struct engine *engine)
{
    return motion_to_step(engine->debugger, engine->movement.step);
}

static enum moved go_to_clock(struct engine *engine)
{
    return motion_to_clock(engine->debugger, engine->movement.clock);
}

static const struct {
    const char *how;
    enum moved (*move)(struct engine *engine);
} ways[] = {
    { "end", go_to_end },      { "continue", go_to_stop },
    { "step", go_steps },      { "next", go_next },
    { "back", go_back },       { "reverse-continue", go_back_to_stop },
    { "step-to", go_to_step }, { "clock-to", go_to_clock },
    { "start", go_to_step },
};
enum { WAYS = sizeof ways / sizeof *ways };

/* ---- How it ended -------------------------------------------------------------- */

static const char *why(const struct engine *engine, enum moved moved)
{
    const c205_stop *halt = debugger_halt(engine->debugger);

    switch (moved) {
    case MOVED_TO_STOP: return "breakpoint";
    case MOVED_TO_HALT: return halt && halt->trap != C205_TRAP_NONE ? "trap" : "end";
    case MOVED_TO_START: return "start";
    case MOVED_INTERRUPTED: return "limit";
    default: return "moved";
    }
}

static void put_place(const struct engine *engine, struct json *reply)
{
    json_count(reply, "step", debugger_step(engine->debugger));
    json_count(reply, "steps", debugger_known(engine->debugger));
    json_count(reply, "clock", c205_clock(engine_machine(engine)));
}

static bool arrive(struct engine *engine, enum moved moved, struct json *reply,
                   c205_error *error)
{
    json_bool(reply, "done", true);
    json_text(reply, "why", why(engine, moved));
    put_place(engine, reply);
    if (moved == MOVED_TO_STOP)
        stops_pass(engine->debugger, true);
    else if (moved == MOVED_TO_HALT)
        show_halt(engine->debugger);
    return put_said(engine, reply, "message", error);
}

static bool go_on(struct engine *engine, struct json *reply, c205_error *error)
{
    enum moved moved = engine->movement.move(engine);

    engine->goes_on = NULL;
    if (moved == MOVED_NOT)
        return refuse_as_said(engine, error);
    if (moved != MOVED_INTERRUPTED || engine->slice.to_the_limit)
        return arrive(engine, moved, reply, error);
    engine->goes_on = go_on;
    json_bool(reply, "done", false);
    json_text(reply, "why", "running");
    put_place(engine, reply);
    json_text(reply, "message", "");
    return true;
}

/* ---- go -------------------------------------------------------------------------- */

/* A sum that is too large is the largest there is. */
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
        return refuse(error, "there is no way to go \"%.40s\"", how);
    given = n != UINT64_MAX;
    if (!given && strstr(how, "-to"))
        return refuse(error, "\"n\" is missing: where to?");
    n = given ? n : 1;
    engine->movement = (struct movement){
        .move = ways[i].move, .step = n, .clock = n, .left = n
    };
    if (ways[i].move == go_steps)
        engine->movement.step = plus(debugger_step(engine->debugger), n);
    if (strcmp(how, "start") == 0)
        engine->movement.step = 0;
    engine->slice.ends_at = plus(c205_clock(engine_machine(engine)), limit);
    return true;
}

bool answer_go(struct engine *engine, const struct json_value *request,
               struct json *reply, c205_error *error)
{
    return needs_program(engine, error) && take_slice(engine, request, error)
           && take_movement(engine, request, error) && go_on(engine, reply, error);
}

/* ---- say --------------------------------------------------------------------------- */

/* One line at a time: what runs on stops at the end of the slice, and says so. */
bool answer_printf(struct engine *engine, const struct json_value *request,
                   struct json *reply, c205_error *error)
{
    const char *line;
    uint64_t limit = ENGINE_LIMIT;

    if (!needs_program(engine, error) || !take_slice(engine, request, error)
        || !take_limit(engine, request, &limit, error)
        || !take_text(request, "line", &line, error))
        return false;
    if (strpbrk(line, "\r\n"))
        return refuse(error, "\"line\" is one line");
    engine->slice.ends_at = plus(c205_clock(engine_machine(engine)), limit);
    debugger_obey(engine->debugger, line);
    printed_forget(&engine->printed, debugger_known(engine->debugger));
    put_place(engine, reply);
    return put_said(engine, reply, "text", error);
}
