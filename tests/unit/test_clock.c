/* test_clock.c - what instructions cost, exactly, and to which causes.
 *
 * Expected clocks follow from the formulas of docs/timing.md; those of pages:
 * test_pages.c.
 */
#include "tests/unit/clock_driver.h"

/* ---- Vector instructions ------------------------------------------------- */

TEST(isolated_add)
{
    static const size_t lengths[] = { 0, 1, 2, 3, 5, 100, 101, 65535 };
    static const char *const models[] = { "title T\nlike cyber205-1pipe-prior",
                                          "title T\nlike cyber205-2pipe-prior",
                                          "title T\nlike cyber205-4pipe-prior" };
    for (size_t m = 0; m < 3; m++) {
        struct clock *clock = clock_of(models[m]);
        size_t pipes = (size_t)1 << m;
        for (size_t i = 0; i < COUNT(lengths); i++) {
            size_t stream = (lengths[i] + pipes - 1) / pipes;
            vector(clock, "ADDNV", lengths[i]);
            assert_int_equal(clock_now(clock), 1);
            clock_drain(clock);
            assert_int_equal(clocks_for(clock, C205_VECTOR_STARTUP), 51);
            assert_int_equal(clocks_for(clock, C205_VECTOR_STREAM), stream);
            assert_total(clock, 51 + stream);
        }
        clock_free(clock);
    }
}

/* Start-up plus stream of 1,001 elements on two pipes. */
TEST(formulas)
{
    static const struct {
        const char *name;
        uint64_t clocks;
    } cases[] = { { "MPYSV", 51 + 501 },  { "DIVSV", 80 + 1627 },
                  { "SQRTV", 80 + 1627 }, { "ORV", 51 + 501 },
                  { "CMPGEV", 51 + 501 }, { "VTOV", 51 + 501 },
                  { "SUMV", 96 + 501 },   { "PRODV", 96 + 501 },
                  { "DOTV", 116 + 1001 }, { "MAXV", 95 + 501 },
                  { "SELGEV", 95 + 501 }, { "CPSV", 55 + 501 },
                  { "VXTOV", 69 + 1001 }, { "VTOVX", 71 + 1001 },
                  { "ANDB", 40 + 16 },    { "LINKV", 84 + 501 } };
    struct clock *clock = two_pipes();
    for (size_t i = 0; i < COUNT(cases); i++) {
        vector(clock, cases[i].name, 1001);
        assert_total(clock, cases[i].clocks);
    }
    clock_free(clock);
}

/* Half of the peak rate at 51 x 2 elements. */
TEST(half_rate)
{
    struct clock *clock = two_pipes();
    vector(clock, "ADDNV", 102);
    assert_total(clock, 102);
    clock_free(clock);
}

/* Words at the rate of half words, which go no faster; gathers and bit strings
 * take what they took. */
TEST(word_rate)
{
    static const struct {
        const char *name;
        uint8_t g;
        uint64_t clocks;
    } cases[] = { { "ADDNV", 0, 51 + 251 }, { "ADDNV", C205_G_HALF, 51 + 251 },
                  { "DIVSV", 0, 80 + 814 }, { "LINKV", 0, 84 + 251 },
                  { "ANDB", 0, 40 + 16 },   { "VXTOV", 0, 69 + 1001 } };
    struct clock *clock = clock_of("title T\nlike cyber205-2pipe-prior\n"
                                   "vector.word_rate 2 results R\n");
    for (size_t i = 0; i < COUNT(cases); i++) {
        struct effect effect = no_effect;
        struct decoded decoded = insn(cases[i].name, 1, 2, 0);
        decoded.fields.g = cases[i].g;
        effect.elements = 1001;
        charge(clock, decoded, &effect);
        clock_drain(clock);
        assert_total(clock, cases[i].clocks);
    }
    clock_free(clock);
}

static uint64_t pair_clocks(struct clock *clock, size_t first, size_t second)
{
    clock_reset(clock);
    vector(clock, "ADDNV", first);
    vector(clock, "MPYSV", second);
    clock_drain(clock);
    return clock_now(clock);
}

TEST(overlap)
{
    struct clock *clock = two_pipes();
    assert_int_equal(pair_clocks(clock, 100, 100), 101 + 101 - 10);
    assert_int_equal(clocks_for(clock, C205_VECTOR_STREAM), 100);
    assert_int_equal(pair_clocks(clock, 6, 100), 54 + 101 - 3);
    assert_int_equal(pair_clocks(clock, 0, 0), 102);
    for (size_t n = 0; n < 200; n++)
        for (size_t m = 0; m < 40; m++) {
            uint64_t clocks = pair_clocks(clock, n, m);
            assert_true(pair_clocks(clock, n + 1, m) >= clocks);
            assert_true(pair_clocks(clock, n, m + 1) >= clocks);
        }
    clock_free(clock);
}

/* No more than the start-up hides, however much the model allows. */
TEST(overlap_of_a_whole_startup)
{
    struct clock *clock = clock_of("title T\nlike cyber205-2pipe-prior\n"
                                   "vector.overlap 1000 clk R\n");
    assert_int_equal(pair_clocks(clock, 1000, 100), 51 + 500 + 50);
    assert_int_equal(pair_clocks(clock, 20, 100), 51 + 10 + 101 - 10);
    clock_free(clock);
}

/* Scalar code runs on under the stream. */
TEST(concurrent_scalar)
{
    struct clock *clock = two_pipes();
    vector(clock, "ADDNV", 100);
    for (unsigned i = 0; i < 20; i++)
        scalar(clock, "ADDN", 3, 4, 10 + i);
    assert_int_equal(clock_now(clock), 21);
    clock_drain(clock);
    assert_int_equal(clocks_for(clock, C205_ISSUE), 20);
    assert_int_equal(clocks_for(clock, C205_VECTOR_STARTUP), 31);
    assert_total(clock, 101);
    clock_free(clock);
}

TEST(vector_result)
{
    struct clock *clock = two_pipes();
    struct effect effect = no_effect;
    effect.elements = 100;
    charge(clock, insn("SUMV", 1, 0, 20), &effect);
    scalar(clock, "ADDN", 3, 4, 5);
    assert_int_equal(clock_now(clock), 2);
    scalar(clock, "ADDN", 20, 4, 6);
    assert_int_equal(clock_now(clock), 96 + 50 + 1);
    assert_int_equal(clocks_for(clock, C205_VECTOR_STREAM), 50);
    assert_int_equal(clocks_for(clock, C205_OPERAND_WAIT), 0);
    clock_free(clock);
}

/* The members of a linked pair name the registers that it needs. */
TEST(linked_pair)
{
    struct clock *clock = two_pipes();
    struct effect effect = no_effect;
    struct decoded first, second, prefix = insn("LINKV", 0, 0, 0);
    effect.elements = 10;
    scalar(clock, "ES", 0, 0, 7);
    scalar(clock, "DIVS", 3, 4, 8);
    first = insn("MPYSV", 7, 0, 0);
    second = insn("ADDNV", 8, 0, 0);
    prefix.linked[0] = &first;
    prefix.linked[1] = &second;
    charge(clock, prefix, &effect);
    assert_int_equal(clocks_for(clock, C205_OPERAND_WAIT), 53);
    assert_total(clock, 1 + 54 + 84 + 5);
    clock_free(clock);
}

/* A prefix and two without registers. */
static void charge_pair(struct clock *clock, const char *first_name,
                        const char *second_name, uint8_t g, size_t recurrent)
{
    struct effect effect = no_effect;
    struct decoded first = insn(first_name, 0, 0, 0);
    struct decoded second = insn(second_name, 0, 0, 0);
    struct decoded prefix = insn("LINKV", 0, 0, 0);

    first.fields.g = second.fields.g = g;
    prefix.linked[0] = &first;
    prefix.linked[1] = &second;
    effect.elements = 1001;
    effect.recurrent = recurrent;
    charge(clock, prefix, &effect);
    clock_drain(clock);
}

/* Of the slowest of the pair, whichever it is; what starts up later than an
 * addition adds that. */
TEST(linked_rates)
{
    static const struct {
        const char *first, *second;
        uint8_t g;
        uint64_t startup, stream;
    } cases[] = {
        { "MPYSV", "ADDNV", 0, 84, 501 },
        { "SHIFTV", "ORV", 0, 84 + 4 + 4, 501 },
        { "TRUV", "CMPGEV", 0, 84 + 9, 501 },
        { "DIVSV", "ADDNV", 0, 84 + 29, 1627 },
        { "ADDNV", "DIVSV", 0, 84 + 29, 1627 },
        { "ORV", "SQRTV", C205_G_HALF, 84 + 29 + 4, 814 },
        { "MPYSV", "SHIFTV", C205_G_HALF, 84 + 4, 251 },
    };
    struct clock *clock = clock_of("title T\nlike cyber205-2pipe-prior\n"
                                   "startup.vtransmit 60 clk R\n"
                                   "startup.vmultiply 40 clk R\n"
                                   "startup.vlogical 55 clk R\n");
    for (size_t i = 0; i < COUNT(cases); i++) {
        clock_reset(clock);
        charge_pair(clock, cases[i].first, cases[i].second, cases[i].g, 0);
        assert_int_equal(clocks_for(clock, C205_VECTOR_STARTUP), cases[i].startup);
        assert_int_equal(clocks_for(clock, C205_VECTOR_STREAM), cases[i].stream);
        assert_total(clock, cases[i].startup + cases[i].stream);
    }
    clock_free(clock);
}

/* Each element that waits for one before costs the start-up once more, that
 * of a pair what the pair takes; all of it is stream, under which the next
 * may begin. */
TEST(recurrences)
{
    struct clock *clock = two_pipes();
    struct effect effect = no_effect;
    effect.elements = 6;
    effect.recurrent = 5;
    charge(clock, insn("ADDNV", 1, 2, 0), &effect);
    clock_drain(clock);
    assert_int_equal(clocks_for(clock, C205_VECTOR_STARTUP), 51);
    assert_int_equal(clocks_for(clock, C205_VECTOR_STREAM), 3 + 5 * 51);
    assert_total(clock, 51 + 3 + 5 * 51);
    charge_pair(clock, "DIVSV", "ADDNV", 0, 7);
    assert_total(clock, 113 + 1627 + 7 * 113);
    charge(clock, insn("ADDNV", 1, 2, 0), &effect);
    vector(clock, "ADDNV", 100);
    clock_drain(clock);
    assert_total(clock, 51 + 3 + 5 * 51 + 51 + 50 - 10);
    clock_free(clock);
}

/* ---- Gather and scatter -------------------------------------------------- */

static uint64_t gather_clocks(struct clock *clock, const c205_word *indices,
                              size_t count)
{
    struct effect effect = no_effect;
    clock_reset(clock);
    effect.elements = effect.index_count = count;
    effect.indices = indices;
    effect.table_step = 64;
    charge(clock, insn("VXTOV", 1, 2, 0), &effect);
    clock_drain(clock);
    return clocks_for(clock, C205_BANK_CONFLICT)
           + clocks_for(clock, C205_VECTOR_STREAM);
}

static uint64_t random_state = 1;
static uint64_t random_bits(void)
{
    uint64_t z = random_state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

enum { LIST = 60000 };

TEST(bank_conflicts)
{
    struct clock *clock = two_pipes();
    c205_word *indices = calloc(LIST, sizeof *indices);
    static const c205_word near[] = { 5, 6, 5, 5, 7 };
    /* issue at 0, 1, 4, 8, 9 */
    assert_int_equal(gather_clocks(clock, near, 5), 10);
    /* one bank: each access but the last keeps it four clocks */
    assert_int_equal(gather_clocks(clock, indices, 100), 99 * 4 + 1);
    for (size_t i = 0; i < LIST; i++)
        indices[i] = i;
    assert_int_equal(gather_clocks(clock, indices, LIST), LIST);
    assert_int_equal(gather_clocks(clock, indices, 0), 0);
    free(indices);
    clock_free(clock);
}

/* The published mean: 40 million elements a second, 1.25 clocks each. */
TEST(random_gather)
{
    struct clock *clock = two_pipes();
    c205_word *indices = calloc(LIST, sizeof *indices);
    uint64_t total = 0;
    for (int round = 0; round < 10; round++) {
        for (size_t i = 0; i < LIST; i++)
            indices[i] = random_bits() % 60000;
        total += gather_clocks(clock, indices, LIST);
    }
    assert_in_range(total * 1000 / (10 * LIST), 1245, 1255);
    free(indices);
    clock_free(clock);
}

/* ---- Scalar instructions ------------------------------------------------- */

TEST(latencies)
{
    static const struct {
        const char *name;
        uint64_t latency;
    } cases[] = { { "ADDX", 1 },  { "ADDN", 5 }, { "MPYS", 5 }, { "DIVS", 54 },
                  { "SQRT", 54 }, { "XOR", 3 },  { "MPYX", 5 }, { "ABS", 5 } };
    struct clock *clock = two_pipes();
    for (size_t i = 0; i < COUNT(cases); i++) {
        for (unsigned reg = 10; reg < 20; reg++)
            scalar(clock, cases[i].name, reg, 0, reg + 1);
        assert_int_equal(clocks_for(clock, C205_OPERAND_WAIT),
                         9 * (cases[i].latency - 1));
        assert_total(clock, 10 * cases[i].latency);
    }
    clock_free(clock);
}

TEST(pipelined_and_busy)
{
    struct clock *clock = two_pipes();
    for (unsigned reg = 10; reg < 20; reg++)
        scalar(clock, "ADDN", 3, 4, reg);
    assert_total(clock, 9 + 5);
    scalar(clock, "DIVS", 3, 4, 10);
    scalar(clock, "ADDN", 3, 4, 11);
    scalar(clock, "SQRT", 3, 4, 12);
    clock_drain(clock);
    assert_int_equal(clocks_for(clock, C205_UNIT_BUSY), 52);
    assert_total(clock, 54 + 54);
    scalar(clock, "DIVS", 3, 4, 10);
    scalar(clock, "ES", 0, 0, 10); /* the quotient comes first */
    assert_total(clock, 55);
    clock_free(clock);
}

TEST(loads)
{
    struct clock *clock = two_pipes();
    scalar(clock, "LOD", 1, 0, 10);
    scalar(clock, "ADDN", 10, 4, 11);
    assert_int_equal(clocks_for(clock, C205_MEMORY_WAIT), 14);
    assert_total(clock, 15 + 5);
    for (unsigned reg = 10; reg < 17; reg++)
        scalar(clock, "LOD", 1, 0, reg);
    assert_int_equal(clock_now(clock), 16); /* the 7th waits for the 1st */
    assert_total(clock, 15 + 15);
    scalar(clock, "LOD", 1, 0, 10);
    vector(clock, "ADDNV", 0);
    assert_int_equal(clocks_for(clock, C205_MEMORY_WAIT), 14);
    assert_total(clock, 15 + 51);
    clock_free(clock);
}

/* Memory is the vector unit's while it works; the wait is charged to the
 * phases of the vector instruction, in its region. */
TEST(load_after_vector)
{
    static const char *const names[] = { "", "vector", "scalar" };
    c205_error error;
    struct clock *clock = two_pipes();
    assert_true(clock_set_regions(clock, names, 3, &error));
    struct effect effect = no_effect;
    effect.elements = 100;
    struct decoded add = insn("ADDNV", 1, 2, 0), load = insn("LOD", 1, 0, 9);
    add.region = 1;
    load.region = 2;
    charge(clock, add, &effect);
    charge(clock, load, &no_effect);
    clock_drain(clock);
    const c205_account *account = clock_account(clock, 1);
    assert_int_equal(account->clocks[C205_VECTOR_STARTUP], 51);
    assert_int_equal(account->clocks[C205_VECTOR_STREAM], 50);
    assert_int_equal(account->elements, 100);
    assert_int_equal(account->operations, 100);
    assert_int_equal(account->vector_instructions, 1);
    account = clock_account(clock, 2);
    assert_string_equal(account->name, "scalar");
    assert_int_equal(account->clocks[C205_ISSUE], 1);
    assert_int_equal(account->clocks[C205_MEMORY_WAIT], 14);
    assert_int_equal(account->instructions, 1);
    assert_int_equal(account->entries, 1);
    assert_total(clock, 51 + 50 + 15);
    clock_free(clock);
}

TEST(swap)
{
    struct clock *clock = two_pipes();
    struct effect effect = no_effect;
    effect.swapped = 20;
    scalar(clock, "DIVS", 3, 4, 10);
    charge(clock, insn("SWAP", 0, 0, 0), &effect);
    assert_int_equal(clocks_for(clock, C205_OPERAND_WAIT), 53);
    assert_int_equal(clocks_for(clock, C205_MEMORY_WAIT), 14 + 20);
    assert_total(clock, 54 + 15 + 20);
    clock_free(clock);
}

/* ---- Branches ------------------------------------------------------------ */

TEST(branches)
{
    struct clock *clock = two_pipes();
    driven_pc = 0x10000;
    scalar(clock, "BEQ", 0, 0, 0);
    assert_total(clock, 1);
    driven_pc = 0x10000;
    scalar(clock, "ES", 0, 0, 9);
    branch(clock, "BEQ", 0x10000); /* back to where the code began */
    assert_int_equal(clocks_for(clock, C205_BRANCH), 8);
    scalar(clock, "ES", 0, 0, 9);
    branch(clock, "BEQ", 0x10000 - 64); /* before it */
    assert_int_equal(clocks_for(clock, C205_BRANCH), 8 + 16);
    branch(clock, "BEQ", 0x10000); /* the stack was emptied */
    assert_int_equal(clocks_for(clock, C205_BRANCH), 8 + 16 + 16);
    assert_total(clock, 5 + 8 + 16 + 16);
    clock_free(clock);
}

/* A loop of exactly 64 words stays in the stack; one word more does not. */
TEST(stack_size)
{
    struct clock *clock = two_pipes();
    for (unsigned words = 63; words <= 65; words++) {
        driven_pc = 0x40000;
        for (unsigned half = 0; half < 2 * words - 1; half++)
            scalar(clock, "ES", 0, 0, 9);
        branch(clock, "BEQ", 0x40000);
        assert_int_equal(clocks_for(clock, C205_BRANCH), words <= 64 ? 8 : 16);
        clock_reset(clock);
    }
    for (unsigned back = 63; back <= 64; back++) { /* of longer code, too */
        driven_pc = 0x40000;
        for (unsigned half = 0; half < 199; half++)
            scalar(clock, "ES", 0, 0, 9);
        branch(clock, "BEQ", 0x40000 + (99 - back) * 64);
        assert_int_equal(clocks_for(clock, C205_BRANCH), back <= 63 ? 8 : 16);
        clock_reset(clock);
    }
    clock_free(clock);
}

/* After a loop has run once its whole body is in the stack. */
TEST(forward_branch)
{
    struct clock *clock = two_pipes();
    driven_pc = 0x10000;
    for (int i = 0; i < 9; i++)
        scalar(clock, "ES", 0, 0, 9);
    branch(clock, "BEQ", 0x10000);
    branch(clock, "BEQ", 0x10000 + 4 * 64);
    assert_int_equal(clocks_for(clock, C205_BRANCH), 16);
    branch(clock, "BEQ", 0x10000 + 5 * 64);
    assert_int_equal(clocks_for(clock, C205_BRANCH), 16 + 16);
    clock_free(clock);
}

/* ---- Everything at once -------------------------------------------------- */

static void random_instruction(struct clock *clock, c205_word *indices)
{
    const c205_insn *row = &c205_insns[random_bits() % c205_insn_count];
    unsigned r = (unsigned)(random_bits() % 8);
    unsigned s = (unsigned)(random_bits() % 8);
    struct decoded decoded = insn(row->mnemonic, r, s, (unsigned)(random_bits() % 8));
    struct effect effect = no_effect;
    decoded.region = random_bits() % 16 ? 0 : 1;
    effect.taken = row->unit == C205_UNIT_BRANCH && random_bits() % 2;
    effect.target = random_bits() % 32768 / 32 * 32;
    effect.swapped = random_bits() % 16;
    effect.touch_count = c205_unit_is_vector(row->unit) ? 3 : 1;
    for (unsigned i = 0; i < effect.touch_count; i++) {
        effect.touch[i].address = random_bits() % (24 * PAGE_BITS);
        effect.touch[i].bits = 64 * (random_bits() % 100);
    }
    if (c205_unit_is_vector(row->unit))
        effect.elements = random_bits() % 100;
    if (row->timing == C205_TIMING_vgather)
        effect.indices = indices;
    effect.table_step = 64;
    charge(clock, decoded, &effect);
}

/* The accounts sum to the time after each instruction, however they mix;
 * the drain asserts it too. */
TEST(sum)
{
    static const char *const names[] = { "", "other" };
    c205_error error;
    c205_word indices[100];
    struct clock *clock = two_pipes();
    assert_true(clock_set_regions(clock, names, 2, &error));
    for (size_t i = 0; i < 100; i++)
        indices[i] = random_bits();
    for (int i = 0; i < 20000; i++) {
        uint64_t sum = 0, before = clock_now(clock);
        random_instruction(clock, indices);
        for (int cause = 0; cause < C205_CAUSES; cause++)
            sum += clocks_for(clock, (c205_cause)cause);
        assert_int_equal(sum, clock_now(clock));
        assert_true(clock_now(clock) > before);
        if (i % 100 == 0)
            clock_drain(clock);
    }
    clock_drain(clock);
    assert_int_equal(clock_account(clock, 0)->instructions
                         + clock_account(clock, 1)->instructions,
                     20000);
    clock_free(clock);
}

TEST(cause_names)
{
    for (int cause = 0; cause < C205_CAUSES; cause++)
        assert_non_null(c205_cause_name((c205_cause)cause));
    assert_string_equal(c205_cause_name(C205_PAGE_FAULT), "page fault");
}
