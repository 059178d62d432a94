/* operand.h - the operands of a vector instruction as streams.
 *
 * An operand is used in three steps. To describe it means to evaluate its descriptor
 * register, offset and G bits; a bad descriptor traps. To claim it for a number of
 * elements means to check its memory and to report this memory to the clock. Finally it
 * is read or stored chunk by chunk. Nothing is stored before all operands are claimed.
 * Functions that describe or claim return NONE or the trap.
 *
 * The machine reads element i, computes it and stores it before it reads element i + 1.
 * Streams process many elements at once. operand_lead returns the number of elements
 * that may be read before the first store without changing the result.
 */
#ifndef C205_OPERAND_H
#define C205_OPERAND_H

#include "vm/min_max.h"
#include "vm/number/lanes.h"
#include "vm/machine.h"

enum { CHUNK = 512, CHUNK_WORDS = CHUNK / 64 };

/* A vector of elements with the same width. */
struct vector {
    uint64_t address;
    size_t length;
    unsigned width; /* WORD_BITS, HALF_BITS or 1 */
};

/* A vector that is read, followed by padding. A broadcast word is an empty vector with
 * that word as padding. */
struct source {
    const struct memory *memory;
    struct vector vector;
    const c205_word *handed; /* the chunk from the first of a linked pair; NULL: memory
                                is read */
    c205_word padding;
    uint8_t sign; /* C205_G_NEGATE_A, C205_G_MAGNITUDE_A */
    bool broadcast;
    size_t padded; /* number of words of space that contain padding */
    c205_word space[CHUNK];
};

/* The control vector, which selects the permitted elements. */
struct control {
    const struct memory *memory;
    struct vector vector; /* the length is not used */
    bool present;
    uint64_t blocked; /* all ones if a one bit blocks its element, 0 otherwise */
};

/* ---- Describe ----------------------------------------------------------- */

c205_trap describe_a(struct source *source, const struct c205 *machine,
                     const struct decoded *decoded);
c205_trap describe_b(struct source *source, const struct c205 *machine,
                     const struct decoded *decoded);
/* Evaluates the descriptors of the result C and of the control vector Z. An offset of C
 * applies to both. */
c205_trap describe_result(struct vector *result, struct control *control,
                          const struct c205 *machine, const struct decoded *decoded);
/* Returns the bit vector that a descriptor specifies. No offset applies. */
struct vector describe_bits(c205_word descriptor);
/* Evaluates the descriptor of a bit vector, in register `slot`, and its offset, in
 * register `offset` (0: no offset). */
c205_trap describe_string(struct vector *string, const struct c205 *machine,
                          uint16_t slot, uint16_t offset);
/* Evaluates the descriptor of the control vector Z of an instruction whose C is not a
 * vector. */
void describe_control(struct control *control, const struct c205 *machine,
                      const struct decoded *decoded);

/* ---- Claim -------------------------------------------------------------- */

/* Claims the first count elements for reading or writing, or the whole vector if it is
 * shorter. Returns a trap if an element is not accessible. */
c205_trap claim_vector(struct c205 *machine, struct vector *vector, size_t count,
                       bool write);
c205_trap claim_source(struct c205 *machine, struct source *source, size_t count);
c205_trap claim_control(struct c205 *machine, struct control *control, size_t count);

/* Returns how many elements of read, at most `most`, may be read before the first
 * element of written is stored. */
size_t operand_lead(const struct vector *read, const struct vector *written,
                    size_t most);
bool operands_overlap(const struct vector *one, const struct vector *other);
/* Returns true if element i of read overlaps one of the first `stored` elements of
 * written. */
bool operand_recurs(const struct vector *read, size_t i, const struct vector *written,
                    size_t stored);
/* Returns true if a whole chunk of an operand may be read before any result of the
 * chunk is stored. Valid for instructions that never store the result of element i at
 * an index above i. */
bool operand_is_ahead(const struct vector *read, const struct vector *written);

/* ---- Read and store ----------------------------------------------------- */

/* Returns n elements from position first, n <= CHUNK. They are valid until the next
 * read. */
const c205_word *source_read(struct source *source, size_t first, size_t n);
/* Sets bit i of permitted to 1 if element first + i is permitted. */
void control_read(const struct control *control, size_t first, size_t n,
                  uint64_t *permitted);
/* Copy n elements from position first. Half words are in the left half of a word. */
void vector_read(const struct memory *memory, const struct vector *vector, size_t first,
                 c205_word *words, size_t n);
void vector_write(struct memory *memory, const struct vector *vector, size_t first,
                  const c205_word *words, size_t n);
/* Returns the address in the host of n elements from position first, for writing.
 * Returns NULL if they are not words or not contiguous. */
c205_word *vector_span(struct memory *memory, const struct vector *vector, size_t first,
                       size_t n);
/* Store n elements, or only the elements that a control vector permits. */
void result_store(struct c205 *machine, const struct vector *result,
                  const struct control *control, size_t first, const c205_word *words,
                  size_t n);
void result_store_bits(struct c205 *machine, const struct vector *result,
                       const struct control *control, size_t first,
                       const uint64_t *bits, size_t n);

/* Packs the elements whose bit is 1 into c, which has room for n. Returns their
 * number. */
size_t compress_words(c205_word *c, const c205_word *a, const uint64_t *bits, size_t n);
size_t count_ones(const uint64_t *bits, size_t n);
/* Returns the index of the first of n bits that is 1, or n if all are 0. */
size_t first_one(const uint64_t *bits, size_t n);

static inline bool bit_at(const uint64_t *bits, size_t i)
{
    return bits[i / 64] >> (63 - i % 64) & 1;
}

static inline uint64_t vector_at(const struct vector *vector, size_t i)
{
    return vector->address + (uint64_t)i * vector->width;
}

#endif
