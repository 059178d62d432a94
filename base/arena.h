/* arena.h - an arena: memory that is allocated in pieces and freed all at once.
 *
 * Pieces are zeroed. A piece is NULL if the host is out of memory; failed is then set,
 * and earlier pieces remain valid.
 */
#ifndef BASE_ARENA_H
#define BASE_ARENA_H

#include <stdbool.h>
#include <stddef.h>

struct arena {
    struct arena_block *blocks;
    bool failed;
};

void *arena_take(struct arena *arena, size_t size);
/* Returns a copy of `length` bytes of a text, which ends with a NUL. */
char *arena_text(struct arena *arena, const char *text, size_t length);
/* Adds a copy of an item, or zeros if item is NULL, to an array of *count items, and
 * returns its place. items: the address of the pointer to the array, which moves if
 * *capacity grows. Returns NULL, with the array unchanged, if the host is out of
 * memory. */
void *arena_add(struct arena *arena, void *items, size_t *count, size_t *capacity,
                const void *item, size_t size);
void arena_free(struct arena *arena);

#endif
