/* engine_client.h - sends requests to an engine and parses its replies. */
#ifndef TESTS_ENGINE_CLIENT_H
#define TESTS_ENGINE_CLIENT_H

#include "base/json_read.h"
#include "tests/unit/asm_helper.h"
#include "web/engine/engine.h"

struct talk {
    struct engine *engine;
    struct arena arena;             /* owns the last reply */
    char *text;                     /* the last reply, unparsed */
    const struct json_value *reply; /* the last reply, parsed */
};

/* Starts a conversation. If the text is not NULL, loads it with talk_load. */
struct talk talk_with(const char *text, const char *more);
void talk_free(struct talk *talk);

/* Sends bytes that need not be a request. Fails the test unless the reply is JSON whose
 * "ok" is true or false. If it is false, the reply must have an "error". */
const struct json_value *talk_bytes(struct talk *talk, const char *request,
                                    size_t length);
/* Replaces each ' by ". Requests and replies are written with ' for JSON's quotes. */
void talk_quote(char *text);
/* Sends a request that printf formats. Returns its text. */
const char *talk_send(struct talk *talk, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
/* Check the reply to a request. talk_success: the request must succeed. talk_failure:
 * it must fail with `why` in the error. */
const struct json_value *talk_success(const struct talk *talk, const char *request);
void talk_failure(const struct talk *talk, const char *why, const char *request);
/* talk_ask sends a request that must succeed, talk_refused a request that must fail. */
#define talk_ask(talk, ...) talk_success(talk, talk_send(talk, __VA_ARGS__))
#define talk_refused(talk, why, ...) \
    talk_failure(talk, why, talk_send(talk, __VA_ARGS__))
/* Fails the test unless the last reply contains `part`. */
void talk_says(const struct talk *talk, const char *part);
/* Loads a program. `more`: further members of the request, each after a comma. */
const struct json_value *talk_load(struct talk *talk, const char *text,
                                   const char *more);

/* Return a member that is a number or a text. If it is missing, the test fails. */
double number_of(const struct json_value *object, const char *key);
const char *text_of(const struct json_value *object, const char *key);
size_t items_of(const struct json_value *list);

/* Members of requests: a model by its name; two programs and the constant of a
 * sweep. */
#define AND_PRIOR ", 'model': 'cyber205-2pipe-prior'"
#define SWEEP \
    "'constant': 'n', 'from': 1, 'to': 300, 'text': ' .include \\\"vectors.s\\\"\\n " \
    ".regs r16, a\\n .data\\nx: .space n\\n .code\\n descriptor a, x, n\\n ADDNV [a], " \
    "[a], [a]\\n EXIT\\n', 'other': ' ES r10, n\\n EX r11, on\\non: IS r12, 1\\n DBNZ " \
    "r10, [r11]\\n EXIT\\n'"

#endif
