/* test_timing.c - clocks of machines are compared with the rules of docs/timing.md. A
 * formula that does not hold for some operands, or a clock without a cause, fails here.
 *
 *   test_timing [CASES]
 *
 * The closed formula is compared for every vector row with random operands. Longer
 * vectors are never cheaper, and more pipes are never slower. The causes sum to the
 * total at every step. Ten programs take the clocks that were computed by hand.
 */
#include "tests/unit/asm_helper.h"
#include "tests/unit/vector_case.h"

#include "tests/oracle/random_program.h"

#include <math.h>

enum { MODELS = 3, DEFAULT_CASES = 20, MAX_BANKS = 64 };

static const char *const model_names[MODELS] = { "cyber205-1pipe-prior",
                                                 "cyber205-2pipe-prior",
                                                 "cyber205-4pipe-prior" };
static struct small_machine fixture[MODELS];
static size_t cases = DEFAULT_CASES;

FIXTURE(make_machines)
{
    for (int i = 0; i < MODELS; i++) {
        begin(&fixture[i]);
        fixture[i].model = NON_NULL(c205_model_find(model_names[i], &failure));
        fixture[i].machine = NON_NULL(c205_new(fixture[i].model, &failure));
    }
    return 0;
}

FIXTURE(free_machines)
{
    for (int i = 0; i < MODELS; i++)
        free_small_machine(&fixture[i]);
    return 0;
}

static bool is_vector(const c205_insn *row)
{
    return c205_unit_is_vector(row->unit) && row->format != C205_FORMAT_NONE;
}

/* ---- Measured ---------------------------------------------------------- */

/* Runs the instruction twice. In the second run the pages are mapped. */
static uint64_t measured(struct small_machine *on, const struct vector_case *one)
{
    load(on, MEMORY_WORDS);
    for (int time = 0; time < 2; time++) {
        assert_true(c205_write(on->machine, DATA, one->memory, MEMORY_WORDS));
        for (unsigned i = 0; i < C205_REGISTERS; i++)
            set(on, i, one->reg[i]);
        c205_set_pc(on->machine, CODE);
        c205_reset_clock(on->machine);
        FAIL_IF(run(on).trap != C205_TRAP_NONE, "%s traps", one->row->mnemonic);
    }
    return c205_clock(on->machine);
}

static void begin_with(struct small_machine *on, const struct vector_case *one,
                       unsigned times)
{
    begin(on);
    while (times-- > 0)
        add(on, one->row->mnemonic, one->fields);
    add(on, "EXIT", (c205_fields){ .r = 0 });
}

/* ---- By the formula ---------------------------------------------------- */

static double constant(const c205_model *model, const char *kind, const char *name)
{
    const char *text = formatted("%s.%s", kind, name);
    const c205_constant *found = NON_NULL(c205_model_lookup(model, text));
    return found->value;
}

/* Returns ceil(n x rate / pipes). Pipes make half_rate results of 32 bits in the time
 * of one result of 64 bits. Rates are exact in millionths. */
static uint64_t stream(const c205_model *model, const char *name, uint64_t n, bool half)
{
    uint64_t million = 1000000, pipes = 1;
    uint64_t rate = (uint64_t)llround(constant(model, "stream", name) * 1e6);
    const char *text = formatted("stream.%s", name);
    if (strncmp(c205_model_lookup(model, text)->unit, "clk*pipe", 8) == 0) {
        pipes = (uint64_t)constant(model, "machine", "pipes");
        pipes *= half ? (uint64_t)constant(model, "vector", "half_rate") : 1;
    }
    return (n * rate + pipes * million - 1) / (pipes * million);
}

typedef bool relation(c205_word a, c205_word b);

static relation *relation_of(const c205_insn *row, unsigned g)
{
    static const struct {
        relation *of_words, *of_halves;
    } relations[C205_OPERATIONS] = {
#define RELATION(name) [C205_OPERATION_##name] = { arith_##name, half_##name },
#include "vm/arith.def"
    };
    if (row->format != C205_FORMAT_SCAN)
        return NULL;
    return g & C205_G_HALF ? relations[row->operation].of_halves
                           : relations[row->operation].of_words;
}

static c205_word unsigned_element(const struct vector_case *one, enum role role,
                                  size_t i)
{
    const struct extent_of *vector = &one->vector[role];
    uint64_t at = vector->address - DATA + i * vector->width;
    unsigned left = role_half[role] % 2 ? HALF : 0;
    c205_word word;
    if (!one->scalar[role] && i >= vector->length)
        return C205_MACHINE_ZERO;
    if (!one->scalar[role]) {
        word = one->memory[at / WORD] << at % WORD;
        return vector->width == HALF ? word >> HALF << HALF : word;
    }
    if (!is_half(one, role))
        return one->reg[role_register[role]];
    return one->reg[role_half[role] / 2] << left >> HALF << HALF;
}

/* Returns an element. A half word is in the left half. */
static c205_word element(const struct vector_case *one, enum role role, size_t i)
{
    unsigned g = one->fields.g;
    bool half = g & C205_G_HALF;
    c205_word word = unsigned_element(one, role, i);
    uint64_t flags = 0;
    if (g & (role == ROLE_A ? C205_G_MAGNITUDE_A : C205_G_MAGNITUDE_B))
        word = half ? half_absolute(word, &flags) : arith_absolute(word, &flags);
    if (role == ROLE_A && g & C205_G_NEGATE_A)
        word = half ? half_negate(word, &flags) : arith_negate(word, &flags);
    return word;
}

static uint64_t comparisons(const struct vector_case *one)
{
    relation *compares = relation_of(one->row, one->fields.g);
    uint64_t count = 0;
    for (size_t i = 0; i < one->n; i++)
        for (size_t k = 0; k < one->vector[ROLE_B].length; k++) {
            count++;
            if (compares(element(one, ROLE_A, i), element(one, ROLE_B, k)))
                break;
        }
    return count;
}

static size_t ones(const struct vector_case *one, bool x, bool y)
{
    size_t count = 0;
    for (size_t i = 0; i < one->n; i++)
        count += (x && bit_of(one, ROLE_X, i)) || (y && bit_of(one, ROLE_Y, i));
    return count;
}

static size_t longest_packed(const struct vector_case *one)
{
    size_t x = ones(one, true, false), y = ones(one, false, true), z = 0;
    for (size_t i = 0; is_given(one) && i < one->n; i++)
        z += bit_of(one, ROLE_Z, i);
    x = x > z ? x : z;
    if (!is_given(one) && !(one->row->flags & C205_INSN_PADO))
        return ones(one, true, true);
    return x > y ? x : y;
}

static uint64_t elements(const struct vector_case *one)
{
    if (one->row->format == C205_FORMAT_SPARSE)
        return longest_packed(one);
    if (relation_of(one->row, one->fields.g))
        return comparisons(one);
    if (one->row->format == C205_FORMAT_SCAN)
        return one->n * one->vector[ROLE_B].length;
    return one->n;
}

/* Uses t(k) = max(t(k-1) + 1, free(bank(k))) for the stored elements. */
static uint64_t conflicts(const struct vector_case *one, const c205_model *model)
{
    uint64_t banks = (uint64_t)constant(model, "memory", "banks");
    uint64_t busy = (uint64_t)constant(model, "memory", "bank_busy");
    uint64_t free_at[MAX_BANKS] = { 0 }, t = 0, accesses = 0;
    for (size_t i = 0; has_indices(one->row) && i < one->n; i++) {
        uint64_t word = indexed(one, i) / WORD;
        if (!is_permitted(one, i))
            continue;
        t = t + 1 > free_at[word % banks] ? t + 1 : free_at[word % banks];
        free_at[word % banks] = t + busy;
        accesses++;
    }
    return t - accesses;
}

TEST(closed_formula)
{
    static struct vector_case one;
    uint64_t random = 3205;
    for (size_t i = 0; i < c205_insn_count; i++)
        for (size_t k = 0; is_vector(&c205_insns[i]) && k < cases; k++) {
            struct small_machine *on = &fixture[k % MODELS];
            const char *timing = c205_timing_name(c205_insns[i].timing);
            draw_case(&one, &c205_insns[i], &random, draw_size(&random));
            begin_with(on, &one, 1);
            uint64_t startup = (uint64_t)constant(on->model, "startup", timing);
            uint64_t clocks = startup + conflicts(&one, on->model)
                              + stream(on->model, timing, elements(&one),
                                       one.fields.g & C205_G_HALF);
            FAIL_IF(measured(on, &one) != clocks,
                    "%s of %zu on %s: %llu clocks, not %llu", one.row->mnemonic, one.n,
                    model_names[k % MODELS], (unsigned long long)measured(on, &one),
                    (unsigned long long)clocks);
        }
}

/* ---- Longer, more pipes ------------------------------------------------ */

static void draw_plain(struct vector_case *one, const c205_insn *row, uint64_t *random)
{
    bool sparse = row->format == C205_FORMAT_SPARSE;
    do
        draw_case(one, row, random, LENGTH);
    while (reference_has_offset(row, &one->fields)
           || one->fields.g & (C205_G_BROADCAST_A | C205_G_BROADCAST_B)
           || one->fields.x != (sparse ? role_register[ROLE_X] : 0)
           || one->fields.y != (sparse ? role_register[ROLE_Y] : 0));
}

/* Tries one instruction, and two in sequence. All operands have each length. */
static void try_lengths(struct vector_case *one, unsigned times)
{
    uint64_t before[MODELS] = { 0 }, now[MODELS];
    for (int i = 0; i < MODELS; i++)
        begin_with(&fixture[i], one, times);
    for (size_t length = 0; length <= LENGTH; length += 1 + length / 20) {
        for (int role = 0; role < ROLES; role++)
            if (letter_of(one->row, (enum role)role) && !one->scalar[role]
                && (role != ROLE_Z || one->fields.z))
                one->reg[role_register[role]] = descriptor(one->vector[role].address,
                                                           length);
        for (int i = 0; i < MODELS; i++) {
            now[i] = measured(&fixture[i], one);
            FAIL_IF(now[i] < before[i], "%s of %zu is cheaper", one->row->mnemonic,
                    length);
        }
        FAIL_IF(now[0] < now[1] || now[1] < now[2], "%s is slower with more pipes",
                one->row->mnemonic);
        memcpy(before, now, sizeof now);
    }
}

TEST(longer_is_never_cheaper)
{
    static struct vector_case one;
    uint64_t random = 4205;
    for (size_t i = 0; i < c205_insn_count; i++)
        for (unsigned times = 1; is_vector(&c205_insns[i]) && times <= 2; times++) {
            draw_plain(&one, &c205_insns[i], &random);
            try_lengths(&one, times);
        }
}

/* ---- Random programs --------------------------------------------------- */

static bool same_states(void)
{
    for (int i = 1; i < MODELS; i++)
        for (unsigned r = 0; r < C205_REGISTERS; r++)
            if (get(&fixture[i], r) != get(&fixture[0], r))
                return false;
    return c205_pc(fixture[0].machine) == c205_pc(fixture[1].machine);
}

/* Steps all machines. Returns false if one machine has ended, or if its state differs
 * from that of the others. The states may differ in programs that read the clock. */
static bool step_all(void)
{
    bool goes_on = true;
    c205_stop stop;
    for (int i = 0; i < MODELS; i++) {
        goes_on = c205_step(fixture[i].machine, &stop) && goes_on;
        assert_sum(fixture[i].machine);
    }
    return goes_on && same_states();
}

static void try_program(uint64_t seed)
{
    enum { STEPS = 200 };
    struct random_program program = random_program(seed);
    for (int i = 0; i < MODELS; i++)
        assert_true(random_load(fixture[i].machine, &program, &failure));
    for (int step = 0; step < STEPS && step_all(); step++)
        FAIL_IF(c205_clock(fixture[0].machine) < c205_clock(fixture[1].machine)
                    || c205_clock(fixture[1].machine) < c205_clock(fixture[2].machine),
                "seed %llu is slower with more pipes", (unsigned long long)seed);
}

TEST(random_programs)
{
    for (uint64_t seed = 1; seed <= 20 * cases; seed++)
        try_program(seed);
}

/* ---- Ten small programs ------------------------------------------------ */

/* All programs run on two pipes, with the constants of docs/timing.md. The first access
 * to a page takes 30 + 1,000 clocks. */
static const struct {
    const char *what, *text;
    uint64_t clocks;
} programs[] = {
    { "The monitor takes 1.", "EXIT", 1 },
    { "A linked pair is one instruction: 3 + 84 + 1030 + 50.",
      "EX r10, x\n ELEN r10, 100\n RTOR r10, r11\n LINKV\n"
      " MPYSV [r10], r12, [r11]\n ADDNV [r11], [r10], [r11]\n EXIT\n"
      " .data\nx: .space 100\n",
      3 + 84 + 1030 + 50 },
    { "Each waits for the one before: at 0, 5, 10; ready at 15.",
      "ADDN r10, r11, r12\n ADDN r12, r11, r13\n ADDN r13, r11, r14\n EXIT", 15 },
    { "At 0, 1, 2: the last is ready at 7.",
      "ADDN r10, r11, r12\n ADDN r10, r11, r13\n ADDN r10, r11, r14\n EXIT", 7 },
    { "The unit is busy for 54: at 0 and 54, ready at 108.",
      "DIVS r10, r11, r12\n DIVS r10, r11, r13\n EXIT", 108 },
    { "EX at 0; the page is in at 1 + 1030, when LOD issues; 15 until it is "
      "there, then 5 for the addition.",
      "EX r10, x\n LOD [r10], r11\n ADDN r11, r11, r12\n EXIT\n .data\nx: .word 1.0\n",
      1 + 1030 + 15 + 5 },
    { "ES at 0 and 1; DBNZ at 2: taken, 8 more; at 11: taken; at 20 not; EXIT at 21.",
      "ES r10, 3\n EX r11, loop\nloop: DBNZ r10, [r11]\n EXIT", 2 + 9 + 9 + 1 + 1 },
    { "Descriptors at 0, 1, 2; the addition at 3: start-up 51, the page, "
      "which holds all, 1030, 100 elements by two pipes 50.",
      "EX r10, x\n ELEN r10, 100\n RTOR r10, r11\n"
      " ADDNV [r10], [r11], [r11]\n EXIT\n .data\nx: .space 100\n",
      3 + 51 + 1030 + 50 },
    { "The second start-up begins 10 clocks before the first stream ends: "
      "3 + 51 + 1030 + 50, then 51 + 50 - 10.",
      "EX r10, x\n ELEN r10, 100\n RTOR r10, r11\n"
      " ADDNV [r10], [r11], [r11]\n ADDNV [r10], [r11], [r11]\n EXIT\n"
      " .data\nx: .space 100\n",
      3 + 51 + 1030 + 50 + 51 + 50 - 10 },
    { "The vector sum of no elements takes its start-up of 96, in whose shade "
      "the chain of two additions is done; what needs the sum waits for it.",
      "SUMV [r10], r20\n ADDN r12, r13, r14\n ADDN r14, r13, r15\n"
      " ADDN r20, r13, r16\n EXIT",
      96 + 5 },
};

TEST(small_programs)
{
    for (size_t i = 0; i < COUNT(programs); i++) {
        SCOPED(object) *object = good(programs[i].text);
        c205 *machine = fixture[1].machine;
        assert_true(c205_load(machine, &object->program, &failure));
        assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
        FAIL_IF(c205_clock(machine) != programs[i].clocks, "%llu clocks, not %llu: %s",
                (unsigned long long)c205_clock(machine),
                (unsigned long long)programs[i].clocks, programs[i].what);
        assert_sum(machine);
    }
}

ARGUMENTS(argc, argv)
{
    cases = argument(argc, argv, 1, share_of(cases));
}

GROUP(make_machines, free_machines);
