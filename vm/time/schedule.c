/* schedule.c - finds the schedule of a block, charges the block by it, and creates new
 * schedules.
 *
 * When the table of schedules or the table of states is full, both are cleared. The
 * clock then gets a new generation number, which invalidates the schedules of every
 * block.
 */
#include "vm/time/schedule.h"

#include "vm/memory.h"
#include "vm/min_max.h"

#include <stdlib.h>
#include <string.h>

enum {
    SCHEDULES = 1 << (TABLE_BITS - 1),
    SCHEDULES_OF_BLOCK = 24,
    PATIENCE = 8 /* blocks before the clock becomes lazy */
};

struct schedules {
    size_t count;
    struct schedule schedule[SCHEDULES];
    struct in_flight_table flights;
};

struct schedules *schedules_new(void)
{
    struct schedules *schedules = malloc(sizeof *schedules);
    if (schedules) {
        schedules->count = 0;
        in_flight_init(&schedules->flights);
    }
    return schedules;
}

void schedules_free(struct schedules *schedules)
{
    free(schedules);
}

/* Drops all schedules and states. They are dropped together, because schedules refer to
 * states by address. */
static void forget_all(struct clock *clock)
{
    clock->schedules->count = 0;
    in_flight_clear(&clock->schedules->flights);
    clock->generation++;
}

/* ---- Lazy clocks -------------------------------------------------------- */

/* Makes the clock lazy (schedule.h). Reading the state in flight takes time, so it is
 * postponed if the state may soon be empty or the vector unit soon busy again. Returns
 * false if the clock is not lazy afterwards. */
static bool fold(struct clock *clock)
{
    struct in_flight_table *flights = &clock->schedules->flights;
    struct in_flight flight;
    if (clock->vector_end > clock->now)
        return false;
    if (in_flight_is_nothing(clock)) {
        clock->flight = &flights->nothing;
        return true;
    }
    if (clock->blocks_since++ < PATIENCE || !in_flight_look(clock, &flight))
        return false;
    clock->flight = in_flight_named(flights, &flight);
    if (!clock->flight)
        forget_all(clock);
    return clock->flight;
}

static void add_times(c205_account *account, const c205_account *once, uint64_t times)
{
    for (int cause = 0; cause < C205_CAUSES; cause++)
        account->clocks[cause] += times * once->clocks[cause];
    account->instructions += times * once->instructions;
    account->operations += times * once->operations;
}

static void commit_accounts(struct clock *clock)
{
    struct schedule *schedule = clock->charged;
    for (; schedule; schedule = schedule->more) {
        add_times(schedule->account, &schedule->once, schedule->times);
        schedule->times = 0;
    }
    clock->charged = NULL;
}

void clock_materialize(struct clock *clock)
{
    if (!clock->flight)
        return;
    in_flight_show(clock, clock->flight);
    commit_accounts(clock);
    clock->flight = NULL;
    clock->blocks_since = 0;
}

/* ---- Limits -------------------------------------------------------------- */

static bool touches_memory(const struct decoded *decoded)
{
    c205_format format = decoded->insn->format;
    return format == C205_FORMAT_MEMORY || format == C205_FORMAT_ALTERB;
}

/* Returns the maximum number of pages that an instruction touches. SWAP uses two
 * ranges, each on at most two pages. */
static uint64_t pages_most(const struct decoded *decoded)
{
    return decoded->insn->timing == C205_TIMING_swap ? 4 : touches_memory(decoded);
}

static uint64_t longest_of(const struct clock *clock, const struct decoded *decoded)
{
    const struct clock_timing *timing = &clock->timing[decoded->insn->timing];
    struct rate swap_word = clock->swap_word;
    uint64_t longest = timing->latency + timing->busy + clock->issue_interval;
    if (decoded->insn->unit == C205_UNIT_BRANCH)
        longest += clock->branch_taken + clock->branch_not_taken
                   + clock->branch_out_of_stack;
    if (decoded->insn->timing == C205_TIMING_swap)
        longest += 2 * C205_REGISTERS * swap_word.clocks / swap_word.per + 1;
    return longest
           + pages_most(decoded) * (clock->translation_miss + clock->page_fault);
}

void clock_measure(const struct clock *clock, struct code_block *block)
{
    block->longest = 0;
    for (unsigned i = 0; i < block->count; i++)
        block->longest += longest_of(clock, &block->insn[i]);
}

uint64_t clock_all_done(const struct clock *clock)
{
    uint64_t done = max_uint64(clock->now, clock->vector_end);
    for (size_t i = 0; i < C205_UNITS; i++)
        done = max_uint64(done, clock->free_at[i]);
    return max_uint64(done, clock->results_done);
}

/* ---- Blocks -------------------------------------------------------------- */

/* Looks up the pages that a block touches. Returns false if the associative registers
 * do not hold one of them. Otherwise only the order of the pages changes. Looking up a
 * page twice has no further effect. */
static bool reach_known_pages(struct pages *pages, const struct effect *effect)
{
    struct translation met = { 0, 0 };
    for (unsigned i = 0; i < effect->touch_count; i++) {
        const struct touch *touch = &effect->touch[i];
        uint64_t last = (touch->address + touch->bits - 1) >> pages->shift;
        uint64_t page = touch->address >> pages->shift;
        for (; page <= last; page++) {
            if (page == pages->latest)
                continue;
            if (!pages_know(pages, page))
                return false;
            pages_look_up(pages, page, &met);
        }
    }
    return true;
}

static struct schedule *find_schedule(const struct clock *clock,
                                      const struct code_block *block, uint64_t leaves)
{
    struct schedule *schedule = block->schedules;
    while (schedule && (schedule->from != clock->flight || schedule->leaves != leaves))
        schedule = schedule->next;
    return schedule;
}

/* Charges a block instruction by instruction. effect->touch has the memory ranges of
 * all instructions, in order: one for each instruction that accesses memory, and any
 * number for the last instruction. */
static void charge_each(struct clock *clock, const struct code_block *block,
                        unsigned count, const struct effect *effect)
{
    struct effect own;
    const struct touch *touch = effect->touch;
    memset(&own, 0, sizeof own);
    for (unsigned i = 0; i + 1 < count; i++) {
        const struct decoded *decoded = &block->insn[i];
        own.touch_count = touches_memory(decoded);
        if (own.touch_count)
            own.touch[0] = *touch++;
        clock_charge(clock, decoded, &own);
    }
    for (own.touch_count = 0; touch < effect->touch + effect->touch_count;)
        own.touch[own.touch_count++] = *touch++;
    own.taken = effect->taken;
    own.target = effect->target;
    own.swapped = effect->swapped;
    clock_charge(clock, &block->insn[count - 1], &own);
}

static c205_account difference(const c205_account *account, const c205_account *before)
{
    c205_account more = { .name = NULL };
    for (int cause = 0; cause < C205_CAUSES; cause++)
        more.clocks[cause] = account->clocks[cause] - before->clocks[cause];
    more.instructions = account->instructions - before->instructions;
    more.operations = account->operations - before->operations;
    return more;
}

static void keep_schedule(struct schedules *schedules, struct code_block *block,
                          const struct schedule *found)
{
    struct schedule *schedule = &schedules->schedule[schedules->count++];
    *schedule = *found;
    schedule->next = block->schedules;
    block->schedules = schedule;
    block->schedule_count++;
}

/* Charges a block instruction by instruction. If the states before and after can both
 * be stored, the difference is stored as a schedule. */
static void find_out(struct clock *clock, struct code_block *block, unsigned count,
                     const struct effect *effect, uint64_t leaves)
{
    struct schedule found = { .from = clock->flight, .leaves = leaves };
    clock_materialize(clock);
    uint64_t before = clock->now, generation = clock->generation;
    c205_account account = *clock->account;
    charge_each(clock, block, count, effect);
    clock->blocks_since = PATIENCE;
    if (clock->schedules->count == SCHEDULES)
        forget_all(clock);
    if (!fold(clock) || generation != clock->generation)
        return;
    found.to = clock->flight;
    found.clocks = clock->now - before;
    found.account = clock->account;
    found.once = difference(clock->account, &account);
    keep_schedule(clock->schedules, block, &found);
}

static void check_generation(const struct clock *clock, struct code_block *block)
{
    if (block->generation == clock->generation)
        return;
    block->generation = clock->generation;
    block->schedules = NULL;
    block->schedule_count = 0;
}

/* Charges a block with the stored costs of a schedule. Returns false if this is not
 * possible, so that each instruction must be charged. */
static bool charge_whole(struct clock *clock, struct code_block *block, unsigned count,
                         const struct effect *effect)
{
    struct stack stack = clock->stack;
    if ((!clock->flight && !fold(clock)) || !reach_known_pages(&clock->pages, effect))
        return false;
    check_generation(clock, block);
    uint64_t leaves = stack_follow(&stack, clock->stack_words, block, count, effect);
    struct schedule *schedule = find_schedule(clock, block, leaves);
    if (schedule) {
        clock->stack = stack;
        follow_schedule(clock, schedule);
        return true;
    }
    if (block->schedule_count == SCHEDULES_OF_BLOCK)
        return false;
    find_out(clock, block, count, effect, leaves);
    return true;
}

void clock_charge_block(struct clock *clock, struct code_block *block, unsigned count,
                        const struct effect *effect)
{
    if (count == 0)
        return;
    clock_enter_region(clock, block->region);
    if (charge_whole(clock, block, count, effect))
        return;
    clock_materialize(clock);
    charge_each(clock, block, count, effect);
}
