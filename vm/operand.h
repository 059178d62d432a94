/* operand.h - the operands of a vector instruction as streams.
 *
 * Each operand is first described (from its descriptor register, offset and
 * G bits; bad descriptors trap here), then claimed for so many elements (its
 * memory is checked and told to the clock), then read or stored chunk by
 * chunk.  Nothing is stored before everything is claimed.
 *
 * The machine reads element i, computes and stores it before it reads element
 * i+1.  Streams take many elements at once; operand_lead says how many may be
 * read ahead of the first store without a difference.
 */
#ifndef C205_OPERAND_H
#define C205_OPERAND_H

#include "vm/number/lanes.h"
#include "vm/machine.h"

enum { CHUNK = 512, CHUNK_WORDS = CHUNK / 64 };

/* Elements of width bits, one behind the other. */
struct vector {
    uint64_t address;
    size_t length;
    unsigned width; /* WORD_BITS, HALF_BITS or 1 */
};

/* A vector that is read; behind its end, padding.  A word that is broadcast
 * is an empty vector with that word as padding. */
struct source {
    const struct memory *memory;
    struct vector vector;
    const c205_word *handed; /* the chunk, where a linked instruction made
                                it; NULL: read memory */
    c205_word padding;
    uint8_t sign; /* bits C205_G_NEGATE_A, C205_G_MAGNITUDE_A */
    bool broadcast;
    size_t padded; /* words of space that are padding */
    c205_word space[CHUNK];
};

/* The control vector: which elements are permitted. */
struct control {
    const struct memory *memory;
    struct vector vector; /* its length is not looked at */
    bool present;
    uint64_t blocked; /* what a bit is that holds its element back, in
                         every place */
};

/* ---- Describe ----------------------------------------------------------- */

c205_trap describe_a(struct source *source, const struct c205 *machine,
                     const struct decoded *decoded);
c205_trap describe_b(struct source *source, const struct c205 *machine,
                     const struct decoded *decoded);
/* C, and Z with the offset of C where it has one. */
c205_trap describe_result(struct vector *result, struct control *control,
                          const struct c205 *machine, const struct decoded *decoded);
/* A vector of bits in a register, without offset. */
struct vector describe_bits(c205_word descriptor);
/* The same with an offset, where the offset's slot is not 0. */
c205_trap describe_string(struct vector *string, const struct c205 *machine,
                          uint16_t slot, uint16_t offset);
/* Z where C is no vector. */
void describe_control(struct control *control, const struct c205 *machine,
                      const struct decoded *decoded);

/* ---- Claim -------------------------------------------------------------- */

/* The first count elements will be read (or written); where the vector is
 * shorter, all of it. */
c205_trap claim_vector(struct c205 *machine, struct vector *vector, size_t count,
                       bool write);
c205_trap claim_source(struct c205 *machine, struct source *source, size_t count);
c205_trap claim_control(struct c205 *machine, struct control *control, size_t count);

/* How many elements of one, but most at most, may be read before the first
 * of the other is stored. */
size_t operand_lead(const struct vector *read, const struct vector *written,
                    size_t most);
bool operands_overlap(const struct vector *one, const struct vector *other);
/* Does element i of the one lie upon the first so many of the other? */
bool operand_recurs(const struct vector *read, size_t i, const struct vector *written,
                    size_t stored);
/* May all of one be read before the other is stored, whose elements come from
 * the same place or from further on? */
bool operand_is_ahead(const struct vector *read, const struct vector *written);

/* ---- Read and store ----------------------------------------------------- */

/* n <= CHUNK elements from the first on; stays until the next read. */
const c205_word *source_read(struct source *source, size_t first, size_t n);
/* Bit i is 1 where element first + i is permitted. */
void control_read(const struct control *control, size_t first, size_t n,
                  uint64_t *permitted);
/* n elements from the first on; half words are in the left half of a word.
 */
void vector_read(const struct memory *memory, const struct vector *vector, size_t first,
                 c205_word *words, size_t n);
void vector_write(struct memory *memory, const struct vector *vector, size_t first,
                  const c205_word *words, size_t n);
/* Where n elements from the first on stand, to be written; NULL: they are no
 * words, or not in one piece. */
c205_word *vector_span(struct memory *memory, const struct vector *vector, size_t first,
                       size_t n);
/* Store n elements, under a control vector only those permitted. */
void result_store(struct c205 *machine, const struct vector *result,
                  const struct control *control, size_t first, const c205_word *words,
                  size_t n);
void result_store_bits(struct c205 *machine, const struct vector *result,
                       const struct control *control, size_t first,
                       const uint64_t *bits, size_t n);

/* Those elements whose bit is 1, one behind the other; how many.  c has room
 * for n. */
size_t compress_words(c205_word *c, const c205_word *a, const uint64_t *bits, size_t n);
size_t count_ones(const uint64_t *bits, size_t n);
/* The place of the first one, or n. */
size_t first_one(const uint64_t *bits, size_t n);

static inline size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static inline bool bit_at(const uint64_t *bits, size_t i)
{
    return bits[i / 64] >> (63 - i % 64) & 1;
}

static inline uint64_t vector_at(const struct vector *vector, size_t i)
{
    return vector->address + (uint64_t)i * vector->width;
}

#endif
