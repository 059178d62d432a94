/* reference_operands.c - sources, results and control vectors. */
#include "reference_vector.h"

#include <string.h>

/* ---- Elements ---------------------------------------------------------- */

/* Of a linked pair every element of the first one raises its flags, as it
 * has no control vector. */
static c205_word read_element(struct reference *reference,
                              const struct source *source, uint64_t i)
{
    switch (source->kind) {
    case NUMBER: return source->number;
    case STREAM:
        return join(reference, source->stream, i, &reference->now.flags);
    case STRING: return read_bit(reference, source->address + i);
    default: return read_word(reference, source->address + BITS * i);
    }
}

/* Sign control is applied to each element as it is read, not to those that
 * continue a short vector, and raises no flags of its own. */
c205_word element(struct reference *reference, const struct source *source,
                  uint64_t i)
{
    uint64_t unused = 0;
    c205_word word;

    if (source->kind != NUMBER && i >= source->length)
        return source->pad;
    word = read_element(reference, source, i);
    if (source->magnitude)
        word = oracle_absolute(word, 0, &unused);
    if (source->negate)
        word = oracle_negate(word, 0, &unused);
    return word;
}

c205_word join(struct reference *reference, const struct pair *pair,
               uint64_t i, uint64_t *flags)
{
    const c205_word a = element(reference, &pair->a, i);
    const c205_word b = pair->has_b ? element(reference, &pair->b, i) : 0;

    return pair->rule(a, b, flags);
}

/* ---- The control vector ------------------------------------------------ */

bool permitted(struct reference *reference, const struct vector *vector,
               uint64_t i)
{
    const bool on_zeros = vector->fields->g & C205_G_ZEROS;

    if (vector->fields->z == 0)
        return true;
    return read_bit(reference, vector->z.address + i) != on_zeros;
}

void write_element(struct reference *reference, const struct vector *vector,
                   uint64_t i, c205_word word, uint64_t flags)
{
    const uint64_t address = vector->c.address + BITS * i;

    if (permitted(reference, vector, i)) {
        reference->now.flags |= flags;
        write_word(reference, address, word);
    } else
        leave_word(reference, address);
}

/* ---- Lengths ----------------------------------------------------------- */

bool scan_length(struct reference *reference, const struct vector *vector,
                 uint64_t *length)
{
    const struct pair *sources = &vector->sources;
    const bool of_b = sources->a.kind == NUMBER;

    *length = of_b ? sources->b.length : sources->a.length;
    if (!of_b || (sources->has_b && sources->b.kind != NUMBER))
        return true;
    add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
    return false;
}

void set_length(struct reference *reference, const struct vector *vector,
                uint64_t length)
{
    const unsigned c = vector->fields->c;

    write_register(reference, c,
                   with_length(read_bits(reference, c), length));
}

/* ---- Taking operands --------------------------------------------------- */

/* An offset moves a vector on and shortens it. */
static struct target behind_offset(struct reference *reference,
                                   c205_word descriptor, unsigned offset,
                                   unsigned width)
{
    const int64_t skipped = as_integer(read_bits(reference, offset));
    const uint64_t length = length_of(descriptor);
    const uint64_t count = (uint64_t)skipped;

    if (skipped < 0)
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
    return (struct target){
        .address = plain_address(descriptor + width * count),
        .length = count < length ? length - count : 0,
    };
}

static c205_word pad_of(const c205_insn *insn)
{
    if (insn->flags & C205_INSN_PADO)
        return C205_ONE;
    return insn->flags & C205_INSN_PADZ ? C205_MACHINE_ZERO : 0;
}

/* The letter of the instruction table says how register 0 reads. */
static struct source broadcast(const struct reference *reference, char letter,
                               unsigned number)
{
    return (struct source){
        .kind = NUMBER,
        .number = letter == 'u' ? read_bits(reference, number)
                                : read_as_number(reference, number),
    };
}

struct source vector_source(struct reference *reference,
                            const c205_insn *insn, char letter,
                            unsigned number, unsigned offset)
{
    const bool bits = letter == 'b';
    const struct target place = behind_offset(reference,
                                              read_bits(reference, number),
                                              offset, bits ? 1 : BITS);

    return (struct source){
        .kind = bits ? STRING : WORDS,
        .address = place.address,
        .length = place.length,
        .pad = pad_of(insn),
    };
}

static void take_sources(struct reference *reference, struct vector *vector)
{
    const c205_insn *insn = vector->insn;
    const c205_fields *fields = vector->fields;
    const char *letters = insn->operands;
    const bool numbers = insn->format == C205_FORMAT_SCALARS;
    const bool signs = insn->flags & C205_INSN_SIGN;
    struct pair *pair = &vector->sources;

    pair->rule = reference_rule(insn);
    pair->has_b = strchr("vubf", letters[1]) != NULL;
    pair->a = numbers || fields->g & C205_G_BROADCAST_A
                  ? broadcast(reference, letters[0], fields->a)
                  : vector_source(reference, insn, letters[0], fields->a,
                                  fields->x);
    if (pair->has_b)
        pair->b = numbers || fields->g & C205_G_BROADCAST_B
                      ? broadcast(reference, letters[1], fields->b)
                      : vector_source(reference, insn, letters[1], fields->b,
                                      fields->y);
    pair->a.magnitude = signs && fields->g & C205_G_MAGNITUDE_A;
    pair->a.negate = signs && fields->g & C205_G_NEGATE_A;
    pair->b.magnitude = signs && fields->g & C205_G_MAGNITUDE_B;
}

static bool writes_bits(const c205_insn *insn)
{
    return insn->timing == C205_TIMING_vbits
           || (strchr(insn->operands, 'e') && !strchr(insn->operands, 'c'));
}

/* C and Z share the offset in C+1. */
void take_targets(struct reference *reference, struct vector *vector)
{
    const c205_fields *fields = vector->fields;
    const unsigned offset = fields->g & reference_bits_of_g(vector->insn)
                                    & C205_G_OFFSET
                                ? fields->c + 1u
                                : 0;

    vector->c = behind_offset(reference, read_bits(reference, fields->c),
                              offset, writes_bits(vector->insn) ? 1 : BITS);
    vector->z = behind_offset(reference, read_bits(reference, fields->z),
                              offset, 1);
}

bool has_bad_operand(const struct reference *reference)
{
    return reference->faults[C205_TRAP_BAD_DESCRIPTOR].certain;
}

bool take_operands(struct reference *reference, const c205_insn *insn,
                   const c205_fields *fields, struct vector *vector)
{
    *vector = (struct vector){ .insn = insn, .fields = fields };
    take_sources(reference, vector);
    take_targets(reference, vector);
    return !has_bad_operand(reference);
}

/* ---- Memory used ------------------------------------------------------- */

void use_source(struct reference *reference, const struct source *source,
                uint64_t n)
{
    const uint64_t used = n < source->length ? n : source->length;

    if (source->kind == WORDS || source->kind == STRING)
        add_extent(reference, source->address,
                   used * (source->kind == WORDS ? BITS : 1));
}

void use_control(struct reference *reference, const struct vector *vector,
                 uint64_t n)
{
    if (vector->fields->z != 0)
        add_extent(reference, vector->z.address, n);
}
static void pass_by(struct reference *reference, const struct source *source,
                    uint64_t i)
{
    if (source->kind == STRING)
        pass_by_bit(reference, source->address + i);
    else
        pass_by_word(reference, source->address + BITS * i);
}

void may_need(struct reference *reference, const struct source *source,
              uint64_t n)
{
    for (uint64_t i = 0; i < n && i < source->length; i++)
        pass_by(reference, source, i);
}
