/* projection.c - charges scalar instructions with the times of another machine. */
#include "vm/min_max.h"
#include "vm/error.h"
#include "vm/time/projection.h"
#include "vm/time/model.h"

#include <stdlib.h>
#include <string.h>

/* The kinds of units, and the maximum number of units of a kind. */
enum unit_kind {
    UNITS_SINGLE,
    UNITS_ADD,
    UNITS_MULTIPLY,
    UNITS_DIVIDE,
    UNITS_LOGICAL,
    UNIT_KINDS
};
enum { MAX_UNITS = 4 };

/* The time and the kind of unit of each timing class on the other machine. Vector
 * classes have none, because the other machine has no vector unit. */
static const struct class
{
    bool known;
    enum projection_constant time;
    enum unit_kind units;
} classes[C205_TIMINGS] = {
#define CLASS(timing, time, units) \
    [C205_TIMING_##timing] = { true, PROJECTION_##time, units },
#include "vm/time/projection.def"
};

struct c205_projection {
    uint64_t now; /* all clocks before it are charged */
    uint64_t time[C205_TIMINGS];
    uint64_t taken, not_taken, out_of_stack, interval;
    uint64_t stack_bits;
    bool overlap;

    size_t units[UNIT_KINDS];
    uint64_t free_at[UNIT_KINDS][MAX_UNITS];
    uint64_t ready[SLOTS]; /* when the value of a register is ready */
    uint64_t read[SLOTS];  /* when all instructions have read the register */
    uint64_t done;         /* when everything in flight is done */

    size_t regions; /* number of regions for which there is space */
    struct share {
        uint64_t clocks;
        uint64_t strangers; /* number of vector instructions */
    } * shares;             /* one element for each region */
    bool no_memory;
};

/* ---- Construction ------------------------------------------------------- */

static uint64_t whole(const c205_model *model, enum projection_constant id)
{
    return model_whole(model, (enum constant)id);
}

static void read_constants(c205_projection *projection, const c205_model *model)
{
    static const enum projection_constant units[UNIT_KINDS] = {
        PROJECTION_UNITS_SINGLE, PROJECTION_UNITS_ADD, PROJECTION_UNITS_MULTIPLY,
        PROJECTION_UNITS_DIVIDE, PROJECTION_UNITS_LOGICAL
    };
    for (int i = 0; i < C205_TIMINGS; i++)
        if (classes[i].known)
            projection->time[i] = whole(model, classes[i].time);
    for (int i = 0; i < UNIT_KINDS; i++)
        projection->units[i] = (size_t)whole(model, units[i]);
    projection->taken = whole(model, PROJECTION_TAKEN);
    projection->not_taken = whole(model, PROJECTION_NOT_TAKEN);
    projection->out_of_stack = whole(model, PROJECTION_OUT_OF_STACK);
    projection->interval = whole(model, PROJECTION_INTERVAL);
    projection->stack_bits = whole(model, PROJECTION_STACK_HALVES) * INSTRUCTION_STEP;
    projection->overlap = whole(model, PROJECTION_OVERLAP_UNITS);
}

c205_projection *c205_projection_new(const c205_model *model, c205_error *error)
{
    c205_projection *projection = calloc(1, sizeof *projection);
    const char *wrong = NULL;
    if (!projection)
        wrong = "out of memory for a projection";
    else if (!c205_model_is_projection(model))
        wrong = "the model is a machine, not a projection";
    if (!wrong) {
        read_constants(projection, model);
        return projection;
    }
    error_set(error, "%s", wrong);
    free(projection);
    return NULL;
}

void c205_projection_free(c205_projection *projection)
{
    if (!projection)
        return;
    free(projection->shares);
    free(projection);
}

/* ---- Units --------------------------------------------------------------- */

/* Returns the unit of a kind that becomes free first. */
static uint64_t *first_free(c205_projection *projection, enum unit_kind kind)
{
    uint64_t *first = projection->free_at[kind];
    for (size_t i = 1; i < projection->units[kind]; i++)
        if (projection->free_at[kind][i] < *first)
            first = &projection->free_at[kind][i];
    return first;
}

static uint64_t operands_ready(const c205_projection *projection,
                               const struct decoded *decoded)
{
    uint64_t ready = 0;
    for (unsigned i = 0; i < decoded->source_count; i++)
        ready = max_uint64(ready, projection->ready[decoded->source[i]]);
    return ready;
}

/* Returns the maximum of `times` over the result registers: the time at which all of
 * them can be reserved (projection->ready) or written (projection->read). */
static uint64_t results_free(const uint64_t *times, const struct decoded *decoded)
{
    uint64_t free_at = 0;
    for (unsigned i = 0; i < decoded->result_count; i++)
        free_at = max_uint64(free_at, times[decoded->result[i]]);
    return free_at;
}

static void go_through_unit(c205_projection *projection, const struct decoded *decoded,
                            uint64_t time)
{
    enum unit_kind kind = classes[decoded->insn->timing].units;
    uint64_t *unit = first_free(projection, kind);
    uint64_t issued = max_uint64(max_uint64(projection->now, *unit),
                                 results_free(projection->ready, decoded));
    uint64_t begun = max_uint64(issued, operands_ready(projection, decoded));
    uint64_t ended = max_uint64(begun + time, results_free(projection->read, decoded));
    for (unsigned i = 0; i < decoded->source_count; i++) {
        uint64_t *read = &projection->read[decoded->source[i]];
        *read = max_uint64(*read, begun);
    }
    for (unsigned i = 0; i < decoded->result_count; i++)
        projection->ready[decoded->result[i]] = ended;
    *unit = ended;
    projection->done = max_uint64(projection->done, ended);
    projection->now = issued + projection->interval;
}

/* ---- Operations ---------------------------------------------------------- */

static void wait_for_all(c205_projection *projection)
{
    projection->now = max_uint64(projection->now, projection->done);
}

static void operate(c205_projection *projection, const struct decoded *decoded)
{
    uint64_t time = projection->time[decoded->insn->timing];
    if (projection->overlap)
        go_through_unit(projection, decoded, time);
    else
        projection->now += time;
}

/* Charges the loads and stores of a SWAP, one after another. If operations overlap,
 * they begin at the rate at which the units compute their addresses. */
static void swap(c205_projection *projection, const struct effect *effect)
{
    uint64_t loads = effect->swapped - effect->saved;
    uint64_t load = projection->time[C205_TIMING_load];
    uint64_t store = projection->time[C205_TIMING_store];
    uint64_t address = projection->time[C205_TIMING_single];
    if (!projection->overlap) {
        projection->now += loads * load + effect->saved * store;
        return;
    }
    wait_for_all(projection);
    if (effect->swapped > 0)
        projection->now += effect->swapped * address / projection->units[UNITS_SINGLE]
                           + max_uint64(loads ? load : 0, effect->saved ? store : 0);
}

static uint64_t branch_time(const c205_projection *projection,
                            const struct decoded *decoded, const struct effect *effect)
{
    uint64_t time = projection->not_taken;
    if (effect->taken)
        time = effect->target <= decoded->pc
                       && decoded->pc - effect->target <= projection->stack_bits
                   ? projection->taken
                   : projection->out_of_stack;
    if (decoded->insn->format == C205_FORMAT_FLOAT)
        time += projection->time[C205_TIMING_add];
    if (decoded->insn->format == C205_FORMAT_INDEX)
        time += projection->time[C205_TIMING_single];
    return time;
}

static void branch(c205_projection *projection, const struct decoded *decoded,
                   const struct effect *effect)
{
    if (projection->overlap)
        projection->now = max_uint64(projection->now,
                                     operands_ready(projection, decoded));
    projection->now += branch_time(projection, decoded, effect);
    for (unsigned i = 0; i < decoded->result_count; i++)
        projection->ready[decoded->result[i]] = projection->now;
}

/* ---- The accounts -------------------------------------------------------- */

static bool grow_shares(c205_projection *projection, size_t region)
{
    if (region < projection->regions)
        return true;
    struct share *shares = realloc(projection->shares, (region + 1) * sizeof *shares);
    if (!shares) {
        projection->no_memory = true;
        return false;
    }
    memset(shares + projection->regions, 0,
           (region + 1 - projection->regions) * sizeof *shares);
    projection->shares = shares;
    projection->regions = region + 1;
    return true;
}

void projection_charge(c205_projection *projection, const struct decoded *decoded,
                       const struct effect *effect)
{
    uint64_t before = projection->now;
    if (!grow_shares(projection, decoded->region))
        return;
    if (decoded->insn->timing == C205_TIMING_swap)
        swap(projection, effect);
    else if (decoded->insn->timing == C205_TIMING_branch)
        branch(projection, decoded, effect);
    else if (classes[decoded->insn->timing].known)
        operate(projection, decoded);
    else
        projection->shares[decoded->region].strangers++;
    projection->shares[decoded->region].clocks += projection->now - before;
}

uint64_t c205_projected_clocks(const c205_projection *projection, size_t region)
{
    return region < projection->regions ? projection->shares[region].clocks : 0;
}

uint64_t projection_strangers(const c205_projection *projection, size_t region)
{
    return region < projection->regions ? projection->shares[region].strangers : 0;
}

bool projection_complete(const c205_projection *projection, c205_error *error)
{
    if (projection->no_memory)
        error_set(error, "out of memory for the accounts of a projection");
    return !projection->no_memory;
}

bool c205_projection_holds(const c205_projection *projection, c205_error *error)
{
    uint64_t strangers = 0;
    for (size_t i = 0; i < projection->regions; i++)
        strangers += projection_strangers(projection, i);
    if (strangers)
        error_set(error, "%llu vector instruction%s cannot be projected",
                  (unsigned long long)strangers, strangers == 1 ? "" : "s");
    return projection_complete(projection, error) && strangers == 0;
}
