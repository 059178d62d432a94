/* c205_time.h - the clocks of a run by cause, and the time that the same run would take
 * on other machines.
 */
#ifndef C205_API_TIME_H
#define C205_API_TIME_H

#include "c205_machine.h"

/* ---- Accounts (vm/time/clock.c) ------------------------------------------ */

/* The causes of clocks. Each clock has one cause. */
typedef enum c205_cause {
    C205_ISSUE,
    C205_OPERAND_WAIT,
    C205_UNIT_BUSY,
    C205_BRANCH,
    C205_MEMORY_WAIT,
    C205_VECTOR_STARTUP,
    C205_VECTOR_STREAM,
    C205_BANK_CONFLICT,
    C205_TRANSLATION_MISS,
    C205_PAGE_FAULT,
    C205_CAUSES
} c205_cause;
const char *c205_cause_name(c205_cause cause);

typedef struct c205_account {
    const char *name; /* name of the region; "": code outside regions */
    uint64_t clocks[C205_CAUSES];
    uint64_t instructions;
    uint64_t vector_instructions;
    uint64_t elements;   /* vector results, or scanned operands */
    uint64_t operations; /* floating-point operations, scalar or on elements */
    uint64_t entries;    /* number of times that control entered the region */
} c205_account;

/* Returns the clocks charged so far: the sum of all accounts. It includes the wait for
 * everything in flight after the end of a program or a trap, but not at the clock
 * limit. Within a vector instruction the clock equals the limit, and the accounts
 * include the clocks of that instruction up to there. The instruction is counted when
 * it is done.
 *
 * After a trap or at the limit, a run may continue as if it had not been stopped, from
 * the clock at which the instruction at the program counter issues. If a missing page
 * was mapped in between, the final times are the same as if the page had been present
 * from the start.
 */
uint64_t c205_clock(const c205 *machine);

/* Return the number of accounts, and account i. Account 0 is all code outside named
 * regions. */
size_t c205_account_count(const c205 *machine);
const c205_account *c205_account_at(const c205 *machine, size_t i);
/* Sets clock and accounts to zero and empties the pipes. Memory, registers, resident
 * pages and the remaining time of the job interval timer are unchanged. An interrupted
 * instruction is charged completely when it is done. */
void c205_reset_clock(c205 *machine);

/* ---- The times of an instruction ----------------------------------------- */

/* The reasons for which an instruction waits. */
typedef enum c205_wait {
    C205_WAIT_NONE,     /* no wait: work of the instruction */
    C205_WAIT_REGISTER, /* a register by number: its source is not ready, or its result
                           is pending */
    C205_WAIT_UNIT,     /* a busy unit, by number of c205_unit */
    C205_WAIT_LOADS,    /* all loads in flight, or the oldest load if the maximum is in
                           flight */
    C205_WAIT_RESULTS,  /* all results in flight */
    C205_WAIT_VECTOR,   /* the busy vector unit */
    C205_WAITS
} c205_wait;

typedef struct c205_piece {
    uint64_t clocks;
    c205_cause cause;
    size_t region; /* the region that is charged */
    uint64_t pc;   /* the instruction that does the work; it may be a vector instruction
                      for which others wait */
    c205_wait wait;
    unsigned number; /* number of the register or unit, or 0 */
} c205_piece;

/* The times of one instruction, as recorded by the clock. A piece is a span of time
 * with one cause. The pieces are in the order of time, and their sum is the increase of
 * the clock. The phases of a vector instruction cover the time from its issue to its
 * end, which may be after the last piece. Phases of zero length are omitted. */
enum { C205_PIECES = 40, C205_PHASES = 5 };
struct c205_times {
    uint64_t pc;
    uint64_t arrived;   /* the clock before the instruction */
    uint64_t issued;    /* the clock at which it issued */
    uint64_t ready;     /* the clock at which its results are ready */
    uint64_t unit_free; /* the clock at which its unit accepts the next instruction; the
                           vector unit accepts it earlier if its start-up overlaps the
                           stream */
    uint64_t misses;    /* pages that the associative registers lack */
    uint64_t faults;    /* pages that real memory lacks; these are misses too */
    size_t piece_count, phase_count;
    c205_piece piece[C205_PIECES];
    struct {
        uint64_t begin, end;
        c205_cause cause;
    } phase[C205_PHASES];
};

/* ---- The time of other machines (vm/time/projection.c) ---------------------
 *
 * A listener that charges each scalar instruction of a program with the time that
 * another machine would take for the same operation.
 */
typedef struct c205_projection c205_projection;

/* Returns a new projection to the machine of a model. The model must be one for which
 * c205_model_is_projection is true. */
c205_projection *c205_projection_new(const c205_model *model, c205_error *error);
void c205_projection_free(c205_projection *projection);
/* A listener that charges the events to a projection. Pass the projection to
 * c205_listen as the context. */
c205_listener c205_project;
/* Returns the clocks that the other machine takes for a region, numbered as in the
 * accounts. */
uint64_t c205_projected_clocks(const c205_projection *projection, size_t region);
/* Returns true if the projected clocks are valid: the run had no vector instructions,
 * and the host did not run out of memory. */
bool c205_projection_holds(const c205_projection *projection, c205_error *error);

/* ---- Other constants for the same run (vm/time/recording.c) ----------------
 *
 * A recording is a listener that stores the input of the clock during a run. It
 * computes the time of the same run with other constants, by the machine's own clock or
 * by a projection. The result is exact if the program does not read the clock.
 */
typedef struct c205_recording c205_recording;
c205_recording *c205_recording_new(c205_error *error);
void c205_recording_free(c205_recording *recording);
/* A listener that adds the events to a recording. Pass the recording to c205_listen as
 * the context, before the run starts. */
c205_listener c205_record;

/* Computes the clocks of each region, numbered as in the accounts, with the constants
 * of the model and these settings; regions that did not run have 0. `ticks` is the
 * number of steps of time per clock (1: as in the machine). A projection gives NaN for
 * regions with vector instructions. On failure sets the error and returns false. */
bool c205_retime(const c205_recording *recording, const c205_model *model,
                 const c205_setting *settings, size_t count, unsigned ticks,
                 double *clocks, size_t regions, c205_error *error);

#endif
