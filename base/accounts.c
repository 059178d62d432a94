/* accounts.c - adds the accounts of machines and converts them to tables. */
#include "base/accounts.h"

#include "base/array.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct table_column by_cause[] = {
    { "region", "region", TABLE_TEXT, 0 },  { "cause", "cause", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 }, { "seconds", "seconds", TABLE_NUMBER, 8 },
    { "percent", "%", TABLE_NUMBER, 1 },
};

static const struct table_column by_region[] = {
    { "region", "region", TABLE_TEXT, 0 },
    { "entries", "entries", TABLE_COUNT, 0 },
    { "instructions", "instructions", TABLE_COUNT, 0 },
    { "vector_instructions", "vector", TABLE_COUNT, 0 },
    { "elements", "elements", TABLE_COUNT, 0 },
    { "operations", "operations", TABLE_COUNT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "seconds", "seconds", TABLE_NUMBER, 8 },
    { "percent", "%", TABLE_NUMBER, 1 },
};

const struct table_column accounts_cause_columns[C205_CAUSES] = {
    [C205_ISSUE] = { "issue", "issue", TABLE_COUNT, 0 },
    [C205_OPERAND_WAIT] = { "operand_wait", "operand wait", TABLE_COUNT, 0 },
    [C205_UNIT_BUSY] = { "unit_busy", "unit busy", TABLE_COUNT, 0 },
    [C205_BRANCH] = { "branch", "branch", TABLE_COUNT, 0 },
    [C205_MEMORY_WAIT] = { "memory_wait", "memory wait", TABLE_COUNT, 0 },
    [C205_VECTOR_STARTUP] = { "vector_startup", "vector start-up", TABLE_COUNT, 0 },
    [C205_VECTOR_STREAM] = { "vector_stream", "vector stream", TABLE_COUNT, 0 },
    [C205_BANK_CONFLICT] = { "bank_conflict", "bank conflict", TABLE_COUNT, 0 },
    [C205_TRANSLATION_MISS] = { "translation_miss", "translation miss", TABLE_COUNT,
                                0 },
    [C205_PAGE_FAULT] = { "page_fault", "page fault", TABLE_COUNT, 0 },
};

double accounts_seconds(const c205_model *model, uint64_t clocks)
{
    const c205_constant *period = c205_model_lookup(model, "clock.period");
    return period ? (double)clocks * period->value / 1e9 : NAN;
}

/* Returns the unit for a time. Microseconds with two decimals show each clock of 20 ns
 * exactly. */
const struct accounts_unit *accounts_unit(double seconds)
{
    static const struct accounts_unit us = { "us", "time, us", 1e6, 2 },
                                      ms = { "ms", "time, ms", 1e3, 3 },
                                      s = { "s", "time, s", 1, 3 };
    return seconds < 10e-3 ? &us : seconds < 10 ? &ms : &s;
}

void accounts_time(const c205_model *model, uint64_t clocks, char text[ACCOUNTS_TIME])
{
    double seconds = accounts_seconds(model, clocks);
    const struct accounts_unit *unit = accounts_unit(seconds);
    snprintf(text, ACCOUNTS_TIME, "%.*f %s", unit->decimals, seconds * unit->per_second,
             unit->name);
}

uint64_t accounts_clocks(const c205_account *account)
{
    uint64_t clocks = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++)
        clocks += account->clocks[cause];
    return clocks;
}

bool accounts_whole(const c205 *machine, c205_account *sum)
{
    struct accounts accounts = { .model = c205_machine_model(machine) };
    bool good = accounts_add(&accounts, machine);
    *sum = accounts_together(&accounts);
    accounts_free(&accounts);
    return good;
}

double accounts_rate(const c205_model *model, const c205_account *account)
{
    double operations = account->operations > 0 ? (double)account->operations : NAN;
    return operations / accounts_seconds(model, accounts_clocks(account)) / 1e6;
}

const c205_account *accounts_find(const struct accounts *accounts, const char *region)
{
    for (size_t i = 0; i < accounts->count; i++)
        if (strcmp(accounts->items[i].name, region) == 0)
            return &accounts->items[i];
    return NULL;
}

size_t accounts_regions(const struct accounts *accounts)
{
    size_t count = 0;
    for (size_t i = 0; i < accounts->count; i++)
        count += accounts_clocks(&accounts->items[i]) > 0;
    return count;
}

static c205_account *new_account(struct accounts *accounts, const char *name)
{
    char *copy = malloc(strlen(name) + 1);
    c205_account account = { .name = copy ? strcpy(copy, name) : NULL };
    c205_account *added = copy ? array_add(&accounts->items, &accounts->count, &account,
                                           sizeof account)
                               : NULL;
    if (!added)
        free(copy);
    return added;
}

static void add_account(c205_account *sum, const c205_account *account)
{
    for (int cause = 0; cause < C205_CAUSES; cause++)
        sum->clocks[cause] += account->clocks[cause];
    sum->instructions += account->instructions;
    sum->vector_instructions += account->vector_instructions;
    sum->elements += account->elements;
    sum->operations += account->operations;
    sum->entries += account->entries;
}

bool accounts_add_account(struct accounts *accounts, const c205_account *account)
{
    const c205_account *found = accounts_find(accounts, account->name);
    c205_account *sum = found ? &accounts->items[found - accounts->items]
                              : new_account(accounts, account->name);
    if (!sum)
        return false;
    add_account(sum, account);
    accounts->clocks += accounts_clocks(account);
    return true;
}

bool accounts_add(struct accounts *accounts, const c205 *machine)
{
    for (size_t i = 0; i < c205_account_count(machine); i++)
        if (!accounts_add_account(accounts, c205_account_at(machine, i)))
            return false;
    return true;
}

bool accounts_add_all(struct accounts *accounts, const struct accounts *more)
{
    for (size_t i = 0; i < more->count; i++)
        if (!accounts_add_account(accounts, &more->items[i]))
            return false;
    return true;
}

void accounts_free(struct accounts *accounts)
{
    for (size_t i = 0; i < accounts->count; i++)
        free((char *)accounts->items[i].name);
    free(accounts->items);
    *accounts = (struct accounts){ .model = accounts->model };
}

const char *accounts_region(const c205_account *account)
{
    return account->name[0] ? account->name : "(outside)";
}

/* Adds cells for clocks: their number, the seconds, and the percentage of the run. */
static void add_clocks(struct table *table, const struct accounts *accounts,
                       uint64_t clocks)
{
    uint64_t all = accounts->clocks;
    table_count(table, clocks);
    table_number(table, accounts_seconds(accounts->model, clocks));
    table_number(table, all ? 100.0 * (double)clocks / (double)all : 0.0);
}

static void add_causes(struct table *table, const struct accounts *accounts,
                       const c205_account *account, const char *name)
{
    table_text(table, name);
    table_text(table, "all");
    add_clocks(table, accounts, accounts_clocks(account));
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        if (account->clocks[cause]) {
            table_text(table, name);
            table_text(table, c205_cause_name((c205_cause)cause));
            add_clocks(table, accounts, account->clocks[cause]);
        }
    }
}

c205_account accounts_together(const struct accounts *accounts)
{
    c205_account sum = { .name = "all" };
    for (size_t i = 0; i < accounts->count; i++)
        add_account(&sum, &accounts->items[i]);
    return sum;
}

struct table *accounts_of_run(const struct accounts *accounts)
{
    struct table *table = table_new(TABLE_COLUMNS(by_cause));
    c205_account sum = accounts_together(accounts);
    if (table)
        add_causes(table, accounts, &sum, sum.name);
    return table;
}

struct table *accounts_by_cause(const struct accounts *accounts)
{
    struct table *table = accounts_of_run(accounts);
    size_t count = accounts->count;
    for (size_t i = 0; table && count > 1 && i < count; i++) {
        const c205_account *account = &accounts->items[i];
        add_causes(table, accounts, account, accounts_region(account));
    }
    return table;
}

struct table *accounts_by_region(const struct accounts *accounts)
{
    struct table *table = table_new(TABLE_COLUMNS(by_region));
    for (size_t i = 0; table && i < accounts->count; i++) {
        const c205_account *account = &accounts->items[i];
        table_text(table, accounts_region(account));
        table_count(table, account->entries);
        table_count(table, account->instructions);
        table_count(table, account->vector_instructions);
        table_count(table, account->elements);
        table_count(table, account->operations);
        add_clocks(table, accounts, accounts_clocks(account));
    }
    return table;
}
