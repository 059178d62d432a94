/* test_dap.c - c205 debug --dap, by a client over pipes: a whole session, what each
 * capability promises, motions by chance beside a plain run, and all that can be wrong.
 */
#include <unistd.h>

#include "asm/dap/message.h"
#include "asm/object.h"
#include "base/file.h"
#include "base/json.h"
#include "tests/random.h"
#include "tests/unit/dap_client.h"
#include "tests/unit/plain_run.h"

static uint64_t random_state = RANDOM_SEED;

static uint64_t below(uint64_t end)
{
    return xorshift(&random_state) % end;
}

/* ---- A program -------------------------------------------------------------------- */

static const char session_text[] =
    "        .include \"vectors.s\"\n"
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
/* Where instructions of it are, and steps. */
enum {
    AGAIN = 0x400120,
    CALL = 0x400160,
    BSAVE = 0x4001A0,
    DBNZ = 0x4001C0,
    DOUBLE = 0x400260,
    WORDS_A = 0x800000,
    WORDS_B = 0x800100,
    STEPS = 40
};

static char path[200];

static void write_program(const char *text)
{
    FILE *file;

    if (!*path)
        snprintf(path, sizeof path, "%s/dap.%d.s",
                 getenv("RT205_LIBDIR") ? getenv("RT205_LIBDIR") : "build",
                 (int)getpid());
    file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

/* The file's own name has no folder. */
static const char *base_name(void)
{
    return strrchr(path, '/') + 1;
}

/* To where breakpoints are set. */
static const struct json_value *launch_file(struct dap_client *client,
                                            const char *more)
{
    const struct json_value *capabilities;

    client_begin(client, NULL);
    capabilities = client_ask(client, "initialize",
                              "{\"adapterID\": \"c205\", "
                              "\"supportsInvalidatedEvent\": true}");
    client_ask(client, "launch", "{\"program\": \"%s\"%s}", path, more);
    client_event(client, "initialized");
    return capabilities;
}

static const struct json_value *launch(struct dap_client *client,
                                       const char *text, const char *more)
{
    write_program(text);
    return launch_file(client, more);
}

/* To its first instruction. */
static void enter(struct dap_client *client, const char *text)
{
    launch(client, text, ", \"stopOnEntry\": true");
    client_ask(client, "configurationDone", NULL);
    client_stopped(client, "entry");
}

static void leave(struct dap_client *client)
{
    client_ask(client, "disconnect", NULL);
    assert_int_equal(client_end(client), 0);
    unlink(path);
}

/* ---- Where it stands ---------------------------------------------------------------- */

static const struct json_value *frames(struct dap_client *client)
{
    return the(client_ask(client, "stackTrace", "{\"threadId\": 1}"),
               "stackFrames");
}

static uint64_t pc_now(struct dap_client *client)
{
    return strtoull(the_text(frames(client)->first,
                             "instructionPointerReference"),
                    NULL, 16);
}

static const struct json_value *variables(struct dap_client *client,
                                          const char *scope)
{
    const struct json_value *scopes = the(client_ask(client, "scopes",
                                                     "{\"frameId\": 1}"),
                                          "scopes");

    return the(client_ask(client, "variables", "{\"variablesReference\": %d}",
                          (int)the_whole(element_with(scopes, "name", scope),
                                         "variablesReference")),
               "variables");
}

static const char *value_of(const struct json_value *list, const char *name)
{
    const struct json_value *variable = element_with(list, "name", name);

    if (!variable)
        fail_msg("there is no variable %s", name);
    return the_text(variable, "value");
}

/* "2  X'FFD3 4000 0000 0000'  .." */
static c205_word word_in(const char *value)
{
    const char *at = strstr(value, "X'");
    c205_word word = 0;

    assert_non_null(at);
    for (at += 2; *at != '\''; at++)
        if (*at != ' ')
            word = word << 4
                   | (c205_word)(*at >= 'A' ? *at - 'A' + 10 : *at - '0');
    return word;
}

static uint64_t step_now(struct dap_client *client)
{
    return strtoull(value_of(variables(client, "Time"), "step"), NULL, 10);
}

static const char *print(struct dap_client *client, const char *expression)
{
    return the_text(client_ask(client, "evaluate",
                               "{\"expression\": \"%s\", \"context\": "
                               "\"watch\"}",
                               expression),
                    "result");
}

/* ---- A whole session ------------------------------------------------------------------ */

static void test_session(void **state)
{
    struct dap_client client;
    const struct json_value *body, *list;

    (void)state;
    launch(&client, session_text, "");
    body = client_ask(&client, "setBreakpoints",
                      "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": "
                      "[{\"line\": 8}, {\"line\": 99}]}",
                      path);
    list = the(body, "breakpoints");
    assert_int_equal(length_of(list), 2);
    assert_true(json_member_truth(list->first, "verified", false));
    assert_int_equal(the_whole(list->first, "line"), 9);
    assert_false(json_member_truth(list->first->next, "verified", true));
    client_ask(&client, "configurationDone", NULL);
    body = client_stopped(&client, "breakpoint");
    assert_int_equal(the(body, "hitBreakpointIds")->first->number,
                     the_whole(list->first, "id"));
    list = the(client_ask(&client, "threads", NULL), "threads");
    assert_int_equal(length_of(list), 1);
    assert_int_equal(the_whole(list->first, "id"), 1);

    list = frames(&client);
    assert_int_equal(length_of(list), 2);
    assert_string_equal(the_text(list->first, "name"), "again");
    assert_int_equal(the_whole(list->first, "line"), 9);
    assert_string_equal(the_text(the(list->first, "source"), "name"),
                        base_name());
    assert_string_equal(the_text(list->first->next, "name"), "loop");
    assert_int_equal(pc_now(&client), AGAIN);
    client_ask(&client, "stepIn", "{\"threadId\": 1}");
    client_stopped(&client, "step");
    list = frames(&client); /* in a macro of the library */
    assert_int_equal(length_of(list), 3);
    assert_string_equal(the_text(the(list->first, "source"), "name"),
                        "core.s");
    assert_string_equal(the_text(list->first->next, "name"),
                        "call    double, link, place");
    assert_int_equal(the_whole(list->first->next, "line"), 10);
    client_ask(&client, "setBreakpoints",
               "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": []}", path);
    client_ask(&client, "continue", "{\"threadId\": 1}");
    assert_int_equal(the_whole(client_event(&client, "exited"), "exitCode"),
                     3);
    client_event(&client, "terminated");
    assert_string_equal(client.output.text, "0\n");
    client_refused(&client, "has ended", "continue", "{\"threadId\": 1}");
    leave(&client);
}

/* ---- What is promised -------------------------------------------------------------------- */

static void ask_line_stop(struct dap_client *client, const char *stop)
{
    const struct json_value *list = the(
        client_ask(client, "setBreakpoints",
                   "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                   path, stop),
        "breakpoints");

    if (list->first && !json_member_truth(list->first, "verified", false))
        fail_msg("%s: %s", stop, the_text(list->first, "message"));
}

static void go(struct dap_client *client, const char *request,
               const char *reason)
{
    client_ask(client, request, "{\"threadId\": 1}");
    client_stopped(client, reason);
}

static void go_finely(struct dap_client *client, const char *request)
{
    client_ask(client, request,
               "{\"threadId\": 1, \"granularity\": \"instruction\"}");
    client_stopped(client, "step");
}

static void try_configuration_done(struct dap_client *client)
{
    client_refused(client, "once", "configurationDone", NULL);
}

static void try_function_breakpoints(struct dap_client *client)
{
    static const struct {
        const char *name;
        uint64_t pc;
    } names[] = { { "double", DOUBLE },
                  { "loop", AGAIN },
                  { "DBNZ", DBNZ },
                  { "insn BSAVE", BSAVE },
                  { "again + 64", CALL } };

    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        client_ask(client, "setFunctionBreakpoints",
                   "{\"breakpoints\": [{\"name\": \"%s\"}]}", names[i].name);
        go(client, "continue", "function breakpoint");
        assert_int_equal(pc_now(client), names[i].pc);
        client_ask(client, "restart", NULL);
        client_stopped(client, "entry");
    }
    client_ask(client, "setFunctionBreakpoints", "{\"breakpoints\": []}");
}

static void try_conditions(struct dap_client *client)
{
    ask_line_stop(client, "{\"line\": 9, \"condition\": \"turns == 2 && "
                          "[a.i] > 0\"}");
    go(client, "continue", "breakpoint");
    assert_int_equal(word_in(print(client, "turns")), 2);
    ask_line_stop(client, "");
}

static void try_hit_conditions(struct dap_client *client)
{
    static const struct {
        const char *wanted;
        c205_word turns[3]; /* at the stops, 0: there is no more */
    } tries[] = { { "3", { 3, 2, 1 } },
                  { "== 2", { 4, 0, 0 } },
                  { "% 2", { 4, 2, 0 } },
                  { "> 4", { 1, 0, 0 } } };

    for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
        char stop[80];

        snprintf(stop, sizeof stop, "{\"line\": 9, \"hitCondition\": \"%s\"}",
                 tries[i].wanted);
        ask_line_stop(client, stop);
        for (size_t k = 0; k < 3 && tries[i].turns[k]; k++) {
            go(client, "continue", "breakpoint");
            assert_int_equal(word_in(print(client, "turns")),
                             tries[i].turns[k]);
        }
        client_ask(client, "restart", NULL);
        client_stopped(client, "entry");
    }
    ask_line_stop(client, "{\"line\": 9}");
    go(client, "continue", "breakpoint");
    go(client, "continue", "breakpoint");
    go(client, "reverseContinue", "breakpoint");
    assert_non_null(strstr(
        the_text(client_ask(client, "evaluate",
                            "{\"expression\": \"info breaks\", \"context\": "
                            "\"repl\"}"),
                 "result"),
        "met 2 times"));
    client_event(client, "invalidated");
    ask_line_stop(client, "");
}

static void try_evaluate(struct dap_client *client)
{
    const struct json_value *body =
        client_ask(client, "evaluate",
                   "{\"expression\": \"2 + 3\", \"context\": \"hover\"}");

    assert_non_null(strstr(the_text(body, "result"), "5"));
    client_refused(client, "nothing is called 'nobody'", "evaluate",
                   "{\"expression\": \"nobody\", \"context\": \"hover\"}");
    body = client_ask(client, "evaluate",
                      "{\"expression\": \"info regions\", \"context\": "
                      "\"repl\"}");
    assert_non_null(strstr(the_text(body, "result"), "loop"));
    body = client_ask(client, "evaluate",
                      "{\"expression\": \"assert 0\", \"context\": "
                      "\"repl\"}");
    assert_non_null(strstr(the_text(body, "result"), "does not hold"));
    client_event(client, "invalidated");
    client_event(client, "invalidated");
    client_ask(client, "evaluate",
               "{\"expression\": \"until double\", \"context\": \"repl\"}");
    client_stopped(client, "goto");
    assert_int_equal(pc_now(client), DOUBLE);
}

static void try_clipboard(struct dap_client *client)
{
    const struct json_value *body =
        client_ask(client, "evaluate",
                   "{\"expression\": \"pc\", \"context\": \"clipboard\"}");

    assert_non_null(strstr(the_text(body, "result"), "400000"));
}

static void try_step_back(struct dap_client *client)
{
    ask_line_stop(client, "{\"line\": 9}");
    go(client, "continue", "breakpoint");
    go(client, "continue", "breakpoint");
    go(client, "reverseContinue", "breakpoint");
    assert_int_equal(step_now(client), 6);
    go(client, "stepBack", "step");
    assert_int_equal(step_now(client), 5);
    ask_line_stop(client, "");
    go(client, "reverseContinue", "entry");
    assert_int_equal(step_now(client), 0);
    go(client, "stepBack", "entry");
}

static void set_variable(struct dap_client *client, int reference,
                         const char *name, const char *value)
{
    client_ask(client, "setVariable",
               "{\"variablesReference\": %d, \"name\": \"%s\", \"value\": "
               "\"%s\"}",
               reference, name, value);
}

static int reference_of(const struct json_value *list, const char *name)
{
    return (int)the_whole(element_with(list, "name", name),
                          "variablesReference");
}

static const struct json_value *inside(struct dap_client *client,
                                       int reference, const char *more)
{
    return the(client_ask(client, "variables",
                          "{\"variablesReference\": %d%s}", reference, more),
               "variables");
}

static void try_set_variable(struct dap_client *client)
{
    const struct json_value *scopes, *list;
    int vector, halves, bits;

    go(client, "next", "step"); /* a is a descriptor then */
    scopes = the(client_ask(client, "scopes", "{\"frameId\": 1}"), "scopes");
    list = variables(client, "Vectors");
    vector = reference_of(list, "a");
    list = inside(client, vector, ", \"filter\": \"named\"");
    halves = reference_of(list, "half words");
    bits = reference_of(list, "bits");
    set_variable(client, reference_of(scopes, "Registers"), "turns", "7");
    assert_int_equal(word_in(print(client, "turns")), 7);
    set_variable(client, reference_of(scopes, "All registers"), "r18", "8");
    assert_int_equal(word_in(print(client, "turns")), 8);
    set_variable(client, vector, "[1]", "2.5");
    assert_true(word_in(print(client, "[a.i + 64]"))
                == c205_from_double(2.5));
    set_variable(client, halves, "[3]", "X'12345678'");
    assert_true((word_in(print(client, "[a.i + 64]")) & UINT32_MAX)
                == 0x12345678);
    set_variable(client, bits, "[3]", "1");
    assert_true(word_in(value_of(inside(client, vector, ""), "[0]")) >> 60
                & 1);
    client_refused(client, "no element", "setVariable",
                   "{\"variablesReference\": %d, \"name\": \"[4]\", "
                   "\"value\": \"1\"}",
                   vector);
    client_refused(client, "register 0", "setVariable",
                   "{\"variablesReference\": %d, \"name\": \"r0\", "
                   "\"value\": \"1\"}",
                   reference_of(scopes, "All registers"));
    client_refused(client, "cannot be changed", "setVariable",
                   "{\"variablesReference\": %d, \"name\": \"clock\", "
                   "\"value\": \"1\"}",
                   reference_of(scopes, "Time"));
}

static void try_set_expression(struct dap_client *client)
{
    const struct json_value
        *body = client_ask(client, "setExpression",
                           "{\"expression\": \"[%d]\", \"value\": \"2 * 3\"}",
                           WORDS_B);

    assert_int_equal(word_in(the_text(body, "value")), 6);
    assert_int_equal(word_in(print(client, "[b.words]")), 6);
    client_refused(client, "set REGISTER", "setExpression",
                   "{\"expression\": \"1 + 2\", \"value\": \"3\"}");
}

/* What was not executed has not been: turns stays 0, and the loop goes on below it. */
static void try_goto(struct dap_client *client)
{
    const struct json_value *target =
        the(client_ask(client, "gotoTargets",
                       "{\"source\": {\"path\": \"%s\"}, \"line\": 15}",
                       path),
            "targets");

    client_ask(client, "goto", "{\"threadId\": 1, \"targetId\": %d}",
               (int)the_whole(target->first, "id"));
    client_stopped(client, "goto");
    assert_int_equal(the_whole(frames(client)->first, "line"), 15);
    assert_int_equal(step_now(client), 0);
    client_refused(client, "no line of code", "goto",
                   "{\"threadId\": 1, \"targetId\": %d}", WORDS_A);
    client_ask(client, "continue", "{\"threadId\": 1}");
    assert_int_equal(the_whole(client_event(client, "exited"), "exitCode"),
                     3);
    client_event(client, "terminated");
}

static void try_restart(struct dap_client *client)
{
    client_ask(client, "continue", "{\"threadId\": 1}");
    client_event(client, "exited");
    client_event(client, "terminated");
    client_ask(client, "restart", NULL);
    client_stopped(client, "entry");
    assert_int_equal(step_now(client), 0);
    client_ask(client, "continue", "{\"threadId\": 1}");
    client_event(client, "exited");
    client_event(client, "terminated");
    assert_string_equal(client->output.text, "0\n0\n");
}

/* A trap: what was jumped over has not set the address. */
static void try_exception_info(struct dap_client *client)
{
    const struct json_value *body;

    client_refused(client, "no trap", "exceptionInfo", NULL);
    client_ask(
        client, "setExpression",
        "{\"expression\": \"r17\", \"value\": \"X'0004FFFF00000000'\"}");
    client_ask(client, "goto", "{\"threadId\": 1, \"targetId\": %d}", AGAIN);
    client_stopped(client, "goto");
    client_ask(
        client, "setExpression",
        "{\"expression\": \"r16\", \"value\": \"X'0004FFFF00000000'\"}");
    body = client_ask(client, "continue", "{\"threadId\": 1}");
    body = client_stopped(client, "exception");
    assert_non_null(strstr(the_text(body, "text"), "trap unmapped-address"));
    body = client_ask(client, "exceptionInfo", NULL);
    assert_string_equal(the_text(body, "exceptionId"), "unmapped-address");
    assert_non_null(strstr(the_text(body, "description"), "ADDNV"));
    client_ask(client, "setExceptionBreakpoints", "{\"filters\": []}");
    client_ask(client, "continue", "{\"threadId\": 1}");
    assert_int_equal(the_whole(client_event(client, "exited"), "exitCode"),
                     1);
    client_event(client, "terminated");
    assert_non_null(strstr(client->output.text, "trap unmapped-address"));
}

static void try_some_frames(struct dap_client *client)
{
    const struct json_value *body =
        client_ask(client, "stackTrace",
                   "{\"threadId\": 1, \"startFrame\": 1, \"levels\": 1}");

    assert_int_equal(the_whole(body, "totalFrames"), 2);
    assert_int_equal(length_of(the(body, "stackFrames")), 1);
    assert_int_equal(the_whole(the(body, "stackFrames")->first, "id"), 2);
}

/* The library's have no path: their text is asked for. */
static void try_sources(struct dap_client *client)
{
    const struct json_value *list = the(client_ask(client, "loadedSources",
                                                   NULL),
                                        "sources");
    const struct json_value *core = element_with(list, "name", "core.s");
    const char *text;

    assert_non_null(element_with(list, "name", base_name()));
    assert_null(json_member(core, "path"));
    text = the_text(client_ask(client, "source",
                               "{\"source\": {\"sourceReference\": %d}}",
                               (int)the_whole(core, "sourceReference")),
                    "content");
    assert_non_null(strstr(text, ".macro  descriptor"));
    text = the_text(client_ask(client, "source",
                               "{\"source\": {\"path\": \"%s\"}}", path),
                    "content");
    assert_string_equal(text, session_text);
    client_refused(client, "no such source", "source",
                   "{\"sourceReference\": 99}");
}

static void try_terminate(struct dap_client *client)
{
    client_ask(client, "terminate", NULL);
    client_event(client, "terminated");
    client_refused(client, "has ended", "continue", "{\"threadId\": 1}");
}

static const char *data_id(struct dap_client *client, const char *arguments)
{
    return the_text(client_ask(client, "dataBreakpointInfo", "%s", arguments),
                    "dataId");
}

static void try_data_breakpoints(struct dap_client *client)
{
    const struct json_value *body;
    char text[100];

    go(client, "next", "step");
    go(client, "next", "step");
    snprintf(text, sizeof text,
             "{\"variablesReference\": %d, \"name\": \"[2]\"}",
             reference_of(variables(client, "Vectors"), "b"));
    client_ask(client, "setDataBreakpoints",
               "{\"breakpoints\": [{\"dataId\": \"%s\", \"accessType\": "
               "\"write\"}]}",
               data_id(client, text));
    go(client, "continue", "data breakpoint");
    assert_int_equal(step_now(client), 7);
    go(client, "continue", "data breakpoint");
    go(client, "reverseContinue", "data breakpoint");
    assert_int_equal(step_now(client), 7);
    body = client_ask(client, "dataBreakpointInfo",
                      "{\"variablesReference\": %d, \"name\": \"turns\"}", 1);
    assert_null(json_member(body, "dataId"));
    client_ask(client, "setDataBreakpoints", "{\"breakpoints\": []}");
}

static void try_data_bytes(struct dap_client *client)
{
    client_ask(client, "setDataBreakpoints",
               "{\"breakpoints\": [{\"dataId\": \"%s\", \"condition\": "
               "\"turns < 4\"}]}",
               data_id(client, "{\"name\": \"b.words\", \"asAddress\": "
                               "true, \"bytes\": 32}"));
    go(client, "continue", "data breakpoint");
    assert_int_equal(word_in(print(client, "turns")), 3);
    client_ask(client, "setDataBreakpoints", "{\"breakpoints\": []}");
}

static void try_read_memory(struct dap_client *client)
{
    const struct json_value *body = client_ask(
        client, "readMemory",
        "{\"memoryReference\": \"0x%X\", \"offset\": 1, \"count\": 8}",
        WORDS_A);

    /* 1.5 is FFD2 6000 .., and FF of the next word ends it */
    assert_string_equal(the_text(body, "data"), "0mAAAAAAAP8=");
    assert_string_equal(the_text(body, "address"), "0x800008");
    body = client_ask(client, "readMemory",
                      "{\"memoryReference\": \"0\", \"count\": 8}");
    assert_int_equal(the_whole(body, "unreadableBytes"), 8);
    assert_string_equal(the_text(body, "data"), "");
}

static void try_write_memory(struct dap_client *client)
{
    const struct json_value *body;

    body = client_ask(client, "writeMemory",
                      "{\"memoryReference\": \"0x%X\", \"offset\": 7, "
                      "\"data\": \"qrs=\"}",
                      WORDS_A);
    assert_int_equal(the_whole(body, "bytesWritten"), 2);
    body = client_ask(client, "readMemory",
                      "{\"memoryReference\": \"0x%X\", \"offset\": 6, "
                      "\"count\": 4}",
                      WORDS_A);
    assert_string_equal(the_text(body, "data"), "AKq70g==");
    client_refused(client, "0 are in memory", "writeMemory",
                   "{\"memoryReference\": \"64\", \"data\": \"qrs=\"}");
    client_refused(client, "no base64", "writeMemory",
                   "{\"memoryReference\": \"0x800000\", \"data\": \"q\"}");
}

static const struct json_value *
disassembled(struct dap_client *client, uint64_t address, int from, int count)
{
    const struct json_value *list = the(
        client_ask(client, "disassemble",
                   "{\"memoryReference\": \"0x%llX\", \"instructionOffset\": "
                   "%d, \"instructionCount\": %d}",
                   (unsigned long long)address, from, count),
        "instructions");

    assert_int_equal(length_of(list), count);
    return list;
}

static void try_disassemble(struct dap_client *client)
{
    const struct json_value *list = disassembled(client, AGAIN, -2, 4);

    assert_string_equal(the_text(list->first, "instruction"), "ES r18, 5");
    list = disassembled(client, AGAIN, 0, 1);
    assert_string_equal(the_text(list->first, "instruction"),
                        "ADDNV [r16], [r16], [r17]");
    assert_string_equal(the_text(list->first, "symbol"), "again");
    assert_int_equal(the_whole(list->first, "line"), 9);
    list = disassembled(client, 0, -5, 3);
    assert_string_equal(the_text(list->first, "presentationHint"), "invalid");
}

static void try_locations(struct dap_client *client)
{
    const struct json_value *list =
        the(client_ask(client, "breakpointLocations",
                       "{\"source\": {\"path\": \"%s\"}, \"line\": 1, "
                       "\"endLine\": 12}",
                       path),
            "breakpoints");
    static const int lines[] = { 4, 5, 6, 7, 9, 10, 11 };
    const struct json_value *item = list->first;

    for (size_t i = 0; i < sizeof lines / sizeof *lines;
         i++, item = item->next) {
        assert_non_null(item);
        assert_int_equal(the_whole(item, "line"), lines[i]);
    }
    assert_null(item);
}

/* A macro call is one line, and so is a call; of instructions it is three. */
static void try_granularity(struct dap_client *client)
{
    go(client, "next", "step");
    assert_int_equal(step_now(client), 2);
    go(client, "stepBack", "step");
    assert_int_equal(step_now(client), 0);
    go_finely(client, "next");
    go_finely(client, "next");
    assert_int_equal(step_now(client), 2);
    go_finely(client, "stepBack");
    assert_int_equal(step_now(client), 1);
    go(client, "stepOut", "step");
    assert_int_equal(step_now(client), 2);
    ask_line_stop(client, "{\"line\": 10}");
    go(client, "continue", "breakpoint");
    go(client, "next", "step");
    assert_int_equal(pc_now(client), DBNZ);
    go(client, "stepBack", "step");
    ask_line_stop(client, "");
    while (pc_now(client) != DBNZ)
        go(client, "stepIn", "step");
    go(client, "stepOut", "step"); /* of the region, by the routine */
    assert_int_equal(pc_now(client), DOUBLE);
    client_refused(client, "neither", "stepOut", "{\"threadId\": 1}");
}

static void try_instruction_breakpoints(struct dap_client *client)
{
    client_ask(client, "setInstructionBreakpoints",
               "{\"breakpoints\": [{\"instructionReference\": \"0x%X\", "
               "\"offset\": 8}]}",
               AGAIN);
    go(client, "continue", "instruction breakpoint");
    assert_int_equal(pc_now(client), CALL);
    client_ask(client, "setInstructionBreakpoints", "{\"breakpoints\": []}");
}

static const struct {
    const char *name;
    void (*attempt)(
        struct dap_client *client); /* from the first instruction */
} promises[] = {
    { "supportsConfigurationDoneRequest", try_configuration_done },
    { "supportsFunctionBreakpoints", try_function_breakpoints },
    { "supportsConditionalBreakpoints", try_conditions },
    { "supportsHitConditionalBreakpoints", try_hit_conditions },
    { "supportsEvaluateForHovers", try_evaluate },
    { "supportsStepBack", try_step_back },
    { "supportsSetVariable", try_set_variable },
    { "supportsSetExpression", try_set_expression },
    { "supportsGotoTargetsRequest", try_goto },
    { "supportsRestartRequest", try_restart },
    { "supportsExceptionInfoRequest", try_exception_info },
    { "supportsDelayedStackTraceLoading", try_some_frames },
    { "supportsLoadedSourcesRequest", try_sources },
    { "supportsTerminateRequest", try_terminate },
    { "supportsDataBreakpoints", try_data_breakpoints },
    { "supportsDataBreakpointBytes", try_data_bytes },
    { "supportsReadMemoryRequest", try_read_memory },
    { "supportsWriteMemoryRequest", try_write_memory },
    { "supportsDisassembleRequest", try_disassemble },
    { "supportsBreakpointLocationsRequest", try_locations },
    { "supportsClipboardContext", try_clipboard },
    { "supportsSteppingGranularity", try_granularity },
    { "supportsInstructionBreakpoints", try_instruction_breakpoints },
};
enum { PROMISES = sizeof promises / sizeof *promises };

/* Each is tried, and what is not promised is not tried. */
static void test_promises(void **state)
{
    struct dap_client client;
    const struct json_value *capabilities = launch(&client, session_text, "");
    size_t promised = 0;

    (void)state;
    for (const struct json_value *item = capabilities->first; item;
         item = item->next)
        promised += item->kind == JSON_TRUTH && item->truth;
    assert_int_equal(promised, PROMISES);
    for (size_t i = 0; i < PROMISES; i++)
        if (!json_member_truth(capabilities, promises[i].name, false))
            fail_msg("%s is not promised", promises[i].name);
    leave(&client);
    for (size_t i = 0; i < PROMISES; i++) {
        enter(&client, session_text);
        promises[i].attempt(&client);
        leave(&client);
    }
}

/* ---- What is shown ------------------------------------------------------------------------ */

/* A file is the same, whatever the way to it is called. */
static void test_paths(void **state)
{
    static const char *const ways[] = { "asm/examples/", "./asm/examples/",
                                        "asm/../asm/examples/" };
    struct dap_client client;
    const struct json_value *stop = NULL;
    char folder[1200];

    (void)state;
    assert_non_null(getcwd(folder, 1000));
    client_begin(&client, NULL);
    client_ask(&client, "initialize", NULL);
    client_ask(&client, "launch",
               "{\"program\": \"asm/examples/saxpy_linked.s\"}");
    client_event(&client, "initialized");
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        stop = the(client_ask(&client, "setBreakpoints",
                              "{\"source\": {\"path\": "
                              "\"%s/%ssaxpy_linked.s\"}, \"breakpoints\": "
                              "[{\"line\": 18}]}",
                              folder, ways[i]),
                   "breakpoints")
                   ->first;
        assert_true(json_member_truth(stop, "verified", false));
    }
    client_ask(&client, "configurationDone", NULL);
    stop = client_stopped(&client, "breakpoint");
    assert_int_equal(length_of(the(stop, "hitBreakpointIds")), 1);
    strcat(folder, "/asm/examples/saxpy_linked.s");
    assert_string_equal(the_text(the(frames(&client)->first, "source"),
                                 "path"),
                        folder);
    client_ask(&client, "disconnect", NULL);
    assert_int_equal(client_end(&client), 0);
}

/* A stop in a macro of the library is one in each call. */
static void test_library_lines(void **state)
{
    struct dap_client client;
    const struct json_value *core;

    (void)state;
    enter(&client, session_text);
    core = element_with(the(client_ask(&client, "loadedSources", NULL),
                            "sources"),
                        "name", "core.s");
    client_ask(&client, "setBreakpoints",
               "{\"source\": {\"name\": \"core.s\", \"sourceReference\": "
               "%d}, \"breakpoints\": [{\"line\": 11}]}",
               (int)the_whole(core, "sourceReference"));
    go(&client, "continue", "breakpoint");
    assert_int_equal(step_now(&client), 1);
    go(&client, "continue", "breakpoint");
    assert_int_equal(step_now(&client), 3);
    leave(&client);
}

static const char masked_text[] = "        .include \"vectors.s\"\n"
                                  "        .regs   r16, a, b, mask\n"
                                  "        words   a, 1.5, -2.0, 3.0, 4.0\n"
                                  "        words   b\n"
                                  "        bits    mask, \"1010\"\n"
                                  "        ADDNV   [a], [a], [b] ? [mask]\n"
                                  "        EXIT\n";

static void test_elements(void **state)
{
    static const char *const values[] = { "1.5  X'FFD2 6000 0000 0000'  ? 1",
                                          "-2  X'FFD2 8000 0000 0000'  ? 0",
                                          "3  X'FFD3 6000 0000 0000'  ? 1",
                                          "4  X'FFD4 4000 0000 0000'  ? 0" };
    struct dap_client client;
    const struct json_value *list, *item;
    int reference;

    (void)state;
    enter(&client, masked_text);
    ask_line_stop(&client, "{\"line\": 6}");
    go(&client, "continue", "breakpoint");
    list = variables(&client, "Operands");
    item = element_with(list, "name", "ADDNV [a]");
    assert_string_equal(the_text(item, "value"), "4 words from 800000 on");
    assert_int_equal(the_whole(item, "indexedVariables"), 4);
    reference = (int)the_whole(item, "variablesReference");
    for (int start = 0; start < 4; start++)
        for (int count = 0; count < 6; count++) {
            char range[80];
            int i = start;

            snprintf(range, sizeof range,
                     ", \"filter\": \"indexed\", \"start\": %d, \"count\": "
                     "%d",
                     start, count);
            item = inside(&client, reference, range)->first;
            for (; item; item = item->next, i++)
                assert_string_equal(the_text(item, "value"), values[i]);
            assert_int_equal(i, count == 0 || start + count > 4
                                    ? 4
                                    : start + count);
        }
    assert_string_equal(value_of(list, "ADDNV [mask]"),
                        "bits from 800200 on");
    item = element_with(variables(&client, "Registers"), "name", "mask");
    item = inside(&client, (int)the_whole(item, "variablesReference"), "");
    assert_int_equal(length_of(item), 2 + 4); /* it could be words, too */
    leave(&client);
}

/* The time is the machine's own accounts, after every step. */
static void check_accounts(struct dap_client *client, const c205 *machine)
{
    const struct json_value *time = variables(client, "Time");
    uint64_t sum = 0;

    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        const char *name = *account->name ? account->name : "outside regions";
        const struct json_value *list = inside(client,
                                               reference_of(time, name), "");

        for (int cause = 0; cause < C205_CAUSES; cause++) {
            uint64_t clocks = strtoull(value_of(list, c205_cause_name(
                                                          (c205_cause)cause)),
                                       NULL, 10);

            assert_int_equal(clocks, account->clocks[cause]);
            sum += clocks;
        }
        assert_int_equal(strtoull(value_of(list, "elements"), NULL, 10),
                         account->elements);
    }
    assert_int_equal(strtoull(value_of(time, "clock"), NULL, 10), sum);
}

static void test_time(void **state)
{
    struct dap_client client;
    struct object *object = good(session_text);
    c205_error error;
    c205 *machine = c205_new(prior_model, &error);
    c205_stop stop;

    (void)state;
    assert_true(c205_load(machine, &object->program, &error));
    launch(&client, session_text,
           ", \"stopOnEntry\": true, \"stopOnEnd\": "
           "true, \"model\": \"cyber205-2pipe-prior\"");
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "entry");
    check_accounts(&client, machine);
    while (c205_step(machine, &stop)) {
        go_finely(&client, "stepIn");
        check_accounts(&client, machine);
    }
    leave(&client);
    c205_free(machine);
    object_free(object);
}

/* ---- Motions by chance --------------------------------------------------------------------- */

/* Loops with vectors, calls and what is stored among them. */
static void draw_program(struct text_buffer *text)
{
    static const char *const lines[] = {
        "        ADDNV   [a], [b], [c]\n",
        "        MPYSV   [b], [a], [b]\n",
        "        SUBNV   [c], [a], [a]\n",
        "        ADDX    one, count, count\n",
        "        STO     [data, one], count\n",
        "        LOD     [data, one], other\n",
        "        call    routine, link, place\n",
        "        ADDN    other, count, other\n",
        "        load_constant other, 1.5\n",
    };
    struct sink sink = text_buffer_sink(text);
    size_t loops = 1 + below(3);

    *text = (struct text_buffer){ .text = NULL };
    sink_put(&sink, "        .include \"vectors.s\"\n"
                    "        .regs r16, a, b, c, one, count, data, other\n"
                    "        .regs r24, turns, link, place, to\n"
                    "        words a, 1.5, -2.0, 3.0, 4.0\n"
                    "        words b, 0.5, 0.25\n"
                    "        words c\n"
                    "        ES one, 1\n"
                    "        EX data, c.words\n");
    for (size_t i = 0; i < loops; i++) {
        sink_print(&sink, "        ES turns, %u\n        EX to, loop%zu\n",
                   (unsigned)(1 + below(40)), i);
        sink_print(&sink, "        .kernel k%zu\nloop%zu:\n", i, i);
        for (size_t k = 1 + below(8); k > 0; k--)
            sink_put(&sink, lines[below(sizeof lines / sizeof *lines)]);
        sink_put(&sink, "        DBNZ turns, [to]\n        .endkernel\n");
    }
    sink_put(&sink, "        EXIT\n"
                    "routine: ADDX count, one, count\n"
                    "        return link\n");
}

struct walk {
    struct dap_client client;
    struct plain plain;
    size_t step;
    bool has_place, by_watch;
    uint64_t place;
};

static void check_moment(struct walk *walk, const char *request)
{
    const struct moment *moment = &walk->plain.moments[walk->step];
    const struct json_value *item, *time = variables(&walk->client, "Time");
    char watched[40];
    size_t i = 0;

    if (strtoull(value_of(time, "step"), NULL, 10) != walk->step
        || strtoull(value_of(time, "clock"), NULL, 10) != moment->clock
        || pc_now(&walk->client) != moment->pc)
        fail_msg("%s: step %s at clock %s, not %zu at %llu", request,
                 value_of(time, "step"), value_of(time, "clock"), walk->step,
                 (unsigned long long)moment->clock);
    item = variables(&walk->client, "All registers")->first;
    for (; item; item = item->next, i++)
        assert_true(word_in(the_text(item, "value")) == moment->registers[i]);
    assert_int_equal(i, C205_REGISTERS);
    snprintf(watched, sizeof watched, "[%llu]",
             (unsigned long long)walk->plain.watched);
    assert_true(word_in(print(&walk->client, watched)) == moment->watched);
}

static bool is_stop(const struct walk *walk, size_t step)
{
    const struct moment *now = &walk->plain.moments[step];

    return step > 0 && step < walk->plain.end
           && ((walk->has_place && now->pc == walk->place)
               || (walk->by_watch && now->watched != now[-1].watched));
}

static void choose_stops(struct walk *walk)
{
    walk->place = walk->plain.moments[below(walk->plain.end)].pc;
    walk->has_place = below(3) > 0;
    walk->by_watch = below(2);
    client_ask(&walk->client, "setInstructionBreakpoints",
               walk->has_place ? "{\"breakpoints\": "
                                 "[{\"instructionReference\": \"0x%llX\"}]}"
                               : "{\"breakpoints\": []}",
               (unsigned long long)walk->place);
    client_ask(&walk->client, "setDataBreakpoints",
               walk->by_watch ? "{\"breakpoints\": [{\"dataId\": "
                                "\"0x%llX, 1\"}]}"
                              : "{\"breakpoints\": []}",
               (unsigned long long)walk->plain.watched);
}

/* Why a motion ends where it does; of two stops the one that was set first is told. */
static const char *reason_for(const struct walk *walk, const char *request,
                              size_t from)
{
    bool steps_back = strcmp(request, "stepBack") == 0;

    if (walk->step == walk->plain.end)
        return "end";
    if (walk->step == 0)
        return steps_back && from > 0 ? "step" : "entry";
    if (steps_back || !is_stop(walk, walk->step))
        return "step";
    return walk->has_place
                   && walk->plain.moments[walk->step].pc == walk->place
               ? "instruction breakpoint"
               : "data breakpoint";
}

static void move_to(struct walk *walk, const char *request, size_t step)
{
    size_t from = walk->step;

    walk->step = step;
    client_ask(&walk->client, request,
               "{\"threadId\": 1, \"granularity\": \"instruction\"}");
    client_stopped(&walk->client, reason_for(walk, request, from));
    check_moment(walk, request);
}

/* Behind its end there is no way on. */
static void move(struct walk *walk)
{
    size_t step = walk->step, end = walk->plain.end;

    switch (step == end ? 2 + below(2) : below(5)) {
    case 0:
        do
            step++;
        while (step < end && !is_stop(walk, step));
        move_to(walk, "continue", step);
        break;
    case 1:
    case 4: move_to(walk, "stepIn", step + 1); break;
    case 2: move_to(walk, "stepBack", step > 0 ? step - 1 : 0); break;
    default:
        while (step > 0 && !is_stop(walk, --step))
            continue;
        move_to(walk, "reverseContinue", step);
    }
}

/* The instructions before a place are those that come to it from the beginning. */
static void check_disassembly(struct walk *walk)
{
    enum { MOST = 60 };
    const struct json_value *all = disassembled(&walk->client, 0x400000, 0,
                                                MOST);
    int here = (int)below(MOST), before = (int)below((uint64_t)here + 1);
    const struct json_value *item = all->first, *from = all->first, *part;

    for (int i = 0; i < here; i++)
        item = item->next;
    for (int i = 0; i < here - before; i++)
        from = from->next;
    part = disassembled(&walk->client,
                        strtoull(the_text(item, "address"), NULL, 16),
                        -before, before + 1)
               ->first;
    for (; part; part = part->next, from = from->next)
        assert_string_equal(the_text(part, "address"),
                            the_text(from, "address"));
}

static void test_motions(void **state)
{
    enum { ROUNDS = 12, MOVES = 60 };

    (void)state;
    for (size_t i = 0; i < ROUNDS; i++) {
        struct walk walk = { .step = 0 };
        struct text_buffer text;

        draw_program(&text);
        walk.plain = run_plainly(good(text.text), &random_state);
        launch(&walk.client, text.text,
               ", \"stopOnEntry\": true, \"stopOnEnd\": true, "
               "\"model\": \"cyber205-2pipe-prior\"");
        client_ask(&walk.client, "configurationDone", NULL);
        client_stopped(&walk.client, "entry");
        for (size_t k = 0; k < MOVES; k++) {
            if (below(8) == 0)
                choose_stops(&walk);
            move(&walk);
        }
        check_disassembly(&walk);
        leave(&walk.client);
        object_free(walk.plain.object);
        free(walk.plain.moments);
        text_buffer_free(&text);
    }
}

/* Of an object the lines are not known: its instructions are read from the beginning. */
static void test_objects(void **state)
{
    enum { ROUNDS = 6 };

    (void)state;
    write_program("");
    for (size_t i = 0; i < ROUNDS; i++) {
        struct walk walk = { .step = 0 };
        struct text_buffer text;
        struct object *object;
        c205_error error;

        draw_program(&text);
        object = good(text.text);
        assert_true(object_save(object, path, &error));
        launch_file(&walk.client, ", \"stopOnEntry\": true");
        client_ask(&walk.client, "configurationDone", NULL);
        client_stopped(&walk.client, "entry");
        assert_null(json_member(frames(&walk.client)->first, "source"));
        for (size_t k = 0; k < 20; k++)
            check_disassembly(&walk);
        leave(&walk.client);
        object_free(object);
        text_buffer_free(&text);
    }
}

/* ---- While it runs ----------------------------------------------------------------------------- */

static const char endless[] = "        EX r10, again\n"
                              "again:  IBNZ r11, [r10]\n"
                              "        EX r11, 1\n"
                              "        EXIT\n";

static void test_running(void **state)
{
    struct dap_client client;

    (void)state;
    launch(&client, endless, "");
    client_ask(&client, "configurationDone", NULL);
    client_ask(&client, "threads", NULL);
    client_refused(&client, "pause it", "stackTrace", "{\"threadId\": 1}");
    client_refused(&client, "pause it", "continue", "{\"threadId\": 1}");
    client_ask(&client, "pause", "{\"threadId\": 1}");
    client_stopped(&client, "pause");
    assert_int_equal(pc_now(&client), 0x400040);
    client_ask(&client, "continue", "{\"threadId\": 1}");
    client_ask(
        &client, "setBreakpoints",
        "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [{\"line\": "
        "2}]}",
        path);
    client_stopped(&client, "breakpoint");
    client_ask(&client, "setBreakpoints",
               "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": []}", path);
    client_ask(&client, "reverseContinue", "{\"threadId\": 1}");
    client_stopped(&client, "entry");
    client_ask(&client, "continue", "{\"threadId\": 1}");
    client_ask(&client, "restart", NULL);
    client_ask(&client, "pause", "{\"threadId\": 1}");
    client_stopped(&client, "pause");
    assert_true(step_now(&client) > 0);
    leave(&client);
}

/* A line for the debugger that does not end: others are heard meanwhile. */
static void test_running_line(void **state)
{
    struct dap_client client;

    (void)state;
    launch(&client, endless, ", \"stopOnEntry\": true");
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "entry");
    client_tell(&client, "evaluate",
                "{\"expression\": \"c\", \"context\": \"repl\"}");
    client_ask(&client, "pause", "{\"threadId\": 1}");
    client.sent -= 3;
    assert_non_null(
        strstr(the_text(the(client_response(&client), "body"), "result"),
               "interrupted"));
    client.sent += 3;
    client_stopped(&client, "goto");
    client_ask(&client, "continue", "{\"threadId\": 1}");
    client_ask(&client, "terminate", NULL);
    client_event(&client, "terminated");
    client_ask(&client, "restart", NULL);
    client_stopped(&client, "entry");
    client_ask(&client, "continue", "{\"threadId\": 1}");
    leave(&client);
}

/* ---- What is wrong -------------------------------------------------------------------------------- */

static void test_wrong_order(void **state)
{
    struct dap_client client;

    (void)state;
    client_begin(&client, NULL);
    client_refused(&client, "initialize comes first", "launch", NULL);
    client_refused(&client, "there is no request 'attach'", "attach", NULL);
    client_refused(&client, "of the format 'uri'", "initialize",
                   "{\"pathFormat\": \"uri\"}");
    client_ask(&client, "initialize",
               "{\"linesStartAt1\": false, \"columnsStartAt1\": false}");
    client_refused(&client, "launch comes first", "threads", NULL);
    client_refused(&client, "launch comes first", "terminate", NULL);
    client_refused(&client, "'program' is missing", "launch", NULL);
    client_refused(&client, "from stdin", "launch", "{\"program\": \"-\"}");
    client_refused(&client, "names with integers", "launch",
                   "{\"program\": \"x.s\", \"defines\": {\"N\": \"8\"}}");
    client_refused(&client, "a list of folders", "launch",
                   "{\"program\": \"x.s\", \"include\": [8]}");
    client_refused(&client, "missing.s", "launch",
                   "{\"program\": \"missing.s\"}");
    client_refused(&client, "no_such_model", "launch",
                   "{\"program\": \"asm/examples/dot.s\", \"model\": "
                   "\"no_such_model\"}");
    write_program("        ADDN r1\n");
    client_refused(&client, "1:16: error", "launch", "{\"program\": \"%s\"}",
                   path);
    assert_non_null(strstr(client.output.text, "1:16: error"));
    write_program(session_text);
    client_ask(&client, "launch", "{\"program\": \"%s\"}", path);
    client_event(&client, "initialized");
    client_refused(&client, "launched already", "launch",
                   "{\"program\": \"%s\"}", path);
    client_refused(&client, "configurationDone comes first", "continue",
                   "{\"threadId\": 1}");
    assert_int_equal(
        the_whole(the(client_ask(&client, "setBreakpoints",
                                 "{\"source\": {\"path\": \"%s\"}, "
                                 "\"breakpoints\": [{\"line\": 5}]}",
                                 path),
                      "breakpoints")
                      ->first,
                  "line"),
        5); /* the sixth, counted from 0 */
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "breakpoint");
    assert_int_equal(the_whole(frames(&client)->first, "line"), 5);
    assert_int_equal(the_whole(frames(&client)->first, "column"), 0);
    leave(&client);
}

static void check_stop(struct dap_client *client, const char *request,
                       const char *stop, const char *why)
{
    const struct json_value *list = the(
        client_ask(client, request,
                   "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                   path, stop),
        "breakpoints");

    assert_int_equal(length_of(list), 1);
    if (json_member_truth(list->first, "verified", true)
        || !strstr(the_text(list->first, "message"), why))
        fail_msg("%s: %s", stop, json_member_text(list->first, "message"));
}

static void test_wrong_stops(void **state)
{
    static const struct {
        const char *request, *stop, *why;
    } wrong[] = {
        { "setBreakpoints", "{\"line\": 1000}", "no code at line 1000" },
        { "setBreakpoints", "{\"line\": 9, \"condition\": \"1 +\"}",
          "expected a value" },
        { "setBreakpoints", "{\"line\": 9, \"condition\": \"1 2\"}",
          "to mean" },
        { "setBreakpoints", "{\"line\": 9, \"hitCondition\": \"many\"}",
          "to mean" },
        { "setBreakpoints", "{\"line\": 9, \"logMessage\": \"x\"}",
          "no log points" },
        { "setBreakpoints", "{\"line\": \"x\"}", "no integer" },
        { "setFunctionBreakpoints", "{\"name\": \"nobody\"}",
          "nothing is called" },
        { "setFunctionBreakpoints", "{}", "missing" },
        { "setInstructionBreakpoints", "{\"instructionReference\": \"x\"}",
          "no address" },
        { "setInstructionBreakpoints", "{}", "missing" },
        { "setDataBreakpoints", "{\"dataId\": \"64, 1\"}",
          "there are no words" },
        { "setDataBreakpoints", "{\"dataId\": \"a.words, 65\"}",
          "1 to 64 words" },
        { "setDataBreakpoints",
          "{\"dataId\": \"a.words\", \"accessType\": \"read\"}",
          "only what is written" },
    };
    struct dap_client client;

    (void)state;
    enter(&client, session_text);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        check_stop(&client, wrong[i].request, wrong[i].stop, wrong[i].why);
    client_refused(&client, "no filter but", "setExceptionBreakpoints",
                   "{\"filters\": [\"all\"]}");
    client_refused(&client, "no variables", "variables",
                   "{\"variablesReference\": 0}");
    client_refused(&client, "counted from 0", "variables",
                   "{\"variablesReference\": 262, \"start\": -1}");
    client_refused(&client, "'count' is", "readMemory",
                   "{\"memoryReference\": \"0\", \"count\": -1}");
    client_refused(&client, "no byte begins", "readMemory",
                   "{\"memoryReference\": \"1\", \"count\": 1}");
    client_refused(&client, "no instruction begins", "disassemble",
                   "{\"memoryReference\": \"8\", \"instructionCount\": 1}");
    leave(&client);
}

/* What is no JSON is told and passed over; without a frame nobody knows where the next one
 * begins. */
static void test_broken(void **state)
{
    static const char *const frames_of[] = {
        "Hello\r\n\r\n",
        "Content-Length: x\r\n\r\n",
        "Content-Length: 99999999\r\n\r\n",
        "Content-Length: 5\n\n",
        "Content-Type: text\r\n\r\n",
        "Content-Length: \r\n\r\n",
    };
    static const char json[] = "Content-Length: 5\r\n\r\nhello";
    static const char half[] = "Content-Length: 50\r\n\r\nhello";
    struct dap_client client;

    (void)state;
    for (size_t i = 0; i < sizeof frames_of / sizeof *frames_of; i++) {
        client_begin(&client, NULL);
        client_send(&client, frames_of[i], strlen(frames_of[i]));
        assert_int_equal(client_end(&client), 1);
    }
    client_begin(&client, NULL);
    client_send(&client, half, strlen(half));
    assert_int_equal(client_end(&client), 1);
    client_begin(&client, NULL);
    client_send(&client, json, strlen(json));
    client_ask(&client, "initialize", NULL);
    assert_non_null(strstr(client.output.text, "no value at byte 0"));
    assert_int_equal(client_end(&client), 0);
}

/* ---- Of the command line ------------------------------------------------------------------------------ */

static void test_command_line(void **state)
{
    static const char *const arguments[] = {
        "--define", "N=7", "--warm", "--model", "cyber205-1pipe", path, NULL
    };
    struct dap_client client;

    (void)state;
    write_program("        ES r10, N + M\n        EXIT r10, r0, 0\n");
    client_begin(&client, arguments);
    client_ask(&client, "initialize", NULL);
    client_ask(&client, "launch",
               "{\"defines\": {\"M\": 4}, \"include\": [\".\"]}");
    client_event(&client, "initialized");
    client_ask(&client, "configurationDone", NULL);
    assert_int_equal(the_whole(client_event(&client, "exited"), "exitCode"),
                     11);
    client_event(&client, "terminated");
    leave(&client);
}

/* ---- The extension ----------------------------------------------------------------------------------- */

static const struct json_value *read_file(struct arena *arena,
                                          const char *name)
{
    char whole[100];
    c205_error error = { "" };
    const struct json_value *tree;
    size_t length;
    char *text;

    snprintf(whole, sizeof whole, "docs/editors/vscode/%s", name);
    text = file_read(whole, FILE_LARGEST, &length, &error);
    if (!text)
        fail_msg("%s: %s", whole, error.message);
    tree = json_read(arena, text, length, &error);
    if (!tree)
        fail_msg("%s: %s", whole, error.message);
    free(text);
    return tree;
}

/* Members with their defaults, as the editor proposes them, but for the program. */
static void put_defaults(struct json *json,
                         const struct json_value *properties)
{
    for (const struct json_value *item = properties->first; item;
         item = item->next) {
        const char *type = the_text(item, "type");
        const struct json_value *value = the(item, "default");

        if (strcmp(item->key, "program") == 0)
            json_text(json, "program", path);
        else if (strcmp(type, "string") == 0)
            json_text(json, item->key, value->text);
        else if (strcmp(type, "boolean") == 0)
            json_truth(json, item->key, value->truth);
        else {
            (strcmp(type, "array") == 0 ? json_array
                                        : json_object)(json, item->key);
            json_end(json);
        }
    }
}

/* What its entry starts is the adapter, which takes what the entry proposes. */
static void test_extension(void **state)
{
    struct dap_client client;
    struct text_buffer launch_text = { 0 };
    struct arena arena = { 0 };
    c205_error error;
    const struct json_value *package = read_file(&arena, "package.json");
    const struct json_value
        *entry = the(the(package, "contributes"), "debuggers")->first;
    struct json *json = json_open_line(&launch_text, &error);

    (void)state;
    read_file(&arena, "language-configuration.json");
    read_file(&arena, "c205.tmLanguage.json");
    assert_string_equal(the_text(package, "version"), C205_VERSION);
    assert_string_equal(the_text(entry, "runtime"), "c205");
    assert_string_equal(the(entry, "args")->first->text, "debug");
    assert_string_equal(the(entry, "args")->first->next->text, "--dap");
    write_program(session_text);
    put_defaults(json,
                 the(the(the(entry, "configurationAttributes"), "launch"),
                     "properties"));
    assert_true(json_close(json, &error));
    client_begin(&client, NULL);
    client_ask(&client, "initialize", NULL);
    client_ask(&client, "launch", "%s", launch_text.text);
    client_event(&client, "initialized");
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "entry");
    leave(&client);
    text_buffer_free(&launch_text);
    arena_free(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_session),
        cmocka_unit_test(test_promises),
        cmocka_unit_test(test_paths),
        cmocka_unit_test(test_library_lines),
        cmocka_unit_test(test_elements),
        cmocka_unit_test(test_time),
        cmocka_unit_test(test_motions),
        cmocka_unit_test(test_objects),
        cmocka_unit_test(test_running),
        cmocka_unit_test(test_running_line),
        cmocka_unit_test(test_wrong_order),
        cmocka_unit_test(test_wrong_stops),
        cmocka_unit_test(test_broken),
        cmocka_unit_test(test_command_line),
        cmocka_unit_test(test_extension),
    };

    return cmocka_run_group_tests(tests, set_up_model, tear_down_model);
}
