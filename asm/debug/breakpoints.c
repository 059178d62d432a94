/* breakpoints.c - creates, deletes and checks breakpoints and watchpoints. */
#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/debug/debugger_engine.h"
#include "asm/view/operand_view.h"
#include "base/array.h"

/* ---- Check ---------------------------------------------------------------- */

static bool is_insn(const struct debugger *debugger, const struct breakpoint *stop)
{
    struct instruction_view view;
    view_decode(&view, machine_of(debugger), c205_pc(machine_of(debugger)));
    return view.insn == stop->insn;
}

static bool is_changed(const struct debugger *debugger, const struct breakpoint *stop)
{
    c205_word now[WATCHED_WORDS];
    return c205_read(machine_of(debugger), stop->address, now, stop->count)
           && memcmp(now, stop->held, stop->count * sizeof *now) != 0;
}

static bool is_entered(const struct debugger *debugger, const struct breakpoint *stop,
                       uint64_t before)
{
    const struct object *object = debugger->setup.object;
    uint64_t pc = c205_pc(machine_of(debugger));
    return strcmp(object_region(object, pc), stop->region) == 0
           && strcmp(object_region(object, before), stop->region) != 0;
}

static bool is_there(const struct debugger *debugger, const struct breakpoint *stop,
                     uint64_t before)
{
    switch (stop->kind) {
    case BREAK_ADDRESS: return c205_pc(machine_of(debugger)) == stop->address;
    case BREAK_LINE:
        return place_begins(debugger, stop->file, stop->line,
                            c205_pc(machine_of(debugger)));
    case BREAK_INSN: return is_insn(debugger, stop);
    case BREAK_ENTRY: return is_entered(debugger, stop, before);
    default: return is_changed(debugger, stop);
    }
}

/* Returns true if the condition holds. A condition that cannot be evaluated counts as
 * true, so the program stops where it fails. */
static bool stop_condition_holds(struct debugger *debugger,
                                 const struct breakpoint *stop)
{
    struct text_cursor cursor = { stop->condition };
    struct value_of value;
    return !*stop->condition || !debug_value(debugger, &cursor, &value)
           || debug_is_true(&value);
}

enum { WANTED_TEXT = MAX_TEXT + 40 };

/* Builds the expression that must hold after a number of hits, such as "6 % 3 == 0". */
static void wanted_text(char text[WANTED_TEXT], const char *wanted, uint64_t hits)
{
    snprintf(text, WANTED_TEXT, "%" PRIu64 " %s%s%s", hits,
             isdigit((unsigned char)*wanted) ? ">= " : "", wanted,
             *wanted == '%' ? " == 0" : "");
}

static bool has_hits(struct debugger *debugger, const struct breakpoint *stop)
{
    char text[WANTED_TEXT];
    struct text_cursor cursor = { text };
    struct value_of value;
    if (!*stop->wanted || debugger->searching)
        return true;
    wanted_text(text, stop->wanted, stop->hits);
    return !debug_value(debugger, &cursor, &value) || debug_is_true(&value);
}

static void sample(const struct debugger *debugger, struct breakpoint *stop)
{
    if (stop->kind == BREAK_WATCH)
        c205_read(machine_of(debugger), stop->address, stop->held, stop->count);
}

void breakpoints_sample(struct debugger *debugger)
{
    for (size_t i = 0; i < debugger->breakpoint_count; i++)
        sample(debugger, &debugger->breakpoints[i]);
}

bool breakpoints_meet(struct debugger *debugger, uint64_t before)
{
    bool any = false;
    for (size_t i = 0; i < debugger->breakpoint_count; i++) {
        struct breakpoint *stop = &debugger->breakpoints[i];
        bool there = is_there(debugger, stop, before);
        stop->met = there && stop_condition_holds(debugger, stop);
        if (stop->met && !debugger->searching)
            stop->hits++;
        stop->met = stop->met && has_hits(debugger, stop);
        any |= stop->met;
        if (there && !stop->met)
            sample(debugger, stop);
    }
    return any;
}

/* ---- Report --------------------------------------------------------------- */

static void print_change(struct debugger *debugger, const struct breakpoint *stop)
{
    c205_word now[WATCHED_WORDS];
    char old_text[C205_TEXT_SIZE], text[C205_TEXT_SIZE];
    size_t i = 0;
    if (!c205_read(machine_of(debugger), stop->address, now, stop->count))
        return;
    while (i + 1 < stop->count && now[i] == stop->held[i])
        i++;
    c205_to_text(stop->held[i], old_text);
    c205_to_text(now[i], text);
    sink_print(&debugger->out, "watch %zu: [%" PRIX64 "] was %s, is %s\n", stop->number,
               stop->address + 64 * (uint64_t)i, old_text, text);
}

static void forget(struct debugger *debugger, size_t i)
{
    memmove(&debugger->breakpoints[i], &debugger->breakpoints[i + 1],
            (debugger->breakpoint_count - i - 1) * sizeof *debugger->breakpoints);
    debugger->breakpoint_count--;
}

static void print_stop(struct debugger *debugger, const struct breakpoint *stop)
{
    if (stop->kind == BREAK_WATCH)
        print_change(debugger, stop);
    else
        sink_print(&debugger->out, "break %zu: %s\n", stop->number, stop->text);
}

void breakpoints_pass(struct debugger *debugger, bool reported)
{
    size_t i = 0;
    while (i < debugger->breakpoint_count) {
        struct breakpoint *stop = &debugger->breakpoints[i];
        if (stop->met && reported)
            print_stop(debugger, stop);
        if (stop->met)
            sample(debugger, stop);
        if (stop->met && stop->once)
            forget(debugger, i);
        else
            i++;
    }
}

/* ---- Create and delete ---------------------------------------------------- */

static bool read_condition(struct debugger *debugger, char kept[MAX_TEXT],
                           const char *text)
{
    struct text_cursor cursor = { text };
    text_cursor_skip(&cursor);
    if (strlen(cursor.at) >= MAX_TEXT)
        return debug_fault(debugger, "a condition has at most %d characters",
                           MAX_TEXT - 1);
    text = cursor.at;
    cursor.at += strlen(text);
    text_cursor_text(text, &cursor, kept);
    return true;
}

static bool is_condition(struct debugger *debugger, const char *text)
{
    struct text_cursor cursor = { text };
    return debug_grammar(debugger, &cursor) && text_cursor_finish(debugger, &cursor);
}

bool breakpoints_condition(struct debugger *debugger, struct breakpoint *stop,
                           const char *text)
{
    return read_condition(debugger, stop->condition, text ? text : "")
           && (!*stop->condition || is_condition(debugger, stop->condition));
}

bool breakpoints_wanted(struct debugger *debugger, struct breakpoint *stop,
                        const char *text)
{
    char whole[WANTED_TEXT];
    if (!read_condition(debugger, stop->wanted, text ? text : ""))
        return false;
    wanted_text(whole, stop->wanted, 1);
    return !*stop->wanted || is_condition(debugger, whole);
}

bool breakpoints_watch(struct debugger *debugger, struct text_cursor *cursor,
                       struct breakpoint *stop)
{
    uint64_t count = 1;
    const char *from;
    stop->kind = BREAK_WATCH;
    text_cursor_skip(cursor);
    from = cursor->at;
    text_cursor_sign(cursor, "*");
    if (!debug_address(debugger, cursor, &stop->address)
        || (text_cursor_sign(cursor, ",") && !debug_count(debugger, cursor, &count)))
        return false;
    if (count < 1 || count > WATCHED_WORDS)
        return debug_fault(debugger, "a watchpoint must cover between 1 and %d words",
                           WATCHED_WORDS);
    stop->count = (size_t)count;
    text_cursor_text(from, cursor, stop->text);
    return c205_read(machine_of(debugger), stop->address, stop->held, stop->count)
           || debug_fault(debugger, "no memory words at %" PRIX64, stop->address);
}

bool breakpoints_add(struct debugger *debugger, struct breakpoint *stop)
{
    stop->number = ++debugger->breakpoint_number;
    sample(debugger, stop);
    return array_add(&debugger->breakpoints, &debugger->breakpoint_count, stop,
                     sizeof *stop)
           || debug_fault(debugger, "out of memory");
}

bool breakpoints_delete(struct debugger *debugger, uint64_t number)
{
    size_t i = 0;
    while (i < debugger->breakpoint_count && debugger->breakpoints[i].number != number)
        i++;
    if (i == debugger->breakpoint_count)
        return false;
    forget(debugger, i);
    return true;
}

void breakpoints_forget(struct debugger *debugger, size_t group)
{
    for (size_t i = debugger->breakpoint_count; i-- > 0;)
        if (debugger->breakpoints[i].group == group)
            forget(debugger, i);
}

/* ---- Lines ----------------------------------------------------------------- */

enum { GROUP_LINES = 1 };

bool debugger_break_line(struct debugger *debugger, const char *file, size_t number,
                         size_t *line)
{
    struct breakpoint stop = { .group = GROUP_LINES };
    if (!place_line(debugger, file, number, &stop) || !breakpoints_add(debugger, &stop))
        return false;
    *line = stop.line;
    return true;
}

void debugger_forget_lines(struct debugger *debugger)
{
    breakpoints_forget(debugger, GROUP_LINES);
}
