/* roots.h - finds the real roots of polynomials on a machine.
 *
 * roots_new assembles the root solver in the requested form, loads it into a machine
 * and lays the polynomials out in its memory. roots_run runs the machine. Afterwards
 * the roots and the machine's accounts can be read.
 */
#ifndef RT_ROOTS_H
#define RT_ROOTS_H

#include "asm/object/object.h"
#include "rt/roots/iterations.h"
#include "rt/trace/trace.h"

/* The rules by which regula falsi in the root solver scales the retained end of a
 * bracket. They are the values of FALSI in rt/kernels/roots/quartic_constants.s, which
 * also defines the default. */
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

/* Returns the regula falsi rule with which a program was assembled, or FALSI_DEFAULT if
 * the program defines no rule. */
enum falsi falsi_of(const struct object *program);

/* The polynomial c[0] t^4 + c[1] t^3 + ... + c[4]. Only roots above the bound are
 * computed. */
struct polynomial {
    c205_word c[5];
    c205_word bound;
};

enum {
    MAX_ROOTS = 4,
    ROOTS_REFUSED = -1 /* count of a rejected polynomial (scaling.s) */
};
struct polynomial_roots {
    int count;                 /* number of roots, or ROOTS_REFUSED */
    c205_word root[MAX_ROOTS]; /* distinct roots in ascending order */
};

struct roots_options {
    enum trace_mode mode;
    size_t queue; /* number of polynomials in a queue; vector mode only */
    bool first;   /* find only the first root of each polynomial */
    enum falsi falsi;
    const c205_model *model; /* must outlive the search */
    /* Like trace_options.progress. */
    bool (*progress)(void *context, size_t done, size_t polynomials);
    void *context;
};

struct root_search;

/* Prepares the search for the roots of polynomials, which are copied. On failure sets
 * the error and returns NULL. */
struct root_search *roots_new(const struct polynomial *polynomials, size_t count,
                              const struct roots_options *options, c205_error *error);
void roots_free(struct root_search *search);

/* Makes the run count the steps of the refinement. Call this before the run. Returns
 * false if the program lacks a label of iterations.h, or if the machine has too many
 * listeners. */
bool roots_watch(struct root_search *search, struct iterations *iterations);

/* Runs the search. Returns false after a trap, or if progress returned false. */
bool roots_run(struct root_search *search, c205_error *error);

/* Reads the roots of all polynomials, in the order of the polynomials. */
bool roots_read(const struct root_search *search, struct polynomial_roots *roots,
                c205_error *error);
/* Returns the regula falsi rule with which the program of the search was assembled. */
enum falsi roots_falsi(const struct root_search *search);
const c205 *roots_machine(const struct root_search *search);

#endif
