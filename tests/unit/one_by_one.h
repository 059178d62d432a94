/* one_by_one.h - another machine, for the tests of the vector instructions:
 * it takes one element after another, reads it, computes, stores, and only
 * then goes on to the next.  Slow, and with nothing clever in it.
 */
#ifndef ONE_BY_ONE_H
#define ONE_BY_ONE_H

#include "machine_fixture.h"

#include "vm/number/arith.h"

enum {
    PAGES = 2,
    WORDS = PAGES * C205_PAGE_WORDS,
    WINDOW = 400, /* words, around the page boundary, that operands lie in */
    ACTIVE = 4 * WINDOW /* words that a case may change */
};
#define WINDOW_BEGIN (DATA + (C205_PAGE_WORDS - WINDOW / 2) * UINT64_C(64))
#define ACTIVE_BEGIN (WINDOW_BEGIN - WINDOW * UINT64_C(64))

struct other {
    c205_word memory[WORDS], before[ACTIVE];
    c205_word reg[256];
    uint64_t flags;
    bool trap;
};

static c205_word *place(struct other *o, uint64_t address)
{
    uint64_t word = ((address & 0xFFFFFFFFFFFF) - DATA) / 64;
    if (word < WORDS)
        return &o->memory[word];
    o->trap = true;
    return &o->reg[0];
}

static bool bit(struct other *o, uint64_t address)
{
    return *place(o, address) >> (63 - address % 64) & 1;
}

static void set_bit(struct other *o, uint64_t address, bool value)
{
    uint64_t mask = UINT64_C(1) << (63 - address % 64);
    c205_word *word = place(o, address);
    *word = value ? *word | mask : *word & ~mask;
}

struct operand {
    uint64_t address;
    int64_t length;
};

static struct operand operand_of(struct other *o, unsigned number,
                                 int64_t offset, int64_t width)
{
    c205_word d = o->reg[number];
    struct operand operand = { d & 0xFFFFFFFFFFFF, (int64_t)(d >> 48) };
    if (offset < 0)
        o->trap = true;
    operand.address += (uint64_t)(offset * width);
    operand.length -= offset;
    if (operand.length < 0)
        operand.length = 0;
    return operand;
}

struct insn {
    struct other *o;
    const c205_insn *row;
    c205_fields f;
    struct operand a, b, c, z;
    unsigned order;          /* the register of Z */
    const c205_word *handed; /* by the first of a linked pair, .. */
    bool handed_a, handed_b; /* .. as what */
};

static c205_word sign(c205_word word, bool magnitude, bool negate)
{
    uint64_t flags = 0;
    if (magnitude)
        word = arith_absolute(word, &flags);
    return negate ? arith_negate(word, &flags) : word;
}

static c205_word padding(const c205_insn *row)
{
    if (row->flags & C205_INSN_PADO)
        return C205_ONE;
    return row->flags & C205_INSN_PADZ ? C205_MACHINE_ZERO : 0;
}

static c205_word scalar(struct insn *i, unsigned number)
{
    bool zero = number == 0 && !strchr("ul", i->row->operands[0]);
    return zero ? C205_MACHINE_ZERO : i->o->reg[number];
}

static c205_word element_a(struct insn *i, int64_t n)
{
    bool controlled = i->row->flags & C205_INSN_SIGN;
    c205_word word;
    if (i->handed_a)
        word = *i->handed;
    else if (i->f.g & C205_G_BROADCAST_A
             || i->row->format == C205_FORMAT_SCALARS)
        word = scalar(i, i->f.a);
    else if (n < i->a.length)
        word = *place(i->o, i->a.address + (uint64_t)n * 64);
    else
        return padding(i->row);
    return controlled ? sign(word, i->f.g & C205_G_MAGNITUDE_A,
                             i->f.g & C205_G_NEGATE_A)
                      : word;
}

static c205_word element_b(struct insn *i, int64_t n)
{
    bool controlled = i->row->flags & C205_INSN_SIGN;
    c205_word word;
    if (i->handed_b)
        word = *i->handed;
    else if (i->f.g & C205_G_BROADCAST_B
             || i->row->format == C205_FORMAT_SCALARS)
        word = scalar(i, i->f.b);
    else if (n < i->b.length)
        word = *place(i->o, i->b.address + (uint64_t)n * 64);
    else
        return padding(i->row);
    return controlled ? sign(word, i->f.g & C205_G_MAGNITUDE_B, false) : word;
}

static bool one_of_z(struct insn *i, int64_t n)
{
    return bit(i->o, i->z.address + (uint64_t)n) != !!(i->f.g & C205_G_ZEROS);
}

static bool permitted(struct insn *i, int64_t n)
{
    return !i->f.z || one_of_z(i, n);
}

static void store(struct insn *i, int64_t n, c205_word word,
                  const uint64_t *flags)
{
    c205_word *to = place(i->o, i->c.address + (uint64_t)n * 64);
    if (permitted(i, n)) {
        *to = word;
        i->o->flags |= flags ? *flags : 0;
    }
}

static void store_answer(struct insn *i, int64_t n, bool answer)
{
    uint64_t address = i->c.address + (uint64_t)n;
    place(i->o, address);
    if (permitted(i, n))
        set_bit(i->o, address, answer);
}

/* ---- What each instruction does with element n -------------------------- */

typedef c205_word two(c205_word a, c205_word b, uint64_t *flags);
typedef c205_word one(c205_word a, uint64_t *flags);
typedef bool relation(c205_word a, c205_word b);

static c205_word copy(c205_word a, uint64_t *flags)
{
    (void)flags;
    return a;
}

static c205_word and_not(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return a & ~b;
}

static c205_word add_index(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return (a & ~UINT64_C(0xFFFFFFFFFFFF)) | ((a + b) & 0xFFFFFFFFFFFF);
}

static const struct {
    const char *name;
    one *one;
    two *two;
    relation *relation;
} simple[] = { { "ADDNV", NULL, arith_add_normalised, NULL },
               { "SUBLV", NULL, arith_subtract_lower, NULL },
               { "MPYSV", NULL, arith_multiply_significant, NULL },
               { "DIVUV", NULL, arith_divide_upper, NULL },
               { "ADJSV", NULL, arith_adjust_significance, NULL },
               { "ADJEV", NULL, arith_adjust_exponent, NULL },
               { "PACKV", NULL, arith_pack, NULL },
               { "ADDXV", NULL, add_index, NULL },
               { "AVGDV", NULL, arith_average_difference, NULL },
               { "SHIFTV", NULL, arith_shift, NULL },
               { "ANDNV", NULL, and_not, NULL },
               { "VTOV", copy, NULL, NULL },
               { "SQRTV", arith_square_root, NULL, NULL },
               { "FLRV", arith_floor, NULL, NULL },
               { "CLGV", arith_ceiling, NULL, NULL },
               { "CMPGEV", NULL, NULL, arith_not_less },
               { "CMPNEV", NULL, NULL, arith_not_equal },
               { "SELLTV", NULL, NULL, arith_less },
               { "SELEQV", NULL, NULL, arith_equal },
               { "SUBUS", NULL, arith_subtract_upper, NULL },
               { "ADDNS", NULL, arith_add_normalised, NULL },
               { "MPYSS", NULL, arith_multiply_significant, NULL },
               { "DIVUS", NULL, arith_divide_upper, NULL },
               { "SCHEQV", NULL, NULL, arith_equal },
               { "SCHGEV", NULL, NULL, arith_not_less } };
enum { SIMPLE = sizeof simple / sizeof simple[0] };

static void do_simple(struct insn *i, size_t which)
{
    for (int64_t n = 0; n < i->c.length; n++) {
        uint64_t flags = 0;
        c205_word a = element_a(i, n);
        if (simple[which].one)
            store(i, n, simple[which].one(a, &flags), &flags);
        else if (simple[which].two)
            store(i, n, simple[which].two(a, element_b(i, n), &flags),
                  &flags);
        else
            store_answer(i, n, simple[which].relation(a, element_b(i, n)));
    }
}

/* The length of what is reduced. */
static int64_t source_length(struct insn *i)
{
    bool b = i->row->format != C205_FORMAT_REDUCE
             && !(i->f.g & C205_G_BROADCAST_B);
    if (!(i->f.g & C205_G_BROADCAST_A))
        return i->a.length;
    i->o->trap = i->o->trap || !b;
    return b ? i->b.length : 0;
}

static void do_select(struct insn *i, size_t which)
{
    int64_t length = source_length(i), found = length;
    for (int64_t n = 0; n < length; n++) {
        c205_word a = element_a(i, n), b = element_b(i, n);
        if (permitted(i, n) && found == length
            && simple[which].relation(a, b))
            found = n;
    }
    i->o->reg[i->f.c] = (c205_word)found;
}

static void do_reduction(struct insn *i)
{
    char kind = i->row->mnemonic[0]; /* Sum, Product, Dot */
    c205_word result = kind == 'P' ? C205_ONE : C205_MACHINE_ZERO;
    int64_t length = source_length(i);
    for (int64_t n = 0; n < length; n++) {
        c205_word a = element_a(i, n), b = 0;
        uint64_t *flags = &i->o->flags;
        if (kind == 'D')
            b = element_b(i, n);
        if (!permitted(i, n))
            continue;
        if (kind == 'D')
            a = arith_multiply_significant(a, b, flags);
        result = kind == 'P' ? arith_multiply_significant(result, a, flags)
                             : arith_add_normalised(result, a, flags);
    }
    i->o->reg[i->f.c] = result;
}

static void do_extreme(struct insn *i)
{
    bool greatest = i->row->opcode == 0xD8, found = false;
    c205_word best = C205_INDEFINITE;
    int64_t length = source_length(i), index = length;
    for (int64_t n = 0; n < length; n++) {
        c205_word a = element_a(i, n);
        if (!permitted(i, n) || (found && word_is_indefinite(best)))
            continue;
        if (found && !word_is_indefinite(a)
            && !(greatest ? arith_less(best, a) : arith_less(a, best)))
            continue;
        found = true;
        best = a;
        index = n;
    }
    if (word_is_indefinite(best))
        i->o->flags |= FLAG_INDEFINITE;
    if (word_is_machine_zero(best))
        i->o->flags |= FLAG_MACHINE_ZERO;
    i->o->reg[i->f.c] = best;
    i->o->reg[i->f.c + 1] = (c205_word)index;
}

static void do_delta(struct insn *i)
{
    for (int64_t n = 0; n < i->c.length; n++) {
        uint64_t flags = 0;
        c205_word a = element_a(i, n), next = element_a(i, n + 1);
        store(i, n, arith_subtract_normalised(next, a, &flags), &flags);
    }
}

static void do_adjacent_mean(struct insn *i)
{
    for (int64_t n = 0; n < i->c.length; n++) {
        uint64_t flags = 0;
        c205_word a = element_a(i, n), next = element_a(i, n + 1);
        store(i, n, arith_average(next, a, &flags), &flags);
    }
}

static void do_polynomial(struct insn *i)
{
    for (int64_t n = 0; n < i->c.length; n++) {
        c205_word a = element_a(i, n), value = C205_MACHINE_ZERO;
        uint64_t flags = 0;
        for (int64_t k = 0; k < i->b.length; k++) {
            c205_word b = element_b(i, k);
            value = arith_multiply_significant(value, a, &flags);
            value = arith_add_normalised(value, b, &flags);
            flags = k == 0 ? 0 : flags;
            value = k == 0 ? b : value;
        }
        store(i, n, value, &flags);
    }
}

/* Order vectors are read before and stored after all elements. */
static void do_sparse(struct insn *i, size_t which)
{
    bool both = i->row->flags & C205_INSN_PADO;
    struct operand x = operand_of(i->o, i->f.x, 0, 1);
    struct operand y = operand_of(i->o, i->f.y, 0, 1);
    int64_t n = x.length > y.length ? x.length : y.length;
    int64_t next_a = 0, next_b = 0, kept = 0;
    bool in_a[C205_MAX_LENGTH], in_b[C205_MAX_LENGTH];
    for (int64_t k = 0; k < n; k++) {
        in_a[k] = k < x.length && bit(i->o, x.address + (uint64_t)k);
        in_b[k] = k < y.length && bit(i->o, y.address + (uint64_t)k);
    }
    i->f.z = 0;
    for (int64_t k = 0; k < n; k++) {
        uint64_t flags = 0;
        c205_word a = in_a[k] ? element_a(i, next_a++) : C205_MACHINE_ZERO;
        c205_word b = in_b[k] ? element_b(i, next_b++) : C205_MACHINE_ZERO;
        if (both ? in_a[k] && in_b[k] : in_a[k] || in_b[k])
            store(i, kept++, simple[which].two(a, b, &flags), &flags);
    }
    for (int64_t k = 0; k < n; k++)
        set_bit(i->o, i->z.address + (uint64_t)k,
                both ? in_a[k] && in_b[k] : in_a[k] || in_b[k]);
    i->o->reg[i->f.c] = descriptor(i->o->reg[i->f.c] & 0xFFFFFFFFFFFF,
                                   (size_t)kept);
    i->o->reg[i->order] = descriptor(i->o->reg[i->order] & 0xFFFFFFFFFFFF,
                                     (size_t)n);
}

static void do_search(struct insn *i, size_t which)
{
    for (int64_t n = 0; n < i->c.length; n++) {
        c205_word a = element_a(i, n);
        int64_t found = 0;
        while (found < i->b.length
               && !simple[which].relation(a, element_b(i, found)))
            found++;
        store(i, n, (c205_word)found, NULL);
    }
}

static void do_interval(struct insn *i)
{
    c205_word value = element_a(i, 0), step = element_b(i, 0);
    uint64_t flags = 0;
    for (int64_t n = 0; n < i->c.length; n++) {
        store(i, n, value, &flags);
        flags = 0;
        value = arith_add_upper(value, step, &flags);
    }
}

static void do_reverse(struct insn *i)
{
    for (int64_t n = 0; n < i->c.length; n++)
        store(i, n, element_a(i, i->c.length - 1 - n), NULL);
}

static void do_mask(struct insn *i)
{
    for (int64_t n = 0; n < i->c.length; n++) {
        c205_word a = element_a(i, n), b = element_b(i, n);
        *place(i->o, i->c.address + (uint64_t)n * 64) = one_of_z(i, n) ? a
                                                                       : b;
    }
}

static void do_merge(struct insn *i)
{
    int64_t next_a = 0, next_b = 0;
    for (int64_t n = 0; n < i->c.length; n++) {
        c205_word word = one_of_z(i, n) ? element_a(i, next_a++)
                                        : element_b(i, next_b++);
        *place(i->o, i->c.address + (uint64_t)n * 64) = word;
    }
}

static void do_compress(struct insn *i)
{
    bool arithmetic = i->row->opcode == 0xCF;
    int64_t kept = 0, n, length = arithmetic ? source_length(i) : i->z.length;
    for (n = 0; n < length; n++) {
        c205_word a = element_a(i, n);
        bool keep = arithmetic ? arith_not_less(a, element_b(i, n))
                               : one_of_z(i, n);
        if (keep)
            *place(i->o, i->c.address + (uint64_t)kept++ * 64) = a;
        if (arithmetic)
            set_bit(i->o, i->z.address + (uint64_t)n, keep);
    }
    i->o->reg[i->f.c] = descriptor(i->o->reg[i->f.c] & 0xFFFFFFFFFFFF,
                                   (size_t)kept);
}

static void do_gather(struct insn *i)
{
    uint64_t base = i->o->reg[i->f.b];
    int64_t length = i->a.length < i->c.length ? i->a.length : i->c.length;
    for (int64_t n = 0; n < length; n++) {
        c205_word index = element_a(i, n);
        bool wanted = permitted(i, n);
        store(i, n, wanted ? *place(i->o, base + index * 64) : 0, NULL);
    }
}

static void do_scatter(struct insn *i)
{
    uint64_t base = i->o->reg[i->f.c];
    for (int64_t n = 0; n < i->a.length; n++) {
        c205_word index = element_a(i, n), word = element_b(i, n);
        if (permitted(i, n))
            *place(i->o, base + index * 64) = word;
    }
}

static bool bit_a(struct insn *i, int64_t n)
{
    return n < i->a.length && bit(i->o, i->a.address + (uint64_t)n);
}

static bool bit_b(struct insn *i, int64_t n)
{
    return n < i->b.length && bit(i->o, i->b.address + (uint64_t)n);
}

static void do_strings(struct insn *i)
{
    for (int64_t n = 0; n < i->c.length; n++)
        set_bit(i->o, i->c.address + (uint64_t)n,
                bit_a(i, n) && !bit_b(i, n));
}

static void do_mask_bits(struct insn *i)
{
    for (int64_t n = 0; n < i->c.length; n++)
        set_bit(i->o, i->c.address + (uint64_t)n,
                one_of_z(i, n) ? bit_a(i, n) : bit_b(i, n));
}

static void do_merge_bits(struct insn *i)
{
    int64_t next_a = 0, next_b = 0;
    for (int64_t n = 0; n < i->c.length; n++)
        set_bit(i->o, i->c.address + (uint64_t)n,
                one_of_z(i, n) ? bit_a(i, next_a++) : bit_b(i, next_b++));
}

static void do_compress_bits(struct insn *i)
{
    int64_t kept = 0;
    for (int64_t n = 0; n < i->z.length; n++) {
        bool a = bit_a(i, n);
        if (one_of_z(i, n))
            set_bit(i->o, i->c.address + (uint64_t)kept++, a);
    }
    i->o->reg[i->f.c] = descriptor(i->o->reg[i->f.c] & 0xFFFFFFFFFFFF,
                                   (size_t)kept);
}

static const struct {
    const char *name;
    void (*go)(struct insn *i);
} special[] = { { "SUMV", do_reduction },      { "PRODV", do_reduction },
                { "DOTV", do_reduction },      { "MAXV", do_extreme },
                { "MINV", do_extreme },        { "DELTAV", do_delta },
                { "ADJMV", do_adjacent_mean }, { "POLYV", do_polynomial },
                { "INTVLV", do_interval },     { "VREVV", do_reverse },
                { "MASKV", do_mask },          { "MRGV", do_merge },
                { "CPSV", do_compress },       { "ACPSV", do_compress },
                { "VXTOV", do_gather },        { "VTOVX", do_scatter },
                { "ANDNB", do_strings },       { "MASKB", do_mask_bits },
                { "MRGB", do_merge_bits },     { "CPSB", do_compress_bits } };
enum { SPECIAL = sizeof special / sizeof special[0] };

static bool is_string(const c205_insn *row)
{
    return row->format == C205_FORMAT_STRING
           || row->format == C205_FORMAT_SELECTEDB
           || row->format == C205_FORMAT_SQUEEZEB;
}

static struct insn describe(struct other *o, const c205_insn *row,
                            c205_fields f)
{
    struct insn i;
    const char *syntax = c205_format_syntax(row->format);
    bool strings = is_string(row);
    int64_t width = strings ? 1 : 64, offset = 0;
    char letter = row->operands[strcspn(row->operands, "deqco")];
    memset(&i, 0, sizeof i);
    i.o = o;
    i.row = row;
    i.f = f;
    if (f.g & C205_G_OFFSET)
        offset = c205_to_integer(o->reg[f.c + 1]);
    i.order = f.z;
    if (row->format == C205_FORMAT_SPARSE) /* X and Y are order vectors */
        f.x = f.y = 0;
    i.a = operand_of(o, f.a, c205_to_integer(o->reg[f.x]), width);
    i.b = operand_of(o, f.b, c205_to_integer(o->reg[f.y]), width);
    i.z = operand_of(o, f.z, offset, 1);
    i.c = operand_of(o, f.c, offset, letter == 'e' ? 1 : width);
    if (!strchr(syntax, 'b') && !strchr(syntax, 'B'))
        i.b.length = 0;
    return i;
}

static void perform(struct other *o, const c205_insn *row, c205_fields f)
{
    struct insn i = describe(o, row, f);
    for (size_t n = 0; n < SIMPLE; n++)
        if (strcmp(simple[n].name, row->mnemonic) == 0) {
            if (row->format == C205_FORMAT_REDUCE2)
                do_select(&i, n);
            else if (row->format == C205_FORMAT_SPARSE)
                do_sparse(&i, n);
            else if (row->format == C205_FORMAT_SCAN)
                do_search(&i, n);
            else
                do_simple(&i, n);
        }
    for (size_t n = 0; n < SPECIAL; n++)
        if (strcmp(special[n].name, row->mnemonic) == 0)
            special[n].go(&i);
}

/* The second takes what the first makes of the same element. */
static void perform_pair(struct other *o, const c205_insn *const *rows,
                         const c205_fields *f, const size_t *which)
{
    struct insn first = describe(o, rows[0], f[0]);
    struct insn second = describe(o, rows[1], f[1]);
    c205_word handed;
    second.handed = &handed;
    second.handed_a = f[1].a == f[0].c;
    second.handed_b = f[1].b == f[0].c;
    for (int64_t n = 0; n < second.c.length; n++) {
        uint64_t flags = 0;
        c205_word a = element_a(&first, n), b = element_b(&first, n), word;
        handed = simple[which[0]].two(a, b, &o->flags);
        a = element_a(&second, n);
        word = simple[which[1]].two(a, element_b(&second, n), &flags);
        store(&second, n, word, &flags);
    }
}

#endif
