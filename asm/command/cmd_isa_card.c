/* cmd_isa_card.c - c205 isa --card: prints the instructions on two pages, as groff
 * source. The instruction table and the machine model determine the rows and the
 * clocks. The other texts and the layout are in asm/card.
 */
#include <ctype.h>
#include <string.h>

#include "asm/command/cmd_isa.h"
#include "base/text_file.h"

/* The width of the column of operands in characters. Longer operands extend beyond
 * it. */
enum { MAX_OPERANDS = 14 };

/* Texts of the instruction table, with the mathematical signs of groff that replace
 * them on the card. */
static const struct {
    const char *written, *set;
} signs[] = {
    { " x ", " \\(mu " }, { ">=", "\\(>=" },
    { "<=", "\\(<=" },    { " is not equal to ", " \\(!= " },
    { " - ", " \\- " },   { "-A", "\\-A" },
    { " -= ", " \\-= " }, { "\"", "\\(dq" },
};
enum { SIGNS = sizeof signs / sizeof *signs };

static void put_text(const char *name)
{
    struct sink sink = stream_sink(stdout);
    text_put(text_find(card_texts, name), &sink);
}

/* Returns the sign that replaces the start of a text, and sets *length to the length of
 * the replaced characters. Returns NULL and 1 if the first character is not
 * replaced. */
static const char *sign_at(const char *text, size_t *length)
{
    for (size_t i = 0; i < SIGNS; i++) {
        *length = strlen(signs[i].written);
        if (!strncmp(text, signs[i].written, *length))
            return signs[i].set;
    }
    *length = 1;
    return NULL;
}

/* Prints a text as an argument of a groff macro. */
static void put_argument(const char *text)
{
    size_t length;
    fputs(" \"", stdout);
    for (; *text; text += length) {
        const char *set = sign_at(text, &length);
        if (set)
            fputs(set, stdout);
        else
            putchar(*text);
    }
    putchar('"');
}

/* Prints a text as an argument of a groff macro, without line breaks. */
static void put_word(const char *text)
{
    fputs(" \"", stdout);
    for (; *text; text++) {
        fputs(*text == ' ' ? "\\" : "", stdout);
        putchar(*text);
    }
    putchar('"');
}

/* Returns the longest syntax of operands in the family that begins with the
 * instruction. Syntaxes longer than MAX_OPERANDS are ignored. */
static const char *usual_operands(const c205_insn *insn)
{
    const c205_insn *end = c205_insns + c205_insn_count;
    const char *usual = c205_format_syntax(insn->format);
    while (++insn < end && !isa_family(insn)) {
        const char *operands = c205_format_syntax(insn->format);
        size_t length = strlen(operands);
        if (length > strlen(usual) && length <= MAX_OPERANDS)
            usual = operands;
    }
    return usual;
}

static bool has_marks(const c205_insn *insn)
{
    const c205_insn *end = c205_insns + c205_insn_count;
    bool marks = false;
    do {
        marks = marks || insn->flags;
    } while (++insn < end && !isa_family(insn));
    return marks;
}

static void put_marks(const c205_insn *insn)
{
    printf(" \"%s%s%s\"", insn->flags & C205_INSN_HALF ? "H" : "",
           insn->flags & C205_INSN_SIGN ? "\\(+-" : "",
           insn->flags & C205_INSN_PADZ   ? "0"
           : insn->flags & C205_INSN_PADO ? "1"
                                          : "");
}

/* Prints the timing class. For instructions that can be linked, the first letter of the
 * name of the arithmetic unit follows, as in "M" for multiply. */
static void put_class(const c205_insn *insn)
{
    const char *part = strchr(c205_unit_name(insn->unit), ' ');
    printf(" \"%s", c205_timing_name(insn->timing));
    if (c205_unit_links(insn->unit) && part)
        printf("\\ %c", toupper((unsigned char)part[1]));
    putchar('"');
}

static void put_insn(const c205_insn *insn)
{
    char code[ISA_CODE];
    isa_code(insn, code);
    printf(".insn %s %s", insn->mnemonic, code);
    put_marks(insn);
    put_class(insn);
    put_word(c205_format_syntax(insn->format));
    put_argument(insn->effect);
    putchar('\n');
}

static void put_insns(void)
{
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        if (isa_family(insn)) {
            printf(".family");
            put_argument(isa_family(insn));
            put_word(usual_operands(insn));
            printf(" %d\n", has_marks(insn));
        }
        put_insn(insn);
    }
}

static c205_unit unit_of(c205_timing timing)
{
    size_t i = 0;
    while (c205_insns[i].timing != timing)
        i++;
    return c205_insns[i].unit;
}

static const char *constant_text(const c205_model *model, const char *kind,
                                 const char *name)
{
    const c205_constant *constant = isa_constant(model, kind, name);
    return constant ? constant->text : "?";
}

static void put_scalar_clocks(c205_timing timing, const c205_model *model)
{
    const char *latency = constant_text(model, "latency", c205_timing_name(timing));
    if (timing == C205_TIMING_branch) {
        printf(" \"taken %s, far %s\"\n", constant_text(model, "branch", "taken"),
               constant_text(model, "branch", "out_of_stack"));
    } else if (timing == C205_TIMING_swap) {
        printf(" \"%s + %.2g a word\"\n", latency,
               isa_constant(model, "swap", "word")->value);
    } else {
        printf(" \"%s, %s\"\n", latency,
               constant_text(model, "busy", c205_timing_name(timing)));
    }
}

static void put_vector_clocks(c205_timing timing, const c205_model *model)
{
    const char *name = c205_timing_name(timing);
    const c205_constant *stream = isa_constant(model, "stream", name);
    printf(" \"%s + %.3g n\"\n", constant_text(model, "startup", name),
           isa_per_element(model, stream, false));
}

static void put_classes(const c205_model *model)
{
    printf(".classes %s\n", c205_model_name(model));
    for (int i = 0; i < C205_TIMINGS; i++) {
        c205_timing timing = (c205_timing)i;
        bool vector = c205_timing_is_vector(timing);
        printf(".class %s %s", c205_timing_name(timing),
               vector ? "vector" : c205_unit_name(unit_of(timing)));
        (vector ? put_vector_clocks : put_scalar_clocks)(timing, model);
    }
    puts(".classes_end");
}

void isa_card(const c205_model *model)
{
    put_text("macros.roff");
    printf(".title \"%zu instructions\" %s\n", c205_insn_count, C205_VERSION);
    put_insns();
    put_classes(model);
    put_text("rest.roff");
}
