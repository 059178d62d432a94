/* emission.h - generates points on a surface, and the directions in which it radiates,
 * on a machine.
 *
 * emission_new assembles the program of rt/kernels/heat in the requested form and lays
 * a primitive out for it. emission_run generates points on the primitive. A point
 * depends only on its number and the choice, so the results are equal bit for bit in
 * both forms and for all queue lengths. docs/heat.md contains the formulas.
 */
#ifndef RT_EMISSION_H
#define RT_EMISSION_H

#include "asm/object/object.h"
#include "base/accounts.h"
#include "rt/shapes/primitive.h"
#include "rt/trace/trace.h"

enum { MAX_EMISSION = 65535 }; /* largest number of points in a run */

struct emission_options {
    enum trace_mode mode;    /* TRACE_SCALAR or TRACE_VECTOR */
    size_t queue;            /* number of points in a queue, 1 .. MAX_EMISSION; vector
                              * mode only */
    size_t points;           /* number of points in a run, 1 .. MAX_EMISSION */
    bool lattice;            /* use lattice points instead of random points
                              * (docs/points.md) */
    const c205_model *model; /* must outlive the emission */
};

/* Selects points of a random stream with this seed: the numbers first, first + 1, .. If
 * a lattice is used, selects the same numbers of its 2^m points with this shift. */
struct emission_choice {
    uint64_t seed, first, m, shift;
};

/* The output planes. A plane has one word for each point, in the machine's number
 * format. Points and directions are in world space. The planes are in the order in
 * which emission.s writes them. */
enum emitted {
    EMITTED_POINT, /* x, y, z of the point */
    /* The outward unit normal. The normal of a complement in a tree points into the
     * complement. The normal of a surface without an outside points to either side. */
    EMITTED_FACE = EMITTED_POINT + 3,
    EMITTED_WEIGHT = EMITTED_FACE + 3, /* an area; its mean over all points is the area
                                        * of the surface */
    EMITTED_RAY, /* a unit direction, distributed by the cosine law about the normal */
    EMITTED_PLANES = EMITTED_RAY + 3
};

/* Returns the choice for a run. Runs with different places have different points for
 * the same seed: another shift of the lattice, or other numbers of the random
 * stream. */
struct emission_choice emission_choose(bool lattice, uint64_t seed, size_t points,
                                       size_t place);

struct emission;

/* Returns the reason why a primitive has no emission, as a sentence. Returns NULL if it
 * has an emission. */
const char *emission_refusal(const struct primitive *primitive);

/* Returns an emission, or NULL with the error if the primitive has no emission or the
 * options are invalid. The emission does not refer to the primitive after this call. */
struct emission *emission_new(const struct primitive *primitive,
                              const struct emission_options *options,
                              c205_error *error);
void emission_free(struct emission *emission);

/* Generates options->points points on a new machine, and writes their EMITTED_PLANES
 * planes to `planes`. Adds the machine's accounts to `accounts`, unless it is NULL.
 * Threads may run the same emission concurrently. Returns false after a trap, or if out
 * of memory. */
bool emission_run(const struct emission *emission, const struct emission_choice *choice,
                  c205_word *planes, struct accounts *accounts, c205_error *error);

const struct object *emission_program(const struct emission *emission);
/* Returns a machine with the program and the input of emission_run, before its first
 * instruction. The caller frees the machine. */
c205 *emission_load(const struct emission *emission,
                    const struct emission_choice *choice, c205_error *error);

#endif
