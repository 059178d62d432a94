/* reference_operands.c - operands of vector instructions (reference_vector.h). */
#include "reference_vector.h"

#include <string.h>

/* ---- Elements ---------------------------------------------------------- */

/* Reads element i of a source. If the source is the result of the first instruction of
 * a linked pair, the operation that computes the element sets the data flags. */
static c205_word read_element(struct reference *reference, const struct source *source,
                              uint64_t i)
{
    switch (source->kind) {
    case NUMBER: return source->number;
    case STREAM: return join(reference, source->stream, i, &reference->now.flags);
    default:
        return read_memory(reference, source->address + source->width * i,
                           source->width);
    }
}

/* Returns an element. Sign control applies to each element that is read, but not to the
 * padding of a short vector. It sets no flags. */
c205_word element(struct reference *reference, const struct source *source, uint64_t i)
{
    const struct oracle_format *format = format_of(source->width);
    uint64_t unused = 0;
    if (source->kind != NUMBER && i >= source->length)
        return source->pad;
    c205_word word = read_element(reference, source, i);
    if (source->magnitude)
        word = oracle_absolute(format, word, 0, &unused);
    if (source->negate)
        word = oracle_negate(format, word, 0, &unused);
    return word;
}

c205_word join(struct reference *reference, const struct pair *pair, uint64_t i,
               uint64_t *flags)
{
    c205_word a = element(reference, &pair->a, i);
    c205_word b = pair->has_b ? element(reference, &pair->b, i) : 0;
    return pair->rule(pair->format, a, b, flags);
}

/* ---- The control vector ------------------------------------------------ */

bool permitted(struct reference *reference, const struct vector *vector, uint64_t i)
{
    bool on_zeros = vector->fields->g & C205_G_ZEROS;
    return vector->fields->z == 0
           || read_memory(reference, vector->z.address + i, BIT) != on_zeros;
}

void store_element(struct reference *reference, const struct target *target, uint64_t i,
                   c205_word word)
{
    write_memory(reference, target->address + target->width * i, target->width, word);
}

void leave_element(struct reference *reference, const struct target *target, uint64_t i)
{
    leave_memory(reference, target->address + target->width * i, target->width);
}

void write_element(struct reference *reference, const struct vector *vector, uint64_t i,
                   c205_word word, uint64_t flags)
{
    if (permitted(reference, vector, i)) {
        reference->now.flags |= flags;
        store_element(reference, &vector->c, i, word);
    } else
        leave_element(reference, &vector->c, i);
}

/* ---- Lengths ----------------------------------------------------------- */

bool scan_length(struct reference *reference, const struct vector *vector,
                 uint64_t *length)
{
    const struct pair *sources = &vector->sources;
    bool of_b = sources->a.kind == NUMBER;
    *length = of_b ? sources->b.length : sources->a.length;
    if (!of_b || (sources->has_b && sources->b.kind != NUMBER))
        return true;
    add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
    return false;
}

void set_length(struct reference *reference, unsigned number, uint64_t length)
{
    write_register(reference, number,
                   with_length(read_bits(reference, number), length));
}

/* ---- Taking operands --------------------------------------------------- */

/* Applies an offset. It advances the start of a vector, and reduces its length. */
static struct target behind_offset(struct reference *reference, c205_word descriptor,
                                   unsigned offset, unsigned width)
{
    int64_t skipped = as_integer(read_bits(reference, offset));
    uint64_t length = length_of(descriptor);
    uint64_t count = (uint64_t)skipped;
    if (skipped < 0)
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
    return (struct target){
        .width = width,
        .address = plain_address(descriptor + width * count),
        .length = count < length ? length - count : 0,
    };
}

static c205_word pad_of(const c205_insn *insn, unsigned width)
{
    if (insn->flags & C205_INSN_PADO)
        return width == HALF_BITS ? HALF_ONE : C205_ONE;
    return insn->flags & C205_INSN_PADZ ? C205_MACHINE_ZERO : 0;
}

static struct source broadcast(const struct reference *reference, char letter,
                               unsigned number)
{
    return (struct source){
        .kind = NUMBER,
        .width = width_of_letter(letter),
        .number = read_operand(reference, letter, number),
    };
}

struct source vector_source(struct reference *reference, const c205_insn *insn,
                            char letter, unsigned number, unsigned offset)
{
    unsigned width = width_of_letter(letter);
    struct target place = behind_offset(reference, read_bits(reference, number), offset,
                                        width);
    return (struct source){
        .kind = VECTOR,
        .width = width,
        .address = place.address,
        .length = place.length,
        .pad = pad_of(insn, width),
    };
}

static struct source take_source(struct reference *reference,
                                 const struct vector *vector, char letter,
                                 unsigned number, unsigned offset, bool broadcasts)
{
    if (vector->insn->format == C205_FORMAT_SCALARS || broadcasts)
        return broadcast(reference, letter, number);
    return vector_source(reference, vector->insn, letter, number, offset);
}

static void take_sources(struct reference *reference, struct vector *vector)
{
    const c205_insn *insn = vector->insn;
    const c205_fields *fields = vector->fields;
    char a = reference_letter(insn, fields->g, 'A');
    char b = reference_letter(insn, fields->g, 'B');
    bool signs = insn->flags & C205_INSN_SIGN;
    struct pair *pair = &vector->sources;
    pair->rule = reference_rule(insn);
    pair->format = format_of(width_of_letter(a));
    pair->has_b = b && strchr("vubfVUF", b);
    pair->a = take_source(reference, vector, a, fields->a, fields->x,
                          fields->g & C205_G_BROADCAST_A);
    if (pair->has_b)
        pair->b = take_source(reference, vector, b, fields->b, fields->y,
                              fields->g & C205_G_BROADCAST_B);
    pair->a.magnitude = signs && fields->g & C205_G_MAGNITUDE_A;
    pair->a.negate = signs && fields->g & C205_G_NEGATE_A;
    pair->b.magnitude = signs && fields->g & C205_G_MAGNITUDE_B;
}

/* C and Z share the offset in C+1. */
void take_targets(struct reference *reference, struct vector *vector)
{
    const c205_insn *insn = vector->insn;
    const c205_fields *fields = vector->fields;
    unsigned width = width_of_letter(reference_letter(insn, fields->g, 'C'));
    unsigned offset = reference_has_offset(insn, fields) ? fields->c + 1u : 0;
    vector->c = behind_offset(reference, read_bits(reference, fields->c), offset,
                              width);
    vector->z = behind_offset(reference, read_bits(reference, fields->z), offset, BIT);
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

void use_source(struct reference *reference, const struct source *source, uint64_t n)
{
    if (source->kind == VECTOR)
        add_extent(reference, source->address,
                   source->width * lesser(n, source->length));
}

void use_target(struct reference *reference, const struct target *target, uint64_t n)
{
    add_extent(reference, target->address, target->width * n);
}

void use_control(struct reference *reference, const struct vector *vector, uint64_t n)
{
    if (vector->fields->z != 0)
        use_target(reference, &vector->z, n);
}

void may_need(struct reference *reference, const struct source *source, uint64_t n)
{
    for (uint64_t i = 0; i < n && i < source->length; i++)
        pass_by_memory(reference, source->address + source->width * i, source->width);
}
