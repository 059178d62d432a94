/* direct.h - converts the operands of a vector instruction to pointers into the memory
 * of the host, if the instruction is simple.
 *
 * Most instructions are simple. They work on words without offsets and sign control,
 * and complete in one turn. Each operand is within one page, except the table of a
 * gather. No store changes an operand that is read later. The direct_NAME functions
 * below check these conditions and change nothing. If a condition does not hold, the
 * instruction uses operand.h, which handles all cases and all traps. Both methods have
 * the same results and report the same effect to the clock.
 *
 * The pointers are valid until the end of the instruction, because no page is mapped,
 * unmapped or changes its access in between.
 */
#ifndef C205_DIRECT_H
#define C205_DIRECT_H

#include "vm/operand.h"

/* A string of bits. Its first bit is `skip` bits from the left of *word. */
struct direct_bits {
    c205_word *word;
    unsigned skip;
};

/* ---- Addresses in the host ---------------------------------------------- */

static inline size_t direct_length(c205_word descriptor)
{
    return (size_t)(descriptor >> LENGTH_SHIFT);
}

/* Returns true if an instruction of n elements runs from its first to its last element
 * without an interruption by the clock limit. */
static inline bool direct_turn(const struct c205 *machine, size_t n)
{
    return n > 0 && n <= machine->allowed && machine->resume.first == 0;
}

/* Returns the address in the host of n words at a bit address. Returns NULL if the
 * words are not aligned, not mapped, not within one page, or read-only although `write`
 * is set. */
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

/* Returns the n words of a descriptor. NULL: the caller must use operand.h. */
static inline const c205_word *direct_read(struct c205 *machine, c205_word descriptor,
                                           size_t n)
{
    if (n > direct_length(descriptor))
        return NULL;
    return direct_place(&machine->memory, LOW(descriptor), n, false);
}

/* Returns n words at the address of a descriptor for writing; its length is not used.
 * NULL: the caller must use operand.h. */
static inline c205_word *direct_write(struct c205 *machine, c205_word descriptor,
                                      size_t n)
{
    return direct_place(&machine->memory, LOW(descriptor), n, true);
}

/* Returns the n bits at the address of a descriptor; its length is not used. */
static inline struct direct_bits direct_bits(struct c205 *machine, c205_word descriptor,
                                             size_t n, bool write)
{
    unsigned skip = (unsigned)(descriptor % WORD_BITS);
    struct direct_bits bits = { NULL, skip };
    bits.word = direct_place(&machine->memory, LOW(descriptor) - skip,
                             (skip + n + WORD_BITS - 1) / WORD_BITS, write);
    return bits;
}

/* ---- Overlaps ----------------------------------------------------------- */

/* Returns true if two spans of bytes overlap. */
static inline bool direct_meets(const void *one, size_t bytes, const void *other,
                                size_t other_bytes)
{
    uintptr_t a = (uintptr_t)one, b = (uintptr_t)other;
    return a < b + other_bytes && b < a + bytes;
}

/* Returns true if a result of n words begins above its source and overlaps it, so some
 * elements depend on earlier results. */
static inline bool direct_recurs(const c205_word *result, const c205_word *source,
                                 size_t n)
{
    uintptr_t above = (uintptr_t)result - (uintptr_t)source;
    return above - 1 < n * sizeof *result - 1;
}

/* Returns the number of bytes that contain n bits of a string. */
static inline size_t direct_bytes(struct direct_bits bits, size_t n)
{
    return (bits.skip + n + WORD_BITS - 1) / WORD_BITS * sizeof(c205_word);
}

/* ---- Bits ---------------------------------------------------------------- */

/* Returns a mask of the leftmost n bits, 1 <= n <= 64. */
static inline uint64_t leading_bits(size_t n)
{
    return UINT64_MAX << (WORD_BITS - n);
}

/* Reads n bits from position first, which must be a multiple of 64. Unused bits of the
 * last word are zero. */
static inline void direct_read_bits(struct direct_bits string, size_t first,
                                    uint64_t *bits, size_t n)
{
    const c205_word *word = string.word + first / WORD_BITS;
    unsigned skip = string.skip;
    for (size_t i = 0; i < n; i += WORD_BITS, word++) {
        size_t some = min_size(n - i, WORD_BITS);
        uint64_t next = *word << skip;
        if (skip + some > WORD_BITS)
            next |= word[1] >> (WORD_BITS - skip);
        *bits++ = next & leading_bits(some);
    }
}

/* Reads which of n elements a control vector permits. blocked: all ones if a one bit
 * blocks its element, otherwise 0. */
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

/* Writes those of n bits from position first that are permitted (NULL: all). */
static inline void direct_write_bits(struct direct_bits string, size_t first,
                                     const uint64_t *bits, const uint64_t *permitted,
                                     size_t n)
{
    c205_word *word = string.word + first / WORD_BITS;
    unsigned skip = string.skip;
    for (size_t i = 0; i < n; i += WORD_BITS, word++, bits++) {
        size_t some = min_size(n - i, WORD_BITS);
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

/* Executes the instruction in the host's memory. Returns false, without effect, if
 * operand.h must execute it. */
bool direct_elementwise(struct c205 *machine, const struct decoded *decoded,
                        const struct operation *operation);
/* Executes a linked pair in the host's memory. The result of the first instruction
 * replaces A (hand_a), B (hand_b) or both of the second. Returns false, without effect,
 * if operand.h must execute one of the two instructions. */
bool direct_pair(struct c205 *machine, const struct decoded *const *linked, bool hand_a,
                 bool hand_b);

#endif
