/* image.c - collects the contents of memory and loads it into machines. */
#include "rt/layout/image.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "vm/error.h"

static bool add_block(struct image *image, struct image_block block)
{
    return array_add(&image->blocks, &image->count, &block, sizeof block);
}

bool image_reserve(struct image *image, uint64_t address, size_t count)
{
    return add_block(image, (struct image_block){ address, count, NULL, NULL, true });
}

/* Returns the mapped block that contains the words, or NULL. */
static struct image_block *block_of(struct image *image, uint64_t address, size_t count)
{
    for (size_t i = image->count; i-- > 0;) {
        struct image_block *block = &image->blocks[i];
        if (block->mapped && address >= block->address
            && address + UINT64_C(64) * count
                   <= block->address + UINT64_C(64) * block->count)
            return block;
    }
    return NULL;
}

bool image_write(struct image *image, uint64_t address, const c205_word *words,
                 size_t count)
{
    struct image_block *block = block_of(image, address, count);
    if (!block) {
        if (!add_block(image,
                       (struct image_block){ address, count, NULL, NULL, false }))
            return false;
        block = &image->blocks[image->count - 1];
    }
    if (!block->words)
        block->words = calloc(block->count + 1, sizeof *block->words);
    if (!block->words)
        return false;
    memcpy(block->words + (address - block->address) / 64, words,
           count * sizeof *words);
    return true;
}

void image_share(struct image *image)
{
    for (size_t i = 0; i < image->count; i++) {
        struct image_block *block = &image->blocks[i];
        if (!block->mapped || !block->words)
            continue;
        block->shared = c205_shared_new(block->words, block->count);
        if (block->shared) {
            free(block->words);
            block->words = NULL;
        }
    }
}

static bool load_block(const struct image_block *block, c205 *machine,
                       c205_error *error)
{
    if (block->shared)
        return c205_map_shared(machine, block->address, block->shared, error);
    if (block->mapped
        && !c205_map(machine, block->address, block->count,
                     block->words ? C205_READ_WRITE : C205_WHEN_TOUCHED, error))
        return false;
    return !block->words
           || c205_write(machine, block->address, block->words, block->count)
           || error_set(error, "address %012llX is not mapped",
                        (unsigned long long)block->address);
}

bool image_load(const struct image *image, c205 *machine, c205_error *error)
{
    for (size_t i = 0; i < image->count; i++)
        if (!load_block(&image->blocks[i], machine, error))
            return false;
    return true;
}

void image_free(struct image *image)
{
    for (size_t i = 0; i < image->count; i++) {
        free(image->blocks[i].words);
        c205_shared_free(image->blocks[i].shared);
    }
    free(image->blocks);
    *image = (struct image){ 0 };
}
