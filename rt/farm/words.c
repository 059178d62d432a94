#include "rt/farm/words.h"

#include <stdlib.h>
#include <string.h>

static bool make_room(struct unit_words *words, size_t more)
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

void words_put(struct unit_words *words, uint64_t word)
{
    words_put_all(words, &word, 1);
}

void words_put_all(struct unit_words *words, const uint64_t *items, size_t count)
{
    if (!make_room(words, count)) {
        words->failed = true;
    } else if (count > 0) {
        memcpy(words->items + words->count, items, count * sizeof *items);
        words->count += count;
    }
}

uint64_t words_take(struct unit_words *words)
{
    uint64_t word = 0;

    words_take_all(words, &word, 1);
    return word;
}

void words_take_all(struct unit_words *words, uint64_t *items, size_t count)
{
    if (count > words->count - words->at) {
        words->failed = true;
    } else if (count > 0) {
        memcpy(items, words->items + words->at, count * sizeof *items);
        words->at += count;
    }
}

bool words_resize(struct unit_words *words, size_t count)
{
    words_clear(words);
    if (!make_room(words, count))
        return false;
    words->count = count;
    return true;
}

void words_clear(struct unit_words *words)
{
    words->count = words->at = 0;
    words->failed = false;
}

void words_free(struct unit_words *words)
{
    free(words->items);
    *words = (struct unit_words){ .items = NULL };
}

/* ---- Accounts ------------------------------------------------------------ */

static void put_name(struct unit_words *words, const char *name)
{
    size_t length = strlen(name);

    words_put(words, length);
    for (size_t i = 0; i < length; i++)
        words_put(words, (unsigned char)name[i]);
}

static void put_account(struct unit_words *words, const c205_account *account)
{
    put_name(words, account->name);
    words_put_all(words, account->clocks, C205_CAUSES);
    words_put(words, account->instructions);
    words_put(words, account->vector_instructions);
    words_put(words, account->elements);
    words_put(words, account->operations);
    words_put(words, account->entries);
}

void words_put_accounts(struct unit_words *words, const struct accounts *accounts)
{
    words_put(words, accounts->count);
    for (size_t i = 0; i < accounts->count; i++)
        put_account(words, &accounts->items[i]);
}

static bool take_account(struct unit_words *words, struct accounts *accounts)
{
    char name[256];
    c205_account account = { .name = name };
    uint64_t length = words_take(words);

    if (length >= sizeof name)
        return false;
    for (uint64_t i = 0; i < length; i++)
        name[i] = (char)words_take(words);
    name[length] = '\0';
    words_take_all(words, account.clocks, C205_CAUSES);
    account.instructions = words_take(words);
    account.vector_instructions = words_take(words);
    account.elements = words_take(words);
    account.operations = words_take(words);
    account.entries = words_take(words);
    return !words->failed && accounts_add_account(accounts, &account);
}

bool words_take_accounts(struct unit_words *words, struct accounts *accounts)
{
    uint64_t count = words_take(words);

    for (uint64_t i = 0; i < count; i++)
        if (!take_account(words, accounts))
            return false;
    return !words->failed;
}
