/* emission.h - points of a surface and the ways in which it radiates from there,
 * made by a machine.
 *
 * emission_new assembles the program of rt/kernels/heat in the form asked for and
 * lays a primitive out for it; emission_run makes points of it, which depend on
 * their numbers and the choice alone: both forms, and whatever queues, give the same
 * bits.  docs/heat.md has the formulas.
 */
#ifndef RT_EMISSION_H
#define RT_EMISSION_H

#include "asm/assemble.h"
#include "rt/shapes/primitive.h"
#include "rt/trace/trace.h"

enum { EMISSION_MOST = 65535 }; /* points of a run */

struct emission_options {
    enum trace_mode mode; /* TRACE_SCALAR or TRACE_VECTOR */
    size_t queue;         /* points; vector mode only; 1 .. EMISSION_MOST */
    size_t points;        /* of each run; 1 .. EMISSION_MOST */
    bool lattice;         /* made of the lattice's points, not of the random
                             stream (docs/points.md) */
    const c205_model *model; /* must outlive the emission */
};

/* Which points: number first, first + 1 .. of a seed; of the lattice, of 2^m
 * points under a shift. */
struct emission_choice {
    uint64_t seed, first, m, shift;
};

/* In the machine's own numbers, in the world. */
struct emitted {
    /* The point, and its outward normal of length one: of a complement in a tree it
     * points into it; of what has no outside, to either side. */
    c205_word spot[3], face[3];
    c205_word weight; /* an area; the mean of all is that of the surface */
    c205_word ray[3]; /* of length one, by the cosine law about the normal */
};

struct emission;

/* Why a primitive has no emission, a sentence; NULL: it has one. */
const char *emission_refusal(const struct primitive *primitive);

/* NULL: the primitive has no emission, or options that cannot be; the error says
 * why.  Of the primitive nothing is kept. */
struct emission *emission_new(const struct primitive *primitive,
                              const struct emission_options *options,
                              c205_error *error);
void emission_free(struct emission *emission);

/* As many as the options say.  False: a trap, no memory. */
bool emission_run(struct emission *emission,
                  const struct emission_choice *choice,
                  struct emitted *points, c205_error *error);

const struct object *emission_program(const struct emission *emission);
/* As it was after the last run: for its accounts. */
const c205 *emission_machine(const struct emission *emission);
/* As it was before the next run, with the choice made: for who listens. */
c205 *emission_load(struct emission *emission,
                    const struct emission_choice *choice, c205_error *error);

#endif
