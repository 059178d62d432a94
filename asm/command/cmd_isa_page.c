/* cmd_isa_page.c - c205 isa --markdown: generates the reference of the instructions
 * (docs/isa.md) from insn.def, the machine model and the examples.
 */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "asm/command/cmd_isa.h"
#include "asm/object/syntax.h"

static const struct {
    unsigned bit;
    const char *text, *where;
} g_bits[] = {
    { C205_G_HALF, "32-bit operands, written `,H`",
      "instructions with the suffix `,H`" },
    { C205_G_ZEROS, "the control vector selects elements at its zeros, not at its ones",
      "instructions with an operand Z, if Z is not 0" },
    { C205_G_OFFSET, "register C+1 contains an offset of C and Z",
      "instructions whose result is a vector, but not a sparse vector" },
    { C205_G_GIVEN, "the order vector Z is given, written `? [z]`",
      "instructions whose result is a sparse vector" },
    { C205_G_BROADCAST_A, "A is one number, broadcast",
      "instructions with a source a, without an offset X" },
    { C205_G_BROADCAST_B, "B is one number, broadcast",
      "instructions with a source b, without an offset Y" },
    { C205_G_MAGNITUDE_A, "the magnitude of A (P)", "instructions with sign control" },
    { C205_G_NEGATE_A, "the negative of A, or of its magnitude (R)",
      "instructions with sign control" },
    { C205_G_MAGNITUDE_B, "the magnitude of B (P)",
      "instructions with sign control and a source B" },
};
enum { G_BITS = sizeof g_bits / sizeof *g_bits };

static const struct {
    const char *what, *why, *instead;
} left_out[] = {
#define NO_SUCH_CODE "its codes: `undefined-instruction`"
    { "strings of bytes and of decimal digits",
      "packed decimal arithmetic, editing, search and translation of bytes: "
      "COBOL's part of the machine. No numerical program needs them, and no "
      "available source gives their rules",
      NO_SUCH_CODE },
    { "monitor mode",
      "the exchange of the register file, keys and locks, and the instructions "
      "for the page table. The project has no operating system, because the host "
      "is the monitor",
      NO_SUCH_CODE "; an unknown request of [EXIT](#exit): `bad-request`" },
    { "input and output",
      "the machine had none of its own; its channels led to other computers. "
      "Programs are loaded by the host and print through "
      "[EXIT](#exit)",
      NO_SUCH_CODE },
    { "interrupts of a program",
      "branches that the machine takes by itself when a data flag is set or the "
      "job interval timer reaches zero. No available source gives the targets of "
      "these branches, or the state that they save",
      "the program must read the flags, bit 36 of the timer among them: "
      "[LSDFR](#lsdfr), [BADF](#badf)" },
    { "32-bit strings of bits, 32-bit branches on a distance",
      "a string of bits has no element size, and the branches B0-B5 compare whole "
      "registers only (R)",
      "bit 80 of G in a string: `undefined-instruction`" },
};
enum { LEFT_OUT = sizeof left_out / sizeof *left_out };

/* ---- Markdown ----------------------------------------------------------- */

/* Prints the text of a cell. Bars are escaped, because they would end the cell. */
static void put_cell(const char *text)
{
    for (; *text; text++) {
        if (*text == '|')
            putchar('\\');
        putchar(*text);
    }
}

/* Prints a row of a Markdown table: a name and a text. Only the first `length`
 * characters of the name are printed; a negative length means all. Returns false if the
 * text is missing. */
static bool put_row(const char *name, int length, const char *text)
{
    printf("| %.*s | ", length, name);
    put_cell(text ? text : "?");
    puts(" |");
    return text;
}

static void put_lower(const char *text)
{
    for (; *text; text++)
        putchar(tolower((unsigned char)*text));
}

/* Prints a link, as in "[ADDNV](#addnv)". */
static void put_link(const char *text)
{
    printf("[%s](#", text);
    put_lower(text);
    putchar(')');
}

/* ---- The formats -------------------------------------------------------- */

static const c205_insn *first_of(c205_format format)
{
    size_t i = 0;
    while (i < c205_insn_count && c205_insns[i].format != format)
        i++;
    return i < c205_insn_count ? &c205_insns[i] : NULL;
}

static void put_formats(void)
{
    char drawing[ISA_DRAWING];
    puts("## Formats\n\n"
         "A drawing shows the fields of a format with their widths in bits, from "
         "bit 0 on the left. F is the operation code, I\n"
         "is an immediate operand or the distance of a branch, and - is an unused "
         "field. Every other field has the letter of\n"
         "its operand, and contains the number of a register. The operands are "
         "written to the right of the drawing. There,\n"
         "`[X]` is a register with a descriptor or an address, and `+X` is an "
         "optional offset. A small letter `a` or `b` is a\n"
         "source: a vector `[a]`, a vector with an offset `[a, x]`, or a register "
         "without brackets. `?Z` is an optional\n"
         "control vector, and `!Z` a required control vector. The table of each "
         "instruction shows which operands are half\n"
         "registers, `h0` .. `h255`. If an instruction allows the suffix `,H` (bit "
         "80 of G), this suffix makes its operands 32\n"
         "bits long.\n");
    for (int format = 0; format < C205_FORMATS; format++) {
        const c205_insn *insn = first_of((c205_format)format);
        if (insn) {
            isa_drawing(insn, drawing);
            printf(*insn->operands ? "    %-9s  %-57s  %s\n" : "    %-9s  %s%s\n",
                   c205_format_name(insn->format), drawing,
                   c205_format_syntax(insn->format));
        }
    }
}

static void put_g_bits(void)
{
    puts("\n## The bits of G\n\n| G | meaning | allowed in |\n|---|---|---|");
    for (size_t i = 0; i < G_BITS; i++)
        printf("| %02X | %s | %s |\n", g_bits[i].bit, g_bits[i].text, g_bits[i].where);
    printf("\n"
           "The letters P and R are those of [the "
           "sources](sources.md#the-letters). If the code of an instruction is "
           "written\n"
           "`9D.02`, the digits after the point are bits of G that belong to the "
           "operation. In the branches B0-B5, bit %02X\n"
           "makes the target a distance from the branch; without this bit the "
           "target is the address (Y) + (B). A one in a bit of\n"
           "G that an instruction does not allow causes the trap "
           "`undefined-instruction`.\n"
           "\n"
           "The immediate operand I4 of the formats ALTER, ALTERB and ALTERF is "
           "the low half of G. The high two bits of I4 give\n"
           "the condition of the branch: 0 never, 1 always, 2 if the bit is one, 3 "
           "if the bit is zero. The low two bits give the\n"
           "change of the bit, which does not depend on the condition: 0 none, 1 "
           "invert it, 2 make it zero, 3 make it one.\n",
           C205_G_RELATIVE);
}

/* ---- One instruction ---------------------------------------------------- */

static void put_stream(const c205_insn *insn, const c205_model *model,
                       const c205_constant *startup, const c205_constant *stream)
{
    const char *clocked = isa_clocked(insn);
    printf(": %s + %g n clocks%s%s", startup->text,
           isa_per_element(model, stream, false), *clocked ? ", " : "", clocked);
    if (insn->flags & C205_INSN_HALF) {
        printf("; with `,H` %s + %g n", startup->text,
               isa_per_element(model, stream, true));
    }
}

/* Prints the clocks of a scalar instruction: until the result is available, and until
 * the unit is free. For a taken branch, prints the clocks lost; for a swap, also the
 * clocks of each word. */
static void put_latency(const c205_insn *insn, const c205_model *model,
                        const c205_constant *latency, const c205_constant *busy)
{
    const c205_constant *near = isa_constant(model, "branch", "taken");
    const c205_constant *far = isa_constant(model, "branch", "out_of_stack");
    const c205_constant *word = isa_constant(model, "swap", "word");
    if (insn->timing == C205_TIMING_branch && near && far) {
        printf(": taken %s clocks lost, %s out of the stack", near->text, far->text);
    } else if (insn->timing == C205_TIMING_swap && word) {
        printf(": %s clocks + %s for each word loaded or saved", latency->text,
               word->text);
    } else {
        printf(": result after %s clk, unit free after %s", latency->text, busy->text);
    }
}

/* Prints the formula of a vector instruction or the constants of a scalar
 * instruction. */
static void put_time(const c205_insn *insn, const c205_model *model)
{
    const char *timing = c205_timing_name(insn->timing);
    bool vector = c205_timing_is_vector(insn->timing);
    const c205_constant *first, *second;
    first = isa_constant(model, vector ? "startup" : "latency", timing);
    second = isa_constant(model, vector ? "stream" : "busy", timing);
    printf("| time | unit `%s`, class `%s`", c205_unit_name(insn->unit), timing);
    if (first && second)
        (vector ? put_stream : put_latency)(insn, model, first, second);
    puts(" |");
}

static bool put_operands(const c205_insn *insn)
{
    struct isa_operand operand = { 0 };
    const char *letter = NULL;
    bool good = true;
    while (isa_next_operand(insn, &letter, &operand))
        good = put_row(operand.written, operand.length, operand.meaning) && good;
    return good;
}

static bool put_rules(const c205_insn *insn)
{
    struct isa_rules rules;
    bool good = true;
    isa_list_rules(insn, &rules);
    for (size_t i = 0; i < rules.count; i++)
        good = put_row(rules.rule[i].page_name, -1, rules.rule[i].text) && good;
    return good;
}

static void put_written(const c205_insn *insn)
{
    const char *syntax = c205_format_syntax(insn->format);
    const char *half = insn->flags & C205_INSN_HALF ? "[" SYNTAX_HALF "]" : "";
    printf("| written | `%s%s%s%s` |\n", insn->mnemonic, half, *syntax ? " " : "",
           syntax);
}

static bool put_example(const c205_insn *insn)
{
    const char *const *line = isa_example(insn);
    if (!line)
        return false;
    puts("\n```c205");
    for (; *line; line++)
        fputs(*line, stdout);
    puts("```");
    return true;
}

/* Prints the section of the reference about an instruction. Returns false if an
 * explanation or the example is missing. */
static bool put_insn(const c205_insn *insn, const c205_model *model)
{
    char code[ISA_CODE], drawing[ISA_DRAWING];
    bool good;
    isa_code(insn, code);
    isa_drawing(insn, drawing);
    printf("\n### %s\n\n%c%s.\n\n| | |\n|---|---|\n| code | %s |\n", insn->mnemonic,
           toupper((unsigned char)insn->effect[0]), insn->effect + 1, code);
    put_written(insn);
    printf("| format | [%s](#formats) `", c205_format_name(insn->format));
    put_cell(drawing);
    puts("` |");
    good = put_operands(insn);
    good = put_rules(insn) && good;
    put_time(insn, model);
    printf("| source | %c: %s |\n", insn->provenance, isa_provenance(insn->provenance));
    return put_example(insn) && good;
}

/* ---- The page ----------------------------------------------------------- */

static void put_contents(void)
{
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        if (isa_family(insn))
            printf("\n- %s:", isa_family(insn));
        putchar(' ');
        put_link(insn->mnemonic);
    }
    puts("\n");
}

static bool put_families(const char *command, const c205_model *model)
{
    bool good = true;
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        if (isa_family(insn))
            printf("\n## %s\n", isa_family(insn));
        if (!put_insn(insn, model)) {
            cmd_failed(command,
                       "%s has no example in asm/isa_examples, or "
                       "a letter or flag that is not explained",
                       insn->mnemonic);
            good = false;
        }
    }
    return good;
}

static bool is_defined(unsigned opcode)
{
    bool found = false;
    for (size_t i = 0; i < c205_insn_count; i++)
        found = found || c205_insns[i].opcode == opcode;
    return found;
}

/* Prints the unused codes, as in "00-08, 0A-1D, ..". */
static void put_free_codes(void)
{
    const char *between = "";
    for (unsigned code = 0; code <= UINT8_MAX; code++) {
        unsigned first = code;
        while (code <= UINT8_MAX && !is_defined(code))
            code++;
        if (code > first) {
            printf("%s%02X", between, first);
            between = ", ";
        }
        if (code > first + 1)
            printf("-%02X", code - 1);
    }
}

static void put_left_out(void)
{
    puts("\n## Instructions that are not implemented\n\n"
         "An operation code without an instruction causes the trap "
         "`undefined-instruction`, which stops the program:\n\n"
         "```c205\n"
         "        .entry  start\n"
         "start:  .half   0xF8000000, 0           ; once a byte string\n"
         "; expect-trap: undefined-instruction\n"
         "```\n\n"
         "| not implemented | reason | effect in a program |\n|---|---|---|");
    for (size_t i = 0; i < LEFT_OUT; i++) {
        printf("| %s | %s | %s |\n", left_out[i].what, left_out[i].why,
               left_out[i].instead);
    }
    printf("\nOperation codes without an instruction: ");
    put_free_codes();
    puts(".");
}

int isa_page(const char *command, const c205_model *model)
{
    bool good;
    puts("# The instructions\n\n"
         "<!-- made from vm/insn.def and asm/isa_examples by "
         "make docs -->\n");
    printf("This page describes all %zu instructions in the order of the "
           "instruction table, `vm/insn.def`.\n"
           "[machine.md](machine.md) has the rules that many instructions share, "
           "[arithmetic.md](arithmetic.md) the results bit\n"
           "by bit, and [timing.md](timing.md) the clock. The clocks are for the "
           "model `%s`,\n"
           "and are rounded up. In a number of clocks, n is the number of elements, "
           "or of bits in a bit string. The table of an\n"
           "instruction lists its rules for special values, if it has any; "
           "[arithmetic.md](arithmetic.md#words) defines the terms\n"
           "of these rules, such as *plain word*. In every instruction, a result above "
           "the range is indefinite and sets the flags\n"
           "42 and 46, and a result below the range is machine zero and sets flag 43. "
           "The tests assemble, run and check each\n"
           "example.\n",
           c205_insn_count, c205_model_name(model));
    put_contents();
    put_formats();
    put_g_bits();
    good = put_families(command, model);
    put_left_out();
    return good ? CMD_DONE : CMD_FAILED;
}
