/* roots.h - polynomials whose real roots a machine finds.
 *
 * roots_new assembles the root solver in the form asked for, loads it into a
 * machine and lays the polynomials out in its memory; roots_run lets it run;
 * after that the roots and the machine's accounts can be read.
 */
#ifndef RT_ROOTS_H
#define RT_ROOTS_H

#include "rt/roots/falsi.h"
#include "rt/roots/iterations.h"
#include "rt/trace/trace.h"

/* c[0] t^4 + c[1] t^3 + ... + c[4]; the roots above the bound are wanted. */
struct polynomial {
    c205_word c[5];
    c205_word bound;
};

enum {
    MAX_ROOTS = 4,
    ROOTS_REFUSED = -1 /* a number of roots: see scaling_vector.s */
};
struct polynomial_roots {
    int count;                 /* or ROOTS_REFUSED */
    c205_word root[MAX_ROOTS]; /* ascending, each once */
};

struct roots_options {
    enum trace_mode mode;
    size_t queue; /* polynomials; vector mode only */
    bool first;   /* the first root of each alone */
    enum falsi falsi;
    const c205_model *model; /* must outlive the search */
    /* As in trace_options. */
    bool (*progress)(void *context, size_t done, size_t polynomials);
    void *context;
};

struct root_search;

/* NULL: the error says why.  Of the polynomials nothing is kept. */
struct root_search *roots_new(const struct polynomial *polynomials, size_t count,
                              const struct roots_options *options, c205_error *error);
void roots_free(struct root_search *search);

/* Count the steps of the refinement from now on; before the run. */
bool roots_watch(struct root_search *search, struct iterations *iterations);

/* False: a trap, or progress said to stop. */
bool roots_run(struct root_search *search, c205_error *error);

/* As many as there are polynomials. */
bool roots_read(const struct root_search *search, struct polynomial_roots *roots,
                c205_error *error);
/* The rule that it was assembled with. */
enum falsi roots_falsi(const struct root_search *search);
const c205 *roots_machine(const struct root_search *search);

#endif
