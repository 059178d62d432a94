/* timeline.c - the request `timeline`. The reply has the spans of a picture for the
 * page, or a file in a format of c205 timeline.
 */
#include "asm/timeline/timeline_lanes.h"
#include "web/engine/engine_internal.h"

/* ---- Spans --------------------------------------------------------------- */

static void put_pieces(const struct timed_piece *pieces, size_t first, size_t count,
                       const char *key, struct json *reply)
{
    json_array(reply, key);
    for (size_t i = first; i < first + count; i++)
        put_clocks(reply, pieces[i].begin, pieces[i].end, pieces[i].cause);
    json_end(reply);
}

static void put_insn(const struct engine *engine, struct json *reply,
                     const struct timed_insn *insn)
{
    const struct timeline *timeline = engine->replay.timeline;
    json_object(reply, NULL);
    json_count(reply, "pc", insn->pc);
    json_count(reply, "line", program_line(engine, insn->pc));
    json_text(reply, "text", insn->text);
    json_text(reply, "source", insn->line);
    json_text(reply, "unit", insn->insn ? c205_unit_name(insn->insn->unit) : "");
    json_count(reply, "elements", insn->elements);
    json_count(reply, "arrived", insn->arrived);
    json_count(reply, "issued", insn->issued);
    json_count(reply, "ready", insn->ready);
    json_count(reply, "done", insn->done);
    put_pieces(timeline->phases, insn->first_phase, insn->phase_count, "phases", reply);
    put_pieces(timeline->pieces, insn->first_piece, insn->piece_count, "pieces", reply);
    json_end(reply);
}

static void put_span(const struct timeline *timeline, struct json *reply,
                     const struct timed_span *span)
{
    json_object(reply, NULL);
    json_count(reply, "lane", (uint64_t)span->lane);
    json_count(reply, "row", span->row);
    json_count(reply, "begin", span->begin);
    json_count(reply, "end", span->end);
    json_count(reply, "insn", (uint64_t)(span->insn - timeline->insns));
    if (span->piece)
        json_text(reply, "cause", c205_cause_name(span->piece->cause));
    json_end(reply);
}

/* Writes the lanes and spans. The first lane has the charged causes, which are also
 * written as a separate list. */
static void put_lanes(const struct timeline *timeline, const struct lanes *lanes,
                      struct json *reply)
{
    json_array(reply, "lanes");
    for (int i = 0; i < LANES; i++) {
        json_object(reply, NULL);
        json_text(reply, "name", lane_name((enum lane)i));
        json_count(reply, "rows", lanes->rows[i]);
        json_end(reply);
    }
    json_end(reply);
    json_array(reply, "spans");
    for (size_t i = 0; i < lanes->count; i++)
        put_span(timeline, reply, &lanes->spans[i]);
    json_end(reply);
    json_array(reply, "charged");
    for (size_t i = 0; i < lanes->count; i++)
        if (lanes->spans[i].lane == LANE_CHARGED)
            put_clocks(reply, lanes->spans[i].begin, lanes->spans[i].end,
                       lanes->spans[i].piece->cause);
    json_end(reply);
}

static bool put_spans(const struct engine *engine, struct json *reply,
                      c205_error *error)
{
    struct timeline *timeline = engine->replay.timeline;
    struct arena arena = { NULL, false };
    struct lanes lanes = { 0 };
    bool good = lanes_make(timeline, &arena, &lanes);
    json_array(reply, "insns");
    for (size_t i = 0; i < timeline->insn_count; i++)
        put_insn(engine, reply, &timeline->insns[i]);
    json_end(reply);
    if (good)
        put_lanes(timeline, &lanes, reply);
    arena_free(&arena);
    return good || error_set(error, "out of memory");
}

/* Writes the shares of the causes, or the spans if all instructions are recorded. */
static bool put_picture(const struct engine *engine, struct json *reply,
                        c205_error *error)
{
    if (!engine->replay.shares || !engine->replay.timeline->full)
        return put_spans(engine, reply, error);
    cause_shares_put(engine->replay.shares, reply);
    return true;
}

/* ---- Files --------------------------------------------------------------- */

/* Writes the timeline as the text of a file in a format of c205 timeline. */
static bool put_file(const struct engine *engine, struct json *reply, c205_error *error)
{
    const struct replay *replay = &engine->replay;
    struct text_buffer text = { .text = NULL };
    struct sink sink = text_buffer_sink(&text);
    char title[TIMELINE_TITLE];
    timeline_title(replay->timeline, engine->name, c205_model_name(engine->model),
                   title);
    text.failed |= !timeline_write(replay->timeline, replay->form, title, &sink);
    return put_buffer(reply, "file", &text, error);
}

/* ---- timeline ------------------------------------------------------------ */

static bool put_timeline(struct engine *engine, struct json *reply, c205_error *error)
{
    struct timeline *timeline = engine->replay.timeline;
    if (!timeline_is_good(timeline))
        return error_set(error, "out of memory");
    timeline_finish(timeline);
    json_count(reply, "from", timeline->from);
    json_count(reply, "to", timeline->to);
    json_bool(reply, "full", timeline->full);
    return engine->replay.form ? put_file(engine, reply, error)
                               : put_picture(engine, reply, error);
}

static bool timeline_slice(struct engine *engine, struct json *reply, c205_error *error)
{
    return replay_slice(engine, reply, timeline_slice, put_timeline, error);
}

/* Reads the name of a file. Sets *form to NULL if there is none; spans are then
 * written. */
static bool take_form(const struct json_value *request,
                      const struct timeline_form **form, c205_error *error)
{
    const char *file = NULL;
    if (!take_text_or(request, "file", &file, error))
        return false;
    *form = file ? timeline_form_of(file) : NULL;
    return !file || *form
           || error_set(error, "the name \"file\" must end in .svg, .kanata or .json");
}

/* Replays all known steps, including steps after the current step. */
bool answer_timeline(struct engine *engine, const struct json_value *request,
                     struct json *reply, c205_error *error)
{
    struct timeline *timeline = &engine->timeline;
    uint64_t most = 2000, columns = 0;
    const struct timeline_form *form;
    if (!take_slice(engine, request, error))
        return false;
    *timeline = (struct timeline){ .object = engine->object, .to = UINT64_MAX };
    if (!take_count(request, "from", &timeline->from, error)
        || !take_count(request, "to", &timeline->to, error)
        || !take_count(request, "most", &most, error)
        || !take_count(request, "columns", &columns, error)
        || !take_form(request, &form, error))
        return false;
    if (timeline->from >= timeline->to)
        return error_set(error, "\"from\" must be before \"to\"");
    if (columns > MAX_COLUMNS || columns > timeline->to - timeline->from)
        return error_set(error, "\"columns\" must be at most %d and at most the clocks",
                         MAX_COLUMNS);
    timeline->most = most < MAX_TIMELINE ? (size_t)most : MAX_TIMELINE;
    if (!replay_begin(engine, NULL, timeline, debugger_known(engine->debugger), error))
        return false;
    engine->replay.form = form;
    if (columns > 0)
        engine->replay.shares = cause_shares_new(timeline->from, timeline->to,
                                                 (size_t)columns);
    if (columns > 0 && !engine->replay.shares) {
        replay_drop(engine);
        return error_set(error, "out of memory");
    }
    return timeline_slice(engine, reply, error);
}
