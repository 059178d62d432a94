/* accounts.c - see accounts.h. */
#include "asm/accounts.h"

#include <math.h>

static const struct table_column by_cause[] = {
    { "region", "region", TABLE_TEXT, 0 },
    { "cause", "cause", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "seconds", "seconds", TABLE_NUMBER, 8 },
    { "percent", "%", TABLE_NUMBER, 1 },
};

static const struct table_column by_region[] = {
    { "region", "region", TABLE_TEXT, 0 },
    { "entries", "entries", TABLE_COUNT, 0 },
    { "instructions", "instructions", TABLE_COUNT, 0 },
    { "vector_instructions", "vector", TABLE_COUNT, 0 },
    { "elements", "elements", TABLE_COUNT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "seconds", "seconds", TABLE_NUMBER, 8 },
    { "percent", "%", TABLE_NUMBER, 1 },
};
#define COLUMNS(list) (sizeof(list) / sizeof *(list))

double accounts_seconds(const c205_model *model, uint64_t clocks)
{
    const c205_constant *period = c205_model_lookup(model, "clock.period");
    return period ? (double)clocks * period->value / 1e9 : NAN;
}

uint64_t accounts_clocks(const c205_account *account)
{
    uint64_t clocks = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        clocks += account->clocks[cause];
    }
    return clocks;
}

static const char *region_name(const c205_account *account)
{
    return account->name[0] ? account->name : "(outside)";
}

/* Clocks, seconds, per cent of the run. */
static void add_clocks(struct table *table, const c205 *machine,
                       uint64_t clocks)
{
    uint64_t all = c205_clock(machine);
    table_count(table, clocks);
    table_number(table,
                 accounts_seconds(c205_machine_model(machine), clocks));
    table_number(table, all ? 100.0 * (double)clocks / (double)all : 0.0);
}

static void add_causes(struct table *table, const c205 *machine,
                       const c205_account *account, const char *name)
{
    table_text(table, name);
    table_text(table, "all");
    add_clocks(table, machine, accounts_clocks(account));
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        if (account->clocks[cause]) {
            table_text(table, name);
            table_text(table, c205_cause_name((c205_cause)cause));
            add_clocks(table, machine, account->clocks[cause]);
        }
    }
}

static c205_account sum_of_accounts(const c205 *machine)
{
    c205_account sum = { .name = "all" };
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        for (int cause = 0; cause < C205_CAUSES; cause++) {
            sum.clocks[cause] += account->clocks[cause];
        }
    }
    return sum;
}

struct table *accounts_of_run(const c205 *machine)
{
    struct table *table = table_new(by_cause, COLUMNS(by_cause));
    c205_account sum = sum_of_accounts(machine);
    if (table) {
        add_causes(table, machine, &sum, sum.name);
    }
    return table;
}

struct table *accounts_by_cause(const c205 *machine)
{
    struct table *table = accounts_of_run(machine);
    size_t count = c205_account_count(machine);
    for (size_t i = 0; table && count > 1 && i < count; i++) {
        const c205_account *account = c205_account_at(machine, i);
        add_causes(table, machine, account, region_name(account));
    }
    return table;
}

struct table *accounts_by_region(const c205 *machine)
{
    struct table *table = table_new(by_region, COLUMNS(by_region));
    for (size_t i = 0; table && i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        table_text(table, region_name(account));
        table_count(table, account->entries);
        table_count(table, account->instructions);
        table_count(table, account->vector_instructions);
        table_count(table, account->elements);
        add_clocks(table, machine, accounts_clocks(account));
    }
    return table;
}
