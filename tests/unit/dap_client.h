/* dap_client.h - a client of c205 debug --dap, connected by two pipes.
 *
 * The client checks the order of messages. The sequence numbers of messages must
 * increase by 1, and a response must belong to the last request. A violation fails the
 * test.
 */
#ifndef TESTS_DAP_CLIENT_H
#define TESTS_DAP_CLIENT_H

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
    struct arena arena; /* owns all messages that were received */
    struct text_buffer input;
    unsigned sent, heard;
    const char *text; /* JSON text of the last response or event that the test has
                       * read */
    size_t event_count, event_room;
    struct dap_message *events; /* received events that the test has not read */
    struct text_buffer output;  /* concatenated text of all output events */
};

/* Starts the adapter. `arguments` follow --dap and end with NULL. */
void client_begin(struct dap_client *client, const char *const *arguments);
/* Reads the remaining messages and returns the exit status. */
int client_end(struct dap_client *client);

/* Sends bytes that need not be a message. */
void client_send(struct dap_client *client, const char *bytes, size_t length);
/* Sends a request. printf formats its arguments; NULL: no arguments. */
void client_command(struct dap_client *client, const char *command, const char *format,
                    ...) __attribute__((format(printf, 3, 4)));
/* Returns the response to the last request. Earlier events are queued. */
const struct json_value *client_response(struct dap_client *client);
/* Returns the body of the response to the last request, which must report success. */
const struct json_value *client_success(struct dap_client *client, const char *command);
/* Fails the test unless the last request fails with `words` in the message. */
void client_failure(struct dap_client *client, const char *words, const char *command);
/* client_ask sends a request that must succeed, client_refused one that must fail. */
#define client_ask(client, command, ...) \
    (client_command(client, command, __VA_ARGS__), client_success(client, command))
#define client_refused(client, words, command, ...) \
    (client_command(client, command, __VA_ARGS__), \
     client_failure(client, words, command))
/* Returns the body of the next event except output, which must have this name. */
const struct json_value *client_event(struct dap_client *client, const char *name);
/* Returns the body of the next event, which must be `stopped` with this reason. */
const struct json_value *client_stopped(struct dap_client *client, const char *reason);

/* Return a member of an object. If it is missing, the test fails. */
const struct json_value *the(const struct json_value *object, const char *key);
const char *the_text(const struct json_value *object, const char *key);
int64_t the_whole(const struct json_value *object, const char *key);
/* Returns the first element of a list whose member `key` has this text, or NULL. */
const struct json_value *element_with(const struct json_value *list, const char *key,
                                      const char *text);
size_t length_of(const struct json_value *list);

#endif
