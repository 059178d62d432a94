/* words.h - 64-bit words in a row: what a unit of work comes to, as files keep it and
 * messages carry it. */
#ifndef RT_FARM_WORDS_H
#define RT_FARM_WORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/accounts.h"

/* Begin with zeros. */
struct unit_words {
    uint64_t *items;
    size_t count, room;
    size_t at;   /* the next one to be taken */
    bool failed; /* no memory, or taken beyond the end */
};

void words_put(struct unit_words *words, uint64_t word);
void words_put_all(struct unit_words *words, const uint64_t *items, size_t count);
/* 0, and failed, beyond the end. */
uint64_t words_take(struct unit_words *words);
/* So many into items; none if there are fewer. */
void words_take_all(struct unit_words *words, uint64_t *items, size_t count);
/* So many, of any values; false: no memory. */
bool words_resize(struct unit_words *words, size_t count);
void words_clear(struct unit_words *words);
void words_free(struct unit_words *words);

void words_put_accounts(struct unit_words *words, const struct accounts *accounts);
/* Added to those that there are.  False: they are none, or no memory. */
bool words_take_accounts(struct unit_words *words, struct accounts *accounts);

#endif
