/* memory.h - bit-addressed, paged virtual memory.
 *
 * An address is 48 bits and names a bit; a page holds 65,536 words (2^22
 * bits).  A word is kept as a host integer whose top bit is its bit 0.
 * Nothing here knows of time, residence or associative registers: that is
 * clock.h's matter.
 */
#ifndef C205_MEMORY_H
#define C205_MEMORY_H

#include "vm/c205.h"

#define ADDRESS_MASK UINT64_C(0xFFFFFFFFFFFF)
enum {
    WORD_BITS = 64,
    HALF_BITS = 32,
    PAGE_SHIFT = 22,      /* bits of address within a page */
    DIRECTORY_SHIFT = 35, /* .. and within a directory's pages */
    DIRECTORY_PAGES = 1 << (DIRECTORY_SHIFT - PAGE_SHIFT),
    DIRECTORIES = 1 << (48 - DIRECTORY_SHIFT)
};

/* Half words travel in the left half of a word, the right one zeros. */
#define LEFT_HALF UINT64_C(0xFFFFFFFF00000000)
#define ADDRESS_SPACE_WORDS ((ADDRESS_MASK + 1) / WORD_BITS)
#define PAGE_BITS (UINT64_C(1) << PAGE_SHIFT)

struct page {
    struct page *next; /* of a machine's own, or of the spare ones */
    c205_word word[C205_PAGE_WORDS];
    /* Which words hold decoded code: bit i % 64, counted from the right, of
     * code[i / 64]. */
    uint64_t code[C205_PAGE_WORDS / 64];
    bool holds_code; /* some bit of code was set */
    bool writable;
    bool shared; /* by machines that have not written there: not this one's own */
};

/* A page that was found lately, so that it need not be looked for: its number,
 * where its words are, and whether they may be stored and hold no code.  What
 * is kept here is forgotten whenever pages come, go or change in that. */
struct near_page {
    uint64_t number;
    c205_word *word;
    bool stores;
};
enum { NEAR_PAGES = 16 };

struct memory {
    struct page **directory[DIRECTORIES];
    struct near_page near_page[NEAR_PAGES]; /* by the last bits of numbers */
    struct page *own;      /* pages that are mapped, but those that are shared */
    struct page *spare;    /* .. for the next that are */
    uint64_t code_changes; /* how often a word that held decoded code was
                              written, and one; the decode cache looks at it */
    bool rewritten;        /* one was, since all was unmapped */
};

/* The memory is a machine's, all zeros before. */
void memory_init(struct memory *memory);
/* Unmap everything; counts as a change of code. */
void memory_clear(struct memory *memory);
/* The same, and keep no page for later. */
void memory_free(struct memory *memory);
/* Pages mapped before keep their words and take the new access. */
bool memory_map(struct memory *memory, uint64_t address, size_t words,
                c205_access access, c205_error *error);

/* A row of pages from that address on, where nothing is mapped; each is copied before
 * it is written, and then to be read and written. */
bool memory_map_shared(struct memory *memory, uint64_t address, struct page *pages,
                       size_t count, c205_error *error);
/* The copy.  NULL: no memory. */
struct page *memory_own(const struct memory *memory, uint64_t address);

/* Is every bit of the range mapped (and writable)?  NONE, UNMAPPED_ADDRESS
 * or PROTECTED_ADDRESS with the first such address in *fault.  A range does
 * not continue from the end of the address space to its beginning. */
c205_trap memory_check(const struct memory *memory, uint64_t address, uint64_t bits,
                       bool write, uint64_t *fault);

/* The span of words from a word-aligned address on that lies in one piece:
 * a pointer to the first and in *count how many there are of the count asked
 * for.  NULL: the first is not mapped.  For writing, marks code as changed. */
const c205_word *memory_read_span(const struct memory *memory, uint64_t address,
                                  size_t *count);
c205_word *memory_write_span(struct memory *memory, uint64_t address, size_t *count);

/* Checked before by memory_check: whole ranges, across pages. */
void memory_read_words(const struct memory *memory, uint64_t address, c205_word *words,
                       size_t count);
void memory_write_words(struct memory *memory, uint64_t address, const c205_word *words,
                        size_t count);
/* Half words, each in the left half of a word. */
void memory_read_halves(const struct memory *memory, uint64_t address,
                        c205_word *halves, size_t count);
void memory_write_halves(struct memory *memory, uint64_t address,
                         const c205_word *halves, size_t count);
/* Bit strings from any bit address; bit i is bit i % 64, counted from the
 * left, of bits[i / 64]; unused bits of the last word are zero on reading and
 * do not matter on writing. */
void memory_read_bits(const struct memory *memory, uint64_t address, uint64_t *bits,
                      size_t count);
void memory_write_bits(struct memory *memory, uint64_t address, const uint64_t *bits,
                       size_t count);

/* The word at address now holds decoded code. */
void memory_mark_code(struct memory *memory, uint64_t address);
/* Words of a page, about to be written, may hold decoded code. */
void memory_change_code(struct memory *memory, struct page *page, size_t first,
                        size_t count);

/* The address of the first mapped page from a page on; the end of the address
 * space: there is none. */
uint64_t memory_next_page(const struct memory *memory, uint64_t address);

/* Look for a page; NULL: not mapped. */
const struct near_page *memory_find_near(struct memory *memory, uint64_t address);

static inline const struct near_page *memory_near(struct memory *memory,
                                                  uint64_t address)
{
    uint64_t number = address >> PAGE_SHIFT;
    const struct near_page *page = &memory->near_page[number % NEAR_PAGES];
    return page->number == number ? page : memory_find_near(memory, address);
}

#define MEMORY_NO_PAGE "no memory left for a page of the machine"

/* Its place stands for a page to be read and written, all zeros, until that is
 * looked for. */
extern const uint64_t memory_untouched;

static inline bool memory_is_untouched(const struct page *page)
{
    return (const void *)page == &memory_untouched;
}

/* NULL: not mapped. */
static inline struct page *memory_peek(const struct memory *memory, uint64_t address)
{
    struct page **pages = memory->directory[address >> DIRECTORY_SHIFT];
    return pages ? pages[address >> PAGE_SHIFT & (DIRECTORY_PAGES - 1)] : NULL;
}

struct page *memory_touch(const struct memory *memory, uint64_t address);

static inline bool memory_may_write(const struct page *page)
{
    return page->writable || page->shared;
}

/* NULL: not mapped, or no memory for a page that was not touched yet. */
static inline struct page *memory_page(const struct memory *memory, uint64_t address)
{
    struct page *page = memory_peek(memory, address);
    return memory_is_untouched(page) ? memory_touch(memory, address) : page;
}

/* To be written by this machine; NULL likewise. */
static inline struct page *memory_own_page(const struct memory *memory,
                                           uint64_t address)
{
    struct page *page = memory_page(memory, address);
    return page && page->shared ? memory_own(memory, address) : page;
}

static inline size_t memory_word_index(uint64_t address)
{
    return address / WORD_BITS % C205_PAGE_WORDS;
}

/* One word, checked. */
static inline c205_trap memory_load(const struct memory *memory, uint64_t address,
                                    c205_word *word)
{
    const struct page *page = memory_page(memory, address);
    if (address % WORD_BITS)
        return C205_TRAP_MISALIGNED_OPERAND;
    if (!page)
        return C205_TRAP_UNMAPPED_ADDRESS;
    *word = page->word[memory_word_index(address)];
    return C205_TRAP_NONE;
}

static inline c205_trap memory_store(struct memory *memory, uint64_t address,
                                     c205_word word)
{
    struct page *page = memory_own_page(memory, address);
    size_t index = memory_word_index(address);
    if (address % WORD_BITS)
        return C205_TRAP_MISALIGNED_OPERAND;
    if (!page)
        return C205_TRAP_UNMAPPED_ADDRESS;
    if (!page->writable)
        return C205_TRAP_PROTECTED_ADDRESS;
    if (page->holds_code)
        memory_change_code(memory, page, index, 1);
    page->word[index] = word;
    return C205_TRAP_NONE;
}

/* One half word, checked, in the left half of *half. */
c205_trap memory_load_half(const struct memory *memory, uint64_t address,
                           c205_word *half);
c205_trap memory_store_half(struct memory *memory, uint64_t address, c205_word half);

#endif
