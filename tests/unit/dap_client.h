/* dap_client.h - a client of c205 debug --dap, over two pipes.
 *
 * It counts what it hears: each message has the number behind that of the one before,
 * each response is to the request that was sent.  What goes wrong fails the test.
 */
#ifndef TESTS_DAP_CLIENT_H
#define TESTS_DAP_CLIENT_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "base/json_read.h"
#include "base/sink.h"

struct dap_message {
    const struct json_value *value;
    const char *text;
};

struct dap_client {
    pid_t process;
    int to, from;
    struct arena arena; /* of all that was heard */
    struct text_buffer input;
    unsigned sent, heard;
    const char *text; /* of the response or event that was taken last */
    size_t event_count, event_room;
    struct dap_message *events; /* that nobody has asked for yet */
    struct text_buffer output;  /* of all events output */
};

/* arguments: behind --dap, NULL at the end. */
void client_begin(struct dap_client *client, const char *const *arguments);
/* The exit status, after what it has to say no more. */
int client_end(struct dap_client *client);

/* Any bytes. */
void client_send(struct dap_client *client, const char *bytes, size_t length);
/* A request, its arguments printed; NULL: none. */
void client_request(struct dap_client *client, const char *command, const char *format,
                    va_list arguments);
void client_command(struct dap_client *client, const char *command, const char *format,
                    ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;
/* The response to what was told last; events before it are kept. */
const struct json_value *client_response(struct dap_client *client);
/* The body of a response that must be one of success. */
const struct json_value *client_ask(struct dap_client *client, const char *command,
                                    const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;
/* It must be refused, with these words in the message. */
void client_refused(struct dap_client *client, const char *words, const char *command,
                    const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 4, 5)))
#endif
    ;
/* The body of the next event, which must be this one; output does not count. */
const struct json_value *client_event(struct dap_client *client, const char *name);
/* The same of stopped, for this reason. */
const struct json_value *client_stopped(struct dap_client *client, const char *reason);

/* Members that must be there. */
const struct json_value *the(const struct json_value *object, const char *key);
const char *the_text(const struct json_value *object, const char *key);
int64_t the_whole(const struct json_value *object, const char *key);
/* The element of a list whose member key has this text; NULL: there is none. */
const struct json_value *element_with(const struct json_value *list, const char *key,
                                      const char *text);
size_t length_of(const struct json_value *list);

#endif
