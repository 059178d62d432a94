/* clock_save.c - all that a clock is beyond its model, on a tape. */
#include "vm/time/clock_parts.h"
#include "vm/memory.h"
#include "vm/tape.h"

/* No run gets that far (3,000 years of the machine); sums of such times
 * with what one instruction costs do not overflow. */
#define LATEST (UINT64_MAX >> 2)

static const char wrong_account[] = "the accounts of the saved machine are wrong";
static const char wrong_flight[] = "what the saved machine has in flight is wrong";
static const char wrong_pages[] = "the list of pages of the saved machine is wrong";

/* ---- Accounts ------------------------------------------------------------ */

static void walk_account(c205_account *account, struct tape *tape)
{
    tape_array(tape, account->clocks, C205_CAUSES);
    tape_word(tape, &account->instructions);
    tape_word(tape, &account->vector_instructions);
    tape_word(tape, &account->elements);
    tape_word(tape, &account->operations);
    tape_word(tape, &account->entries);
}

/* The region, counted from one: none has been entered yet. */
static void walk_region(struct clock *clock, struct tape *tape)
{
    size_t entered = clock->region + 1;
    tape_size(tape, &entered, clock->accounts.count);
    if (!tape_is_read(tape))
        return;
    clock->region = entered - 1;
    clock->account = &clock->accounts.account[entered ? entered - 1 : 0];
}

static void walk_accounts(struct clock *clock, struct tape *tape)
{
    for (size_t i = 0; i < clock->accounts.count; i++)
        walk_account(&clock->accounts.account[i], tape);
    walk_region(clock, tape);
    tape_word(tape, &clock->now);
    tape_require(tape,
                 accounts_sum(&clock->accounts) == clock->now && clock->now <= LATEST,
                 wrong_account);
}

/* What has been charged, where more than that is shown. */
static void walk_charged(struct clock *clock, struct tape *tape)
{
    size_t ahead = clock->ahead;
    tape_size(tape, &ahead, 1);
    clock->ahead = ahead == 1;
    if (!clock->ahead)
        return;
    for (size_t i = 0; i < clock->accounts.count; i++)
        walk_account(&clock->accounts.kept[i], tape);
    tape_word(tape, &clock->kept_now);
    tape_require(tape,
                 accounts_sum_kept(&clock->accounts) == clock->kept_now
                     && clock->kept_now <= clock->now,
                 wrong_account);
}

static uint64_t charged(const struct clock *clock)
{
    return clock->ahead ? clock->kept_now : clock->now;
}

/* ---- In flight ----------------------------------------------------------- */

static void walk_time(uint64_t *time, struct tape *tape)
{
    tape_word(tape, time);
    tape_require(tape, *time <= LATEST, wrong_flight);
}

/* What is over is saved as if it had been over at clock 0. */
static void walk_pending(const struct clock *clock, uint64_t *time, struct tape *tape)
{
    uint64_t pending = *time > charged(clock) ? *time : 0;
    walk_time(&pending, tape);
    if (tape_is_read(tape))
        *time = pending;
}

static void walk_register(struct clock *clock, size_t slot, struct tape *tape)
{
    bool pending = clock->ready[slot] > charged(clock);
    size_t awaits = pending || tape_is_read(tape) ? clock->awaits[slot] : 0;
    tape_size(tape, &awaits, FOR_VECTOR);
    if (tape_is_read(tape))
        clock->awaits[slot] = (uint8_t)awaits;
}

/* From the oldest on. */
static void walk_loads(struct clock *clock, struct tape *tape)
{
    size_t loads = (size_t)clock->loads_in_flight, oldest = 0;
    for (size_t i = 0; i < loads; i++)
        walk_pending(clock, &clock->load_end[(clock->load + i) % loads], tape);
    tape_size(tape, &oldest, loads - 1);
    if (tape_is_read(tape))
        clock->load = oldest;
}

static void walk_scoreboard(struct clock *clock, struct tape *tape)
{
    for (size_t i = 0; i < SLOTS; i++)
        walk_pending(clock, &clock->ready[i], tape);
    for (size_t i = 0; i < SLOTS; i++)
        walk_register(clock, i, tape);
    walk_pending(clock, &clock->results_done, tape);
    walk_pending(clock, &clock->loads_done, tape);
    for (size_t i = 0; i < C205_UNITS; i++)
        walk_pending(clock, &clock->free_at[i], tape);
    walk_loads(clock, tape);
}

static void walk_phase(struct phase *phase, size_t regions, struct tape *tape)
{
    size_t cause = phase->cause;
    walk_time(&phase->end, tape);
    tape_size(tape, &cause, C205_CAUSES - 1);
    phase->cause = (c205_cause)cause;
    tape_size(tape, &phase->region, regions - 1);
    tape_word(tape, &phase->pc);
}

/* The phases follow each other up to the end; before the last one begins,
 * no start-up may hide. */
static bool phases_are_sound(const struct clock *clock)
{
    if (clock->phase_count == 0)
        return clock->vector_end <= charged(clock) && clock->vector_tail == 0;
    const struct phase *last = &clock->phase[clock->phase_count - 1];
    if (last->end != clock->vector_end || clock->vector_tail > clock->vector_end)
        return false;
    for (const struct phase *phase = clock->phase; phase < last; phase++)
        if (phase->end > phase[1].end
            || phase->end > clock->vector_end - clock->vector_tail)
            return false;
    return true;
}

/* A register that the vector unit delivers is ready when that is done. */
static bool output_are_sound(const struct clock *clock)
{
    for (size_t i = 0; i < SLOTS; i++)
        if (clock->awaits[i] == FOR_VECTOR && clock->ready[i] > charged(clock)
            && clock->ready[i] > clock->vector_end)
            return false;
    return true;
}

static void walk_vector_unit(struct clock *clock, struct tape *tape)
{
    tape_size(tape, &clock->phase_count, PHASES);
    for (size_t i = 0; i < clock->phase_count; i++)
        walk_phase(&clock->phase[i], clock->accounts.count, tape);
    walk_time(&clock->vector_end, tape);
    walk_time(&clock->vector_tail, tape);
    tape_require(tape, phases_are_sound(clock) && output_are_sound(clock),
                 wrong_flight);
}

/* ---- Control, pages ------------------------------------------------------ */

static void walk_stack(struct clock *clock, struct tape *tape)
{
    tape_word(tape, &clock->stack.next);
    tape_word(tape, &clock->stack.low);
    tape_word(tape, &clock->stack.high);
}

static void write_page_list(const struct pages *pages, struct tape *tape)
{
    const struct resident *resident = pages->resident;
    size_t count = pages->count;
    tape_size(tape, &count, pages->capacity);
    for (uint32_t at = resident[0].newer; at; at = resident[at].newer) {
        uint64_t page = resident[at].page;
        tape_word(tape, &page);
    }
}

/* No page stands in the list twice. */
static void read_page_list(struct pages *pages, struct tape *tape)
{
    struct translation met = { 0, 0 };
    size_t count = 0;
    tape_size(tape, &count, pages->capacity);
    pages_forget(pages);
    for (size_t i = 0; i < count; i++) {
        uint64_t page;
        tape_word(tape, &page);
        tape_require(tape, page <= ADDRESS_MASK >> pages->shift, wrong_pages);
        pages_look_up(pages, page, &met);
    }
    tape_require(tape, met.faults == count, wrong_pages);
}

/* From the oldest page to the latest: as they were looked up. */
static void walk_page_list(struct pages *pages, struct tape *tape)
{
    if (tape_is_read(tape))
        read_page_list(pages, tape);
    else
        write_page_list(pages, tape);
}

void clock_walk(struct clock *clock, struct tape *tape)
{
    walk_accounts(clock, tape);
    walk_charged(clock, tape);
    walk_scoreboard(clock, tape);
    walk_vector_unit(clock, tape);
    walk_stack(clock, tape);
    walk_page_list(&clock->pages, tape);
}
