/* accounts.h - tables of the clocks of runs, by cause and by region. */
#ifndef BASE_ACCOUNTS_H
#define BASE_ACCOUNTS_H

#include "base/table.h"

/* The accounts of one machine, or of several that ran the same program, added region by
 * region. */
struct accounts {
    const c205_model *model; /* of all of them */
    uint64_t clocks;         /* the sum of all items */
    size_t count;
    c205_account *items; /* the list owns their names */
};

/* Add accounts to a list that was initialised with { .model = ... }. Returns false if
 * memory is exhausted. */
bool accounts_add(struct accounts *accounts, const c205 *machine);
bool accounts_add_account(struct accounts *accounts, const c205_account *account);
/* Adds all accounts of another list. */
bool accounts_add_all(struct accounts *accounts, const struct accounts *more);
/* NULL: there is no such region. */
const c205_account *accounts_find(const struct accounts *accounts, const char *region);
void accounts_free(struct accounts *accounts);

/* Returns the time of clocks, by the model's clock.period. */
double accounts_seconds(const c205_model *model, uint64_t clocks);
uint64_t accounts_clocks(const c205_account *account);
/* Writes clocks as a readable time: "22.78 us". */
enum { ACCOUNTS_TIME = 48 };
void accounts_time(const c205_model *model, uint64_t clocks, char text[ACCOUNTS_TIME]);
/* Returns millions of floating-point operations per second; NaN: there were none. */
double accounts_rate(const c205_model *model, const c205_account *account);
/* Returns the printed name of a region. */
const char *accounts_region(const c205_account *account);
/* Returns the number of regions that took time. */
size_t accounts_regions(const struct accounts *accounts);
/* Returns the sum of all regions, with the name "all". */
c205_account accounts_together(const struct accounts *accounts);
/* Sets the sum of the accounts of a machine. Returns false if memory is exhausted. */
bool accounts_whole(const c205 *machine, c205_account *sum);

/* One column for the clocks of each cause. */
extern const struct table_column accounts_cause_columns[C205_CAUSES];

/* Returns the unit of time for figures of at most the given seconds. */
struct accounts_unit {
    const char *name, *heading;
    double per_second;
    int decimals;
};
const struct accounts_unit *accounts_unit(double seconds);

/* Returns the clocks of the whole run by cause, without causes that have no clocks.
 * NULL: out of memory; this holds for the next functions too. */
struct table *accounts_of_run(const struct accounts *accounts);
/* Returns the clocks of the whole run by cause, followed by the clocks of each
 * region. */
struct table *accounts_by_cause(const struct accounts *accounts);
/* Returns instructions, elements and clocks of each region. */
struct table *accounts_by_region(const struct accounts *accounts);

#endif
