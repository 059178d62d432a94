/* cmd_isa_words.c - the texts of cmd_isa.h: meanings of letters and flags, and rules of
 * formats. */
#include <ctype.h>
#include <string.h>

#include "asm/command/cmd_isa.h"
#include "asm/object/syntax.h"

/* The meaning of a letter in insn.def. */
struct meaning {
    char letter;
    const char *text;
};

/* The meanings of the letters of operands. in_brackets replaces `text` in formats that
 * always have the source in brackets, where it cannot be a register. */
static const struct operand_meaning {
    char letter;
    const char *text, *in_brackets;
} operand_meanings[] = {
#define OR_REGISTER " in brackets, or a register, broadcast"
#define OR_HALF " in brackets, or a half register, broadcast"
    { 'f', "register, read as a number; r0 is machine zero", NULL },
    { 'i', "register, read as bits, an index or an address; r0 is 0", NULL },
    { 'w', "register, written", NULL },
    { 'p', "even register, written, with the next register", NULL },
    { 'm', "register, read as bits, then written", NULL },
    { 'k', "register, written with an index", NULL },
    { 'F', "half register, read as a number; h0, h1 are machine zero", NULL },
    { 'I', "half register, read as bits; h0, h1 are 0", NULL },
    { 'W', "half register, written", NULL },
    { 'M', "half register, read as bits, then written", NULL },
    { 'v', "vector of numbers" OR_REGISTER, "vector of numbers" },
    { 'u', "vector of words" OR_REGISTER, "vector of words" },
    { 'l', "vector of indices", NULL },
    { 'V', "vector of 32-bit numbers" OR_HALF, "vector of 32-bit numbers" },
    { 'b', "bit vector, read", NULL },
    { 'd', "vector of words, written", NULL },
    { 'D', "vector of half words, written", NULL },
    { 'q', "vector of indices, written", NULL },
    { 'e', "bit vector, written", NULL },
    { 'c', "vector, written; the machine sets its length", NULL },
    { 'o', "bit vector, written; the machine sets its length", NULL },
    { 'g',
      "bit vector; `, [z]` makes it a result, whose length the machine sets; `? [z]` "
      "makes it an input, and C has an element for each of its ones",
      NULL },
    { 'x', "address of a table; its length is not used", NULL },
    { 'n', "immediate", NULL },
    { 't', "branch target, a label", NULL },
    { 'z', "control vector: ? selects elements at its ones, ?! at its zeros", NULL },
};
enum { MEANINGS = sizeof operand_meanings / sizeof *operand_meanings };

static const struct meaning provenances[] = {
    { 'P', "read in a primary source" },
    { 'S', "read in a secondary source" },
    { 'D', "derived" },
    { 'R', "reconstructed from recollection" },
    { '\0', NULL },
};

static const char *meaning_of(const struct meaning *meanings, char letter)
{
    while (meanings->letter && meanings->letter != letter)
        meanings++;
    return meanings->text;
}

const char *isa_provenance(char letter)
{
    return meaning_of(provenances, letter);
}

/* Returns the explanation of a flag, or NULL. */
static const char *flag_note(const c205_insn *insn, unsigned flag)
{
    if (flag != C205_INSN_SIGN)
        return NULL;
    if (insn->format == C205_FORMAT_EXTREME)
        return "sign control: A may be -A, |A| or -|A|; bit 01 of G is allowed and has "
               "no effect";
    return strpbrk(c205_format_syntax(insn->format), "bB")
               ? "sign control: A may be -A, |A| or -|A|; B may be |B|"
               : "sign control: A may be -A, |A| or -|A|";
}

/* Describes how the instruction can be linked. The text is empty if it cannot. */
static const char *link_note(const c205_insn *insn)
{
    return c205_unit_links(insn->unit)
               ? "may be linked (LINKV) with an instruction of another unit"
               : "";
}

void isa_code(const c205_insn *insn, char text[ISA_CODE])
{
    int length = snprintf(text, ISA_CODE, "%02X", insn->opcode);
    if (insn->subop_mask)
        snprintf(text + length, ISA_CODE - (size_t)length, ".%02X", insn->subop);
}

/* ---- The drawing of a format ------------------------------------------ */

enum { WORD_BITS = 64, HALF_BITS = 32, BYTE_BITS = 8 };

/* Writes a letter at the position of each bit of the mask. */
static void mark(char letter, c205_word mask, char owners[WORD_BITS])
{
    for (unsigned i = 0; i < WORD_BITS; i++)
        if (mask << i >> (WORD_BITS - 1))
            owners[i] = letter;
}

/* Sets owners[i] to the letter of the field to which bit i of the instruction word
 * belongs. For this, each field is set to ones, and the bits of the encoded word that
 * change are marked. Fixed bits of the operation belong to G. The distance of a
 * relative branch overlays Y and B, so it is marked last. */
static void probe_format(const c205_insn *insn, char owners[WORD_BITS])
{
    c205_fields fields = { 0 };
    c205_word empty = c205_encode(insn, &fields);
    memset(owners, '-', WORD_BITS);
    memset(owners, 'F', BYTE_BITS);
    mark('G', (c205_word)insn->subop_mask << (WORD_BITS - 2 * BYTE_BITS), owners);
    for (const char *letter = "GXAYBZCRST"; *letter; letter++) {
        uint8_t *byte = *letter == 'G' ? &fields.g : syntax_field(&fields, *letter);
        *byte = 0xFF;
        mark(*letter, c205_encode(insn, &fields) ^ empty, owners);
        *byte = 0;
    }
    fields.g = C205_G_RELATIVE;
    empty = c205_encode(insn, &fields);
    fields.immediate = -1;
    mark('I', c205_encode(insn, &fields) ^ empty, owners);
}

void isa_drawing(const c205_insn *insn, char text[ISA_DRAWING])
{
    char owners[WORD_BITS];
    int bits = (int)c205_format_halves(insn->format) * HALF_BITS;
    size_t length = 0;
    probe_format(insn, owners);
    for (int i = 0; i < bits;) {
        int run = 1;
        while (i + run < bits && owners[i] == owners[i + run])
            run++;
        length += (size_t)snprintf(text + length, ISA_DRAWING - length, "| %c %d ",
                                   owners[i], run);
        i += run;
    }
    snprintf(text + length, ISA_DRAWING - length, "|");
}

/* ---- Operands and rules ------------------------------------------------- */

/* Returns true if the syntax always has the source in brackets, so it must be a vector:
 * its letter is a capital, or the instruction is a reduction. */
static bool is_in_brackets(const c205_insn *insn, char field)
{
    return isupper((unsigned char)field) || insn->format == C205_FORMAT_REDUCE
           || insn->format == C205_FORMAT_EXTREME;
}

static const char *operand_meaning(char letter, bool in_brackets)
{
    size_t i = 0;
    while (i < MEANINGS && operand_meanings[i].letter != letter)
        i++;
    if (i == MEANINGS)
        return NULL;
    return in_brackets && operand_meanings[i].in_brackets
               ? operand_meanings[i].in_brackets
               : operand_meanings[i].text;
}

bool isa_next_operand(const c205_insn *insn, const char **letter,
                      struct isa_operand *operand)
{
    static const char between[] = "[], ?!";
    if (!*letter) {
        *letter = insn->operands;
        operand->written = c205_format_syntax(insn->format);
    } else {
        (*letter)++;
        operand->written += operand->length;
    }
    operand->written += strspn(operand->written, between);
    operand->length = (int)strcspn(operand->written, between);
    operand->meaning = operand_meaning(**letter,
                                       is_in_brackets(insn, *operand->written));
    return **letter != '\0';
}

static bool has_operand(const c205_insn *insn, const char *letters)
{
    return insn->operands[strcspn(insn->operands, letters)] != '\0';
}

static bool is_vector(const c205_insn *insn)
{
    return c205_unit_is_vector(insn->unit) && has_operand(insn, "vulVbdDeqcox");
}

static bool must_have_control(const c205_insn *insn)
{
    return strchr(c205_format_syntax(insn->format), '!') != NULL;
}

/* Formats whose number of elements follows a special rule, and the sentence that states
 * it. */
static const struct {
    c205_format format;
    const char *length, *clocked;
} lengths[] = {
    { C205_FORMAT_SCAN, "the length of C; each element of A is used with all of B",
      "n the total number of elements of B that are read" },
    { C205_FORMAT_PERIODIC, "the length of C", "" },
    { C205_FORMAT_SPACED, "the length of B", "" },
    { C205_FORMAT_SPARSE,
      "the longer of X and Y; the machine sets the lengths of C and Z. With `? [z]`: "
      "the length of Z; the machine sets the length of C",
      "n the largest number of elements in A, B or C" },
};
enum { LENGTHS = sizeof lengths / sizeof *lengths };

const char *isa_clocked(const c205_insn *insn)
{
    for (size_t i = 0; i < LENGTHS; i++)
        if (lengths[i].format == insn->format)
            return lengths[i].clocked;
    return "";
}

/* Returns the sentence that states the number of elements of an instruction, or "" for
 * a scalar instruction. */
static const char *length_rule(const c205_insn *insn)
{
    if (!is_vector(insn))
        return "";
    for (size_t i = 0; i < LENGTHS; i++)
        if (lengths[i].format == insn->format)
            return lengths[i].length;
    if (has_operand(insn, "co")) {
        return must_have_control(insn)
                   ? "the length of Z; the machine sets the length of C"
                   : "the length of A, or of B if A is broadcast; the machine sets the "
                     "length of C";
    }
    if (has_operand(insn, "x")) {
        return has_operand(insn, "d") ? "the length of C, or of A if A is shorter"
                                      : "the length of A";
    }
    if (has_operand(insn, "dDe")) {
        return strchr(c205_format_syntax(insn->format), 'C') ? "the length of C"
                                                             : "the length of T";
    }
    return has_operand(insn, "b") ? "the length of R"
           : strchr(c205_format_syntax(insn->format), 'b')
               ? "the length of A, or of B if A is broadcast"
               : "the length of A";
}

/* Describes the elements that continue a short source vector. Returns "" if no source
 * can be short. */
static const char *padding_rule(const c205_insn *insn)
{
    bool sparse = insn->format == C205_FORMAT_SPARSE;
    if (insn->flags & C205_INSN_PADZ) {
        return sparse ? "continues with machine zeros, like absent elements"
                      : "continues with machine zeros";
    }
    if (insn->flags & C205_INSN_PADO)
        return "continues with normalised ones";
    if (!has_operand(insn, "vub") || has_operand(insn, "xwp"))
        return "";
    return has_operand(insn, "b") ? "continues with zero bits"
                                  : "continues with zero words";
}

/* Describes the effect of the control vector on elements that it does not select. */
static const char *control_rule(const c205_insn *insn)
{
    if (!has_operand(insn, "z"))
        return "";
    if (must_have_control(insn)) {
        return "required; `? [z]` selects elements where Z has ones, `?! [z]` "
               "where Z has zeros";
    }
    return has_operand(insn, "wkp")
               ? "with `? [z]` only elements where Z has ones take part; "
                 "with `?! [z]`, where Z has zeros"
               : "with `? [z]` C keeps its values where Z has zeros; "
                 "with `?! [z]`, where Z has ones";
}

/* ---- 32-bit operands ---------------------------------------------------- */

enum { ISA_FIELDS = 16 };

/* Lists the fields whose letters are in `letters`, as in "A, B and C". Returns their
 * number. */
static size_t list_fields(const c205_insn *insn, const char *letters,
                          char text[ISA_FIELDS])
{
    struct isa_operand operand = { 0 };
    const char *letter = NULL;
    size_t count = 0, length = 0;
    text[0] = '\0';
    while (isa_next_operand(insn, &letter, &operand)) {
        if (strchr(letters, *letter)) {
            length += (size_t)snprintf(text + length, ISA_FIELDS - length, "%s%c",
                                       count ? ", " : "",
                                       toupper((unsigned char)*operand.written));
            count++;
        }
    }
    return count;
}

/* Writes a text with the names of the fields whose letters are given: the format `one`
 * for one field, `more` for several. */
static size_t put_group(const c205_insn *insn, const char *letters, const char *one,
                        const char *more, char *text, size_t size)
{
    char fields[ISA_FIELDS];
    size_t count = list_fields(insn, letters, fields);
    return count ? (size_t)snprintf(text, size, count > 1 ? more : one, fields) : 0;
}

static bool broadcasts(const c205_insn *insn)
{
    const char *syntax = c205_format_syntax(insn->format);
    return has_operand(insn, "vu") && insn->format != C205_FORMAT_REDUCE
           && syntax[strcspn(syntax, "ab")];
}

/* Describes the operands with ",H". The text is empty if the instruction has no such
 * form. */
static void write_half_rule(const c205_insn *insn, char text[ISA_HALF])
{
    size_t length;
    text[0] = '\0';
    if (!(insn->flags & C205_INSN_HALF))
        return;
    length = put_group(insn, "vudcx", "elements of %s of 32 bits",
                       "elements of %s of 32 bits", text, ISA_HALF);
    length += put_group(insn, "fwp", "; %s is a half register",
                        "; %s are half registers", text + length, ISA_HALF - length);
    length += (size_t)snprintf(text + length, ISA_HALF - length, "%s",
                               broadcasts(insn)
                                   ? "; a broadcast source is a half register"
                                   : "");
    length += put_group(insn, "lq", "; the indices of %s have 64 bits",
                        "; the indices of %s have 64 bits", text + length,
                        ISA_HALF - length);
    put_group(insn, "k", "; %s is a whole register", "; %s are whole registers",
              text + length, ISA_HALF - length);
}

/* ---- Special values ----------------------------------------------------- */

/* Describes the results for machine zeros and indefinites, and also for results out of
 * range if they differ from the general rule. */
static const char *specials_rule(const c205_insn *insn)
{
    bool has_numbers = has_operand(insn, "fvFV");
    bool has_elements = c205_unit_is_vector(insn->unit) && *insn->operands;
    return has_numbers || has_elements ? c205_operation_specials(insn->operation) : "";
}

/* ---- All rules ---------------------------------------------------------- */

static void add_rule(struct isa_rules *rules, const char *name, const char *page_name,
                     const char *text)
{
    if (!text || *text)
        rules->rule[rules->count++] = (struct isa_rule){ name, page_name, text };
}

void isa_list_rules(const c205_insn *insn, struct isa_rules *rules)
{
    static const unsigned described = C205_INSN_PADZ | C205_INSN_PADO | C205_INSN_HALF;
    rules->count = 0;
    write_half_rule(insn, rules->half);
    add_rule(rules, "length", "length", length_rule(insn));
    add_rule(rules, "padding", "short source", padding_rule(insn));
    add_rule(rules, "control", "control vector", control_rule(insn));
    add_rule(rules, "specials", "special values", specials_rule(insn));
    add_rule(rules, "with ,H", "with `,H`", rules->half);
    for (unsigned flag = 1; flag <= insn->flags; flag <<= 1)
        if (insn->flags & flag & ~described)
            add_rule(rules, "note", "note", flag_note(insn, flag));
    add_rule(rules, "note", "note", link_note(insn));
}

/* ---- Families ----------------------------------------------------------- */

/* The rows of insn.def and the headings between them. */
static const struct entry {
    const char *family; /* NULL: this entry is a row */
} entries[] = {
#define FAMILY(title) { title },
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, flags, \
             semantics, operation, provenance, effect) \
    { NULL },
#include "vm/insn.def"
};

const char *isa_family(const c205_insn *insn)
{
    ptrdiff_t row = insn - c205_insns;
    const struct entry *entry = entries;
    for (; row > 0 || entry->family; entry++)
        if (!entry->family)
            row--;
        else if (row == 0)
            return entry->family;
    return NULL;
}

/* ---- Time --------------------------------------------------------------- */

const c205_constant *isa_constant(const c205_model *model, const char *kind,
                                  const char *timing)
{
    char name[C205_TEXT_SIZE];
    snprintf(name, sizeof name, "%s.%s", kind, timing);
    return c205_model_lookup(model, name);
}

double isa_per_element(const c205_model *model, const c205_constant *stream, bool half)
{
    const c205_constant *pipes = c205_model_lookup(model, "machine.pipes");
    const c205_constant *rate = c205_model_lookup(model, "vector.half_rate");
    bool shared = strstr(stream->unit, "*pipe") != NULL;
    double clocks = stream->value;
    if (shared && pipes)
        clocks /= pipes->value;
    return shared && half && rate ? clocks / rate->value : clocks;
}

/* ---- Examples ----------------------------------------------------------- */

static bool names(const char *file, const char *mnemonic)
{
    while (*mnemonic && tolower((unsigned char)*mnemonic) == *file) {
        mnemonic++;
        file++;
    }
    return *mnemonic == '\0' && strcmp(file, ".s") == 0;
}

const char *const *isa_example(const c205_insn *insn)
{
    const struct text *text = isa_example_texts;
    while (text->name && !names(text->name, insn->mnemonic))
        text++;
    return text->lines;
}
