/* arena.c - allocates pieces from a list of blocks. */
#include "base/arena.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"

union widest {
    long double number;
    void *pointer;
    long long integer;
};

struct arena_block {
    struct arena_block *next;
    size_t used, size;
    union widest bytes[1];
};

/* Builds with sanitizers define a smaller block size, which reveals more accesses
 * beyond the end of a piece of memory. */
#ifndef BLOCK_SIZE
#define BLOCK_SIZE ((size_t)64 * 1024)
#endif

static struct arena_block *add_block(struct arena *arena, size_t size)
{
    size_t header = offsetof(struct arena_block, bytes);
    struct arena_block *block;
    if (size < BLOCK_SIZE)
        size = BLOCK_SIZE;
    block = size > SIZE_MAX - header ? NULL : calloc(1, header + size);
    if (!block) {
        arena->failed = true;
        return NULL;
    }
    block->size = size;
    block->next = arena->blocks;
    arena->blocks = block;
    return block;
}

void *arena_take(struct arena *arena, size_t size)
{
    struct arena_block *block = arena->blocks;
    size_t step = sizeof(union widest);
    char *piece;
    if (size > SIZE_MAX / 2) {
        arena->failed = true;
        return NULL;
    }
    size = (size + step - 1) / step * step;
    if (!block || block->size - block->used < size)
        block = add_block(arena, size);
    if (!block)
        return NULL;
    piece = (char *)block->bytes + block->used;
    block->used += size;
    return piece;
}

char *arena_text(struct arena *arena, const char *text, size_t length)
{
    char *copy = arena_take(arena, length + 1);
    if (copy && length > 0)
        memcpy(copy, text, length);
    return copy;
}

/* Returns the array with room for one more item, or NULL if the host is out of memory.
 * The array may move. */
static void *grow(struct arena *arena, void *items, size_t count, size_t *capacity,
                  size_t size)
{
    size_t larger = *capacity ? 2 * *capacity : 16;
    void *moved;
    if (count < *capacity)
        return items;
    if (larger > SIZE_MAX / 2 / size) {
        arena->failed = true;
        return NULL;
    }
    moved = arena_take(arena, larger * size);
    if (!moved)
        return NULL;
    if (count > 0)
        memcpy(moved, items, count * size);
    *capacity = larger;
    return moved;
}

void *arena_add(struct arena *arena, void *items, size_t *count, size_t *capacity,
                const void *item, size_t size)
{
    void *array;
    memcpy(&array, items, sizeof array);
    array = grow(arena, array, *count, capacity, size);
    return array_store(items, array, count, item, size);
}

void arena_free(struct arena *arena)
{
    while (arena->blocks) {
        struct arena_block *next = arena->blocks->next;
        free(arena->blocks);
        arena->blocks = next;
    }
    arena->failed = false;
}
