/* compared.c - compares the accounts of two runs in tables and a sentence. */
#include "asm/compare/compared.h"

#include <math.h>
#include <stdio.h>

#include "base/plural.h"
#include "base/table.h"

bool compared_take(struct compared_run *run, const c205 *machine)
{
    run->accounts.model = c205_machine_model(machine);
    if (!accounts_add(&run->accounts, machine))
        return false;
    run->all = accounts_together(&run->accounts);
    return true;
}

void compared_free(struct compared_run *run)
{
    accounts_free(&run->accounts);
}

/* ---- Tables ---------------------------------------------------------------- */

static const struct table_column cause_columns[] = {
    { "cause", "clocks", TABLE_TEXT, 0 },
    { "first", "first", TABLE_COUNT, 0 },
    { "second", "second", TABLE_COUNT, 0 },
    { "difference", "second - first", TABLE_NUMBER, 0 },
    { "ratio", "first / second", TABLE_NUMBER, 3 },
};
static const struct table_column region_columns[] = {
    { "region", "region, clocks", TABLE_TEXT, 0 },
    { "first", "first", TABLE_COUNT, 0 },
    { "second", "second", TABLE_COUNT, 0 },
    { "difference", "second - first", TABLE_NUMBER, 0 },
    { "ratio", "first / second", TABLE_NUMBER, 3 },
};
static const struct table_column figure_columns[] = {
    { "figure", "figure", TABLE_TEXT, 0 },
    { "first", "first", TABLE_NUMBER, 3 },
    { "second", "second", TABLE_NUMBER, 3 },
    { "ratio", "first / second", TABLE_NUMBER, 3 },
};

static double quotient(double a, double b)
{
    return b > 0 ? a / b : NAN;
}

static void add_clocks(struct table *table, const char *name, uint64_t first,
                       uint64_t second)
{
    table_text(table, name);
    table_count(table, first);
    table_count(table, second);
    table_number(table, (double)second - (double)first);
    table_number(table, quotient((double)first, (double)second));
}

struct table *compared_causes(const struct compared_run runs[COMPARED_RUNS])
{
    const c205_account *first = &runs[COMPARED_FIRST].all;
    const c205_account *second = &runs[COMPARED_SECOND].all;
    struct table *table = table_new(TABLE_COLUMNS(cause_columns));
    for (int i = 0; table && i < C205_CAUSES; i++)
        if (first->clocks[i] + second->clocks[i] > 0)
            add_clocks(table, c205_cause_name((c205_cause)i), first->clocks[i],
                       second->clocks[i]);
    if (table)
        add_clocks(table, "all", accounts_clocks(first), accounts_clocks(second));
    return table;
}

static uint64_t compared_clocks(const struct compared_run *run, const char *region)
{
    const c205_account *account = accounts_find(&run->accounts, region);
    return account ? accounts_clocks(account) : 0;
}

/* Returns a table with the clocks of both runs by region: first the regions of the
 * first run, then those that only the second run has. */
struct table *compared_regions(const struct compared_run runs[COMPARED_RUNS])
{
    struct table *table = table_new(TABLE_COLUMNS(region_columns));
    for (int which = COMPARED_FIRST; table && which < COMPARED_RUNS; which++) {
        const struct accounts *accounts = &runs[which].accounts;
        for (size_t i = 0; i < accounts->count; i++) {
            const char *name = accounts->items[i].name;
            uint64_t first = compared_clocks(&runs[COMPARED_FIRST], name);
            uint64_t second = compared_clocks(&runs[COMPARED_SECOND], name);
            bool reported = which == COMPARED_SECOND
                            && accounts_find(&runs[COMPARED_FIRST].accounts, name);
            if (!reported && first + second > 0)
                add_clocks(table, accounts_region(&accounts->items[i]), first, second);
        }
    }
    return table;
}

/* Adds a row with a figure of both runs and the quotient of the figures. `decimals` is
 * the number of decimals, the same as in c205 run. */
static void add_figure(struct table *table, const char *name, int decimals,
                       double first, double second)
{
    table_text(table, name);
    table_rounded(table, first, decimals);
    table_rounded(table, second, decimals);
    table_number(table, quotient(first, second));
}

static double seconds_of(const struct compared_run *run)
{
    return accounts_seconds(run->accounts.model, accounts_clocks(&run->all));
}

static double mean_length(const c205_account *account)
{
    return quotient((double)account->elements, (double)account->vector_instructions);
}

struct table *compared_figures(const struct compared_run runs[COMPARED_RUNS])
{
    const struct compared_run *one = &runs[COMPARED_FIRST];
    const struct compared_run *other = &runs[COMPARED_SECOND];
    const c205_account *first = &one->all, *second = &other->all;
    struct table *table = table_new(TABLE_COLUMNS(figure_columns));
    if (!table)
        return NULL;
    add_figure(table, "milliseconds", 3, 1e3 * seconds_of(one),
               1e3 * seconds_of(other));
    add_figure(table, "instructions", 0, (double)first->instructions,
               (double)second->instructions);
    add_figure(table, "of them vector", 0, (double)first->vector_instructions,
               (double)second->vector_instructions);
    add_figure(table, "elements", 0, (double)first->elements, (double)second->elements);
    add_figure(table, "mean vector length", 1, mean_length(first), mean_length(second));
    add_figure(table, "Mflop/s", 2, accounts_rate(one->accounts.model, first),
               accounts_rate(other->accounts.model, second));
    return table;
}

/* ---- Sentence -------------------------------------------------------------- */

static double difference_of(const struct compared_run runs[COMPARED_RUNS], int cause)
{
    return (double)runs[COMPARED_SECOND].all.clocks[cause]
           - (double)runs[COMPARED_FIRST].all.clocks[cause];
}

/* Returns the cause whose clocks differ most between the two runs. Only causes whose
 * difference has the sign of `whole` are considered, and not the cause `besides`.
 * Returns -1 if there is none. */
static int largest(const struct compared_run runs[COMPARED_RUNS], double whole,
                   int besides)
{
    int found = -1;
    for (int i = 0; i < C205_CAUSES; i++) {
        double own = difference_of(runs, i);
        if (i != besides && own * whole > 0
            && (found < 0 || fabs(own) > fabs(difference_of(runs, found))))
            found = i;
    }
    return found;
}

enum { CAUSE_TEXT = 80 };

static void print_cause(const struct compared_run runs[COMPARED_RUNS], int cause,
                        char text[CAUSE_TEXT])
{
    double own = difference_of(runs, cause);
    snprintf(text, CAUSE_TEXT, "%.0f %s of %s", fabs(own), own < 0 ? "fewer" : "more",
             c205_cause_name((c205_cause)cause));
}

void compared_sentence(const struct compared_run runs[COMPARED_RUNS],
                       char text[COMPARED_SENTENCE])
{
    double first = (double)accounts_clocks(&runs[COMPARED_FIRST].all);
    double second = (double)accounts_clocks(&runs[COMPARED_SECOND].all);
    double whole = second - first;
    int most = largest(runs, whole, -1), next;
    char cause[CAUSE_TEXT], beside[CAUSE_TEXT] = "";
    if (most < 0) {
        snprintf(text, COMPARED_SENTENCE, "Both take %.0f clock%s.", first,
                 plural((uint64_t)first));
        return;
    }
    print_cause(runs, most, cause);
    next = largest(runs, whole, most);
    if (next >= 0
        && fabs(difference_of(runs, next)) * 5 >= fabs(difference_of(runs, most)))
        print_cause(runs, next, beside);
    snprintf(text, COMPARED_SENTENCE,
             "The second takes %.0f clock%s %s than the first: %s%s%s.", fabs(whole),
             plural((uint64_t)fabs(whole)), whole < 0 ? "less" : "more", cause,
             *beside ? ", and " : "", beside);
}
