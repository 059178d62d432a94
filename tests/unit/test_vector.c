/* test_vector.c - vector instructions against a machine that takes one
 * element after another: read, compute, store, then the next.
 *
 * Operands are put at random, so that they overlap in every way, lie across
 * a page boundary, and sometimes run out of memory: then both must trap and
 * leave everything as it was.
 */
#include "one_by_one.h"

enum { CASES = 1500 }; /* of each instruction */

/* ---- Random operands ---------------------------------------------------- */

static uint64_t random_state = 0x2545F4914F6CDD1D;

static uint64_t random_bits(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state * UINT64_C(0x9E3779B97F4A7C15);
}

static uint64_t below(uint64_t n)
{
    return (random_bits() >> 20) % n;
}

static c205_word random_word(void)
{
    switch (below(8)) {
    case 0: return random_bits();
    case 1: return C205_MACHINE_ZERO;
    case 2: return c205_from_integer((int64_t)below(7) - 3);
    case 3: return c205_from_double((double)below(9) - 4);
    default: return below(WINDOW);
    }
}

/* Registers: 1-4 vectors of words, 5-8 of bits, 9 an offset, 10 a table, 11
 * and 12 numbers, 13 for results.  From 20 on stand pairs of
 * a vector of words and an offset of 0 to 3, from 30 on of one of bits. */
static void random_registers(struct other *o, size_t longest)
{
    for (unsigned r = 1; r <= 8; r++) {
        uint64_t at = WINDOW_BEGIN + below(WINDOW / 4) * 64;
        o->reg[r] = descriptor(r > 4 ? at + below(128) : at,
                               below(longest + 1));
    }
    o->reg[9] = below(4);
    o->reg[10] = WINDOW_BEGIN + below(WINDOW) * 64;
    o->reg[11] = random_word();
    o->reg[12] = random_word();
    o->reg[13] = 0;
    for (unsigned r = 20; r < 40; r += 2) {
        o->reg[r] = o->reg[(r < 30 ? 1 : 5) + below(4)];
        o->reg[r + 1] = below(4);
    }
    if (below(50) == 0)
        o->reg[1 + below(4)] += UINT64_C(64) * WORDS;
}

static uint8_t some(uint64_t chance, unsigned value)
{
    return below(chance) == 0 ? (uint8_t)value : 0;
}

static c205_fields random_fields(const c205_insn *row)
{
    const char *syntax = c205_format_syntax(row->format);
    bool scalars = row->format == C205_FORMAT_SCALARS;
    bool strings = is_string(row);
    bool sieve = row->format == C205_FORMAT_SIEVE;
    bool scan = row->format == C205_FORMAT_SCAN;
    bool sparse = row->format == C205_FORMAT_SPARSE;
    char result = row->operands[strcspn(row->operands, "deqco")];
    uint64_t base = strings ? 5 : 1;
    c205_fields f;
    memset(&f, 0, sizeof f);
    f.g = row->subop;
    f.a = (uint8_t)(scalars ? 11 : base + below(4));
    if (strchr(syntax, 'a'))
        f.g |= some(4, C205_G_BROADCAST_A);
    if (f.g & C205_G_BROADCAST_A)
        f.a = (uint8_t)(11 + below(2));
    else if (strchr(syntax, 'a'))
        f.x = some(3, 9);
    if (strchr(syntax, 'b') || scalars || strings || scan || sparse)
        f.b = (uint8_t)(scalars ? 12 : base + below(4));
    if (row->format == C205_FORMAT_TABLE)
        f.b = 10;
    if (strchr(syntax, 'b'))
        f.g |= some(4, C205_G_BROADCAST_B);
    if (f.g & C205_G_BROADCAST_B)
        f.b = (uint8_t)(below(2) * 12);
    else if (strchr(syntax, 'b') || scan)
        f.y = some(3, 9);
    if (strchr(syntax, '!') || sieve || sparse
        || (strchr(syntax, '?') && below(2)))
        f.z = (uint8_t)(5 + below(4));
    if (f.z && !sieve && !sparse)
        f.g |= some(3, C205_G_ZEROS);
    if (row->flags & C205_INSN_SIGN)
        f.g |= (uint8_t)(some(4, C205_G_NEGATE_A)
                         | some(4, C205_G_MAGNITUDE_A));
    if (row->flags & C205_INSN_SIGN && f.b)
        f.g |= some(4, C205_G_MAGNITUDE_B);
    if (sparse) {
        f.x = (uint8_t)(5 + below(4));
        f.y = (uint8_t)(5 + below(4));
    }
    f.c = (uint8_t)((sieve || result != 'e' ? 1 : 5) + below(4));
    if (row->format == C205_FORMAT_SPREAD)
        f.c = 10;
    else if (!result)
        f.c = 13;
    else if (below(3) == 0) {
        f.g |= C205_G_OFFSET;
        f.c = (uint8_t)((result == 'e' && !sieve ? 30 : 20) + 2 * below(5));
    }
    return f;
}

/* ---- Both machines, side by side ---------------------------------------- */

struct bench {
    struct little little;
    struct other *other;
};

static struct bench *make_bench(void)
{
    struct bench *bench = malloc(sizeof *bench);
    assert_non_null(bench);
    bench->little = make_little();
    bench->other = calloc(1, sizeof *bench->other);
    assert_non_null(bench->other);
    load(&bench->little, WORDS);
    return bench;
}

static void free_bench(struct bench *bench)
{
    free_little(&bench->little);
    free(bench->other);
    free(bench);
}

static void fill(struct bench *bench, size_t longest)
{
    struct other *o = bench->other;
    c205_word *window = place(o, WINDOW_BEGIN);
    for (size_t i = 0; i < WINDOW; i++)
        window[i] = random_word();
    random_registers(o, longest);
    o->trap = false;
    o->flags = c205_data_flags(bench->little.machine);
    memcpy(o->before, place(o, ACTIVE_BEGIN), sizeof o->before);
    assert_true(
        c205_write(bench->little.machine, ACTIVE_BEGIN, o->before, ACTIVE));
    for (unsigned r = 1; r < 256; r++)
        set(&bench->little, r, o->reg[r]);
}

static void compare_machines(struct bench *bench, const char *name,
                             c205_fields f, const c205_stop *stop)
{
    struct other *o = bench->other;
    c205_word memory[ACTIVE];
    c205_read(bench->little.machine, ACTIVE_BEGIN, memory, ACTIVE);
    bool same = memcmp(memory, place(o, ACTIVE_BEGIN), sizeof memory) == 0
                && c205_data_flags(bench->little.machine) == o->flags;
    for (unsigned r = 1; r < 256; r++)
        same = same && get(&bench->little, r) == o->reg[r];
    if (!same)
        fail_msg("%s G %02X X %d A %d Y %d B %d Z %d C %d%s", name, f.g, f.x,
                 f.a, f.y, f.b, f.z, f.c, stop->trap ? " traps" : "");
}

/* The program in bench has run on the other machine; run it on ours. */
static void finish_case(struct bench *bench, const c205_insn *row,
                        c205_fields f, const c205_word *registers,
                        uint64_t flags)
{
    struct other *o = bench->other;
    c205_set_pc(bench->little.machine, CODE);
    c205_stop stop = run(&bench->little);
    /* where a result changes what is read, room for all is asked for */
    if (stop.trap && row->timing == C205_TIMING_vcompress)
        o->trap = true;
    if (o->trap != (stop.trap != C205_TRAP_NONE))
        fail_msg("%s: trap %s, expected %s", row->mnemonic,
                 c205_trap_name(stop.trap), o->trap ? "one" : "none");
    if (o->trap) {
        o->trap = false;
        memcpy(place(o, ACTIVE_BEGIN), o->before, sizeof o->before);
        memcpy(o->reg, registers, sizeof o->reg);
        o->flags = flags;
    }
    compare_machines(bench, row->mnemonic, f, &stop);
}

static void write_code(struct bench *bench)
{
    add(&bench->little, "EXIT", (c205_fields){ .r = 0 });
    assert_true(c205_write(bench->little.machine, CODE, bench->little.code,
                           CODE_WORDS));
}

static void one_case(struct bench *bench, const c205_insn *row,
                     size_t longest)
{
    struct other *o = bench->other;
    c205_word registers[256];
    c205_fields f = random_fields(row);
    begin(&bench->little);
    add(&bench->little, row->mnemonic, f);
    write_code(bench);
    fill(bench, longest);
    uint64_t flags = o->flags;
    memcpy(registers, o->reg, sizeof registers);
    perform(o, row, f);
    finish_case(bench, row, f, registers, flags);
}

/* The first result is said to lie nowhere: it is not stored. */
enum { HANDED = 14 };

static void random_pair(c205_fields f[2])
{
    bool as_a = below(2), as_b = !as_a || below(4) == 0;
    f[0].z = 0;
    f[0].g &= (uint8_t) ~(C205_G_OFFSET | C205_G_ZEROS);
    if (below(2)) {
        f[0].g |= C205_G_BROADCAST_A;
        f[0].x = 0;
        f[0].a = 11;
    } else {
        f[0].g |= C205_G_BROADCAST_B;
        f[0].y = 0;
        f[0].b = 11;
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

static void one_pair(struct bench *bench, size_t longest)
{
    struct other *o = bench->other;
    c205_word registers[256];
    size_t which[2] = { below(3), below(3) };
    const c205_insn *rows[2];
    c205_fields f[2];
    for (size_t i = 0; i < 2; i++) {
        const char *name = simple[which[i]].name;
        rows[i] = c205_insn_named(name, strlen(name));
        f[i] = random_fields(rows[i]);
    }
    random_pair(f);
    begin(&bench->little);
    add(&bench->little, "LINKV", (c205_fields){ .r = 0 });
    for (size_t i = 0; i < 2; i++)
        add(&bench->little, rows[i]->mnemonic, f[i]);
    write_code(bench);
    fill(bench, longest);
    o->reg[HANDED] = descriptor(64,
                                (size_t)describe(o, rows[1], f[1]).c.length);
    set(&bench->little, HANDED, o->reg[HANDED]);
    uint64_t flags = o->flags;
    memcpy(registers, o->reg, sizeof registers);
    perform_pair(o, rows, f, which);
    finish_case(bench, rows[1], f[1], registers, flags);
}

static void many_cases(const char *name)
{
    const c205_insn *row = c205_insn_named(name, strlen(name));
    struct bench *bench = make_bench();
    assert_non_null(row);
    for (int n = 0; n < CASES; n++)
        one_case(bench, row, n % 10 ? 20 : 150);
    free_bench(bench);
}

static void test_elementwise(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIMPLE; i++)
        many_cases(simple[i].name);
}

static void test_others(void **state)
{
    (void)state;
    for (size_t i = 0; i < SPECIAL; i++)
        many_cases(special[i].name);
}

static void test_linked_pairs(void **state)
{
    (void)state;
    struct bench *bench = make_bench();
    for (int n = 0; n < 10 * CASES; n++)
        one_pair(bench, n % 10 ? 20 : 150);
    free_bench(bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_elementwise),
                                        cmocka_unit_test(test_others),
                                        cmocka_unit_test(test_linked_pairs) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
