/* random_nest.h - random nests of directives of the scene language.
 *
 * A seed gives each list in one of two forms. The written form has #for, #while, #if,
 * #switch, #macro, #local and #break at every position. The expanded form is the result
 * of executing these directives. No choice depends on a value, so both forms make the
 * same choices. The body of a loop is generated once in the written form, and once for
 * each iteration in the expanded form, always from the same seed.
 */
#ifndef RANDOM_NEST_H
#define RANDOM_NEST_H

#include "base/sink.h"

#include <stdbool.h>
#include <stdint.h>

/* Returns the objects of a scene. The seed must not be 0. The caller frees the text. */
struct text_buffer random_nest(uint64_t seed, bool written);

#endif
