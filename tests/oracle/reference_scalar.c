/* reference_scalar.c - instructions on registers and memory. */
#include "reference_parts.h"

/* ---- Rules of arithmetic, one for registers and elements --------------- */

static oracle_rule *const rules[C205_OPERATIONS] = {
#define ELEMENTWISE(name, specials) [C205_OPERATION_##name] = oracle_##name,
#include "vm/arith.def"
};

oracle_rule *reference_rule(const c205_insn *insn)
{
    return rules[insn->operation];
}

/* ---- Registers --------------------------------------------------------- */

static void apply_rule(struct reference *reference, const c205_insn *insn,
                       const c205_fields *fields)
{
    const char *letters = insn->operands;
    c205_word r = read_operand(reference, letters[0], fields->r);
    c205_word s = read_operand(reference, letters[1], fields->s);
    const struct oracle_format *format = format_of(width_of_letter(letters[0]));
    write_operand(reference, reference_letter(insn, 0, 'T'), fields->t,
                  reference_rule(insn)(format, r, s, &reference->now.flags));
}

/* Returns a half register: the low 24 bits of `low`, the other bits of `high`. */
static c205_word half_of(uint64_t high, uint64_t low)
{
    return (high & ~(LOW_24 << HALF_BITS)) | (low & LOW_24) << HALF_BITS;
}

static void enter_half(struct reference *reference, const c205_fields *fields, bool add)
{
    c205_word old = read_operand(reference, 'I', fields->r);
    uint64_t immediate = (uint64_t)fields->immediate;
    write_operand(reference, 'W', fields->r,
                  add ? half_of(old, (old >> HALF_BITS) + immediate)
                      : half_of(0, immediate));
}

static void read_timer(struct reference *reference, unsigned result)
{
    const struct reference_state *now = &reference->now;
    write_register(reference, result,
                   now->timer == 0 ? 0 : now->timer - reference->clock);
}

static void set_timer(struct reference *reference, c205_word clocks)
{
    clocks &= LOW_48;
    reference->now.timer = clocks == 0 ? 0 : reference->clock + clocks;
}

static void exchange_flags(struct reference *reference, const c205_fields *fields)
{
    c205_word old = reference->now.flags;
    reference->now.flags = read_bits(reference, fields->r);
    write_register(reference, fields->t, old);
}

/* A register field: a length and a first bit, where bit 0 is the leftmost bit. */
struct field {
    unsigned shift; /* distance of the last bit of the field from the right end */
    uint64_t mask;  /* right-justified */
};

static struct field describe_field(struct reference *reference, c205_word descriptor)
{
    uint64_t length = length_of(descriptor);
    uint64_t first = descriptor & LOW_48;
    struct field none = { 0, 0 };
    if (first + length > BITS)
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
    if (length == 0 || first + length > BITS)
        return none;
    return (struct field){ (unsigned)(BITS - first - length),
                           UINT64_MAX >> (BITS - length) };
}

static void extract(struct reference *reference, const c205_fields *fields)
{
    struct field field = describe_field(reference, read_bits(reference, fields->s));
    write_register(reference, fields->t,
                   read_bits(reference, fields->r) >> field.shift & field.mask);
}

static void insert(struct reference *reference, const c205_fields *fields)
{
    struct field field = describe_field(reference, read_bits(reference, fields->s));
    c205_word bits = read_bits(reference, fields->r) & field.mask;
    c205_word rest = read_bits(reference, fields->t) & ~(field.mask << field.shift);
    write_register(reference, fields->t, rest | bits << field.shift);
}

/* Returns a product modulo 2^48. */
static uint64_t low_product(c205_word r, c205_word s)
{
    return ((r & LOW_48) * (s & LOW_48)) & LOW_48;
}

/* Records the faults of a SWAP that loads the vector `from` and saves to `to`. */
static void look_at_vectors(struct reference *reference, c205_word from, c205_word to)
{
    for (unsigned i = 0; i < length_of(from); i++)
        pass_by_memory(reference, from + BITS * i, BITS);
    for (unsigned i = 0; i < length_of(to); i++)
        leave_memory(reference, to + BITS * i, BITS);
}

/* Saves registers, then loads registers. Both descriptors are read first. */
static void swap(struct reference *reference, const c205_fields *fields)
{
    c205_word from = read_bits(reference, fields->r);
    c205_word to = read_bits(reference, fields->t);
    uint64_t saved = length_of(to), loaded = length_of(from);
    if (fields->s + saved > C205_REGISTERS || fields->s + loaded > C205_REGISTERS) {
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
        look_at_vectors(reference, from, to);
        return;
    }
    for (unsigned i = 0; i < saved; i++)
        write_memory(reference, to + BITS * i, BITS,
                     read_bits(reference, fields->s + i));
    for (unsigned i = 0; i < loaded; i++)
        write_register(reference, fields->s + i,
                       read_memory(reference, from + BITS * i, BITS));
    reference->deed.swapped = saved + loaded;
    add_extent(reference, from, BITS * loaded);
    add_extent(reference, to, BITS * saved);
}

/* Loads or stores an operand. Its size is the size of T. */
static void reach_memory(struct reference *reference, const c205_insn *insn,
                         const c205_fields *fields, bool store)
{
    char letter = reference_letter(insn, 0, 'T');
    unsigned width = width_of_letter(letter);
    uint64_t address = plain_address(read_bits(reference, fields->r)
                                     + width * read_bits(reference, fields->s));
    add_extent(reference, address, width);
    if (store)
        write_memory(reference, address, width,
                     read_operand(reference, letter, fields->t));
    else
        write_operand(reference, letter, fields->t,
                      read_memory(reference, address, width));
}

void do_scalar(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields)
{
    uint64_t immediate = (uint64_t)fields->immediate;
    c205_word r = read_bits(reference, fields->r);
    c205_word s = read_bits(reference, fields->s);
    unsigned first = fields->r, result = fields->t;
    switch (reference_which(insn)) {
    case DO_ES:
    case DO_EX: write_register(reference, first, immediate & LOW_48); break;
    case DO_IS:
    case DO_IX: write_register(reference, first, with_low(r, r + immediate)); break;
    case DO_ELEN: write_register(reference, first, with_length(r, immediate)); break;
    case DO_ADDLEN:
        write_register(reference, result, with_length(r, length_of(r) + s));
        break;
    case DO_LTOR: write_register(reference, result, length_of(r)); break;
    case DO_MPYX: write_register(reference, result, low_product(r, s)); break;
    case DO_SHIFTI:
        write_register(reference, result,
                       oracle_shift(&oracle_full, r, immediate & LOW_48,
                                    &reference->now.flags));
        break;
    case DO_LSDFR: exchange_flags(reference, fields); break;
    case DO_CLOCK: write_register(reference, result, reference->clock & LOW_48); break;
    case DO_RJTIME: read_timer(reference, result); break;
    case DO_WJTIME: set_timer(reference, r); break;
    case DO_EXH:
    case DO_IXH: enter_half(reference, fields, reference_which(insn) == DO_IXH); break;
    case DO_EXTB: extract(reference, fields); break;
    case DO_INSB: insert(reference, fields); break;
    case DO_LOD:
    case DO_LODH: reach_memory(reference, insn, fields, false); break;
    case DO_STO:
    case DO_STOH: reach_memory(reference, insn, fields, true); break;
    case DO_SWAP: swap(reference, fields); break;
    default: apply_rule(reference, insn, fields);
    }
}

/* ---- Which instructions have a rule ------------------------------------ */

static const enum reference_insn written_out[] = {
    /* instructions that are not elementwise operations */
    DO_ES,     DO_IS,     DO_EX,     DO_IX,    DO_ELEN,   DO_ADDLEN, DO_LTOR,
    DO_MPYX,   DO_LOD,    DO_STO,    DO_SWAP,  DO_SHIFTI, DO_BEQ,    DO_BNE,
    DO_BGE,    DO_BLT,    DO_IBNZ,   DO_DBNZ,  DO_BSAVE,  DO_BIM,    DO_IBXEQ,
    DO_IBXNE,  DO_IBXGE,  DO_IBXLT,  DO_IBXLE, DO_IBXGT,  DO_CFPEQ,  DO_CFPNE,
    DO_CFPGE,  DO_CFPLT,  DO_CFPLE,  DO_CFPGT, DO_EXIT,   DO_INTVLV, DO_MAXV,
    DO_MINV,   DO_SUMV,   DO_PRODV,  DO_DOTV,  DO_VREVV,  DO_VXTOV,  DO_VTOVX,
    DO_MASKV,  DO_CPSV,   DO_MRGV,   DO_ACPSV, DO_CNTLB,  DO_LSDFR,  DO_CLOCK,
    DO_INSB,   DO_EXTB,   DO_BARB,   DO_BAB,   DO_BADF,   DO_POLYV,  DO_CPSB,
    DO_MRGB,   DO_MASKB,  DO_MRKZ,   DO_MRKO,  DO_CNTOB,  DO_LINKV,  DO_EXH,
    DO_IXH,    DO_LODH,   DO_STOH,   DO_BHEQ,  DO_BHNE,   DO_BHGE,   DO_BHLT,
    DO_RJTIME, DO_WJTIME, DO_VGATHP, DO_VSCATP
};

bool reference_knows(const c205_insn *insn)
{
    bool known = reference_rule(insn);
    for (size_t i = 0; i < sizeof written_out / sizeof *written_out; i++)
        known |= reference_which(insn) == written_out[i];
    return known;
}
