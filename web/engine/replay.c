/* replay.c - repeats the run from its start for the listeners of a profile or a
 * timeline, and answers the request `profile`. Changes of the state by the user are
 * repeated at the steps at which they were made.
 */
#include "web/engine/engine_internal.h"

/* ---- Replay --------------------------------------------------------------------- */

void replay_listen(void *context, const c205 *machine, const c205_event *event)
{
    struct engine *engine = context;
    if (engine->replay.profile)
        line_profile_listen(engine->replay.profile, machine, event);
    if (engine->replay.timeline)
        timeline_listen(engine->replay.timeline, machine, event);
    if (engine->replay.shares)
        cause_shares_add(engine->replay.shares, event);
}

static void fall_silent(struct replay *replay)
{
    line_profile_free(replay->profile);
    if (replay->timeline)
        timeline_free(replay->timeline);
    cause_shares_free(replay->shares);
    *replay = (struct replay){ .begun = false };
}

/* Goes to a step. If the program halted there, the step is executed again, so it halts
 * again. */
static enum execution_end stand_at(struct engine *engine, uint64_t step, bool halted)
{
    enum execution_end ended = execution_to_step(engine->debugger, step);
    if (halted && ended == EXECUTION_COMPLETE)
        ended = execution_steps(engine->debugger, 1);
    return ended;
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

bool replay_begin(struct engine *engine, struct line_profile *profile,
                  struct timeline *timeline, uint64_t end, c205_error *error)
{
    struct replay *replay = &engine->replay;
    if (!profile && !timeline)
        return error_set(error, "out of memory");
    replay->begun = true;
    replay->stands = debugger_step(engine->debugger);
    replay->halted = debugger_halt(engine->debugger);
    replay->end = end;
    engine->slice.ends_at = UINT64_MAX;
    if (execution_to_step(engine->debugger, 0) == EXECUTION_FAILED) {
        line_profile_free(profile);
        *replay = (struct replay){ .begun = false };
        return refuse_with_report(engine, error);
    }
    replay->profile = profile;
    replay->timeline = timeline;
    return true;
}

/* Returns true if the replay is complete. A timeline is complete when its last clock
 * has passed, or when it is full and no shares are requested. */
static bool has_recorded_all(const struct engine *engine)
{
    const struct timeline *timeline = engine->replay.timeline;
    return debugger_step(engine->debugger) >= engine->replay.end
           || (timeline
               && ((timeline->full && !engine->replay.shares)
                   || c205_clock(engine_machine(engine)) >= timeline->to));
}

/* Replays for a slice. Sets *done if the replay is complete. */
static bool continue_replay(struct engine *engine, bool *done, c205_error *error)
{
    enum { AT_ONCE = 512 };
    struct replay *replay = &engine->replay;
    enum execution_end ended = EXECUTION_COMPLETE;
    while (ended == EXECUTION_COMPLETE && !has_recorded_all(engine)) {
        uint64_t step = debugger_step(engine->debugger);
        uint64_t left = replay->end - step;
        ended = execution_to_step(engine->debugger,
                                  step + (left < AT_ONCE ? left : AT_ONCE));
        if (ended == EXECUTION_COMPLETE && !has_recorded_all(engine)
            && slice_is_over(engine))
            ended = EXECUTION_INTERRUPTED;
    }
    if (ended == EXECUTION_FAILED)
        return refuse_with_report(engine, error);
    *done = ended != EXECUTION_INTERRUPTED;
    if (*done && replay->halted && replay->end == replay->stands
        && debugger_step(engine->debugger) == replay->end)
        stand_at(engine, replay->stands, !debugger_halt(engine->debugger));
    return true;
}

bool replay_slice(struct engine *engine, struct json *reply, engine_slice *again,
                  engine_slice *put, c205_error *error)
{
    bool done = false, good = continue_replay(engine, &done, error);
    engine->goes_on = good && !done ? again : NULL;
    if (good)
        json_bool(reply, "done", done);
    if (good && !done)
        json_count(reply, "step", debugger_step(engine->debugger));
    if (good && done)
        good = put(engine, reply, error);
    if (!good || done)
        replay_drop(engine);
    return good;
}

/* ---- profile ------------------------------------------------------------- */

/* Writes the lines in the form of c205 run --profile --json. */
static bool put_profile(struct engine *engine, struct json *reply, c205_error *error)
{
    struct profile_view view = { engine->replay.in_order ? PROFILE_AS_WRITTEN
                                                         : PROFILE_HOTTEST,
                                 false };
    struct table *table = line_profile_table(engine->replay.profile, view, false);
    return put_table(table, "lines", reply, error);
}

static bool profile_slice(struct engine *engine, struct json *reply, c205_error *error)
{
    return replay_slice(engine, reply, profile_slice, put_profile, error);
}

bool answer_profile(struct engine *engine, const struct json_value *request,
                    struct json *reply, c205_error *error)
{
    struct replay *replay = &engine->replay;
    bool in_order = false;
    if (!take_slice(engine, request, error)
        || !take_truth(request, "in-order", &in_order, error)
        || !replay_begin(engine, line_profile_new(engine->object), NULL,
                         debugger_step(engine->debugger), error))
        return false;
    replay->in_order = in_order;
    return profile_slice(engine, reply, error);
}
