/* lanes.c - the arithmetic of words over spans; see lanes.h for what they
 * promise.
 */
#include "vm/number/spans.h"

#include "vm/number/lane.h"

#define BINARY_FAST(name) BINARY_SPAN(lanes_##name, lane_##name, arith_##name)
#define BINARY_HALVES_FAST(name) BINARY_EXACT(name)
#define BINARY_EXACT(name) EXACT(lanes_##name, arith_##name)
#define UNARY_FAST(name) UNARY_SPAN(lanes_##name, lane_##name, arith_##name)
/* In spans.c. */
#define BINARY_WRITTEN(name)
#define UNARY_WRITTEN(name)

#define BINARY(name, spans, registers, specials) BINARY_##spans(name)
#define UNARY(name, spans, registers, specials) UNARY_##spans(name)
#include "vm/arith.def"
