/* trap_report.c - reports a trap: the line, the rule that was broken, and the values of
 * the operands. */
#include "asm/view/trap_report.h"

#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "asm/view/vector_view.h"
#include "asm/view/word_text.h"

/* Prints an operand that may be an address, in hex and as a decimal integer. */
static void put_integer(const struct sink *sink, const struct operand_view *operand)
{
    struct word_text text = word_text(operand->word, false);
    sink_print(sink, "X'%s' (%" PRId64 ")", text.hex, c205_to_integer(operand->word));
}

static void put_vector(const struct sink *sink, const struct instruction_view *view,
                       const struct operand_view *operand)
{
    struct vector_view vector = vector_of_operand(view, operand);
    char letter = (char)tolower((unsigned char)operand->letter);
    if (operand->is_bad)
        sink_put(sink, "its offset is negative");
    else if (letter == 'x' || letter == 'z')
        sink_print(sink, "%s%s from %" PRIX64 " on", letter == 'x' ? "a table of " : "",
                   vector_elements(operand->width), operand->address);
    else
        vector_extent(&vector, sink);
    if (!operand->is_bad && !strchr("xzco", letter)
        && c205_descriptor_length(operand->word) == 0)
        sink_put(sink, "; its length was not set");
}

/* Prints "r10", or "x (r10)" if the instruction at pc names the register. */
static void put_name(const struct sink *sink, const struct object *object, uint64_t pc,
                     unsigned number, bool half)
{
    const char *name = object ? object_mentioned_name(object, pc, number, half) : "";
    sink_print(sink, *name ? "%s (%c%u)" : "%s%c%u", name, half ? 'h' : 'r', number);
}

static void put_operand(const struct sink *sink, const struct object *object,
                        const struct instruction_view *view,
                        const struct operand_view *operand)
{
    if (!view_is_read(operand))
        return;
    sink_put(sink, operand->is_vector ? "    [" : "    ");
    put_name(sink, object, view->pc, operand->number, operand->is_half);
    if (operand->offset) {
        sink_put(sink, ", ");
        put_name(sink, object, view->pc, operand->offset, false);
    }
    sink_put(sink, operand->is_vector ? "]: " : " = ");
    if (operand->is_vector)
        put_vector(sink, view, operand);
    else if (strchr("fFvV", operand->letter) || operand->is_half)
        word_print(operand->word, operand->is_half, sink);
    else
        put_integer(sink, operand);
    sink_put(sink, "\n");
}

void trap_report_operands(const struct object *object, const c205 *machine, uint64_t pc,
                          const struct sink *sink)
{
    struct instruction_view views[VIEW_LINKED];
    size_t count = view_at(views, machine, pc);
    for (size_t i = 0; i < count && views[i].insn; i++) {
        if (count > 1)
            sink_print(sink, "    %s:\n", views[i].insn->mnemonic);
        for (size_t k = 0; k < views[i].count; k++)
            put_operand(sink, object, &views[i], &views[i].operands[k]);
    }
}

void trap_diagnose(const struct object *object, const char *name, const c205 *machine,
                   const c205_stop *stop, struct diagnostics *diagnostics)
{
    const struct asm_line *line = object ? object_line(object, stop->pc) : NULL;
    struct position position = { .file = name };
    c205_error text;
    if (line)
        position = asm_line_position(line);
    c205_describe_stop(machine, stop, &text);
    diagnostics_add(diagnostics, SEVERITY_ERROR, &position, text.message);
}

void trap_report(const struct object *object, const char *name, const c205 *machine,
                 const c205_stop *stop, const struct sink *sink)
{
    struct diagnostics diagnostics = { 0 };
    trap_diagnose(object, name, machine, stop, &diagnostics);
    diagnostics_put(&diagnostics, sink);
    diagnostics_free(&diagnostics);
    if (stop->insn && stop->trap != C205_TRAP_CLOCK_LIMIT)
        trap_report_operands(object, machine, stop->pc, sink);
}
