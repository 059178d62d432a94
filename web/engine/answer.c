/* answer.c - reads requests, dispatches them, and divides long work into slices. */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "web/engine/engine_internal.h"

/* ---- Errors ------------------------------------------------------------------ */

bool refuse_of(c205_error *error, const char *name)
{
    c205_error why = *error;
    return error_set(error, "%.80s: %.160s", name, why.message);
}

bool refuse_with_report(struct engine *engine, c205_error *error)
{
    const char *said = debugger_report(&engine->said);
    error_set(error, "%s", *said ? said : "out of memory");
    text_buffer_free(&engine->said);
    return false;
}

bool put_said(struct engine *engine, struct json *reply, const char *key,
              c205_error *error)
{
    bool good = !engine->said.failed;
    json_text(reply, key, debugger_report(&engine->said));
    text_buffer_free(&engine->said);
    return good || error_set(error, "out of memory");
}

void put_clocks(struct json *reply, uint64_t begin, uint64_t end, c205_cause cause)
{
    json_object(reply, NULL);
    json_count(reply, "begin", begin);
    json_count(reply, "end", end);
    json_text(reply, "cause", c205_cause_name(cause));
    json_end(reply);
}

bool put_buffer(struct json *reply, const char *key, struct text_buffer *text,
                c205_error *error)
{
    bool good = !text->failed;
    json_text(reply, key, text->text ? text->text : "");
    text_buffer_free(text);
    return good || error_set(error, "out of memory");
}

char *copy_of(const char *text)
{
    char *copy = malloc(strlen(text) + 1);
    return copy ? strcpy(copy, text) : NULL;
}

/* ---- Members of a request ------------------------------------------------------ */

bool take_text_or(const struct json_value *request, const char *key, const char **text,
                  c205_error *error)
{
    const struct json_value *value = json_member(request, key);
    if (value && value->kind != JSON_TEXT)
        return error_set(error, "\"%s\" is not a string", key);
    if (value)
        *text = value->text;
    return true;
}

bool take_text(const struct json_value *request, const char *key, const char **text,
               c205_error *error)
{
    *text = NULL;
    return take_text_or(request, key, text, error)
           && (*text || error_set(error, "\"%s\" is missing", key));
}

bool take_truth(const struct json_value *request, const char *key, bool *truth,
                c205_error *error)
{
    const struct json_value *value = json_member(request, key);
    if (value && value->kind != JSON_TRUTH)
        return error_set(error, "\"%s\" must be true or false", key);
    if (value)
        *truth = value->truth;
    return true;
}

bool take_count(const struct json_value *request, const char *key, uint64_t *count,
                c205_error *error)
{
    int64_t value = 0;
    if (!json_member(request, key))
        return true;
    if (!json_member_whole(request, key, &value) || value < 0)
        return error_set(error, "\"%s\" is not an integer from 0 on", key);
    *count = (uint64_t)value;
    return true;
}

bool take_limit(const struct engine *engine, const struct json_value *request,
                uint64_t *limit, c205_error *error)
{
    bool good = take_count(request, "limit", limit, error);
    if (*limit > engine->bound)
        *limit = engine->bound;
    return good;
}

/* ---- Slices ---------------------------------------------------------------------- */

static double milliseconds(void)
{
    struct timespec now = { 0, 0 };
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

bool take_slice(struct engine *engine, const struct json_value *request,
                c205_error *error)
{
    uint64_t ms = UINT64_MAX;
    struct slice *slice = &engine->slice;
    slice->clocks = 0;
    if (!take_count(request, "ms", &ms, error)
        || !take_count(request, "clocks", &slice->clocks, error))
        return false;
    slice->ms = ms == UINT64_MAX ? -1 : (double)ms;
    slice->begun = milliseconds();
    slice->from = engine->debugger ? c205_clock(engine_machine(engine)) : 0;
    slice->spent = 0;
    slice->to_the_limit = false;
    return true;
}

static bool time_is_over(const struct slice *slice)
{
    return slice->ms >= 0 && milliseconds() - slice->begun >= slice->ms;
}

bool slice_is_over(void *given)
{
    struct engine *engine = given;
    struct slice *slice = &engine->slice;
    uint64_t clock = c205_clock(engine_machine(engine));
    slice->to_the_limit = clock >= slice->ends_at;
    if (clock < slice->from) /* the program has gone back */
        slice->from = clock;
    return slice->to_the_limit
           || (slice->clocks > 0 && clock - slice->from >= slice->clocks)
           || time_is_over(slice);
}

bool slice_is_full(const struct engine *engine)
{
    const struct slice *slice = &engine->slice;
    return (slice->clocks > 0 && slice->spent >= slice->clocks) || time_is_over(slice);
}

/* ---- Requests ------------------------------------------------------------ */

static void drop_work(struct engine *engine)
{
    replay_drop(engine);
    sweep_drop(engine);
    compare_drop(engine);
    engine->goes_on = NULL;
}

static bool answer_more(struct engine *engine, const struct json_value *request,
                        struct json *reply, c205_error *error)
{
    engine_slice *goes_on = engine->goes_on;
    if (!goes_on)
        return error_set(error, "no work is left to continue");
    return take_slice(engine, request, error) && goes_on(engine, reply, error);
}

/* The effects of a request on unfinished work, which waits for `more`. */
enum keeps { KEEPS_NOTHING, KEEPS_MOVEMENT, KEEPS_ALL };

static const struct {
    const char *name;
    engine_request *answer;
    enum keeps keeps;
    bool needs_program;
} requests[] = {
    { "about", answer_about, KEEPS_ALL, false },
    { "load", answer_load, KEEPS_NOTHING, false },
    { "breaks", answer_breaks, KEEPS_NOTHING, true },
    { "go", answer_go, KEEPS_NOTHING, true },
    { "view", answer_view, KEEPS_MOVEMENT, true },
    { "timeline", answer_timeline, KEEPS_NOTHING, true },
    { "profile", answer_profile, KEEPS_NOTHING, true },
    { "results", answer_results, KEEPS_MOVEMENT, true },
    { "accounts", answer_accounts, KEEPS_MOVEMENT, true },
    { "say", answer_command, KEEPS_NOTHING, true },
    { "sweep", answer_sweep, KEEPS_NOTHING, false },
    { "compare", answer_compare, KEEPS_NOTHING, false },
    { "grade", answer_grade, KEEPS_ALL, false },
    { "more", answer_more, KEEPS_ALL, false },
};
enum { REQUESTS = sizeof requests / sizeof *requests };

static bool answer(struct engine *engine, const struct json_value *request,
                   struct json *reply, c205_error *error)
{
    const char *name;
    size_t i = 0;
    if (request->kind != JSON_OBJECT)
        return error_set(error, "a request must be an object");
    if (!take_text(request, "do", &name, error))
        return false;
    while (i < REQUESTS && strcmp(requests[i].name, name) != 0)
        i++;
    if (i == REQUESTS)
        return error_set(error, "unknown request \"%.60s\"", name);
    if (requests[i].keeps == KEEPS_NOTHING
        || (requests[i].keeps == KEEPS_MOVEMENT && engine->replay.begun))
        drop_work(engine);
    if (requests[i].needs_program && !engine->debugger)
        return error_set(error, "no program is loaded");
    return requests[i].answer(engine, request, reply, error);
}

/* Returns the reply to a failed request, or NULL if memory is exhausted. */
static char *put_refusal(const struct engine *engine, const char *why)
{
    struct text_buffer text = { .text = NULL };
    c205_error error;
    struct json *reply = json_open_line(&text, &error);
    if (!reply)
        return NULL;
    json_bool(reply, "ok", false);
    json_text(reply, "error", why);
    if (engine->diagnostics.count > 0)
        put_diagnostics(&engine->diagnostics, reply);
    if (json_close(reply, &error))
        return text.text;
    text_buffer_free(&text);
    return NULL;
}

static char *answer_read(struct engine *engine, const struct json_value *request)
{
    struct text_buffer text = { .text = NULL };
    c205_error error = { "out of memory" };
    struct json *reply = json_open_line(&text, &error);
    if (!reply)
        return NULL;
    json_bool(reply, "ok", true);
    if (!answer(engine, request, reply, &error))
        json_discard(reply);
    else if (json_close(reply, &error))
        return text.text;
    text_buffer_free(&text);
    return put_refusal(engine, error.message);
}

char *engine_answer(struct engine *engine, const char *request, size_t length)
{
    struct arena arena = { 0 };
    c205_error error;
    const struct json_value *read = json_read(&arena, request, length, &error);
    char *text = read ? answer_read(engine, read) : put_refusal(engine, error.message);
    diagnostics_free(&engine->diagnostics);
    engine->diagnostics = (struct diagnostics){ 0 };
    arena_free(&arena);
    return text;
}

/* ---- Create and free ----------------------------------------------------- */

struct engine *engine_new(void)
{
    struct engine *engine = calloc(1, sizeof *engine);
    if (engine)
        engine->bound = UINT64_MAX;
    return engine;
}

void engine_bound(struct engine *engine, uint64_t clocks)
{
    engine->bound = clocks;
}

void engine_free(struct engine *engine)
{
    if (!engine)
        return;
    drop_work(engine);
    program_drop(engine);
    text_buffer_free(&engine->said);
    free(engine);
}
