/* iterations_table.c - writes the refinement steps of the root solver as rows of
 * tables. */
#include "rt/study/iterations_table.h"

#include <math.h>

/* Returns the mean, or NAN if the count is 0. */
static double mean(uint64_t sum, uint64_t count)
{
    return count > 0 ? (double)sum / (double)count : NAN;
}

/* Returns the percentage of active lanes in the loop. It is meaningless in the scalar
 * form, which refines one bracket after another. */
static double active_percent(const struct iterations *iterations, uint64_t active,
                             uint64_t lanes)
{
    return iterations->vector ? 100 * mean(active, lanes) : NAN;
}

void iterations_add(struct table *table, const struct iterations *iterations,
                    enum stage stage)
{
    const struct stage_count *count = &iterations->stage[stage];
    table_text(table, stage_name(stage));
    table_count(table, count->brackets);
    table_number(table, mean(count->halvings, count->brackets));
    table_count(table, count->steps);
    table_number(table, mean(count->steps, count->brackets));
    table_count(table, count->passes);
    table_number(table, mean(count->lanes, count->passes));
    table_number(table, active_percent(iterations, count->steps, count->lanes));
}

size_t iterations_passes(const struct iterations *iterations, enum stage stage)
{
    size_t passes = 0;
    while (passes < MAX_ITERATIONS && iterations->stage[stage].in_loop[passes] > 0)
        passes++;
    return passes;
}

void iterations_add_pass(struct table *table, const struct iterations *iterations,
                         enum stage stage, size_t pass)
{
    const struct stage_count *count = &iterations->stage[stage];
    uint64_t active = count->active[pass], lanes = count->in_loop[pass];
    table_text(table, stage_name(stage));
    table_count(table, pass + 1);
    table_count(table, active);
    table_number(table, 100 * mean(active, count->brackets));
    table_count(table, lanes);
    table_number(table, active_percent(iterations, active, lanes));
}
