/* serialized_result.h - 64-bit words in a row: what a unit of work comes to, as files keep it and
 * messages carry it. */
#ifndef RT_FARM_WORDS_H
#define RT_FARM_WORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/accounts.h"

/* Begin with zeros. */
struct serialized_result {
    uint64_t *items;
    size_t count, room;
    size_t at;   /* the next one to be taken */
    bool failed; /* no memory, or taken beyond the end */
};

void result_put(struct serialized_result *words, uint64_t word);
void result_put_all(struct serialized_result *words, const uint64_t *items,
                    size_t count);
/* 0, and failed, beyond the end. */
uint64_t result_take(struct serialized_result *words);
/* So many into items; none if there are fewer. */
void result_take_all(struct serialized_result *words, uint64_t *items, size_t count);
/* So many, of any values; false: no memory. */
bool result_resize(struct serialized_result *words, size_t count);
void result_clear(struct serialized_result *words);
void result_free(struct serialized_result *words);

void result_put_accounts(struct serialized_result *words,
                         const struct accounts *accounts);
/* Added to those that there are.  False: they are none, or no memory. */
bool result_take_accounts(struct serialized_result *words, struct accounts *accounts);

#endif
