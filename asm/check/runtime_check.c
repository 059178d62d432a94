/* runtime_check.c - finds the check site of each instruction, and reports each warning
 * once for a line. */
#include "asm/check/runtime_check.h"
#include "vm/error.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/check/check_site.h"
#include "asm/check/expect.h"
#include "asm/object/disassemble.h"

struct runtime_checker *runtime_new(const struct object *object, const char *name,
                                    const struct warning_choice *choice,
                                    const struct sink *report)
{
    struct runtime_checker *watch = calloc(1, sizeof *watch);
    if (!watch)
        return NULL;
    watch->object = object;
    watch->name = name;
    watch->choice = choice;
    watch->report = report;
    watch->meant = expect_warnings(object);
    watch->storage = storage_map_new(object);
    if (watch->storage)
        return watch;
    free(watch);
    return NULL;
}

void runtime_free(struct runtime_checker *watch)
{
    if (!watch)
        return;
    storage_map_free(watch->storage);
    diagnostics_free(&watch->found);
    free(watch);
}

warning_set runtime_warned(const struct runtime_checker *watch)
{
    return watch->warned;
}

size_t runtime_errors(const struct runtime_checker *watch)
{
    return watch->found.errors;
}

const struct diagnostics *runtime_found(const struct runtime_checker *watch)
{
    return &watch->found;
}

void runtime_forget(struct runtime_checker *watch, size_t count)
{
    diagnostics_keep(&watch->found, count);
    watch->reported_count = watch->found.count;
}

/* ---- Reports ------------------------------------------------------------ */

/* Returns true, and records the report, if the warning was not yet reported for the
 * line and fewer than MAX_REPORTED reports are recorded. */
static bool is_new(struct runtime_checker *watch, struct reported reported)
{
    for (size_t i = 0; i < watch->reported_count; i++)
        if (watch->reported[i].number == reported.number
            && watch->reported[i].warning == reported.warning
            && strcmp(watch->reported[i].file, reported.file) == 0)
            return false;
    if (watch->reported_count == MAX_REPORTED)
        return false;
    watch->reported[watch->reported_count++] = reported;
    return true;
}

static void put(struct runtime_checker *watch, enum warning warning,
                const struct position *position, const char *message)
{
    size_t before = watch->found.count;
    warning_add(&watch->found, watch->choice, warning, position, message);
    if (watch->report && watch->found.count > before)
        diagnostic_put(&watch->found.items[before], watch->report);
}

/* Reports a warning with the address of the instruction, for programs without source
 * lines. */
static void put_at_address(struct runtime_checker *watch, const struct site *site,
                           enum warning warning, const char *message)
{
    const struct position position = { .file = watch->name };
    char text[700];
    snprintf(text, sizeof text, "%s at %" PRIX64 ": %.500s", site->view.insn->mnemonic,
             site->view.pc, message);
    put(watch, warning, &position, text);
}

void runtime_report(struct runtime_checker *watch, const struct site *site,
                    enum warning warning, const char *format, ...)
{
    const struct asm_line *line = object_line(watch->object, site->view.pc);
    struct reported reported = { "", site->view.pc, warning };
    struct position position = { .file = NULL };
    char message[500];
    watch->warned |= WARNING_BIT(warning);
    if ((watch->meant | watch->choice->off) & WARNING_BIT(warning))
        return;
    if (line) {
        reported.file = line->reported.file;
        reported.number = line->reported.number;
        position = asm_line_position(line);
    }
    if (!is_new(watch, reported))
        return;
    PRINTF_TEXT(message, format);
    if (line)
        put(watch, warning, &position, message);
    else
        put_at_address(watch, site, warning, message);
}

/* ---- The instructions --------------------------------------------------- */

/* Returns the check site of an instruction. The sites are a direct-mapped cache. The
 * half word address of the instruction is the index. Two instructions with the same
 * index replace each other, and the count of executions starts again. */
struct site *runtime_site(struct runtime_checker *watch, const c205 *machine,
                          uint64_t pc)
{
    static const struct site empty;
    struct site *site = &watch->sites[pc / 32 % CHECK_SITES];
    if (site->view.pc == pc && site->view.halves)
        return site;
    *site = empty;
    view_decode(&site->view, machine, pc);
    if (site->view.insn)
        site_choose(site);
    return site;
}

/* Returns true if an instruction is in a macro of another file than its call. */
static bool is_of_other_file(const struct object *object, uint64_t pc)
{
    const struct asm_line *line = object_line(object, pc);
    return line && strcmp(line->file, line->shown.file) != 0;
}

/* Warns of a register that the instruction at pc reads before it was written. LINKV
 * runs the two instructions after it. */
static void check_first_reads(struct runtime_checker *watch, const c205 *machine,
                              uint64_t pc)
{
    struct site *site = runtime_site(watch, machine, pc);
    struct instruction_view views[VIEW_LINKED];
    size_t count = view_at(views, machine, pc);
    for (size_t i = 0; i < count && views[i].insn; i++) {
        struct text_line message = { "", 0 };
        struct sink sink = text_line_sink(&message);
        struct unwritten found;
        if (!unwritten_find(&watch->written, &views[i], &found) || watch->is_straight
            || (unwritten_is_copy(views[i].insn)
                && is_of_other_file(watch->object, views[i].pc)))
            continue;
        unwritten_print(&found,
                        object_mentioned_name(watch->object, views[i].pc, found.number,
                                              found.is_half),
                        &views[i], &sink);
        runtime_report(watch, site, WARNING_UNWRITTEN_REGISTER, "%s", message.text);
    }
}

static void look_ahead(struct runtime_checker *watch, const c205 *machine)
{
    uint64_t pc = c205_pc(machine);
    size_t i = pc / 32 % CHECK_SITES;
    if (watch->direct[i].pc != pc) {
        watch->direct[i].before = runtime_site(watch, machine, pc)->before;
        watch->direct[i].pc = pc;
        check_first_reads(watch, machine, pc);
    }
    if (watch->direct[i].before)
        watch->direct[i].before(watch, machine, runtime_site(watch, machine, pc));
}

/* Clears is_entered and is_emptied of the registers that the instruction has written.
 * CPSV sets the length of its result, so this length is intended even if it is 0. */
static void take_lengths(struct runtime_checker *watch, const c205_event *event)
{
    for (unsigned r = 0; r < C205_REGISTERS; r++) {
        uint64_t written = event->written[r / 64];
        if (!written)
            r |= 63;
        else if (written >> r % 64 & 1)
            watch->is_entered[r] = watch->is_emptied[r] = false;
    }
}

/* Returns true if the run ends. The instruction after EXIT is not executed, so it is
 * not checked. */
static bool ends_run(const c205_event *event)
{
    return event->insn->format == C205_FORMAT_REQUEST
           && event->kind == C205_EVENT_INSTRUCTION;
}

void runtime_listen(void *context, const c205 *machine, const c205_event *event)
{
    struct runtime_checker *watch = context;
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST)
        return;
    for (size_t i = 0; i < C205_REGISTERS / 64; i++)
        watch->written.bits[i] |= event->written[i];
    watch->is_straight = watch->is_straight && unwritten_is_straight(event->insn);
    if (c205_unit_is_vector(event->insn->unit)) {
        struct site *site = runtime_site(watch, machine, event->pc);
        take_lengths(watch, event);
        if (site->after)
            site->after(watch, machine, site);
        if (event->recurrent > 0)
            runtime_recurrence(watch, machine, site, event->recurrent);
    }
    if (!ends_run(event))
        look_ahead(watch, machine);
}

/* ---- The start ---------------------------------------------------------- */

/* The registers that the host has set count as written. So do all registers of a
 * machine that is not at the entry, because it was restored. */
void runtime_begin(struct runtime_checker *watch, const c205 *machine)
{
    bool restored = c205_pc(machine) != watch->object->program.entry;
    for (unsigned r = 0; r < C205_REGISTERS; r++)
        if (restored || c205_register(machine, r) != 0)
            register_set_add(&watch->written, r);
    watch->is_straight = watch->object->line_count > 0;
    look_ahead(watch, machine);
}
