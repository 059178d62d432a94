/* clock.c - computes the waits and the cost of each instruction.
 *
 * Rules and formulas with their sources: docs/timing.md.
 */
#include "vm/time/clock_parts.h"
#include "vm/min_max.h"

#include <assert.h>

/* ---- The time line ------------------------------------------------------- */

/* The reason why an instruction waits, for the record of its times. */
struct wait_reason {
    c205_wait wait;
    unsigned number;
};
static const struct wait_reason no_wait = { C205_WAIT_NONE, 0 },
                                for_loads = { C205_WAIT_LOADS, 0 },
                                for_results = { C205_WAIT_RESULTS, 0 },
                                for_vector = { C205_WAIT_VECTOR, 0 };

/* Adds clocks with their cause, region and reason to the record of the listener. */
static void note(const struct clock *clock, uint64_t clocks, c205_cause cause,
                 size_t region, uint64_t pc, struct wait_reason reason)
{
    c205_times *record = clock->record;
    if (clocks == 0)
        return;
    if (record->piece_count == C205_PIECES) { /* no known instruction has this many
                                                 pieces */
        record->piece[C205_PIECES - 1].clocks += clocks;
        return;
    }
    record->piece[record->piece_count++] = (c205_piece){ clocks,      cause,
                                                         region,      pc,
                                                         reason.wait, reason.number };
}

static inline void spend_for(struct clock *clock, uint64_t clocks, c205_cause cause,
                             struct wait_reason reason)
{
    if (clock->record)
        note(clock, clocks, cause, clock->region, clock->record->pc, reason);
    clock->account->clocks[cause] += clocks;
    clock->now += clocks;
}

static inline void spend(struct clock *clock, uint64_t clocks, c205_cause cause)
{
    spend_for(clock, clocks, cause, no_wait);
}

static inline void wait_until(struct clock *clock, uint64_t until, c205_cause cause,
                              struct wait_reason reason)
{
    if (clock->now < until)
        spend_for(clock, until - clock->now, cause, reason);
}

/* Waits for a clock at which the vector unit is still busy. The part of the wait in
 * each phase of the vector unit is charged to the cause and region of that phase. */
static inline void wait_through_phases(struct clock *clock, uint64_t until,
                                       struct wait_reason reason)
{
    c205_account *accounts = clock->accounts.account;
    uint64_t now = clock->now;
    for (const struct phase *phase = clock->phase; now < until; phase++) {
        uint64_t end = phase->end < until ? phase->end : until;
        if (now < end) {
            if (clock->record)
                note(clock, end - now, phase->cause, phase->region, phase->pc, reason);
            accounts[phase->region].clocks[phase->cause] += end - now;
            now = end;
        }
    }
    clock->now = now;
}

static void wait_for_vector(struct clock *clock)
{
    wait_through_phases(clock, clock->vector_end, for_vector);
}

static void wait_for_slot(struct clock *clock, uint16_t slot)
{
    struct wait_reason reason = { C205_WAIT_REGISTER, slot };
    if (clock->awaits[slot] == FOR_VECTOR)
        wait_through_phases(clock, clock->ready[slot], reason);
    else
        wait_until(clock, clock->ready[slot], (c205_cause)clock->awaits[slot], reason);
}

/* Waits until all sources are ready and no result of a result register is pending. */
static void wait_for_registers(struct clock *clock, const struct decoded *decoded)
{
    for (unsigned i = 0; i < decoded->source_count; i++)
        if (clock->ready[decoded->source[i]] > clock->now)
            wait_for_slot(clock, decoded->source[i]);
    for (unsigned i = 0; i < decoded->result_count; i++)
        if (clock->ready[decoded->result[i]] > clock->now)
            wait_for_slot(clock, decoded->result[i]);
}

static void set_results(struct clock *clock, const struct decoded *decoded,
                        uint64_t ready, unsigned awaits)
{
    for (unsigned i = 0; i < decoded->result_count; i++) {
        clock->ready[decoded->result[i]] = ready;
        clock->awaits[decoded->result[i]] = (uint8_t)awaits;
    }
}

/* Returns the quotient, by a 32-bit division if possible, which is faster on many
 * hosts. */
static inline uint64_t divided(uint64_t dividend, uint64_t divisor)
{
    if ((dividend | divisor) <= UINT32_MAX)
        return (uint32_t)dividend / (uint32_t)divisor;
    return dividend / divisor;
}

static inline uint64_t at_rate(struct rate rate, uint64_t n)
{
    return divided(n * rate.clocks + rate.per - 1, rate.per);
}

/* ---- The scalar unit ----------------------------------------------------- */

static void note_times(const struct clock *clock, uint64_t ready, uint64_t unit_free)
{
    clock->record->issued = clock->issued;
    clock->record->ready = ready;
    clock->record->unit_free = unit_free;
}

/* Waits for the unit of the instruction, then issues it. Returns the clock at which its
 * result is ready. */
static uint64_t issue(struct clock *clock, const struct decoded *decoded,
                      c205_cause awaits)
{
    const struct clock_timing *timing = &clock->timing[decoded->insn->timing];
    uint64_t *free_at = &clock->free_at[decoded->insn->unit];
    struct wait_reason unit = { C205_WAIT_UNIT, decoded->insn->unit };
    wait_until(clock, *free_at, C205_UNIT_BUSY, unit);
    clock->issued = clock->now;
    uint64_t ready = clock->now + timing->latency;
    *free_at = clock->now + timing->busy;
    if (clock->record)
        note_times(clock, ready, *free_at);
    spend(clock, clock->issue_interval, C205_ISSUE);
    set_results(clock, decoded, ready, awaits);
    if (clock->results_done < ready)
        clock->results_done = ready;
    return ready;
}

static inline struct translation translate(struct clock *clock,
                                           const struct effect *effect)
{
    struct translation met = { 0, 0 };
    const struct touch *touch = effect->touch;
    for (unsigned left = effect->touch_count; left > 0; left--, touch++)
        pages_touch(&clock->pages, touch->address, touch->bits, &met);
    if (effect->indices) {
        index_list_meet(&clock->list, effect->indices, effect->index_count);
        pages_touch_indexed(&clock->pages, effect->table, effect->table_step,
                            &clock->list, &met);
    }
    if (clock->record) {
        clock->record->misses = met.misses;
        clock->record->faults = met.faults;
    }
    return met;
}

/* Lets a scalar instruction wait for the vector unit and for the translation of its
 * addresses before it accesses memory. */
static void reach_memory(struct clock *clock, const struct effect *effect)
{
    wait_for_vector(clock);
    struct translation met = translate(clock, effect);
    if (met.misses == 0)
        return;
    spend(clock, met.misses * clock->translation_miss, C205_TRANSLATION_MISS);
    spend(clock, met.faults * clock->page_fault, C205_PAGE_FAULT);
}

static void charge_load(struct clock *clock, const struct decoded *decoded)
{
    uint64_t *oldest = &clock->load_end[clock->load];
    wait_until(clock, *oldest, C205_MEMORY_WAIT, for_loads);
    *oldest = issue(clock, decoded, C205_MEMORY_WAIT);
    if (clock->loads_done < *oldest)
        clock->loads_done = *oldest;
    clock->load++;
    if (clock->load == clock->loads_in_flight)
        clock->load = 0;
}

/* Charges a SWAP. It waits for all registers that it moves, and no instruction issues
 * before it is done. */
static void charge_swap(struct clock *clock, const struct decoded *decoded,
                        const struct effect *effect)
{
    wait_until(clock, clock->loads_done, C205_MEMORY_WAIT, for_loads);
    wait_until(clock, clock->results_done, C205_OPERAND_WAIT, for_results);
    uint64_t begun = issue(clock, decoded, C205_MEMORY_WAIT);
    uint64_t end = begun + at_rate(clock->swap_word, effect->swapped);
    wait_until(clock, end, C205_MEMORY_WAIT, no_wait);
    if (clock->record)
        clock->record->ready = end;
}

static void charge_memory(struct clock *clock, const struct decoded *decoded,
                          const struct effect *effect)
{
    reach_memory(clock, effect);
    if (decoded->insn->timing == C205_TIMING_load)
        charge_load(clock, decoded);
    else if (decoded->insn->timing == C205_TIMING_swap)
        charge_swap(clock, decoded, effect);
    else
        issue(clock, decoded, C205_OPERAND_WAIT);
}

static void charge_branch(struct clock *clock, const struct decoded *decoded,
                          const struct effect *effect)
{
    if (effect->touch_count > 0)
        reach_memory(clock, effect);
    issue(clock, decoded, C205_OPERAND_WAIT);
    if (!effect->taken) {
        spend(clock, clock->branch_not_taken, C205_BRANCH);
        return;
    }
    stack_extend(&clock->stack, decoded->next, clock->stack_words);
    clock->stack.next = effect->target;
    if (stack_holds(&clock->stack, effect->target)) {
        spend(clock, clock->branch_taken, C205_BRANCH);
        return;
    }
    stack_begin(&clock->stack, effect->target);
    spend(clock, clock->branch_out_of_stack, C205_BRANCH);
}

/* Charges a monitor call. The scalar unit waits until the monitor has served it. */
static void charge_monitor(struct clock *clock, const struct decoded *decoded)
{
    uint64_t done = issue(clock, decoded, C205_OPERAND_WAIT);
    wait_until(clock, done, C205_BRANCH, no_wait);
}

/* ---- The vector unit ----------------------------------------------------- */

static void note_phase(const struct clock *clock, uint64_t clocks, c205_cause cause)
{
    c205_times *record = clock->record;
    size_t i = record->phase_count++;
    record->phase[i].begin = clock->vector_end;
    record->phase[i].end = clock->vector_end + clocks;
    record->phase[i].cause = cause;
}

/* Appends a phase at the end of the work of the vector unit. */
static inline void add_phase(struct clock *clock, uint64_t clocks, c205_cause cause)
{
    struct phase *phase = &clock->phase[clock->phase_count];
    if (clocks == 0)
        return;
    if (clock->record)
        note_phase(clock, clocks, cause);
    clock->vector_end += clocks;
    phase->end = clock->vector_end;
    phase->cause = cause;
    phase->region = clock->region;
    phase->pc = clock->vector_pc;
    clock->phase_count++;
}

/* Drops the phases that have ended. The stream of the previous instruction may remain,
 * because it may overlap the start-up of the next instruction. */
static inline void drop_phases(struct clock *clock)
{
    size_t kept = 0;
    for (size_t i = 0; i < clock->phase_count; i++)
        if (clock->phase[i].end > clock->now)
            clock->phase[kept++] = clock->phase[i];
    clock->phase_count = kept;
}

/* Returns the clock at which the vector unit accepts an instruction with this start-up.
 * The start-up may overlap the stream of the previous instruction by up to `overlap`
 * clocks. */
static uint64_t vector_free_at(const struct clock *clock, uint64_t startup)
{
    uint64_t hidden = min_uint64(min_uint64(clock->overlap, startup),
                                 clock->vector_tail);
    return clock->vector_end - hidden;
}

static bool is_slower(struct rate rate, struct rate than)
{
    return rate.clocks * than.per > than.clocks * rate.per;
}

static inline struct rate class_rate(const struct clock *clock,
                                     const struct decoded *decoded, bool half)
{
    const struct clock_timing *timing = &clock->timing[decoded->insn->timing];
    return half ? timing->half_stream : timing->stream;
}

/* Returns the rate of a linked pair, which is the rate of its slower member. The
 * elements of both members have the same size. */
static struct rate pair_rate(const struct clock *clock, const struct decoded *decoded)
{
    const struct decoded *const *linked = decoded->linked;
    bool half = linked[0]->fields.g & C205_G_HALF;
    struct rate slowest = class_rate(clock, decoded, half);
    for (size_t i = 0; i < 2 && linked[i]; i++) {
        struct rate rate = class_rate(clock, linked[i], half);
        if (is_slower(rate, slowest))
            slowest = rate;
    }
    return slowest;
}

static inline struct rate stream_rate(const struct clock *clock,
                                      const struct decoded *decoded)
{
    if (decoded->linked[0])
        return pair_rate(clock, decoded);
    return class_rate(clock, decoded, decoded->fields.g & C205_G_HALF);
}

/* Returns the start-up of a vector instruction. The constant for a linked pair assumes
 * two units with the start-up of the addition. A member with a longer start-up adds the
 * difference. */
static inline uint64_t startup_of(const struct clock *clock,
                                  const struct decoded *decoded)
{
    uint64_t startup = clock->timing[decoded->insn->timing].startup;
    uint64_t addition = clock->timing[C205_TIMING_vadd].startup;
    for (size_t i = 0; i < 2 && decoded->linked[i]; i++) {
        c205_timing member = decoded->linked[i]->insn->timing;
        uint64_t own = clock->timing[member].startup;
        startup += own > addition ? own - addition : 0;
    }
    return startup;
}

static inline void add_phases(struct clock *clock, const struct decoded *decoded,
                              const struct effect *effect, uint64_t startup)
{
    struct translation met = translate(clock, effect);
    uint64_t stream = at_rate(stream_rate(clock, decoded), effect->elements)
                      + effect->recurrent * startup;
    clock->vector_end = clock->now;
    clock->vector_tail = stream;
    clock->vector_pc = decoded->pc;
    add_phase(clock, startup, C205_VECTOR_STARTUP);
    if (met.misses > 0) { /* each fault is also a miss */
        add_phase(clock, met.misses * clock->translation_miss, C205_TRANSLATION_MISS);
        add_phase(clock, met.faults * clock->page_fault, C205_PAGE_FAULT);
    }
    if (effect->indices)
        add_phase(clock,
                  banks_conflicts(&clock->banks, effect->table, effect->table_step,
                                  &clock->list),
                  C205_BANK_CONFLICT);
    add_phase(clock, stream, C205_VECTOR_STREAM);
}

/* Waits for the registers of both members of a linked pair. */
static void wait_for_pair(struct clock *clock, const struct decoded *decoded)
{
    for (size_t i = 0; i < 2; i++)
        if (decoded->linked[i])
            wait_for_registers(clock, decoded->linked[i]);
}

static inline void charge_vector(struct clock *clock, const struct decoded *decoded,
                                 const struct effect *effect)
{
    uint64_t startup = startup_of(clock, decoded);
    if (decoded->linked[0])
        wait_for_pair(clock, decoded);
    wait_until(clock, clock->loads_done, C205_MEMORY_WAIT, for_loads);
    wait_through_phases(clock, vector_free_at(clock, startup), for_vector);
    drop_phases(clock);
    clock->issued = clock->now;
    uint64_t issued = clock->now + clock->issue_interval;
    add_phases(clock, decoded, effect, startup);
    if (clock->record)
        note_times(clock, clock->vector_end, clock->vector_end);
    wait_through_phases(clock, min_uint64(issued, clock->vector_end), no_wait);
    wait_until(clock, issued, C205_ISSUE, no_wait);
    set_results(clock, decoded, clock->vector_end, FOR_VECTOR);
    clock->account->vector_instructions++;
    clock->account->elements += effect->elements;
    clock->account->operations += decoded->flops * (effect->elements - effect->idle);
}

/* ---- One instruction ----------------------------------------------------- */

static void begin_record(const struct clock *clock, uint64_t pc)
{
    c205_times *record = clock->record;
    record->pc = pc;
    record->arrived = clock->now;
    record->piece_count = record->phase_count = 0;
    record->misses = record->faults = 0;
}

void clock_charge(struct clock *clock, const struct decoded *decoded,
                  const struct effect *effect)
{
    clock_enter_region(clock, decoded->region);
    if (clock->record)
        begin_record(clock, decoded->pc);
    if (decoded->pc != clock->stack.next)
        stack_begin(&clock->stack, decoded->pc);
    clock->stack.next = decoded->next;
    clock->account->instructions++;
    wait_for_registers(clock, decoded);
    switch (decoded->insn->unit) {
    case C205_UNIT_VECTOR:
    case C205_UNIT_V_ADD:
    case C205_UNIT_V_MULTIPLY:
    case C205_UNIT_V_DIVIDE:
    case C205_UNIT_V_SHIFT:
    case C205_UNIT_V_LOGICAL: charge_vector(clock, decoded, effect); break;
    case C205_UNIT_MEMORY: charge_memory(clock, decoded, effect); break;
    case C205_UNIT_BRANCH:
        if (decoded->insn->timing == C205_TIMING_monitor)
            charge_monitor(clock, decoded);
        else
            charge_branch(clock, decoded, effect);
        break;
    default:
        issue(clock, decoded, C205_OPERAND_WAIT);
        clock->account->operations += decoded->flops;
        break;
    }
}

static void check_sum(const struct clock *clock)
{
    assert(accounts_sum(&clock->accounts) == clock->now);
}

void clock_drain(struct clock *clock)
{
    if (clock->record)
        begin_record(clock, clock->record->pc);
    wait_for_vector(clock);
    wait_until(clock, clock->loads_done, C205_MEMORY_WAIT, for_loads);
    wait_until(clock, clock->results_done, C205_OPERAND_WAIT, for_results);
    check_sum(clock);
}

/* ---- Within an instruction ----------------------------------------------- */

static uint64_t registers_ready(const struct clock *clock,
                                const struct decoded *decoded)
{
    uint64_t ready = 0;
    for (unsigned i = 0; i < decoded->source_count; i++)
        ready = max_uint64(ready, clock->ready[decoded->source[i]]);
    for (unsigned i = 0; i < decoded->result_count; i++)
        ready = max_uint64(ready, clock->ready[decoded->result[i]]);
    return ready;
}

/* Returns the clock at which a vector instruction starts to stream. */
static uint64_t stream_begin(const struct clock *clock, const struct decoded *decoded)
{
    uint64_t startup = startup_of(clock, decoded);
    uint64_t issue = max_uint64(clock->now, registers_ready(clock, decoded));
    for (size_t i = 0; i < 2; i++)
        if (decoded->linked[i])
            issue = max_uint64(issue, registers_ready(clock, decoded->linked[i]));
    issue = max_uint64(issue, clock->loads_done);
    return max_uint64(issue, vector_free_at(clock, startup)) + startup;
}

/* Returns the largest number of elements that take at most `clocks` at a rate. */
static size_t in_clocks(struct rate rate, uint64_t clocks)
{
    if (rate.clocks == 0)
        return SIZE_MAX;
    uint64_t whole = divided(clocks, rate.clocks);
    uint64_t rest = clocks - whole * rate.clocks;
    bool small = (whole | rate.per) <= UINT32_MAX;
    if (!small && whole >= SIZE_MAX / rate.per)
        return SIZE_MAX;
    return (size_t)(whole * rate.per + divided(rest * rate.per, rate.clocks));
}

size_t clock_elements(const struct clock *clock, const struct decoded *decoded,
                      uint64_t until)
{
    uint64_t begin = stream_begin(clock, decoded);
    return in_clocks(stream_rate(clock, decoded), until > begin ? until - begin : 0);
}

static void keep_charged(struct clock *clock)
{
    accounts_keep(&clock->accounts);
    clock->kept_now = clock->now;
    clock->ahead = true;
}

/* Limits all pending times to a clock, so no instruction waits beyond it. */
static void cut_at(struct clock *clock, uint64_t until)
{
    for (size_t i = 0; i < SLOTS; i++)
        clock->ready[i] = min_uint64(clock->ready[i], until);
    for (size_t i = 0; i < clock->phase_count; i++)
        clock->phase[i].end = min_uint64(clock->phase[i].end, until);
    clock->vector_end = min_uint64(clock->vector_end, until);
    clock->loads_done = min_uint64(clock->loads_done, until);
}

void clock_show(struct clock *clock, const struct decoded *decoded, uint64_t until)
{
    uint64_t begin = stream_begin(clock, decoded);
    struct clock cut = *clock; /* shares the accounts with *clock */
    cut.record = NULL;
    keep_charged(clock);
    cut_at(&cut, until);
    cut.account = &cut.accounts.account[decoded->region];
    wait_for_registers(&cut, decoded);
    wait_for_pair(&cut, decoded);
    wait_until(&cut, cut.loads_done, C205_MEMORY_WAIT, for_loads);
    wait_for_vector(&cut);
    wait_until(&cut, min_uint64(begin, until), C205_VECTOR_STARTUP, no_wait);
    wait_until(&cut, until, C205_VECTOR_STREAM, no_wait);
    clock->now = cut.now;
    check_sum(clock);
}

void clock_show_drained(struct clock *clock)
{
    keep_charged(clock);
    clock_drain(clock);
}

void clock_go_back(struct clock *clock)
{
    if (!clock->ahead)
        return;
    accounts_put_back(&clock->accounts);
    clock->now = clock->kept_now;
    clock->ahead = false;
}

void clock_commit(struct clock *clock)
{
    clock->ahead = false;
}

/* ---- Queries ------------------------------------------------------------ */

uint64_t clock_now(const struct clock *clock)
{
    return clock->now;
}

void clock_listen(struct clock *clock, c205_times *record)
{
    clock->record = record;
}

void clock_warm_page(struct clock *clock, uint64_t address, uint64_t bits)
{
    struct translation met = { 0, 0 };
    pages_touch(&clock->pages, address, bits, &met);
}

uint64_t clock_issued(const struct clock *clock)
{
    return clock->issued;
}

size_t clock_account_count(const struct clock *clock)
{
    return clock->accounts.count;
}

const c205_account *clock_account(const struct clock *clock, size_t i)
{
    return &clock->accounts.account[i];
}
