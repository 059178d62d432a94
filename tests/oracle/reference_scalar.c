/* reference_scalar.c - instructions on registers and memory. */
#include "reference_parts.h"

/* ---- Rules of arithmetic, one for registers and elements --------------- */

static oracle_rule *const rules[] = {
    [DO_ADDU] = oracle_add_upper,
    [DO_ADDL] = oracle_add_lower,
    [DO_ADDN] = oracle_add_normalised,
    [DO_SUBU] = oracle_subtract_upper,
    [DO_SUBL] = oracle_subtract_lower,
    [DO_SUBN] = oracle_subtract_normalised,
    [DO_MPYU] = oracle_multiply_upper,
    [DO_MPYL] = oracle_multiply_lower,
    [DO_MPYS] = oracle_multiply_significant,
    [DO_DIVU] = oracle_divide_upper,
    [DO_DIVS] = oracle_divide_significant,
    [DO_TRU] = oracle_truncate,
    [DO_FLR] = oracle_floor,
    [DO_SQRT] = oracle_square_root,
    [DO_ABS] = oracle_absolute,
    [DO_EXP] = oracle_exponent,
    [DO_CLG] = oracle_ceiling,
    [DO_ADJS] = oracle_adjust_significance,
    [DO_ADJE] = oracle_adjust_exponent,
    [DO_PACK] = oracle_pack,
    [DO_SHIFT] = oracle_shift,
    [DO_XOR] = oracle_xor,
    [DO_AND] = oracle_and,
    [DO_OR] = oracle_or,
    [DO_ADDUV] = oracle_add_upper,
    [DO_ADDLV] = oracle_add_lower,
    [DO_ADDNV] = oracle_add_normalised,
    [DO_SUBUV] = oracle_subtract_upper,
    [DO_SUBLV] = oracle_subtract_lower,
    [DO_SUBNV] = oracle_subtract_normalised,
    [DO_MPYUV] = oracle_multiply_upper,
    [DO_MPYLV] = oracle_multiply_lower,
    [DO_MPYSV] = oracle_multiply_significant,
    [DO_DIVUV] = oracle_divide_upper,
    [DO_DIVSV] = oracle_divide_significant,
    [DO_TRUV] = oracle_truncate,
    [DO_FLRV] = oracle_floor,
    [DO_SQRTV] = oracle_square_root,
    [DO_VTOV] = oracle_copy,
    [DO_ABSV] = oracle_absolute,
    [DO_EXPV] = oracle_exponent,
    [DO_ADDUS] = oracle_add_upper,
    [DO_ADDLS] = oracle_add_lower,
    [DO_ADDNS] = oracle_add_normalised,
    [DO_SUBUS] = oracle_subtract_upper,
    [DO_SUBLS] = oracle_subtract_lower,
    [DO_SUBNS] = oracle_subtract_normalised,
    [DO_MPYUS] = oracle_multiply_upper,
    [DO_MPYLS] = oracle_multiply_lower,
    [DO_MPYSS] = oracle_multiply_significant,
    [DO_DIVUS] = oracle_divide_upper,
    [DO_DIVSS] = oracle_divide_significant,
    [DO_AVGV] = oracle_average,
    [DO_AVGDV] = oracle_average_difference,
    [DO_CLGV] = oracle_ceiling,
    [DO_ADJSV] = oracle_adjust_significance,
    [DO_ADJEV] = oracle_adjust_exponent,
    [DO_PACKV] = oracle_pack,
    [DO_ADDXV] = oracle_add_index,
    [DO_SUBXV] = oracle_subtract_index,
    [DO_DELTAV] = oracle_subtract_normalised,
    [DO_ADJMV] = oracle_average,
    [DO_SCHEQV] = oracle_equal,
    [DO_SCHNEV] = oracle_not_equal,
    [DO_SCHGEV] = oracle_not_less,
    [DO_SCHLTV] = oracle_less,
    [DO_SHIFTV] = oracle_shift,
    [DO_XORV] = oracle_xor,
    [DO_ANDV] = oracle_and,
    [DO_ORV] = oracle_or,
    [DO_NANDV] = oracle_nand,
    [DO_NORV] = oracle_nor,
    [DO_ORNV] = oracle_or_not,
    [DO_ANDNV] = oracle_and_not,
    [DO_EQVV] = oracle_equivalence,
    [DO_CMPEQV] = oracle_equal,
    [DO_CMPNEV] = oracle_not_equal,
    [DO_CMPGEV] = oracle_not_less,
    [DO_CMPLTV] = oracle_less,
    [DO_SELEQV] = oracle_equal,
    [DO_SELNEV] = oracle_not_equal,
    [DO_SELGEV] = oracle_not_less,
    [DO_SELLTV] = oracle_less,
    [DO_XORB] = oracle_xor,
    [DO_ANDB] = oracle_and,
    [DO_ORB] = oracle_or,
    [DO_NANDB] = oracle_nand,
    [DO_NORB] = oracle_nor,
    [DO_ORNB] = oracle_or_not,
    [DO_ANDNB] = oracle_and_not,
    [DO_EQVB] = oracle_equivalence,
    [DO_NOTHING] = NULL,
};

oracle_rule *reference_rule(const c205_insn *insn)
{
    return rules[reference_which(insn)];
}

/* ---- Registers --------------------------------------------------------- */

/* As the letter of its operand says. */
static c205_word read_as(const struct reference *reference, char letter,
                         unsigned number)
{
    return letter == 'f' ? read_as_number(reference, number)
                         : read_bits(reference, number);
}

static void apply_rule(struct reference *reference, const c205_insn *insn,
                       const c205_fields *fields)
{
    const c205_word r = read_as(reference, insn->operands[0], fields->r);
    const c205_word s = read_as(reference, insn->operands[1], fields->s);

    write_register(reference, fields->t,
                   reference_rule(insn)(r, s, &reference->now.flags));
}

static void exchange_flags(struct reference *reference,
                           const c205_fields *fields)
{
    const c205_word old = reference->now.flags;

    reference->now.flags = read_bits(reference, fields->r);
    write_register(reference, fields->t, old);
}

/* Bits of a register: a length, a first bit, 0 the leftmost. */
struct field {
    unsigned shift; /* of its last bit from the right end */
    uint64_t mask;  /* right-justified */
};

static struct field describe_field(struct reference *reference,
                                   c205_word descriptor)
{
    const uint64_t length = length_of(descriptor);
    const uint64_t first = descriptor & LOW_48;
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
    const struct field field = describe_field(reference,
                                              read_bits(reference,
                                                        fields->s));

    write_register(reference, fields->t,
                   read_bits(reference, fields->r) >> field.shift
                       & field.mask);
}

static void insert(struct reference *reference, const c205_fields *fields)
{
    const struct field field = describe_field(reference,
                                              read_bits(reference,
                                                        fields->s));
    const c205_word bits = read_bits(reference, fields->r) & field.mask;
    const c205_word rest = read_bits(reference, fields->t)
                           & ~(field.mask << field.shift);

    write_register(reference, fields->t, rest | bits << field.shift);
}

/* A product modulo 2^48. */
static uint64_t low_product(c205_word r, c205_word s)
{
    return ((r & LOW_48) * (s & LOW_48)) & LOW_48;
}

/* They may be at fault as well. */
static void look_at_vectors(struct reference *reference, c205_word from,
                            c205_word to)
{
    for (unsigned i = 0; i < length_of(from); i++)
        pass_by_word(reference, from + BITS * i);
    for (unsigned i = 0; i < length_of(to); i++)
        leave_word(reference, to + BITS * i);
}

/* Saved first, then loaded; the descriptors are read before either. */
static void swap(struct reference *reference, const c205_fields *fields)
{
    const c205_word from = read_bits(reference, fields->r);
    const c205_word to = read_bits(reference, fields->t);
    const uint64_t saved = length_of(to), loaded = length_of(from);

    if (fields->s + saved > C205_REGISTERS
        || fields->s + loaded > C205_REGISTERS) {
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
        look_at_vectors(reference, from, to);
        return;
    }
    for (unsigned i = 0; i < saved; i++)
        write_word(reference, to + BITS * i,
                   read_bits(reference, fields->s + i));
    for (unsigned i = 0; i < loaded; i++)
        write_register(reference, fields->s + i,
                       read_word(reference, from + BITS * i));
    reference->deed.swapped = saved + loaded;
    add_extent(reference, from, BITS * loaded);
    add_extent(reference, to, BITS * saved);
}

static void reach_memory(struct reference *reference,
                         const c205_fields *fields, bool store)
{
    const uint64_t address = plain_address(
        read_bits(reference, fields->r)
        + BITS * read_bits(reference, fields->s));

    add_extent(reference, address, BITS);
    if (store)
        write_word(reference, address, read_bits(reference, fields->t));
    else
        write_register(reference, fields->t, read_word(reference, address));
}

void do_scalar(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields)
{
    const uint64_t immediate = (uint64_t)fields->immediate;
    const c205_word r = read_bits(reference, fields->r);
    const c205_word s = read_bits(reference, fields->s);
    const unsigned first = fields->r, result = fields->t;

    switch (reference_which(insn)) {
    case DO_ES:
    case DO_EX: write_register(reference, first, immediate & LOW_48); break;
    case DO_IS:
    case DO_IX:
        write_register(reference, first, with_low(r, r + immediate));
        break;
    case DO_ELEN:
        write_register(reference, first, with_length(r, immediate));
        break;
    case DO_ADDLEN:
        write_register(reference, result, with_length(r, length_of(r) + s));
        break;
    case DO_LTOR: write_register(reference, result, length_of(r)); break;
    case DO_RTOR: write_register(reference, result, r); break;
    case DO_ADDX:
        write_register(reference, result, with_low(r, r + s));
        break;
    case DO_SUBX:
        write_register(reference, result, with_low(r, r - s));
        break;
    case DO_MPYX: write_register(reference, result, low_product(r, s)); break;
    case DO_SHIFTI:
        write_register(reference, result,
                       oracle_shift(r, immediate & LOW_48,
                                    &reference->now.flags));
        break;
    case DO_LSDFR: exchange_flags(reference, fields); break;
    case DO_CLOCK:
        write_register(reference, result, reference->clock & LOW_48);
        break;
    case DO_EXTB: extract(reference, fields); break;
    case DO_INSB: insert(reference, fields); break;
    case DO_LOD:
    case DO_STO:
        reach_memory(reference, fields, reference_which(insn) == DO_STO);
        break;
    case DO_SWAP: swap(reference, fields); break;
    default: apply_rule(reference, insn, fields);
    }
}

/* ---- Which instructions have a rule ------------------------------------ */

static const bool written_out[] = {
    [DO_ES] = true,     [DO_IS] = true,    [DO_EX] = true,
    [DO_IX] = true,     [DO_ELEN] = true,  [DO_ADDLEN] = true,
    [DO_LTOR] = true,   [DO_RTOR] = true,  [DO_ADDX] = true,
    [DO_SUBX] = true,   [DO_MPYX] = true,  [DO_LOD] = true,
    [DO_STO] = true,    [DO_SWAP] = true,  [DO_SHIFTI] = true,
    [DO_BEQ] = true,    [DO_BNE] = true,   [DO_BGE] = true,
    [DO_BLT] = true,    [DO_IBNZ] = true,  [DO_DBNZ] = true,
    [DO_BSAVE] = true,  [DO_BIM] = true,   [DO_IBXEQ] = true,
    [DO_IBXNE] = true,  [DO_IBXGE] = true, [DO_IBXLT] = true,
    [DO_IBXLE] = true,  [DO_IBXGT] = true, [DO_CFPEQ] = true,
    [DO_CFPNE] = true,  [DO_CFPGE] = true, [DO_CFPLT] = true,
    [DO_CFPLE] = true,  [DO_CFPGT] = true, [DO_EXIT] = true,
    [DO_INTVLV] = true, [DO_MAXV] = true,  [DO_MINV] = true,
    [DO_SUMV] = true,   [DO_PRODV] = true, [DO_DOTV] = true,
    [DO_VREVV] = true,  [DO_VXTOV] = true, [DO_VTOVX] = true,
    [DO_MASKV] = true,  [DO_CPSV] = true,  [DO_MRGV] = true,
    [DO_ACPSV] = true,  [DO_CNTLB] = true, [DO_LSDFR] = true,
    [DO_CLOCK] = true,  [DO_INSB] = true,  [DO_EXTB] = true,
    [DO_BARB] = true,   [DO_BAB] = true,   [DO_BADF] = true,
    [DO_POLYV] = true,  [DO_CPSB] = true,  [DO_MRGB] = true,
    [DO_MASKB] = true,  [DO_MRKZ] = true,  [DO_MRKO] = true,
    [DO_CNTOB] = true,  [DO_LINKV] = true, [DO_NOTHING] = false,
};

bool reference_knows(const c205_insn *insn)
{
    return reference_rule(insn) != NULL || written_out[reference_which(insn)];
}
