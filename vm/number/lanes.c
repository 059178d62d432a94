/* lanes.c - the arithmetic of words over spans; see lanes.h for what they
 * promise.
 */
#include "vm/number/spans.h"

#include "vm/number/lane.h"

#define BINARY(name) BINARY_SPAN(lanes_##name, lane_##name, arith_##name)
#define UNARY(name) UNARY_SPAN(lanes_##name, lane_##name, arith_##name)

BINARY(add_upper)
BINARY(add_normalised)
BINARY(subtract_upper)
BINARY(subtract_normalised)
BINARY(average)
BINARY(average_difference)
BINARY(multiply_upper)
BINARY(multiply_significant)
BINARY(divide_significant)
EXACT(lanes_add_lower, arith_add_lower)
EXACT(lanes_subtract_lower, arith_subtract_lower)
EXACT(lanes_multiply_lower, arith_multiply_lower)
EXACT(lanes_divide_upper, arith_divide_upper)
EXACT(lanes_adjust_significance, arith_adjust_significance)
EXACT(lanes_adjust_exponent, arith_adjust_exponent)
UNARY(square_root)
UNARY(truncate)
UNARY(floor)
UNARY(ceiling)
UNARY(absolute)
UNARY(negate)
