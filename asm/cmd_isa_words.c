/* cmd_isa_words.c - see cmd_isa.h. */
#include <ctype.h>
#include <stddef.h>
#include <string.h>

#include "asm/cmd_isa.h"

/* What the letters of insn.def mean. */
struct meaning {
    char letter;
    const char *text;
};

static const struct meaning operand_meanings[] = {
    { 'f', "register, read as a number; r0 is machine zero" },
    { 'i', "register, read as bits, an index or an address; r0 is 0" },
    { 'w', "register, written" },
    { 'm', "register, read as bits, then written" },
    { 'v', "vector of numbers in brackets, or a register, broadcast" },
    { 'u', "vector of words in brackets, or a register, broadcast" },
    { 'V', "vector of numbers" },
    { 'U', "vector of words" },
    { 'b', "bit vector, read" },
    { 'd', "vector of words, written" },
    { 'e', "bit vector, written" },
    { 'c', "vector, written; the machine sets its length" },
    { 'x', "address of a table; its length is not used" },
    { 'n', "immediate" },
    { 't', "branch target, a label" },
    { 'z', "control vector: ? where it has ones, ?! zeros" },
    { '\0', NULL },
};

static const struct meaning provenances[] = {
    { 'P', "read in a primary source" },
    { 'S', "read in a secondary source" },
    { 'D', "derived" },
    { 'R', "reconstructed from recollection" },
    { '\0', NULL },
};

static const struct {
    unsigned flag;
    const char *text;
} flag_notes[] = {
    { C205_INSN_SIGN, "sign control: -A, |A|, -|A|, |B|" },
    { C205_INSN_LINK, "may stand after the link prefix" },
    { C205_INSN_INDEX, "the register after the result gets an index" },
};
enum { FLAG_NOTES = sizeof flag_notes / sizeof *flag_notes };

static const char *meaning_of(const struct meaning *meanings, char letter)
{
    while (meanings->letter && meanings->letter != letter) {
        meanings++;
    }
    return meanings->text;
}

const char *isa_provenance(char letter)
{
    return meaning_of(provenances, letter);
}

const char *isa_flag(unsigned flag)
{
    size_t i = 0;
    while (i < FLAG_NOTES && flag_notes[i].flag != flag) {
        i++;
    }
    return i < FLAG_NOTES ? flag_notes[i].text : NULL;
}

void isa_code(const c205_insn *insn, char text[ISA_CODE])
{
    int length = snprintf(text, ISA_CODE, "%02X", insn->opcode);
    if (insn->subop_mask) {
        snprintf(text + length, ISA_CODE - (size_t)length, ".%02X",
                 insn->subop);
    }
}

/* ---- The drawing of a format ------------------------------------------ */

enum { WORD_BITS = 64, HALF_BITS = 32, BYTE_BITS = 8 };

static const struct {
    char letter;
    size_t offset;
} byte_fields[] = {
    { 'G', offsetof(c205_fields, g) }, { 'X', offsetof(c205_fields, x) },
    { 'A', offsetof(c205_fields, a) }, { 'Y', offsetof(c205_fields, y) },
    { 'B', offsetof(c205_fields, b) }, { 'Z', offsetof(c205_fields, z) },
    { 'C', offsetof(c205_fields, c) }, { 'R', offsetof(c205_fields, r) },
    { 'S', offsetof(c205_fields, s) }, { 'T', offsetof(c205_fields, t) },
};
enum { BYTE_FIELDS = sizeof byte_fields / sizeof *byte_fields };

/* Put the letter at each bit of the mask. */
static void mark(char letter, c205_word mask, char owners[WORD_BITS])
{
    for (unsigned i = 0; i < WORD_BITS; i++) {
        if (mask << i >> (WORD_BITS - 1)) {
            owners[i] = letter;
        }
    }
}

/* Which field owns each bit: fill one after another and look where the word
 * changes.  Those of the operation belong to G.  The distance of a relative
 * branch lies over Y and B. */
static void probe_format(const c205_insn *insn, char owners[WORD_BITS])
{
    c205_fields fields = { 0 };
    c205_word empty = c205_encode(insn, &fields);
    memset(owners, '-', WORD_BITS);
    memset(owners, 'F', BYTE_BITS);
    mark('G', (c205_word)insn->subop_mask << (WORD_BITS - 2 * BYTE_BITS),
         owners);
    for (size_t i = 0; i < BYTE_FIELDS; i++) {
        unsigned char *byte =
            (unsigned char *)&fields + byte_fields[i].offset;
        *byte = 0xFF;
        mark(byte_fields[i].letter, c205_encode(insn, &fields) ^ empty,
             owners);
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
        while (i + run < bits && owners[i] == owners[i + run]) {
            run++;
        }
        length += (size_t)snprintf(text + length, ISA_DRAWING - length,
                                   "| %c %d ", owners[i], run);
        i += run;
    }
    snprintf(text + length, ISA_DRAWING - length, "|");
}

/* ---- Operands and rules ------------------------------------------------- */

/* Fields in capitals are registers or descriptors only. */
static char without_broadcast(char letter)
{
    return letter == 'v' ? 'V' : letter == 'u' ? 'U' : letter;
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
    operand->meaning =
        meaning_of(operand_meanings,
                   isupper((unsigned char)*operand->written)
                       ? without_broadcast(**letter) : **letter);
    return **letter != '\0';
}

static bool has_operand(const c205_insn *insn, const char *letters)
{
    return insn->operands[strcspn(insn->operands, letters)] != '\0';
}

static bool is_vector(const c205_insn *insn)
{
    return insn->unit == C205_UNIT_VECTOR && has_operand(insn, "vubdecx");
}

static bool must_have_control(const c205_insn *insn)
{
    return strchr(c205_format_syntax(insn->format), '!') != NULL;
}

/* Formats with a rule of their own. */
static const struct {
    c205_format format;
    const char *length, *clocked;
} lengths[] = {
    { C205_FORMAT_SCAN, "that of C; each element goes through all of B",
      "n elements of B gone through in all" },
    { C205_FORMAT_SPARSE,
      "that of X or Y, the longer; those of C and Z are set",
      "n the most elements present in A, B or C" },
};
enum { LENGTHS = sizeof lengths / sizeof *lengths };

const char *isa_clocked(const c205_insn *insn)
{
    for (size_t i = 0; i < LENGTHS; i++) {
        if (lengths[i].format == insn->format) {
            return lengths[i].clocked;
        }
    }
    return "";
}

const char *isa_length(const c205_insn *insn)
{
    if (!is_vector(insn)) {
        return "";
    }
    for (size_t i = 0; i < LENGTHS; i++) {
        if (lengths[i].format == insn->format) {
            return lengths[i].length;
        }
    }
    if (has_operand(insn, "c")) {
        return must_have_control(insn)
                   ? "that of Z; C's is set"
                   : "that of A, or of B if A is broadcast; C's is set";
    }
    if (has_operand(insn, "x")) {
        return has_operand(insn, "d")
                   ? "that of C, or of A if A is shorter"
                   : "that of A, or of B if A is broadcast";
    }
    if (has_operand(insn, "de")) {
        return strchr(c205_format_syntax(insn->format), 'C')
                   ? "that of C" : "that of T";
    }
    return has_operand(insn, "b") ? "that of R"
           : strchr(c205_format_syntax(insn->format), 'b')
               ? "that of A, or of B if A is broadcast"
               : "that of A";
}

/* Nothing can be short where the length is that of the one source. */
const char *isa_padding(const c205_insn *insn)
{
    bool sparse = insn->format == C205_FORMAT_SPARSE;
    if (insn->flags & C205_INSN_PADZ) {
        return sparse ? "continues with machine zeros, as for absent ones"
                      : "continues with machine zeros";
    }
    if (insn->flags & C205_INSN_PADO) {
        return "continues with normalised ones";
    }
    if (!has_operand(insn, "vub") || has_operand(insn, "xw")) {
        return "";
    }
    return has_operand(insn, "b") ? "continues with zero bits"
                                  : "continues with zero words";
}

const char *isa_control(const c205_insn *insn)
{
    if (!has_operand(insn, "z")) {
        return "";
    }
    if (must_have_control(insn)) {
        return "must be there: Z chooses, `? [z]` with its ones, `?! [z]` "
               "with its zeros";
    }
    return has_operand(insn, "w")
               ? "`? [z]`: only elements where Z has ones take part; "
                 "`?! [z]`: zeros"
               : "`? [z]`: C keeps what it had where Z has zeros; "
                 "`?! [z]`: where it has ones";
}

/* ---- Special values ----------------------------------------------------- */

/* By the stem of the mnemonic; the first that fits. */
static const struct {
    const char *stem, *text;
} specials[] = {
#define SUM_RULE \
    "indefinite in either: indefinite; machine zero is 0 with the smallest " \
    "exponent"
#define PRODUCT_RULE \
    "indefinite in either: indefinite; otherwise machine zero in either: " \
    "machine zero"
#define EXTREME_RULE \
    "any indefinite: indefinite with its index; of equals the first; no " \
    "elements: indefinite"
#define KEEP_RULE "machine zero and indefinite stay what they are"
    { "ADD", SUM_RULE },
    { "SUB", SUM_RULE },
    { "SUM", SUM_RULE "; no elements: machine zero" },
    { "AVG", SUM_RULE },
    { "ADJM", SUM_RULE },
    { "DELTA", SUM_RULE },
    { "INTVL", SUM_RULE },
    { "MPY", PRODUCT_RULE },
    { "PROD", PRODUCT_RULE "; no elements: one" },
    { "DOT", "products and sums as those of MPYS and ADDN; no elements: "
             "machine zero" },
    { "DIV", "indefinite in either: indefinite; divisor zero: indefinite, "
             "flag 41; otherwise dividend machine zero: machine zero" },
    { "SQRT", "indefinite: indefinite; zero: machine zero; negative: "
              "indefinite, flag 45" },
    { "TRU", KEEP_RULE },
    { "FLR", KEEP_RULE },
    { "ABS", KEEP_RULE },
    { "CLG", KEEP_RULE },
    { "VTOV", KEEP_RULE },
    { "ADJ", "machine zero and indefinite stay; a coefficient that does not "
             "fit: indefinite, flag 42" },
    { "POLY", "products and sums as those of MPYS and ADDN; no "
              "coefficients: machine zero" },
    { "EXP", "the exponent field of every word, no flags" },
    { "MAX", EXTREME_RULE },
    { "MIN", EXTREME_RULE },
    { "", "" },
};

static bool compares(const c205_insn *insn)
{
    return insn->unit == C205_UNIT_BRANCH
           || insn->timing == C205_TIMING_vcompare
           || insn->timing == C205_TIMING_vselect
           || insn->timing == C205_TIMING_vcompress;
}

const char *isa_specials(const c205_insn *insn)
{
    size_t i = 0;
    if (!has_operand(insn, "fv") && insn->format != C205_FORMAT_SPARSE) {
        return insn->unit == C205_UNIT_VECTOR && *insn->operands
                   ? "none: elements are bits, whatever they mean"
                   : "";
    }
    if (compares(insn)) {
        return "machine zero equals every zero; indefinite equals nothing, "
               "and is neither >= nor <";
    }
    while (strncmp(insn->mnemonic, specials[i].stem,
                   strlen(specials[i].stem)) != 0) {
        i++;
    }
    return specials[i].text;
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
    while (text->name && !names(text->name, insn->mnemonic)) {
        text++;
    }
    return text->lines;
}
