/* session.c - reads messages of the client and dispatches the requests. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/dap/message.h"
#include "asm/dap/dap_internal.h"
#include "vm/error.h"

/* ---- Requests ----------------------------------------------------------------- */

#define ROW(name, answer, states) { name, answer, states },
static const struct {
    const char *name;
    dap_request *answer;
    unsigned states; /* the states in which it is permitted */
} requests[] = { DAP_REQUESTS(ROW) };
enum { REQUESTS = sizeof requests / sizeof *requests };

static bool may_come(struct dap *dap, unsigned states)
{
    if (states & (unsigned)dap->state)
        return true;
    switch (dap->state) {
    case DAP_NEW: return dap_fault(dap, "send 'initialize' first");
    case DAP_GREETED: return dap_fault(dap, "send 'launch' first");
    case DAP_LAUNCHED:
        return states & DAP_STANDING ? dap_fault(dap, "send 'configurationDone' first")
                                     : dap_fault(dap, "a program is already launched");
    case DAP_RUNNING: return dap_fault(dap, "the program is running; pause it first");
    case DAP_ENDED: return dap_fault(dap, "the program has ended");
    default: return dap_fault(dap, "this request is allowed only once");
    }
}

static bool answer(struct dap *dap, const char *command)
{
    size_t i = 0;
    while (i < REQUESTS && strcmp(requests[i].name, command) != 0)
        i++;
    if (i == REQUESTS)
        return dap_fault(dap, "unknown request '%.60s'", command);
    return may_come(dap, requests[i].states) && dap_check(dap, command, dap->arguments)
           && requests[i].answer(dap);
}

/* Sends the response. Reports of a successful request become console output. Reports of
 * a failed request are the reason of the failure. */
static void respond(struct dap *dap, const struct json_value *request, bool good,
                    const char *body)
{
    const char *said = debugger_report(&dap->said);
    if (good)
        send_output(dap, "console", said);
    send_response(dap, request, good, good ? body : *said ? said : "out of memory");
}

/* Executes a request and responds. If an earlier request is running the program,
 * `outer` saves the state of the earlier request. */
static void handle_request(struct dap *dap, const struct json_value *request)
{
    struct text_buffer body;
    struct dap outer = *dap;
    struct json *json = event_begin(dap, &body);
    void (*then)(struct dap * dap);
    bool good;
    if (!json)
        return;
    dap->said = (struct text_buffer){ .text = NULL };
    dap->then = NULL;
    dap->arguments = json_member(request, "arguments");
    dap->body = json;
    good = answer(dap, json_member_text(request, "command"));
    send_printed(dap);
    if (!good)
        json_discard(json);
    if (!good || json_close(json, dap->error))
        respond(dap, request, good, body.text);
    text_buffer_free(&body);
    text_buffer_free(&dap->said);
    dap->said = outer.said;
    dap->arguments = outer.arguments;
    dap->body = outer.body;
    then = good ? dap->then : NULL;
    dap->then = NULL;
    if (then)
        then(dap);
}

/* ---- Messages ------------------------------------------------------------------- */

/* Handles a message. Messages other than requests need no response. A message without a
 * type is reported as output, because there is no request to respond to. */
static void handle_message(struct dap *dap, const char *text, size_t length)
{
    struct arena arena = { 0 };
    c205_error error;
    const struct json_value *message = json_read(&arena, text, length, &error);
    const char *type = json_member_text(message, "type");
    char line[400];
    if (!message || !type) {
        snprintf(line, sizeof line, "invalid message: %s\n",
                 message ? "it has no type" : error.message);
        send_output(dap, "stderr", line);
    } else if (strcmp(type, "request") == 0 && json_member_text(message, "command")) {
        handle_request(dap, message);
    }
    arena_free(&arena);
}

/* Handles the next complete message. Returns false if there is none. */
static bool handle_next(struct dap *dap)
{
    struct message_content content;
    char *text;
    switch (message_find(&dap->input, &content, dap->error)) {
    case MESSAGE_PART: return false;
    case MESSAGE_BROKEN: dap->over = dap->failed = true; return false;
    default: break;
    }
    text = malloc(content.length + 1);
    if (!text) {
        error_set(dap->error, "out of memory");
        dap->over = dap->failed = true;
        return false;
    }
    memcpy(text, dap->input.text + content.begin, content.length);
    message_drop(&dap->input, content.begin + content.length);
    handle_message(dap, text, content.length);
    free(text);
    return true;
}

static void read_more(struct dap *dap)
{
    enum { AT_ONCE = 1 << 16 };
    struct sink sink = text_buffer_sink(&dap->input);
    char bytes[AT_ONCE];
    size_t length = dap->setup.read(dap->setup.context, bytes, sizeof bytes);
    sink.put(sink.context, bytes, length);
    if (length > 0 && !dap->input.failed)
        return;
    dap->over = true;
    dap->failed = dap->input.failed || dap->input.length > 0;
    error_set(dap->error, "%s",
              dap->input.failed ? "out of memory" : "the input ends within a message");
}

bool dap_listen(void *given)
{
    struct dap *dap = given;
    send_printed(dap);
    if (dap->setup.ready(dap->setup.context))
        read_more(dap);
    while (!dap->over && dap->pending == PENDING_NONE && handle_next(dap))
        continue;
    return dap->over || dap->pending != PENDING_NONE;
}

/* ---- The session --------------------------------------------------------- */

static void end_session(struct dap *dap)
{
    close_program(dap);
    text_buffer_free(&dap->input);
    text_buffer_free(&dap->printed);
    text_buffer_free(&dap->said);
}

bool dap_serve(const struct dap_setup *setup, c205_error *error)
{
    struct dap dap = { .setup = *setup, .state = DAP_NEW, .error = error };
    while (!dap.over)
        if (!handle_next(&dap) && !dap.over)
            read_more(&dap);
    end_session(&dap);
    return !dap.failed;
}
