/* pairs.c - executes two arithmetic operations in one pass (pairs.h). */
#include "vm/number/pairs.h"

#include "vm/number/round_down.h"
#include "vm/number/spans.h"

/* ---- Blocks -------------------------------------------------------------- */

/* Names the operand of the first operation that is the same word for all lanes. */
enum constants { NO_CONSTANT, CONSTANT_A, CONSTANT_B };

#define PAIR_BLOCK(name, first, second) \
    LANEWISE bool name##_block(c205_word *restrict to, const c205_word *a, \
                               const c205_word *b, const c205_word *d, size_t n, \
                               uint64_t *flags, enum constants constants) \
    { \
        c205_word constant_a = a[0], constant_b = b[0]; \
        round_down_block block = round_down_begin; \
        host_rounding before; \
        if (!host_round_down(&before)) \
            return false; \
        EACH_LANE({ \
            c205_word x = constants == CONSTANT_A ? constant_a : a[j]; \
            c205_word y = constants == CONSTANT_B ? constant_b : b[j]; \
            take_edges(&block, x, y); \
            take_edges(&block, d[j], d[j]); \
            double handed = round_down_value( \
                take_result(&block, first(moderate_value(x), moderate_value(y)))); \
            double other = moderate_value(d[j]); \
            to[j] = result_word(take_result(&block, second)); \
        }); \
        host_round_as(before); \
        return round_down_end(&block, flags); \
    }

/* ---- Spans --------------------------------------------------------------- */

#define PAIR_PARAMETERS \
    (bool *done, c205_word *c, pair_operand a, pair_operand b, const c205_word *d, \
     size_t n, uint64_t *flags)
#define PAIR_ARGUMENTS (done, c, a, b, d, n, flags)

/* Tests the first words only, because a span that contains a word that is not moderate
 * usually begins with one. Two constant operands are rare and not supported. */
static inline bool may_be_done(pair_operand a, pair_operand b, const c205_word *d,
                               size_t n)
{
    return n >= MIN_ROUND_DOWN && n <= PAIR_LENGTH && !(a.is_constant && b.is_constant)
           && moderate_pair(a.words[0], b.words[0]) && moderate_pair(d[0], d[0]);
}

static inline bool pair_meets(const c205_word *c, pair_operand operand, size_t n)
{
    return !operand.is_constant && spans_meet(c, operand.words, n);
}

#define PAIR_SPAN(name) \
    LANEWISE void name##_span PAIR_PARAMETERS \
    { \
        c205_word space[PAIR_LENGTH]; \
        bool apart = !pair_meets(c, a, n) && !pair_meets(c, b, n) \
                     && !spans_meet(c, d, n); \
        c205_word *to = apart ? c : space; \
        if (!may_be_done(a, b, d, n)) \
            *done = false; \
        else if (a.is_constant) \
            *done = name##_block(to, a.words, b.words, d, n, flags, CONSTANT_A); \
        else if (b.is_constant) \
            *done = name##_block(to, a.words, b.words, d, n, flags, CONSTANT_B); \
        else \
            *done = name##_block(to, a.words, b.words, d, n, flags, NO_CONSTANT); \
        if (*done && !apart) \
            copy_block(c, space, n); \
    }

/* `second` is an expression in `handed`, the result of the first operation, and
 * `other`, the other source of the second operation. */
#define PAIR(name, first, second) \
    PAIR_BLOCK(name, first, second) \
    PAIR_SPAN(name) \
    static lanes_pair name; \
    VERSIONS(name, name##_span, PAIR_PARAMETERS, PAIR_ARGUMENTS)

PAIR(multiply_add, round_down_multiply, round_down_add(handed, other))
PAIR(multiply_subtract, round_down_multiply, round_down_subtract(handed, other))
PAIR(subtract_product, round_down_multiply, round_down_subtract(other, handed))
PAIR(add_multiply, round_down_add, round_down_multiply(handed, other))
PAIR(subtract_multiply, round_down_subtract, round_down_multiply(handed, other))

/* ---- Choice of the function --------------------------------------------- */

lanes_pair *lanes_pair_of(lanes_binary *first, lanes_binary *second, bool hands_a,
                          bool hands_b)
{
    if (hands_a == hands_b)
        return NULL;
    if (second == lanes_multiply_significant)
        return first == lanes_add_normalised        ? add_multiply
               : first == lanes_subtract_normalised ? subtract_multiply
                                                    : NULL;
    if (first != lanes_multiply_significant)
        return NULL;
    if (second == lanes_add_normalised)
        return multiply_add;
    if (second == lanes_subtract_normalised)
        return hands_a ? multiply_subtract : subtract_product;
    return NULL;
}
