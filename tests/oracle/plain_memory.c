/* plain_memory.c - memory as a sparse map: a hash table of words. */
#include "plain_memory.h"

#include "tests/oracle/give_up.h"

#include <stdlib.h>

enum { WORD_BITS = 64, FIRST_SLOTS = 1024 };
#define ADDRESS_MASK UINT64_C(0xFFFFFFFFFFFF)
#define NO_ADDRESS UINT64_MAX

struct plain_slot {
    uint64_t address; /* NO_ADDRESS: unused */
    c205_word word;
};

void *plain_room(void *items, size_t count, size_t size)
{
    void *room = realloc(items, count * size);
    if (!room)
        give_up("out of memory");
    return room;
}

uint64_t plain_address(uint64_t address)
{
    return address & ADDRESS_MASK;
}

uint64_t plain_page_number(uint64_t address)
{
    return plain_address(address) / WORD_BITS / C205_PAGE_WORDS;
}

/* ---- Words ------------------------------------------------------------- */

static void free_slots(struct plain_memory *memory, size_t count)
{
    memory->slots = plain_room(NULL, count, sizeof *memory->slots);
    memory->slot_count = count;
    memory->word_count = 0;
    for (size_t i = 0; i < count; i++)
        memory->slots[i] = (struct plain_slot){ NO_ADDRESS, 0 };
}

/* Returns the slot of an address, or the unused slot for it. */
static struct plain_slot *find(const struct plain_memory *memory, uint64_t address)
{
    uint64_t mixed = address * UINT64_C(0x9E3779B97F4A7C15);
    size_t i = (size_t)(mixed >> 32) & (memory->slot_count - 1);
    while (memory->slots[i].address != NO_ADDRESS
           && memory->slots[i].address != address)
        i = (i + 1) & (memory->slot_count - 1);
    return memory->slots + i;
}

static void put(struct plain_memory *memory, uint64_t address, c205_word word)
{
    struct plain_slot *slot = find(memory, address);
    memory->word_count += slot->address == NO_ADDRESS;
    *slot = (struct plain_slot){ address, word };
}

static void grow(struct plain_memory *memory)
{
    struct plain_slot *old = memory->slots;
    size_t count = memory->slot_count;
    free_slots(memory, 2 * count);
    for (size_t i = 0; i < count; i++)
        if (old[i].address != NO_ADDRESS)
            put(memory, old[i].address, old[i].word);
    free(old);
}

c205_word plain_read(const struct plain_memory *memory, uint64_t address)
{
    return find(memory, plain_address(address))->word;
}

static void remember(struct plain_memory *memory, uint64_t address)
{
    if (memory->change_count == memory->change_room) {
        memory->change_room = 2 * memory->change_room + WORD_BITS;
        memory->changes = plain_room(memory->changes, memory->change_room,
                                     sizeof *memory->changes);
    }
    memory->changes[memory->change_count++] = (struct plain_change){
        address, plain_read(memory, address)
    };
}

void plain_store(struct plain_memory *memory, uint64_t address, c205_word word)
{
    remember(memory, plain_address(address));
    if (2 * memory->word_count >= memory->slot_count)
        grow(memory);
    put(memory, plain_address(address), word);
}

void plain_commit(struct plain_memory *memory)
{
    memory->change_count = 0;
}

void plain_undo(struct plain_memory *memory)
{
    while (memory->change_count > 0) {
        const struct plain_change *last = memory->changes + --memory->change_count;
        put(memory, last->address, last->before);
    }
}

/* ---- Pages ------------------------------------------------------------- */

static struct plain_page *page_of(const struct plain_memory *memory, uint64_t address)
{
    for (size_t i = 0; i < memory->page_count; i++)
        if (memory->pages[i].number == plain_page_number(address))
            return memory->pages + i;
    return NULL;
}

static void map_page(struct plain_memory *memory, uint64_t address, c205_access access)
{
    if (!page_of(memory, address)) {
        memory->pages = plain_room(memory->pages, memory->page_count + 1,
                                   sizeof *memory->pages);
        memory->pages[memory->page_count++].number = plain_page_number(address);
    }
    page_of(memory, address)->access = access;
}

void plain_map(struct plain_memory *memory, uint64_t address, size_t words,
               c205_access access)
{
    uint64_t last = address + WORD_BITS * (uint64_t)(words - 1);
    for (uint64_t page = plain_page_number(address); page <= plain_page_number(last);
         page++)
        map_page(memory, page * C205_PAGE_WORDS * WORD_BITS, access);
}

bool plain_is_mapped(const struct plain_memory *memory, uint64_t address)
{
    return page_of(memory, address) != NULL;
}

bool plain_is_writable(const struct plain_memory *memory, uint64_t address)
{
    const struct plain_page *page = page_of(memory, address);
    return page && page->access == C205_READ_WRITE;
}

/* ---- Begin and end ----------------------------------------------------- */

void plain_begin(struct plain_memory *memory)
{
    *memory = (struct plain_memory){ .page_count = 0 };
    free_slots(memory, FIRST_SLOTS);
}

void plain_end(struct plain_memory *memory)
{
    free(memory->slots);
    free(memory->pages);
    free(memory->changes);
}
