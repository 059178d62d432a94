/* debugger_session.h - runs command lines in a debugger and checks its output. */
#ifndef TESTS_DEBUGGER_SESSION_H
#define TESTS_DEBUGGER_SESSION_H

#include "asm/debug/debug_internal.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/prior_model.h"

struct debug_session {
    struct object *object; /* freed by session_end */
    struct debugger *debugger;
    struct text_buffer said; /* output of the last line */
};

void session_begin(struct debug_session *session, struct object *object,
                   const char *name);
void session_end(struct debug_session *session);
/* Runs a command line. It must not quit the debugger. */
void session_obey(struct debug_session *session, const char *line);
bool session_says(const struct debug_session *session, const char *part);

/* A command line, and a text that its output must contain, or must not contain if the
 * text begins with "!". */
struct line_said {
    const char *line, *said;
};
void session_check(struct debug_session *session, const struct line_said *lines,
                   size_t count);
/* Checks a session with the program test.s. Exactly `faults` lines must be rejected. */
void check_session(const char *text, const struct line_said *lines, size_t count,
                   size_t faults);

#endif
