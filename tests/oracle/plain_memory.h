/* plain_memory.h - memory as pages of words, for the reference interpreter.
 *
 * Its only source is docs/machine.md. Stores are recorded until plain_commit or
 * plain_undo, so that the stores of an instruction that traps can be undone.
 */
#ifndef PLAIN_MEMORY_H
#define PLAIN_MEMORY_H

#include "vm/c205.h"

struct plain_page {
    uint64_t number;
    c205_access access;
    c205_word *words;
};

struct plain_change {
    uint64_t address;
    c205_word before;
};

struct plain_memory {
    struct plain_page *pages;
    size_t page_count;
    struct plain_change *changes;
    size_t change_count, change_room;
};

/* Returns the low 48 bits of a bit address, because the other bits are ignored. */
uint64_t plain_address(uint64_t address);

void plain_begin(struct plain_memory *memory);
void plain_end(struct plain_memory *memory);

void plain_map(struct plain_memory *memory, uint64_t address, size_t words,
               c205_access access);
bool plain_is_mapped(const struct plain_memory *memory, uint64_t address);
bool plain_is_writable(const struct plain_memory *memory, uint64_t address);

/* Returns a pointer to the word at an address; the other words of the page follow it.
 * Returns NULL if there is no such page. */
c205_word *plain_words(const struct plain_memory *memory, uint64_t address);
/* Returns the word at an address. Words that were never stored are zero, mapped or not.
 * A store outside of the pages, which is a fault, has no effect. */
c205_word plain_read(const struct plain_memory *memory, uint64_t address);
void plain_store(struct plain_memory *memory, uint64_t address, c205_word word);

/* plain_commit keeps the stores since the last call, plain_undo undoes them. */
void plain_commit(struct plain_memory *memory);
void plain_undo(struct plain_memory *memory);

/* Resizes an array to count items, and keeps the first items. If out of memory, ends
 * the program. */
void *plain_room(void *items, size_t count, size_t size);

#endif
