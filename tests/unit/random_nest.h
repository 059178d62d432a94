/* random_nest.h - nests of directives of the scene language, at random.
 *
 * Each list is made from a seed in one of two ways: as it is written, with #for,
 * #while, #if, #switch, #macro, #local and #break at every place of it, or as it
 * is carried out, without any.  No choice depends on a value, so that both ways
 * choose the same; a loop's body is made once in the one way and once each turn
 * in the other, of one seed.
 */
#ifndef RANDOM_NEST_H
#define RANDOM_NEST_H

#include "base/sink.h"

#include <stdbool.h>
#include <stdint.h>

/* A scene's objects, from a seed that is not 0; the caller frees the text. */
struct text_buffer random_nest(uint64_t seed, bool written);

#endif
