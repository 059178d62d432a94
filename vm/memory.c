/* memory.c - maps pages by a two-level table, and copies words, half words and bits. */
#include "vm/memory.h"
#include "vm/error.h"

#include <stdlib.h>
#include <string.h>

/* ---- Cache of pages ----------------------------------------------------- */

static void forget_near(struct memory *memory)
{
    for (size_t i = 0; i < NEAR_PAGES; i++)
        memory->near_page[i].number = UINT64_MAX;
}

const struct near_page *memory_find_near(struct memory *memory, uint64_t address)
{
    uint64_t number = address >> PAGE_SHIFT;
    struct near_page *near = &memory->near_page[number % NEAR_PAGES];
    struct page *page = memory_page(memory, address);
    if (!page)
        return NULL;
    near->number = number;
    near->word = page->word;
    near->stores = page->writable && !page->holds_code;
    return near;
}

void memory_init(struct memory *memory)
{
    forget_near(memory);
    memory->code_changes = 1;
}

/* Clears the memory without reading shared pages, because they may have been freed
 * already. */
void memory_clear(struct memory *memory)
{
    forget_near(memory);
    for (struct page *page; (page = memory->own);) {
        memory->own = page->next;
        page->next = memory->spare;
        memory->spare = page;
    }
    for (size_t i = 0; i < DIRECTORIES; i++) {
        free(memory->directory[i]);
        memory->directory[i] = NULL;
    }
    memory->rewritten = false;
    memory->code_changes++;
}

static struct page *take_spare(struct memory *memory)
{
    struct page *page = memory->spare;
    if (page)
        memory->spare = page->next;
    return page;
}

void memory_free(struct memory *memory)
{
    memory_clear(memory);
    for (struct page *page; (page = take_spare(memory));)
        free(page);
}

/* ---- Pages -------------------------------------------------------------- */

static struct page **page_place(struct memory *memory, uint64_t address)
{
    struct page ***pages = &memory->directory[address >> DIRECTORY_SHIFT];
    if (!*pages)
        *pages = calloc(DIRECTORY_PAGES, sizeof **pages);
    return *pages ? *pages + (address >> PAGE_SHIFT & (DIRECTORY_PAGES - 1)) : NULL;
}

static struct page *add_own(struct memory *memory, struct page *page)
{
    if (page) {
        page->next = memory->own;
        memory->own = page;
    }
    return page;
}

static struct page *new_page(struct memory *memory)
{
    struct page *page = take_spare(memory);
    return add_own(memory,
                   page ? memset(page, 0, sizeof *page) : calloc(1, sizeof *page));
}

const uint64_t memory_untouched = 0;

/* Allocates the page on first use. The memory is const because this changes no value
 * that can be read. */
struct page *memory_touch(const struct memory *memory, uint64_t address)
{
    struct memory *owner = (struct memory *)memory;
    struct page **place = page_place(owner, address);
    struct page *page = new_page(owner);
    if (page) {
        page->writable = true;
        *place = page;
    }
    return page;
}

static bool map_page(struct memory *memory, uint64_t address, c205_access access)
{
    struct page **place = page_place(memory, address);
    bool untouched = place && (!*place || memory_is_untouched(*place));
    if (place && !untouched && (*place)->shared && !memory_own(memory, address))
        return false;
    if (untouched && access == C205_WHEN_TOUCHED) {
        *place = (struct page *)&memory_untouched;
        return true;
    }
    if (untouched)
        *place = new_page(memory);
    if (!place || !*place)
        return false;
    (*place)->writable = access != C205_READ_ONLY;
    return true;
}

bool memory_map(struct memory *memory, uint64_t address, size_t words,
                c205_access access, c205_error *error)
{
    uint64_t last = address + (uint64_t)words * WORD_BITS - 1;
    if (address > ADDRESS_MASK || (uint64_t)words > ADDRESS_SPACE_WORDS
        || (words > 0 && last > ADDRESS_MASK))
        return error_set(error,
                         "%zu word%s at %llX %s beyond the end of the address space",
                         words, words == 1 ? "" : "s", (unsigned long long)address,
                         words == 1 ? "lies" : "lie");
    forget_near(memory);
    for (uint64_t page = address >> PAGE_SHIFT; words > 0 && page <= last >> PAGE_SHIFT;
         page++)
        if (!map_page(memory, page << PAGE_SHIFT, access))
            return error_set(error, MEMORY_NO_PAGE);
    return true;
}

/* ---- Shared pages ------------------------------------------------------- */

bool memory_map_shared(struct memory *memory, uint64_t address, struct page *pages,
                       size_t count, c205_error *error)
{
    forget_near(memory);
    for (size_t i = 0; i < count; i++, address += PAGE_BITS) {
        struct page **place = page_place(memory, address);
        if (!place || *place)
            return error_set(error, "%s",
                             place ? "pages are already mapped at this address"
                                   : MEMORY_NO_PAGE);
        *place = &pages[i];
    }
    return true;
}

/* Copies a shared page. The memory is const because this changes no value that can be
 * read. */
struct page *memory_own(const struct memory *memory, uint64_t address)
{
    struct memory *owner = (struct memory *)memory;
    struct page **place = page_place(owner, address);
    struct page *page = take_spare(owner);
    if (!page)
        page = malloc(sizeof *page);
    if (!page)
        return NULL;
    *page = **place;
    page->shared = false;
    page->writable = true;
    forget_near(owner);
    return *place = add_own(owner, page);
}

uint64_t memory_next_page(const struct memory *memory, uint64_t address)
{
    uint64_t directory_bits = UINT64_C(1) << DIRECTORY_SHIFT;
    while (address <= ADDRESS_MASK && !memory_peek(memory, address))
        if (memory->directory[address >> DIRECTORY_SHIFT])
            address += PAGE_BITS;
        else
            address = (address | (directory_bits - 1)) + 1;
    return address;
}

static c205_trap check_page(const struct memory *memory, uint64_t address, bool write)
{
    const struct page *page = write ? memory_own_page(memory, address)
                                    : memory_page(memory, address);
    if (!page)
        return C205_TRAP_UNMAPPED_ADDRESS;
    return write && !page->writable ? C205_TRAP_PROTECTED_ADDRESS : C205_TRAP_NONE;
}

c205_trap memory_check(const struct memory *memory, uint64_t address, uint64_t bits,
                       bool write, uint64_t *fault)
{
    uint64_t page_mask = PAGE_BITS - 1;
    uint64_t end = address + bits;
    while (address < end) {
        c205_trap trap = address > ADDRESS_MASK ? C205_TRAP_UNMAPPED_ADDRESS
                                                : check_page(memory, address, write);
        if (trap != C205_TRAP_NONE) {
            *fault = address & ADDRESS_MASK;
            return trap;
        }
        address = (address | page_mask) + 1;
    }
    return C205_TRAP_NONE;
}

/* ---- Decoded code ------------------------------------------------------- */

void memory_mark_code(struct memory *memory, uint64_t address)
{
    struct page *page = memory_own_page(memory, address);
    size_t index = memory_word_index(address);
    page->code[index / 64] |= UINT64_C(1) << index % 64;
    if (!page->holds_code)
        forget_near(memory);
    page->holds_code = true;
}

/* Clears the marks of words that hold decoded code. A word that still holds code is
 * decoded and marked again when it is executed. */
void memory_change_code(struct memory *memory, struct page *page, size_t first,
                        size_t count)
{
    bool changed = false;
    for (size_t i = first, n; i < first + count; i += n) {
        uint64_t mask = UINT64_MAX << i % 64;
        n = 64 - i % 64;
        if (n > first + count - i) {
            mask &= UINT64_MAX >> (n - (first + count - i));
            n = first + count - i;
        }
        changed = changed || page->code[i / 64] & mask;
        page->code[i / 64] &= ~mask;
    }
    memory->code_changes += changed;
    memory->rewritten = memory->rewritten || changed;
}

/* ---- Words -------------------------------------------------------------- */

static void limit_to_page(size_t index, size_t *count)
{
    if (*count > C205_PAGE_WORDS - index)
        *count = C205_PAGE_WORDS - index;
}

const c205_word *memory_read_span(const struct memory *memory, uint64_t address,
                                  size_t *count)
{
    const struct page *page = memory_page(memory, address);
    size_t index = memory_word_index(address);
    limit_to_page(index, count);
    return page ? page->word + index : NULL;
}

c205_word *memory_write_span(struct memory *memory, uint64_t address, size_t *count)
{
    struct page *page = memory_own_page(memory, address);
    size_t index = memory_word_index(address);
    limit_to_page(index, count);
    if (!page)
        return NULL;
    if (page->holds_code)
        memory_change_code(memory, page, index, *count);
    return page->word + index;
}

void memory_read_words(const struct memory *memory, uint64_t address, c205_word *words,
                       size_t count)
{
    for (size_t n; count > 0; count -= n, words += n) {
        n = count;
        const c205_word *span = memory_read_span(memory, address, &n);
        memcpy(words, span, n * sizeof *words);
        address += n * WORD_BITS;
    }
}

void memory_write_words(struct memory *memory, uint64_t address, const c205_word *words,
                        size_t count)
{
    for (size_t n; count > 0; count -= n, words += n) {
        n = count;
        c205_word *span = memory_write_span(memory, address, &n);
        memcpy(span, words, n * sizeof *words);
        address += n * WORD_BITS;
    }
}

/* ---- Half words ---------------------------------------------------------- */

enum { WORD_HALVES = WORD_BITS / HALF_BITS };

/* Returns the half word that is shift bits from the left end of a word. */
static inline c205_word half_of(c205_word word, unsigned shift)
{
    return word << shift & LEFT_HALF;
}

static inline c205_word with_half(c205_word word, unsigned shift, c205_word half)
{
    return (word & ~(LEFT_HALF >> shift)) | half >> shift;
}

static unsigned shift_at(uint64_t address)
{
    return (unsigned)(address % WORD_BITS);
}

c205_trap memory_load_half(const struct memory *memory, uint64_t address,
                           c205_word *half)
{
    c205_word word;
    if (address % HALF_BITS)
        return C205_TRAP_MISALIGNED_OPERAND;
    c205_trap trap = memory_load(memory, address - shift_at(address), &word);
    if (trap == C205_TRAP_NONE)
        *half = half_of(word, shift_at(address));
    return trap;
}

c205_trap memory_store_half(struct memory *memory, uint64_t address, c205_word half)
{
    uint64_t place = address - shift_at(address);
    c205_word word;
    if (address % HALF_BITS)
        return C205_TRAP_MISALIGNED_OPERAND;
    c205_trap trap = memory_load(memory, place, &word);
    if (trap != C205_TRAP_NONE)
        return trap;
    word = with_half(word, shift_at(address), half);
    return memory_store(memory, place, word);
}

/* Returns how many of count half words from an address on are in a span of words. The
 * span begins with the word at the address. */
static size_t halves_in(size_t words, uint64_t address, size_t count)
{
    size_t halves = words * WORD_HALVES - shift_at(address) / HALF_BITS;
    return halves < count ? halves : count;
}

void memory_read_halves(const struct memory *memory, uint64_t address,
                        c205_word *halves, size_t count)
{
    for (size_t n; count > 0; count -= n, halves += n) {
        unsigned shift = shift_at(address);
        size_t words = (count + shift / HALF_BITS + 1) / WORD_HALVES;
        const c205_word *span = memory_read_span(memory, address - shift, &words);
        n = halves_in(words, address, count);
        for (size_t i = 0, at = shift / HALF_BITS; i < n; i++, at++)
            halves[i] = half_of(span[at / WORD_HALVES], at % WORD_HALVES * HALF_BITS);
        address += n * HALF_BITS;
    }
}

void memory_write_halves(struct memory *memory, uint64_t address,
                         const c205_word *halves, size_t count)
{
    for (size_t n; count > 0; count -= n, halves += n) {
        unsigned shift = shift_at(address);
        size_t words = (count + shift / HALF_BITS + 1) / WORD_HALVES;
        c205_word *span = memory_write_span(memory, address - shift, &words);
        n = halves_in(words, address, count);
        for (size_t i = 0, at = shift / HALF_BITS; i < n; i++, at++)
            span[at / WORD_HALVES] = with_half(span[at / WORD_HALVES],
                                               at % WORD_HALVES * HALF_BITS, halves[i]);
        address += n * HALF_BITS;
    }
}

/* ---- Bits --------------------------------------------------------------- */

static c205_word word_at(const struct memory *memory, uint64_t address)
{
    size_t one = 1;
    return *memory_read_span(memory, address - address % WORD_BITS, &one);
}

/* Returns a mask of the leftmost n bits, 1 <= n <= 64. */
static uint64_t leading(size_t n)
{
    return UINT64_MAX << (WORD_BITS - n);
}

void memory_read_bits(const struct memory *memory, uint64_t address, uint64_t *bits,
                      size_t count)
{
    unsigned skip = (unsigned)(address % WORD_BITS);
    if (skip == 0 && count >= WORD_BITS) {
        size_t words = count / WORD_BITS;
        memory_read_words(memory, address, bits, words);
        address += words * WORD_BITS;
        bits += words;
        count %= WORD_BITS;
    }
    for (size_t n; count > 0; count -= n, address += n, bits++) {
        n = count < WORD_BITS ? count : WORD_BITS;
        *bits = word_at(memory, address) << skip;
        if (skip + n > WORD_BITS)
            *bits |= word_at(memory, address + n - 1) >> (WORD_BITS - skip);
        *bits &= leading(n);
    }
}

/* Returns 64 bits from position `place` on of a string of count bits. Bits after the
 * end of the string are zero. */
static uint64_t bits_from(const uint64_t *bits, size_t place, size_t count)
{
    size_t word = place / WORD_BITS, skip = place % WORD_BITS;
    uint64_t result = bits[word] << skip;
    if (skip > 0 && (word + 1) * WORD_BITS < count)
        result |= bits[word + 1] >> (WORD_BITS - skip);
    return result;
}

void memory_write_bits(struct memory *memory, uint64_t address, const uint64_t *bits,
                       size_t count)
{
    size_t begin = 0;
    if (address % WORD_BITS == 0 && count >= WORD_BITS) {
        memory_write_words(memory, address, bits, count / WORD_BITS);
        begin = count - count % WORD_BITS;
        address += begin;
    }
    for (size_t place = begin, n; place < count; place += n, address += n) {
        size_t skip = address % WORD_BITS, one = 1;
        n = WORD_BITS - skip < count - place ? WORD_BITS - skip : count - place;
        c205_word *word = memory_write_span(memory, address - skip, &one);
        uint64_t mask = leading(n) >> skip;
        *word = (*word & ~mask) | (bits_from(bits, place, count) >> skip & mask);
    }
}
