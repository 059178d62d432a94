/* clock_parts.h - the inside of a clock, for what runs it and what saves it.
 */
#ifndef C205_CLOCK_PARTS_H
#define C205_CLOCK_PARTS_H

#include "vm/time/account.h"
#include "vm/time/banks.h"
#include "vm/time/clock.h"
#include "vm/time/model.h"
#include "vm/time/pages.h"

/* A timing class, its constants taken from the model. */
struct clock_timing {
    uint64_t latency, busy;          /* scalar */
    uint64_t startup;                /* vector .. */
    struct rate stream, half_stream; /* of words, of half words */
};

/* What keeps the vector unit until a clock, and whom that is charged to. */
struct phase {
    uint64_t end;
    c205_cause cause;
    size_t region;
    uint64_t pc; /* of the instruction */
};
/* Start-up, misses, faults, conflicts, stream; and the tail of the stream of
 * the instruction before, under which the start-up hides. */
enum { PHASES = 6 };

/* What a register waits for, besides C205_OPERAND_WAIT and _MEMORY_WAIT. */
enum { FOR_VECTOR = C205_CAUSES };

/* The instruction stack: the last words of code that ran straight on. */
struct stack {
    uint64_t next;      /* address, if control runs straight on */
    uint64_t low, high; /* words */
};

enum { WORD_SHIFT = 6 };

static inline void stack_begin(struct stack *stack, uint64_t address)
{
    stack->low = stack->high = address >> WORD_SHIFT;
}

/* Up to a next address; it has room for so many words. */
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
    bool ahead;            /* now and the accounts show a later time than .. */
    uint64_t kept_now;     /* .. this, with the accounts kept, from which the
                              clock continues */
    c205_account *account; /* of the region in which the program is */
    size_t region;

    uint64_t ready[SLOTS]; /* the clock at which each register is ready .. */
    uint8_t awaits[SLOTS]; /* .. and the cause of waiting for it */
    uint64_t results_done; /* all registers are ready */
    uint64_t loads_done;   /* all loads are */
    uint64_t free_at[C205_UNITS];
    uint64_t load_end[MAX_LOADS]; /* of the last loads_in_flight loads */
    size_t load;                  /* the oldest of them */

    uint64_t issued;           /* the latest instruction did then .. */
    struct c205_times *record; /* .. and this is all about its time; NULL:
                                    nobody listens */

    struct phase phase[PHASES];
    size_t phase_count;
    uint64_t vector_end;  /* the end of the last phase .. */
    uint64_t vector_tail; /* .. and how much of it may hide a start-up */
    uint64_t vector_pc;   /* of the instruction whose phases are added */

    struct stack stack;

    struct clock_timing timing[C205_TIMINGS];
    uint64_t issue_interval, loads_in_flight, stack_words, overlap;
    uint64_t branch_taken, branch_not_taken, branch_out_of_stack;
    uint64_t translation_miss, page_fault;
    struct rate swap_word;
    struct index_list list; /* of the latest gather or scatter */
    struct pages pages;
    struct banks banks;
    struct clock_accounts accounts;

    struct schedules *schedules;    /* of blocks (schedule.h) */
    uint64_t generation;            /* counts how often all were forgotten,
                                     from one */
    struct schedule *charged;       /* those followed that the accounts do not
                                     have yet */
    const struct in_flight *flight; /* if not NULL, what is in flight, in place
                                     of ready, awaits, results_done,
                                     loads_done, free_at and load_end */
    unsigned blocks_since;          /* blocks since it was NULL */
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
