/* test_debugger.c - the position of a debugger after random command lines is compared
 * with a plain run of the program. A missed stop or a step too many fails here. */
#include <inttypes.h>

#include "tests/unit/draw.h"
#include "tests/unit/debugger_session.h"
#include "tests/unit/plain_run.h"

enum { LINES = 300, ROUNDS = 4 };

static const char *const programs[] = { "asm/examples/dot.s", "asm/examples/horner.s",
                                        "asm/examples/lookup.s",
                                        "asm/examples/saxpy_scalar.s",
                                        "asm/examples/sieve.s" };
enum { PROGRAMS = COUNT(programs) };

/* ---- Expected values of a line -------------------------------------------- */

static bool begins_with_stop(const struct plain *plain,
                             const struct plain_stops *reported)
{
    uint64_t pc = plain->moments[0].pc;
    return (reported->by_place && pc == reported->place)
           || (reported->region
               && strcmp(plain_region(plain, pc), reported->region) == 0);
}

static size_t to_place(const struct plain *plain, const struct plain_stops *reported,
                       size_t step, uint64_t place)
{
    while (step < plain->end) {
        step++;
        if (plain->moments[step].pc == place || plain_stops_at(plain, reported, step))
            break;
    }
    return step;
}

/* ---- Random lines ------------------------------------------------------ */

struct session {
    const struct plain *plain;
    struct debug_session debug;
    struct plain_stops reported; /* breakpoints of the debugger */
    size_t step;
};

static void obey(struct session *session, const char *line)
{
    session_obey(&session->debug, line);
}

static void choose_place(struct session *session)
{
    session->reported.by_place = true;
    session->reported.place = session->plain->moments[below(session->plain->end)].pc;
    session->reported.every = 1 + below(below(2) ? 3 : 97);
    obey(session, "delete");
    session->reported.by_watch = false;
    session->reported.region = NULL;
    obey(session, formatted("break *%" PRIu64 " if $step %% %zu == 0",
                            session->reported.place, session->reported.every));
}

static void choose_region(struct session *session)
{
    const c205_program *program = &session->plain->object->program;
    if (session->reported.region || program->region_count == 0)
        return;
    session->reported.region = program->regions[below(program->region_count)].name;
    obey(session, formatted("break region %s", session->reported.region));
}

static void choose_watch(struct session *session)
{
    if (session->reported.by_watch)
        return;
    session->reported.by_watch = true;
    obey(session, formatted("watch *%" PRIu64, session->plain->watched));
}

/* Makes a random command line. Returns the step that the program must reach. */
static size_t draw_line(struct session *session, char line[80])
{
    const struct plain *plain = session->plain;
    const struct plain_stops *reported = &session->reported;
    size_t step = session->step;
    uint64_t number;
    switch (below(8)) {
    case 0:
        number = 1 + below(40);
        snprintf(line, 80, "step %" PRIu64, number);
        return plain_on(plain, reported, step, number);
    case 1:
        number = 1 + below(40);
        snprintf(line, 80, "reverse-step %" PRIu64, number);
        return step > number ? step - (size_t)number : 0;
    case 2: strcpy(line, "c"); return plain_on(plain, reported, step, UINT64_MAX);
    case 3: strcpy(line, "rc"); return plain_back(plain, reported, step);
    case 4:
        number = below(plain->end + 1);
        snprintf(line, 80, "goto %" PRIu64, number);
        return (size_t)number;
    case 5:
        number = below(plain->moments[plain->end].clock + 1);
        snprintf(line, 80, "goto clock %" PRIu64, number);
        return plain_to_clock(plain, step, number);
    case 6:
        strcpy(line, "run");
        return begins_with_stop(plain, reported)
                   ? 0
                   : plain_on(plain, reported, 0, UINT64_MAX);
    default:
        number = plain->moments[below(plain->end)].pc;
        snprintf(line, 80, "until *%" PRIu64, number);
        return to_place(plain, reported, step, number);
    }
}

static void check_place(const struct session *session, const char *line)
{
    const struct moment *expected = &session->plain->moments[session->step];
    struct moment found = moment_of(machine_of(session->debug.debugger),
                                    session->plain->watched);
    FAIL_IF(c205_history_step(session->debug.debugger->history) != session->step
                || memcmp(&found, expected, sizeof found) != 0,
            "'%s' (watch %d, place %d every %zu, region %s): step %" PRIu64
            ", not %zu, or another state; it said %s",
            line, session->reported.by_watch, session->reported.by_place,
            session->reported.every,
            session->reported.region ? session->reported.region : "none",
            c205_history_step(session->debug.debugger->history), session->step,
            session->debug.said.text);
}

static void end(struct session *session)
{
    session_end(&session->debug);
    free(session->plain->moments);
}

TEST(movements)
{
    for (size_t i = 0; i < ROUNDS * PROGRAMS; i++) {
        struct plain plain = run_plainly(good_file(programs[i % PROGRAMS]),
                                         &random_state);
        struct session session = { .plain = &plain };
        session_begin(&session.debug, plain.object, programs[i % PROGRAMS]);
        for (size_t k = 0; k < LINES; k++) {
            char line[80];
            if (below(20) == 0)
                choose_place(&session);
            if (below(20) == 0)
                choose_watch(&session);
            if (below(20) == 0)
                choose_region(&session);
            session.step = draw_line(&session, line);
            obey(&session, line);
            check_place(&session, line);
        }
        assert_int_equal(debugger_faults(session.debug.debugger), 0);
        end(&session);
    }
}

/* Sets one stop, and returns to it from each later step. */
TEST(far_back)
{
    enum { STOP = 150, FAR = 400 };
    struct plain plain = run_plainly(good_file("asm/examples/saxpy_scalar.s"),
                                     &random_state);
    struct session session = { .plain = &plain };
    char line[80];
    session_begin(&session.debug, plain.object, "saxpy_scalar.s");
    snprintf(line, sizeof line, "break *%" PRIu64 " if $step == %d",
             plain.moments[STOP].pc, STOP);
    obey(&session, line);
    for (session.step = STOP + 1; session.step < STOP + FAR; session.step++) {
        snprintf(line, sizeof line, "goto %zu", session.step);
        obey(&session, line);
        check_place(&session, line);
        obey(&session, "rc");
        assert_int_equal(c205_history_step(session.debug.debugger->history), STOP);
    }
    end(&session);
}
