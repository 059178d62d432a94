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
#include "base/accounts.h"
#include "rt/shapes/primitive.h"
#include "rt/trace/trace.h"

enum { MAX_EMISSION = 65535 }; /* points of a run */

struct emission_options {
    enum trace_mode mode;    /* TRACE_SCALAR or TRACE_VECTOR */
    size_t queue;            /* points; vector mode only; 1 .. MAX_EMISSION */
    size_t points;           /* of each run; 1 .. MAX_EMISSION */
    bool lattice;            /* made of the lattice's points, not of the random
                             stream (docs/points.md) */
    const c205_model *model; /* must outlive the emission */
};

/* Which points: number first, first + 1 .. of a seed; of the lattice, of 2^m
 * points under a shift. */
struct emission_choice {
    uint64_t seed, first, m, shift;
};

/* What is made of points: planes of a word for each, in the machine's own numbers, in the
 * world; as emission_program.s has them. */
enum emitted {
    EMITTED_SPOT, /* x, y, z of the point */
    /* .. of its outward normal of length one: of a complement in a tree it points into it;
     * of what has no outside, to either side. */
    EMITTED_FACE = EMITTED_SPOT + 3,
    EMITTED_WEIGHT = EMITTED_FACE + 3, /* an area; the mean of all is that of the
                                          surface */
    EMITTED_RAY, /* of a direction of length one, by the cosine law about the
                    normal */
    EMITTED_PLANES = EMITTED_RAY + 3
};

/* Those of a run that has a place of its own among all of a seed: another shift of the
 * lattice, or other numbers of the stream. */
struct emission_choice emission_choose(bool lattice, uint64_t seed, size_t points,
                                       size_t place);

struct emission;

/* Why a primitive has no emission, a sentence; NULL: it has one. */
const char *emission_refusal(const struct primitive *primitive);

/* NULL: the primitive has no emission, or options that cannot be; the error says
 * why.  Of the primitive nothing is kept. */
struct emission *emission_new(const struct primitive *primitive,
                              const struct emission_options *options,
                              c205_error *error);
void emission_free(struct emission *emission);

/* As many as the options say, EMITTED_PLANES planes, in a machine of its own, whose
 * accounts are added (NULL: to none); any number of threads may run one emission at a
 * time.  False: a trap, no memory. */
bool emission_run(const struct emission *emission, const struct emission_choice *choice,
                  c205_word *planes, struct accounts *accounts, c205_error *error);

const struct object *emission_program(const struct emission *emission);
/* A machine before such a run, which the caller frees: for who listens. */
c205 *emission_load(const struct emission *emission,
                    const struct emission_choice *choice, c205_error *error);

#endif
