/* dap_session.c - starts debug sessions over DAP and reads the program's state. */
#include "tests/unit/dap_session.h"

#include <unistd.h>

/* ---- A program ------------------------------------------------------------------- */

const char client_program[] = "        .include \"vectors.s\"\n"
                              "        .include \"print.s\"\n"
                              "        .regs   r16, a, b, turns, to, link, place\n"
                              "        words   a, 1.5, -2.0, 3.0, 4.0\n"
                              "        words   b, 1.0, 1.0, 1.0, 1.0\n"
                              "        ES      turns, 5\n"
                              "        EX      to, again\n"
                              "        .kernel loop\n"
                              "again:  ADDNV   [a], [a], [b]\n"
                              "        call    double, link, place\n"
                              "        DBNZ    turns, [to]\n"
                              "        .endkernel\n"
                              "        print_integer turns\n"
                              "        newline\n"
                              "        ES      place, 3\n"
                              "        EXIT    place, r0, 0\n"
                              "double: ADDNV   [b], [b], [b]\n"
                              "        return  link\n";
char client_path[200];

void client_write(const char *text)
{
    if (!*client_path)
        snprintf(client_path, sizeof client_path, "%s/dap.%d.s",
                 getenv("RT205_LIBDIR") ? getenv("RT205_LIBDIR") : "build",
                 (int)getpid());
    FILE *file = NON_NULL(fopen(client_path, "w"));
    fputs(text, file);
    fclose(file);
}

const char *client_file_name(void)
{
    return strrchr(client_path, '/') + 1;
}

const struct json_value *client_launch_file(struct dap_client *client, const char *more)
{
    client_begin(client, NULL);
    const struct json_value
        *capabilities = client_ask(client, "initialize",
                                   "{\"adapterID\": \"c205\", "
                                   "\"supportsInvalidatedEvent\": true}");
    client_ask(client, "launch", "{\"program\": \"%s\"%s}", client_path, more);
    client_event(client, "initialized");
    return capabilities;
}

const struct json_value *client_launch(struct dap_client *client, const char *text,
                                       const char *more)
{
    client_write(text);
    return client_launch_file(client, more);
}

void client_enter(struct dap_client *client, const char *text)
{
    client_launch(client, text, ", \"stopOnEntry\": true");
    client_ask(client, "configurationDone", NULL);
    client_stopped(client, "entry");
}

void client_leave(struct dap_client *client)
{
    client_ask(client, "disconnect", NULL);
    assert_int_equal(client_end(client), 0);
    unlink(client_path);
}

/* ---- Current position ------------------------------------------------------------ */

const struct json_value *client_frames(struct dap_client *client)
{
    return the(client_ask(client, "stackTrace", "{\"threadId\": 1}"), "stackFrames");
}

uint64_t client_pc(struct dap_client *client)
{
    return strtoull(the_text(client_frames(client)->first,
                             "instructionPointerReference"),
                    NULL, 16);
}

const struct json_value *client_variables(struct dap_client *client, const char *scope)
{
    const struct json_value *scopes = the(client_ask(client, "scopes",
                                                     "{\"frameId\": 1}"),
                                          "scopes");
    return the(client_ask(client, "variables", "{\"variablesReference\": %d}",
                          (int)the_whole(element_with(scopes, "name", scope),
                                         "variablesReference")),
               "variables");
}

const char *value_of(const struct json_value *list, const char *name)
{
    const struct json_value *variable = element_with(list, "name", name);
    FAIL_IF(!variable, "there is no variable %s", name);
    return the_text(variable, "value");
}

c205_word word_in(const char *value)
{
    const char *at = NON_NULL(strstr(value, "X'"));
    c205_word word = 0;
    for (at += 2; *at != '\''; at++)
        if (*at != ' ')
            word = word << 4 | (c205_word)(*at >= 'A' ? *at - 'A' + 10 : *at - '0');
    return word;
}

uint64_t client_step(struct dap_client *client)
{
    return strtoull(value_of(client_variables(client, "Time"), "step"), NULL, 10);
}

const char *client_print(struct dap_client *client, const char *expression)
{
    return the_text(client_ask(client, "evaluate",
                               "{\"expression\": \"%s\", \"context\": \"watch\"}",
                               expression),
                    "result");
}

/* ---- Execution ------------------------------------------------------------------- */

void client_stop_at(struct dap_client *client, const char *stop)
{
    const struct json_value *list =
        the(client_ask(client, "setBreakpoints",
                       "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                       client_path, stop),
            "breakpoints");
    FAIL_IF(list->first && !json_member_truth(list->first, "verified", false), "%s: %s",
            stop, the_text(list->first, "message"));
}

void client_go(struct dap_client *client, const char *request, const char *reason)
{
    client_ask(client, request, "{\"threadId\": 1}");
    client_stopped(client, reason);
}

void client_go_finely(struct dap_client *client, const char *request)
{
    client_ask(client, request, "{\"threadId\": 1, \"granularity\": \"instruction\"}");
    client_stopped(client, "step");
}

int reference_of(const struct json_value *list, const char *name)
{
    return (int)the_whole(element_with(list, "name", name), "variablesReference");
}

const struct json_value *client_inside(struct dap_client *client, int reference,
                                       const char *more)
{
    return the(client_ask(client, "variables", "{\"variablesReference\": %d%s}",
                          reference, more),
               "variables");
}

const struct json_value *client_disassembled(struct dap_client *client,
                                             uint64_t address, int from, int count)
{
    const struct json_value *list =
        the(client_ask(client, "disassemble",
                       "{\"memoryReference\": \"0x%llX\", \"instructionOffset\": "
                       "%d, \"instructionCount\": %d}",
                       (unsigned long long)address, from, count),
            "instructions");
    assert_int_equal(length_of(list), count);
    return list;
}
