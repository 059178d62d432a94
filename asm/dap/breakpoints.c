/* breakpoints.c - sets and deletes breakpoints for the client. A request contains all
 * breakpoints of one kind. Its response has a result for each breakpoint.
 */
#include <stdio.h>
#include <string.h>

#include "asm/dap/dap_internal.h"

/* ---- One breakpoint ------------------------------------------------------------- */

/* Reads the place of a breakpoint from a request. Reports an error and returns false if
 * there is no such place. */
typedef bool stop_reader(struct dap *dap, const struct json_value *wanted,
                         const char *file, struct breakpoint *stop);

static bool make_stop(struct dap *dap, const struct json_value *wanted,
                      const char *file, stop_reader *read, struct breakpoint *stop)
{
    struct debugger *debugger = dap->debugger;
    if (!dap_check(dap, "Breakpoint", wanted))
        return false;
    if (json_member(wanted, "logMessage"))
        return dap_fault(dap, "log points are not supported");
    return read(dap, wanted, file, stop)
           && breakpoints_condition(debugger, stop,
                                    json_member_text(wanted, "condition"))
           && breakpoints_wanted(debugger, stop,
                                 json_member_text(wanted, "hitCondition"))
           && breakpoints_add(debugger, stop);
}

static void put_place(struct dap *dap, struct json *body, const struct breakpoint *stop)
{
    json_count(body, "id", stop->number);
    json_text(body, "message", stop->text);
    if (stop->file) {
        put_source(dap, body, stop->file);
        put_line(dap, body, "line", stop->line);
    }
    if (stop->kind == BREAK_LINE || stop->kind == BREAK_ADDRESS)
        dap_put_address(body, "instructionReference", stop->address);
}

static void put_stop(struct dap *dap, struct json *body,
                     const struct json_value *wanted, const char *file, size_t group,
                     stop_reader *read)
{
    struct breakpoint stop = { .group = group };
    bool good = make_stop(dap, wanted, file, read, &stop);
    json_object(body, NULL);
    json_bool(body, "verified", good);
    if (good)
        put_place(dap, body, &stop);
    else
        dap_put_said(dap, body, "message");
    json_end(body);
}

static bool replace(struct dap *dap, const char *file, size_t group, stop_reader *read)
{
    const struct json_value *wanted = json_member_first(dap->arguments, "breakpoints");
    breakpoints_forget(dap->debugger, group);
    json_array(dap->body, "breakpoints");
    for (; wanted; wanted = wanted->next)
        put_stop(dap, dap->body, wanted, file, group, read);
    json_end(dap->body);
    return true;
}

/* ---- Lines --------------------------------------------------------------- */

static bool read_line_stop(struct dap *dap, const struct json_value *wanted,
                           const char *file, struct breakpoint *stop)
{
    int64_t line = 0;
    if (!file)
        return dap_fault(dap, "expected the path of a source file in 'source'");
    return dap_whole(dap, wanted, "line", &line)
           && place_line(dap->debugger, file, line_of(dap, line), stop);
}

/* Sets the breakpoints of a file. Unknown files share one group, which remains
 * empty. */
bool request_breakpoints(struct dap *dap)
{
    const char *file = source_file(dap, json_member(dap->arguments, "source"));
    return replace(dap, file, GROUP_FILES + file_index(dap, file), read_line_stop);
}

static bool has_code(const struct dap *dap, const char *file, size_t number)
{
    for (size_t i = 0; i < dap->object->line_count; i++) {
        const struct asm_line *line = &dap->object->lines[i];
        if (line->is_code
            && ((line->number == number && strcmp(line->file, file) == 0)
                || asm_place_is(&line->shown, file, number)
                || asm_place_is(&line->call, file, number)))
            return true;
    }
    return false;
}

bool request_breakpoint_locations(struct dap *dap)
{
    enum { MAX_LINES = 1000 };
    const char *file = source_file(dap, json_member(dap->arguments, "source"));
    int64_t line = 0, end;
    if (!dap_whole(dap, dap->arguments, "line", &line))
        return false;
    end = line;
    if (!dap_whole(dap, dap->arguments, "endLine", &end))
        return false;
    if (end - line >= MAX_LINES)
        return dap_fault(dap, "more than %d lines", MAX_LINES);
    json_array(dap->body, "breakpoints");
    for (; file && line <= end; line++)
        if (has_code(dap, file, line_of(dap, line))) {
            json_object(dap->body, NULL);
            json_number(dap->body, "line", (double)line);
            json_end(dap->body);
        }
    json_end(dap->body);
    return true;
}

/* ---- Names --------------------------------------------------------------- */

/* Returns the keyword of a place in a debugger command: "region ", "insn ", or "" for a
 * label. If a label, a region and an instruction have the same name, the label or else
 * the region is meant. */
static const char *kind_of(const struct dap *dap, const char *name)
{
    if (object_symbol(dap->object, name))
        return "";
    if (object_region_named(dap->object, name))
        return "region ";
    return c205_insn_named(name, strlen(name)) ? "insn " : "";
}

static bool read_named_stop(struct dap *dap, const struct json_value *wanted,
                            const char *file, struct breakpoint *stop)
{
    const char *name = json_member_text(wanted, "name");
    char text[MAX_TEXT];
    struct text_cursor cursor = { text };
    (void)file;
    if (!name || strlen(name) + sizeof "region " > sizeof text)
        return dap_fault(dap,
                         "a name is missing, or has more than %d "
                         "characters",
                         MAX_TEXT - (int)sizeof "region ");
    snprintf(text, sizeof text, "%s%s", kind_of(dap, name), name);
    return place_read(dap->debugger, &cursor, stop)
           && text_cursor_finish(dap->debugger, &cursor);
}

bool request_function_breakpoints(struct dap *dap)
{
    return replace(dap, NULL, GROUP_FUNCTIONS, read_named_stop);
}

/* ---- Instructions -------------------------------------------------------- */

static bool read_instruction_stop(struct dap *dap, const struct json_value *wanted,
                                  const char *file, struct breakpoint *stop)
{
    char text[DAP_ADDRESS_SIZE];
    struct text_cursor cursor = { text };
    uint64_t address;
    (void)file;
    if (!dap_address(dap, wanted, "instructionReference", &address))
        return false;
    snprintf(text, sizeof text, "*0x%llX", (unsigned long long)address);
    return place_read(dap->debugger, &cursor, stop);
}

bool request_instruction_breakpoints(struct dap *dap)
{
    return replace(dap, NULL, GROUP_INSTRUCTIONS, read_instruction_stop);
}

/* ---- Data ---------------------------------------------------------------- */

/* Reads the identifier of watched data. It has the form "ADDRESS, WORDS", like the
 * arguments of the debugger command `watch`. */
static bool read_data_stop(struct dap *dap, const struct json_value *wanted,
                           const char *file, struct breakpoint *stop)
{
    const char *id = json_member_text(wanted, "dataId");
    const char *access = json_member_text(wanted, "accessType");
    struct text_cursor cursor = { id ? id : "" };
    (void)file;
    if (access && strcmp(access, "write") != 0)
        return dap_fault(dap, "only write access can be watched");
    return breakpoints_watch(dap->debugger, &cursor, stop)
           && text_cursor_finish(dap->debugger, &cursor);
}

bool request_data_breakpoints(struct dap *dap)
{
    return replace(dap, NULL, GROUP_DATA, read_data_stop);
}

/* Finds the address of the data that a request names. The name is an element of a
 * vector if the request has a variablesReference; otherwise it is an expression. */
static bool find_address(struct dap *dap, const char *name, uint64_t *address)
{
    struct text_cursor cursor = { name };
    struct vector_view vector;
    int64_t reference = 0;
    size_t number;
    if (!dap_whole(dap, dap->arguments, "variablesReference", &reference))
        return false;
    if (reference == 0)
        return debug_address(dap->debugger, &cursor, address)
               && text_cursor_finish(dap->debugger, &cursor);
    if (!vector_of(dap, reference, &vector) || !element_number(&vector, name, &number))
        return dap_fault(dap, "only words of memory can be watched, not registers");
    *address = vector.address + (uint64_t)number * vector.width;
    return true;
}

static void put_data(struct json *body, uint64_t address, int64_t bytes)
{
    uint64_t words = ((uint64_t)bytes + address % 64 / 8 + 7) / 8;
    char text[2 * DAP_ADDRESS_SIZE];
    snprintf(text, sizeof text, "0x%llX, %llu",
             (unsigned long long)(address - address % 64), (unsigned long long)words);
    json_text(body, "dataId", text);
    json_text(body, "description", text);
    json_array(body, "accessTypes");
    json_text(body, NULL, "write");
    json_end(body);
    json_bool(body, "canPersist", true);
}

/* Responds with the identifier of data to be watched. If the data cannot be watched,
 * the request succeeds with a null identifier and the reason. */
bool request_data_breakpoint_info(struct dap *dap)
{
    const char *name = json_member_text(dap->arguments, "name");
    int64_t bytes = 8;
    uint64_t address;
    const char *why;
    if (!dap_whole(dap, dap->arguments, "bytes", &bytes))
        return false;
    if (name && bytes > 0 && bytes <= 8 * WATCHED_WORDS
        && find_address(dap, name, &address)) {
        put_data(dap->body, address, bytes);
        return true;
    }
    why = debugger_report(&dap->said);
    json_null(dap->body, "dataId");
    json_text(dap->body, "description",
              *why ? why : "only 1 to 64 words of memory can be watched");
    text_buffer_free(&dap->said);
    return true;
}

/* ---- Traps --------------------------------------------------------------- */

bool request_exception_breakpoints(struct dap *dap)
{
    const struct json_value *filter = json_member_first(dap->arguments, "filters");
    dap->stop_at_traps = false;
    for (; filter; filter = filter->next) {
        if (strcmp(filter->text, "trap") != 0)
            return dap_fault(dap, "unknown filter; the only filter is 'trap'");
        dap->stop_at_traps = true;
    }
    return true;
}
