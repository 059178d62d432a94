/* evaluate.c - evaluates expressions and executes debugger commands for the client. */
#include <string.h>

#include "asm/dap/dap_internal.h"

/* ---- Expressions --------------------------------------------------------- */

/* Evaluates the expression `text` and writes its value as the member `key`. For a
 * register, also writes the members that describe its vector. */
static bool put_value(struct dap *dap, struct json *body, const char *text,
                      const char *key)
{
    struct text_cursor cursor = { text }, again = { text };
    struct register_of named;
    if (!verb_print(dap->debugger, &cursor))
        return false;
    dap_put_said(dap, body, key);
    if (debug_register(dap->debugger, &again, &named) && text_cursor_end(&again))
        put_word_members(dap, body, named);
    else
        json_number(body, "variablesReference", 0);
    return true;
}

/* ---- Lines --------------------------------------------------------------- */

/* The part of the state that a debugger command may change. */
struct debug_location {
    uint64_t step, pc;
    bool halted;
};

static struct debug_location debug_location_of(const struct dap *dap)
{
    return (struct debug_location){ .step = step_of(dap->debugger),
                                    .pc = c205_pc(machine_of(dap->debugger)),
                                    .halted = dap->debugger->halted };
}

static bool has_moved(struct debug_location a, struct debug_location b)
{
    return a.step != b.step || a.pc != b.pc || a.halted != b.halted;
}

static void send_moved(struct dap *dap)
{
    dap->exit_reported = dap->debugger->halted;
    dap_stopped(dap, "goto", false);
}

/* Notifies the client that it must read all variables again, because a command may have
 * changed registers or memory. */
static void send_changed(struct dap *dap)
{
    struct text_buffer body;
    struct json *json = event_begin(dap, &body);
    if (!json)
        return;
    json_array(json, "areas");
    json_text(json, NULL, "variables");
    json_end(json);
    event_end(dap, "invalidated", json, &body);
}

/* Executes a command of the debugger. The command may run the program, and a request of
 * the client may end the run. */
static void obey_line(struct dap *dap, const char *text)
{
    struct debug_location before = debug_location_of(dap);
    bool goes_on;
    dap->state = DAP_RUNNING;
    dap->pending = PENDING_NONE;
    goes_on = debugger_obey(dap->debugger, text);
    dap->state = DAP_STANDING;
    if (!goes_on || dap->pending == PENDING_TERMINATE)
        dap->then = dap_finish;
    else if (dap->pending == PENDING_RESTART)
        dap->then = dap_begin;
    else if (has_moved(before, debug_location_of(dap)))
        dap->then = send_moved;
    else if (dap->client_redraws)
        dap->then = send_changed;
}

bool request_evaluate(struct dap *dap)
{
    const char *text = json_member_text(dap->arguments, "expression");
    const char *context = json_member_text(dap->arguments, "context");
    if (!text)
        return dap_fault(dap, "'expression' is missing");
    if (!context || strcmp(context, "repl") != 0)
        return put_value(dap, dap->body, text, "result");
    if (dap->state != DAP_STANDING)
        return dap_fault(
            dap, "debugger commands are accepted only while the program is stopped");
    obey_line(dap, text);
    dap_put_said(dap, dap->body, "result");
    json_number(dap->body, "variablesReference", 0);
    return true;
}

/* Executes the debugger command "set EXPRESSION = VALUE". */
bool request_set_expression(struct dap *dap)
{
    const char *name = json_member_text(dap->arguments, "expression");
    const char *value = json_member_text(dap->arguments, "value");
    struct text_buffer line = { 0 };
    struct sink sink = text_buffer_sink(&line);
    struct text_cursor cursor;
    bool good;
    if (!name || !value)
        return dap_fault(dap, "'expression' or 'value' is missing");
    sink_put(&sink, name);
    sink_put(&sink, " = ");
    sink_put(&sink, value);
    cursor.at = line.text;
    good = !line.failed && verb_set(dap->debugger, &cursor)
           && put_value(dap, dap->body, name, "value");
    text_buffer_free(&line);
    return good;
}
