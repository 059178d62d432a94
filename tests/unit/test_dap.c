/* test_dap.c - c205 debug --dap, by a client over pipes: a whole session, and what each
 * capability promises.
 */
#include "tests/unit/dap_session.h"
#include "tests/unit/prior_model.h"

/* ---- A whole session ------------------------------------------------------------------ */

TEST(session)
{
    struct dap_client client;
    const struct json_value *body, *list;

    client_launch(&client, client_program, "");
    body = client_ask(&client, "setBreakpoints",
                      "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": "
                      "[{\"line\": 8}, {\"line\": 99}]}",
                      client_path);
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

    list = client_frames(&client);
    assert_int_equal(length_of(list), 2);
    assert_string_equal(the_text(list->first, "name"), "again");
    assert_int_equal(the_whole(list->first, "line"), 9);
    assert_string_equal(the_text(the(list->first, "source"), "name"),
                        client_file_name());
    assert_string_equal(the_text(list->first->next, "name"), "loop");
    assert_int_equal(client_pc(&client), AGAIN);
    client_ask(&client, "stepIn", "{\"threadId\": 1}");
    client_stopped(&client, "step");
    list = client_frames(&client); /* in a macro of the library */
    assert_int_equal(length_of(list), 3);
    assert_string_equal(the_text(the(list->first, "source"), "name"), "core.s");
    assert_string_equal(the_text(list->first->next, "name"),
                        "call    double, link, place");
    assert_int_equal(the_whole(list->first->next, "line"), 10);
    client_ask(&client, "setBreakpoints",
               "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": []}", client_path);
    client_ask(&client, "continue", "{\"threadId\": 1}");
    assert_int_equal(the_whole(client_event(&client, "exited"), "exitCode"), 3);
    client_event(&client, "terminated");
    assert_string_equal(client.output.text, "0\n");
    client_refused(&client, "has ended", "continue", "{\"threadId\": 1}");
    client_leave(&client);
}

/* ---- What is promised -------------------------------------------------------------------- */

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

    for (size_t i = 0; i < COUNT(names); i++) {
        client_ask(client, "setFunctionBreakpoints",
                   "{\"breakpoints\": [{\"name\": \"%s\"}]}", names[i].name);
        client_go(client, "continue", "function breakpoint");
        assert_int_equal(client_pc(client), names[i].pc);
        client_ask(client, "restart", NULL);
        client_stopped(client, "entry");
    }
    client_ask(client, "setFunctionBreakpoints", "{\"breakpoints\": []}");
}

static void try_conditions(struct dap_client *client)
{
    client_stop_at(client, "{\"line\": 9, \"condition\": \"turns == 2 && "
                           "[a.i] > 0\"}");
    client_go(client, "continue", "breakpoint");
    assert_int_equal(word_in(client_print(client, "turns")), 2);
    client_stop_at(client, "");
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

    for (size_t i = 0; i < COUNT(tries); i++) {
        char stop[80];

        snprintf(stop, sizeof stop, "{\"line\": 9, \"hitCondition\": \"%s\"}",
                 tries[i].wanted);
        client_stop_at(client, stop);
        for (size_t k = 0; k < 3 && tries[i].turns[k]; k++) {
            client_go(client, "continue", "breakpoint");
            assert_int_equal(word_in(client_print(client, "turns")), tries[i].turns[k]);
        }
        client_ask(client, "restart", NULL);
        client_stopped(client, "entry");
    }
    client_stop_at(client, "{\"line\": 9}");
    client_go(client, "continue", "breakpoint");
    client_go(client, "continue", "breakpoint");
    client_go(client, "reverseContinue", "breakpoint");
    assert_non_null(
        strstr(the_text(client_ask(client, "evaluate",
                                   "{\"expression\": \"info breaks\", \"context\": "
                                   "\"repl\"}"),
                        "result"),
               "met 2 times"));
    client_event(client, "invalidated");
    client_stop_at(client, "");
}

static void try_evaluate(struct dap_client *client)
{
    const struct json_value
        *body = client_ask(client, "evaluate",
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
    assert_int_equal(client_pc(client), DOUBLE);
}

static void try_clipboard(struct dap_client *client)
{
    const struct json_value
        *body = client_ask(client, "evaluate",
                           "{\"expression\": \"pc\", \"context\": \"clipboard\"}");

    assert_non_null(strstr(the_text(body, "result"), "400000"));
}

static void try_step_back(struct dap_client *client)
{
    client_stop_at(client, "{\"line\": 9}");
    client_go(client, "continue", "breakpoint");
    client_go(client, "continue", "breakpoint");
    client_go(client, "reverseContinue", "breakpoint");
    assert_int_equal(client_step(client), 6);
    client_go(client, "stepBack", "step");
    assert_int_equal(client_step(client), 5);
    client_stop_at(client, "");
    client_go(client, "reverseContinue", "entry");
    assert_int_equal(client_step(client), 0);
    client_go(client, "stepBack", "entry");
}

static void set_variable(struct dap_client *client, int reference, const char *name,
                         const char *value)
{
    client_ask(client, "setVariable",
               "{\"variablesReference\": %d, \"name\": \"%s\", \"value\": "
               "\"%s\"}",
               reference, name, value);
}

static void try_set_variable(struct dap_client *client)
{
    const struct json_value *scopes, *list;
    int vector, halves, bits;

    client_go(client, "next", "step"); /* a is a descriptor then */
    scopes = the(client_ask(client, "scopes", "{\"frameId\": 1}"), "scopes");
    list = client_variables(client, "Vectors");
    vector = reference_of(list, "a");
    list = client_inside(client, vector, ", \"filter\": \"named\"");
    halves = reference_of(list, "half words");
    bits = reference_of(list, "bits");
    set_variable(client, reference_of(scopes, "Registers"), "turns", "7");
    assert_int_equal(word_in(client_print(client, "turns")), 7);
    set_variable(client, reference_of(scopes, "All registers"), "r18", "8");
    assert_int_equal(word_in(client_print(client, "turns")), 8);
    set_variable(client, vector, "[1]", "2.5");
    assert_true(word_in(client_print(client, "[a.i + 64]")) == c205_from_double(2.5));
    set_variable(client, halves, "[3]", "X'12345678'");
    assert_true((word_in(client_print(client, "[a.i + 64]")) & UINT32_MAX)
                == 0x12345678);
    set_variable(client, bits, "[3]", "1");
    assert_true(word_in(value_of(client_inside(client, vector, ""), "[0]")) >> 60 & 1);
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
                           "{\"expression\": \"[%d]\", \"value\": \"2 * 3\"}", WORDS_B);

    assert_int_equal(word_in(the_text(body, "value")), 6);
    assert_int_equal(word_in(client_print(client, "[b.words]")), 6);
    client_refused(client, "set REGISTER", "setExpression",
                   "{\"expression\": \"1 + 2\", \"value\": \"3\"}");
}

/* What was not executed has not been: turns stays 0, and the loop goes on below it. */
static void try_goto(struct dap_client *client)
{
    const struct json_value *target =
        the(client_ask(client, "gotoTargets",
                       "{\"source\": {\"path\": \"%s\"}, \"line\": 15}", client_path),
            "targets");

    client_ask(client, "goto", "{\"threadId\": 1, \"targetId\": %d}",
               (int)the_whole(target->first, "id"));
    client_stopped(client, "goto");
    assert_int_equal(the_whole(client_frames(client)->first, "line"), 15);
    assert_int_equal(client_step(client), 0);
    client_refused(client, "no line of code", "goto",
                   "{\"threadId\": 1, \"targetId\": %d}", WORDS_A);
    client_ask(client, "continue", "{\"threadId\": 1}");
    assert_int_equal(the_whole(client_event(client, "exited"), "exitCode"), 3);
    client_event(client, "terminated");
}

static void try_restart(struct dap_client *client)
{
    client_ask(client, "continue", "{\"threadId\": 1}");
    client_event(client, "exited");
    client_event(client, "terminated");
    client_ask(client, "restart", NULL);
    client_stopped(client, "entry");
    assert_int_equal(client_step(client), 0);
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
    client_ask(client, "setExpression",
               "{\"expression\": \"r17\", \"value\": \"X'0004FFFF00000000'\"}");
    client_ask(client, "goto", "{\"threadId\": 1, \"targetId\": %d}", AGAIN);
    client_stopped(client, "goto");
    client_ask(client, "setExpression",
               "{\"expression\": \"r16\", \"value\": \"X'0004FFFF00000000'\"}");
    body = client_ask(client, "continue", "{\"threadId\": 1}");
    body = client_stopped(client, "exception");
    assert_non_null(strstr(the_text(body, "text"), "trap unmapped-address"));
    body = client_ask(client, "exceptionInfo", NULL);
    assert_string_equal(the_text(body, "exceptionId"), "unmapped-address");
    assert_non_null(strstr(the_text(body, "description"), "ADDNV"));
    client_ask(client, "setExceptionBreakpoints", "{\"filters\": []}");
    client_ask(client, "continue", "{\"threadId\": 1}");
    assert_int_equal(the_whole(client_event(client, "exited"), "exitCode"), 1);
    client_event(client, "terminated");
    assert_non_null(strstr(client->output.text, "trap unmapped-address"));
}

static void try_some_frames(struct dap_client *client)
{
    const struct json_value
        *body = client_ask(client, "stackTrace",
                           "{\"threadId\": 1, \"startFrame\": 1, \"levels\": 1}");

    assert_int_equal(the_whole(body, "totalFrames"), 2);
    assert_int_equal(length_of(the(body, "stackFrames")), 1);
    assert_int_equal(the_whole(the(body, "stackFrames")->first, "id"), 2);
}

/* The library's have no path: their text is asked for. */
static void try_sources(struct dap_client *client)
{
    const struct json_value *list = the(client_ask(client, "loadedSources", NULL),
                                        "sources");
    const struct json_value *core = element_with(list, "name", "core.s");
    const char *text;

    assert_non_null(element_with(list, "name", client_file_name()));
    assert_null(json_member(core, "path"));
    text = the_text(client_ask(client, "source",
                               "{\"source\": {\"sourceReference\": %d}}",
                               (int)the_whole(core, "sourceReference")),
                    "content");
    assert_non_null(strstr(text, ".macro  descriptor"));
    text = the_text(client_ask(client, "source", "{\"source\": {\"path\": \"%s\"}}",
                               client_path),
                    "content");
    assert_string_equal(text, client_program);
    client_refused(client, "no such source", "source", "{\"sourceReference\": 99}");
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

    client_go(client, "next", "step");
    client_go(client, "next", "step");
    snprintf(text, sizeof text, "{\"variablesReference\": %d, \"name\": \"[2]\"}",
             reference_of(client_variables(client, "Vectors"), "b"));
    client_ask(client, "setDataBreakpoints",
               "{\"breakpoints\": [{\"dataId\": \"%s\", \"accessType\": "
               "\"write\"}]}",
               data_id(client, text));
    client_go(client, "continue", "data breakpoint");
    assert_int_equal(client_step(client), 7);
    client_go(client, "continue", "data breakpoint");
    client_go(client, "reverseContinue", "data breakpoint");
    assert_int_equal(client_step(client), 7);
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
    client_go(client, "continue", "data breakpoint");
    assert_int_equal(word_in(client_print(client, "turns")), 3);
    client_ask(client, "setDataBreakpoints", "{\"breakpoints\": []}");
}

static void try_read_memory(struct dap_client *client)
{
    const struct json_value *body =
        client_ask(client, "readMemory",
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

static void try_disassemble(struct dap_client *client)
{
    const struct json_value *list = client_disassembled(client, AGAIN, -2, 4);

    assert_string_equal(the_text(list->first, "instruction"), "ES r18, 5");
    list = client_disassembled(client, AGAIN, 0, 1);
    assert_string_equal(the_text(list->first, "instruction"),
                        "ADDNV [r16], [r16], [r17]");
    assert_string_equal(the_text(list->first, "symbol"), "again");
    assert_int_equal(the_whole(list->first, "line"), 9);
    list = client_disassembled(client, 0, -5, 3);
    assert_string_equal(the_text(list->first, "presentationHint"), "invalid");
}

static void try_locations(struct dap_client *client)
{
    const struct json_value
        *list = the(client_ask(client, "breakpointLocations",
                               "{\"source\": {\"path\": \"%s\"}, \"line\": 1, "
                               "\"endLine\": 12}",
                               client_path),
                    "breakpoints");
    static const int lines[] = { 4, 5, 6, 7, 9, 10, 11 };
    const struct json_value *item = list->first;

    for (size_t i = 0; i < COUNT(lines); i++, item = item->next) {
        assert_non_null(item);
        assert_int_equal(the_whole(item, "line"), lines[i]);
    }
    assert_null(item);
}

/* A macro call is one line, and so is a call; of instructions it is three. */
static void try_granularity(struct dap_client *client)
{
    client_go(client, "next", "step");
    assert_int_equal(client_step(client), 2);
    client_go(client, "stepBack", "step");
    assert_int_equal(client_step(client), 0);
    client_go_finely(client, "next");
    client_go_finely(client, "next");
    assert_int_equal(client_step(client), 2);
    client_go_finely(client, "stepBack");
    assert_int_equal(client_step(client), 1);
    client_go(client, "stepOut", "step");
    assert_int_equal(client_step(client), 2);
    client_stop_at(client, "{\"line\": 10}");
    client_go(client, "continue", "breakpoint");
    client_go(client, "next", "step");
    assert_int_equal(client_pc(client), DBNZ);
    client_go(client, "stepBack", "step");
    client_stop_at(client, "");
    while (client_pc(client) != DBNZ)
        client_go(client, "stepIn", "step");
    client_go(client, "stepOut", "step"); /* of the region, by the routine */
    assert_int_equal(client_pc(client), DOUBLE);
    client_refused(client, "neither", "stepOut", "{\"threadId\": 1}");
}

static void try_instruction_breakpoints(struct dap_client *client)
{
    client_ask(client, "setInstructionBreakpoints",
               "{\"breakpoints\": [{\"instructionReference\": \"0x%X\", "
               "\"offset\": 8}]}",
               AGAIN);
    client_go(client, "continue", "instruction breakpoint");
    assert_int_equal(client_pc(client), CALL);
    client_ask(client, "setInstructionBreakpoints", "{\"breakpoints\": []}");
}

static const struct {
    const char *name;
    void (*attempt)(struct dap_client *client); /* from the first instruction */
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
enum { PROMISES = COUNT(promises) };

/* Each is tried, and what is not promised is not tried. */
TEST(promises)
{
    struct dap_client client;
    const struct json_value *capabilities = client_launch(&client, client_program, "");
    size_t promised = 0;

    for (const struct json_value *item = capabilities->first; item; item = item->next)
        promised += item->kind == JSON_TRUTH && item->truth;
    assert_int_equal(promised, PROMISES);
    for (size_t i = 0; i < PROMISES; i++)
        if (!json_member_truth(capabilities, promises[i].name, false))
            fail_msg("%s is not promised", promises[i].name);
    client_leave(&client);
    for (size_t i = 0; i < PROMISES; i++) {
        client_enter(&client, client_program);
        promises[i].attempt(&client);
        client_leave(&client);
    }
}

GROUP(set_up_model, tear_down_model);
