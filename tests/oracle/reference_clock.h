/* reference_clock.h - a second, simple implementation of the clock.
 *
 * Its source is docs/timing.md. For each instruction it computes the waits in order,
 * and the cause to which each wait is charged.
 *
 * In some points that the text leaves open, it follows the machine. Ranges of memory
 * are in the order A, B, Z, C. For sparse instructions the order is X, Y, A, B, C, Z.
 * For a linked pair, A and B of the first instruction precede A and B of the second.
 * Neighbours count as two sources. At the end the clock first waits for the vector
 * unit, then for loads, then for results, including results for register 0.
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

/* An activity of the vector unit, and its end. */
struct phase {
    uint64_t end;
    c205_cause cause;
    size_t region;
};

/* Counts of a region, without its clocks. */
struct counts {
    uint64_t instructions, vector_instructions, elements, operations, entries;
};

struct reference_clock {
    const c205_model *model;
    uint64_t now;
    struct awaited registers[C205_REGISTERS];
    uint64_t unit_free[C205_UNITS];
    uint64_t loads[CLOCK_LOADS]; /* in flight; the oldest is the first */
    size_t load_count;
    struct phase phases[CLOCK_PHASES];
    size_t phase_count;
    uint64_t vector_done, vector_stream;
    uint64_t stack_low, stack_high; /* range of words of code; the end is excluded */
    uint64_t pages[CLOCK_PAGES];    /* the most recent page is the first */
    size_t page_count;
    size_t region; /* region of the current instruction */
    bool begun;
    struct counts counts[CLOCK_REGIONS];
    uint64_t charged[CLOCK_REGIONS][C205_CAUSES];
};

void reference_clock_begin(struct reference_clock *clock, const c205_model *model);
/* Starts code at pc after a jump from outside, with an empty instruction stack. */
void reference_clock_enter(struct reference_clock *clock, uint64_t pc);
/* Adds an instruction of a region after its execution. */
void reference_clock_step(struct reference_clock *clock, const struct deed *deed,
                          size_t region);
/* Ends the run: waits for all results in flight. */
void reference_clock_drain(struct reference_clock *clock);

#endif
