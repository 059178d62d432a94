/* clock_save.c - serializes the state of a clock, without its model. */
#include "vm/time/clock_parts.h"
#include "vm/memory.h"
#include "vm/serializer.h"

/* The latest time that a file may contain: 3,000 years of the machine, which no run
 * reaches. Adding the cost of one instruction to it cannot overflow. */
#define LATEST (UINT64_MAX >> 2)

static const char wrong_account[] = "the accounts of the saved machine are invalid";
static const char wrong_flight[] = "the timing state of the saved machine is invalid";
static const char wrong_pages[] = "the list of pages of the saved machine is invalid";

/* ---- Accounts ------------------------------------------------------------ */

static void walk_account(c205_account *account, struct serializer *serializer)
{
    serializer_array(serializer, account->clocks, C205_CAUSES);
    serializer_word(serializer, &account->instructions);
    serializer_word(serializer, &account->vector_instructions);
    serializer_word(serializer, &account->elements);
    serializer_word(serializer, &account->operations);
    serializer_word(serializer, &account->entries);
}

/* Serializes the index of the region plus 1, or 0 if no region has been entered yet. */
static void walk_region(struct clock *clock, struct serializer *serializer)
{
    size_t entered = clock->region + 1;
    serializer_size(serializer, &entered, clock->accounts.count);
    if (!serializer_is_read(serializer))
        return;
    clock->region = entered - 1;
    clock->account = &clock->accounts.account[entered ? entered - 1 : 0];
}

static void walk_accounts(struct clock *clock, struct serializer *serializer)
{
    for (size_t i = 0; i < clock->accounts.count; i++)
        walk_account(&clock->accounts.account[i], serializer);
    walk_region(clock, serializer);
    serializer_word(serializer, &clock->now);
    serializer_require(serializer,
                       accounts_sum(&clock->accounts) == clock->now
                           && clock->now <= LATEST,
                       wrong_account);
}

/* Serializes the charged time and accounts if the clock shows a later time than the
 * charged time. */
static void walk_charged(struct clock *clock, struct serializer *serializer)
{
    size_t ahead = clock->ahead;
    serializer_size(serializer, &ahead, 1);
    clock->ahead = ahead == 1;
    if (!clock->ahead)
        return;
    for (size_t i = 0; i < clock->accounts.count; i++)
        walk_account(&clock->accounts.kept[i], serializer);
    serializer_word(serializer, &clock->kept_now);
    serializer_require(serializer,
                       accounts_sum_kept(&clock->accounts) == clock->kept_now
                           && clock->kept_now <= clock->now,
                       wrong_account);
}

static uint64_t charged(const struct clock *clock)
{
    return clock->ahead ? clock->kept_now : clock->now;
}

/* ---- In flight ----------------------------------------------------------- */

static void walk_time(uint64_t *time, struct serializer *serializer)
{
    serializer_word(serializer, time);
    serializer_require(serializer, *time <= LATEST, wrong_flight);
}

/* Serializes a time. A past time is saved as 0. */
static void walk_pending(const struct clock *clock, uint64_t *time,
                         struct serializer *serializer)
{
    uint64_t pending = *time > charged(clock) ? *time : 0;
    walk_time(&pending, serializer);
    if (serializer_is_read(serializer))
        *time = pending;
}

static void walk_register(struct clock *clock, size_t slot,
                          struct serializer *serializer)
{
    bool pending = clock->ready[slot] > charged(clock);
    size_t awaits = pending || serializer_is_read(serializer) ? clock->awaits[slot] : 0;
    serializer_size(serializer, &awaits, FOR_VECTOR);
    if (serializer_is_read(serializer))
        clock->awaits[slot] = (uint8_t)awaits;
}

/* Serializes the loads in flight, the oldest first. */
static void walk_loads(struct clock *clock, struct serializer *serializer)
{
    size_t loads = (size_t)clock->loads_in_flight, oldest = 0;
    for (size_t i = 0; i < loads; i++)
        walk_pending(clock, &clock->load_end[(clock->load + i) % loads], serializer);
    serializer_size(serializer, &oldest, loads - 1);
    if (serializer_is_read(serializer))
        clock->load = oldest;
}

static void walk_scoreboard(struct clock *clock, struct serializer *serializer)
{
    for (size_t i = 0; i < SLOTS; i++)
        walk_pending(clock, &clock->ready[i], serializer);
    for (size_t i = 0; i < SLOTS; i++)
        walk_register(clock, i, serializer);
    walk_pending(clock, &clock->results_done, serializer);
    walk_pending(clock, &clock->loads_done, serializer);
    for (size_t i = 0; i < C205_UNITS; i++)
        walk_pending(clock, &clock->free_at[i], serializer);
    walk_loads(clock, serializer);
}

static void walk_phase(struct phase *phase, size_t regions,
                       struct serializer *serializer)
{
    size_t cause = phase->cause;
    walk_time(&phase->end, serializer);
    serializer_size(serializer, &cause, C205_CAUSES - 1);
    phase->cause = (c205_cause)cause;
    serializer_size(serializer, &phase->region, regions - 1);
    serializer_word(serializer, &phase->pc);
}

/* Returns true if the phases are valid. Their ends must not decrease, and the last end
 * must be vector_end. Only the last phase may overlap a start-up. */
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

/* Returns true if each register that waits for the vector unit is ready when the vector
 * unit is. */
static bool waits_are_sound(const struct clock *clock)
{
    for (size_t i = 0; i < SLOTS; i++)
        if (clock->awaits[i] == FOR_VECTOR && clock->ready[i] > charged(clock)
            && clock->ready[i] > clock->vector_end)
            return false;
    return true;
}

static void walk_vector_unit(struct clock *clock, struct serializer *serializer)
{
    serializer_size(serializer, &clock->phase_count, PHASES);
    for (size_t i = 0; i < clock->phase_count; i++)
        walk_phase(&clock->phase[i], clock->accounts.count, serializer);
    walk_time(&clock->vector_end, serializer);
    walk_time(&clock->vector_tail, serializer);
    serializer_require(serializer, phases_are_sound(clock) && waits_are_sound(clock),
                       wrong_flight);
}

/* ---- Control, pages ------------------------------------------------------ */

static void walk_stack(struct clock *clock, struct serializer *serializer)
{
    serializer_word(serializer, &clock->stack.next);
    serializer_word(serializer, &clock->stack.low);
    serializer_word(serializer, &clock->stack.high);
}

static void write_page_list(const struct pages *pages, struct serializer *serializer)
{
    const struct resident *resident = pages->resident;
    size_t count = pages->count;
    serializer_size(serializer, &count, pages->capacity);
    for (uint32_t at = resident[0].newer; at; at = resident[at].newer) {
        uint64_t page = resident[at].page;
        serializer_word(serializer, &page);
    }
}

/* Reads the list of pages. No page may occur twice. */
static void read_page_list(struct pages *pages, struct serializer *serializer)
{
    struct translation met = { 0, 0 };
    size_t count = 0;
    serializer_size(serializer, &count, pages->capacity);
    pages_forget(pages);
    for (size_t i = 0; i < count; i++) {
        uint64_t page;
        serializer_word(serializer, &page);
        serializer_require(serializer, page <= ADDRESS_MASK >> pages->shift,
                           wrong_pages);
        pages_look_up(pages, page, &met);
    }
    serializer_require(serializer, met.faults == count, wrong_pages);
}

/* Serializes the list from the oldest page to the latest. Looking the pages up in this
 * order rebuilds the list. */
static void walk_page_list(struct pages *pages, struct serializer *serializer)
{
    if (serializer_is_read(serializer))
        read_page_list(pages, serializer);
    else
        write_page_list(pages, serializer);
}

void clock_walk(struct clock *clock, struct serializer *serializer)
{
    walk_accounts(clock, serializer);
    walk_charged(clock, serializer);
    walk_scoreboard(clock, serializer);
    walk_vector_unit(clock, serializer);
    walk_stack(clock, serializer);
    walk_page_list(&clock->pages, serializer);
}
