/* plain_run.h - all states of a program, from one run forward: what a debugger is held
 * beside. */
#ifndef TESTS_PLAIN_RUN_H
#define TESTS_PLAIN_RUN_H

#include "tests/unit/asm_helper.h"
#include "tests/unit/prior_model.h"

enum { PLAIN_STEPS_MOST = 3000 };

/* Before each step. */
struct moment {
    uint64_t pc, clock;
    c205_word registers[C205_REGISTERS];
    c205_word watched;
};

struct plain {
    struct object *object;
    uint64_t watched;       /* a word of memory */
    size_t end;             /* steps until the program ends */
    struct moment *moments; /* [end + 1], to be freed */
};

struct moment moment_of(const c205 *machine, uint64_t watched);
/* A word of the last segment, by chance, is watched.  Takes the object. */
struct plain run_plainly(struct object *object, uint64_t *random_state);
/* The region of an address, "" for none. */
const char *plain_region(const struct plain *plain, uint64_t pc);

#endif
