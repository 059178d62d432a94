/* serialized_result.h - writes and reads a growing sequence of 64-bit words: the form
 * in which files and messages contain the result of a unit of work. */
#ifndef RT_SERIALIZED_RESULT_H
#define RT_SERIALIZED_RESULT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/accounts.h"

/* A serialized result. It must initially be zeros. */
struct serialized_result {
    uint64_t *items;
    size_t count, room;
    size_t at;   /* index of the next word to take */
    bool failed; /* out of memory, or a read after the last word */
};

void result_put(struct serialized_result *words, uint64_t word);
void result_put_all(struct serialized_result *words, const uint64_t *items,
                    size_t count);
/* Returns the next word. After the last word it returns 0 and sets `failed`. */
uint64_t result_take(struct serialized_result *words);
/* Reads count words into items. If there are fewer words, it reads none. */
void result_take_all(struct serialized_result *words, uint64_t *items, size_t count);
/* Sets the number of words. New words have arbitrary values. Returns false if out of
 * memory. */
bool result_resize(struct serialized_result *words, size_t count);
void result_clear(struct serialized_result *words);
void result_free(struct serialized_result *words);

void result_put_accounts(struct serialized_result *words,
                         const struct accounts *accounts);
/* Reads accounts and adds them to *accounts. Returns false if their format is wrong, or
 * if out of memory. */
bool result_take_accounts(struct serialized_result *words, struct accounts *accounts);

#endif
