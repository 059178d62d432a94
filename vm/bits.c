/* bits.c - executes instructions on bit strings. Strings are read and stored as 64 bits
 * per word, so the bitwise loops of lanes.h apply.
 */
#include "vm/direct.h"
#include "vm/vector.h"

enum { STRING_BITS = C205_MAX_LENGTH + 1, STRING_WORDS = STRING_BITS / 64 };

/* Reads n bits of a string from position `first` on. Missing bits at the end of a short
 * string are zero. */
static void read_string(const struct c205 *machine, const struct vector *string,
                        size_t first, size_t n, uint64_t *bits)
{
    size_t left = first < string->length ? string->length - first : 0;
    size_t in_memory = left < n ? left : n;
    memory_read_bits(&machine->memory, vector_at(string, first), bits, in_memory);
    for (size_t i = (in_memory + 63) / 64; i < (n + 63) / 64; i++)
        bits[i] = 0;
}

static c205_trap run_strings(struct c205 *machine, const struct vector *a,
                             const struct vector *b, const struct vector *c,
                             lanes_binary *operation)
{
    struct turn turn = machine_turn(machine, c->length, machine->allowed);
    uint64_t bits_a[STRING_WORDS], bits_b[STRING_WORDS];
    uint64_t bits_c[STRING_WORDS], flags = 0;
    size_t chunk = operand_lead(a, c, STRING_BITS);
    chunk = operand_lead(b, c, chunk);
    for (size_t first = turn.first, n; first < turn.end; first += n) {
        n = min_size(turn.end - first, chunk);
        read_string(machine, a, first, n, bits_a);
        read_string(machine, b, first, n, bits_b);
        operation(bits_c, bits_a, bits_b, (n + 63) / 64, &flags);
        memory_write_bits(&machine->memory, vector_at(c, first), bits_c, n);
    }
    return machine_end_turn(machine, &turn);
}

/* Executes a logical instruction on strings in the host's memory. Returns false,
 * without effect, if the operands are not simple (direct.h). The result may overlap a
 * source only if it is the same string. */
static bool strings_directly(struct c205 *machine, const struct decoded *decoded)
{
    c205_word a = machine->slot[decoded->a], b = machine->slot[decoded->b];
    c205_word c = machine->slot[decoded->fields.c];
    size_t n = direct_length(c);
    uint64_t bits_a[CHUNK_WORDS], bits_b[CHUNK_WORDS], bits[CHUNK_WORDS];
    uint64_t flags = 0;
    lanes_binary *operation = operation_of(decoded)->binary;
    if (!decoded->plain || !direct_turn(machine, n) || direct_length(a) < n
        || direct_length(b) < n)
        return false;
    struct direct_bits from = direct_bits(machine, a, n, false);
    struct direct_bits other = direct_bits(machine, b, n, false);
    struct direct_bits to = direct_bits(machine, c, n, true);
    size_t bytes = direct_bytes(to, n);
    if (!from.word || !other.word || !to.word
        || (LOW(a) != LOW(c)
            && direct_meets(to.word, bytes, from.word, direct_bytes(from, n)))
        || (LOW(b) != LOW(c)
            && direct_meets(to.word, bytes, other.word, direct_bytes(other, n))))
        return false;
    for (size_t first = 0, some; first < n; first += some) {
        some = min_size(n - first, CHUNK);
        direct_read_bits(from, first, bits_a, some);
        direct_read_bits(other, first, bits_b, some);
        operation(bits, bits_a, bits_b, (some + 63) / 64, &flags);
        direct_write_bits(to, first, bits, NULL, some);
    }
    machine_touch(machine, LOW(a), n);
    machine_touch(machine, LOW(b), n);
    machine_touch_result(machine, LOW(c), n);
    machine->effect.elements = n;
    return true;
}

c205_trap execute_strings(struct c205 *machine, const struct decoded *decoded)
{
    struct vector a, b, c;
    struct control none;
    if (strings_directly(machine, decoded))
        return C205_TRAP_NONE;
    c205_trap trap = describe_string(&a, machine, decoded->a, decoded->x);
    if (trap == C205_TRAP_NONE)
        trap = describe_string(&b, machine, decoded->b, decoded->y);
    if (trap == C205_TRAP_NONE)
        trap = describe_result(&c, &none, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &a, c.length, false);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &b, c.length, false);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &c, c.length, true);
    if (trap != C205_TRAP_NONE)
        return trap;
    machine->effect.elements = c.length;
    return run_strings(machine, &a, &b, &c, operation_of(decoded)->binary);
}

/* ---- Mask, merge ------------------------------------------------------- */

static void set_bit(uint64_t *bits, size_t i, bool value)
{
    uint64_t one = UINT64_C(1) << (63 - i % 64);
    bits[i / 64] = value ? bits[i / 64] | one : bits[i / 64] & ~one;
}

/* The operands of a mask or merge of strings. A mask takes the bit at the same index of
 * the selected source. A merge takes the next bit of that source (see move.c for
 * words). */
struct bit_choice {
    struct c205 *machine;
    struct vector a, b, c;
    struct control control;
    size_t next_a, next_b;
};

typedef void chooser(struct bit_choice *choice, size_t first, size_t n,
                     const uint64_t *from_a, uint64_t *bits);

static void mask_bits(struct bit_choice *choice, size_t first, size_t n,
                      const uint64_t *from_a, uint64_t *bits)
{
    uint64_t a[STRING_WORDS], b[STRING_WORDS];
    read_string(choice->machine, &choice->a, first, n, a);
    read_string(choice->machine, &choice->b, first, n, b);
    for (size_t i = 0; i < (n + 63) / 64; i++)
        bits[i] = (a[i] & from_a[i]) | (b[i] & ~from_a[i]);
}

static void merge_bits(struct bit_choice *choice, size_t first, size_t n,
                       const uint64_t *from_a, uint64_t *bits)
{
    uint64_t a[STRING_WORDS], b[STRING_WORDS];
    size_t count = count_ones(from_a, n), at_a = 0, at_b = 0;
    (void)first;
    read_string(choice->machine, &choice->a, choice->next_a, count, a);
    read_string(choice->machine, &choice->b, choice->next_b, n - count, b);
    for (size_t i = 0; i < n; i++)
        set_bit(bits, i, bit_at(from_a, i) ? bit_at(a, at_a++) : bit_at(b, at_b++));
    choice->next_a += count;
    choice->next_b += n - count;
}

static c205_trap open_choice(struct bit_choice *choice, struct c205 *machine,
                             const struct decoded *decoded)
{
    struct vector *a = &choice->a, *b = &choice->b, *c = &choice->c;
    choice->machine = machine;
    choice->next_a = machine->resume.count[0];
    choice->next_b = machine->resume.count[1];
    c205_trap trap = describe_string(a, machine, decoded->a, decoded->x);
    if (trap == C205_TRAP_NONE)
        trap = describe_string(b, machine, decoded->b, decoded->y);
    if (trap == C205_TRAP_NONE)
        trap = describe_result(c, &choice->control, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, a, c->length, false);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, b, c->length, false);
    if (trap == C205_TRAP_NONE)
        trap = claim_control(machine, &choice->control, c->length);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, c, c->length, true);
    return trap;
}

static c205_trap choose(struct c205 *machine, const struct decoded *decoded,
                        chooser *chosen)
{
    struct bit_choice choice;
    const struct vector *c = &choice.c;
    uint64_t bits[STRING_WORDS], from_a[STRING_WORDS];
    c205_trap trap = open_choice(&choice, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    machine->effect.elements = c->length;
    bool apart = !operands_overlap(&choice.a, c) && !operands_overlap(&choice.b, c)
                 && !operands_overlap(&choice.control.vector, c);
    size_t chunk = apart ? STRING_BITS : 1;
    struct turn turn = machine_turn(machine, c->length, machine->allowed);
    for (size_t first = turn.first, n; first < turn.end; first += n) {
        n = min_size(turn.end - first, chunk);
        control_read(&choice.control, first, n, from_a);
        chosen(&choice, first, n, from_a, bits);
        memory_write_bits(&machine->memory, vector_at(c, first), bits, n);
    }
    trap = machine_end_turn(machine, &turn);
    if (trap != C205_TRAP_NONE) {
        machine->resume.count[0] = choice.next_a;
        machine->resume.count[1] = choice.next_b;
    }
    return trap;
}

c205_trap execute_bits_mask(struct c205 *machine, const struct decoded *decoded)
{
    return choose(machine, decoded, mask_bits);
}

c205_trap execute_bits_merge(struct c205 *machine, const struct decoded *decoded)
{
    return choose(machine, decoded, merge_bits);
}

/* ---- Compress ---------------------------------------------------------- */

struct bit_sieve {
    struct c205 *machine;
    struct vector a, c;
    struct control control;
    size_t n;    /* number of bits scanned */
    size_t kept; /* bits kept so far */
    struct turn turn;
};

static size_t keep_bits(const struct bit_sieve *sieve, size_t first, size_t n,
                        uint64_t *kept)
{
    uint64_t bits[STRING_WORDS], keep[STRING_WORDS];
    size_t count = 0;
    read_string(sieve->machine, &sieve->a, first, n, bits);
    control_read(&sieve->control, first, n, keep);
    for (size_t i = 0; i < n; i++)
        if (bit_at(keep, i))
            set_bit(kept, count++, bit_at(bits, i));
    return count;
}

/* Checks the memory of the operands and of the result. If `ahead` is true, no store
 * overwrites an operand bit before it is read; the kept bits are then counted first,
 * and the result needs room only for these. Otherwise the result needs room for all
 * scanned bits. */
static c205_trap claim_sieve(struct bit_sieve *sieve, bool ahead)
{
    struct c205 *machine = sieve->machine;
    const struct turn *turn = &sieve->turn;
    uint64_t kept[STRING_WORDS];
    c205_trap trap = claim_vector(machine, &sieve->a, sieve->n, false);
    if (trap == C205_TRAP_NONE)
        trap = claim_control(machine, &sieve->control, sieve->n);
    if (trap != C205_TRAP_NONE)
        return trap;
    unsigned touches = machine->effect.touch_count;
    sieve->kept = min_size(machine->resume.count[0], turn->first);
    sieve->c.length = sieve->n;
    if (ahead)
        sieve->c.length = sieve->kept
                          + keep_bits(sieve, turn->first, turn->n - turn->first, kept);
    trap = claim_vector(machine, &sieve->c, sieve->c.length, true);
    machine->effect.touch_count = touches;
    return trap;
}

static c205_trap store_kept(struct bit_sieve *sieve, size_t chunk)
{
    struct memory *memory = &sieve->machine->memory;
    const struct turn *turn = &sieve->turn;
    uint64_t bits[STRING_WORDS];
    for (size_t first = turn->first, n; first < turn->end; first += n) {
        n = min_size(turn->end - first, chunk);
        size_t count = keep_bits(sieve, first, n, bits);
        memory_write_bits(memory, vector_at(&sieve->c, sieve->kept), bits, count);
        sieve->kept += count;
    }
    c205_trap trap = machine_end_turn(sieve->machine, turn);
    if (trap != C205_TRAP_NONE)
        sieve->machine->resume.count[0] = sieve->kept;
    return trap;
}

c205_trap execute_bits_compress(struct c205 *machine, const struct decoded *decoded)
{
    struct bit_sieve sieve = { .machine = machine };
    c205_trap trap = describe_string(&sieve.a, machine, decoded->a, decoded->x);
    if (trap == C205_TRAP_NONE)
        trap = describe_result(&sieve.c, &sieve.control, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    sieve.n = sieve.c.length = sieve.control.vector.length;
    sieve.turn = machine_turn(machine, sieve.n, machine->allowed);
    bool ahead = operand_is_ahead(&sieve.a, &sieve.c)
                 && operand_is_ahead(&sieve.control.vector, &sieve.c);
    trap = claim_sieve(&sieve, ahead);
    if (trap != C205_TRAP_NONE)
        return trap;
    trap = store_kept(&sieve, ahead ? STRING_BITS : 1);
    if (trap != C205_TRAP_NONE)
        return trap;
    if (sieve.kept > 0)
        machine_touch_result(machine, sieve.c.address, sieve.kept);
    machine->effect.elements = sieve.n;
    machine->slot[decoded->result[0]] = with_length(machine->slot[decoded->c],
                                                    sieve.kept);
    return C205_TRAP_NONE;
}

/* ---- Repeated masks ---------------------------------------------------- */

/* Stores groups of S bits. The first R bits of each group have the value `first`. The
 * other bits have its complement. */
static c205_trap repeat(struct c205 *machine, const struct decoded *decoded, bool first)
{
    struct vector c = describe_bits(machine->slot[decoded->c]);
    int64_t many = c205_to_integer(machine->slot[decoded->a]);
    int64_t group = c205_to_integer(machine->slot[decoded->b]);
    uint64_t bits[STRING_WORDS];
    if (group < 1)
        return machine_refuse(machine, RULE_GROUP);
    c205_trap trap = claim_vector(machine, &c, c.length, true);
    if (trap != C205_TRAP_NONE)
        return trap;
    machine->effect.elements = c.length;
    struct turn turn = machine_turn(machine, c.length, machine->allowed);
    for (size_t i = turn.first; i < turn.end; i++)
        set_bit(bits, i - turn.first, ((int64_t)i % group < many) == first);
    memory_write_bits(&machine->memory, vector_at(&c, turn.first), bits,
                      turn.end - turn.first);
    return machine_end_turn(machine, &turn);
}

c205_trap execute_bits_repeat_zeros(struct c205 *machine, const struct decoded *decoded)
{
    return repeat(machine, decoded, false);
}

c205_trap execute_bits_repeat_ones(struct c205 *machine, const struct decoded *decoded)
{
    return repeat(machine, decoded, true);
}

/* ---- Count ------------------------------------------------------------- */

static size_t leading_alike(const uint64_t *bits, size_t n)
{
    size_t i = 0;
    while (i < n && bit_at(bits, i) == bit_at(bits, 0))
        i++;
    return i;
}

typedef size_t count(const uint64_t *bits, size_t n);

/* Counts the whole string again after an interruption, because nothing is stored before
 * the end. */
static c205_trap count_string(struct c205 *machine, const struct decoded *decoded,
                              count *counted)
{
    struct vector string = describe_bits(machine->slot[decoded->a]);
    struct turn turn = machine_turn(machine, string.length, machine->allowed);
    uint64_t bits[STRING_WORDS];
    c205_trap trap = claim_vector(machine, &string, string.length, false);
    if (trap == C205_TRAP_NONE)
        trap = machine_end_turn(machine, &turn);
    if (trap != C205_TRAP_NONE)
        return trap;
    read_string(machine, &string, 0, string.length, bits);
    machine->effect.elements = string.length;
    machine->slot[decoded->c] = counted(bits, string.length);
    return C205_TRAP_NONE;
}

c205_trap execute_bits_leading(struct c205 *machine, const struct decoded *decoded)
{
    return count_string(machine, decoded, leading_alike);
}

c205_trap execute_bits_count(struct c205 *machine, const struct decoded *decoded)
{
    return count_string(machine, decoded, count_ones);
}
