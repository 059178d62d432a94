/* test_dap_arguments.c - requests whose arguments have values of every wrong type are
 * compared with the protocol's types: each request is rejected, the message names the
 * argument, and the state is unchanged. A wrong type that is accepted fails here. */
#include "tests/unit/dap_session.h"
#include "tests/unit/prior_model.h"

enum type { TEXT, TRUTH, WHOLE, OBJECT, LIST, TEXTS, WHOLES, TYPES };

static const struct {
    const char *request, *key;
    enum type type;
} arguments[] = {
    { "initialize", "pathFormat", TEXT },
    { "initialize", "adapterID", TEXT },
    { "initialize", "linesStartAt1", TRUTH },
    { "initialize", "columnsStartAt1", TRUTH },
    { "initialize", "supportsInvalidatedEvent", TRUTH },
    { "launch", "program", TEXT },
    { "launch", "model", TEXT },
    { "launch", "defines", WHOLES },
    { "launch", "include", TEXTS },
    { "launch", "warm", TRUTH },
    { "launch", "noDebug", TRUTH },
    { "launch", "stopOnEntry", TRUTH },
    { "launch", "stopOnEnd", TRUTH },
    { "restart", "arguments", OBJECT },
    { "terminate", "restart", TRUTH },
    { "disconnect", "terminateDebuggee", TRUTH },
    { "setBreakpoints", "source", OBJECT },
    { "setBreakpoints", "breakpoints", LIST },
    { "setFunctionBreakpoints", "breakpoints", LIST },
    { "setInstructionBreakpoints", "breakpoints", LIST },
    { "setDataBreakpoints", "breakpoints", LIST },
    { "setExceptionBreakpoints", "filters", TEXTS },
    { "dataBreakpointInfo", "variablesReference", WHOLE },
    { "dataBreakpointInfo", "name", TEXT },
    { "dataBreakpointInfo", "bytes", WHOLE },
    { "breakpointLocations", "source", OBJECT },
    { "breakpointLocations", "line", WHOLE },
    { "breakpointLocations", "endLine", WHOLE },
    { "continue", "threadId", WHOLE },
    { "next", "threadId", WHOLE },
    { "next", "granularity", TEXT },
    { "stepIn", "threadId", WHOLE },
    { "stepOut", "threadId", WHOLE },
    { "stepBack", "granularity", TEXT },
    { "reverseContinue", "threadId", WHOLE },
    { "pause", "threadId", WHOLE },
    { "goto", "targetId", WHOLE },
    { "gotoTargets", "source", OBJECT },
    { "gotoTargets", "line", WHOLE },
    { "exceptionInfo", "threadId", WHOLE },
    { "stackTrace", "threadId", WHOLE },
    { "stackTrace", "startFrame", WHOLE },
    { "stackTrace", "levels", WHOLE },
    { "source", "source", OBJECT },
    { "source", "sourceReference", WHOLE },
    { "scopes", "frameId", WHOLE },
    { "variables", "variablesReference", WHOLE },
    { "variables", "filter", TEXT },
    { "variables", "start", WHOLE },
    { "variables", "count", WHOLE },
    { "setVariable", "variablesReference", WHOLE },
    { "setVariable", "name", TEXT },
    { "setVariable", "value", TEXT },
    { "evaluate", "expression", TEXT },
    { "evaluate", "context", TEXT },
    { "evaluate", "frameId", WHOLE },
    { "setExpression", "expression", TEXT },
    { "setExpression", "value", TEXT },
    { "readMemory", "memoryReference", TEXT },
    { "readMemory", "offset", WHOLE },
    { "readMemory", "count", WHOLE },
    { "writeMemory", "memoryReference", TEXT },
    { "writeMemory", "offset", WHOLE },
    { "writeMemory", "data", TEXT },
    { "writeMemory", "allowPartial", TRUTH },
    { "disassemble", "memoryReference", TEXT },
    { "disassemble", "offset", WHOLE },
    { "disassemble", "instructionOffset", WHOLE },
    { "disassemble", "instructionCount", WHOLE },
    { "disassemble", "resolveSymbols", TRUTH },
};
enum { ARGUMENTS = COUNT(arguments) };

/* Members of a source, in requests that take one. */
static const struct {
    const char *key;
    enum type type;
} source_members[] = { { "path", TEXT },
                       { "name", TEXT },
                       { "sourceReference", WHOLE } };

/* Members of a breakpoint, and the request that has it. */
static const struct {
    const char *request, *key;
    enum type type;
} members[] = {
    { "setBreakpoints", "line", WHOLE },
    { "setBreakpoints", "condition", TEXT },
    { "setBreakpoints", "hitCondition", TEXT },
    { "setBreakpoints", "logMessage", TEXT },
    { "setFunctionBreakpoints", "name", TEXT },
    { "setFunctionBreakpoints", "condition", TEXT },
    { "setInstructionBreakpoints", "instructionReference", TEXT },
    { "setInstructionBreakpoints", "offset", WHOLE },
    { "setInstructionBreakpoints", "hitCondition", TEXT },
    { "setDataBreakpoints", "dataId", TEXT },
    { "setDataBreakpoints", "accessType", TEXT },
};

/* Values, and the types that they match. */
static const struct {
    const char *text;
    bool right[TYPES];
} values[] = {
    { "5", { [WHOLE] = true } },
    { "1.5", { [TEXT] = false } },
    { "1e300", { [TEXT] = false } },
    { "-9007199254740993", { [TEXT] = false } },
    { "\"x\"", { [TEXT] = true } },
    { "\"5\"", { [TEXT] = true } },
    { "\"true\"", { [TEXT] = true } },
    { "true", { [TRUTH] = true } },
    { "false", { [TRUTH] = true } },
    { "[]", { [LIST] = true, [TEXTS] = true } },
    { "[5]", { [LIST] = true } },
    { "[\"x\", null]", { [LIST] = true } },
    { "{}", { [OBJECT] = true, [WHOLES] = true } },
    { "{\"n\": \"5\"}", { [OBJECT] = true } },
    { "{\"n\": 5, \"m\": 0.5}", { [OBJECT] = true } },
    { "{\"n\": null}", { [OBJECT] = true } },
};
enum { VALUES = COUNT(values) };

static void check_argument(struct dap_client *client, size_t i)
{
    for (size_t k = 0; k < VALUES; k++)
        if (!values[k].right[arguments[i].type])
            client_refused(client, arguments[i].key, arguments[i].request,
                           "{\"%s\": %s}", arguments[i].key, values[k].text);
}

/* Requests whose arguments are not an object. */
static void check_no_object(struct dap_client *client, const char *request)
{
    static const char *const wrong[] = { "5", "\"x\"", "true", "[]", "[{}]" };

    for (size_t i = 0; i < COUNT(wrong); i++)
        client_refused(client, "expected an object", request, "%s", wrong[i]);
}

static void check_requests(struct dap_client *client, const char *only)
{
    for (size_t i = 0; i < ARGUMENTS; i++) {
        bool early = strcmp(arguments[i].request, "initialize") == 0
                     || strcmp(arguments[i].request, "launch") == 0;

        if (only ? strcmp(arguments[i].request, only) != 0 : early)
            continue;
        if (i == 0 || strcmp(arguments[i].request, arguments[i - 1].request) != 0)
            check_no_object(client, arguments[i].request);
        check_argument(client, i);
    }
}

static void check_sources(struct dap_client *client)
{
    static const char *const requests[] = { "setBreakpoints", "gotoTargets",
                                            "breakpointLocations", "source" };

    for (size_t r = 0; r < COUNT(requests); r++)
        for (size_t i = 0; i < COUNT(source_members); i++)
            for (size_t k = 0; k < VALUES; k++)
                if (!values[k].right[source_members[i].type])
                    client_refused(client, source_members[i].key, requests[r],
                                   "{\"source\": {\"%s\": %s}}", source_members[i].key,
                                   values[k].text);
}

static void check_breakpoint(struct dap_client *client, const char *request,
                             const char *breakpoint, const char *said)
{
    const struct json_value *list =
        the(client_ask(client, request,
                       "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                       client_path, breakpoint),
            "breakpoints");

    assert_int_equal(length_of(list), 1);
    if (json_member_truth(list->first, "verified", true)
        || !strstr(the_text(list->first, "message"), said))
        fail_msg("%s %s", request, breakpoint);
}

static void check_breakpoints(struct dap_client *client)
{
    char text[100];

    for (size_t i = 0; i < COUNT(members); i++) {
        check_breakpoint(client, members[i].request, "5", "expected an object");
        for (size_t k = 0; k < VALUES; k++) {
            if (values[k].right[members[i].type])
                continue;
            snprintf(text, sizeof text, "{\"%s\": %s}", members[i].key, values[k].text);
            check_breakpoint(client, members[i].request, text, members[i].key);
        }
    }
}

TEST(arguments)
{
    struct dap_client client;

    client_write(client_program);
    client_begin(&client, NULL);
    check_requests(&client, "initialize");
    client_ask(&client, "initialize", "{\"pathFormat\": null}");
    check_requests(&client, "launch");
    client_ask(&client, "launch",
               "{\"program\": \"%s\", \"stopOnEntry\": true, \"warm\": null, "
               "\"defines\": {}, \"include\": [], \"console\": 5}",
               client_path);
    client_event(&client, "initialized");
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "entry");
    check_requests(&client, NULL);
    check_sources(&client);
    check_breakpoints(&client);
    assert_int_equal(client_step(&client), 0);
    client_leave(&client);
}

/* Names of constants, from the client and from the command line. */
TEST(defines)
{
    static const struct {
        const char *defines, *said;
    } wrong[] = {
        { "{\"N\": 1, \"r5\": 1}", "'r5' cannot be defined: it is a regis" },
        { "{\"N\": 1, \"a b\": 1}", "'a b' cannot be defined: it is not" },
        { "{\"N\": 1, \"\": 1}", "'' cannot be defined: it is not a name" },
        { "{\"N\": 1, \"SUMV\": 1}", "'SUMV' cannot be defined: it is an in" },
        { "{\"N\": 1, \"M\": 1}", "'M' is defined, and not used" },
    };
    struct dap_client client;

    client_write("        ES r10, N\n        EXIT r10, r0, 0\n");
    client_begin(&client, NULL);
    client_ask(&client, "initialize", NULL);
    for (size_t i = 0; i < COUNT(wrong); i++)
        client_refused(&client, wrong[i].said, "launch",
                       "{\"program\": \"%s\", \"defines\": %s}", client_path,
                       wrong[i].defines);
    client_ask(&client, "launch", "{\"program\": \"%s\", \"defines\": {\"N\": 1}}",
               client_path);
    client_event(&client, "initialized");
    client_leave(&client);
}

GROUP(set_up_model, tear_down_model);
