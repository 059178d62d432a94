/* plain_memory.c - memory as pages of words. */
#include "plain_memory.h"

#include "tests/oracle/give_up.h"

enum { WORD_BITS = 64 };
#define ADDRESS_MASK UINT64_C(0xFFFFFFFFFFFF)

void *plain_room(void *items, size_t count, size_t size)
{
    return NEEDED(realloc(items, count * size));
}

uint64_t plain_address(uint64_t address)
{
    return address & ADDRESS_MASK;
}

static uint64_t page_number(uint64_t address)
{
    return plain_address(address) / WORD_BITS / C205_PAGE_WORDS;
}

/* ---- Pages ------------------------------------------------------------- */

static struct plain_page *page_of(const struct plain_memory *memory, uint64_t address)
{
    for (size_t i = 0; i < memory->page_count; i++)
        if (memory->pages[i].number == page_number(address))
            return memory->pages + i;
    return NULL;
}

static void map_page(struct plain_memory *memory, uint64_t address, c205_access access)
{
    if (!page_of(memory, address)) {
        c205_word *words = NEEDED(calloc(C205_PAGE_WORDS, sizeof *words));
        memory->pages = plain_room(memory->pages, memory->page_count + 1,
                                   sizeof *memory->pages);
        memory->pages[memory->page_count++] = (struct plain_page){
            .number = page_number(address), .words = words
        };
    }
    page_of(memory, address)->access = access;
}

void plain_map(struct plain_memory *memory, uint64_t address, size_t words,
               c205_access access)
{
    uint64_t last = address + WORD_BITS * (uint64_t)(words - 1);
    for (uint64_t page = page_number(address); page <= page_number(last); page++)
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

/* ---- Words ------------------------------------------------------------- */

c205_word *plain_words(const struct plain_memory *memory, uint64_t address)
{
    const struct plain_page *page = page_of(memory, address);
    return page ? page->words + plain_address(address) / WORD_BITS % C205_PAGE_WORDS
                : NULL;
}

c205_word plain_read(const struct plain_memory *memory, uint64_t address)
{
    const c205_word *word = plain_words(memory, address);
    return word ? *word : 0;
}

void plain_store(struct plain_memory *memory, uint64_t address, c205_word word)
{
    c205_word *old = plain_words(memory, address);
    if (!old)
        return;
    if (memory->change_count == memory->change_room) {
        memory->change_room = 2 * memory->change_room + WORD_BITS;
        memory->changes = plain_room(memory->changes, memory->change_room,
                                     sizeof *memory->changes);
    }
    memory->changes[memory->change_count++] = (struct plain_change){
        plain_address(address), *old
    };
    *old = word;
}

void plain_commit(struct plain_memory *memory)
{
    memory->change_count = 0;
}

void plain_undo(struct plain_memory *memory)
{
    while (memory->change_count > 0) {
        const struct plain_change *last = memory->changes + --memory->change_count;
        *plain_words(memory, last->address) = last->before;
    }
}

/* ---- Begin and end ----------------------------------------------------- */

void plain_begin(struct plain_memory *memory)
{
    *memory = (struct plain_memory){ .page_count = 0 };
}

void plain_end(struct plain_memory *memory)
{
    for (size_t i = 0; i < memory->page_count; i++)
        free(memory->pages[i].words);
    free(memory->pages);
    free(memory->changes);
}
