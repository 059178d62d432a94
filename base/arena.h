/* arena.h - an arena: memory that is allocated in pieces and freed all at once.
 *
 * Pieces are zeroed. If the host is out of memory, pieces are NULL and failed is set;
 * earlier pieces remain valid.
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
/* Returns a NUL-terminated copy. */
char *arena_text(struct arena *arena, const char *text, size_t length);
/* Makes room for one more item in an array of count items. Returns the array, which
 * moves if *capacity has to grow, or NULL; the old array then remains valid. */
void *arena_grow(struct arena *arena, void *items, size_t count, size_t *capacity,
                 size_t item_size);
void arena_free(struct arena *arena);

#endif
