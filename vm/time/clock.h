/* clock.h - the clock, which computes the cost of each instruction and charges it to a
 * cause.
 *
 * The clock is independent of the results of instructions. Its input is the decoded
 * instruction (unit, registers) and its effect (length, addresses). All constants come
 * from the model. Every clock is charged to one cause in one region: each step of an
 * instruction charges the time since the previous step.
 *
 * Scalar unit: instructions issue in order, at most one per clock. An instruction waits
 * for its operands (a scoreboard holds the time at which each register is ready), for
 * its unit and for memory. Vector unit: the start-up comes first, then the stream. The
 * issue clock is the first clock of the start-up. The scalar unit continues during a
 * vector instruction unless it needs memory, the vector result or the vector unit. The
 * wait is charged to the phases of the vector instruction that it falls in, and to the
 * region of that instruction.
 *
 * An instruction is charged as a whole after it has executed. A run may stop before
 * that, by a trap or within a vector instruction. The clock then shows the time of the
 * stop, which is not charged yet. When the run continues, the clock returns to the
 * charged time, so the total does not depend on the stop.
 */
#ifndef C205_CLOCK_H
#define C205_CLOCK_H

#include "vm/block.h"

struct clock;
struct serializer;

/* Returns a new clock. All constants of the model must be valid. NULL: the host is out
 * of memory. */
struct clock *clock_new(const c205_model *model, c205_error *error);
void clock_free(struct clock *clock);

/* Sets the names of the regions and zeroes their accounts. names[0] is "". Returns
 * false if the host is out of memory. */
bool clock_set_regions(struct clock *clock, const char *const *names, size_t count,
                       c205_error *error);

/* clock_reset sets time and accounts to zero and empties the pipes. Only
 * clock_forget_pages clears the resident pages and the associative registers. */
void clock_reset(struct clock *clock);
void clock_forget_pages(struct clock *clock);

/* Makes the pages of a range resident and enters them into the associative
 * registers. */
void clock_warm_page(struct clock *clock, uint64_t address, uint64_t bits);

/* Charges an instruction that has executed. */
void clock_charge(struct clock *clock, const struct decoded *decoded,
                  const struct effect *effect);
/* Charges the first count instructions of a block, which have executed; effect combines
 * their effects. The first such call makes the clock lazy: it no longer updates the
 * times of registers and units. Only clock_now may be called on a lazy clock.
 * clock_materialize computes these times again, after which all functions may be
 * called. */
void clock_charge_block(struct clock *clock, struct code_block *block, unsigned count,
                        const struct effect *effect);
void clock_materialize(struct clock *clock);
/* Sets block->longest, the maximum time of a new block. */
void clock_measure(const struct clock *clock, struct code_block *block);
/* Returns the clock at which everything in flight is done. After clock_charge_block,
 * clock_materialize must be called first. */
uint64_t clock_all_done(const struct clock *clock);
/* Waits until everything in flight is done, and charges the wait. */
void clock_drain(struct clock *clock);

/* Sets the record that receives the times of each instruction from now on; NULL:
 * none. */
void clock_listen(struct clock *clock, c205_times *record);
/* Returns the clock at which the latest instruction issued. */
uint64_t clock_issued(const struct clock *clock);

/* Returns the number of elements of the next vector instruction that will have streamed
 * at a given clock. The result ignores misses, faults and conflicts, which are known
 * only after execution. */
size_t clock_elements(const struct clock *clock, const struct decoded *decoded,
                      uint64_t until);
/* clock_show sets the clock to a given time within the next vector instruction, without
 * charging this time. clock_show_drained sets it to the time when everything in flight
 * is done. */
void clock_show(struct clock *clock, const struct decoded *decoded, uint64_t until);
void clock_show_drained(struct clock *clock);
/* clock_go_back returns from the time that is shown to the charged time. clock_commit
 * charges the time that is shown. */
void clock_go_back(struct clock *clock);
void clock_commit(struct clock *clock);

/* Serializes the whole clock except the names of its regions. A clock that is read must
 * have the same model and regions. */
void clock_walk(struct clock *clock, struct serializer *serializer);

/* Returns the clocks charged so far: the sum of all accounts. */
uint64_t clock_now(const struct clock *clock);
size_t clock_account_count(const struct clock *clock);
const c205_account *clock_account(const struct clock *clock, size_t i);

#endif
