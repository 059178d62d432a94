/* operand.c - describes, claims, reads and stores the operands of vector instructions.
 */
#include "vm/operand.h"

#include <string.h>

/* ---- Describe ----------------------------------------------------------- */

uint64_t c205_descriptor_address(c205_word descriptor)
{
    return descriptor & ADDRESS_MASK;
}

size_t c205_descriptor_length(c205_word descriptor)
{
    return (size_t)(descriptor >> LENGTH_SHIFT);
}

static struct vector describe(c205_word descriptor, unsigned width)
{
    struct vector vector;
    vector.address = c205_descriptor_address(descriptor);
    vector.length = c205_descriptor_length(descriptor);
    vector.width = width;
    return vector;
}

/* Adds an offset to a vector: its address increases and its length decreases
 * (reconstructed). */
static c205_trap advance(struct vector *vector, c205_word offset)
{
    int64_t elements = c205_to_integer(offset);
    if (elements < 0)
        return C205_TRAP_BAD_DESCRIPTOR;
    vector->address += (uint64_t)elements * vector->width;
    vector->address &= ADDRESS_MASK;
    vector->length -= (uint64_t)elements < vector->length ? (size_t)elements
                                                          : vector->length;
    return C205_TRAP_NONE;
}

struct vector describe_bits(c205_word descriptor)
{
    return describe(descriptor, 1);
}

c205_trap describe_string(struct vector *string, const struct c205 *machine,
                          uint16_t slot, uint16_t offset)
{
    *string = describe_bits(machine->slot[slot]);
    return offset ? advance(string, machine->slot[offset]) : C205_TRAP_NONE;
}

/* Returns the value that pads a short source. */
static c205_word padding_of(const c205_insn *insn, unsigned width)
{
    if (insn->flags & C205_INSN_PADO)
        return width == HALF_BITS ? C205_HALF_ONE : C205_ONE;
    return insn->flags & C205_INSN_PADZ ? C205_MACHINE_ZERO : 0;
}

/* Applies the sign control to the words of a source: takes the magnitudes, then
 * negates. The signs change on the path to the pipe and not by an operation, so no data
 * flags are set. */
static void control_sign(const struct source *source, c205_word *words, size_t n)
{
    bool half = source->vector.width == HALF_BITS;
    c205_word signless[CHUNK];
    uint64_t flags = 0;
    if (source->sign & C205_G_MAGNITUDE_A) {
        memcpy(signless, words, n * sizeof *words);
        (half ? halves_absolute : lanes_absolute)(words, signless, n, &flags);
    }
    if (source->sign & C205_G_NEGATE_A) {
        memcpy(signless, words, n * sizeof *words);
        (half ? halves_negate : lanes_negate)(words, signless, n, &flags);
    }
}

static c205_trap describe_source(struct source *source, const struct c205 *machine,
                                 const struct decoded *decoded, unsigned operand,
                                 uint16_t slot, uint16_t offset)
{
    unsigned width = decoded->width[operand];
    source->memory = &machine->memory;
    source->handed = NULL;
    source->padded = 0;
    if (!(decoded->insn->flags & C205_INSN_SIGN))
        source->sign = 0;
    if (source->broadcast) {
        source->vector = describe(0, width);
        source->padding = width == HALF_BITS
                              ? machine_half(machine, slot, decoded->shift[operand])
                              : machine->slot[slot];
        control_sign(source, &source->padding, 1);
        return C205_TRAP_NONE;
    }
    source->vector = describe(machine->slot[slot], width);
    source->padding = padding_of(decoded->insn, width);
    return offset ? advance(&source->vector, machine->slot[offset]) : C205_TRAP_NONE;
}

c205_trap describe_a(struct source *source, const struct c205 *machine,
                     const struct decoded *decoded)
{
    uint8_t g = decoded->fields.g;
    source->broadcast = g & C205_G_BROADCAST_A
                        || decoded->insn->format == C205_FORMAT_SCALARS;
    source->sign = g & (C205_G_NEGATE_A | C205_G_MAGNITUDE_A);
    return describe_source(source, machine, decoded, OPERAND_A, decoded->a, decoded->x);
}

c205_trap describe_b(struct source *source, const struct c205 *machine,
                     const struct decoded *decoded)
{
    uint8_t g = decoded->fields.g;
    source->broadcast = g & C205_G_BROADCAST_B
                        || decoded->insn->format == C205_FORMAT_SCALARS;
    source->sign = g & C205_G_MAGNITUDE_B ? C205_G_MAGNITUDE_A : 0;
    return describe_source(source, machine, decoded, OPERAND_B, decoded->b, decoded->y);
}

void describe_control(struct control *control, const struct c205 *machine,
                      const struct decoded *decoded)
{
    control->memory = &machine->memory;
    control->present = decoded->z != 0;
    control->vector = describe_bits(machine->slot[decoded->z]);
    control->blocked = decoded->fields.g & C205_G_ZEROS ? UINT64_MAX : 0;
}

c205_trap describe_result(struct vector *result, struct control *control,
                          const struct c205 *machine, const struct decoded *decoded)
{
    describe_control(control, machine, decoded);
    *result = describe(machine->slot[decoded->fields.c], decoded->width[OPERAND_C]);
    if (!(decoded->fields.g & C205_G_OFFSET))
        return C205_TRAP_NONE;
    c205_word offset = machine->slot[decoded->fields.c + 1];
    c205_trap trap = advance(result, offset);
    return trap == C205_TRAP_NONE ? advance(&control->vector, offset) : trap;
}

/* ---- Claim -------------------------------------------------------------- */

c205_trap claim_vector(struct c205 *machine, struct vector *vector, size_t count,
                       bool write)
{
    if (vector->length > count)
        vector->length = count;
    if (vector->length == 0)
        return C205_TRAP_NONE;
    uint64_t bits = (uint64_t)vector->length * vector->width;
    if (vector->address % vector->width)
        return machine_fault(machine, C205_TRAP_MISALIGNED_OPERAND, vector->address);
    machine_touch_as(machine, vector->address, bits, write);
    return memory_check(&machine->memory, vector->address, bits, write,
                        &machine->fault);
}

c205_trap claim_source(struct c205 *machine, struct source *source, size_t count)
{
    return claim_vector(machine, &source->vector, count, false);
}

c205_trap claim_control(struct c205 *machine, struct control *control, size_t count)
{
    control->vector.length = control->present ? count : 0;
    return claim_vector(machine, &control->vector, count, false);
}

bool operands_overlap(const struct vector *one, const struct vector *other)
{
    return one->length > 0 && other->length > 0
           && one->address < vector_at(other, other->length)
           && other->address < vector_at(one, one->length);
}

/* Returns the number of elements that may be read before the first store. If the result
 * begins k elements above the source, the first store changes none of the first k
 * elements. If it begins at the source or below, it overwrites only elements that have
 * been read. */
size_t operand_lead(const struct vector *read, const struct vector *written,
                    size_t most)
{
    if (!operands_overlap(read, written))
        return most;
    if (read->width != written->width)
        return 1;
    if (written->address <= read->address)
        return most;
    uint64_t lead = (written->address - read->address) / read->width;
    return lead < most ? (size_t)lead : most;
}

bool operand_recurs(const struct vector *read, size_t i, const struct vector *written,
                    size_t stored)
{
    return i < read->length && stored > 0
           && vector_at(read, i) < vector_at(written, stored)
           && vector_at(written, 0) < vector_at(read, i + 1);
}

/* No result of element i is stored at an index above i. A result vector that does not
 * begin above the source therefore overwrites only elements that have been read. */
bool operand_is_ahead(const struct vector *read, const struct vector *written)
{
    return !operands_overlap(read, written)
           || (read->width == written->width && written->address <= read->address);
}

/* ---- Elements in memory ------------------------------------------------- */

void vector_read(const struct memory *memory, const struct vector *vector, size_t first,
                 c205_word *words, size_t n)
{
    uint64_t address = vector_at(vector, first);
    if (vector->width == HALF_BITS)
        memory_read_halves(memory, address, words, n);
    else
        memory_read_words(memory, address, words, n);
}

void vector_write(struct memory *memory, const struct vector *vector, size_t first,
                  const c205_word *words, size_t n)
{
    uint64_t address = vector_at(vector, first);
    if (vector->width == HALF_BITS)
        memory_write_halves(memory, address, words, n);
    else
        memory_write_words(memory, address, words, n);
}

c205_word *vector_span(struct memory *memory, const struct vector *vector, size_t first,
                       size_t n)
{
    size_t count = n;
    if (vector->width != WORD_BITS)
        return NULL;
    c205_word *span = memory_write_span(memory, vector_at(vector, first), &count);
    return count == n ? span : NULL;
}

/* ---- Read --------------------------------------------------------------- */

static const c205_word *padding_words(struct source *source, size_t n)
{
    if (source->padded < n) {
        lanes_fill(source->space, source->padding, n);
        source->padded = n;
    }
    return source->space;
}

static const c205_word *filled_space(struct source *source, size_t first, size_t n)
{
    size_t in_memory = min_size(source->vector.length - first, n);
    vector_read(source->memory, &source->vector, first, source->space, in_memory);
    control_sign(source, source->space, in_memory);
    source->padded = 0;
    for (size_t i = in_memory; i < n; i++)
        source->space[i] = source->padding;
    return source->space;
}

static const c205_word *handed_words(struct source *source, size_t n)
{
    if (!source->sign)
        return source->handed;
    memcpy(source->space, source->handed, n * sizeof *source->space);
    control_sign(source, source->space, n);
    return source->space;
}

const c205_word *source_read(struct source *source, size_t first, size_t n)
{
    size_t count = n;
    const c205_word *span;
    if (source->handed)
        return handed_words(source, n);
    if (first >= source->vector.length)
        return padding_words(source, n);
    if (source->sign || source->vector.width != WORD_BITS
        || n > source->vector.length - first)
        return filled_space(source, first, n);
    span = memory_read_span(source->memory, vector_at(&source->vector, first), &count);
    return count == n ? span : filled_space(source, first, n);
}

void control_read(const struct control *control, size_t first, size_t n,
                  uint64_t *permitted)
{
    size_t words = (n + 63) / 64;
    if (control->present)
        memory_read_bits(control->memory, vector_at(&control->vector, first), permitted,
                         n);
    for (size_t i = 0; i < words; i++)
        permitted[i] = control->present ? permitted[i] ^ control->blocked : UINT64_MAX;
    if (n % 64)
        permitted[words - 1] &= UINT64_MAX << (64 - n % 64);
}

/* ---- Store -------------------------------------------------------------- */

static void store_merged(struct memory *memory, const struct vector *result,
                         size_t first, const c205_word *words,
                         const uint64_t *permitted, size_t n)
{
    c205_word merged[CHUNK];
    vector_read(memory, result, first, merged, n);
    lanes_store_masked(merged, words, permitted, n);
    vector_write(memory, result, first, merged, n);
}

void result_store(struct c205 *machine, const struct vector *result,
                  const struct control *control, size_t first, const c205_word *words,
                  size_t n)
{
    uint64_t permitted[CHUNK_WORDS];
    if (!control->present) {
        vector_write(&machine->memory, result, first, words, n);
        return;
    }
    control_read(control, first, n, permitted);
    c205_word *span = vector_span(&machine->memory, result, first, n);
    if (span)
        lanes_store_masked(span, words, permitted, n);
    else
        store_merged(&machine->memory, result, first, words, permitted, n);
}

void result_store_bits(struct c205 *machine, const struct vector *result,
                       const struct control *control, size_t first,
                       const uint64_t *bits, size_t n)
{
    uint64_t address = vector_at(result, first);
    uint64_t merged[CHUNK_WORDS], permitted[CHUNK_WORDS];
    if (control->present) {
        control_read(control, first, n, permitted);
        memory_read_bits(&machine->memory, address, merged, n);
        for (size_t i = 0; i < (n + 63) / 64; i++)
            merged[i] ^= (merged[i] ^ bits[i]) & permitted[i];
        bits = merged;
    }
    memory_write_bits(&machine->memory, address, bits, n);
}

/* ---- Elements and their bits -------------------------------------------- */

/* Compresses words. All ones and all zeros in the mask are frequent and have their own
 * code. */
size_t compress_words(c205_word *c, const c205_word *a, const uint64_t *bits, size_t n)
{
    size_t count = 0;
    for (size_t i = 0; i < n; i += 64) {
        uint64_t rest = bits[i / 64];
        size_t end = rest == 0 || rest == UINT64_MAX ? i : min_size(n, i + 64);
        if (rest == UINT64_MAX) {
            memcpy(c + count, a + i, 64 * sizeof *c);
            count += 64;
        }
        for (size_t j = i; j < end; j++, rest <<= 1) {
            c[count] = a[j];
            count += rest >> 63;
        }
    }
    return count;
}

/* Counts the ones in pairs, in groups of four and in bytes. The product has the sum of
 * the bytes in its first byte. */
static size_t ones_in(uint64_t word)
{
    uint64_t pairs = UINT64_MAX / 3, fours = UINT64_MAX / 5;
    uint64_t bytes = UINT64_MAX / 17, each = UINT64_MAX / 255;
    word -= word >> 1 & pairs;
    word = (word & fours) + (word >> 2 & fours);
    word = (word + (word >> 4)) & bytes;
    return word * each >> 56;
}

size_t count_ones(const uint64_t *bits, size_t n)
{
    size_t count = 0;
    for (size_t i = 0; i < (n + 63) / 64; i++)
        count += ones_in(bits[i]);
    return count;
}

size_t first_one(const uint64_t *bits, size_t n)
{
    size_t i = 0;
    while (i < n && !bit_at(bits, i))
        i += bits[i / 64] ? 1 : 64;
    return i < n ? i : n;
}
