/* memory.h - maps, reads and writes bit-addressed, paged virtual memory.
 *
 * An address has 48 bits and names a bit. A page holds 65,536 words (2^22 bits). A word
 * is a host integer whose top bit is its bit 0. Time, residence and associative
 * registers are not part of this module; see clock.h.
 */
#ifndef C205_MEMORY_H
#define C205_MEMORY_H

#include "vm/c205.h"

#define ADDRESS_MASK UINT64_C(0xFFFFFFFFFFFF)
enum {
    WORD_BITS = 64,
    HALF_BITS = 32,
    PAGE_SHIFT = 22,      /* log2 of the bits of a page */
    DIRECTORY_SHIFT = 35, /* log2 of the bits that a directory covers */
    DIRECTORY_PAGES = 1 << (DIRECTORY_SHIFT - PAGE_SHIFT),
    DIRECTORIES = 1 << (48 - DIRECTORY_SHIFT)
};

/* Half words are passed in the left half of a word; the right half is zero. */
#define LEFT_HALF UINT64_C(0xFFFFFFFF00000000)
#define ADDRESS_SPACE_WORDS ((ADDRESS_MASK + 1) / WORD_BITS)
#define PAGE_BITS (UINT64_C(1) << PAGE_SHIFT)

struct page {
    struct page *next; /* in the list of own or spare pages */
    c205_word word[C205_PAGE_WORDS];
    /* The marks of words that hold decoded code. The mark of word i is bit i % 64 of
     * code[i / 64], counted from the right. */
    uint64_t code[C205_PAGE_WORDS / 64];
    bool holds_code; /* some mark has been set */
    bool writable;
    bool shared; /* shared by several machines; no machine owns it */
};

/* A cached page: its number, the address of its words, and whether stores need no
 * further checks, because the page is writable and holds no code. The cache is cleared
 * if a page is mapped, unmapped or changes in these properties. */
struct near_page {
    uint64_t number;
    c205_word *word;
    bool stores;
};
enum { NEAR_PAGES = 16 };

struct memory {
    struct page **directory[DIRECTORIES];
    struct near_page near_page[NEAR_PAGES]; /* indexed by the low bits of the page
                                               number */
    struct page *own;                       /* list of mapped pages except shared
                                               pages */
    struct page *spare;                     /* free pages for reuse */
    uint64_t code_changes; /* 1 + number of changes of words that held decoded code; the
                              decode cache compares it */
    bool rewritten;        /* a word that held decoded code changed since
                              memory_clear */
};

/* Initialises the memory of a machine. The struct must be zeroed. */
void memory_init(struct memory *memory);
/* Unmaps all pages. Decoded code becomes invalid. */
void memory_clear(struct memory *memory);
/* Unmaps all pages and frees the spare pages. */
void memory_free(struct memory *memory);
/* Maps pages. Pages that were mapped before retain their words and get the new
 * access. */
bool memory_map(struct memory *memory, uint64_t address, size_t words,
                c205_access access, c205_error *error);

/* Maps count shared pages at consecutive addresses. No page may be mapped there. Each
 * page is copied before it is written, and the copy may be read and written. */
bool memory_map_shared(struct memory *memory, uint64_t address, struct page *pages,
                       size_t count, c205_error *error);
/* Replaces the shared page at an address by a copy that this machine owns and may
 * write. Returns the copy. NULL: out of memory. */
struct page *memory_own(const struct memory *memory, uint64_t address);

/* Checks that every bit of the range is mapped, and writable if write is set. Returns
 * NONE, or UNMAPPED_ADDRESS or PROTECTED_ADDRESS with the first such address in *fault.
 * A range does not wrap around at the end of the address space. */
c205_trap memory_check(const struct memory *memory, uint64_t address, uint64_t bits,
                       bool write, uint64_t *fault);

/* Returns a pointer to the word at a word-aligned address. Reduces *count to the number
 * of contiguous words from there. Writing marks code as changed. NULL: the first word
 * is not mapped. */
const c205_word *memory_read_span(const struct memory *memory, uint64_t address,
                                  size_t *count);
c205_word *memory_write_span(struct memory *memory, uint64_t address, size_t *count);

/* These functions copy ranges that may extend over several pages. memory_check must
 * have succeeded for the range. */
void memory_read_words(const struct memory *memory, uint64_t address, c205_word *words,
                       size_t count);
void memory_write_words(struct memory *memory, uint64_t address, const c205_word *words,
                        size_t count);
/* Copy half words. Each is in the left half of a word. */
void memory_read_halves(const struct memory *memory, uint64_t address,
                        c205_word *halves, size_t count);
void memory_write_halves(struct memory *memory, uint64_t address,
                         const c205_word *halves, size_t count);
/* Copy bit strings from or to any bit address. Bit i is bit i % 64 of bits[i / 64],
 * counted from the left. Unused bits of the last word are zero after reading and
 * ignored when writing. */
void memory_read_bits(const struct memory *memory, uint64_t address, uint64_t *bits,
                      size_t count);
void memory_write_bits(struct memory *memory, uint64_t address, const uint64_t *bits,
                       size_t count);

/* Records that the word at an address holds decoded code. */
void memory_mark_code(struct memory *memory, uint64_t address);
/* Counts a change of code if one of these words holds decoded code, and clears the
 * marks of the words. Must be called before words of a page with marks are changed. */
void memory_change_code(struct memory *memory, struct page *page, size_t first,
                        size_t count);

/* Returns the address of the first mapped page at or after a page, or the end of the
 * address space. */
uint64_t memory_next_page(const struct memory *memory, uint64_t address);

/* Returns the page of an address and caches it. NULL: not mapped. */
const struct near_page *memory_find_near(struct memory *memory, uint64_t address);

static inline const struct near_page *memory_near(struct memory *memory,
                                                  uint64_t address)
{
    uint64_t number = address >> PAGE_SHIFT;
    const struct near_page *page = &memory->near_page[number % NEAR_PAGES];
    return page->number == number ? page : memory_find_near(memory, address);
}

#define MEMORY_NO_PAGE "out of memory for a page of the machine"

/* The address of this constant marks a mapped, writable page of zeros that is allocated
 * on first use. */
extern const uint64_t memory_untouched;

static inline bool memory_is_untouched(const struct page *page)
{
    return (const void *)page == &memory_untouched;
}

/* Returns the page of an address without allocating it. NULL: not mapped. */
static inline struct page *memory_peek(const struct memory *memory, uint64_t address)
{
    struct page **pages = memory->directory[address >> DIRECTORY_SHIFT];
    return pages ? pages[address >> PAGE_SHIFT & (DIRECTORY_PAGES - 1)] : NULL;
}

/* Allocates the page of an address that is mapped but untouched. Returns the page,
 * which contains zeros. NULL: out of memory. */
struct page *memory_touch(const struct memory *memory, uint64_t address);

static inline bool memory_may_write(const struct page *page)
{
    return page->writable || page->shared;
}

/* Returns the page of an address, and allocates it on first use. NULL: not mapped, or
 * out of memory. */
static inline struct page *memory_page(const struct memory *memory, uint64_t address)
{
    struct page *page = memory_peek(memory, address);
    return memory_is_untouched(page) ? memory_touch(memory, address) : page;
}

/* Returns the page of an address. A shared page is first replaced by a copy that
 * belongs to this memory. NULL: not mapped, or out of memory. */
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

/* Load or store one word. Both functions check the alignment of the address and that
 * its page is mapped. A store also checks that the page is writable. They return NONE
 * or the trap. */
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

/* Load or store one half word, which is in the left half of *half, with the same
 * checks. */
c205_trap memory_load_half(const struct memory *memory, uint64_t address,
                           c205_word *half);
c205_trap memory_store_half(struct memory *memory, uint64_t address, c205_word half);

#endif
