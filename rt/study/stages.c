/* stages.c - compares the clocks of a computation in its three stages. */
#include "rt/study/stages.h"

#include <math.h>

#include "vm/error.h"

static const struct table_column columns[] = {
    { "step", "step", TABLE_TEXT, 0 },
    { "scalar", "scalar", TABLE_COUNT, 0 },
    { "kernels", "kernels", TABLE_COUNT, 0 },
    { "vector", "vector", TABLE_COUNT, 0 },
    { "speedup_kernels", "scalar/kernels", TABLE_NUMBER, 1 },
    { "speedup_vector", "scalar/vector", TABLE_NUMBER, 1 },
    { "speedup_rest", "kernels/vector", TABLE_NUMBER, 1 },
};

bool stages_find(struct stages *stages, enum trace_mode there, stages_function *find,
                 const void *found, c205_error *error)
{
    for (int mode = 0; mode < TRACE_MODES; mode++) {
        bool same = true;
        if (mode == (int)there)
            continue;
        if (!find(found, (enum trace_mode)mode, stages->clocks[mode], &same, error))
            return false;
        if (!same)
            return error_set(error, "the stages %s and %s do not agree",
                             trace_mode_name(there),
                             trace_mode_name((enum trace_mode)mode));
    }
    return true;
}

uint64_t stages_clocks(const struct stages *stages, enum trace_mode mode)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < stages->step_count; i++)
        sum += stages->clocks[mode][i];
    return sum;
}

static double quotient(uint64_t slow, uint64_t fast)
{
    return fast > 0 ? (double)slow / (double)fast : NAN;
}

static void add_row(struct table *table, const char *name, uint64_t scalar,
                    uint64_t kernels, uint64_t vector)
{
    table_text(table, name);
    table_count(table, scalar);
    table_count(table, kernels);
    table_count(table, vector);
    table_number(table, quotient(scalar, kernels));
    table_number(table, quotient(scalar, vector));
    table_number(table, quotient(kernels, vector));
}

struct table *stages_table(const struct stages *stages)
{
    struct table *table = table_new(TABLE_COLUMNS(columns));
    for (size_t i = 0; table && i < stages->step_count; i++)
        if (stages->clocks[TRACE_SCALAR][i] > 0)
            add_row(table, stages->steps[i], stages->clocks[TRACE_SCALAR][i],
                    stages->clocks[TRACE_KERNELS][i], stages->clocks[TRACE_VECTOR][i]);
    if (table)
        add_row(table, "all", stages_clocks(stages, TRACE_SCALAR),
                stages_clocks(stages, TRACE_KERNELS),
                stages_clocks(stages, TRACE_VECTOR));
    return table;
}
