/* debugger.c - creates and frees a debugger, listens to its machine, and dispatches its
 * verbs. */
#include <ctype.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/debug/debug_internal.h"
#include "asm/object/object_file.h"
#include "vm/error.h"
#include "base/spelling.h"

/* Default maximum of the bytes of snapshots. */
static const size_t usual_history = (size_t)128 << 20;

/* ---- Verbs ---------------------------------------------------------------- */

static debug_verb verb_help;

struct verb {
    const char *name, *other; /* other: a second name, or NULL */
    debug_verb *obey;         /* NULL: the verb quit */
    bool moves;               /* an empty line repeats the verb */
    const char *arguments, *help;
};

/* The verbs. A prefix of a name selects the first verb that begins with it. */
static const struct verb verbs[] = {
    { "step", "si", verb_step, true, "[N]", "execute N instructions (1)" },
    { "next", "ni", verb_next, true, "[N]",
      "like step, but a whole call counts as one instruction" },
    { "continue", NULL, verb_continue, true, "[N]",
      "run to the next stop, or to the N-th" },
    { "reverse-step", "rs", verb_reverse_step, true, "[N]",
      "go back N instructions (1)" },
    { "reverse-continue", "rc", verb_reverse_continue, true, "",
      "go back to the previous stop" },
    { "until", NULL, verb_until, false, "PLACE", "run to PLACE, or to the next stop" },
    { "goto", NULL, verb_goto, false, "N | clock N",
      "go to step N or to clock N, forward or back" },
    { "run", NULL, verb_run, false, "", "run from the beginning to the first stop" },
    { "break", NULL, verb_break, false, "PLACE [if VALUE]",
      "stop at PLACE: LABEL, LINE, FILE:LINE, *ADDRESS, insn NAME or region NAME" },
    { "tbreak", NULL, verb_tbreak, false, "PLACE [if VALUE]",
      "like break, but stop only once" },
    { "watch", NULL, verb_watch, false, "ADDRESS [, WORDS] [if VALUE]",
      "stop when these words of memory change" },
    { "delete", NULL, verb_delete, false, "[N]",
      "delete breakpoint or watchpoint N, or all" },
    { "where", NULL, verb_where, false, "", "show the current location" },
    { "list", NULL, verb_list, false, "[PLACE] [, N]", "show source lines" },
    { "disassemble", NULL, verb_disassemble, false, "[PLACE] [, N]",
      "show instructions" },
    { "print", NULL, verb_print, false, "VALUE",
      "show a value: r10, NAME, NAME.i, [ADDRESS], clock, step .. with the operators "
      "of .equ" },
    { "x", NULL, verb_x, false, "[/N fixhb] REGISTER | ADDRESS [? REGISTER]",
      "show elements: f numbers, i integers, x hex, h half words, b bits; at a label "
      "in its declared type; after ? with control bits" },
    { "info", NULL, verb_info, false,
      "registers | operands | breaks | regions | pages | symbols", "" },
    { "why", NULL, verb_why, false, "",
      "show the time of the last instruction and its waits" },
    { "account", NULL, verb_account, false, "", "show where the clocks went so far" },
    { "set", NULL, verb_set, false, "REGISTER | [ADDRESS] = VALUE",
      "change a value; the run is different from here on" },
    { "assert", NULL, verb_assert, false, "VALUE",
      "report an error if VALUE is 0; a script then ends with status 1" },
    { "help", NULL, verb_help, false, "", "show this list" },
    { "quit", NULL, NULL, false, "", "" },
};
enum { VERBS = sizeof verbs / sizeof *verbs };

const char *debugger_verb(size_t i)
{
    return i < VERBS ? verbs[i].name : NULL;
}

static void print_verb(const struct debugger *debugger, const char *name,
                       const char *arguments, const char *help)
{
    sink_print(&debugger->out, "%s %s\n", name, arguments);
    if (*help)
        sink_print(&debugger->out, "    %s\n", help);
}

static bool verb_help(struct debugger *debugger, struct text_cursor *cursor)
{
    const struct debugger_verb *more = debugger->setup.verbs;
    if (!text_cursor_finish(debugger, cursor))
        return false;
    for (; more && more->name; more++)
        print_verb(debugger, more->name, more->arguments, more->help);
    for (size_t i = 0; i < VERBS; i++)
        print_verb(debugger, verbs[i].name, verbs[i].arguments, verbs[i].help);
    sink_put(&debugger->out,
             "A verb can be abbreviated; an empty line repeats the last step or "
             "continue.\n");
    return true;
}

/* ---- The listener --------------------------------------------------------- */

/* Copies a record without the unused elements of its arrays of pieces and phases. */
static void copy_record(c205_times *to, const c205_times *from)
{
    memcpy(to, from, offsetof(c205_times, piece));
    memcpy(to->piece, from->piece, from->piece_count * sizeof *to->piece);
    memcpy(to->phase, from->phase, from->phase_count * sizeof *to->phase);
}

/* The listener of the machine, which records the last instruction. Instructions are
 * executed again after a step back; their output is printed only the first time. */
static void hear(void *context, const c205 *machine, const c205_event *event)
{
    struct debugger *debugger = context;
    if (event->kind == C205_EVENT_STOP && event->record) {
        debugger->has_end = true;
        copy_record(&debugger->end, event->record);
    }
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST)
        return;
    debugger->has_end = false;
    debugger->has_last = true;
    debugger->last = *event;
    copy_record(&debugger->record, event->record);
    debugger->last.record = &debugger->record;
    if (step_of(debugger) < debugger->reported)
        return;
    debugger->reported = step_of(debugger) + 1;
    printer_listen(&debugger->printer, machine, event);
}

/* ---- Create and free ------------------------------------------------------ */

static c205 *make_machine(const struct debugger_setup *setup, c205_error *error)
{
    c205 *machine;
    if (setup->machine)
        return setup->machine(setup->context, error);
    machine = c205_new(setup->model, error);
    if (machine && object_check(setup->object, error)
        && c205_load(machine, &setup->object->program, error))
        return machine;
    c205_free(machine);
    return NULL;
}

static c205 *load_machine(struct debugger *debugger, c205_error *error)
{
    c205 *machine = make_machine(&debugger->setup, error);
    if (machine && c205_listen(machine, hear, debugger)) {
        if (debugger->setup.warm)
            c205_warm(machine);
        return machine;
    }
    c205_free(machine);
    return NULL;
}

struct debugger *debugger_new(const struct debugger_setup *setup, c205_error *error)
{
    struct debugger *debugger = calloc(1, sizeof *debugger);
    c205 *machine;
    if (!debugger) {
        error_set(error, "out of memory");
        return NULL;
    }
    debugger->setup = *setup;
    debugger->out = setup->out;
    debugger->printed.to = setup->printed.put ? setup->printed : setup->out;
    debugger->printer.sink = setup->printed_apart
                                 ? setup->printed
                                 : line_tracker_sink(&debugger->printed);
    machine = load_machine(debugger, error);
    if (machine)
        debugger->history = c205_history_new(machine,
                                             setup->history > 0 ? setup->history
                                                                : usual_history,
                                             error);
    if (debugger->history)
        return debugger;
    c205_free(machine);
    free(debugger);
    return NULL;
}

void debugger_free(struct debugger *debugger)
{
    if (!debugger)
        return;
    c205_history_free(debugger->history);
    free(debugger->breakpoints);
    free(debugger);
}

const c205 *debugger_machine(const struct debugger *debugger)
{
    return machine_of(debugger);
}

const struct sink *debugger_out(const struct debugger *debugger)
{
    return &debugger->out;
}

uint64_t debugger_step(const struct debugger *debugger)
{
    return step_of(debugger);
}

uint64_t debugger_known(const struct debugger *debugger)
{
    return c205_history_known(debugger->history);
}

const c205_stop *debugger_halt(const struct debugger *debugger)
{
    return debugger->halted ? &debugger->halt : NULL;
}

const c205_event *debugger_last(const struct debugger *debugger)
{
    return debugger->has_last ? &debugger->last : NULL;
}

const c205_times *debugger_end(const struct debugger *debugger)
{
    return debugger->has_end ? &debugger->end : NULL;
}

const char *debugger_report(struct text_buffer *said)
{
    static const char error[] = "error: ";
    if (said->length == 0)
        return "";
    if (said->text[said->length - 1] == '\n')
        said->text[--said->length] = '\0';
    return strncmp(said->text, error, sizeof error - 1) == 0
               ? said->text + sizeof error - 1
               : said->text;
}

void debugger_greet(struct debugger *debugger)
{
    show_place(debugger);
}

size_t debugger_faults(const struct debugger *debugger)
{
    return debugger->faults;
}

/* ---- Lines ---------------------------------------------------------------- */

static bool is_verb(const struct verb *verb, const char *name, size_t length)
{
    return (strlen(verb->name) >= length && strncmp(verb->name, name, length) == 0)
           || (verb->other && strlen(verb->other) == length
               && strncmp(verb->other, name, length) == 0);
}

static size_t verb_length(const char *text)
{
    size_t length = 0;
    while (isalpha((unsigned char)text[length]) || text[length] == '-')
        length++;
    return length;
}

static void print_unknown(struct debugger *debugger, const char *name, size_t length)
{
    const struct debugger_verb *more = debugger->setup.verbs;
    char word[40];
    struct spelling nearest = { .word = word };
    snprintf(word, sizeof word, "%.*s", (int)length, name);
    for (size_t i = 0; i < VERBS; i++)
        spelling_try(&nearest, verbs[i].name);
    for (; more && more->name; more++)
        spelling_try(&nearest, more->name);
    debug_fault(debugger, "unknown verb '%.*s'; %s%s%s", length < 40 ? (int)length : 40,
                name, nearest.name ? "did you mean '" : "help lists the verbs",
                nearest.name ? nearest.name : "", nearest.name ? "'?" : "");
}

static void keep_movement(struct debugger *debugger, const char *line)
{
    if (line != debugger->again)
        snprintf(debugger->again, sizeof debugger->again, "%s", line);
}

/* Executes an additional verb of the setup. Its name must be written in full. Returns
 * false if the line has no such verb. */
static bool obey_more(struct debugger *debugger, const char *line, size_t length)
{
    const struct debugger_verb *verb = debugger->setup.verbs;
    c205_error error = { "out of memory" };
    while (verb && verb->name
           && !(strlen(verb->name) == length && strncmp(verb->name, line, length) == 0))
        verb++;
    if (!verb || !verb->name)
        return false;
    debugger->again[0] = '\0';
    if (!verb->obey(debugger->setup.context, debugger, line + length, &error))
        debug_fault(debugger, "%s", error.message);
    return true;
}

bool debugger_obey(struct debugger *debugger, const char *line)
{
    struct text_cursor cursor = { line };
    size_t length, i = 0;
    if (text_cursor_end(&cursor))
        cursor.at = line = debugger->again;
    if (text_cursor_end(&cursor) || *cursor.at == '#')
        return true;
    length = verb_length(cursor.at);
    if (obey_more(debugger, cursor.at, length))
        return true;
    while (i < VERBS && !(length > 0 && is_verb(&verbs[i], cursor.at, length)))
        i++;
    if (i == VERBS) {
        print_unknown(debugger, cursor.at, strcspn(cursor.at, " \t\n"));
        return true;
    }
    if (!verbs[i].obey)
        return false;
    cursor.at += length;
    if (verbs[i].moves)
        keep_movement(debugger, line);
    else
        debugger->again[0] = '\0';
    verbs[i].obey(debugger, &cursor);
    return true;
}
