/* test_vector.c - states after instructions with vector operands are compared with the
 * reference interpreter, which reads, computes and stores one element after another. A
 * result, flag, trap or page that differs fails here.
 *
 * Each row of the instruction table with such operands is tried with random registers.
 * The operands are close together, so that words, half words and bits overlap in every
 * way and cross a page boundary. Some are in read-only or missing memory, are
 * misaligned, or have an invalid offset. Both machines must then trap and change
 * nothing.
 */
#include "machine_fixture.h"

#include "tests/oracle/operand_letters.h"
#include "tests/unit/prior_model.h"
#include "tests/oracle/operands.h"
#include "tests/oracle/reference.h"

#include <ctype.h>

enum {
    CASES = 600
}; /* cases for each instruction; there are ten times as many
                       * pairs */

/* ---- Memory ------------------------------------------------------------- */

enum { WORD = 64, BEFORE = 100, AFTER = 450 };
#define PAGE (C205_PAGE_WORDS * UINT64_C(64))
#define NOWHERE (DATA + 8 * PAGE)

/* The data is around page boundaries: BEFORE words before and AFTER words after each
 * boundary. The operands of a case are near the first boundary. */
static const struct border {
    uint64_t address;
    size_t words;
} borders[] = {
    { DATA + 1 * PAGE, BEFORE + AFTER }, /* followed by a page with the same access */
    { DATA + 2 * PAGE, BEFORE + AFTER }, /* followed by a read-only page */
    { DATA + 5 * PAGE, BEFORE },         /* followed by an unmapped page */
};
enum { BORDERS = COUNT(borders) };

static uint64_t begin_of(size_t border)
{
    return borders[border].address - BEFORE * WORD;
}

/* ---- Registers ---------------------------------------------------------- */

/* The roles of registers. A result may use two half registers. */
enum {
    OFFSET = 13,
    TABLE,
    NUMBER,                   /* uses two registers */
    HALF_NUMBER = NUMBER + 2, /* uses four half registers, which are in two registers */
    COUNT = HALF_NUMBER + 2,
    RESULT = 50,
    HANDED = 60, /* result of the first instruction of a linked pair */
    FLAGS,
    BLOCK = 70 /* first of a block of registers */
};

/* Vectors in four registers, and in five pairs of a vector and an offset of 0 to 3. */
static const struct pool {
    unsigned width, first, pairs;
} pools[] = { { WORD, 1, 20 }, { HALF_WORD, 5, 30 }, { 1, 9, 40 } };
enum { POOLS = COUNT(pools), SINGLES = 4, PAIRS = 5 };

struct bench {
    struct small_machine fixture;
    struct reference reference;
    uint64_t random;
    c205_word memory[BORDERS][BEFORE + AFTER]; /* expected contents */
    const c205_insn *row;
    c205_fields fields;
};

static uint64_t below(struct bench *bench, uint64_t n)
{
    return random_bits(&bench->random) % n;
}

static bool one_in(struct bench *bench, uint64_t n)
{
    return below(bench, n) == 0;
}

static c205_word draw_half_words(struct bench *bench)
{
    return random_word(&oracle_half, &bench->random)
           | random_word(&oracle_half, &bench->random) >> HALF_WORD;
}

/* The contents of most words in a case. */
enum contents { NUMBERS, HALF_NUMBERS, INDICES };

static c205_word draw_number(struct bench *bench)
{
    switch (below(bench, 8)) {
    case 0: return random_word(&oracle_full, &bench->random);
    case 1: return C205_MACHINE_ZERO;
    case 2: return c205_from_integer((int64_t)below(bench, 7) - 3);
    case 3: return c205_from_double((double)below(bench, 9) - 4);
    default: return below(bench, AFTER - BEFORE);
    }
}

static c205_word draw_word(struct bench *bench, enum contents contents)
{
    if (contents == INDICES && !one_in(bench, 100))
        return below(bench, AFTER - BEFORE);
    if (contents == HALF_NUMBERS && one_in(bench, 2))
        return draw_half_words(bench);
    return draw_number(bench);
}

static void draw_vectors(struct bench *bench, const struct pool *pool, uint64_t begin,
                         uint64_t spread, size_t longest)
{
    c205_word *registers = bench->reference.now.registers;
    uint64_t places = spread * WORD / pool->width;
    for (unsigned i = 0; i < SINGLES; i++)
        registers[pool->first + i] = descriptor(begin
                                                    + below(bench, places)
                                                          * pool->width,
                                                below(bench, longest + 1));
}

static void draw_pairs(struct bench *bench, const struct pool *pool)
{
    c205_word *registers = bench->reference.now.registers;
    for (unsigned i = 0; i < PAIRS; i++) {
        registers[pool->pairs + 2 * i] = registers[pool->first + below(bench, SINGLES)];
        registers[pool->pairs + 2 * i + 1] = below(bench, 4);
    }
}

/* Moves a vector to another boundary, out of memory, or to a misaligned address. */
static void move_away(struct bench *bench, c205_word *vector)
{
    switch (below(bench, 5)) {
    case 0: *vector += NOWHERE - DATA; break;
    case 1: *vector += 1; break;
    default:
        *vector += borders[1 + below(bench, BORDERS - 1)].address - borders[0].address;
    }
}

static void spoil(struct bench *bench)
{
    c205_word *registers = bench->reference.now.registers;
    for (unsigned i = 0; i < POOLS * SINGLES; i++)
        if (one_in(bench, 4))
            move_away(bench, registers + pools[0].first + i);
    if (one_in(bench, 4))
        move_away(bench, registers + TABLE);
    if (one_in(bench, 8))
        registers[OFFSET] = c205_from_integer(-1);
}

static void draw_registers(struct bench *bench, size_t longest)
{
    c205_word *registers = bench->reference.now.registers;
    uint64_t begin = borders[0].address - 60 * WORD + below(bench, 60) * WORD;
    uint64_t spread = one_in(bench, 2) ? 2 : 20;
    for (size_t i = 0; i < POOLS; i++)
        draw_vectors(bench, pools + i, begin, spread, longest);
    registers[OFFSET] = below(bench, 4);
    registers[TABLE] = begin + below(bench, spread) * WORD;
    for (unsigned i = 0; i < 2; i++) {
        registers[NUMBER + i] = draw_number(bench);
        registers[HALF_NUMBER + i] = draw_half_words(bench);
    }
    registers[COUNT] = c205_from_integer((int64_t)below(bench, 18) - 6);
    registers[RESULT] = registers[FLAGS] = 0;
    if (one_in(bench, 10))
        spoil(bench);
    for (size_t i = 0; i < POOLS; i++)
        draw_pairs(bench, pools + i);
}

/* ---- Fields, from the row of the table ----------------------------------- */

static bool has_vectors(const c205_insn *row)
{
    return row->format == C205_FORMAT_SWAP
           || (c205_unit_is_vector(row->unit) && row->format != C205_FORMAT_NONE);
}

static uint64_t draw_vector(struct bench *bench, char letter, bool offset)
{
    unsigned width = strchr("beoz", letter)           ? 1
                     : isupper((unsigned char)letter) ? HALF_WORD
                                                      : WORD;
    const struct pool *pool = pools;
    while (pool->width != width)
        pool++;
    return offset ? pool->pairs + 2 * below(bench, PAIRS)
                  : pool->first + below(bench, SINGLES);
}

static uint64_t draw_scalar(struct bench *bench, char letter, bool half)
{
    if (strchr("wkpWP", letter) && one_in(bench, 10))
        return 0;
    if (strchr("pP", letter)) /* the odd register of two is not a sum */
        return (half ? 2 * RESULT : RESULT) + (uint64_t)one_in(bench, 10);
    if (strchr("wkW", letter))
        return (half ? 2 * RESULT : RESULT) + below(bench, 2);
    if (letter == 'i')
        return COUNT;
    if (one_in(bench, 4))
        return 0;
    return half ? 2 * HALF_NUMBER + below(bench, 4) : NUMBER + below(bench, 2);
}

static uint64_t draw_operand(struct bench *bench, const c205_insn *row, unsigned g,
                             enum role role)
{
    char letter = sized_letter(row, g, role);
    if (row->format == C205_FORMAT_SWAP) /* its operands are vectors, too */
        return role == ROLE_B ? BLOCK + below(bench, C205_REGISTERS - BLOCK)
                              : draw_vector(bench, 'd', false);
    if (is_scalar(row, g, role))
        return draw_scalar(bench, letter, is_half_register(row, g, role));
    if (letter == 'z' && !strstr(c205_format_syntax(row->format), "!Z")
        && one_in(bench, 2))
        return 0;
    return strchr("xX", letter)
               ? TABLE
               : draw_vector(bench, letter,
                             role == ROLE_C && row->format != C205_FORMAT_SPARSE
                                 && g & C205_G_OFFSET);
}

static uint8_t draw_g(struct bench *bench, const c205_insn *row)
{
    unsigned legal = reference_bits_of_g(row) & ~(unsigned)row->subop_mask;
    uint64_t some = random_bits(&bench->random) & random_bits(&bench->random)
                    & ~C205_G_HALF;
    unsigned half = one_in(bench, 2) ? C205_G_HALF : 0;
    return (uint8_t)(row->subop | (((unsigned)some | half) & legal));
}

static uint8_t draw_offset(struct bench *bench, const c205_insn *row, unsigned g,
                           enum role role)
{
    const char *syntax = c205_format_syntax(row->format);
    bool may = role == ROLE_A ? strchr(syntax, 'a') || strstr(syntax, "A+X")
                              : strchr(syntax, 'b') || strstr(syntax, "B+Y");
    return may && !is_scalar(row, g, role) && one_in(bench, 3) ? OFFSET : 0;
}

static c205_fields draw_fields(struct bench *bench, const c205_insn *row)
{
    c205_fields f = { .f = row->opcode };
    if (c205_format_halves(row->format) == 2) {
        f.g = draw_g(bench, row);
        f.x = draw_offset(bench, row, f.g, ROLE_A);
        f.y = draw_offset(bench, row, f.g, ROLE_B);
    }
    for (int role = 0; role < ROLES; role++)
        if (letter_of(row, (enum role)role))
            *field_of_role(&f, row,
                           (enum role)role) = (uint8_t)draw_operand(bench, row, f.g,
                                                                    (enum role)role);
    if (f.z == 0)
        f.g &= (uint8_t)~C205_G_ZEROS;
    return f;
}

/* ---- Both machines, side by side ----------------------------------------- */

static void map(struct bench *bench, uint64_t page, c205_access access)
{
    plain_map(&bench->reference.memory, DATA + page * PAGE, C205_PAGE_WORDS, access);
    FAIL_IF(!c205_map(bench->fixture.machine, DATA + page * PAGE, C205_PAGE_WORDS,
                      access, &failure),
            "%s", failure.message);
}

static void fill(struct bench *bench, size_t border, enum contents contents)
{
    c205_word *words = bench->memory[border];
    for (size_t i = 0; i < borders[border].words; i++) {
        words[i] = draw_word(bench, contents);
        plain_store(&bench->reference.memory, begin_of(border) + i * WORD, words[i]);
    }
    assert_true(c205_write(bench->fixture.machine, begin_of(border), words,
                           borders[border].words));
}

static struct bench *make_bench(void)
{
    struct bench *bench = NON_NULL(calloc(1, sizeof *bench));
    bench->fixture = make_small_machine();
    load(&bench->fixture, 1);
    reference_begin(&bench->reference);
    plain_map(&bench->reference.memory, CODE, CODE_WORDS, C205_READ_WRITE);
    map(bench, 0, C205_READ_WRITE);
    map(bench, 1, C205_READ_WRITE);
    map(bench, 2, C205_READ_ONLY);
    map(bench, 4, C205_READ_WRITE);
    for (size_t i = 0; i < BORDERS; i++)
        fill(bench, i, HALF_NUMBERS);
    return bench;
}

static void free_bench(struct bench *bench)
{
    free_small_machine(&bench->fixture);
    reference_end(&bench->reference);
    free(bench);
}

static void fail_case(const struct bench *bench, const char *what)
{
    const c205_fields *f = &bench->fields;
    fail_msg("%s G %02X X %d A %d Y %d B %d Z %d C %d R %d S %d T %d: %s",
             bench->row->mnemonic, f->g, f->x, f->a, f->y, f->b, f->z, f->c, f->r, f->s,
             f->t, what);
}

/* Returns the word to which the reference stores, or NULL if there are no data. */
static c205_word *place(struct bench *bench, uint64_t address)
{
    for (size_t i = 0; i < BORDERS; i++) {
        uint64_t word = (address - begin_of(i)) / WORD;
        if (word < borders[i].words)
            return bench->memory[i] + word;
    }
    return NULL;
}

static void follow_changes(struct bench *bench)
{
    const struct plain_memory *memory = &bench->reference.memory;
    for (size_t i = 0; i < memory->change_count; i++) {
        uint64_t address = memory->changes[i].address;
        c205_word word = plain_read(memory, address);
        c205_word *to_be = place(bench, address);
        if (to_be)
            *to_be = word;
        else if (word_at(&bench->fixture, address) != word)
            fail_case(bench, "memory far away");
    }
}

static void compare_memory(struct bench *bench)
{
    c205_word words[BEFORE + AFTER];
    follow_changes(bench);
    for (size_t i = 0; i < BORDERS; i++) {
        size_t count = borders[i].words;
        assert_true(c205_read(bench->fixture.machine, begin_of(i), words, count));
        if (memcmp(words, bench->memory[i], count * sizeof *words) != 0)
            fail_case(bench, "memory");
    }
}

/* A trap of an unmapped or protected word must report its address. */
static bool has_fault(const struct bench *bench, const c205_stop *stop)
{
    bool names_address = stop->trap == C205_TRAP_UNMAPPED_ADDRESS
                         || stop->trap == C205_TRAP_PROTECTED_ADDRESS;
    return names_address
               ? reference_has_fault(&bench->reference, stop->trap, stop->address)
               : bench->reference.faults[stop->trap].possible;
}

/* Each possible fault of an instruction is accepted. */
static bool step_both(struct bench *bench)
{
    c205_stop stop = { .trap = C205_TRAP_NONE };
    bool done = reference_step(&bench->reference);
    bool traps = !c205_step(bench->fixture.machine, &stop);
    assert_false(bench->reference.lost);
    if (traps && !has_fault(bench, &stop))
        fail_case(bench, c205_trap_name(stop.trap));
    if (!traps && !done)
        fail_case(bench, "no trap");
    if (traps && done)
        reference_undo(&bench->reference);
    compare_memory(bench);
    for (unsigned r = 1; r < C205_REGISTERS; r++)
        if (get(&bench->fixture, r) != bench->reference.now.registers[r])
            fail_case(bench, "registers");
    if (c205_data_flags(bench->fixture.machine) != bench->reference.now.flags)
        fail_case(bench, "data flags");
    return traps;
}

/* ---- Cases --------------------------------------------------------------- */

/* The flags are cleared first, so that a case shows the flags that it sets. */
static void begin_case(struct bench *bench)
{
    begin(&bench->fixture);
    add(&bench->fixture, "LSDFR", (c205_fields){ .t = FLAGS });
}

static void add_insn(struct bench *bench, const c205_insn *row,
                     const c205_fields *fields)
{
    bench->row = row;
    bench->fields = *fields;
    add(&bench->fixture, row->mnemonic, *fields);
}

static void load_code(struct bench *bench)
{
    const c205_word *code = bench->fixture.code;
    for (size_t i = 0; i <= bench->fixture.halves / 2; i++)
        plain_store(&bench->reference.memory, CODE + i * WORD, code[i]);
    assert_true(c205_write(bench->fixture.machine, CODE, code, CODE_WORDS));
    bench->reference.now.pc = CODE;
    c205_set_pc(bench->fixture.machine, CODE);
}

static enum contents contents_for(const struct bench *bench)
{
    if (strchr(bench->row->operands, 'l'))
        return INDICES;
    return bench->fields.g & C205_G_HALF ? HALF_NUMBERS : NUMBERS;
}

/* Returns true if the case trapped. */
static bool run_case(struct bench *bench)
{
    load_code(bench);
    fill(bench, 0, contents_for(bench));
    for (unsigned r = 1; r < C205_REGISTERS; r++)
        set(&bench->fixture, r, bench->reference.now.registers[r]);
    assert_false(step_both(bench));
    return step_both(bench);
}

static bool one_case(struct bench *bench, const c205_insn *row)
{
    c205_fields fields = draw_fields(bench, row);
    begin_case(bench);
    add_insn(bench, row, &fields);
    draw_registers(bench, one_in(bench, 10) ? 150 : 20);
    return run_case(bench);
}

/* Chooses two rows, usually of different units. The results of the first are words. */
static void draw_linkables(struct bench *bench, const c205_insn *rows[2])
{
    do
        for (size_t i = 0; i < 2; i++)
            do
                rows[i] = c205_insns + below(bench, c205_insn_count);
            while (!c205_unit_links(rows[i]->unit));
    while ((rows[0]->unit == rows[1]->unit || rows[0]->timing == C205_TIMING_vcompare)
           && !one_in(bench, 40));
}

/* The first instruction usually has one vector as operand. The second instruction has
 * the result of the first as operand. */
static void link_pair(struct bench *bench, const c205_insn *const rows[2],
                      c205_fields f[2])
{
    bool takes_b = letter_of(rows[1], ROLE_B);
    bool as_a = !takes_b || one_in(bench, 2);
    bool as_b = takes_b && (!as_a || one_in(bench, 4));
    uint8_t number = f[0].g & C205_G_HALF ? 2 * HALF_NUMBER : NUMBER;
    f[0].z = 0;
    f[0].g &= (uint8_t) ~(C205_G_OFFSET | C205_G_ZEROS);
    if (letter_of(rows[0], ROLE_B) && !one_in(bench, 20))
        f[0].g |= one_in(bench, 2) ? C205_G_BROADCAST_A : C205_G_BROADCAST_B;
    if (f[0].g & C205_G_BROADCAST_A) {
        f[0].x = 0;
        f[0].a = number;
    }
    if (f[0].g & C205_G_BROADCAST_B) {
        f[0].y = 0;
        f[0].b = number;
    }
    f[0].c = HANDED;
    if (as_a) {
        f[1].g &= (uint8_t)~C205_G_BROADCAST_A;
        f[1].a = HANDED;
        f[1].x = 0;
    }
    if (as_b) {
        f[1].g &= (uint8_t)~C205_G_BROADCAST_B;
        f[1].b = HANDED;
        f[1].y = 0;
    }
}

/* Describes the intermediate result. It has the length of the result. Its address is
 * arbitrary, because it is not stored. */
static void describe_handed(struct bench *bench, const c205_fields *second)
{
    c205_word *registers = bench->reference.now.registers;
    uint64_t length = registers[second->c] >> 48;
    uint64_t offset = second->g & C205_G_OFFSET ? registers[second->c + 1] : 0;
    length = offset < length ? length - offset : 0;
    registers[HANDED] = descriptor(WORD, one_in(bench, 30) ? 7 : length);
}

static bool one_pair(struct bench *bench)
{
    const c205_insn *rows[2];
    c205_fields f[2];
    draw_linkables(bench, rows);
    do
        for (size_t i = 0; i < 2; i++)
            f[i] = draw_fields(bench, rows[i]);
    while ((f[0].g ^ f[1].g) & C205_G_HALF);
    link_pair(bench, rows, f);
    begin_case(bench);
    add(&bench->fixture, "LINKV", (c205_fields){ .r = 0 });
    for (size_t i = 0; i < 2; i++)
        add_insn(bench, rows[i], f + i);
    draw_registers(bench, one_in(bench, 10) ? 150 : 20);
    describe_handed(bench, f + 1);
    return run_case(bench);
}

/* ---- Tests --------------------------------------------------------------- */

/* Some cases must trap, but at most half of them. */
static void check_traps(const char *name, size_t traps, size_t cases)
{
    FAIL_IF(traps == 0 || traps > cases / 2, "%s: %zu of %zu cases trap", name, traps,
            cases);
}

TEST(instructions)
{
    struct bench *bench = make_bench();
    for (size_t i = 0; i < c205_insn_count; i++) {
        size_t traps = 0;
        if (!has_vectors(c205_insns + i))
            continue;
        bench->random = i;
        for (int k = 0; k < CASES; k++)
            traps += one_case(bench, c205_insns + i);
        check_traps(c205_insns[i].mnemonic, traps, CASES);
    }
    free_bench(bench);
}

TEST(linked_pairs)
{
    struct bench *bench = make_bench();
    size_t traps = 0;
    for (int i = 0; i < 10 * CASES; i++)
        traps += one_pair(bench);
    check_traps("LINKV", traps, 10 * CASES);
    free_bench(bench);
}

GROUP(set_up_oracle, tear_down_oracle);
