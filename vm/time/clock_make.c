/* clock_make.c - creates, resets and frees a clock, and reads its constants from a
 * model.
 */
#include "vm/time/schedule.h"
#include "vm/error.h"

#include <stdlib.h>
#include <string.h>

static void read_timings(struct clock *clock, const c205_model *model)
{
    for (unsigned i = 0; i < C205_TIMINGS; i++) {
        c205_timing id = (c205_timing)i;
        struct clock_timing *timing = &clock->timing[i];
        if (c205_timing_is_vector(id)) {
            timing->startup = model_whole(model, startup_constant(id));
            timing->stream = model_rate(model, stream_constant(id));
            timing->half_stream = model_half_rate(model, stream_constant(id));
        } else {
            timing->latency = model_whole(model, latency_constant(id));
            timing->busy = model_whole(model, busy_constant(id));
        }
    }
}

static void read_constants(struct clock *clock, const c205_model *model)
{
    clock->issue_interval = model_whole(model, CONSTANT_ISSUE_INTERVAL);
    clock->loads_in_flight = model_whole(model, CONSTANT_LOADS_IN_FLIGHT);
    clock->stack_words = model_whole(model, CONSTANT_STACK_WORDS);
    clock->overlap = model_whole(model, CONSTANT_OVERLAP);
    clock->branch_taken = model_whole(model, CONSTANT_BRANCH_TAKEN);
    clock->branch_not_taken = model_whole(model, CONSTANT_BRANCH_NOT_TAKEN);
    clock->branch_out_of_stack = model_whole(model, CONSTANT_BRANCH_OUT_OF_STACK);
    clock->translation_miss = model_whole(model, CONSTANT_TRANSLATION_MISS);
    clock->page_fault = model_whole(model, CONSTANT_PAGE_FAULT);
    clock->swap_word = model_rate(model, CONSTANT_SWAP_WORD);
}

/* Returns an integer constant. Its maximum in constants.def fits a size_t. */
static size_t model_count(const c205_model *model, enum constant id)
{
    return (size_t)model_whole(model, id);
}

static bool make_parts(struct clock *clock, const c205_model *model)
{
    static const char *const outside[] = { "" };
    return pages_init(&clock->pages, model_whole(model, CONSTANT_PAGE_WORDS),
                      model_whole(model, CONSTANT_REAL_WORDS),
                      model_count(model, CONSTANT_REGISTERS))
           && banks_init(&clock->banks, model_count(model, CONSTANT_BANKS),
                         model_ticks(model), model_whole(model, CONSTANT_BANK_BUSY))
           && accounts_open(&clock->accounts, outside, 1);
}

struct clock *clock_new(const c205_model *model, c205_error *error)
{
    struct clock *clock = calloc(1, sizeof *clock);
    if (clock)
        clock->schedules = schedules_new();
    if (clock && clock->schedules && make_parts(clock, model)) {
        read_constants(clock, model);
        read_timings(clock, model);
        clock->generation = 1;
        clock_reset(clock);
        return clock;
    }
    error_set(error, "out of memory for the machine's clock");
    clock_free(clock);
    return NULL;
}

void clock_free(struct clock *clock)
{
    if (!clock)
        return;
    pages_free(&clock->pages);
    banks_free(&clock->banks);
    index_list_free(&clock->list);
    schedules_free(clock->schedules);
    accounts_close(&clock->accounts);
    free(clock);
}

bool clock_set_regions(struct clock *clock, const char *const *names, size_t count,
                       c205_error *error)
{
    if (!accounts_open(&clock->accounts, names, count))
        return error_set(error, "out of memory for the accounts of %zu region%s", count,
                         count == 1 ? "" : "s");
    clock->generation++; /* the schedules point to accounts that no longer exist */
    clock_reset(clock);
    return true;
}

static void forget_flight(struct clock *clock)
{
    memset(clock->ready, 0, sizeof clock->ready);
    memset(clock->free_at, 0, sizeof clock->free_at);
    memset(clock->load_end, 0, sizeof clock->load_end);
    clock->load = 0;
    clock->results_done = clock->loads_done = 0;
    clock->phase_count = 0;
    clock->vector_end = clock->vector_tail = 0;
    clock->flight = NULL;
    clock->charged = NULL;
    clock->blocks_since = 0;
}

void clock_reset(struct clock *clock)
{
    accounts_clear(&clock->accounts);
    forget_flight(clock);
    clock->now = 0;
    clock->ahead = false;
    clock->account = &clock->accounts.account[0];
    clock->region = SIZE_MAX;       /* the first instruction enters a region */
    clock->stack.next = UINT64_MAX; /* the first instruction starts the stack */
}

void clock_forget_pages(struct clock *clock)
{
    pages_forget(&clock->pages);
}
