/* reference_clock.h - the clock a second time.
 *
 * Written from docs/timing.md: for each instruction the waits it makes, one
 * after the other, and what each is charged to.
 *
 * What the text does not say was settled by comparing with the machine: the
 * ranges of memory in the order A, B, Z, C (sparse: X, Y, A, B, C, Z; a
 * linked pair: first A, B, then the second), neighbours counting as two
 * sources; at the end the vector unit is waited for first, then loads, then
 * results, those for register 0 as well.
 */
#ifndef REFERENCE_CLOCK_H
#define REFERENCE_CLOCK_H

#include "tests/oracle/reference.h"

enum {
    CLOCK_REGIONS = 2,
    CLOCK_PHASES = 16,
    CLOCK_LOADS = 64,
    CLOCK_PAGES = 64 /* more than any model has in memory or registers */
};

/* When something is there, and whom one waits for until then. */
struct awaited {
    uint64_t ready;
    enum { ARITHMETIC, LOAD, VECTOR_UNIT } maker;
};

/* What the vector unit does until when. */
struct phase {
    uint64_t end;
    c205_cause cause;
    size_t region;
};

/* Beside the clocks of a region. */
struct counts {
    uint64_t instructions, vector_instructions, elements, operations, entries;
};

struct reference_clock {
    const c205_model *model;
    uint64_t now;
    struct awaited registers[C205_REGISTERS];
    uint64_t unit_free[C205_UNITS];
    uint64_t loads[CLOCK_LOADS]; /* in flight, the oldest first */
    size_t load_count;
    struct phase phases[CLOCK_PHASES];
    size_t phase_count;
    uint64_t vector_done, vector_stream;
    uint64_t stack_low, stack_high; /* words of code: from, to before */
    uint64_t pages[CLOCK_PAGES];    /* latest first */
    size_t page_count;
    size_t region; /* of the instruction at work */
    bool begun;
    struct counts counts[CLOCK_REGIONS];
    uint64_t charged[CLOCK_REGIONS][C205_CAUSES];
};

void reference_clock_begin(struct reference_clock *clock, const c205_model *model);
/* Code begins here, come from nowhere: the instruction stack is empty. */
void reference_clock_enter(struct reference_clock *clock, uint64_t pc);
/* An instruction of a region has been done. */
void reference_clock_step(struct reference_clock *clock, const struct deed *deed,
                          size_t region);
/* The run has ended: wait for everything in flight. */
void reference_clock_drain(struct reference_clock *clock);

#endif
