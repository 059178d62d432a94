/* reference_branch.c - branches and the monitor. */
#include "reference_parts.h"

#include <limits.h>
#include <string.h>

/* ---- Branches ---------------------------------------------------------- */

enum relation { LESS = 1, EQUAL = 2, GREATER = 4, UNORDERED = 8 };

/* Returns the relations on which an instruction branches, by the end of its name. */
static unsigned branches_on(const c205_insn *insn)
{
    static const struct {
        char ending[3];
        unsigned relations;
    } rows[] = { { "EQ", EQUAL },   { "GE", GREATER | EQUAL },
                 { "LT", LESS },    { "LE", LESS | EQUAL },
                 { "GT", GREATER }, { "NE", LESS | GREATER | UNORDERED } };
    const char *ending = insn->mnemonic + strlen(insn->mnemonic) - 2;
    size_t i = 0;
    while (strcmp(rows[i].ending, ending) != 0)
        i++;
    return rows[i].relations;
}

static enum relation compare_integers(int64_t a, int64_t b)
{
    return a < b ? LESS : a > b ? GREATER : EQUAL;
}

static enum relation compare_numbers(const struct oracle_format *format, c205_word a,
                                     c205_word b)
{
    uint64_t flags = 0;
    if (oracle_less(format, a, b, &flags))
        return LESS;
    if (oracle_equal(format, a, b, &flags))
        return EQUAL;
    return oracle_not_less(format, a, b, &flags) ? GREATER : UNORDERED;
}

static void go_to(struct reference *reference, uint64_t target, bool taken)
{
    target = plain_address(target);
    if (target % HALF_BITS != 0)
        add_fault(reference, C205_TRAP_MISALIGNED_OPERAND, target, taken);
    if (!taken)
        return;
    reference->deed.taken = true;
    reference->deed.target = target;
    reference->now.pc = target;
}

/* Returns the target of a 64-bit branch: relative to the branch, or (Y) + (B). */
static uint64_t long_target(const struct reference *reference,
                            const c205_fields *fields)
{
    if (fields->g & C205_G_RELATIVE)
        return reference->deed.pc + HALF_BITS * (uint64_t)fields->immediate;
    return read_bits(reference, fields->y) + read_bits(reference, fields->b);
}

static void branch_on_index(struct reference *reference, const c205_insn *insn,
                            const c205_fields *fields)
{
    c205_word a = read_bits(reference, fields->a);
    c205_word sum = (a + read_bits(reference, fields->x)) & LOW_48;
    c205_word limit = read_bits(reference, fields->z);
    uint64_t target = long_target(reference, fields);
    enum relation found = compare_integers(as_integer(sum), as_integer(limit));
    write_register(reference, fields->c, sum);
    go_to(reference, target, branches_on(insn) & (unsigned)found);
}

static void branch_on_numbers(struct reference *reference, const c205_insn *insn,
                              unsigned a, unsigned b, uint64_t target)
{
    char letter = insn->operands[0];
    enum relation found = compare_numbers(format_of(width_of_letter(letter)),
                                          read_operand(reference, letter, a),
                                          read_operand(reference, letter, b));
    go_to(reference, target, branches_on(insn) & (unsigned)found);
}

static void count_and_branch(struct reference *reference, const c205_fields *fields,
                             uint64_t step, uint64_t target)
{
    c205_word r = read_bits(reference, fields->r);
    c205_word count = with_low(r, r + step);
    write_register(reference, fields->r, count);
    go_to(reference, target, (count & LOW_48) != 0);
}

/* ---- Branches on one bit, which they alter ----------------------------- */

enum alteration { LEAVE, CHANGE, MAKE_ZERO, MAKE_ONE };

/* I4 is 4 x condition + alteration. The conditions are never, always, one and zero. */
static bool holds(int64_t i4, bool bit)
{
    const bool answers[] = { false, true, bit, !bit };
    return answers[i4 >> 2];
}

static bool altered(int64_t i4, bool bit)
{
    const bool answers[] = { bit, !bit, false, true };
    return answers[i4 & 3];
}

/* Returns the altered word. If the bit meets the condition, branches to C. Only the low
 * 6 bits of the bit's number are used. */
static c205_word branch_on_bit(struct reference *reference, const c205_fields *fields,
                               c205_word word, c205_word number)
{
    uint64_t mask = UINT64_C(1) << (BITS - 1 - number % BITS);
    bool bit = word & mask;
    go_to(reference, read_bits(reference, fields->c), holds(fields->immediate, bit));
    return altered(fields->immediate, bit) ? word | mask : word & ~mask;
}

static void branch_on_memory(struct reference *reference, const c205_fields *fields)
{
    uint64_t address = plain_address(read_bits(reference, fields->a)
                                     + read_bits(reference, fields->b));
    bool bit = read_memory(reference, address, BIT);
    add_extent(reference, address, 1);
    go_to(reference, read_bits(reference, fields->c), holds(fields->immediate, bit));
    if ((fields->immediate & 3) != LEAVE)
        write_memory(reference, address, BIT, altered(fields->immediate, bit));
}

static void branch_on_one_bit(struct reference *reference, const c205_insn *insn,
                              const c205_fields *fields)
{
    c205_word a = read_bits(reference, fields->a);
    if (reference_which(insn) == DO_BAB)
        branch_on_memory(reference, fields);
    else if (reference_which(insn) == DO_BADF)
        reference->now.flags = branch_on_bit(reference, fields, reference->now.flags,
                                             a);
    else
        write_register(reference, fields->a,
                       branch_on_bit(reference, fields, a,
                                     read_bits(reference, fields->b)));
}

enum request { END, PRINT_TEXT = 4, PRINT_NUMBERS = 6, PRINT_BITS = 7, REQUESTS };

/* Reads the memory that the monitor prints. It must be mapped. */
static void look_at(struct reference *reference, c205_word descriptor, int64_t request)
{
    for (uint64_t i = 0; i < length_of(descriptor); i++)
        if (request == PRINT_TEXT)
            read_memory(reference, descriptor + CHAR_BIT * i, CHAR_BIT);
        else if (request == PRINT_NUMBERS)
            read_memory(reference, descriptor + BITS * i, BITS);
        else if (request == PRINT_BITS)
            read_memory(reference, descriptor + i, BIT);
}

static void ask_monitor(struct reference *reference, const c205_fields *fields)
{
    c205_word r = read_bits(reference, fields->r);
    if (fields->immediate >= REQUESTS)
        add_fault(reference, C205_TRAP_BAD_REQUEST, 0, true);
    look_at(reference, r, fields->immediate);
    reference->ended = fields->immediate == END;
    reference->status = as_integer(r);
}

void do_branch(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields)
{
    uint64_t t = read_bits(reference, fields->t);
    uint64_t called = t + HALF_BITS * read_bits(reference, fields->s);
    switch (reference_which(insn)) {
    case DO_IBNZ: count_and_branch(reference, fields, 1, called); break;
    case DO_DBNZ: count_and_branch(reference, fields, (uint64_t)-1, called); break;
    case DO_BSAVE:
        write_register(reference, fields->r, reference->now.pc);
        go_to(reference, called, true);
        break;
    case DO_BIM:
        go_to(reference, (uint64_t)fields->immediate + read_bits(reference, fields->r),
              true);
        break;
    case DO_BARB:
    case DO_BAB:
    case DO_BADF: branch_on_one_bit(reference, insn, fields); break;
    case DO_EXIT: ask_monitor(reference, fields); break;
    default:
        if (insn->format == C205_FORMAT_COMPARE)
            branch_on_numbers(reference, insn, fields->r, fields->s, t);
        else if (insn->format == C205_FORMAT_FLOAT)
            branch_on_numbers(reference, insn, fields->a, fields->z,
                              long_target(reference, fields));
        else
            branch_on_index(reference, insn, fields);
    }
}
