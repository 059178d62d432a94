/* schedule.h - stores the costs of blocks of scalar instructions, and charges them when
 * a block runs again.
 *
 * The cost of a block and the state in flight after it depend only on the state in
 * flight before it and on where and how control leaves it. This holds while the vector
 * unit is idle and the associative registers hold all pages of the block. The first
 * execution of a block is charged instruction by instruction as in clock.c. A schedule
 * stores the changes of the accounts and of the state. Later executions with the same
 * state add the schedule at once.
 *
 * While the clock moves from schedule to schedule it is lazy: it stores the state in
 * flight as a pointer, and ready, free_at and similar fields are invalid. Each schedule
 * counts its executions. The clocks are added to the accounts before they are read.
 */
#ifndef C205_SCHEDULE_H
#define C205_SCHEDULE_H

#include "vm/block.h"
#include "vm/time/clock_parts.h"
#include "vm/time/in_flight.h"

struct schedule {
    struct schedule *next; /* next schedule of the block */
    const struct in_flight *from, *to;
    uint64_t leaves; /* code of where and how control leaves the block */
    uint64_t clocks;
    uint64_t times;        /* executions that are not in the accounts yet */
    struct schedule *more; /* next schedule with such executions */
    c205_account *account; /* account of the region */
    c205_account once;     /* charge of one execution */
};

enum { GOES_ON, TAKEN, TAKEN_OUT_OF_STACK, COUNT_SHIFT = 2, SWAP_SHIFT = 16 };

/* Returns a code of where and how control leaves a block, and of the number of
 * registers that were swapped. Updates the instruction stack. */
static inline uint64_t stack_follow(struct stack *stack, uint64_t words,
                                    const struct code_block *block, unsigned count,
                                    const struct effect *effect)
{
    uint64_t leaves = (uint64_t)effect->swapped << SWAP_SHIFT
                      | (uint64_t)count << COUNT_SHIFT;
    if (block->pc != stack->next)
        stack_begin(stack, block->pc);
    stack->next = block->insn[count - 1].next;
    if (!effect->taken)
        return leaves | GOES_ON;
    stack_extend(stack, stack->next, words);
    stack->next = effect->target;
    if (stack_holds(stack, effect->target))
        return leaves | TAKEN;
    stack_begin(stack, effect->target);
    return leaves | TAKEN_OUT_OF_STACK;
}

/* Returns true if all touched addresses are on the page that was looked up last. */
static inline bool touches_latest(const struct pages *pages,
                                  const struct effect *effect)
{
    uint64_t others = 0;
    for (unsigned i = 0; i < effect->touch_count; i++) {
        const struct touch *touch = &effect->touch[i];
        uint64_t last = touch->address + touch->bits - 1;
        others |= touch->address >> pages->shift ^ pages->latest;
        others |= last >> pages->shift ^ pages->latest;
    }
    return others == 0;
}

static inline void follow_schedule(struct clock *clock, struct schedule *schedule)
{
    clock->now += schedule->clocks;
    clock->flight = schedule->to;
    if (schedule->times++ > 0)
        return;
    schedule->more = clock->charged;
    clock->charged = schedule;
}

/* The fast path of clock_charge_block. Returns false if the slow path must charge the
 * block. */
static inline bool clock_repeat(struct clock *clock, const struct code_block *block,
                                unsigned count, const struct effect *effect)
{
    if (count == 0 || block->region != clock->region
        || block->generation != clock->generation
        || !touches_latest(&clock->pages, effect))
        return false;
    struct stack stack = clock->stack;
    uint64_t leaves = stack_follow(&stack, clock->stack_words, block, count, effect);
    struct schedule *schedule = block->schedules;
    while (schedule && (schedule->from != clock->flight || schedule->leaves != leaves))
        schedule = schedule->next;
    if (!schedule)
        return false;
    clock->stack = stack;
    follow_schedule(clock, schedule);
    return true;
}

/* Returns true only if a block certainly ends before a limit. */
static inline bool clock_ends_before(const struct clock *clock,
                                     const struct code_block *block, uint64_t limit)
{
    uint64_t latest = clock->flight ? clock->now + clock->flight->latest
                                    : clock_all_done(clock);
    return latest + block->longest < limit;
}

struct schedules *schedules_new(void);
void schedules_free(struct schedules *schedules);

#endif
