/* instruction_text.c - writes one instruction as text of the assembler. */
#include "asm/object/instruction_text.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "asm/object/address_space.h"
#include "asm/object/syntax.h"

enum { HALF_BITS = 32 };

/* ---- One instruction ----
 *
 * The fields of each operand that is written are copied to `written`. If the
 * instruction that these fields encode differs from the original word, the text cannot
 * express it. */

struct writer {
    struct sink sink;
    const struct labels *labels;
    uint64_t address;
    c205_fields fields, written;
};

static int compare_addresses(const void *a, const void *b)
{
    uint64_t first = *(const uint64_t *)a;
    uint64_t second = ((const struct label *)b)->address;
    return (first > second) - (first < second);
}

const struct label *label_at(const struct labels *labels, uint64_t address)
{
    return labels->count == 0 ? NULL
                              : bsearch(&address, labels->items, labels->count,
                                        sizeof *labels->items, compare_addresses);
}

void label_write(const struct labels *labels, uint64_t address, const struct sink *sink)
{
    const struct label *label = label_at(labels, address);
    if (label && label->name)
        sink_put(sink, label->name);
    else
        sink_print(sink, "%s%" PRIX64, label ? "L" : "0x", address);
}

static void write_address(const struct writer *writer, uint64_t address)
{
    label_write(writer->labels, address, &writer->sink);
}

static uint8_t print_field(struct writer *writer, char letter)
{
    uint8_t value = *syntax_field(&writer->fields, letter);
    *syntax_field(&writer->written, letter) = value;
    return value;
}

static bool print_bit(struct writer *writer, uint8_t bit)
{
    bit &= writer->fields.g;
    writer->written.g |= bit;
    return bit != 0;
}

static void write_second(struct writer *writer, const struct operand *operand,
                         uint8_t first)
{
    uint8_t second = 0;
    if (operand->second == SECOND_IS_NEXT)
        if (print_bit(writer, C205_G_OFFSET))
            second = (uint8_t)(first + 1);
        else
            return;
    else if (operand->second)
        second = print_field(writer, operand->second);
    if (second || operand->second == SECOND_IS_NEXT)
        sink_print(&writer->sink, ", r%u", second);
}

static void write_source(struct writer *writer, const struct operand *operand)
{
    bool negate = print_bit(writer, operand->negate);
    bool magnitude = print_bit(writer, operand->magnitude);
    bool bare = operand->kind == OPERAND_REGISTER
                || print_bit(writer, operand->broadcast);
    uint8_t number = print_field(writer, operand->field);
    sink_print(&writer->sink, "%s%s%s%c%u", negate ? "-" : "", magnitude ? "|" : "",
               bare ? "" : "[", bare && operand->half ? 'h' : 'r', number);
    if (!bare)
        write_second(writer, operand, number);
    sink_print(&writer->sink, "%s%s", bare ? "" : "]", magnitude ? "|" : "");
}

/* Writes a branch target. The distance of a target outside of the address space is not
 * stored in `written`, the fields that the text expresses. */
static void write_target(struct writer *writer)
{
    uint64_t target = writer->address + (uint64_t)writer->fields.immediate * HALF_BITS;
    uint8_t y, b;
    if (print_bit(writer, C205_G_RELATIVE)) {
        if (target >> ADDRESS_BITS == 0)
            writer->written.immediate = writer->fields.immediate;
        write_address(writer, target);
        return;
    }
    y = print_field(writer, 'Y');
    b = print_field(writer, 'B');
    sink_print(&writer->sink, b ? "[r%u, r%u]" : "[r%u]", y, b);
}

static bool holds_address(const struct operand *operand)
{
    return operand->kind == OPERAND_IMMEDIATE
           && operand->high >> (ADDRESS_BITS - 1) > 0;
}

/* Writes an immediate, as an address if it can be one. A value out of range is not
 * stored in `written`, the fields that the text expresses. */
static void write_immediate(struct writer *writer, const struct operand *operand)
{
    int64_t value = writer->fields.immediate;
    if (value >= operand->low && value <= operand->high)
        writer->written.immediate = value;
    if (holds_address(operand) && value >= 0)
        write_address(writer, (uint64_t)value);
    else
        sink_print(&writer->sink, "%" PRId64, value);
}

static void write_control(struct writer *writer, const struct operand *operand)
{
    sink_put(&writer->sink, print_bit(writer, C205_G_ZEROS) ? " ?! [" : " ? [");
    sink_print(&writer->sink, "r%u]", print_field(writer, operand->field));
}

static void write_operand(struct writer *writer, const struct operand *operand)
{
    switch (operand->kind) {
    case OPERAND_IMMEDIATE: write_immediate(writer, operand); break;
    case OPERAND_TARGET: write_target(writer); break;
    case OPERAND_CONTROL: write_control(writer, operand); break;
    default: write_source(writer, operand);
    }
}

/* Returns true if the operand is an optional control vector that the text omits: its
 * register is r0, and G does not select elements by zero bits. */
static bool is_absent(const struct writer *writer, const struct operand *operand)
{
    return operand->kind == OPERAND_CONTROL && operand->may_be_left_out
           && writer->fields.z == 0 && !(writer->fields.g & C205_G_ZEROS);
}

static bool write_instruction(struct writer *writer, const c205_insn *insn,
                              c205_word word)
{
    struct operand operands[MAX_OPERANDS];
    size_t blamed, count;
    bool half;
    writer->fields = c205_decode(insn, word);
    writer->written.f = insn->opcode;
    writer->written.g = insn->subop;
    half = insn->flags & C205_INSN_HALF && print_bit(writer, C205_G_HALF);
    count = syntax_operands(insn, half, operands);
    sink_print(&writer->sink, "%s%s", insn->mnemonic, half ? SYNTAX_HALF : "");
    for (size_t i = 0; i < count; i++) {
        if (is_absent(writer, &operands[i]))
            continue;
        if (print_bit(writer, operands[i].given))
            sink_put(&writer->sink, " ? ");
        else if (operands[i].kind != OPERAND_CONTROL)
            sink_put(&writer->sink, i > 0 ? ", " : " ");
        write_operand(writer, &operands[i]);
    }
    return c205_encode(insn, &writer->written) == word
           && !syntax_refusal(insn, operands, count, &writer->fields, &blamed);
}

unsigned instruction_write(c205_word word, uint64_t address, unsigned available,
                           const struct labels *labels, const struct sink *sink)
{
    static const struct writer empty;
    struct writer writer = empty;
    struct text_line line = { "", 0 };
    const c205_insn *insn;
    unsigned halves;
    insn = c205_insn_coded((uint8_t)(word >> 56), (uint8_t)(word >> 48));
    halves = insn ? c205_format_halves(insn->format) : 1;
    if (halves == 1)
        word &= ~(c205_word)UINT32_MAX;
    writer.sink = text_line_sink(&line);
    writer.labels = labels;
    writer.address = address;
    if (insn && halves <= available && write_instruction(&writer, insn, word)) {
        sink_put(sink, line.text);
    } else {
        sink_print(sink, ".half X'%08" PRIX64 "'", word >> HALF_BITS);
        halves = 1;
    }
    return halves;
}

bool instruction_address(c205_word word, uint64_t address, uint64_t *target)
{
    struct operand operands[MAX_OPERANDS];
    const c205_insn *insn;
    c205_fields fields;
    size_t count;
    insn = c205_insn_coded((uint8_t)(word >> 56), (uint8_t)(word >> 48));
    if (!insn)
        return false;
    fields = c205_decode(insn, word);
    count = syntax_operands(insn, false, operands);
    for (size_t i = 0; i < count; i++) {
        *target = (uint64_t)fields.immediate;
        if (holds_address(&operands[i]) && fields.immediate >= 0)
            return true;
        *target = address + *target * HALF_BITS;
        if (operands[i].kind == OPERAND_TARGET && (fields.g & C205_G_RELATIVE))
            return true;
    }
    return false;
}
