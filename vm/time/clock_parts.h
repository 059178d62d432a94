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
};
/* Start-up, misses, faults, conflicts, stream; and the tail of the stream of
 * the instruction before, under which the start-up hides. */
enum { PHASES = 6 };

/* What a register waits for, besides C205_OPERAND_WAIT and _MEMORY_WAIT. */
enum { FOR_VECTOR = C205_CAUSES };

struct clock {
    uint64_t now;
    bool ahead;        /* now and the accounts show a later time than .. */
    uint64_t kept_now; /* .. this, with the accounts kept, from which the
                              clock goes on */
    c205_account *account; /* of the region in which the program is */
    size_t region;

    uint64_t ready[SLOTS]; /* the clock at which each register is ready .. */
    uint8_t awaits[SLOTS]; /* .. and the cause of waiting for it */
    uint64_t results_done; /* all registers are ready */
    uint64_t loads_done;   /* all loads are */
    uint64_t free_at[C205_UNITS];
    uint64_t load_end[LOADS_MOST]; /* of the last loads_in_flight loads */
    size_t load;                   /* the oldest of them */

    struct phase phase[PHASES];
    size_t phase_count;
    uint64_t vector_end;  /* the end of the last phase .. */
    uint64_t vector_tail; /* .. and how much of it may hide a start-up */

    uint64_t next;                  /* address, if control runs straight on */
    uint64_t stack_low, stack_high; /* words in the instruction stack */

    struct clock_timing timing[C205_TIMINGS];
    uint64_t issue_interval, loads_in_flight, stack_words, overlap;
    uint64_t branch_taken, branch_not_taken, branch_out_of_stack;
    uint64_t translation_miss, page_fault;
    struct rate swap_word;
    struct pages pages;
    struct banks banks;
    struct clock_accounts accounts;
};

#endif
