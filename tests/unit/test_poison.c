/* test_poison.c - memory, registers, flags and clocks after vector instructions are
 * compared between two runs with different contents outside of the operands. Every row
 * of the instruction table is run with random operands. An instruction that reads or
 * writes beyond its operands fails here.
 *
 *   test_poison [CASES]
 *
 * The contents outside of the operands are called poison. They are:
 *
 * - words before, between and after the operands;
 * - elements after the lengths, and elements that the control vector suppresses;
 * - the rest of the last word of a bit vector;
 * - unused parts of registers;
 * - the old contents of the result.
 *
 * All poison outside of the result must stay unchanged. Results, data flags and clocks
 * must be the same in both runs.
 */
#include "tests/unit/vector_case.h"

enum { TWICE = 2, DEFAULT_CASES = 60 };

static size_t cases = DEFAULT_CASES;

/* The contents of the machine before or after a run. */
struct image {
    c205_word memory[MEMORY_WORDS], reg[C205_REGISTERS];
    c205_word flags;
    uint64_t clock;
};

/* ---- Elements that an instruction uses --------------------------------- */

/* Returns the number of elements of an order vector before position i. */
static size_t present_before(const struct vector_case *one, enum role role, size_t i)
{
    size_t count = 0;
    for (size_t k = 0; k < i; k++)
        count += bit_of(one, role, k);
    return count;
}

/* Returns true if element i of the result exists. With Z, its bit of Z must be one.
 * Without Z, products need both operands, and sums need one. */
static bool has_result(const struct vector_case *one, size_t i)
{
    bool x = bit_of(one, ROLE_X, i), y = bit_of(one, ROLE_Y, i);
    if (is_given(one))
        return bit_of(one, ROLE_Z, i);
    return one->row->flags & C205_INSN_PADO ? x && y : x || y;
}

static void mark_packed(struct vector_case *one, enum role packed, enum role order,
                        size_t i)
{
    mark_element(&one->defined, &one->vector[order], i);
    if (bit_of(one, order, i) && has_result(one, i))
        mark_element(&one->defined, &one->vector[packed],
                     present_before(one, order, i));
}

static void mark_sparse(struct vector_case *one)
{
    for (size_t i = 0; i < one->n; i++) {
        mark_packed(one, ROLE_A, ROLE_X, i);
        mark_packed(one, ROLE_B, ROLE_Y, i);
        if (is_given(one))
            mark_element(&one->defined, &one->vector[ROLE_Z], i);
    }
}

/* Returns true if Z selects element i of A, or of B. */
static bool is_selected(const struct vector_case *one, enum role role, size_t i)
{
    bool ones = role == ROLE_A;
    if (is_row_of(one->row, "MRGV MRGB"))
        return i < count_chosen(one, ones);
    return is_chosen(one, i) == ones;
}

static bool is_used(const struct vector_case *one, enum role role, size_t i)
{
    if (role == ROLE_B && one->row->format == C205_FORMAT_SCAN)
        return true;
    if (is_row_of(one->row, "DELTAV ADJMV"))
        return (i < one->n && is_permitted(one, i))
               || (i > 0 && i - 1 < one->n && is_permitted(one, i - 1));
    if (i >= one->n)
        return false;
    if (is_row_of(one->row, "VREVV"))
        return is_permitted(one, one->n - 1 - i);
    if (z_selects(one->row))
        return is_selected(one, role, i);
    return is_permitted(one, i);
}

static void mark_source(struct vector_case *one, enum role role)
{
    if (!one->scalar[role])
        for (size_t i = 0; i < one->vector[role].length; i++)
            if (is_used(one, role, i))
                mark_element(&one->defined, &one->vector[role], i);
}

static void mark_table(struct vector_case *one, struct bits_of *bits)
{
    unsigned width = one->vector[table_of(one->row)].width;
    for (size_t i = 0; i < one->n; i++)
        if (is_permitted(one, i))
            mark(bits, indexed(one, i), width);
}

static bool scatters(const c205_insn *row)
{
    return has_indices(row) && table_of(row) == ROLE_C;
}

static void mark_sources(struct vector_case *one)
{
    if (has_control(one))
        mark(&one->defined, one->vector[ROLE_Z].address, one->n);
    if (one->row->format == C205_FORMAT_SPARSE) {
        mark_sparse(one);
        return;
    }
    mark_source(one, ROLE_A);
    if (has_indices(one->row) && !scatters(one->row))
        mark_table(one, &one->defined);
    else
        mark_source(one, ROLE_B);
}

/* ---- Stored elements --------------------------------------------------- */

static void mark_result(struct vector_case *one, const struct image *after)
{
    const struct extent_of *c = &one->vector[ROLE_C];
    c205_word set = after->reg[role_register[ROLE_C]] >> 48;
    bool counted = strchr("co", letter_of(one->row, ROLE_C));
    if (scatters(one->row))
        mark_table(one, &one->written);
    else if (counted)
        mark(&one->written, c->address, set * c->width);
    else
        for (size_t i = 0; i < one->n; i++)
            if (is_permitted(one, i))
                mark_element(&one->written, c, i);
    if (letter_of(one->row, ROLE_Z) && !has_control(one) && !is_given(one)
        && letter_of(one->row, ROLE_Z) != 'z')
        mark(&one->written, one->vector[ROLE_Z].address, one->n);
}

static void mark_number(struct vector_case *one, enum role role, unsigned behind)
{
    c205_word *reg = one->written.reg;
    unsigned number = register_name(one, role) + behind;
    if (is_half(one, role))
        reg[number / 2] |= number % 2 ? UINT32_MAX : (c205_word)UINT32_MAX << HALF;
    else
        reg[number] = UINT64_MAX;
}

static void mark_registers(struct vector_case *one)
{
    for (int role = ROLE_A; role < ROLES; role++) {
        char letter = letter_of(one->row, (enum role)role);
        if (!letter)
            continue;
        if (strchr("wpk", letter))
            mark_number(one, (enum role)role, 0);
        if (letter == 'p')
            mark_number(one, (enum role)role, 1);
        if (strchr("co", letter) || (letter == 'g' && !is_given(one)))
            one->written.reg[role_register[role]] = ~ADDRESS_BITS;
    }
}

/* ---- Running ----------------------------------------------------------- */

static c205_word poison(uint64_t *random)
{
    static const c205_word kinds[] = { C205_INDEFINITE, C205_MACHINE_ZERO, UINT64_MAX,
                                       0, UINT64_C(0x6FFF7FFFFFFFFFFF) };
    size_t kind = draw(random, 0, 9);
    return kind < 5 ? kinds[kind] : random_bits(random);
}

static void poison_words(c205_word *words, const c205_word *good,
                         const c205_word *defined, size_t count, uint64_t *random)
{
    for (size_t i = 0; i < count; i++)
        words[i] = (good[i] & defined[i]) | (poison(random) & ~defined[i]);
}

static void run_image(struct small_machine *fixture, const char *name,
                      const struct image *before, struct image *after)
{
    load(fixture, MEMORY_WORDS);
    assert_true(c205_write(fixture->machine, DATA, before->memory, MEMORY_WORDS));
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        set(fixture, i, before->reg[i]);
    c205_stop stop = run(fixture);
    FAIL_IF(stop.trap != C205_TRAP_NONE, "%s: trap %s", name,
            c205_trap_name(stop.trap));
    assert_true(c205_read(fixture->machine, DATA, after->memory, MEMORY_WORDS));
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        after->reg[i] = get(fixture, i);
    after->flags = c205_data_flags(fixture->machine);
    after->clock = c205_clock(fixture->machine);
}

/* ---- Comparing --------------------------------------------------------- */

static void check_words(const char *name, const char *what, const c205_word *a,
                        const c205_word *b, const c205_word *bits, c205_word flip,
                        size_t count)
{
    for (size_t i = 0; i < count; i++)
        FAIL_IF((a[i] ^ b[i]) & (bits[i] ^ flip),
                "%s: %s %zu: %016llX and %016llX, of which %016llX", name, what, i,
                (unsigned long long)a[i], (unsigned long long)b[i],
                (unsigned long long)(bits[i] ^ flip));
}

/* Compares two images of memory and registers: the written bits, or the others. */
static void check_contents(const char *name, const struct image *a,
                           const struct image *b, const struct bits_of *written,
                           bool outside)
{
    c205_word flip = outside ? UINT64_MAX : 0;
    check_words(name, outside ? "changed word" : "unlike word", a->memory, b->memory,
                written->memory, flip, MEMORY_WORDS);
    check_words(name, outside ? "changed register" : "unlike register", a->reg, b->reg,
                written->reg, flip, C205_REGISTERS);
}

static void run_twice(struct small_machine *fixture, struct vector_case *one,
                      uint64_t *random, struct image *before, struct image *after)
{
    for (int i = 0; i < TWICE; i++) {
        poison_words(before[i].memory, one->memory, one->defined.memory, MEMORY_WORDS,
                     random);
        poison_words(before[i].reg, one->reg, one->defined.reg, C205_REGISTERS, random);
        before[i].reg[0] = 0;
        run_image(fixture, one->row->mnemonic, &before[i], &after[i]);
    }
}

/* Returns false if the time depends on suppressed elements. A control vector saves no
 * time, because a search continues over suppressed elements. */
static bool time_is_known(const struct vector_case *one)
{
    return !(one->row->format == C205_FORMAT_SCAN && one->fields.z
             && is_row_of(one->row, "SCHEQV SCHNEV SCHGEV SCHLTV"));
}

static void check_images(struct vector_case *one, const struct image *before,
                         const struct image *after)
{
    const char *name = one->row->mnemonic;
    const struct image *a = &after[0], *b = &after[1];
    for (int i = 0; i < TWICE; i++)
        check_contents(name, &before[i], &after[i], &one->written, true);
    check_contents(name, a, b, &one->written, false);
    FAIL_IF(a->flags != b->flags || (time_is_known(one) && a->clock != b->clock),
            "%s: flags %llX and %llX, clocks %llu and %llu", name,
            (unsigned long long)a->flags, (unsigned long long)b->flags,
            (unsigned long long)a->clock, (unsigned long long)b->clock);
}

/* ---- The tests --------------------------------------------------------- */

static struct vector_case one, other;
static struct image before[TWICE], after[TWICE];

static void try_row(struct small_machine *fixture, const c205_insn *row,
                    uint64_t *random)
{
    draw_case(&one, row, random, draw_size(random));
    mark_sources(&one);
    begin(fixture);
    add(fixture, row->mnemonic, one.fields);
    add(fixture, "EXIT", (c205_fields){ .r = 0 });
    run_twice(fixture, &one, random, before, after);
    mark_registers(&one);
    if (!one.scalar[ROLE_C])
        mark_result(&one, &after[0]);
    check_images(&one, before, after);
}

TEST(rows)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    uint64_t random = 1205;
    for (size_t i = 0; i < c205_insn_count; i++)
        if (c205_unit_is_vector(c205_insns[i].unit)
            && c205_insns[i].format != C205_FORMAT_NONE)
            for (size_t k = 0; k < cases; k++)
                try_row(&fixture, &c205_insns[i], &random);
}

/* ---- Linked pairs ------------------------------------------------------ */

static const c205_insn *draw_linked(uint64_t *random)
{
    const c205_insn *row;
    do
        row = c205_insns + draw(random, 0, c205_insn_count - 1);
    while (!c205_unit_links(row->unit));
    return row;
}

/* Chooses a row of another unit whose result has words. */
static const c205_insn *draw_first(uint64_t *random, c205_unit second)
{
    const c205_insn *row;
    do
        row = draw_linked(random);
    while (row->unit == second || row->timing == C205_TIMING_vcompare);
    return row;
}

/* Returns the fields of the first instruction, on [x] and perhaps a number. */
static c205_fields first_fields(const c205_insn *row, unsigned half)
{
    c205_fields fields = { .g = (uint8_t)(row->subop | half),
                           .a = role_register[ROLE_X],
                           .c = role_register[ROLE_A] };
    if (letter_of(row, ROLE_B)) {
        fields.g |= C205_G_BROADCAST_B;
        fields.b = half ? role_half[ROLE_Y] : role_register[ROLE_Y];
    }
    return fields;
}

/* The result of the first instruction is operand A of the second, not stored. */
static void draw_pair(uint64_t *random)
{
    do
        draw_case(&one, draw_linked(random), random, draw_size(random));
    while (one.scalar[ROLE_A] || one.fields.x || one.scalar[ROLE_B]);
    unsigned half = one.fields.g & C205_G_HALF;
    memset(&other, 0, sizeof other);
    other.row = draw_first(random, one.row->unit);
    other.fields = first_fields(other.row, half);
    if (half)
        define_half(&one, role_half[ROLE_Y], draw_half(random));
    else
        define(&one, role_register[ROLE_Y], draw_word(random), UINT64_MAX);
    one.vector[ROLE_A].length = 0;
    one.vector[ROLE_X].width = half ? HALF : WORD;
    one.vector[ROLE_X].address = DATA + ROLE_X * ZONE_WORDS * UINT64_C(64);
    one.vector[ROLE_X].length = source_length(random, one.n);
    define(&one, role_register[ROLE_X],
           descriptor(one.vector[ROLE_X].address, one.vector[ROLE_X].length),
           UINT64_MAX);
    for (size_t i = 0; i < one.vector[ROLE_X].length && i < one.n; i++)
        mark_element(&one.defined, &one.vector[ROLE_X], i);
    define(&one, role_register[ROLE_A], descriptor(one.vector[ROLE_A].address, one.n),
           UINT64_MAX);
}

static void try_pair(struct small_machine *fixture, uint64_t *random)
{
    draw_pair(random);
    mark_sources(&one);
    begin(fixture);
    add(fixture, "LINKV", (c205_fields){ .f = 0 });
    add(fixture, other.row->mnemonic, other.fields);
    add(fixture, one.row->mnemonic, one.fields);
    add(fixture, "EXIT", (c205_fields){ .r = 0 });
    run_twice(fixture, &one, random, before, after);
    mark_result(&one, &after[0]);
    check_images(&one, before, after);
}

TEST(pairs)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    uint64_t random = 2205;
    for (size_t k = 0; k < 4 * cases; k++)
        try_pair(&fixture, &random);
}

ARGUMENTS(argc, argv)
{
    cases = argument(argc, argv, 1, share_of(cases));
}
