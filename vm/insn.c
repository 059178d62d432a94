/* insn.c - expands the instruction table, and decodes and encodes instruction words. */
#include "vm/c205.h"

#include <string.h>

/* Short names of the instruction flags, for the rows of insn.def. */
enum {
    SIGN = C205_INSN_SIGN,
    PADZ = C205_INSN_PADZ,
    PADO = C205_INSN_PADO,
    HALF = C205_INSN_HALF
};

const c205_insn c205_insns[] = {
/* clang-format off */
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, \
             flags, semantics, operation, provenance, effect) \
    { #mnemonic, opcode, subop, mask, flags, C205_FORMAT_##format, \
      C205_UNIT_##unit, C205_TIMING_##timing, C205_OPERATION_##operation, \
      operands, effect, provenance },
/* clang-format on */
#include "vm/insn.def"
};
const size_t c205_insn_count = sizeof c205_insns / sizeof c205_insns[0];

static const struct {
    const char *name, *syntax;
    unsigned halves;
} formats[C205_FORMATS] = {
#define FORMAT(name, halves, syntax) { #name, syntax, halves },
#include "vm/insn.def"
};

enum timing_kind { SCALAR, VECTOR };
static const struct {
    const char *name;
    enum timing_kind kind;
} timings[C205_TIMINGS] = {
#define TIMING(name, kind) { #name, kind },
#include "vm/insn.def"
};

enum {
#define SPECIALS(rule, flops, text) SPECIALS_##rule,
#include "vm/arith.def"
    SPECIALS_RULES
};

static const char *const specials_texts[SPECIALS_RULES] = {
#define SPECIALS(rule, flops, text) text,
#include "vm/arith.def"
};

static const uint8_t specials_flops[SPECIALS_RULES] = {
#define SPECIALS(rule, flops, text) flops,
#include "vm/arith.def"
};

/* The rule for special values in each operation. */
static const uint8_t specials[C205_OPERATIONS] = {
#define OPERATION(name, specials) SPECIALS_##specials,
#include "vm/arith.def"
};

static const char *const unit_names[C205_UNITS] = {
    [C205_UNIT_SINGLE] = "single",           [C205_UNIT_ADD] = "add",
    [C205_UNIT_MULTIPLY] = "multiply",       [C205_UNIT_DIVIDE] = "divide",
    [C205_UNIT_LOGICAL] = "logical",         [C205_UNIT_MEMORY] = "memory",
    [C205_UNIT_BRANCH] = "branch",           [C205_UNIT_VECTOR] = "vector",
    [C205_UNIT_V_ADD] = "vector add",        [C205_UNIT_V_MULTIPLY] = "vector multiply",
    [C205_UNIT_V_DIVIDE] = "vector divide",  [C205_UNIT_V_SHIFT] = "vector shift",
    [C205_UNIT_V_LOGICAL] = "vector logical"
};

const char *c205_format_name(c205_format format)
{
    return formats[format].name;
}

const char *c205_format_syntax(c205_format format)
{
    return formats[format].syntax;
}

unsigned c205_format_halves(c205_format format)
{
    return formats[format].halves;
}

const char *c205_unit_name(c205_unit unit)
{
    return unit_names[unit];
}

bool c205_unit_is_vector(c205_unit unit)
{
    return unit >= C205_UNIT_VECTOR;
}

bool c205_unit_links(c205_unit unit)
{
    return unit > C205_UNIT_VECTOR;
}

const char *c205_timing_name(c205_timing timing)
{
    return timings[timing].name;
}

const char *c205_operation_specials(c205_operation operation)
{
    return specials_texts[specials[operation]];
}

unsigned c205_operation_flops(c205_operation operation)
{
    return specials_flops[specials[operation]];
}

bool c205_timing_is_vector(c205_timing timing)
{
    return timings[timing].kind == VECTOR;
}

static char upper_case(char c)
{
    return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c;
}

static bool same_name(const char *name, const char *text, size_t length)
{
    size_t i = 0;
    while (i < length && name[i] && name[i] == upper_case(text[i]))
        i++;
    return i == length && !name[i];
}

const c205_insn *c205_insn_named(const char *mnemonic, size_t length)
{
    char first = length ? upper_case(*mnemonic) : 0;
    for (size_t i = 0; i < c205_insn_count; i++)
        if (*c205_insns[i].mnemonic == first
            && same_name(c205_insns[i].mnemonic, mnemonic, length))
            return &c205_insns[i];
    return NULL;
}

const c205_insn *c205_insn_coded(uint8_t opcode, uint8_t g)
{
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        if (insn->opcode == opcode && (g & insn->subop_mask) == insn->subop)
            return insn;
    }
    return NULL;
}

/* ---- Positions of the fields -------------------------------------------- */

/* The byte fields: letter, distance in bits from the right end of the word, and offset
 * in c205_fields. */
static const struct field_place {
    char letter;
    unsigned shift;
    size_t offset;
} places[] = {
    { 'g', 48, offsetof(c205_fields, g) }, { 'x', 40, offsetof(c205_fields, x) },
    { 'a', 32, offsetof(c205_fields, a) }, { 'y', 24, offsetof(c205_fields, y) },
    { 'b', 16, offsetof(c205_fields, b) }, { 'z', 8, offsetof(c205_fields, z) },
    { 'c', 0, offsetof(c205_fields, c) },  { 'r', 48, offsetof(c205_fields, r) },
    { 's', 40, offsetof(c205_fields, s) }, { 't', 32, offsetof(c205_fields, t) },
};
enum { PLACES = sizeof places / sizeof places[0], OPCODE_SHIFT = 56 };

enum immediate { NO_IMMEDIATE, SIGNED, UNSIGNED, IF_RELATIVE };

/* The byte fields and the immediate of each format. A branch with C205_G_RELATIVE has a
 * signed immediate in the place of Y and B. */
static const struct format_layout {
    const char *letters;
    enum immediate immediate;
    unsigned shift, width;
} layouts[C205_FORMATS] = { [C205_FORMAT_NONE] = { "", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_RST] = { "rst", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_RT] = { "rt", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_R] = { "r", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_T] = { "t", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_MEMORY] = { "rst", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_COMPARE] = { "rst", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_CALL] = { "rst", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SWAP] = { "rst", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_REQUEST] = { "rs", UNSIGNED, 32, 8 },
                            [C205_FORMAT_SHIFT] = { "rt", SIGNED, 40, 8 },
                            [C205_FORMAT_BITS1] = { "rt", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_REPEAT] = { "rst", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_I16] = { "r", SIGNED, 32, 16 },
                            [C205_FORMAT_I24] = { "r", SIGNED, 24, 24 },
                            [C205_FORMAT_I48] = { "r", SIGNED, 0, 48 },
                            [C205_FORMAT_JUMP] = { "r", UNSIGNED, 0, 48 },
                            [C205_FORMAT_INDEX] = { "gxaybzc", IF_RELATIVE, 16, 16 },
                            [C205_FORMAT_FLOAT] = { "gaybz", IF_RELATIVE, 16, 16 },
                            [C205_FORMAT_ALTER] = { "abc", UNSIGNED, 48, 4 },
                            [C205_FORMAT_ALTERB] = { "abc", UNSIGNED, 48, 4 },
                            [C205_FORMAT_ALTERF] = { "ac", UNSIGNED, 48, 4 },
                            [C205_FORMAT_VECTOR] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_UNARY] = { "gxazc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_REDUCE2] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_REDUCE] = { "gxazc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_EXTREME] = { "gxabzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SCALARS] = { "gabzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SELECTED] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SQUEEZE] = { "gxazc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SIEVE] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SPARSE] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_TABLE] = { "gxabzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SPREAD] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_PERIODIC] = { "gabzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SPACED] = { "gaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_STRING] = { "gxaybc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SCAN] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SELECTEDB] = { "gxaybzc", NO_IMMEDIATE, 0, 0 },
                            [C205_FORMAT_SQUEEZEB] = { "gxazc", NO_IMMEDIATE, 0, 0 } };

static bool has_immediate(const struct format_layout *layout, uint8_t g)
{
    if (layout->immediate == IF_RELATIVE)
        return g & C205_G_RELATIVE;
    return layout->immediate != NO_IMMEDIATE;
}

static uint64_t immediate_mask(const struct format_layout *layout)
{
    return (UINT64_C(1) << layout->width) - 1;
}

static int64_t take_immediate(const struct format_layout *layout, c205_word word)
{
    uint64_t bits = word >> layout->shift & immediate_mask(layout);
    uint64_t sign = UINT64_C(1) << (layout->width - 1);
    if (layout->immediate == UNSIGNED || !(bits & sign))
        return (int64_t)bits;
    return (int64_t)(bits ^ sign) - (int64_t)sign;
}

c205_fields c205_decode(const c205_insn *insn, c205_word word)
{
    const struct format_layout *layout = &layouts[insn->format];
    c205_fields fields;
    memset(&fields, 0, sizeof fields);
    fields.f = (uint8_t)(word >> OPCODE_SHIFT);
    for (size_t i = 0; i < PLACES; i++)
        if (strchr(layout->letters, places[i].letter))
            ((uint8_t *)&fields)[places[i].offset] = (uint8_t)(word >> places[i].shift);
    if (has_immediate(layout, fields.g))
        fields.immediate = take_immediate(layout, word);
    return fields;
}

c205_word c205_encode(const c205_insn *insn, const c205_fields *fields)
{
    const struct format_layout *layout = &layouts[insn->format];
    const uint8_t *bytes = (const uint8_t *)fields;
    c205_word word = (c205_word)insn->opcode << OPCODE_SHIFT;
    for (size_t i = 0; i < PLACES; i++)
        if (strchr(layout->letters, places[i].letter))
            word |= (c205_word)bytes[places[i].offset] << places[i].shift;
    if (has_immediate(layout, fields->g)) {
        uint64_t mask = immediate_mask(layout);
        word &= ~(mask << layout->shift);
        word |= ((uint64_t)fields->immediate & mask) << layout->shift;
    }
    if (insn->subop_mask)
        word |= (c205_word)insn->subop << places[0].shift;
    return word;
}
