/* dap_client.c - runs c205 debug --dap in a child and exchanges messages with it. */
#include "tests/unit/dap_client.h"
#include "tests/unit/unit.h"

#include <errno.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "asm/dap/message.h"

/* ---- The process --------------------------------------------------------------- */

enum { MAX_ARGUMENTS = 20, MAX_SECONDS = 60 };

static void become_adapter(int in, int out, const char *const *arguments)
{
    const char *folder = getenv("RT205_LIBDIR");
    char program[1000];
    const char *words[MAX_ARGUMENTS] = { program, "debug", "--dap" };
    for (size_t i = 0; arguments && arguments[i]; i++)
        words[3 + i] = arguments[i];
    snprintf(program, sizeof program, "%s/c205", folder ? folder : "build");
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    freopen("/dev/null", "w", stderr);
    execv(program, (char **)words);
    _exit(127);
}

/* Starts the adapter. An alarm signal ends a client that waits too long. */
void client_begin(struct dap_client *client, const char *const *arguments)
{
    int to[2], from[2];
    *client = (struct dap_client){ .process = 0 };
    signal(SIGPIPE, SIG_IGN);
    alarm(MAX_SECONDS);
    assert_int_equal(pipe(to), 0);
    assert_int_equal(pipe(from), 0);
    client->process = fork();
    assert_true(client->process >= 0);
    if (client->process == 0) {
        close(to[1]);
        close(from[0]);
        become_adapter(to[0], from[1], arguments);
    }
    close(to[0]);
    close(from[1]);
    client->to = to[1];
    client->from = from[0];
}

int client_end(struct dap_client *client)
{
    int status = 0;
    char rest[1000];
    close(client->to);
    while (read(client->from, rest, sizeof rest) > 0)
        continue;
    close(client->from);
    assert_int_equal(waitpid(client->process, &status, 0), client->process);
    assert_true(WIFEXITED(status));
    arena_free(&client->arena);
    text_buffer_free(&client->input);
    text_buffer_free(&client->output);
    free(client->events);
    return WEXITSTATUS(status);
}

/* ---- Sent messages ------------------------------------------------------------- */

void client_send(struct dap_client *client, const char *bytes, size_t length)
{
    while (length > 0) {
        ssize_t written = write(client->to, bytes, length);
        assert_true(written > 0);
        bytes += written;
        length -= (size_t)written;
    }
}

static void put(void *context, const char *text, size_t length)
{
    client_send(context, text, length);
}

/* Sequence numbers of requests are multiples of 3, unlike those of responses. */
void client_command(struct dap_client *client, const char *command, const char *format,
                    ...)
{
    SCOPED_VALUE(text_buffer) text = { 0 };
    struct sink sink = text_buffer_sink(&text), out = { put, client };
    char whole[4000] = "{}";
    va_list arguments;
    va_start(arguments, format);
    if (format)
        vsnprintf(whole, sizeof whole, format, arguments);
    va_end(arguments);
    client->sent += 3;
    sink_print(&sink,
               "{\"seq\": %u, \"type\": \"request\", \"command\": "
               "\"%s\", \"arguments\": ",
               client->sent, command);
    sink_put(&sink, whole);
    sink_put(&sink, "}");
    message_put(&text, &out);
}

/* ---- Notifications ------------------------------------------------------------- */

static void receive_more(struct dap_client *client)
{
    struct sink sink = text_buffer_sink(&client->input);
    char bytes[4096];
    ssize_t length = read(client->from, bytes, sizeof bytes);
    FAIL_IF(length <= 0, "the adapter has ended; of a message there is: %s",
            client->input.text ? client->input.text : "nothing");
    sink.put(sink.context, bytes, (size_t)length);
}

static struct dap_message next_message(struct dap_client *client)
{
    struct dap_message message;
    struct message_content content;
    for (;;) {
        enum message_state state = message_find(&client->input, &content, &failure);
        if (state == MESSAGE_WHOLE)
            break;
        FAIL_IF(state == MESSAGE_BROKEN, "%s: %s", failure.message, client->input.text);
        receive_more(client);
    }
    message.text = arena_text(&client->arena, client->input.text + content.begin,
                              content.length);
    message.value = json_read(&client->arena, message.text, content.length, &failure);
    FAIL_IF(!message.value, "%s: %s", failure.message, client->input.text);
    message_drop(&client->input, content.begin + content.length);
    assert_int_equal(the_whole(message.value, "seq"), ++client->heard);
    return message;
}

static void keep_event(struct dap_client *client, struct dap_message event)
{
    struct sink sink = text_buffer_sink(&client->output);
    if (strcmp(the_text(event.value, "event"), "output") == 0) {
        sink_put(&sink, the_text(the(event.value, "body"), "output"));
        return;
    }
    if (client->event_count == client->event_room) {
        client->event_room = 2 * client->event_room + 8;
        client->events = realloc(client->events,
                                 client->event_room * sizeof *client->events);
    }
    client->events[client->event_count++] = event;
}

const struct json_value *client_response(struct dap_client *client)
{
    for (;;) {
        struct dap_message message = next_message(client);
        if (strcmp(the_text(message.value, "type"), "response") == 0) {
            assert_int_equal(the_whole(message.value, "request_seq"), client->sent);
            client->text = message.text;
            return message.value;
        }
        assert_string_equal(the_text(message.value, "type"), "event");
        keep_event(client, message);
    }
}

const struct json_value *client_success(struct dap_client *client, const char *command)
{
    const struct json_value *response = client_response(client);
    assert_string_equal(the_text(response, "command"), command);
    FAIL_IF(!json_member_truth(response, "success", false), "%s: %s", command,
            the_text(response, "message"));
    return the(response, "body");
}

void client_failure(struct dap_client *client, const char *words, const char *command)
{
    const struct json_value *response = client_response(client);
    FAIL_IF(json_member_truth(response, "success", true)
                || !strstr(the_text(response, "message"), words),
            "%s: not refused with '%s', but %s", command, words,
            json_member_text(response, "message"));
}

const struct json_value *client_event(struct dap_client *client, const char *name)
{
    while (client->event_count == 0)
        keep_event(client, next_message(client));
    struct dap_message event = client->events[0];
    client->event_count--;
    memmove(client->events, client->events + 1,
            client->event_count * sizeof *client->events);
    client->text = event.text;
    assert_string_equal(the_text(event.value, "event"), name);
    return json_member(event.value, "body");
}

const struct json_value *client_stopped(struct dap_client *client, const char *reason)
{
    const struct json_value *body = client_event(client, "stopped");
    assert_string_equal(the_text(body, "reason"), reason);
    assert_int_equal(the_whole(body, "threadId"), 1);
    assert_true(json_member_truth(body, "allThreadsStopped", false));
    return body;
}

/* ---- Members -------------------------------------------------------------------- */

const struct json_value *the(const struct json_value *object, const char *key)
{
    const struct json_value *member = json_member(object, key);
    FAIL_IF(!member, "there is no '%s'", key);
    return member;
}

const char *the_text(const struct json_value *object, const char *key)
{
    const char *text = the(object, key)->text;
    FAIL_IF(!text, "'%s' is no text", key);
    return text;
}

int64_t the_whole(const struct json_value *object, const char *key)
{
    int64_t value = 0;
    the(object, key);
    FAIL_IF(!json_member_whole(object, key, &value), "'%s' is no integer", key);
    return value;
}

const struct json_value *element_with(const struct json_value *list, const char *key,
                                      const char *text)
{
    const struct json_value *item = list->first;
    while (item && strcmp(the_text(item, key), text) != 0)
        item = item->next;
    return item;
}

size_t length_of(const struct json_value *list)
{
    size_t length = 0;
    for (const struct json_value *item = list->first; item; item = item->next)
        length++;
    return length;
}
