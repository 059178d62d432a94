/* direct.h - operands of a vector instruction where they are in the host's
 * memory.
 *
 * Most instructions are simple: of words, without offsets and signs, begun
 * and ended in one turn, each operand within a page, but for the
 * table of a gather, and no result upon what is read after it is stored.  direct_NAME below say whether an operand is,
 * and then it has been checked; where one is not, nothing has happened yet,
 * and the instruction goes the way of operand.h, which knows all cases and
 * all traps.  Both do the same, and tell the clock the same.
 *
 * Pointers hold from the checks to the end of the instruction: no page comes,
 * goes or changes its access in between.
 */
#ifndef C205_DIRECT_H
#define C205_DIRECT_H

#include "vm/operand.h"

/* A string of bits: the first stands skip bits from the left of *word. */
struct direct_bits {
    c205_word *word;
    unsigned skip;
};

/* ---- Where they stand ---------------------------------------------------- */

static inline size_t direct_length(c205_word descriptor)
{
    return (size_t)(descriptor >> LENGTH_SHIFT);
}

/* The instruction is in its first turn, and ends in it. */
static inline bool direct_turn(const struct c205 *machine, size_t n)
{
    return n > 0 && n <= machine->allowed && machine->resume.first == 0;
}

/* NULL: not aligned, not mapped, not in one page, or not to be written so. */
static inline c205_word *direct_place(struct memory *memory, uint64_t address, size_t n,
                                      bool write)
{
    size_t index = memory_word_index(address);
    const struct near_page *page = memory_near(memory, address);
    if (!page || address % WORD_BITS || n > C205_PAGE_WORDS - index
        || (write && !page->stores))
        return NULL;
    return page->word + index;
}

/* n words that a descriptor names.  NULL: they are to be read otherwise. */
static inline const c205_word *direct_read(struct c205 *machine, c205_word descriptor,
                                           size_t n)
{
    if (n > direct_length(descriptor))
        return NULL;
    return direct_place(&machine->memory, LOW(descriptor), n, false);
}

/* The same, to be written; its length is not looked at. */
static inline c205_word *direct_write(struct c205 *machine, c205_word descriptor,
                                      size_t n)
{
    return direct_place(&machine->memory, LOW(descriptor), n, true);
}

/* n bits; the descriptor's length is not looked at. */
static inline struct direct_bits direct_bits(struct c205 *machine, c205_word descriptor,
                                             size_t n, bool write)
{
    unsigned skip = (unsigned)(descriptor % WORD_BITS);
    struct direct_bits bits = { NULL, skip };
    bits.word = direct_place(&machine->memory, LOW(descriptor) - skip,
                             (skip + n + WORD_BITS - 1) / WORD_BITS, write);
    return bits;
}

/* ---- Do they overlap? ---------------------------------------------------- */

/* Spans of so many bytes have some in common. */
static inline bool direct_meets(const void *one, size_t bytes, const void *other,
                                size_t other_bytes)
{
    uintptr_t a = (uintptr_t)one, b = (uintptr_t)other;
    return a < b + other_bytes && b < a + bytes;
}

/* Of n words each: the result begins above the source and upon it, so that
 * some elements wait for earlier ones. */
static inline bool direct_recurs(const c205_word *result, const c205_word *source,
                                 size_t n)
{
    uintptr_t above = (uintptr_t)result - (uintptr_t)source;
    return above - 1 < n * sizeof *result - 1;
}

/* The bytes that hold n bits of a string. */
static inline size_t direct_bytes(struct direct_bits bits, size_t n)
{
    return (bits.skip + n + WORD_BITS - 1) / WORD_BITS * sizeof(c205_word);
}

/* ---- Bits ---------------------------------------------------------------- */

/* The leftmost n bits of a word, 1 to 64 of them. */
static inline uint64_t leading_bits(size_t n)
{
    return UINT64_MAX << (WORD_BITS - n);
}

/* n bits from the first on, which is a multiple of 64; unused ones are
 * zero. */
static inline void direct_read_bits(struct direct_bits string, size_t first,
                                    uint64_t *bits, size_t n)
{
    const c205_word *word = string.word + first / WORD_BITS;
    unsigned skip = string.skip;
    for (size_t i = 0; i < n; i += WORD_BITS, word++) {
        size_t some = least(n - i, WORD_BITS);
        uint64_t next = *word << skip;
        if (skip + some > WORD_BITS)
            next |= word[1] >> (WORD_BITS - skip);
        *bits++ = next & leading_bits(some);
    }
}

/* .. of a control vector, as control_read tells them. */
static inline void direct_read_control(struct direct_bits control, uint64_t blocked,
                                       size_t first, uint64_t *permitted, size_t n)
{
    direct_read_bits(control, first, permitted, n);
    for (size_t i = 0; i < (n + WORD_BITS - 1) / WORD_BITS; i++)
        permitted[i] ^= blocked;
    if (n % WORD_BITS)
        permitted[n / WORD_BITS] &= leading_bits(n % WORD_BITS);
}

static inline void direct_merge(c205_word *word, uint64_t bits, uint64_t mask)
{
    *word ^= (*word ^ bits) & mask;
}

/* The same the other way, under a mask of their own (NULL: all). */
static inline void direct_write_bits(struct direct_bits string, size_t first,
                                     const uint64_t *bits, const uint64_t *permitted,
                                     size_t n)
{
    c205_word *word = string.word + first / WORD_BITS;
    unsigned skip = string.skip;
    for (size_t i = 0; i < n; i += WORD_BITS, word++, bits++) {
        size_t some = least(n - i, WORD_BITS);
        uint64_t mask = leading_bits(some)
                        & (permitted ? permitted[i / WORD_BITS] : UINT64_MAX);
        direct_merge(word, *bits >> skip, mask >> skip);
        if (skip + some > WORD_BITS)
            direct_merge(word + 1, *bits << (WORD_BITS - skip),
                         mask << (WORD_BITS - skip));
    }
}

/* ---- The instructions ---------------------------------------------------- */

struct operation;

/* False: it is not simple, and nothing has happened. */
bool direct_elementwise(struct c205 *machine, const struct decoded *decoded,
                        const struct operation *operation);
/* The two instructions of a pair that may be linked; the result of the first is
 * A or B of the second, or both. */
bool direct_pair(struct c205 *machine, const struct decoded *const *linked, bool hand_a,
                 bool hand_b);

#endif
