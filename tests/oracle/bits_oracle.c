/* bits_oracle.c - the rules of operations on words as bit strings: shifts, logical
 * operations, pack, sums of indices. */
#include "arithmetic_oracle.h"

/* Returns bit i of a word. Bit 0 is the leftmost bit. */
static c205_word bit(c205_word word, long i)
{
    return word >> (63 - i) & 1;
}

/* Returns a word with the exponent field of `high` and the coefficient of `low`. */
static c205_word join(const struct oracle_format *format, c205_word high, c205_word low)
{
    long middle = format->width - format->digits - 1;
    c205_word word = 0;
    for (long i = 0; i < 64; i++) {
        c205_word from = i < middle ? high : low;
        word = word << 1 | (i < format->width ? bit(from, i) : 0);
    }
    return word;
}

/* Moves the low bits of a number to the left bits of a word of the format. */
static c205_word justified(const struct oracle_format *format, c205_word number)
{
    return number << (64 - format->width);
}

static c205_word as_number(const struct oracle_format *format, c205_word word)
{
    return word >> (64 - format->width);
}

ORACLE_RULE(pack)
{
    c205_word exponent = as_number(format, a) << (format->digits + 1);
    return join(format, justified(format, exponent), b);
}

ORACLE_RULE(add_index)
{
    return join(format, a,
                justified(format, as_number(format, a) + as_number(format, b)));
}

ORACLE_RULE(subtract_index)
{
    return join(format, a,
                justified(format, as_number(format, a) - as_number(format, b)));
}

/* Returns the coefficient field as a two's complement integer. */
static long as_integer(const struct oracle_format *format, c205_word word)
{
    long first = format->width - format->digits - 1;
    long integer = -(long)bit(word, first);
    for (long i = first + 1; i < format->width; i++)
        integer = 2 * integer + (long)bit(word, i);
    return integer;
}

ORACLE_RULE(shift)
{
    long width = format->width;
    long count = as_integer(format, b);
    c205_word shifted = 0;
    for (long i = 0; i < width; i++) {
        long from = count >= 0      ? (i + count % width) % width
                    : i + count < 0 ? 0
                                    : i + count;
        shifted = shifted << 1 | bit(a, from);
    }
    return justified(format, shifted);
}

/* Computes each bit of the result as truth[a][b] of the bits a and b. */
static c205_word bitwise(const struct oracle_format *format, c205_word a, c205_word b,
                         const unsigned truth[2][2])
{
    c205_word result = 0;
    for (long i = 0; i < format->width; i++)
        result = result << 1 | truth[bit(a, i)][bit(b, i)];
    return justified(format, result);
}

#define LOGICAL(name, of00, of01, of10, of11) \
    ORACLE_RULE(name) \
    { \
        static const unsigned truth[2][2] = { { of00, of01 }, { of10, of11 } }; \
        return bitwise(format, a, b, truth); \
    }

LOGICAL(xor, 0, 1, 1, 0)
LOGICAL(and, 0, 0, 0, 1)
LOGICAL(or, 0, 1, 1, 1)
LOGICAL(nand, 1, 1, 1, 0)
LOGICAL(nor, 1, 0, 0, 0)
LOGICAL(or_not, 1, 0, 1, 1)
LOGICAL(and_not, 0, 0, 1, 0)
LOGICAL(equivalence, 1, 0, 0, 1)
LOGICAL(copy, 0, 0, 1, 1)
