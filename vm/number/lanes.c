/* lanes.c - the arithmetic of words over spans; see lanes.h for what they
 * promise.
 */
#include "vm/number/spans.h"

#include "vm/number/lane.h"
#include "vm/number/quick.h"

/* What has a quick rule also looks for blocks of one kind. */
ZEROS_BLOCK(usual_block_add_normalised, GIVE_OTHERS, GIVE_OTHERS)
ZEROS_BLOCK(usual_block_subtract_normalised, GIVE_NEITHER, GIVE_OTHERS)
USUAL_BLOCK(usual_block_multiply_significant, usual_multiply_significant,
            GIVE_ZEROS, GIVE_ZEROS)
USUAL_BLOCK(usual_block_divide_significant, usual_divide_significant,
            GIVE_NEITHER, GIVE_NEITHER)
#define BLOCK_QUICK(name) usual_block_##name
#define BLOCK_REGISTERS(name) NEVER_USUAL
#define BLOCK_VECTORS(name) NEVER_USUAL

/* Where the host has no vectors, it goes by that rule. */
#define BINARY_QUICK(name) \
    static BINARY_WORDS(lanes_##name##_words, quick_##name) \
        BINARY_VERSIONS(lanes_##name, lanes_##name##_words)
#define BINARY_REGISTERS(name) \
    BINARY_VERSIONS(lanes_##name, lanes_##name##_span)
#define BINARY_VECTORS(name) BINARY_REGISTERS(name)
#define UNARY_QUICK(name) \
    static UNARY_WORDS(lanes_##name##_words, quick_##name) \
        UNARY_VERSIONS(lanes_##name, lanes_##name##_words)
#define UNARY_REGISTERS(name) \
    UNARY_VERSIONS(lanes_##name, lanes_##name##_span)
#define UNARY_VECTORS(name) UNARY_REGISTERS(name)

#define BINARY_FAST(name, registers) \
    BINARY_SPAN(lanes_##name, BLOCK_##registers(name), lane_##name, \
                arith_##name) \
    BINARY_##registers(name)
#define BINARY_HALVES_FAST(name, registers) BINARY_EXACT(name, registers)
#define BINARY_EXACT(name, registers) BINARY_WORDS(lanes_##name, arith_##name)
#define UNARY_FAST(name, registers) \
    UNARY_SPAN(lanes_##name, lane_##name, arith_##name) \
    UNARY_##registers(name)
/* In spans.c. */
#define BINARY_WRITTEN(name, registers)
#define UNARY_WRITTEN(name, registers)

#define BINARY(name, spans, registers, specials) \
    BINARY_##spans(name, registers)
#define UNARY(name, spans, registers, specials) UNARY_##spans(name, registers)
#include "vm/arith.def"
