/* reference_clock.h - a second, simple implementation of the clock.
 *
 * Written from docs/timing.md: for each instruction, the waits in their order and the
 * cause that each is charged to.
 *
 * The text leaves the following points open; here they follow the machine.  Ranges of
 * memory are in the order A, B, Z, C (sparse: X, Y, A, B, C, Z; a linked pair: A and B
 * of the first, then the second), and neighbours count as two sources.  At the end the
 * clock waits for the vector unit first, then for loads, then for results, including
 * those for register 0.
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

/* The clock at which a result is ready, and the unit that produces it. */
struct awaited {
    uint64_t ready;
    enum { ARITHMETIC, LOAD, VECTOR_UNIT } maker;
};

/* An activity of the vector unit and its end. */
struct phase {
    uint64_t end;
    c205_cause cause;
    size_t region;
};

/* Counts of a region, in addition to its clocks. */
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
    uint64_t stack_low, stack_high; /* words of code, half-open */
    uint64_t pages[CLOCK_PAGES];    /* most recent first */
    size_t page_count;
    size_t region; /* of the current instruction */
    bool begun;
    struct counts counts[CLOCK_REGIONS];
    uint64_t charged[CLOCK_REGIONS][C205_CAUSES];
};

void reference_clock_begin(struct reference_clock *clock, const c205_model *model);
/* Starts code at pc after a jump from outside: the instruction stack is empty. */
void reference_clock_enter(struct reference_clock *clock, uint64_t pc);
/* Adds an executed instruction of a region. */
void reference_clock_step(struct reference_clock *clock, const struct deed *deed,
                          size_t region);
/* Ends the run: waits for everything in flight. */
void reference_clock_drain(struct reference_clock *clock);

#endif
