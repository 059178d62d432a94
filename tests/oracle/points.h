/* points.h - the random stream and the lattice of rt/kernels/points. They are computed
 * in two ways: from their definitions, in the host's integers, and by the machine. */
#ifndef TESTS_POINTS_H
#define TESTS_POINTS_H

#include "vm/c205.h"

#include <stddef.h>

/* ---- By the definition --------------------------------------------------- */

enum { STREAM_DRAWS = 5, LATTICE_COORDINATES = 6 };

/* Returns a^p mod 2^47, the state before the output function, for p >= 0. */
uint64_t stream_state_at(uint64_t p);
/* Returns t(x), the output function of the random stream (docs/points.md). */
uint64_t stream_mixed(uint64_t x);
/* Returns the position of a random number in the stream, modulo 2^47. */
uint64_t stream_position(uint64_t seed, uint64_t ray, unsigned draw);
/* Returns a random number of a ray as an integer in (0, 2^47). draw is from 0 to 4. */
uint64_t stream_word(uint64_t seed, uint64_t ray, unsigned draw);
/* Returns a coordinate of point i of the 2^m lattice points, as an integer. The
 * coordinates are 0 to 5. The shift depends on the seed. */
uint64_t lattice_word(unsigned m, uint64_t seed, uint64_t shift, uint64_t i,
                      unsigned coordinate);

/* ---- By the machine ------------------------------------------------------ */

enum point_form { POINTS_SCALAR, POINTS_VECTOR, POINT_FORMS };

/* The output of points.s. There are at most 65,535 points. */
struct point_kind {
    enum point_form form;
    bool lattice;
    bool numbers;                      /* numbers in (0, 1), else the integers from
                                        * which they are computed */
    size_t queue, points, coordinates; /* number of points in a queue, points and
                                        * coordinates; the stream has 5 coordinates */
};

/* Selects points of the kind. Only the lattice uses m and shift. */
struct point_choice {
    uint64_t seed, first, m, shift;
};

struct point_maker;

/* Assembles the program for a kind of points. Returns NULL after an error. */
struct point_maker *point_maker_new(const struct point_kind *kind, c205_error *error);
void point_maker_free(struct point_maker *maker);
/* Computes the n points. Coordinate j of all points starts at words + j * n. */
bool point_maker_run(struct point_maker *maker, const struct point_choice *choice,
                     c205_word *words, c205_error *error);
const struct object *point_maker_program(const struct point_maker *maker);
/* Returns the machine of this choice before its run, for attaching listeners. */
c205 *point_maker_load(struct point_maker *maker, const struct point_choice *choice,
                       c205_error *error);

#endif
