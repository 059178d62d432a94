/* trap_report.c - reports a trap with its line, its rule and the
 * values of the operands. */
#include "asm/view/trap_report.h"

#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "asm/view/operand_view.h"

static void put_number(const struct sink *sink, const struct operand_view *operand)
{
    char hex[C205_TEXT_SIZE], text[C205_TEXT_SIZE];

    c205_to_hex(operand->word, hex);
    if (operand->is_half)
        hex[9] = '\0'; /* 8 digits and a blank */
    (operand->is_half ? c205_half_to_text : c205_to_text)(operand->word, text);
    sink_print(sink, "X'%s' (%s)\n", hex, text);
}

/* Prints an operand that is often an address: hex, and the decimal integer. */
static void put_integer(const struct sink *sink, const struct operand_view *operand)
{
    char hex[C205_TEXT_SIZE];

    c205_to_hex(operand->word, hex);
    sink_print(sink, "X'%s' (%" PRId64 ")\n", hex, c205_to_integer(operand->word));
}

static void put_vector(const struct sink *sink, const struct operand_view *operand)
{
    const char *elements = operand->width == 64   ? "words"
                           : operand->width == 32 ? "half words"
                                                  : "bits";
    char letter = (char)tolower((unsigned char)operand->letter);

    if (operand->is_bad)
        sink_put(sink, "its offset is negative\n");
    else if (letter == 'x')
        sink_print(sink, "a table of %s from %" PRIX64 " on\n", elements,
                   operand->address);
    else if (letter == 'z')
        sink_print(sink, "bits from %" PRIX64 " on\n", operand->address);
    else
        sink_print(sink, "%zu %s from %" PRIX64 " on\n", operand->length, elements,
                   operand->address);
}

static void put_operand(const struct sink *sink, const struct operand_view *operand)
{
    bool number = strchr("fFvV", operand->letter) != NULL;
    char name = operand->is_half ? 'h' : 'r';

    if (!operand->field || strchr("wWpP", operand->letter)
        || (operand->letter == 'z' && operand->number == 0))
        return;
    if (!operand->is_vector) {
        sink_print(sink, "    %c%u = ", name, operand->number);
        (number || operand->is_half ? put_number : put_integer)(sink, operand);
        return;
    }
    sink_print(sink, "    [r%u", operand->number);
    if (operand->offset)
        sink_print(sink, ", r%u", operand->offset);
    sink_put(sink, "]: ");
    put_vector(sink, operand);
}

void trap_report_operands(const c205 *machine, uint64_t pc, const struct sink *sink)
{
    struct instruction_view view;
    size_t i, n = 1;

    for (i = 0; i < n; i++) {
        size_t k;

        view_decode(&view, machine, pc);
        if (!view.insn)
            return;
        if (view.insn->timing == C205_TIMING_vlink)
            n = 3;
        view_fill(&view, machine);
        if (i > 0)
            sink_print(sink, "    %s:\n", view.insn->mnemonic);
        for (k = 0; k < view.count; k++)
            put_operand(sink, &view.operands[k]);
        pc += 32 * (uint64_t)view.halves;
    }
}

void trap_report(const struct object *object, const char *name, const c205 *machine,
                 const c205_stop *stop, const struct sink *sink)
{
    const struct asm_line *line = object ? object_line(object, stop->pc) : NULL;
    struct position position = { .file = name };
    struct diagnostics diagnostics = { 0 };
    c205_error text;

    if (line)
        position = asm_line_position(line);
    c205_describe_stop(machine, stop, &text);
    diagnostics_add(&diagnostics, SEVERITY_ERROR, &position, text.message);
    diagnostics_put(&diagnostics, sink);
    diagnostics_free(&diagnostics);
    if (stop->insn && stop->trap != C205_TRAP_CLOCK_LIMIT)
        trap_report_operands(machine, stop->pc, sink);
}
