/* roots.h - finds the real roots of polynomials on a machine.
 *
 * roots_new assembles the root solver in the requested form, loads it into a
 * machine and lays the polynomials out in its memory. roots_run runs it. The roots
 * and the machine's accounts can be read after that.
 */
#ifndef RT_ROOTS_H
#define RT_ROOTS_H

#include "asm/object/object.h"
#include "rt/roots/iterations.h"
#include "rt/trace/trace.h"

/* The rules by which the root solver's falsi (regula falsi) scales the retained end of a
 * bracket. They are the values of FALSI in rt/kernels/roots/quartic_constants.s, which
 * also has the default. */
enum falsi {
    FALSI_DEFAULT = -1,
    FALSI_PAPER,
    FALSI_ILLINOIS,
    FALSI_PEGASUS,
    FALSI_ANDERSON_BJORCK,
    FALSI_RULES
};
const char *falsi_name(enum falsi rule);
bool falsi_named(const char *name, enum falsi *rule);

/* Returns the rule that a program was assembled with, or FALSI_DEFAULT if it has
 * none. */
enum falsi falsi_of(const struct object *program);

/* The polynomial c[0] t^4 + c[1] t^3 + ... + c[4]. Its roots above the bound are
 * computed. */
struct polynomial {
    c205_word c[5];
    c205_word bound;
};

enum {
    MAX_ROOTS = 4,
    ROOTS_REFUSED = -1 /* a count for rejected polynomials: see scaling_vector.s */
};
struct polynomial_roots {
    int count;                 /* or ROOTS_REFUSED */
    c205_word root[MAX_ROOTS]; /* ascending, each of them once */
};

struct roots_options {
    enum trace_mode mode;
    size_t queue; /* polynomials; vector mode only */
    bool first;   /* only the first root of each polynomial */
    enum falsi falsi;
    const c205_model *model; /* must outlive the search */
    /* As in trace_options. */
    bool (*progress)(void *context, size_t done, size_t polynomials);
    void *context;
};

struct root_search;

/* Prepares a search. It copies the polynomials. Returns NULL with the reason in
 * the error. */
struct root_search *roots_new(const struct polynomial *polynomials, size_t count,
                              const struct roots_options *options, c205_error *error);
void roots_free(struct root_search *search);

/* Counts the steps of the refinement. Call this before the run. */
bool roots_watch(struct root_search *search, struct iterations *iterations);

/* Returns false after a trap, or if progress returned false. */
bool roots_run(struct root_search *search, c205_error *error);

/* Reads the roots of all polynomials, in their order. */
bool roots_read(const struct root_search *search, struct polynomial_roots *roots,
                c205_error *error);
/* Returns the rule that the program was assembled with. */
enum falsi roots_falsi(const struct root_search *search);
const c205 *roots_machine(const struct root_search *search);

#endif
