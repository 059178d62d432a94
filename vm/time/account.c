/* account.c - stores accounts of clocks by region and cause. */
#include "vm/time/account.h"

#include <stdlib.h>
#include <string.h>

static const char *const cause_names[C205_CAUSES] = {
    [C205_ISSUE] = "issue",
    [C205_OPERAND_WAIT] = "operand wait",
    [C205_UNIT_BUSY] = "unit busy",
    [C205_BRANCH] = "branch",
    [C205_MEMORY_WAIT] = "memory wait",
    [C205_VECTOR_STARTUP] = "vector start-up",
    [C205_VECTOR_STREAM] = "vector stream",
    [C205_BANK_CONFLICT] = "bank conflict",
    [C205_TRANSLATION_MISS] = "translation miss",
    [C205_PAGE_FAULT] = "page fault"
};

const char *c205_cause_name(c205_cause cause)
{
    return cause_names[cause];
}

static size_t names_size(const char *const *names, size_t count)
{
    size_t size = 0;
    for (size_t i = 0; i < count; i++)
        size += strlen(names[i]) + 1;
    return size;
}

bool accounts_open(struct clock_accounts *accounts, const char *const *names,
                   size_t count)
{
    struct clock_accounts opened = { count, calloc(count, sizeof(c205_account)),
                                     calloc(count, sizeof(c205_account)),
                                     malloc(names_size(names, count)) };
    if (!opened.account || !opened.kept || !opened.names) {
        accounts_close(&opened);
        return false;
    }
    char *name = opened.names;
    for (size_t i = 0; i < count; i++) {
        size_t size = strlen(names[i]) + 1;
        opened.account[i].name = memcpy(name, names[i], size);
        opened.kept[i].name = name;
        name += size;
    }
    accounts_close(accounts);
    *accounts = opened;
    return true;
}

void accounts_close(struct clock_accounts *accounts)
{
    free(accounts->account);
    free(accounts->kept);
    free(accounts->names);
}

void accounts_clear(struct clock_accounts *accounts)
{
    for (size_t i = 0; i < accounts->count; i++) {
        c205_account empty = { .name = accounts->account[i].name };
        accounts->account[i] = empty;
    }
}

void accounts_keep(struct clock_accounts *accounts)
{
    memcpy(accounts->kept, accounts->account,
           accounts->count * sizeof *accounts->account);
}

void accounts_put_back(struct clock_accounts *accounts)
{
    memcpy(accounts->account, accounts->kept,
           accounts->count * sizeof *accounts->account);
}

static uint64_t sum_of(const c205_account *account, size_t count)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < count; i++)
        for (int cause = 0; cause < C205_CAUSES; cause++)
            sum += account[i].clocks[cause];
    return sum;
}

uint64_t accounts_sum(const struct clock_accounts *accounts)
{
    return sum_of(accounts->account, accounts->count);
}

uint64_t accounts_sum_kept(const struct clock_accounts *accounts)
{
    return sum_of(accounts->kept, accounts->count);
}
