/* accounts.h - where the clocks of runs went, as tables. */
#ifndef BASE_ACCOUNTS_H
#define BASE_ACCOUNTS_H

#include "base/table.h"

/* The accounts of one machine, or of several that ran the same program:
 * added region by region. */
struct accounts {
    const c205_model *model; /* of all of them */
    uint64_t clocks;         /* the sum of everything below */
    size_t count;
    c205_account *items; /* their names are this list's own */
};

/* Begin with { .model = ... }.  False: no memory. */
bool accounts_add(struct accounts *accounts, const c205 *machine);
bool accounts_add_account(struct accounts *accounts, const c205_account *account);
/* All of another list. */
bool accounts_add_all(struct accounts *accounts, const struct accounts *more);
/* NULL: there is no such region. */
const c205_account *accounts_find(const struct accounts *accounts, const char *region);
void accounts_free(struct accounts *accounts);

/* By the model's clock.period. */
double accounts_seconds(const c205_model *model, uint64_t clocks);
uint64_t accounts_clocks(const c205_account *account);
/* Clocks as a time that is read easily: "22.78 us". */
enum { ACCOUNTS_TIME = 48 };
void accounts_time(const c205_model *model, uint64_t clocks, char text[ACCOUNTS_TIME]);
/* Millions of floating-point operations a second; NaN: none was done. */
double accounts_rate(const c205_model *model, const c205_account *account);
/* What a region is called in print. */
const char *accounts_region(const c205_account *account);
/* How many regions took time. */
size_t accounts_regions(const struct accounts *accounts);
/* All regions together, by the name "all". */
c205_account accounts_together(const struct accounts *accounts);

/* A column for the clocks of each cause. */
extern const struct table_column accounts_cause_columns[C205_CAUSES];

/* A unit of time for figures of which the largest is so long. */
struct accounts_unit {
    const char *name, *heading;
    double per_second;
    int decimals;
};
const struct accounts_unit *accounts_unit(double seconds);

/* Clocks of the whole run by cause; causes without clocks are left out.  NULL:
 * no memory, here as below. */
struct table *accounts_of_run(const struct accounts *accounts);
/* The same, and then that of each region. */
struct table *accounts_by_cause(const struct accounts *accounts);
/* Instructions, elements and clocks of each region. */
struct table *accounts_by_region(const struct accounts *accounts);

#endif
