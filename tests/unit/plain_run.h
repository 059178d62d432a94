/* plain_run.h - all states of a program, from one run forward: what a debugger is held
 * beside. */
#ifndef TESTS_PLAIN_RUN_H
#define TESTS_PLAIN_RUN_H

#include "tests/unit/asm_helper.h"
#include "tests/unit/prior_model.h"

enum { MAX_PLAIN_STEPS = 3000 };

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
/* A word of the last segment, at random, is watched.  Takes the object. */
struct plain run_plainly(struct object *object, uint64_t *random_state);
/* The region of an address, "" for none. */
const char *plain_region(const struct plain *plain, uint64_t pc);

/* ---- Where a debugger stops -------------------------------------------------- */

struct plain_stops {
    bool by_watch, by_place;
    uint64_t place;
    size_t every;       /* the place counts at steps that this divides; 0: at all */
    const char *region; /* that is entered; NULL: none */
};

bool plain_stops_at(const struct plain *plain, const struct plain_stops *stops,
                    size_t step);
/* Forward to a stop, by up to a number of steps; back to a stop, or to the beginning. */
size_t plain_on(const struct plain *plain, const struct plain_stops *stops, size_t step,
                uint64_t count);
size_t plain_back(const struct plain *plain, const struct plain_stops *stops,
                  size_t step);
/* The first step at or after a clock. */
size_t plain_to_clock(const struct plain *plain, size_t step, uint64_t clock);

#endif
