/* bits.c - strings of bits.  They are read and stored as 64 bits a word, so
 * the loops of lanes.h do for them too.
 */
#include "operand.h"

enum { STRING_BITS = C205_MAX_LENGTH + 1, STRING_WORDS = STRING_BITS / 64 };

/* A string that is too short continues with zeros. */
static void read_string(const struct c205 *machine,
                        const struct vector *string, size_t first, size_t n,
                        uint64_t *bits)
{
    size_t left = first < string->length ? string->length - first : 0;
    size_t in_memory = left < n ? left : n;
    memory_read_bits(&machine->memory, vector_at(string, first), bits,
                     in_memory);
    for (size_t i = (in_memory + 63) / 64; i < (n + 63) / 64; i++)
        bits[i] = 0;
}

static size_t chunk_of(const struct vector *source,
                       const struct vector *result)
{
    if (!operands_overlap(source, result)
        || result->address <= source->address)
        return STRING_BITS;
    return (size_t)(result->address - source->address);
}

static void run_strings(struct c205 *machine, const struct vector *a,
                        const struct vector *b, const struct vector *c,
                        lanes_binary *operation)
{
    uint64_t bits_a[STRING_WORDS], bits_b[STRING_WORDS];
    uint64_t bits_c[STRING_WORDS], flags = 0;
    size_t chunk_a = chunk_of(a, c), chunk_b = chunk_of(b, c);
    size_t chunk = chunk_a < chunk_b ? chunk_a : chunk_b;
    for (size_t first = 0, n; first < c->length; first += n) {
        n = c->length - first < chunk ? c->length - first : chunk;
        read_string(machine, a, first, n, bits_a);
        read_string(machine, b, first, n, bits_b);
        operation(bits_c, bits_a, bits_b, (n + 63) / 64, &flags);
        memory_write_bits(&machine->memory, vector_at(c, first), bits_c, n);
    }
}

static c205_trap strings(struct c205 *machine, const struct decoded *decoded,
                         lanes_binary *operation)
{
    struct vector a, b, c;
    struct control none;
    c205_trap trap = describe_string(&a, machine, decoded->a, decoded->x);
    if (trap == C205_TRAP_NONE)
        trap = describe_string(&b, machine, decoded->b, decoded->y);
    if (trap == C205_TRAP_NONE)
        trap = describe_result(&c, &none, machine, decoded, 1);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &a, c.length, false);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &b, c.length, false);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &c, c.length, true);
    if (trap != C205_TRAP_NONE)
        return trap;
    machine->effect.elements = c.length;
    run_strings(machine, &a, &b, &c, operation);
    return C205_TRAP_NONE;
}

#define STRINGS(name) \
    c205_trap execute_bits_##name(struct c205 *machine, \
                                  const struct decoded *decoded) \
    { \
        return strings(machine, decoded, lanes_##name); \
    }
STRINGS(xor)
STRINGS(and)
STRINGS(or)
STRINGS(nand)
STRINGS(nor)
STRINGS(or_not)
STRINGS(and_not)
STRINGS(equivalence)

/* ---- Count -------------------------------------------------------------- */

static size_t leading_alike(const uint64_t *bits, size_t n)
{
    size_t i = 0;
    while (i < n && bit_at(bits, i) == bit_at(bits, 0))
        i++;
    return i;
}

typedef size_t count(const uint64_t *bits, size_t n);

static c205_trap count_string(struct c205 *machine,
                              const struct decoded *decoded, count *counted)
{
    struct vector string = describe_bits(machine->slot[decoded->a]);
    uint64_t bits[STRING_WORDS];
    c205_trap trap = claim_vector(machine, &string, string.length, false);
    if (trap != C205_TRAP_NONE)
        return trap;
    read_string(machine, &string, 0, string.length, bits);
    machine->effect.elements = string.length;
    machine->slot[decoded->c] = counted(bits, string.length);
    return C205_TRAP_NONE;
}

c205_trap execute_bits_leading(struct c205 *machine,
                               const struct decoded *decoded)
{
    return count_string(machine, decoded, leading_alike);
}

c205_trap execute_bits_count(struct c205 *machine,
                             const struct decoded *decoded)
{
    return count_string(machine, decoded, count_ones);
}
