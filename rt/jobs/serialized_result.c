/* serialized_result.c - a growing sequence of 64-bit words. */
#include "rt/jobs/serialized_result.h"

#include <stdlib.h>
#include <string.h>

static bool grow_result(struct serialized_result *words, size_t more)
{
    size_t room = words->room > 0 ? words->room : 64;
    uint64_t *items;
    if (more <= words->room - words->count)
        return true;
    if (more > SIZE_MAX / 4 / sizeof *items - words->count)
        return false;
    while (room - words->count < more)
        room *= 2;
    items = realloc(words->items, room * sizeof *items);
    if (!items)
        return false;
    words->items = items;
    words->room = room;
    return true;
}

void result_put(struct serialized_result *words, uint64_t word)
{
    result_put_all(words, &word, 1);
}

void result_put_all(struct serialized_result *words, const uint64_t *items,
                    size_t count)
{
    if (!grow_result(words, count)) {
        words->failed = true;
    } else if (count > 0) {
        memcpy(words->items + words->count, items, count * sizeof *items);
        words->count += count;
    }
}

uint64_t result_take(struct serialized_result *words)
{
    uint64_t word = 0;
    result_take_all(words, &word, 1);
    return word;
}

void result_take_all(struct serialized_result *words, uint64_t *items, size_t count)
{
    if (count > words->count - words->at) {
        words->failed = true;
    } else if (count > 0) {
        memcpy(items, words->items + words->at, count * sizeof *items);
        words->at += count;
    }
}

bool result_resize(struct serialized_result *words, size_t count)
{
    result_clear(words);
    if (!grow_result(words, count))
        return false;
    words->count = count;
    return true;
}

void result_clear(struct serialized_result *words)
{
    words->count = words->at = 0;
    words->failed = false;
}

void result_free(struct serialized_result *words)
{
    free(words->items);
    *words = (struct serialized_result){ .items = NULL };
}

/* ---- Accounts ------------------------------------------------------------ */

static void put_name(struct serialized_result *words, const char *name)
{
    size_t length = strlen(name);
    result_put(words, length);
    for (size_t i = 0; i < length; i++)
        result_put(words, (unsigned char)name[i]);
}

static void put_account(struct serialized_result *words, const c205_account *account)
{
    put_name(words, account->name);
    result_put_all(words, account->clocks, C205_CAUSES);
    result_put(words, account->instructions);
    result_put(words, account->vector_instructions);
    result_put(words, account->elements);
    result_put(words, account->operations);
    result_put(words, account->entries);
}

void result_put_accounts(struct serialized_result *words,
                         const struct accounts *accounts)
{
    result_put(words, accounts->count);
    for (size_t i = 0; i < accounts->count; i++)
        put_account(words, &accounts->items[i]);
}

static bool take_account(struct serialized_result *words, struct accounts *accounts)
{
    char name[256];
    c205_account account = { .name = name };
    uint64_t length = result_take(words);
    if (length >= sizeof name)
        return false;
    for (uint64_t i = 0; i < length; i++)
        name[i] = (char)result_take(words);
    name[length] = '\0';
    result_take_all(words, account.clocks, C205_CAUSES);
    account.instructions = result_take(words);
    account.vector_instructions = result_take(words);
    account.elements = result_take(words);
    account.operations = result_take(words);
    account.entries = result_take(words);
    return !words->failed && accounts_add_account(accounts, &account);
}

bool result_take_accounts(struct serialized_result *words, struct accounts *accounts)
{
    uint64_t count = result_take(words);
    for (uint64_t i = 0; i < count; i++)
        if (!take_account(words, accounts))
            return false;
    return !words->failed;
}
