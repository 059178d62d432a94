/* show.c - the verbs that show the current location, instructions and source lines. */
#include <inttypes.h>
#include <string.h>

#include "asm/debug/debug_internal.h"
#include "asm/object/disassemble.h"
#include "asm/view/operand_view.h"
#include "asm/view/source_line.h"
#include "asm/view/trap_report.h"

/* ---- Instructions --------------------------------------------------------- */

/* Prints the source line at which the instruction is shown. If the instruction is from
 * a line of a macro, that line follows after "<-". */
static void put_source(const struct debugger *debugger, const struct asm_line *line)
{
    sink_put(&debugger->out, "  ; ");
    source_line_shown(line, &debugger->out);
    if (asm_place_is(&line->shown, line->file, line->number))
        return;
    sink_put(&debugger->out, "  <- ");
    source_line_innermost(line, &debugger->out);
}

void show_instruction(struct debugger *debugger, uint64_t address, const char *before)
{
    const struct asm_line *line = object_line(debugger->setup.object, address);
    char text[DISASSEMBLE_TEXT_SIZE];
    disassemble_one(view_word_at(machine_of(debugger), address), address, text);
    sink_print(&debugger->out, line ? "%s%6" PRIX64 "  %-28s" : "%s%6" PRIX64 "  %s",
               before, address, text);
    if (line)
        put_source(debugger, line);
    sink_put(&debugger->out, "\n");
}

void show_halt(struct debugger *debugger)
{
    const c205_stop *stop = &debugger->halt;
    if (stop->trap == C205_TRAP_NONE)
        sink_print(&debugger->out, "the program has ended with status %" PRId64 "\n",
                   stop->status);
    else
        trap_report(debugger->setup.object, debugger->setup.name, machine_of(debugger),
                    stop, &debugger->out);
}

/* Prints the outermost macro call, if the instruction is shown at another line. */
static void put_call(const struct debugger *debugger)
{
    const struct asm_line *line = object_line(debugger->setup.object,
                                              c205_pc(machine_of(debugger)));
    const struct asm_place *shown = line ? &line->shown : NULL;
    if (!line || asm_place_is(&line->call, shown->file, shown->number))
        return;
    sink_put(&debugger->out, ", called at ");
    source_line_place(&line->call, &debugger->out);
}

void show_place(struct debugger *debugger)
{
    c205 *machine = machine_of(debugger);
    const char *region = object_region(debugger->setup.object, c205_pc(machine));
    line_tracker_close(&debugger->printed);
    sink_print(&debugger->out, "step %" PRIu64 ", clock %" PRIu64 "%s%s",
               step_of(debugger), c205_clock(machine), *region ? ", region " : "",
               region);
    put_call(debugger);
    sink_put(&debugger->out, "\n");
    if (debugger->halted)
        show_halt(debugger);
    if (!debugger->halted || debugger->halt.trap != C205_TRAP_NONE)
        show_instruction(debugger, c205_pc(machine), "=> ");
}

bool verb_where(struct debugger *debugger, struct text_cursor *cursor)
{
    if (!text_cursor_finish(debugger, cursor))
        return false;
    show_place(debugger);
    return true;
}

/* Reads an optional PLACE. The default is the current instruction. */
static bool read_start(struct debugger *debugger, struct text_cursor *cursor,
                       uint64_t *address)
{
    *address = c205_pc(machine_of(debugger));
    text_cursor_skip(cursor);
    return !*cursor->at || *cursor->at == ','
           || place_address(debugger, cursor, address);
}

/* Reads an optional ", COUNT" to the end of the line. The default is the previous value
 * of *count. */
static bool read_count(struct debugger *debugger, struct text_cursor *cursor,
                       uint64_t *count)
{
    return (!text_cursor_sign(cursor, ",") || debug_count(debugger, cursor, count))
           && text_cursor_finish(debugger, cursor);
}

/* Executes disassemble [PLACE] [, COUNT], which prints instructions. */
bool verb_disassemble(struct debugger *debugger, struct text_cursor *cursor)
{
    enum { MAX = 100000 };
    uint64_t address, count = 10;
    if (!read_start(debugger, cursor, &address)
        || !read_count(debugger, cursor, &count))
        return false;
    if (count > MAX)
        return debug_fault(debugger, "at most %d instructions are shown", MAX);
    for (; count > 0 && address >> 48 == 0; count--) {
        struct instruction_view view;
        bool at = address == c205_pc(machine_of(debugger));
        view_decode(&view, machine_of(debugger), address);
        show_instruction(debugger, address, at ? "=> " : "   ");
        address += 32 * (uint64_t)view.halves;
    }
    return true;
}

/* ---- Source --------------------------------------------------------------- */

static bool is_same_line(const struct asm_line *a, const struct asm_line *b)
{
    return a && b && a->form == b->form
           && asm_place_is(&a->shown, b->shown.file, b->shown.number);
}

/* Shows the source lines of code and data, with the form of their operations, in the
 * order of addresses: list [PLACE] [, COUNT] */
bool verb_list(struct debugger *debugger, struct text_cursor *cursor)
{
    const struct object *object = debugger->setup.object;
    const struct asm_line *shown = NULL, *now;
    uint64_t address, count = 10;
    if (!read_start(debugger, cursor, &address)
        || !read_count(debugger, cursor, &count))
        return false;
    if (object->line_count == 0)
        return debug_fault(debugger,
                           "the source lines are not known: debug the program text");
    now = object_line(object, c205_pc(machine_of(debugger)));
    for (size_t i = 0; i < object->line_count && count > 0; i++) {
        const struct asm_line *line = &object->lines[i];
        if (line->address + 32 * line->halves <= address || is_same_line(line, shown))
            continue;
        sink_print(&debugger->out, "%s%s:%zu%s%s\t%.*s\n",
                   is_same_line(line, now) ? "=> " : "   ", line->shown.file,
                   line->shown.number, line->form ? " " : "", asm_form_name(line->form),
                   (int)strcspn(line->shown.source, "\n"), line->shown.source);
        shown = line;
        count--;
    }
    return true;
}
