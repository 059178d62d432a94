/* debugger_session.h - a debugger that is told lines, and what it says. */
#ifndef TESTS_DEBUGGER_SESSION_H
#define TESTS_DEBUGGER_SESSION_H

#include "asm/debug/debug_internal.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/prior_model.h"

struct debug_session {
    struct object *object; /* freed at the end */
    struct debugger *debugger;
    struct text_buffer said; /* to the last line */
};

void session_begin(struct debug_session *session, struct object *object,
                   const char *name);
void session_end(struct debug_session *session);
/* One that is not quit. */
void session_obey(struct debug_session *session, const char *line);
bool session_says(const struct debug_session *session, const char *part);

/* Lines, and a part of what must be said to each; with a ! before it, of what must not. */
struct line_said {
    const char *line, *said;
};
void session_check(struct debug_session *session, const struct line_said *lines,
                   size_t count);
/* All of a session with a program, test.s; so many lines cannot be done. */
void check_session(const char *text, const struct line_said *lines, size_t count,
                   size_t faults);

#endif
