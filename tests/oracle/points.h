/* points.h - the random stream and the lattice of rt/kernels/points: as the texts
 * there define them, in the host's integers, and as the machine makes them.
 */
#ifndef TESTS_POINTS_H
#define TESTS_POINTS_H

#include "vm/c205.h"

#include <stddef.h>

/* ---- By the definition --------------------------------------------------- */

enum { STREAM_DRAWS = 5, LATTICE_COORDINATES = 6 };

/* a^p mod 2^47: the generator without its mixed output.  p >= 0. */
uint64_t stream_state_at(uint64_t p);
/* t of x. */
uint64_t stream_mixed(uint64_t x);
/* Of a draw, modulo 2^47. */
uint64_t stream_position(uint64_t seed, uint64_t ray, unsigned draw);
/* The integer in (0, 2^47) that a draw, 0 .. 4, of a ray is made of. */
uint64_t stream_word(uint64_t seed, uint64_t ray, unsigned draw);
/* The one of a coordinate, 0 .. 5, of point i of 2^m under a shift of a seed. */
uint64_t lattice_word(unsigned m, uint64_t seed, uint64_t shift, uint64_t i,
                      unsigned coordinate);

/* ---- By the machine ------------------------------------------------------ */

enum point_form { POINTS_SCALAR, POINTS_VECTOR, POINT_FORMS };

/* What points_scalar.s and points_vector.s make; 65,535 points at most. */
struct point_kind {
    enum point_form form;
    bool lattice;
    bool numbers; /* in (0, 1); else the integers that they are made of */
    size_t queue, points, coordinates; /* of the stream 5 */
};

/* Which points of the kind: m and shift are the lattice's alone. */
struct point_choice {
    uint64_t seed, first, m, shift;
};

struct point_maker;

/* NULL: the error says why. */
struct point_maker *point_maker_new(const struct point_kind *kind, c205_error *error);
void point_maker_free(struct point_maker *maker);
/* Coordinate j of all points from words + j points on. */
bool point_maker_run(struct point_maker *maker, const struct point_choice *choice,
                     c205_word *words, c205_error *error);
const struct object *point_maker_program(const struct point_maker *maker);
/* As it was before the next run, with the choice made: for who listens. */
c205 *point_maker_load(struct point_maker *maker, const struct point_choice *choice,
                       c205_error *error);

#endif
