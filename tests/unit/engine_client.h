/* engine_client.h - an engine that is asked, and its replies read. */
#ifndef TESTS_ENGINE_CLIENT_H
#define TESTS_ENGINE_CLIENT_H

#include "base/json_read.h"
#include "tests/unit/asm_helper.h"
#include "web/engine/engine.h"

struct talk {
    struct engine *engine;
    struct arena arena;             /* of the last reply */
    char *text;                     /* .. as it came */
    const struct json_value *reply; /* .. read */
};

void talk_begin(struct talk *talk);
void talk_end(struct talk *talk);

/* Any bytes.  The reply is JSON, "ok" is true or false, and there is an error where it is
 * false. */
const struct json_value *talk_bytes(struct talk *talk, const char *request,
                                    size_t length);
/* Requests and parts of replies are written with ' for the quotes of JSON. */
void talk_quote(char *text);
/* One that can be answered; while it is not done there is more. */
const struct json_value *talk_ask(struct talk *talk, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* One that cannot, for a reason that has this in it. */
void talk_refused(struct talk *talk, const char *why, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* The last reply contains this. */
void talk_says(const struct talk *talk, const char *part);
/* more: further members, each behind a comma. */
const struct json_value *talk_load(struct talk *talk, const char *text,
                                   const char *more);

/* A member that is a number, or a text; one that is missing is a failure. */
double number_of(const struct json_value *object, const char *key);
const char *text_of(const struct json_value *object, const char *key);
size_t items_of(const struct json_value *list);

/* Members of requests: a model of its own; two programs against a constant. */
#define AND_PRIOR ", 'model': 'cyber205-2pipe-prior'"
#define SWEEP \
    "'constant': 'n', 'from': 1, 'to': 300, 'text': ' .include \\\"vectors.s\\\"\\n " \
    ".regs r16, a\\n .data\\nx: .space n\\n .code\\n descriptor a, x, n\\n ADDNV [a], " \
    "[a], [a]\\n EXIT\\n', 'other': ' ES r10, n\\n EX r11, on\\non: IS r12, 1\\n DBNZ " \
    "r10, [r11]\\n EXIT\\n'"

#endif
