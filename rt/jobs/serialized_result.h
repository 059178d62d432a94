/* serialized_result.h - a growing row of 64-bit words: the result of a unit of work, as
 * it is stored in files and sent in messages. */
#ifndef RT_FARM_WORDS_H
#define RT_FARM_WORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/accounts.h"

/* Must start as zeros. */
struct serialized_result {
    uint64_t *items;
    size_t count, room;
    size_t at;   /* index of the next word to take */
    bool failed; /* no memory, or a read beyond the end */
};

void result_put(struct serialized_result *words, uint64_t word);
void result_put_all(struct serialized_result *words, const uint64_t *items,
                    size_t count);
/* Returns the next word. Beyond the end it returns 0 and sets failed. */
uint64_t result_take(struct serialized_result *words);
/* Reads count words into items, or none if there are fewer. */
void result_take_all(struct serialized_result *words, uint64_t *items, size_t count);
/* Sets the number of words, with any values. Returns false if out of memory. */
bool result_resize(struct serialized_result *words, size_t count);
void result_clear(struct serialized_result *words);
void result_free(struct serialized_result *words);

void result_put_accounts(struct serialized_result *words,
                         const struct accounts *accounts);
/* Adds the accounts in the words to the existing ones. Returns false if their
 * format is wrong, or if out of memory. */
bool result_take_accounts(struct serialized_result *words, struct accounts *accounts);

#endif
