/* plain_memory.h - memory as a sparse map from addresses to words.
 *
 * Written from docs/machine.md alone, for the reference interpreter.  Every
 * store is remembered until it is settled or undone, so that an instruction
 * which turns out to trap can be taken back as a whole.
 */
#ifndef PLAIN_MEMORY_H
#define PLAIN_MEMORY_H

#include "vm/c205.h"

struct plain_page {
    uint64_t number;
    c205_access access;
};

struct plain_change {
    uint64_t address;
    c205_word before;
};

struct plain_memory {
    struct plain_slot *slots;
    size_t slot_count, word_count;
    struct plain_page *pages;
    size_t page_count;
    struct plain_change *changes;
    size_t change_count, change_room;
};

/* Addresses are bit addresses of words; only their low 48 bits count. */
uint64_t plain_address(uint64_t address);
uint64_t plain_page_number(uint64_t address);

void plain_begin(struct plain_memory *memory);
void plain_end(struct plain_memory *memory);

void plain_map(struct plain_memory *memory, uint64_t address, size_t words,
               c205_access access);
bool plain_is_mapped(const struct plain_memory *memory, uint64_t address);
bool plain_is_writable(const struct plain_memory *memory, uint64_t address);

/* Words never stored are zero, mapped or not. */
c205_word plain_read(const struct plain_memory *memory, uint64_t address);
void plain_store(struct plain_memory *memory, uint64_t address, c205_word word);

/* The stores since the last of these two calls are kept or taken back. */
void plain_commit(struct plain_memory *memory);
void plain_undo(struct plain_memory *memory);

/* Room for count items of a size, the first ones kept; ends the program
 * when the host has no memory left. */
void *plain_room(void *items, size_t count, size_t size);

#endif
