/* test_dap_arguments.c - requests whose arguments have values of every wrong type are
 * compared with the protocol's types: each request is rejected, the message names the
 * argument, and the state is unchanged. A wrong type that is accepted fails here. */
#include "tests/unit/dap_session.h"
#include "tests/unit/prior_model.h"

/* Requests with their arguments. Each argument has a name and a type. "names" is a list
 * of texts, and "numbers" is an object of integers. */
struct request {
    const char *name, *arguments;
};
static const struct request requests[] = {
    { "initialize", "pathFormat:text adapterID:text linesStartAt1:truth "
                    "columnsStartAt1:truth supportsInvalidatedEvent:truth" },
    { "launch", "program:text model:text defines:numbers include:names warm:truth "
                "noDebug:truth stopOnEntry:truth stopOnEnd:truth" },
    { "restart", "arguments:object" },
    { "terminate", "restart:truth" },
    { "disconnect", "terminateDebuggee:truth" },
    { "setBreakpoints", "source:object breakpoints:list" },
    { "setFunctionBreakpoints", "breakpoints:list" },
    { "setInstructionBreakpoints", "breakpoints:list" },
    { "setDataBreakpoints", "breakpoints:list" },
    { "setExceptionBreakpoints", "filters:names" },
    { "dataBreakpointInfo", "variablesReference:whole name:text bytes:whole" },
    { "breakpointLocations", "source:object line:whole endLine:whole" },
    { "continue", "threadId:whole" },
    { "next", "threadId:whole granularity:text" },
    { "stepIn", "threadId:whole" },
    { "stepOut", "threadId:whole" },
    { "stepBack", "granularity:text" },
    { "reverseContinue", "threadId:whole" },
    { "pause", "threadId:whole" },
    { "goto", "targetId:whole" },
    { "gotoTargets", "source:object line:whole" },
    { "exceptionInfo", "threadId:whole" },
    { "stackTrace", "threadId:whole startFrame:whole levels:whole" },
    { "source", "source:object sourceReference:whole" },
    { "scopes", "frameId:whole" },
    { "variables", "variablesReference:whole filter:text start:whole count:whole" },
    { "setVariable", "variablesReference:whole name:text value:text" },
    { "evaluate", "expression:text context:text frameId:whole" },
    { "setExpression", "expression:text value:text" },
    { "readMemory", "memoryReference:text offset:whole count:whole" },
    { "writeMemory", "memoryReference:text offset:whole data:text allowPartial:truth" },
    { "disassemble", "memoryReference:text offset:whole instructionOffset:whole "
                     "instructionCount:whole resolveSymbols:truth" },
};

/* Members of a source, for requests with a source. */
#define SOURCE "path:text name:text sourceReference:whole"
static const struct request sources[] = {
    { "setBreakpoints", SOURCE },
    { "gotoTargets", SOURCE },
    { "breakpointLocations", SOURCE },
    { "source", SOURCE },
};

/* Requests, with the members of their breakpoints. */
static const struct request breakpoints[] = {
    { "setBreakpoints", "line:whole condition:text hitCondition:text logMessage:text" },
    { "setFunctionBreakpoints", "name:text condition:text" },
    { "setInstructionBreakpoints", "instructionReference:text offset:whole "
                                   "hitCondition:text" },
    { "setDataBreakpoints", "dataId:text accessType:text" },
};

/* JSON values, and the types of arguments that each of them matches. */
static const struct {
    const char *text, *types;
} values[] = {
    { "1.5", "" },        { "[\"x\", null]", "list" },
    { "true", "truth" },  { "{\"n\": null}", "object" },
    { "1e300", "" },      { "\"true\"", "text" },
    { "false", "truth" }, { "{\"n\": \"5\"}", "object" },
    { "5", "whole" },     { "[]", "list names" },
    { "[5]", "list" },    { "{\"n\": 5, \"m\": 0.5}", "object" },
    { "\"x\"", "text" },  { "{}", "object numbers" },
    { "\"5\"", "text" },  { "-9007199254740993", "" },
};

typedef void check_value(struct dap_client *client, const char *request,
                         const char *key, const char *value);

/* Calls `check` for each argument of a request and each value of a wrong type. */
static void check_types(struct dap_client *client, const struct request *request,
                        check_value *check)
{
    char key[40], type[10];
    int length = 0;
    for (const char *next = request->arguments;
         sscanf(next, " %39[^:]:%9s%n", key, type, &length) == 2; next += length)
        for (size_t k = 0; k < COUNT(values); k++)
            if (!strstr(values[k].types, type))
                check(client, request->name, key, values[k].text);
}

static void check_argument(struct dap_client *client, const char *request,
                           const char *key, const char *value)
{
    client_refused(client, key, request, "{\"%s\": %s}", key, value);
}

static void check_source(struct dap_client *client, const char *request,
                         const char *key, const char *value)
{
    client_refused(client, key, request, "{\"source\": {\"%s\": %s}}", key, value);
}

/* For one request, or for all requests of a running program: sends arguments that are
 * not an object, and arguments of wrong types. */
static void check_requests(struct dap_client *client, const char *only)
{
    static const char *const wrong[] = { "5", "\"x\"", "true", "[]", "[{}]" };
    for (size_t i = 0; i < COUNT(requests); i++) {
        const char *name = requests[i].name;
        if (only ? strcmp(name, only) != 0
                 : !strcmp(name, "initialize") || !strcmp(name, "launch"))
            continue;
        for (size_t k = 0; k < COUNT(wrong); k++)
            client_refused(client, "expected an object", name, "%s", wrong[k]);
        check_types(client, &requests[i], check_argument);
    }
}

static void check_list(struct dap_client *client, const char *request,
                       const char *breakpoint, const char *said)
{
    const struct json_value *list =
        the(client_ask(client, request,
                       "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                       client_path, breakpoint),
            "breakpoints");
    assert_int_equal(length_of(list), 1);
    FAIL_IF(json_member_truth(list->first, "verified", true)
                || !strstr(the_text(list->first, "message"), said),
            "%s %s", request, breakpoint);
}

static void check_breakpoint(struct dap_client *client, const char *request,
                             const char *key, const char *value)
{
    check_list(client, request, formatted("{\"%s\": %s}", key, value), key);
}

TEST(arguments)
{
    FREED_BY(client_leave) struct dap_client client;

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
    for (size_t i = 0; i < COUNT(sources); i++)
        check_types(&client, &sources[i], check_source);
    for (size_t i = 0; i < COUNT(breakpoints); i++) {
        check_list(&client, breakpoints[i].name, "5", "expected an object");
        check_types(&client, &breakpoints[i], check_breakpoint);
    }
    assert_int_equal(client_step(&client), 0);
}

/* Names that cannot be constants are rejected, from the client and from the command
 * line. */
TEST(defines)
{
    static const struct {
        const char *defines, *said;
    } wrong[] = {
        { "{\"N\": 1, \"r5\": 1}", "'r5' cannot be defined: it is a regis" },
        { "{\"N\": 1, \"a b\": 1}", "'a b' cannot be defined: it is not" },
        { "{\"N\": 1, \"\": 1}", "'' cannot be defined: it is not a name" },
        { "{\"N\": 1, \"SUMV\": 1}", "'SUMV' cannot be defined: it is an in" },
        { "{\"N\": 1, \"M\": 1}", "'M' is defined, but the program does not use it" },
    };
    FREED_BY(client_leave) struct dap_client client;

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
}
