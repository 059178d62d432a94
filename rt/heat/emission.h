/* emission.h - generates points of a surface and the directions in which it
 * radiates, on a machine.
 *
 * emission_new assembles the program of rt/kernels/heat in the requested form and
 * lays a primitive out for it. emission_run generates its points. A point depends
 * only on its number and the choice, so both forms and all queue lengths give the
 * same bits. docs/heat.md has the formulas.
 */
#ifndef RT_EMISSION_H
#define RT_EMISSION_H

#include "asm/object/object.h"
#include "base/accounts.h"
#include "rt/shapes/primitive.h"
#include "rt/trace/trace.h"

enum { MAX_EMISSION = 65535 }; /* points of a run */

struct emission_options {
    enum trace_mode mode;    /* TRACE_SCALAR or TRACE_VECTOR */
    size_t queue;            /* points, 1 .. MAX_EMISSION; vector mode only */
    size_t points;           /* of each run, 1 .. MAX_EMISSION */
    bool lattice;            /* use the lattice's points instead of the random stream
                              * (docs/points.md) */
    const c205_model *model; /* must outlive the emission */
};

/* Selects points: the numbers first, first + 1, .. of a seed. With the lattice,
 * they are those of 2^m points under a shift. */
struct emission_choice {
    uint64_t seed, first, m, shift;
};

/* The output: planes with a word for each point, in the machine's number format
 * and in world space, in the order of emission_program.s. */
enum emitted {
    EMITTED_POINT, /* x, y, z of the point */
    /* The outward normal, of length 1. For a complement in a tree it points into the
     * complement; for a surface without an outside, to either side. */
    EMITTED_FACE = EMITTED_POINT + 3,
    EMITTED_WEIGHT = EMITTED_FACE + 3, /* an area; the mean over all points is the
                                        * area of the surface */
    EMITTED_RAY, /* a direction of length 1, by the cosine law about the normal */
    EMITTED_PLANES = EMITTED_RAY + 3
};

/* Returns the choice of a run. Each place has its own points among all of a seed:
 * another shift of the lattice, or other numbers of the stream. */
struct emission_choice emission_choose(bool lattice, uint64_t seed, size_t points,
                                       size_t place);

struct emission;

/* Returns the reason why a primitive has no emission, as a sentence, or NULL if it
 * has one. */
const char *emission_refusal(const struct primitive *primitive);

/* Returns NULL if the primitive has no emission, or for invalid options; the error
 * gives the reason. The emission keeps no pointer to the primitive. */
struct emission *emission_new(const struct primitive *primitive,
                              const struct emission_options *options,
                              c205_error *error);
void emission_free(struct emission *emission);

/* Generates the number of points in the options: EMITTED_PLANES planes, on a
 * machine of its own. Adds its accounts unless accounts is NULL. Threads may run
 * one emission concurrently. Returns false after a trap, or if out of memory. */
bool emission_run(const struct emission *emission, const struct emission_choice *choice,
                  c205_word *planes, struct accounts *accounts, c205_error *error);

const struct object *emission_program(const struct emission *emission);
/* Returns a machine that is loaded for such a run and has not run yet, for
 * observers. The caller frees it. */
c205 *emission_load(const struct emission *emission,
                    const struct emission_choice *choice, c205_error *error);

#endif
