/* halves.c - arithmetic of half words over spans, and conversion between words and half
 * words (lanes.h).
 */
#include "vm/number/spans.h"

#include "vm/number/half_lane.h"

#define BINARY_FAST(name) \
    BINARY_SPAN(halves_##name, NEVER_COMMON, lane_##name, half_##name) \
    BINARY_VERSIONS(halves_##name, halves_##name##_span)
#define BINARY_HALVES_FAST(name) BINARY_FAST(name)
#define BINARY_EXACT(name) BINARY_WORDS(halves_##name, half_##name)
#define UNARY_FAST(name) \
    UNARY_SPAN(halves_##name, lane_##name, half_##name) \
    UNARY_VERSIONS(halves_##name, halves_##name##_span)
/* spans.c defines the functions of these rows of arith.def, so they expand to
 * nothing. */
#define BINARY_WRITTEN(name)
#define UNARY_WRITTEN(name)

#define BINARY(name, spans, registers, specials) BINARY_##spans(name)
#define UNARY(name, spans, registers, specials) UNARY_##spans(name)
#define CONVERSION(name, ...) \
    UNARY_SPAN(lanes_##name, lane_##name, arith_##name) \
    UNARY_VERSIONS(lanes_##name, lanes_##name##_span)
#include "vm/arith.def"
