/* placed_solid.h - one random thing, about a place: a shape, or a tree of a
 * few, and what it is made of.  All from a state, which is never 0. */
#ifndef PLACED_SOLID_H
#define PLACED_SOLID_H

#include "tests/oracle/solid_text.h"

#include <stdbool.h>
#include <stdint.h>

/* About where a thing is, and how far it reaches. */
struct place {
    double at[3], size;
    bool whole; /* parts are moved by whole quarters of it */
};

/* To what is short to write, and differs in ends of what is tiny. */
void place_make_short(struct place *place);

/* Of what a scene's things are made. */
enum mood { DULL, MIXED, CLEAR, MOODS };

/* A shape or, if depth is not 0, perhaps a tree so deep; the caller frees it. */
struct solid *solid_at(uint64_t *state, const struct place *place, enum mood mood,
                       int depth);
/* Open, or a body. */
struct solid *mesh_at(uint64_t *state, const struct place *place);
/* A shape that no bound can hold. */
struct solid *endless_at(uint64_t *state, const struct place *place);

/* Pigment, finish and so on, to SOLID_WORDS characters. */
void random_look(uint64_t *state, enum mood mood, char *look);
enum solid_joining random_joining(uint64_t *state);

#endif
