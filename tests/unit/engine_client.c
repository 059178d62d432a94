/* engine_client.c - sends requests to an engine and parses its replies. */
#include "tests/unit/engine_client.h"

#include "base/json.h"

struct talk talk_with(const char *text, const char *more)
{
    struct talk talk = { .engine = engine_new() };
    assert_non_null(talk.engine);
    if (text)
        talk_load(&talk, text, more);
    return talk;
}

static void forget(struct talk *talk)
{
    free(talk->text);
    arena_free(&talk->arena);
    talk->arena = (struct arena){ 0 };
}

void talk_free(struct talk *talk)
{
    forget(talk);
    engine_free(talk->engine);
}

const struct json_value *talk_bytes(struct talk *talk, const char *request,
                                    size_t length)
{
    forget(talk);
    talk->text = NON_NULL(engine_answer(talk->engine, request, length));
    talk->reply = json_read(&talk->arena, talk->text, strlen(talk->text), &failure);
    FAIL_IF(!talk->reply, "%.*s\n%s: %s", (int)length, request, talk->text,
            failure.message);
    const struct json_value *ok = NON_NULL(json_member(talk->reply, "ok"));
    assert_int_equal(ok->kind, JSON_TRUTH);
    if (!ok->truth)
        assert_true(*text_of(talk->reply, "error"));
    return talk->reply;
}

void talk_quote(char *text)
{
    while ((text = strchr(text, '\'')) != NULL)
        *text = '"';
}

static bool has(const char *text, const char *part)
{
    char quoted[400];
    snprintf(quoted, sizeof quoted, "%s", part);
    talk_quote(quoted);
    return strstr(text, part) || strstr(text, quoted);
}

/* Formats a request, replaces each ' by ", sends the request and reads the reply. */
const char *talk_send(struct talk *talk, const char *format, ...)
{
    static char request[1 << 16];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(request, sizeof request, format, arguments);
    va_end(arguments);
    assert_true(length >= 0 && (size_t)length < sizeof request);
    talk_quote(request);
    talk_bytes(talk, request, (size_t)length);
    return request;
}

const struct json_value *talk_success(const struct talk *talk, const char *request)
{
    FAIL_IF(!json_member_truth(talk->reply, "ok", false), "%s\n%s", request,
            talk->text);
    return talk->reply;
}

void talk_failure(const struct talk *talk, const char *why, const char *request)
{
    FAIL_IF(json_member_truth(talk->reply, "ok", true)
                || !has(text_of(talk->reply, "error"), why),
            "%s\n%s, not %s", request, talk->text, why);
}

void talk_says(const struct talk *talk, const char *part)
{
    FAIL_IF(!has(talk->text, part), "not '%s', but %s", part, talk->text);
}

const struct json_value *talk_load(struct talk *talk, const char *text,
                                   const char *more)
{
    SCOPED_VALUE(text_buffer) line = { .text = NULL };
    struct sink sink = text_buffer_sink(&line);
    struct json *json = json_open_line(&line, &failure);
    json_text(json, "do", "load");
    json_text(json, "text", text);
    assert_true(json_close(json, &failure));
    size_t length = line.length -= strlen("}");
    sink_print(&sink, "%s}", more);
    talk_quote(line.text + length);
    talk_bytes(talk, line.text, line.length);
    talk_success(talk, line.text);
    return talk->reply;
}

double number_of(const struct json_value *object, const char *key)
{
    const struct json_value *value = json_member(object, key);
    FAIL_IF(!value || value->kind != JSON_NUMBER, "'%s' is no number", key);
    return value->number;
}

const char *text_of(const struct json_value *object, const char *key)
{
    const char *text = json_member_text(object, key);
    FAIL_IF(!text, "'%s' is no text", key);
    return text;
}

size_t items_of(const struct json_value *list)
{
    size_t length = 0;
    for (const struct json_value *item = list ? list->first : NULL; item;
         item = item->next)
        length++;
    return length;
}
