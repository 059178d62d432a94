/* materials.c - finds equal materials with a hash table. */
#include "rt/layout/materials.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/fnv_hash.h"

struct material {
    c205_word words[MATERIAL_WORDS];
    uint64_t address;
};

/* A hash table with open addressing. An element of `places` is 0, or the index of a row
 * plus 1. */
struct material_table {
    size_t count, mask;
    struct material *rows;
    size_t *places;
};

struct material_table *materials_new(size_t count)
{
    struct material_table *materials = calloc(1, sizeof *materials);
    size_t room = 4;
    if (!materials)
        return NULL;
    while (room < 2 * count)
        room *= 2;
    materials->mask = room - 1;
    materials->places = calloc(room, sizeof *materials->places);
    if (materials->places)
        return materials;
    free(materials);
    return NULL;
}

void materials_free(struct material_table *materials)
{
    if (!materials)
        return;
    free(materials->rows);
    free(materials->places);
    free(materials);
}

uint64_t materials_first(struct material_table *materials,
                         const c205_word words[MATERIAL_WORDS], uint64_t address)
{
    size_t place = (size_t)hash_words(HASH_START, words, MATERIAL_WORDS);
    struct material *added;
    for (place &= materials->mask; materials->places[place] > 0;
         place = (place + 1) & materials->mask) {
        const struct material *material = &materials
                                               ->rows[materials->places[place] - 1];

        if (memcmp(material->words, words, sizeof material->words) == 0)
            return material->address;
    }
    added = array_add(&materials->rows, &materials->count, NULL, sizeof *added);
    if (!added)
        return 0;
    memcpy(added->words, words, sizeof added->words);
    added->address = address;
    materials->places[place] = materials->count;
    return address;
}
