/* account.h - stores accounts of clocks by region of the program and by cause.
 *
 * Region 0 is all code outside named regions. The clocks of all regions and causes sum
 * to the elapsed time; clock.c asserts this.
 */
#ifndef C205_ACCOUNT_H
#define C205_ACCOUNT_H

#include "vm/c205.h"

struct clock_accounts {
    size_t count;
    c205_account *account;
    c205_account *kept; /* buffer for a copy */
    char *names;        /* consecutive strings, each ending with '\0' */
};

/* Closes the previous accounts and opens accounts for the named regions, with all
 * clocks zero. Returns false, without effect, if the host is out of memory. */
bool accounts_open(struct clock_accounts *accounts, const char *const *names,
                   size_t count);
void accounts_close(struct clock_accounts *accounts);
void accounts_clear(struct clock_accounts *accounts);

/* accounts_keep copies the accounts. accounts_put_back restores the copy. */
void accounts_keep(struct clock_accounts *accounts);
void accounts_put_back(struct clock_accounts *accounts);

/* Return the sum of all clocks, and the same sum in the copy that accounts_keep
 * made. */
uint64_t accounts_sum(const struct clock_accounts *accounts);
uint64_t accounts_sum_kept(const struct clock_accounts *accounts);

#endif
