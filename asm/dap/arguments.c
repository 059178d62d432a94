/* arguments.c - checks the types of the arguments of requests.
 *
 * A request is checked before it is executed. Members that are not listed are ignored,
 * since clients add their own. A member that is null counts as absent.
 */
#include <string.h>

#include "asm/dap/dap_internal.h"

enum kind { TEXT, TRUTH, WHOLE, OBJECT, SOURCE, LIST, TEXTS, WHOLES };
enum { MAX_KEYS = 8 };

static const struct {
    const char *owner; /* a request, or a type of the protocol */
    enum kind kind;
    const char *keys[MAX_KEYS];
} rows[] = {
    { "initialize",
      TEXT,
      { "clientID", "clientName", "adapterID", "locale", "pathFormat" } },
    { "initialize",
      TRUTH,
      { "linesStartAt1", "columnsStartAt1", "supportsVariableType",
        "supportsVariablePaging" } },
    { "initialize",
      TRUTH,
      { "supportsMemoryReferences", "supportsProgressReporting",
        "supportsMemoryEvent" } },
    { "initialize",
      TRUTH,
      { "supportsInvalidatedEvent", "supportsRunInTerminalRequest" } },
    { "launch", TEXT, { "program", "model" } },
    { "launch", WHOLES, { "defines" } },
    { "launch", TEXTS, { "include" } },
    { "launch", TRUTH, { "warm", "noDebug", "stopOnEntry", "stopOnEnd" } },
    { "restart", OBJECT, { "arguments" } },
    { "terminate", TRUTH, { "restart" } },
    { "disconnect", TRUTH, { "restart", "terminateDebuggee", "suspendDebuggee" } },
    { "setBreakpoints", SOURCE, { "source" } },
    { "setBreakpoints", LIST, { "breakpoints", "lines" } },
    { "setBreakpoints", TRUTH, { "sourceModified" } },
    { "setFunctionBreakpoints", LIST, { "breakpoints" } },
    { "setInstructionBreakpoints", LIST, { "breakpoints" } },
    { "setDataBreakpoints", LIST, { "breakpoints" } },
    { "setExceptionBreakpoints", TEXTS, { "filters" } },
    { "setExceptionBreakpoints", LIST, { "filterOptions", "exceptionOptions" } },
    { "dataBreakpointInfo", TEXT, { "name", "mode" } },
    { "dataBreakpointInfo", WHOLE, { "variablesReference", "frameId", "bytes" } },
    { "dataBreakpointInfo", TRUTH, { "asAddress" } },
    { "breakpointLocations", SOURCE, { "source" } },
    { "breakpointLocations", WHOLE, { "line", "column", "endLine", "endColumn" } },
    { "continue", WHOLE, { "threadId" } },
    { "continue", TRUTH, { "singleThread" } },
    { "reverseContinue", WHOLE, { "threadId" } },
    { "reverseContinue", TRUTH, { "singleThread" } },
    { "next", WHOLE, { "threadId" } },
    { "next", TRUTH, { "singleThread" } },
    { "next", TEXT, { "granularity" } },
    { "stepIn", WHOLE, { "threadId", "targetId" } },
    { "stepIn", TRUTH, { "singleThread" } },
    { "stepIn", TEXT, { "granularity" } },
    { "stepOut", WHOLE, { "threadId" } },
    { "stepOut", TRUTH, { "singleThread" } },
    { "stepOut", TEXT, { "granularity" } },
    { "stepBack", WHOLE, { "threadId" } },
    { "stepBack", TRUTH, { "singleThread" } },
    { "stepBack", TEXT, { "granularity" } },
    { "pause", WHOLE, { "threadId" } },
    { "goto", WHOLE, { "threadId", "targetId" } },
    { "gotoTargets", SOURCE, { "source" } },
    { "gotoTargets", WHOLE, { "line", "column" } },
    { "exceptionInfo", WHOLE, { "threadId" } },
    { "stackTrace", WHOLE, { "threadId", "startFrame", "levels" } },
    { "stackTrace", OBJECT, { "format" } },
    { "source", SOURCE, { "source" } },
    { "source", WHOLE, { "sourceReference" } },
    { "scopes", WHOLE, { "frameId" } },
    { "variables", WHOLE, { "variablesReference", "start", "count" } },
    { "variables", TEXT, { "filter" } },
    { "variables", OBJECT, { "format" } },
    { "setVariable", WHOLE, { "variablesReference" } },
    { "setVariable", TEXT, { "name", "value" } },
    { "setVariable", OBJECT, { "format" } },
    { "evaluate", TEXT, { "expression", "context" } },
    { "evaluate", WHOLE, { "frameId" } },
    { "evaluate", OBJECT, { "format" } },
    { "setExpression", TEXT, { "expression", "value" } },
    { "setExpression", WHOLE, { "frameId" } },
    { "setExpression", OBJECT, { "format" } },
    { "readMemory", TEXT, { "memoryReference" } },
    { "readMemory", WHOLE, { "offset", "count" } },
    { "writeMemory", TEXT, { "memoryReference", "data" } },
    { "writeMemory", WHOLE, { "offset" } },
    { "writeMemory", TRUTH, { "allowPartial" } },
    { "disassemble", TEXT, { "memoryReference" } },
    { "disassemble", WHOLE, { "offset", "instructionOffset", "instructionCount" } },
    { "disassemble", TRUTH, { "resolveSymbols" } },
    { "Source", TEXT, { "path", "name" } },
    { "Source", WHOLE, { "sourceReference" } },
    { "Breakpoint", WHOLE, { "line", "column", "offset" } },
    { "Breakpoint", TEXT, { "name", "instructionReference", "dataId", "accessType" } },
    { "Breakpoint", TEXT, { "condition", "hitCondition", "logMessage", "mode" } },
};

/* ---- Values -------------------------------------------------------------- */

static const struct {
    enum json_kind kind;
    const char *fault; /* format of the report; the argument is the key */
} kinds[] = {
    [TEXT] = { JSON_TEXT, "'%s' is not a string" },
    [TRUTH] = { JSON_TRUTH, "'%s' is neither true nor false" },
    [WHOLE] = { JSON_NUMBER, "'%s' is not an integer" },
    [OBJECT] = { JSON_OBJECT, "'%s' is not an object" },
    [SOURCE] = { JSON_OBJECT, "'%s' is not an object" },
    [LIST] = { JSON_ARRAY, "'%s' is not a list" },
    [TEXTS] = { JSON_ARRAY, "'%s' is not a list of strings" },
    [WHOLES] = { JSON_OBJECT, "'%s' is not an object of integers" },
};

static bool is_whole(const struct json_value *object, const char *key)
{
    int64_t whole;
    return json_member_whole(object, key, &whole);
}

static bool has_elements(const struct json_value *value, enum kind kind)
{
    for (const struct json_value *item = value->first; item; item = item->next)
        if ((kind == TEXTS && item->kind != JSON_TEXT)
            || (kind == WHOLES
                && (item->kind != JSON_NUMBER || !is_whole(value, item->key))))
            return false;
    return true;
}

static bool check_member(struct dap *dap, const struct json_value *object,
                         const char *key, enum kind kind)
{
    const struct json_value *value = json_member(object, key);
    if (!value)
        return true;
    if (value->kind != kinds[kind].kind || !has_elements(value, kind)
        || (kind == WHOLE && !is_whole(object, key)))
        return dap_fault(dap, kinds[kind].fault, key);
    return kind != SOURCE || dap_check(dap, "Source", value);
}

bool dap_check(struct dap *dap, const char *owner, const struct json_value *object)
{
    if (object && object->kind != JSON_OBJECT)
        return dap_fault(dap, "expected an object for '%s'", owner);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (size_t k = 0;
             strcmp(rows[i].owner, owner) == 0 && k < MAX_KEYS && rows[i].keys[k]; k++)
            if (!check_member(dap, object, rows[i].keys[k], rows[i].kind))
                return false;
    return true;
}
