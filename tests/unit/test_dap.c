/* test_dap.c - responses of c205 debug --dap to a client over pipes are compared with
 * the responses that the sessions of dap.txt expect. Its reactions to malformed
 * messages are compared with the rules of the protocol. A capability without a session,
 * or another response, fails here. */
#include "tests/unit/dap_session.h"
#include "tests/unit/prior_model.h"

#include <unistd.h>

enum { LINE = 400, TEXT = 4000 };

struct session {
    char name[LINE]; /* "": no session */
    unsigned line;   /* line of the script */
    char own[TEXT];
    const char *program; /* program of the session, or the default program */
    struct dap_client client;
    bool begun, refused; /* the last response reports failure */
    int reference;
};

static void wrong(const struct session *session, const char *text)
{
    fail_msg("dap.txt:%u (%s): not '%s', but %s", session->line, session->name, text,
             session->client.text ? session->client.text : "nothing");
}

/* Copies a text. Replaces $F, $N, $D, $T and $R by their values. */
static void replace(const struct session *session, const char *from, char to[TEXT])
{
    for (size_t used = 0; (to[used] = *from) != '\0'; from++) {
        char folder[TEXT] = "", number[20];
        const char *value = NULL;
        snprintf(number, sizeof number, "%d", session->reference);
        if (*from == '$')
            switch (from[1]) {
            case 'F': value = client_path; break;
            case 'N': value = client_file_name(); break;
            case 'D': value = getcwd(folder, sizeof folder); break;
            case 'T': value = "{\"threadId\": 1}"; break;
            case 'R': value = number; break;
            }
        if (value)
            used += (size_t)sprintf(to + used, "%s", value), from++;
        else
            used++;
    }
}

/* Ends the first word of a text. Returns a pointer to the rest. */
static char *next_word(char *text)
{
    char *end = text + strcspn(text, " ");
    return *end ? *end = '\0', end + 1 : end;
}

/* ---- Commands and checks --------------------------------------------------------- */

static void send(struct session *session, char *request)
{
    char *arguments = next_word(request);
    client_command(&session->client, request, *arguments ? "%s" : NULL, arguments);
}

static void do_request(struct session *session, char *request)
{
    send(session, request);
    session->refused = !json_member_truth(client_response(&session->client), "success",
                                          false);
}

static void begin(struct session *session, char *arguments)
{
    const char *words[20] = { NULL };
    client_write(session->program);
    for (size_t i = 0; *arguments; i++) {
        words[i] = arguments;
        arguments = next_word(arguments);
    }
    client_begin(&session->client, words);
    session->begun = true;
}

static void launch(struct session *session, char *more)
{
    client_launch(&session->client, session->program, more);
    session->begun = true;
}

static void enter(struct session *session, char *rest UNUSED)
{
    client_enter(&session->client, session->program);
    session->begun = true;
}

static void go(struct session *session, char *request)
{
    client_go(&session->client, request, next_word(request));
}

static void stop(struct session *session, char *request)
{
    char *place = next_word(request), *fault = strstr(place, " ! ");
    if (fault) {
        *fault = '\0';
        fault += strlen(" ! ");
    }
    const struct json_value *list =
        the(client_ask(&session->client, request,
                       "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                       client_path, place),
            "breakpoints");
    assert_int_equal(length_of(list), *place != '\0');
    if (*place
        && (json_member_truth(list->first, "verified", fault) == (fault != NULL)
            || (fault && !strstr(the_text(list->first, "message"), fault))))
        wrong(session, fault ? fault : "verified");
}

static void restart(struct session *session, char *rest UNUSED)
{
    client_ask(&session->client, "restart", NULL);
    client_stopped(&session->client, "entry");
}

static void check_text(struct session *session, const char *text)
{
    if (!session->client.text || !strstr(session->client.text, text))
        wrong(session, text);
}

/* Checks the response to the second to last request. */
static void check_late(struct session *session, char *text)
{
    session->client.sent -= 3;
    client_response(&session->client);
    session->client.sent += 3;
    check_text(session, text);
}

static void check_refused(struct session *session, char *text)
{
    if (!session->refused)
        wrong(session, text);
    session->refused = false;
    check_text(session, text);
}

static void check_event(struct session *session, char *event)
{
    char *text = next_word(event);
    client_event(&session->client, event);
    check_text(session, text);
}

static void take_reference(struct session *session, char *name)
{
    static const char key[] = "\"variablesReference\": ";
    const char *text = formatted("{\"name\": \"%s\", ", name);
    check_text(session, text);
    const char *at = NON_NULL(strstr(strstr(session->client.text, text), key));
    session->reference = atoi(at + strlen(key));
}

static void check_place(struct session *session, char *address)
{
    if (client_pc(&session->client) != strtoull(address, NULL, 16))
        wrong(session, address);
}

static void check_step(struct session *session, char *step)
{
    if (client_step(&session->client) != strtoull(step, NULL, 10))
        wrong(session, step);
}

static void check_value(struct session *session, char *value)
{
    char *text = NON_NULL(strstr(value, " = "));
    *text = '\0';
    client_print(&session->client, value);
    check_text(session, text + strlen(" = "));
}

/* A text that ends with \n must be the whole output. */
static void check_output(struct session *session, char *text)
{
    const char *printed = session->client.output.text;
    char *end;
    bool whole = false;
    while ((end = strstr(text, "\\n")) != NULL) {
        *end = '\n';
        memmove(end + 1, end + 2, strlen(end + 1));
        whole = true;
    }
    FAIL_IF(!printed || (whole ? strcmp(printed, text) != 0 : !strstr(printed, text)),
            "dap.txt:%u: not '%s', but '%s'", session->line, text, printed);
}

static const struct {
    const char *word;
    void (*play)(struct session *session, char *rest);
} steps[] = {
    { "begin", begin },     { "launch", launch },  { "restart", restart },
    { "enter", enter },     { ">", do_request },   { "!", check_refused },
    { ">>", send },         { "<<", check_late },  { "=", take_reference },
    { "go", go },           { "stop", stop },      { "print", check_value },
    { "*", check_event },   { "at", check_place }, { "out", check_output },
    { "step", check_step },
};

static void play_step(struct session *session, const char *step)
{
    char text[TEXT], *rest, first[TEXT];
    size_t i = 0;
    replace(session, step, text);
    strcpy(first, text);
    rest = text + (next_word(first) - first);
    while (i < COUNT(steps) && strcmp(steps[i].word, first) != 0)
        i++;
    if (session->refused && strcmp(first, "!") != 0)
        wrong(session, "a success");
    if (i < COUNT(steps))
        steps[i].play(session, rest);
    else
        check_text(session, text);
}

/* ---- The script ------------------------------------------------------------------ */

static void end_session(struct session *session)
{
    unsigned line = session->line;
    if (session->begun) {
        if (session->refused)
            wrong(session, "a success");
        client_leave(&session->client);
    }
    *session = (struct session){ .line = line, .program = client_program };
}

static void play_line(struct session *session, char *line)
{
    static const char between[] = " => ";
    line += strspn(line, " ");
    while (line) {
        char *next = strstr(line, between);
        if (next)
            *next = '\0';
        play_step(session, line);
        line = next ? next + strlen(between) : NULL;
    }
}

TEST(sessions)
{
    FILE *script = NON_NULL(fopen("tests/unit/dap.txt", "r"));
    struct session session = { .program = client_program };
    FREED_BY(client_leave) struct dap_client client;
    size_t tried = 0, promised = 0;
    char line[LINE];
    const struct json_value *capabilities = client_launch(&client, client_program, "");
    for (const struct json_value *item = capabilities->first; item; item = item->next)
        promised += item->kind == JSON_TRUTH && item->truth;
    while (fgets(line, sizeof line, script)) {
        session.line++;
        line[strcspn(line, "\n")] = '\0';
        if (*line == '@') {
            end_session(&session);
            strcpy(session.name, line + 2);
            if (strncmp(session.name, "supports", 8) == 0) {
                tried += json_member_truth(capabilities, session.name, false);
                enter(&session, NULL);
            }
        } else if (*line == '|') {
            session.program = strcat(strcat(session.own, line + 1), "\n");
        } else if (*line && *line != '#') {
            play_line(&session, line);
        }
    }
    end_session(&session);
    fclose(script);
    assert_int_equal(tried, promised);
}

/* A message that is not JSON is reported and ignored. After a malformed header the next
 * message cannot be found, so the session ends. */
TEST(broken)
{
    static const char *const broken[] = {
        "Hello\r\n\r\n",
        "Content-Length: x\r\n\r\n",
        "Content-Length: 99999999\r\n\r\n",
        "Content-Length: 5\n\n",
        "Content-Type: text\r\n\r\n",
        "Content-Length: \r\n\r\n",
        "Content-Length: 50\r\n\r\nhello",
    };
    static const char no_json[] = "Content-Length: 5\r\n\r\nhello";
    struct dap_client client;
    for (size_t i = 0; i < COUNT(broken); i++) {
        client_begin(&client, NULL);
        client_send(&client, broken[i], strlen(broken[i]));
        assert_int_equal(client_end(&client), 1);
    }
    client_begin(&client, NULL);
    client_send(&client, no_json, strlen(no_json));
    client_ask(&client, "initialize", NULL);
    assert_non_null(strstr(client.output.text, "expected a value at byte 0"));
    assert_int_equal(client_end(&client), 0);
}
