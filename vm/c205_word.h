/* c205_word.h - errors, and words as numbers and instructions. */
#ifndef C205_API_WORD_H
#define C205_API_WORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct c205_error {
    char message[256]; /* one sentence, no newline; empty: no error */
} c205_error;

/* ---- Numbers (vm/number/word.c, decimal.c) ---------------------------------
 *
 * A word is 64 bits; bit 0 is the leftmost. As a number it is
 *
 *   | exponent 16, two's complement | coefficient 48, two's complement |
 *
 * with the value coefficient x 2^exponent. Exponents 8000-8FFF hex mark a machine zero,
 * 7000-7FFF an indefinite. See docs/machine.md.
 */
typedef uint64_t c205_word;

#define C205_MACHINE_ZERO UINT64_C(0x8000000000000000)
#define C205_INDEFINITE UINT64_C(0x7000000000000000)
#define C205_ONE UINT64_C(0xFFD2400000000000)

/* Returns a double, rounded down to a normalised word. The result is exact if 47 bits
 * hold the value. It is indefinite for infinity, NaN and values that are too large, and
 * machine zero for zero and values that are too small. */
c205_word c205_from_double(double value);

/* Returns the value of a word. It is exact if it is within the range of a double.
 * Values beyond the range become an infinity or a zero with the same sign. Indefinite
 * gives NaN. */
double c205_to_double(c205_word word);

/* Returns an integer, -2^47 .. 2^47-1, as a word with exponent 0. */
c205_word c205_from_integer(int64_t value);
/* Returns the low 48 bits of a word, sign extended. */
int64_t c205_to_integer(c205_word word);
/* Return the parts of a vector descriptor: the bit address (the low 48 bits) and the
 * length in elements (the high 16 bits). */
uint64_t c205_descriptor_address(c205_word descriptor);
size_t c205_descriptor_length(c205_word descriptor);

/* Reads decimal text ("-12.5e-3") of any length. Returns its exact value, rounded down
 * to a normalised word. Sets *end to the first unused character; *end equals text if
 * there is no number. */
c205_word c205_from_text(const char *text, const char **end);

enum { C205_TEXT_SIZE = 40 };
/* Writes the shortest decimal text that c205_from_text reads back as the same value,
 * "indefinite" for an indefinite, and "0" for every zero. */
void c205_to_text(c205_word word, char text[C205_TEXT_SIZE]);
/* The notations of c205_to_decimal, which rounds a word to the nearest decimal, ties to
 * even. FIXED has the given number of digits after the point. SCIENTIFIC has the given
 * number of digits in total, with one before the point, followed by e and the power of
 * ten. A FIXED number of more than C205_DIGITS digits is written in scientific notation
 * with the given number of digits after the point. */
typedef enum c205_notation { C205_FIXED, C205_SCIENTIFIC } c205_notation;
enum { C205_DIGITS = 17 };
void c205_to_decimal(c205_word word, c205_notation notation, unsigned digits,
                     char text[C205_TEXT_SIZE]);
/* Writes a word as in "FFD2 4000 0000 0000". */
void c205_to_hex(c205_word word, char text[C205_TEXT_SIZE]);

/* ---- Half words (vm/number/word.c, decimal.c) ------------------------------
 *
 * A half word is 32 bits:
 *
 *   | exponent 8, two's complement | coefficient 24, two's complement |
 *
 * Exponents 80-8F hex mark a machine zero, 70-7F an indefinite. In this API a half word
 * is always at the left of a c205_word, followed by zeros, so C205_MACHINE_ZERO and
 * C205_INDEFINITE are valid for both sizes.
 */
#define C205_HALF_ONE UINT64_C(0xEA40000000000000)

/* Convert half words like the functions for words. A half word holds 23 bits of the
 * value. */
c205_word c205_half_from_double(double value);
double c205_half_to_double(c205_word half);
c205_word c205_half_from_text(const char *text, const char **end);
void c205_half_to_text(c205_word half, char text[C205_TEXT_SIZE]);

/* ---- Instructions (vm/insn.c, from vm/insn.def, vm/arith.def) ------------ */

typedef enum c205_format {
#define FORMAT(name, halves, syntax) C205_FORMAT_##name,
#include "insn.def"
    C205_FORMATS
} c205_format;

typedef enum c205_unit {
    C205_UNIT_SINGLE,
    C205_UNIT_ADD,
    C205_UNIT_MULTIPLY,
    C205_UNIT_DIVIDE,
    C205_UNIT_LOGICAL,
    C205_UNIT_MEMORY,
    C205_UNIT_BRANCH,
    C205_UNIT_VECTOR, /* the whole unit; its parts follow */
    C205_UNIT_V_ADD,
    C205_UNIT_V_MULTIPLY,
    C205_UNIT_V_DIVIDE,
    C205_UNIT_V_SHIFT,
    C205_UNIT_V_LOGICAL,
    C205_UNITS
} c205_unit;

typedef enum c205_timing {
#define TIMING(name, kind) C205_TIMING_##name,
#include "insn.def"
    C205_TIMINGS
} c205_timing;

/* The operation of an instruction on its operands, or on each element of vectors. */
typedef enum c205_operation {
#define OPERATION(name, specials) C205_OPERATION_##name,
#include "arith.def"
    C205_OPERATIONS
} c205_operation;

/* Bits of c205_insn.flags, which insn.def describes. */
#define C205_INSN_SIGN 1u
#define C205_INSN_PADZ 2u
#define C205_INSN_PADO 4u
#define C205_INSN_HALF 8u

/* Bits of the G byte, as values of that byte. */
#define C205_G_HALF 0x80u   /* 32-bit operands */
#define C205_G_ZEROS 0x40u  /* a one bit of the control vector blocks its element */
#define C205_G_OFFSET 0x20u /* C+1 holds the offset of C and Z */
#define C205_G_GIVEN 0x20u  /* sparse instructions: Z is an input */
#define C205_G_BROADCAST_A 0x10u
#define C205_G_BROADCAST_B 0x08u
#define C205_G_MAGNITUDE_A 0x04u
#define C205_G_NEGATE_A 0x02u /* -A, or -|A| if C205_G_MAGNITUDE_A is set */
#define C205_G_MAGNITUDE_B 0x01u
#define C205_G_RELATIVE 0x40u /* branches B0-B5 */

typedef struct c205_insn {
    const char *mnemonic;
    uint8_t opcode;
    uint8_t subop;      /* fixed bits of G */
    uint8_t subop_mask; /* mask of the fixed bits of G */
    uint8_t flags;
    c205_format format;
    c205_unit unit;
    c205_timing timing;
    c205_operation operation;
    const char *operands; /* a letter for each operand; see insn.def */
    const char *effect;
    char provenance;
} c205_insn;

extern const c205_insn c205_insns[]; /* in the order of the table */
extern const size_t c205_insn_count;

/* Returns the instruction with a mnemonic in upper or lower case, or NULL. */
const c205_insn *c205_insn_named(const char *mnemonic, size_t length);
/* Returns the instruction with an operation code; g is the second byte of the word.
 * NULL: undefined. */
const c205_insn *c205_insn_coded(uint8_t opcode, uint8_t g);

/* Return the name of a format, the syntax of its operands, and the length of its
 * instructions in half words. */
const char *c205_format_name(c205_format format);
const char *c205_format_syntax(c205_format format);
unsigned c205_format_halves(c205_format format);
const char *c205_unit_name(c205_unit unit);
bool c205_unit_is_vector(c205_unit unit);
/* Returns true if the instructions of this unit can be linked. */
bool c205_unit_links(c205_unit unit);
const char *c205_timing_name(c205_timing timing);
bool c205_timing_is_vector(c205_timing timing);
/* Returns a sentence on the treatment of machine zeros and indefinites. */
const char *c205_operation_specials(c205_operation operation);
/* Returns the floating-point operations per element of an operation. */
unsigned c205_operation_flops(c205_operation operation);

/* The fields of an instruction by name: F, G, X, A, Y, B, Z and C of the long formats,
 * F, R, S and T of the short formats. Their positions in the word depend on the
 * format. */
typedef struct c205_fields {
    uint8_t f, g, x, a, y, b, z, c; /* VECTOR and similar formats, INDEX, FLOAT */
    uint8_t r, s, t;                /* register formats */
    int64_t immediate;              /* I8 .. I48, or the distance of a branch in half
                                       words */
} c205_fields;

/* Decode and encode an instruction. A short instruction is in the high half of the
 * word. The functions check nothing. encode inserts every field of the format; decode
 * sets missing fields to zero. */
c205_fields c205_decode(const c205_insn *insn, c205_word word);
c205_word c205_encode(const c205_insn *insn, const c205_fields *fields);

#endif
