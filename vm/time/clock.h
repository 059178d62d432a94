/* clock.h - time: what each instruction costs, and to which cause.
 *
 * Time knows no semantics: it sees the decoded instruction (which unit,
 * which registers) and its effect (how long, which addresses).  All constants
 * come from the model.  Every clock is charged to one cause of one region:
 * the time line is cut at each step and the piece between two cuts charged.
 *
 * Scalar unit: instructions issue in order, at most one a clock; an
 * instruction waits for its operands (a scoreboard of when each register is
 * ready), for its unit, for memory.  Vector unit: start-up, then the stream;
 * the issue clock is the first of the start-up.  The scalar unit runs on under
 * a vector instruction unless it needs memory, its result, or the vector
 * unit; clocks it then waits are charged to the phase of the vector
 * instruction in which they fall, and to that instruction's region.
 *
 * An instruction is charged as a whole when it has executed.  Where a run
 * stops before that, by a trap or within a vector instruction, the clock
 * shows ahead the time at which it stopped; when the run continues it goes back
 * to what has been charged, so that the total does not depend on the stop.
 */
#ifndef C205_CLOCK_H
#define C205_CLOCK_H

#include "vm/block.h"

struct clock;
struct serializer;

/* A model is complete and in range.  NULL: the host has no memory left. */
struct clock *clock_new(const c205_model *model, c205_error *error);
void clock_free(struct clock *clock);

/* Name the regions, whose accounts start at zero.  names[0] is "". */
bool clock_set_regions(struct clock *clock, const char *const *names, size_t count,
                       c205_error *error);

/* Time and accounts to zero, pipes empty; which pages are resident and in
 * the associative registers stays.  clock_forget_pages forgets that too. */
void clock_reset(struct clock *clock);
void clock_forget_pages(struct clock *clock);

/* The pages of a range are known and resident. */
void clock_warm_page(struct clock *clock, uint64_t address, uint64_t bits);

/* One instruction has executed. */
void clock_charge(struct clock *clock, const struct decoded *decoded,
                  const struct effect *effect);
/* The first so many of a block have executed; the effect is that of all.
 * From the first block on until it is unfolded a clock is folded, and may be
 * asked for nothing but clock_now. */
void clock_charge_block(struct clock *clock, struct code_block *block, unsigned count,
                        const struct effect *effect);
void clock_materialize(struct clock *clock);
/* A block is new. */
void clock_measure(const struct clock *clock, struct code_block *block);
/* When all is done that is in flight; of a clock that is not folded. */
uint64_t clock_all_done(const struct clock *clock);
/* Wait until everything in flight is done, and charge it. */
void clock_drain(struct clock *clock);

/* From now on the record is that of the latest instruction; NULL: of none. */
void clock_listen(struct clock *clock, c205_times *record);
/* The clock at which the latest instruction issued. */
uint64_t clock_issued(const struct clock *clock);

/* How many elements of a vector instruction that comes next will have
 * streamed at a clock.  What only its execution tells, misses, faults and
 * conflicts, does not count. */
size_t clock_elements(const struct clock *clock, const struct decoded *decoded,
                      uint64_t until);
/* Show how the clock is at that clock, within that instruction; or when
 * everything in flight is done. */
void clock_show(struct clock *clock, const struct decoded *decoded, uint64_t until);
void clock_show_drained(struct clock *clock);
/* Go back to what has been charged; or charge what is shown. */
void clock_go_back(struct clock *clock);
void clock_commit(struct clock *clock);

/* Write all of a clock, its names of regions aside, to a serializer; or fill one
 * with the same model and regions from there. */
void clock_walk(struct clock *clock, struct serializer *serializer);

/* The clocks charged so far: the sum of all accounts. */
uint64_t clock_now(const struct clock *clock);
size_t clock_account_count(const struct clock *clock);
const c205_account *clock_account(const struct clock *clock, size_t i);

#endif
