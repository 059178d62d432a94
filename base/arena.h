/* arena.h - memory that is taken piece by piece and given back all at once.
 *
 * Pieces are zeroed.  When the host has no memory left, pieces are NULL and
 * failed stays set; nothing that was taken before is lost.
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
/* A NUL-terminated copy. */
char *arena_text(struct arena *arena, const char *text, size_t length);
/* Room for one item more in an array of count items: the array, moved when
 * *capacity had to grow, or NULL, and then the old array is still good. */
void *arena_grow(struct arena *arena, void *items, size_t count, size_t *capacity,
                 size_t item_size);
void arena_free(struct arena *arena);

#endif
