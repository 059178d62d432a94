/* test_clock.c - clocks of instructions that check-random does not draw are compared
 * with the formulas of docs/timing.md: linked pairs of units whose start-ups differ
 * from the built-in models, loops as long as the instruction stack, and gathers of
 * 60,000 random elements. A pair, loop or gather with other clocks fails here. All
 * other instructions are compared with a second clock by check-random, and with the
 * closed formula by test_timing. */
#include "tests/random.h"
#include "tests/unit/clock_driver.h"

SCOPED_BY_FREE(clock);

/* Charges a prefix and two instructions without registers. */
static void charge_pair(struct clock *clock, const char *first_name,
                        const char *second_name, uint8_t g)
{
    struct effect effect = no_effect;
    struct decoded first = insn(first_name, 0, 0, 0);
    struct decoded second = insn(second_name, 0, 0, 0);
    struct decoded prefix = insn("LINKV", 0, 0, 0);
    first.fields.g = second.fields.g = g;
    prefix.linked[0] = &first;
    prefix.linked[1] = &second;
    effect.elements = 1001;
    charge(clock, prefix, &effect);
    clock_drain(clock);
}

/* A pair streams at the rate of its slower unit, in either order. A unit with a longer
 * start-up than an addition adds the difference. */
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
    SCOPED(clock) *clock = clock_of("title T\nlike cyber205-2pipe-prior\n"
                                    "startup.vtransmit 60 clk R\n"
                                    "startup.vmultiply 40 clk R\n"
                                    "startup.vlogical 55 clk R\n");
    for (size_t i = 0; i < COUNT(cases); i++) {
        clock_reset(clock);
        charge_pair(clock, cases[i].first, cases[i].second, cases[i].g);
        assert_int_equal(clocks_for(clock, C205_VECTOR_STARTUP), cases[i].startup);
        assert_int_equal(clocks_for(clock, C205_VECTOR_STREAM), cases[i].stream);
        assert_total(clock, cases[i].startup + cases[i].stream);
    }
}

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

enum { LIST = 60000 };

/* The published mean of 40 million elements a second is 1.25 clocks an element. */
TEST(random_gather)
{
    SCOPED(clock) *clock = two_pipes();
    FREED c205_word *indices = calloc(LIST, sizeof *indices);
    uint64_t total = 0, seed = RANDOM_SEED;
    for (int round = 0; round < 10; round++) {
        for (size_t i = 0; i < LIST; i++)
            indices[i] = xorshift(&seed) % 60000;
        total += gather_clocks(clock, indices, LIST);
    }
    assert_in_range(total * 1000 / (10 * LIST), 1245, 1255);
}

/* A loop of exactly 64 words stays in the stack; a loop of 65 words does not. */
TEST(stack_size)
{
    SCOPED(clock) *clock = two_pipes();
    for (unsigned words = 63; words <= 65; words++) {
        driven_pc = 0x40000;
        for (unsigned half = 0; half < 2 * words - 1; half++)
            scalar(clock, "ES", 0, 0, 9);
        branch(clock, "BEQ", 0x40000);
        assert_int_equal(clocks_for(clock, C205_BRANCH), words <= 64 ? 8 : 16);
        clock_reset(clock);
    }
    for (unsigned back = 63; back <= 64; back++) { /* longer code, same result */
        driven_pc = 0x40000;
        for (unsigned half = 0; half < 199; half++)
            scalar(clock, "ES", 0, 0, 9);
        branch(clock, "BEQ", 0x40000 + (99 - back) * 64);
        assert_int_equal(clocks_for(clock, C205_BRANCH), back <= 63 ? 8 : 16);
        clock_reset(clock);
    }
}
