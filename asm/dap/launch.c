/* launch.c - executes the requests that start and end a session. */
#include <stdio.h>
#include <string.h>

#include "asm/dap/dap_internal.h"

/* ---- initialize --------------------------------------------------------------- */

static const char *const capabilities[] = {
    "supportsConfigurationDoneRequest",
    "supportsFunctionBreakpoints",
    "supportsConditionalBreakpoints",
    "supportsHitConditionalBreakpoints",
    "supportsEvaluateForHovers",
    "supportsStepBack",
    "supportsSetVariable",
    "supportsSetExpression",
    "supportsGotoTargetsRequest",
    "supportsRestartRequest",
    "supportsExceptionInfoRequest",
    "supportsDelayedStackTraceLoading",
    "supportsLoadedSourcesRequest",
    "supportsTerminateRequest",
    "supportsDataBreakpoints",
    "supportsDataBreakpointBytes",
    "supportsReadMemoryRequest",
    "supportsWriteMemoryRequest",
    "supportsDisassembleRequest",
    "supportsBreakpointLocationsRequest",
    "supportsClipboardContext",
    "supportsSteppingGranularity",
    "supportsInstructionBreakpoints",
};

static void put_trap_filter(struct json *body)
{
    json_array(body, "exceptionBreakpointFilters");
    json_object(body, NULL);
    json_text(body, "filter", "trap");
    json_text(body, "label", "Traps");
    json_text(body, "description", "Stop at a trap; otherwise the program ends there");
    json_bool(body, "default", true);
    json_end(body);
    json_end(body);
}

bool request_initialize(struct dap *dap)
{
    const char *paths = json_member_text(dap->arguments, "pathFormat");
    if (paths && strcmp(paths, "path") != 0)
        return dap_fault(dap,
                         "the path format '%.40s' is not supported; expected 'path'",
                         paths);
    for (size_t i = 0; i < sizeof capabilities / sizeof *capabilities; i++)
        json_bool(dap->body, capabilities[i], true);
    put_trap_filter(dap->body);
    dap->first_line = json_member_truth(dap->arguments, "linesStartAt1", true);
    dap->first_column = json_member_truth(dap->arguments, "columnsStartAt1", true);
    dap->client_redraws = json_member_truth(dap->arguments, "supportsInvalidatedEvent",
                                            false);
    dap->state = DAP_GREETED;
    return true;
}

/* ---- launch --------------------------------------------------------------------- */

/* Copies a text into the arena that lives as long as the program. The copy of NULL is
 * NULL. */
static const char *copy_text(struct dap *dap, const char *text)
{
    return text ? arena_text(&dap->launched, text, strlen(text)) : NULL;
}

/* Reads definitions from an object such as { "N": 8 }. Returns NULL if memory is
 * exhausted. */
static const struct asm_define *read_defines(struct dap *dap)
{
    const struct json_value *object = json_member(dap->arguments, "defines");
    const struct json_value *item = object ? object->first : NULL;
    struct asm_define *defines = arena_take(&dap->launched, (json_length(object) + 1)
                                                                * sizeof *defines);
    for (size_t i = 0; defines && item; i++, item = item->next) {
        defines[i].name = copy_text(dap, item->key);
        json_member_whole(object, item->key, &defines[i].value);
    }
    return defines;
}

/* Reads the argument "include", a list of folders such as [ "DIR", .. ]. */
static const char *const *read_search(struct dap *dap)
{
    const struct json_value *list = json_member(dap->arguments, "include");
    const struct json_value *item = list ? list->first : NULL;
    const char **search = arena_take(&dap->launched,
                                     (json_length(list) + 1) * sizeof *search);
    for (size_t i = 0; search && item; i++, item = item->next)
        search[i] = copy_text(dap, item->text);
    return search;
}

static bool read_program(struct dap *dap, struct dap_program *program)
{
    const char *path = json_member_text(dap->arguments, "program");
    path = path ? path : dap->setup.program;
    if (!path)
        return dap_fault(dap, "'program' is missing");
    if (strcmp(path, "-") == 0)
        return dap_fault(
            dap, "the program cannot be read from stdin, which carries the requests");
    program->path = dap->path = copy_text(dap, path);
    program->model = json_member_text(dap->arguments, "model");
    program->defines = read_defines(dap);
    program->search = program->defines ? read_search(dap) : NULL;
    return program->search;
}

static void print(void *context, const char *text, size_t length)
{
    struct dap *dap = context;
    struct sink sink = text_buffer_sink(&dap->printed);
    sink.put(sink.context, text, length);
}

static bool make_debugger(struct dap *dap, bool warm)
{
    struct debugger_setup setup = { .object = dap->object,
                                    .name = dap->path,
                                    .model = dap->model,
                                    .out = dap_output_sink(dap),
                                    .printed = { print, dap },
                                    .printed_apart = true,
                                    .warm = warm,
                                    .clocks_most = dap->setup.clocks_most,
                                    .interrupted = dap_listen,
                                    .asked = dap };
    c205_error error;
    dap->debugger = debugger_new(&setup, &error);
    return dap->debugger || dap_fault(dap, "%s", error.message);
}

static bool open_program(struct dap *dap)
{
    struct dap_program program;
    struct sink report = dap_output_sink(dap);
    return read_program(dap, &program)
           && dap->setup.open(dap->setup.context, &program, &report, &dap->object,
                              &dap->model)
           && make_debugger(dap,
                            json_member_truth(dap->arguments, "warm", dap->setup.warm))
           && (sources_find(dap) || dap_fault(dap, "out of memory"));
}

void close_program(struct dap *dap)
{
    debugger_free(dap->debugger);
    object_free(dap->object);
    c205_model_free(dap->model);
    arena_free(&dap->launched);
    dap->debugger = NULL;
    dap->object = NULL;
    dap->model = NULL;
    dap->path = NULL;
}

/* Requests the breakpoints by the event `initialized`. Setting them needs the program,
 * so the event is sent after the launch. */
static void ask_configuration(struct dap *dap)
{
    send_event(dap, "initialized", NULL);
}

/* Reads whether traps, the entry and the end stop the program. With noDebug none of
 * them does. */
static void read_stops(struct dap *dap)
{
    bool stops = !json_member_truth(dap->arguments, "noDebug", false);
    dap->stop_at_traps = stops;
    dap->stop_on_entry = stops
                         && json_member_truth(dap->arguments, "stopOnEntry", false);
    dap->stop_on_end = stops && json_member_truth(dap->arguments, "stopOnEnd", false);
}

bool request_launch(struct dap *dap)
{
    if (!open_program(dap)) {
        send_output(dap, "stderr", dap->said.text);
        close_program(dap);
        return false;
    }
    read_stops(dap);
    dap->state = DAP_LAUNCHED;
    dap->then = ask_configuration;
    return true;
}

bool request_configuration_done(struct dap *dap)
{
    dap->state = DAP_STANDING;
    dap->then = dap_begin;
    return true;
}

/* ---- Restart and end ----------------------------------------------------- */

/* Ends the execution of the program because of a request. If the program runs, the
 * pending request ends it. Otherwise, `then` is called after the response. */
static bool end_execution(struct dap *dap, enum pending_request pending,
                          void (*then)(struct dap *dap))
{
    if (dap->state == DAP_RUNNING)
        dap->pending = pending;
    else
        dap->then = then;
    return true;
}

bool request_restart(struct dap *dap)
{
    return end_execution(dap, PENDING_RESTART, dap_begin);
}

bool request_terminate(struct dap *dap)
{
    return end_execution(dap, PENDING_TERMINATE, dap_finish);
}

bool request_disconnect(struct dap *dap)
{
    dap->over = true;
    return true;
}
