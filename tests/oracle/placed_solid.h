/* placed_solid.h - random objects at a place: a shape or a small CSG tree, with its
 * finish. All random numbers come from a state, which is never 0. */
#ifndef PLACED_SOLID_H
#define PLACED_SOLID_H

#include "tests/oracle/solid_text.h"

#include <stdbool.h>
#include <stdint.h>

/* The position of an object and its approximate size. */
struct place {
    double at[3], size;
    bool whole; /* children are moved by multiples of a quarter of the size */
};

/* Rounds a place to few digits, so that its text is short. The coordinates of tiny
 * objects still differ in their last digits. */
void place_make_short(struct place *place);

/* The finishes of the objects of a scene. */
enum mood { DULL, MIXED, CLEAR, MOODS };

/* Returns a shape, or a tree of at most this depth. The caller frees it. */
struct solid *solid_at(uint64_t *state, const struct place *place, enum mood mood,
                       int depth);
/* Returns an open or a closed mesh. */
struct solid *mesh_at(uint64_t *state, const struct place *place);
/* Returns an unbounded shape. */
struct solid *endless_at(uint64_t *state, const struct place *place);

/* Writes a pigment, a finish and so on. The text has at most SOLID_WORDS characters. */
void random_look(uint64_t *state, enum mood mood, char *look);
enum solid_joining random_joining(uint64_t *state);

#endif
