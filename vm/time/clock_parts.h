/* clock_parts.h - the internal state of a clock, for the files that advance and save
 * it.
 */
#ifndef C205_CLOCK_PARTS_H
#define C205_CLOCK_PARTS_H

#include "vm/time/account.h"
#include "vm/time/banks.h"
#include "vm/time/clock.h"
#include "vm/time/model.h"
#include "vm/time/pages.h"

/* A timing class with its constants from the model. */
struct clock_timing {
    uint64_t latency, busy;          /* for scalar classes */
    uint64_t startup;                /* for vector classes */
    struct rate stream, half_stream; /* for vector classes: words, half words */
};

/* A period in which the vector unit is busy. Waits during a phase are charged to its
 * cause and region. */
struct phase {
    uint64_t end;
    c205_cause cause;
    size_t region;
    uint64_t pc; /* address of the instruction */
};
/* The maximum number of phases: start-up, misses, faults, conflicts and stream, and the
 * rest of the previous stream, which overlaps the start-up. */
enum { PHASES = 6 };

/* The cause of waiting for a register is C205_OPERAND_WAIT, C205_MEMORY_WAIT, or
 * FOR_VECTOR if the register waits for the vector unit. */
enum { FOR_VECTOR = C205_CAUSES };

/* The instruction stack: the last words of code that were executed in sequence. */
struct stack {
    uint64_t next;      /* the next address in sequence */
    uint64_t low, high; /* the range, in words */
};

enum { WORD_SHIFT = 6 };

static inline void stack_begin(struct stack *stack, uint64_t address)
{
    stack->low = stack->high = address >> WORD_SHIFT;
}

/* Extends the instruction stack to the next address and limits it to a capacity in
 * words. */
static inline void stack_extend(struct stack *stack, uint64_t next, uint64_t words)
{
    uint64_t word = (next - 1) >> WORD_SHIFT;
    if (stack->high < word)
        stack->high = word;
    if (stack->high - stack->low >= words)
        stack->low = stack->high - words + 1;
}

static inline bool stack_holds(const struct stack *stack, uint64_t address)
{
    uint64_t word = address >> WORD_SHIFT;
    return stack->low <= word && word <= stack->high;
}

struct schedules;
struct schedule;
struct in_flight;

struct clock {
    uint64_t now;
    bool ahead;            /* now and the accounts show a later time than the charged
                              time */
    uint64_t kept_now;     /* if ahead: the charged time, from which the clock
                              continues; the accounts have a copy, too */
    c205_account *account; /* account of the current region */
    size_t region;

    uint64_t ready[SLOTS]; /* the clock at which each register is ready */
    uint8_t awaits[SLOTS]; /* the cause of waiting for the register */
    uint64_t results_done; /* the clock at which all registers are ready */
    uint64_t loads_done;   /* the clock at which all loads are done */
    uint64_t free_at[C205_UNITS];
    uint64_t load_end[MAX_LOADS]; /* ends of the last loads_in_flight loads */
    size_t load;                  /* index of the oldest of these loads */

    uint64_t issued;           /* the clock at which the latest instruction issued */
    struct c205_times *record; /* receives the times of each instruction; NULL: none */

    struct phase phase[PHASES];
    size_t phase_count;
    uint64_t vector_end;  /* the end of the last phase */
    uint64_t vector_tail; /* clocks of the last phase that may overlap a start-up */
    uint64_t vector_pc;   /* the instruction that adds phases */

    struct stack stack;

    struct clock_timing timing[C205_TIMINGS];
    uint64_t issue_interval, loads_in_flight, stack_words, overlap;
    uint64_t branch_taken, branch_not_taken, branch_out_of_stack;
    uint64_t translation_miss, page_fault;
    struct rate swap_word;
    struct index_list list; /* indices of the latest gather or scatter */
    struct pages pages;
    struct banks banks;
    struct clock_accounts accounts;

    struct schedules *schedules;    /* schedules of blocks (schedule.h) */
    uint64_t generation;            /* 1 + number of times that all schedules were
                                       dropped */
    struct schedule *charged;       /* schedules whose clocks are not in the accounts
                                       yet */
    const struct in_flight *flight; /* NULL, or the state in flight of a lazy clock; it
                                       replaces ready, awaits, results_done, loads_done,
                                       free_at and load_end */
    unsigned blocks_since;          /* number of blocks since flight was NULL */
};

static inline void clock_enter_region(struct clock *clock, size_t region)
{
    if (clock->region == region)
        return;
    clock->region = region;
    clock->account = &clock->accounts.account[region];
    clock->account->entries++;
}

#endif
