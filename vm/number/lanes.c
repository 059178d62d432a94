/* lanes.c - arithmetic of words over spans (lanes.h). */
#include "vm/number/spans.h"

#include "vm/number/round_down.h"
#include "vm/number/lane.h"
#include "vm/number/fast_path.h"

/* Functions that compute a block if all of its words are of one kind and return false
 * otherwise. BLOCK_COMMON gives the function that an operation tries first. */
ROUND_DOWN_BLOCK(round_down_add_block, round_down_add)
ROUND_DOWN_BLOCK(round_down_subtract_block, round_down_subtract)
ROUND_DOWN_BLOCK(round_down_multiply_block, round_down_multiply)
ZEROS_BLOCK(zeros_add, GIVE_OTHERS, GIVE_OTHERS)
ZEROS_BLOCK(zeros_subtract, GIVE_NEITHER, GIVE_OTHERS)
ZEROS_BLOCK(zeros_multiply, GIVE_ZEROS, GIVE_ZEROS)
COMMON_BLOCK(common_multiply, common_multiply_significant)
EITHER_BLOCK(common_block_add_normalised, zeros_add, round_down_add_block)
EITHER_BLOCK(common_block_subtract_normalised, zeros_subtract,
             round_down_subtract_block)
EITHER_BLOCK(round_down_or_common_multiply, round_down_multiply_block, common_multiply)
EITHER_BLOCK(common_block_multiply_significant, zeros_multiply,
             round_down_or_common_multiply)
COMMON_BLOCK(common_block_divide_significant, common_divide_significant)
#define BLOCK_COMMON(name) common_block_##name
#define BLOCK_REGISTERS(name) NEVER_COMMON
#define BLOCK_VECTORS(name) NEVER_COMMON

/* On a host without vector units, an operation with a fast path runs it word by word.
 * kind is BINARY or UNARY. */
#define VERSIONS_COMMON(kind, name) \
    static kind##_WORDS(lanes_##name##_words, fast_##name) \
        kind##_VERSIONS(lanes_##name, lanes_##name##_words)
#define VERSIONS_REGISTERS(kind, name) \
    kind##_VERSIONS(lanes_##name, lanes_##name##_span)
#define VERSIONS_VECTORS(kind, name) VERSIONS_REGISTERS(kind, name)

#define BINARY_FAST(name, registers) \
    BINARY_SPAN(lanes_##name, BLOCK_##registers(name), lane_##name, arith_##name) \
    VERSIONS_##registers(BINARY, name)
#define BINARY_HALVES_FAST(name, registers) BINARY_EXACT(name, registers)
#define BINARY_EXACT(name, registers) BINARY_WORDS(lanes_##name, arith_##name)
#define UNARY_FAST(name, registers) \
    UNARY_SPAN(lanes_##name, lane_##name, arith_##name) \
    VERSIONS_##registers(UNARY, name)
/* spans.c defines the functions of these rows of arith.def, so they expand to
 * nothing. */
#define BINARY_WRITTEN(name, registers)
#define UNARY_WRITTEN(name, registers)

#define BINARY(name, spans, registers, specials) BINARY_##spans(name, registers)
#define UNARY(name, spans, registers, specials) UNARY_##spans(name, registers)
#include "vm/arith.def"
