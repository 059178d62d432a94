/* replay.c - the run so far once more, for who listens: where its clocks went line by line,
 * and when each instruction was at work.  What somebody has changed on the way is changed
 * again.
 */
#include <stdio.h>
#include <string.h>

#include "asm/timeline/lanes.h"
#include "web/engine/parts.h"

/* ---- Once more ------------------------------------------------------------------ */

void replay_listen(void *context, const c205 *machine,
                   const c205_event *event)
{
    struct engine *engine = context;

    if (engine->replay.profile)
        line_profile_listen(engine->replay.profile, machine, event);
    if (engine->replay.timeline)
        timeline_listen(engine->replay.timeline, machine, event);
}

static void fall_silent(struct replay *replay)
{
    line_profile_free(replay->profile);
    if (replay->timeline)
        timeline_free(replay->timeline);
    *replay = (struct replay){ .begun = false };
}

/* To a step; where nothing could go on there it is tried again. */
static enum moved stand_at(struct engine *engine, uint64_t step, bool halted)
{
    enum moved moved = motion_to_step(engine->debugger, step);

    if (halted && moved == MOVED_ON)
        moved = motion_steps(engine->debugger, 1);
    return moved;
}

void replay_drop(struct engine *engine)
{
    struct replay replay = engine->replay;

    if (!replay.begun)
        return;
    fall_silent(&engine->replay);
    engine->slice = (struct slice){ .ms = -1, .ends_at = UINT64_MAX };
    stand_at(engine, replay.stands, replay.halted);
}

/* The listeners are the replay's from here on; none of them: there was no memory. */
static bool begin(struct engine *engine, struct line_profile *profile,
                  struct timeline *timeline, uint64_t end, c205_error *error)
{
    struct replay *replay = &engine->replay;

    if (!profile && !timeline)
        return refuse(error, "no memory");
    replay->begun = true;
    replay->stands = debugger_step(engine->debugger);
    replay->halted = debugger_halt(engine->debugger);
    replay->end = end;
    engine->slice.ends_at = UINT64_MAX;
    if (motion_to_step(engine->debugger, 0) == MOVED_NOT) {
        line_profile_free(profile);
        *replay = (struct replay){ .begun = false };
        return refuse_as_said(engine, error);
    }
    replay->profile = profile;
    replay->timeline = timeline;
    return true;
}

/* Nothing is at work behind a timeline's end that it would show. */
static bool is_behind(const struct engine *engine)
{
    const struct timeline *timeline = engine->replay.timeline;

    return debugger_step(engine->debugger) >= engine->replay.end
           || (timeline
               && c205_clock(engine_machine(engine)) >= timeline->to);
}

/* *done: all has been heard. */
static bool go_on(struct engine *engine, bool *done, c205_error *error)
{
    enum { AT_ONCE = 512 };
    struct replay *replay = &engine->replay;
    enum moved moved = MOVED_ON;

    while (moved == MOVED_ON && !is_behind(engine)) {
        uint64_t step = debugger_step(engine->debugger);
        uint64_t left = replay->end - step;

        moved = motion_to_step(engine->debugger,
                               step + (left < AT_ONCE ? left : AT_ONCE));
        if (moved == MOVED_ON && !is_behind(engine) && slice_is_over(engine))
            moved = MOVED_INTERRUPTED;
    }
    if (moved == MOVED_NOT)
        return refuse_as_said(engine, error);
    *done = moved != MOVED_INTERRUPTED;
    if (*done && replay->halted && replay->end == replay->stands
        && debugger_step(engine->debugger) == replay->end)
        stand_at(engine, replay->stands, !debugger_halt(engine->debugger));
    return true;
}

/* False in *done: there will be more.  The reply is put by one who has heard all. */
static bool slice(struct engine *engine, struct json *reply,
                  engine_slice *again, engine_slice *put, c205_error *error)
{
    bool done = false, good = go_on(engine, &done, error);

    engine->goes_on = good && !done ? again : NULL;
    if (good)
        json_truth(reply, "done", done);
    if (good && !done)
        json_count(reply, "step", debugger_step(engine->debugger));
    if (good && done)
        good = put(engine, reply, error);
    if (!good || done)
        replay_drop(engine);
    return good;
}

/* ---- profile ---------------------------------------------------------------------- */

/* As c205 run --profile has it in its JSON. */
static bool put_profile(struct engine *engine, struct json *reply,
                        c205_error *error)
{
    struct profile_view view = { engine->replay.in_order ? PROFILE_AS_WRITTEN
                                                         : PROFILE_HOTTEST,
                                 false };
    struct table *table = line_profile_table(engine->replay.profile, view,
                                             false);

    return put_table(table, "lines", reply, error);
}

static bool profile_slice(struct engine *engine, struct json *reply,
                          c205_error *error)
{
    return slice(engine, reply, profile_slice, put_profile, error);
}

bool answer_profile(struct engine *engine, const struct json_value *request,
                    struct json *reply, c205_error *error)
{
    struct replay *replay = &engine->replay;

    if (!needs_program(engine, error) || !take_slice(engine, request, error)
        || !begin(engine, line_profile_new(engine->object), NULL,
                  debugger_step(engine->debugger), error))
        return false;
    replay->in_order = json_member_truth(request, "in-order", false);
    return profile_slice(engine, reply, error);
}

/* ---- timeline ---------------------------------------------------------------------- */

static void put_pieces(const struct timed_piece *pieces, size_t first,
                       size_t count, const char *key, struct json *reply)
{
    json_array(reply, key);
    for (size_t i = first; i < first + count; i++) {
        json_object(reply, NULL);
        json_count(reply, "begin", pieces[i].begin);
        json_count(reply, "end", pieces[i].end);
        json_text(reply, "cause", c205_cause_name(pieces[i].cause));
        json_end(reply);
    }
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
    json_text(reply, "unit",
              insn->insn ? c205_unit_name(insn->insn->unit) : "");
    json_count(reply, "elements", insn->elements);
    json_count(reply, "arrived", insn->arrived);
    json_count(reply, "issued", insn->issued);
    json_count(reply, "ready", insn->ready);
    json_count(reply, "done", insn->done);
    put_pieces(timeline->phases, insn->first_phase, insn->phase_count,
               "phases", reply);
    put_pieces(timeline->pieces, insn->first_piece, insn->piece_count,
               "pieces", reply);
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

/* What the clock was charged to is in the first lane. */
static void put_lanes(const struct timeline *timeline,
                      const struct lanes *lanes, struct json *reply)
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
        if (lanes->spans[i].lane == LANE_CHARGED) {
            json_object(reply, NULL);
            json_count(reply, "begin", lanes->spans[i].begin);
            json_count(reply, "end", lanes->spans[i].end);
            json_text(reply, "cause",
                      c205_cause_name(lanes->spans[i].piece->cause));
            json_end(reply);
        }
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
    return good || refuse(error, "no memory");
}

/* As c205 timeline writes a file of this form. */
static bool put_file(const struct engine *engine, struct json *reply,
                     c205_error *error)
{
    const struct replay *replay = &engine->replay;
    struct text_buffer text = { .text = NULL };
    struct sink sink = text_buffer_sink(&text);
    char title[TIMELINE_TITLE];
    bool good;

    timeline_title(replay->timeline, engine->name,
                   c205_model_name(engine->model), title);
    good = timeline_write(replay->timeline, replay->form, title, &sink)
           && !text.failed;
    if (good)
        json_text(reply, "file", text.text);
    text_buffer_free(&text);
    return good || refuse(error, "no memory");
}

static bool put_timeline(struct engine *engine, struct json *reply,
                         c205_error *error)
{
    struct timeline *timeline = engine->replay.timeline;

    if (!timeline_is_good(timeline))
        return refuse(error, "no memory");
    timeline_settle(timeline);
    json_count(reply, "from", timeline->from);
    json_count(reply, "to", timeline->to);
    json_truth(reply, "full", timeline->full);
    return engine->replay.form ? put_file(engine, reply, error)
                               : put_spans(engine, reply, error);
}

static bool timeline_slice(struct engine *engine, struct json *reply,
                           c205_error *error)
{
    return slice(engine, reply, timeline_slice, put_timeline, error);
}

/* NULL: spans are wanted, no file. */
static bool take_form(const struct json_value *request,
                      const struct timeline_form **form, c205_error *error)
{
    const char *file = NULL;

    if (!take_text_or(request, "file", &file, error))
        return false;
    *form = file ? timeline_form_of(file) : NULL;
    return !file || *form
           || refuse(error, "\"file\" is a name with .svg, .kanata or "
                            ".json at its end");
}

/* Of all the run that is known, wherever the program stands. */
bool answer_timeline(struct engine *engine, const struct json_value *request,
                     struct json *reply, c205_error *error)
{
    struct timeline *timeline = &engine->timeline;
    uint64_t most = 2000;
    const struct timeline_form *form;

    if (!needs_program(engine, error) || !take_slice(engine, request, error))
        return false;
    *timeline = (struct timeline){ .to = UINT64_MAX };
    if (!take_count(request, "from", &timeline->from, error)
        || !take_count(request, "to", &timeline->to, error)
        || !take_count(request, "most", &most, error)
        || !take_form(request, &form, error))
        return false;
    if (timeline->from >= timeline->to)
        return refuse(error, "\"from\" is before \"to\"");
    timeline->most = most < TIMELINE_MOST ? (size_t)most : TIMELINE_MOST;
    if (!begin(engine, NULL, timeline, debugger_known(engine->debugger),
               error))
        return false;
    engine->replay.form = form;
    return timeline_slice(engine, reply, error);
}
