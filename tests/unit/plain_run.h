/* plain_run.h - records all states of a run, the reference for a debugger. */
#ifndef TESTS_PLAIN_RUN_H
#define TESTS_PLAIN_RUN_H

#include "tests/unit/asm_helper.h"
#include "tests/unit/prior_model.h"

enum { MAX_PLAIN_STEPS = 3000 };

/* The state of the machine before a step of the plain run. */
struct moment {
    uint64_t pc, clock;
    c205_word registers[C205_REGISTERS];
    c205_word watched;
};

struct plain {
    struct object *object;
    uint64_t watched;       /* bit address of the watched word */
    size_t end;             /* number of steps of the program */
    struct moment *moments; /* [end + 1]; the caller frees it */
};

struct moment moment_of(const c205 *machine, uint64_t watched);
/* Records the states of a program, and a random word of its last segment. Takes
 * ownership of the object. */
struct plain run_plainly(struct object *object, uint64_t *random_state);
/* Returns the region that contains an address, or "". */
const char *plain_region(const struct plain *plain, uint64_t pc);

/* ---- Where a debugger stops -------------------------------------------------- */

struct plain_stops {
    bool by_watch, by_place;
    uint64_t place;
    size_t every;       /* stops only at multiples of this step; 0: at all steps */
    const char *region; /* stops where this region is entered; NULL: at no region */
};

bool plain_stops_at(const struct plain *plain, const struct plain_stops *stops,
                    size_t step);
/* plain_on returns the step of the next stop within `count` steps, going forward.
 * plain_back returns the previous stop, going backward, or the first step. */
size_t plain_on(const struct plain *plain, const struct plain_stops *stops, size_t step,
                uint64_t count);
size_t plain_back(const struct plain *plain, const struct plain_stops *stops,
                  size_t step);
/* Returns the first step at or after a clock. */
size_t plain_to_clock(const struct plain *plain, size_t step, uint64_t clock);

#endif
