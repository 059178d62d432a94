/* accounts.h - makes tables of the clocks of runs, by cause and by region. */
#ifndef BASE_ACCOUNTS_H
#define BASE_ACCOUNTS_H

#include "base/table.h"

/* The accounts of one machine, or the sum of several machines that ran the same
 * program. */
struct accounts {
    const c205_model *model; /* the model of all machines */
    uint64_t clocks;         /* sum of all items */
    size_t count;
    c205_account *items; /* owns the names of the items */
};

/* Adds the accounts of a machine. The struct must be initialised with { .model = ... }.
 * Returns false if the host is out of memory. */
bool accounts_add(struct accounts *accounts, const c205 *machine);
bool accounts_add_account(struct accounts *accounts, const c205_account *account);
/* Adds all accounts of other machines, which ran the same program. */
bool accounts_add_all(struct accounts *accounts, const struct accounts *more);
/* Returns the account of a region, or NULL. */
const c205_account *accounts_find(const struct accounts *accounts, const char *region);
void accounts_free(struct accounts *accounts);

/* Returns the time of a number of clocks, by clock.period of the model. */
double accounts_seconds(const c205_model *model, uint64_t clocks);
uint64_t accounts_clocks(const c205_account *account);
/* Writes the time of a number of clocks, as in "22.78 us". */
enum { ACCOUNTS_TIME = 48 };
void accounts_time(const c205_model *model, uint64_t clocks, char text[ACCOUNTS_TIME]);
/* Returns the Mflop/s of an account, or NaN if it has no floating-point operations. */
double accounts_rate(const c205_model *model, const c205_account *account);
/* Returns the name of an account's region as tables print it. */
const char *accounts_region(const c205_account *account);
/* Returns the number of regions that took time. */
size_t accounts_regions(const struct accounts *accounts);
/* Returns an account with the sums over all regions. Its region name is "all". */
c205_account accounts_together(const struct accounts *accounts);
/* Computes the sum of all accounts of a machine. Returns false if the host is out of
 * memory. */
bool accounts_whole(const c205 *machine, c205_account *sum);

/* The table columns for the clocks of each cause. */
extern const struct table_column accounts_cause_columns[C205_CAUSES];

/* The unit in which tables print times, such as us. accounts_unit returns the unit for
 * times of up to the given seconds. */
struct accounts_unit {
    const char *name, *heading;
    double per_second;
    int decimals;
};
const struct accounts_unit *accounts_unit(double seconds);

/* Returns the clocks of the run by cause, without causes that have no clocks. This
 * function and the next two return NULL if the host is out of memory. */
struct table *accounts_of_run(const struct accounts *accounts);
/* Returns the clocks of the run by cause, followed by the clocks of each region. */
struct table *accounts_by_cause(const struct accounts *accounts);
/* Returns instructions, elements and clocks of each region. */
struct table *accounts_by_region(const struct accounts *accounts);

#endif
