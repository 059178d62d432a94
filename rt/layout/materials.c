/* materials.c - finds equal materials with a hash table. */
#include "rt/layout/materials.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/hash.h"

struct look {
    c205_word words[LOOK_WORDS];
    uint64_t address;
};

/* A hash table with open addressing. An entry of places is 0 or an index of a row
 * plus 1. */
struct looks {
    size_t count, mask;
    struct look *rows;
    size_t *places;
};

struct looks *looks_new(size_t count)
{
    struct looks *looks = calloc(1, sizeof *looks);
    size_t room = 4;

    if (!looks)
        return NULL;
    while (room < 2 * count)
        room *= 2;
    looks->mask = room - 1;
    looks->places = calloc(room, sizeof *looks->places);
    if (looks->places)
        return looks;
    free(looks);
    return NULL;
}

void looks_free(struct looks *looks)
{
    if (!looks)
        return;
    free(looks->rows);
    free(looks->places);
    free(looks);
}

uint64_t looks_first(struct looks *looks, const c205_word words[LOOK_WORDS],
                     uint64_t address)
{
    size_t place = (size_t)hash_words(HASH_START, words, LOOK_WORDS);
    struct look *rows;

    for (place &= looks->mask; looks->places[place] > 0;
         place = (place + 1) & looks->mask) {
        const struct look *look = &looks->rows[looks->places[place] - 1];

        if (memcmp(look->words, words, sizeof look->words) == 0)
            return look->address;
    }
    rows = array_grow(looks->rows, looks->count, sizeof *rows);
    if (!rows)
        return 0;
    looks->rows = rows;
    memcpy(rows[looks->count].words, words, sizeof rows->words);
    rows[looks->count++].address = address;
    looks->places[place] = looks->count;
    return address;
}
