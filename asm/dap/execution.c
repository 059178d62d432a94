/* execution.c - executes the program for requests and reports the reason of each stop
 * to the client. */
#include <inttypes.h>
#include <string.h>

#include "asm/dap/dap_internal.h"
#include "base/plural.h"

/* ---- The program has stopped --------------------------------------------- */

static const char *stop_reason(const struct breakpoint *stop)
{
    if (stop->kind == BREAK_WATCH)
        return "data breakpoint";
    switch (stop->group) {
    case GROUP_FUNCTIONS: return "function breakpoint";
    case GROUP_INSTRUCTIONS: return "instruction breakpoint";
    default: return "breakpoint";
    }
}

/* Returns the reason of the first breakpoint that stopped the program. */
static const char *met_reason(const struct dap *dap)
{
    const struct debugger *debugger = dap->debugger;
    for (size_t i = 0; i < debugger->breakpoint_count; i++)
        if (debugger->breakpoints[i].met)
            return stop_reason(&debugger->breakpoints[i]);
    return "breakpoint";
}

static void put_met(const struct dap *dap, struct json *body)
{
    const struct debugger *debugger = dap->debugger;
    json_array(body, "hitBreakpointIds");
    for (size_t i = 0; i < debugger->breakpoint_count; i++)
        if (debugger->breakpoints[i].met)
            json_count(body, NULL, debugger->breakpoints[i].number);
    json_end(body);
}

void dap_stopped(struct dap *dap, const char *reason, bool met)
{
    struct text_buffer text;
    struct json *body;
    const char *said;
    dap->state = DAP_STANDING;
    send_printed(dap);
    body = event_begin(dap, &text);
    if (!body)
        return;
    json_text(body, "reason", reason);
    json_number(body, "threadId", 1);
    json_bool(body, "allThreadsStopped", true);
    if (met) {
        put_met(dap, body);
        breakpoints_pass(dap->debugger, true);
    }
    said = debugger_report(&dap->said);
    if (*said) {
        json_text(body, "description", said);
        json_text(body, "text", said);
    }
    text_buffer_free(&dap->said);
    event_end(dap, "stopped", body, &text);
}

/* ---- The program has ended ----------------------------------------------- */

void dap_finish(struct dap *dap)
{
    send_printed(dap);
    if (dap->state != DAP_ENDED)
        send_event(dap, "terminated", NULL);
    dap->state = DAP_ENDED;
}

static void send_exit(struct dap *dap, int64_t status)
{
    struct text_buffer text;
    struct json *body;
    send_printed(dap);
    body = event_begin(dap, &text);
    if (!body)
        return;
    json_number(body, "exitCode", (double)status);
    event_end(dap, "exited", body, &text);
    dap_finish(dap);
}

static void send_trap(struct dap *dap)
{
    show_halt(dap->debugger);
    if (dap->stop_at_traps) {
        dap_stopped(dap, "exception", false);
        return;
    }
    send_printed(dap);
    send_output(dap, "stderr", dap->said.text);
    text_buffer_free(&dap->said);
    send_exit(dap, 1);
}

static void send_halt(struct dap *dap)
{
    const c205_stop *stop = &dap->debugger->halt;
    if (stop->trap != C205_TRAP_NONE) {
        send_trap(dap);
    } else if (dap->stop_on_end && !dap->exit_reported) {
        show_halt(dap->debugger);
        dap_stopped(dap, "end", false);
        dap->exit_reported = true;
    } else {
        send_exit(dap, stop->status);
    }
}

/* ---- Execution ----------------------------------------------------------- */

static void arrive(struct dap *dap, enum execution_end ended)
{
    struct sink output = dap_output_sink(dap);
    if (ended != EXECUTION_HALTED)
        dap->exit_reported = false;
    switch (ended) {
    case EXECUTION_AT_STOP: dap_stopped(dap, met_reason(dap), true); break;
    case EXECUTION_HALTED: send_halt(dap); break;
    case EXECUTION_AT_START:
        sink_put(&output, "at the beginning of the program");
        dap_stopped(dap, "entry", false);
        break;
    case EXECUTION_INTERRUPTED: dap_stopped(dap, "pause", false); break;
    case EXECUTION_OUT_OF_RANGE:
        sink_print(&output, "stopped after %" PRIu64 " clock%s", dap->setup.clocks_most,
                   plural(dap->setup.clocks_most));
        dap_stopped(dap, "pause", false);
        break;
    default: dap_stopped(dap, dap->reason, false);
    }
}

static enum execution_end to_the_beginning(struct debugger *debugger)
{
    execution_back(debugger, UINT64_MAX);
    return EXECUTION_COMPLETE;
}

/* Prepares a new start: resets the counts of hits, and lets the output be printed
 * again. */
static void prepare_beginning(struct dap *dap)
{
    struct debugger *debugger = dap->debugger;
    for (size_t i = 0; i < debugger->breakpoint_count; i++)
        debugger->breakpoints[i].hits = 0;
    debugger->reported = 0;
    dap->reason = "entry";
    dap->move = dap->stop_on_entry ? to_the_beginning : execution_run;
}

static void go(struct dap *dap)
{
    enum execution_end ended;
    do {
        if (dap->pending == PENDING_RESTART)
            prepare_beginning(dap);
        dap->pending = PENDING_NONE;
        dap->state = DAP_RUNNING;
        ended = dap->move(dap->debugger);
        dap->state = DAP_STANDING;
    } while (!dap->over && dap->pending == PENDING_RESTART);
    if (dap->pending == PENDING_TERMINATE)
        dap_finish(dap);
    else if (!dap->over)
        arrive(dap, ended);
}

void dap_begin(struct dap *dap)
{
    dap->pending = PENDING_RESTART;
    go(dap);
}

/* Starts an execution after the response, because the client must first be notified
 * that the program runs. */
static bool move_by(struct dap *dap, enum execution_end (*move)(struct debugger *))
{
    dap->move = move;
    dap->reason = "step";
    dap->then = go;
    return true;
}

static enum execution_end run_to_end(struct debugger *debugger)
{
    return execution_steps(debugger, UINT64_MAX);
}

static enum execution_end step(struct debugger *debugger)
{
    return execution_steps(debugger, 1);
}

static enum execution_end step_back(struct debugger *debugger)
{
    return execution_back(debugger, 1);
}

bool request_continue(struct dap *dap)
{
    json_bool(dap->body, "allThreadsContinued", true);
    return move_by(dap, run_to_end);
}

/* Returns true if the client steps by instruction. Such a step enters a macro call. A
 * step by statement or line executes the whole call. */
static bool by_instruction(const struct dap *dap)
{
    const char *unit = json_member_text(dap->arguments, "granularity");
    return unit && strcmp(unit, "instruction") == 0;
}

bool request_next(struct dap *dap)
{
    return move_by(dap, by_instruction(dap) ? execution_next : execution_line);
}

bool request_step_in(struct dap *dap)
{
    return move_by(dap, step);
}

bool request_step_out(struct dap *dap)
{
    return execution_can_go_out(dap->debugger) && move_by(dap, execution_out);
}

bool request_step_back(struct dap *dap)
{
    return move_by(dap, by_instruction(dap) ? step_back : execution_back_line);
}

bool request_reverse_continue(struct dap *dap)
{
    return move_by(dap, execution_back_to_stop);
}

/* Pauses the program if it is running. */
bool request_pause(struct dap *dap)
{
    if (dap->state == DAP_RUNNING)
        dap->pending = PENDING_PAUSE;
    return true;
}

/* ---- Jump ---------------------------------------------------------------- */

bool request_goto_targets(struct dap *dap)
{
    const char *file = source_file(dap, json_member(dap->arguments, "source"));
    struct breakpoint stop = { .number = 0 };
    int64_t line = 0;
    if (!file)
        return dap_fault(dap, "expected the path of a source file in 'source'");
    if (!dap_whole(dap, dap->arguments, "line", &line)
        || !place_line(dap->debugger, file, line_of(dap, line), &stop))
        return false;
    json_array(dap->body, "targets");
    json_object(dap->body, NULL);
    json_count(dap->body, "id", stop.address);
    json_text(dap->body, "label", stop.text);
    put_line(dap, dap->body, "line", stop.line);
    dap_put_address(dap->body, "instructionPointerReference", stop.address);
    json_end(dap->body);
    json_end(dap->body);
    return true;
}

static void send_goto(struct dap *dap)
{
    dap_stopped(dap, "goto", false);
}

/* Jumps to a target. Its identifier is its address. */
bool request_goto(struct dap *dap)
{
    int64_t target = -1;
    dap->then = send_goto;
    return dap_whole(dap, dap->arguments, "targetId", &target)
           && debug_jump(dap->debugger, (uint64_t)target);
}

bool request_exception_info(struct dap *dap)
{
    const struct debugger *debugger = dap->debugger;
    if (!debugger->halted || debugger->halt.trap == C205_TRAP_NONE)
        return dap_fault(dap, "no trap has stopped the program");
    show_halt(dap->debugger);
    json_text(dap->body, "exceptionId", c205_trap_name(debugger->halt.trap));
    dap_put_said(dap, dap->body, "description");
    json_text(dap->body, "breakMode", "unhandled");
    return true;
}
