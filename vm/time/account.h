/* account.h - where the clocks went: by region of the program, by cause.
 *
 * Region 0 is all code outside named regions.  The clocks of all regions and
 * causes sum to the time that has passed; clock.c asserts it.
 */
#ifndef C205_ACCOUNT_H
#define C205_ACCOUNT_H

#include "vm/c205.h"

struct clock_accounts {
    size_t count;
    c205_account *account;
    c205_account *kept; /* room for a copy */
    char *names;        /* one after the other, each ending with '\0' */
};

/* Accounts for these regions, all zero, in place of the former ones.  False:
 * the host has no memory left, and nothing has changed. */
bool accounts_open(struct clock_accounts *accounts, const char *const *names,
                   size_t count);
void accounts_close(struct clock_accounts *accounts);
void accounts_clear(struct clock_accounts *accounts);

/* Copy all that is in them, and put it back. */
void accounts_keep(struct clock_accounts *accounts);
void accounts_put_back(struct clock_accounts *accounts);

uint64_t accounts_sum(const struct clock_accounts *accounts);
uint64_t accounts_sum_kept(const struct clock_accounts *accounts);

#endif
