/* schedule.h - what blocks of scalar instructions cost, remembered.
 *
 * What a block costs, and what is in flight behind it, depends on what was in
 * flight before it, on where control leaves it and how, and on nothing else:
 * as long as the vector unit is idle and all pages are known to the
 * associative registers.  So the first time it is charged instruction by
 * instruction, as clock.c does it, and how the accounts and the flight changed
 * is kept as a schedule; when it comes again with the same flight, that is
 * added at once.
 *
 * While the clock goes from schedule to schedule it knows its flight by name
 * alone, and ready, free_at and the like say nothing; and how often a schedule
 * was followed is counted with it, and added to the accounts when somebody
 * may look at them.
 */
#ifndef C205_SCHEDULE_H
#define C205_SCHEDULE_H

#include "vm/block.h"
#include "vm/time/clock_parts.h"
#include "vm/time/in_flight.h"

struct schedule {
    struct schedule *next; /* of the block */
    const struct in_flight *from, *to;
    uint64_t leaves; /* where control leaves the block, and how .. */
    uint64_t clocks;
    uint64_t times;        /* that are not in the accounts yet .. */
    struct schedule *more; /* .. and the next that has some */
    c205_account *account; /* of the region .. */
    c205_account once;     /* .. and what it is charged each time */
};

enum { GOES_ON, TAKEN, TAKEN_OUT_OF_STACK, COUNT_SHIFT = 2, SWAP_SHIFT = 16 };

/* Where control leaves a block, and how, and how many registers were swapped
 * there; and the instruction stack behind. */
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

/* All that was touched lies on the page that was touched last. */
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

/* The quick way of clock_charge_block; false: it must go the other one. */
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

/* Will a block have ended before a limit, whatever it meets?  False: perhaps
 * not. */
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
