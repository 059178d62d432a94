/* respond.c - writes responses, events and reports. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/dap/message.h"
#include "asm/dap/dap_internal.h"
#include "vm/error.h"

/* ---- Texts ------------------------------------------------------------------ */

struct sink dap_output_sink(struct dap *dap)
{
    return text_buffer_sink(&dap->said);
}

bool dap_fault(struct dap *dap, const char *format, ...)
{
    struct sink sink = dap_output_sink(dap);
    char text[512];
    PRINTF_TEXT(text, format);
    sink_put(&sink, text);
    return false;
}

void dap_put_said(struct dap *dap, struct json *json, const char *key)
{
    json_text(json, key, debugger_report(&dap->said));
    text_buffer_free(&dap->said);
}

/* ---- Messages ----------------------------------------------------------------- */

static void give_up(struct dap *dap, const char *why)
{
    error_set(dap->error, "%s", why);
    dap->over = dap->failed = true;
}

struct json *event_begin(struct dap *dap, struct text_buffer *line)
{
    struct json *json;
    *line = (struct text_buffer){ .text = NULL };
    json = json_open_line(line, dap->error);
    if (!json)
        dap->over = dap->failed = true;
    return json;
}

static struct json *message_begin(struct dap *dap, struct text_buffer *line,
                                  const char *type)
{
    struct json *json = event_begin(dap, line);
    if (!json)
        return NULL;
    json_count(json, "seq", ++dap->sent);
    json_text(json, "type", type);
    return json;
}

static void message_end(struct dap *dap, struct json *json, struct text_buffer *line)
{
    if (!json_close(json, dap->error))
        dap->over = dap->failed = true;
    else
        message_put(line, &dap->setup.out);
    text_buffer_free(line);
}

/* ---- Events --------------------------------------------------------------------- */

void send_event(struct dap *dap, const char *name, const char *body)
{
    struct text_buffer line;
    struct json *json = message_begin(dap, &line, "event");
    if (!json)
        return;
    json_text(json, "event", name);
    if (body)
        json_raw(json, "body", body);
    message_end(dap, json, &line);
}

void event_end(struct dap *dap, const char *name, struct json *json,
               struct text_buffer *body)
{
    if (json_close(json, dap->error))
        send_event(dap, name, body->text);
    else
        dap->over = dap->failed = true;
    text_buffer_free(body);
}

void send_output(struct dap *dap, const char *category, const char *text)
{
    struct text_buffer body;
    struct json *json;
    if (!text || !*text)
        return;
    json = event_begin(dap, &body);
    if (!json)
        return;
    json_text(json, "category", category);
    json_text(json, "output", text);
    event_end(dap, "output", json, &body);
}

void send_printed(struct dap *dap)
{
    if (dap->printed.failed)
        give_up(dap, "out of memory");
    send_output(dap, "stdout", dap->printed.text);
    text_buffer_free(&dap->printed);
}

/* ---- Responses ----------------------------------------------------------- */

void send_response(struct dap *dap, const struct json_value *request, bool success,
                   const char *text)
{
    struct text_buffer line;
    struct json *json = message_begin(dap, &line, "response");
    int64_t number = 0;
    if (!json)
        return;
    json_member_whole(request, "seq", &number);
    json_number(json, "request_seq", (double)number);
    json_bool(json, "success", success);
    json_text(json, "command", json_member_text(request, "command"));
    (success ? json_raw : json_text)(json, success ? "body" : "message", text);
    message_end(dap, json, &line);
}

/* ---- Numbers and addresses ----------------------------------------------- */

void dap_put_address(struct json *json, const char *key, uint64_t address)
{
    char text[DAP_ADDRESS_SIZE];
    snprintf(text, sizeof text, "0x%" PRIX64, address);
    json_text(json, key, text);
}

bool dap_whole(struct dap *dap, const struct json_value *arguments, const char *key,
               int64_t *value)
{
    return json_member_whole(arguments, key, value)
           || dap_fault(dap, "'%s' is not an integer", key);
}

bool dap_address(struct dap *dap, const struct json_value *arguments,
                 const char *reference, uint64_t *address)
{
    uint64_t mask = (UINT64_C(1) << 48) - 1;
    const char *text = json_member_text(arguments, reference);
    int64_t offset = 0;
    char *end;
    if (!text)
        return dap_fault(dap, "'%s' is missing", reference);
    *address = strtoull(text, &end, 0);
    if (end == text || *end || *address > mask)
        return dap_fault(dap, "'%.40s' is not an address", text);
    if (!dap_whole(dap, arguments, "offset", &offset))
        return false;
    *address = (*address + 8 * (uint64_t)offset) & mask;
    return true;
}
