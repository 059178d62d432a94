/* arguments.c - checks the types of the arguments of requests.
 *
 * A request is checked before it is executed. Members that are not listed are ignored,
 * because clients add other members. A member that is null counts as absent.
 */
#include <string.h>

#include "asm/dap/dap_internal.h"

enum kind { TEXT, TRUTH, WHOLE, OBJECT, SOURCE, LIST, TEXTS, WHOLES };
enum { MAX_KEYS = 9 };

/* clang-format off */
/* The required types of the members of requests and of types of the protocol. Each row
 * has one type. The first row that a message violates is reported. */
static const struct {
    const char *owners; /* requests or types of the protocol */
    enum kind kind;
    const char *keys[MAX_KEYS];
} rows[] = {
    { "initialize", TEXT, { "clientID", "clientName", "adapterID", "locale",
      "pathFormat" } },
    { "initialize", TRUTH, { "linesStartAt1", "columnsStartAt1",
      "supportsVariableType", "supportsVariablePaging", "supportsMemoryReferences",
      "supportsProgressReporting", "supportsMemoryEvent", "supportsInvalidatedEvent",
      "supportsRunInTerminalRequest" } },
    { "launch", TEXT, { "program", "model" } },
    { "launch", WHOLES, { "defines" } },
    { "launch", TEXTS, { "include" } },
    { "launch", TRUTH, { "warm", "noDebug", "stopOnEntry", "stopOnEnd" } },
    { "restart", OBJECT, { "arguments" } },
    { "terminate disconnect", TRUTH, { "restart" } },
    { "disconnect", TRUTH, { "terminateDebuggee", "suspendDebuggee" } },
    { "setBreakpoints breakpointLocations gotoTargets source", SOURCE, { "source" } },
    { "setBreakpoints setFunctionBreakpoints setInstructionBreakpoints "
      "setDataBreakpoints", LIST, { "breakpoints" } },
    { "setBreakpoints", LIST, { "lines" } },
    { "setBreakpoints", TRUTH, { "sourceModified" } },
    { "setExceptionBreakpoints", TEXTS, { "filters" } },
    { "setExceptionBreakpoints", LIST, { "filterOptions", "exceptionOptions" } },
    { "dataBreakpointInfo", TEXT, { "name", "mode" } },
    { "dataBreakpointInfo variables setVariable", WHOLE, { "variablesReference" } },
    { "dataBreakpointInfo", WHOLE, { "frameId", "bytes" } },
    { "dataBreakpointInfo", TRUTH, { "asAddress" } },
    { "breakpointLocations gotoTargets Breakpoint", WHOLE, { "line", "column" } },
    { "breakpointLocations", WHOLE, { "endLine", "endColumn" } },
    { "continue reverseContinue next stepIn stepOut stepBack pause goto "
      "exceptionInfo stackTrace", WHOLE, { "threadId" } },
    { "stepIn goto", WHOLE, { "targetId" } },
    { "continue reverseContinue next stepIn stepOut stepBack", TRUTH,
      { "singleThread" } },
    { "next stepIn stepOut stepBack", TEXT, { "granularity" } },
    { "stackTrace", WHOLE, { "startFrame", "levels" } },
    { "variables", WHOLE, { "start", "count" } },
    { "variables", TEXT, { "filter" } },
    { "setVariable", TEXT, { "name", "value" } },
    { "evaluate", TEXT, { "expression", "context" } },
    { "setExpression", TEXT, { "expression", "value" } },
    { "scopes evaluate setExpression", WHOLE, { "frameId" } },
    { "stackTrace variables setVariable evaluate setExpression", OBJECT, { "format" } },
    { "readMemory writeMemory disassemble", TEXT, { "memoryReference" } },
    { "writeMemory", TEXT, { "data" } },
    { "readMemory writeMemory disassemble Breakpoint", WHOLE, { "offset" } },
    { "readMemory", WHOLE, { "count" } },
    { "writeMemory", TRUTH, { "allowPartial" } },
    { "disassemble", WHOLE, { "instructionOffset", "instructionCount" } },
    { "disassemble", TRUTH, { "resolveSymbols" } },
    { "Source", TEXT, { "path", "name" } },
    { "Source source", WHOLE, { "sourceReference" } },
    { "Breakpoint", TEXT, { "name", "instructionReference", "dataId", "accessType",
      "condition", "hitCondition", "logMessage", "mode" } },
};
/* clang-format on */

/* ---- Values -------------------------------------------------------------- */

static const struct {
    enum json_kind kind;
    const char *fault; /* format of the report, with the key as argument */
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

static bool has_word(const char *words, const char *word)
{
    size_t length = strlen(word);
    while (words
           && (strncmp(words, word, length) != 0
               || (words[length] != ' ' && words[length] != '\0'))) {
        words = strchr(words, ' ');
        words = words ? words + 1 : NULL;
    }
    return words;
}

bool dap_check(struct dap *dap, const char *owner, const struct json_value *object)
{
    if (object && object->kind != JSON_OBJECT)
        return dap_fault(dap, "expected an object for '%s'", owner);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (size_t k = 0;
             k < MAX_KEYS && rows[i].keys[k] && has_word(rows[i].owners, owner); k++)
            if (!check_member(dap, object, rows[i].keys[k], rows[i].kind))
                return false;
    return true;
}
