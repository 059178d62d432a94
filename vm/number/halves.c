/* halves.c - the arithmetic of half words over spans, and the way between
 * the sizes; see lanes.h for what they promise.
 */
#include "vm/number/spans.h"

#include "vm/number/half_lane.h"

#define BINARY(name) BINARY_SPAN(halves_##name, lane_##name, half_##name)
#define UNARY(name) UNARY_SPAN(halves_##name, lane_##name, half_##name)
#define CONVERSION(name) UNARY_SPAN(lanes_##name, lane_##name, arith_##name)

BINARY(add_upper)
BINARY(add_lower)
BINARY(add_normalised)
BINARY(subtract_upper)
BINARY(subtract_lower)
BINARY(subtract_normalised)
BINARY(average)
BINARY(average_difference)
BINARY(multiply_upper)
BINARY(multiply_lower)
BINARY(multiply_significant)
BINARY(divide_upper)
BINARY(divide_significant)
EXACT(halves_adjust_significance, half_adjust_significance)
EXACT(halves_adjust_exponent, half_adjust_exponent)
UNARY(square_root)
UNARY(truncate)
UNARY(floor)
UNARY(ceiling)
UNARY(absolute)
UNARY(negate)
CONVERSION(contract)
CONVERSION(contract_rounded)
CONVERSION(extend)
