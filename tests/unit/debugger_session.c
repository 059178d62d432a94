/* debugger_session.c - runs command lines in a debugger and checks its output. */
#include "tests/unit/debugger_session.h"

void session_begin(struct debug_session *session, struct object *object,
                   const char *name)
{
    struct debugger_setup setup = { .object = object,
                                    .name = name,
                                    .model = prior_model,
                                    .out = text_buffer_sink(&session->said),
                                    .clocks_most = 1000000000 };
    *session = (struct debug_session){ .object = object };
    session->debugger = NON_NULL(debugger_new(&setup, &failure));
}

void session_end(struct debug_session *session)
{
    text_buffer_free(&session->said);
    debugger_free(session->debugger);
    object_free(session->object);
}

void session_obey(struct debug_session *session, const char *line)
{
    text_buffer_free(&session->said);
    session->said = (struct text_buffer){ 0 };
    assert_true(debugger_obey(session->debugger, line));
}

bool session_says(const struct debug_session *session, const char *part)
{
    return strstr(session->said.text ? session->said.text : "", part);
}

void session_check(struct debug_session *session, const struct line_said *lines,
                   size_t count)
{
    for (size_t i = 0; i < count; i++) {
        bool absent = *lines[i].said == '!';
        session_obey(session, lines[i].line);
        FAIL_IF(session_says(session, lines[i].said + absent) == absent, "%s: %s",
                lines[i].line, session->said.text);
    }
}

void check_session(const char *text, const struct line_said *lines, size_t count,
                   size_t faults)
{
    FREED_BY(session_end) struct debug_session session;

    session_begin(&session, good(text), "test.s");
    session_check(&session, lines, count);
    assert_int_equal(debugger_faults(session.debugger), faults);
}
