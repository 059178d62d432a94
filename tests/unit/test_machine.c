/* test_machine.c - the behaviour of a machine apart from the results of instructions,
 * and SWAP. Traps with their addresses and messages, limits, regions, events and copies
 * of memory are compared with expected values. check-programs compares results of
 * instructions with results computed by hand, and check-random with a second
 * interpreter. A trap that is missing, or reported with another address, fails here. */
#include "machine_fixture.h"

static c205_stop expect_stop(struct small_machine *fixture, c205_trap trap,
                             uint64_t address)
{
    c205_stop stop = run(fixture);
    assert_int_equal(stop.trap, trap);
    assert_int_equal(stop.address, address);
    return stop;
}

static void expect_message(const struct small_machine *fixture, c205_stop stop,
                           const char *message)
{
    c205_error error;
    c205_describe_stop(fixture->machine, &stop, &error);
    assert_string_equal(error.message, message);
}

/* SWAP saves registers before it loads registers. Register 0 does not change. */
TEST(swap)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    add(&fixture, "SWAP", F(.r = 1, .s = 10, .t = 2));
    add(&fixture, "SWAP", F(.r = 1, .s = 0, .t = 0));
    add(&fixture, "EXIT", F(.r = 0));
    load(&fixture, 100);
    for (unsigned i = 0; i < 4; i++) {
        set(&fixture, 10 + i, 100 + i);
        put_at(&fixture, DATA + i * 64, 200 + i);
    }
    set(&fixture, 1, descriptor(DATA, 3));
    set(&fixture, 2,
        descriptor(DATA + 2 * 64, 4)); /* the ranges overlap: registers are saved before
                                        * the load */
    expect_stop(&fixture, C205_TRAP_NONE, 0);
    /* the second SWAP loads the registers 0, 1 and 2; register 0 does not change */
    static const unsigned expected[][2] = { { 10, 200 }, { 11, 201 }, { 12, 100 },
                                            { 13, 103 }, { 0, 0 },    { 1, 201 },
                                            { 2, 100 } };
    for (size_t i = 0; i < COUNT(expected); i++)
        assert_int_equal(get(&fixture, expected[i][0]), expected[i][1]);
    assert_int_equal(word_at(&fixture, DATA + 5 * 64), 103);
}

/* ---- Traps -------------------------------------------------------------- */

static c205_stop run_one(struct small_machine *fixture, const char *mnemonic,
                         c205_fields fields)
{
    begin(fixture);
    add(fixture, "RTOR", F(.r = 0, .t = 0)); /* a short instruction, so that the next
                                              * one is not aligned to a word */
    add(fixture, mnemonic, fields);
    add(fixture, "EXIT", F(.r = 0));
    load(fixture, 100);
    set(fixture, 1, descriptor(DATA, 4));
    set(fixture, 2, descriptor(DATA + 1, 4));
    set(fixture, 3, descriptor(0x800000, 4)); /* not mapped */
    set(fixture, 4, 0xFFFFFFFFFFFF);          /* -1 */
    return run(fixture);
}

static void expect_trap(struct small_machine *fixture, const char *name,
                        uint64_t address, const char *mnemonic, c205_fields fields)
{
    c205_stop stop = run_one(fixture, mnemonic, fields);
    assert_string_equal(c205_trap_name(stop.trap), name);
    assert_int_equal(stop.address, address);
    assert_int_equal(stop.pc, CODE + HALF_WORD);
    assert_int_equal(c205_pc(fixture->machine), CODE + HALF_WORD);
}

TEST(undefined)
{
    static const struct {
        const char *mnemonic;
        c205_fields fields;
    } wrong[] = { { "CONV", { .g = C205_G_HALF, .a = 1, .c = 1 } },
                  { "XORB", { .g = C205_G_HALF, .a = 1, .b = 1, .c = 1 } },
                  { "MAXV", { .g = C205_G_BROADCAST_B, .a = 1, .c = 1 } },
                  { "SUMV", { .a = 1, .c = 5 } },
                  { "DOTV", { .g = C205_G_HALF, .a = 1, .b = 1, .c = 5 } },
                  { "ADDNV", { .g = C205_G_ZEROS, .a = 1, .b = 1, .c = 1 } },
                  { "ADDNV", { .g = C205_G_OFFSET, .a = 1, .b = 1, .c = 255 } },
                  { "ADDNV", { .g = C205_G_BROADCAST_A, .x = 5, .a = 1, .c = 1 } },
                  { "SHIFTV", { .g = C205_G_NEGATE_A, .a = 1, .b = 1, .c = 1 } },
                  { "VTOV", { .g = C205_G_BROADCAST_B, .a = 1, .c = 1 } },
                  { "VTOV", { .g = C205_G_MAGNITUDE_B, .a = 1, .c = 1 } },
                  { "INTVLV", { .g = C205_G_BROADCAST_A, .a = 1, .c = 1 } },
                  { "SUMV", { .g = C205_G_OFFSET, .a = 1, .c = 2 } },
                  { "VTOVX", { .g = C205_G_OFFSET, .a = 1, .b = 1, .c = 1 } },
                  { "XORB", { .g = C205_G_ZEROS, .a = 1, .b = 1, .c = 1 } },
                  { "SUMV", { .a = 1, .c = 255 } },
                  { "IBXEQ", { .g = 1, .a = 1 } } };
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    for (size_t i = 0; i < COUNT(wrong); i++)
        expect_trap(&fixture, "undefined-instruction", 0, wrong[i].mnemonic,
                    wrong[i].fields);
    begin(&fixture);
    add_half(&fixture, 0xFF000000);
    load(&fixture, 1);
    c205_stop stop = expect_stop(&fixture, C205_TRAP_UNDEFINED_INSTRUCTION, 0);
    assert_null(stop.insn);
    expect_message(&fixture, stop,
                   "trap undefined-instruction at 400000: FF000000: no "
                   "instruction has this code");
    begin(&fixture);
    add(&fixture, "VTOV", F(.a = 1, .c = 1));
    fixture.code[0] |= 1 << 16; /* sets field B, which the format does not have */
    load(&fixture, 1);
    expect_stop(&fixture, C205_TRAP_UNDEFINED_INSTRUCTION, 0);
}

/* The low three bits of G control the signs of the operands. For instance, G = 05 adds
 * magnitudes, as programs of the 1980s show. For each value of these bits, the test
 * computes ADDNV of the pairs (-2, -3) and (2, -3). */
TEST(sign_bits)
{
    static const double sums[][2] = { { -5, -1 }, { 1, 5 }, { -1, -5 }, { 5, 1 },
                                      { -1, -1 }, { 5, 5 }, { -5, -5 }, { 1, 1 } };
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    for (uint32_t g = 0; g < 8; g++) {
        begin(&fixture);
        add_half(&fixture, 0x82000001 | (c205_word)g << 16);
        add_half(&fixture, 0x00020003);
        add(&fixture, "EXIT", F(.r = 0));
        load(&fixture, 300);
        set(&fixture, 1, descriptor(DATA, 2));
        set(&fixture, 2, descriptor(DATA + 128, 2));
        set(&fixture, 3, descriptor(DATA + 256, 2));
        for (uint64_t i = 0; i < 2; i++) {
            put_at(&fixture, DATA + i * 64, c205_from_double(i == 0 ? -2 : 2));
            put_at(&fixture, DATA + (2 + i) * 64, c205_from_double(-3));
        }
        expect_stop(&fixture, C205_TRAP_NONE, 0);
        for (uint64_t i = 0; i < 2; i++)
            assert_int_equal(word_at(&fixture, DATA + (4 + i) * 64),
                             c205_from_double(sums[g][i]));
    }
}

TEST(operand_traps)
{
    uint64_t odd = DATA + 1, out = 0x800000;
    SCOPED_VALUE(small_machine) l = make_small_machine();
    const char *bad = "bad-descriptor", *misaligned = "misaligned-operand";
    const char *unmapped = "unmapped-address";
    expect_trap(&l, unmapped, out, "LOD", F(.r = 3, .t = 5));
    expect_trap(&l, misaligned, odd, "STO", F(.r = 2, .t = 5));
    expect_trap(&l, misaligned, odd, "BIM", F(.r = 2));
    expect_trap(&l, misaligned, odd, "BSAVE", F(.r = 1, .t = 2));
    expect_trap(&l, misaligned, odd, "ADDNV", F(.a = 1, .b = 2, .c = 1));
    expect_trap(&l, unmapped, out, "ADDNV", F(.a = 1, .b = 1, .c = 3));
    expect_trap(&l, unmapped, out, "ADDNV", F(.a = 1, .b = 1, .z = 3, .c = 1));
    expect_trap(&l, bad, 0, "ADDNV", F(.a = 1, .x = 4, .b = 1, .c = 1));
    expect_trap(&l, bad, 0, "MASKV", F(.a = 1, .b = 1, .c = 1));
    expect_trap(&l, bad, 0, "SUMV", F(.g = C205_G_BROADCAST_A, .a = 1, .c = 6));
    expect_trap(&l, bad, 0, "DOTV",
                F(.g = C205_G_BROADCAST_A | C205_G_BROADCAST_B, .a = 1, .b = 1,
                  .c = 6));
    expect_trap(&l, bad, DATA, "SWAP", F(.r = 1, .s = 253));
    expect_trap(&l, unmapped, out, "SWAP", F(.r = 1, .s = 10, .t = 3));
    expect_trap(&l, "bad-request", 0, "EXIT", F(.immediate = 8));
    expect_trap(&l, unmapped, out, "EXIT", F(.r = 3, .immediate = 6));
    expect_trap(&l, "bad-link", 0, "LINKV", F(.f = 0));
}

/* Address 0 is reported like any other address. */
TEST(messages)
{
    static const c205_fields at_0 = { .r = 0, .t = 5 }, at_data = { .r = 1, .t = 1 };
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    add(&fixture, "LOD", at_0);
    load(&fixture, 1);
    expect_message(&fixture, run(&fixture),
                   "trap unmapped-address at 400000: LOD: address 0: "
                   "no memory is mapped there");
    begin(&fixture);
    add(&fixture, "STO", at_data);
    load(&fixture, 1);
    set(&fixture, 1, DATA);
    assert_true(c205_map(fixture.machine, DATA, 1, C205_READ_ONLY, &failure));
    c205_stop stop = run(&fixture);
    assert_string_equal(c205_trap_name(stop.trap), "protected-address");
    expect_message(&fixture, stop,
                   "trap protected-address at 400000: STO: address 10000000: "
                   "this memory may only be read");
    assert_int_equal(word_at(&fixture, DATA), 0);
}

TEST(fetch)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    load(&fixture, 1);
    c205_set_pc(fixture.machine, CODE + 16);
    assert_int_equal(run(&fixture).trap, C205_TRAP_MISALIGNED_OPERAND);
    c205_set_pc(fixture.machine, 0x800000);
    expect_stop(&fixture, C205_TRAP_UNMAPPED_ADDRESS, 0x800000);
    /* the second half is after the last page */
    put_at(&fixture, 0x800000 - 64, 0xBE000000);
    c205_set_pc(fixture.machine, 0x800000 - 32);
    expect_stop(&fixture, C205_TRAP_UNMAPPED_ADDRESS, 0x800000);
}

TEST(clock_limit)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    add(&fixture, "BIM", F(.r = 0, .immediate = (int64_t)CODE));
    load(&fixture, 1);
    c205_stop stop = c205_run(fixture.machine, 1000);
    assert_string_equal(c205_trap_name(stop.trap), "clock-limit");
    assert_in_range(c205_clock(fixture.machine), 1000, 1100);
    c205_reset_clock(fixture.machine);
    assert_int_equal(c205_clock(fixture.machine), 0);
}

/* First there must be memory for the longest possible result. If this memory is missing
 * but not needed, no later instruction may report a fault. */
TEST(compress_leaves_no_fault)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    uint64_t end = DATA + C205_PAGE_WORDS * UINT64_C(64);
    add(&fixture, "CPSV", F(.a = 1, .z = 2, .c = 3));
    add(&fixture, "SUMV", F(.g = C205_G_BROADCAST_A, .a = 1, .c = 6));
    load(&fixture, 100);
    set(&fixture, 1, descriptor(DATA, 2));
    set(&fixture, 2, descriptor(DATA, 2)); /* zeros: no element is selected */
    set(&fixture, 3, end - 64);
    expect_stop(&fixture, C205_TRAP_BAD_DESCRIPTOR, 0);
}

/* ---- Regions, events ---------------------------------------------------- */

static void expect_no_load(const struct small_machine *fixture,
                           const c205_program *program, const char *message)
{
    c205_error error;
    assert_false(c205_load(fixture->machine, program, &error));
    assert_string_equal(error.message, message);
}

TEST(regions)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    c205_region regions[] = { { "late", CODE + 64, CODE + 96 },
                              { "early", CODE, CODE + 32 },
                              { "late", CODE + 128, CODE + 160 } };
    c205_segment segment = { CODE, CODE_WORDS, fixture.code };
    c205_program program = { CODE, 1, &segment, 3, regions, false };
    for (unsigned i = 0; i < 5; i++)
        add(&fixture, "RTOR", F(.r = 0, .t = 0));
    add(&fixture, "EXIT", F(.r = 0));
    assert_true(c205_load(fixture.machine, &program, &failure));
    expect_stop(&fixture, C205_TRAP_NONE, 0);
    assert_int_equal(c205_account_count(fixture.machine), 3);
    const c205_account *late = c205_account_at(fixture.machine, 1);
    assert_string_equal(late->name, "late");
    assert_int_equal(late->instructions, 2);
    assert_int_equal(late->entries, 2);
    regions[1].end = CODE + 65;
    expect_no_load(&fixture, &program, "the region late overlaps another, at 400040");
    regions[1].end = CODE - 32;
    expect_no_load(&fixture, &program,
                   "the region early ends before it begins, at 400000");
    program.region_count = 0;
    segment.address = CODE + 32;
    expect_no_load(&fixture, &program, "a segment at 400020 does not begin on a word");
}

struct heard {
    unsigned count[4];
    uint64_t clocks;
    unsigned request;
    c205_word r;
    bool taken;
};

static void listen(void *context, const c205 *machine UNUSED, const c205_event *event)
{
    struct heard *heard = context;
    heard->count[event->kind]++;
    heard->clocks += event->clocks;
    heard->taken = heard->taken || event->taken;
    if (event->kind == C205_EVENT_REQUEST) {
        heard->request = event->request;
        heard->r = event->r;
    }
}

TEST(events)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    struct heard heard = { { 0 }, 0, 0, 0, false };
    add(&fixture, "ES", F(.r = 1, .immediate = 7));
    add(&fixture, "EXIT", F(.r = 1, .immediate = 2));
    add(&fixture, "BIM", F(.r = 0, .immediate = (int64_t)CODE + 128));
    add(&fixture, "EXIT", F(.r = 0));
    load(&fixture, 1);
    assert_true(c205_listen(fixture.machine, listen, &heard));
    expect_stop(&fixture, C205_TRAP_NONE, 0);
    assert_int_equal(heard.count[C205_EVENT_INSTRUCTION], 3);
    assert_int_equal(heard.count[C205_EVENT_REQUEST], 1);
    assert_int_equal(heard.count[C205_EVENT_STOP], 1);
    assert_int_equal(heard.clocks, c205_clock(fixture.machine));
    assert_int_equal(heard.request, 2);
    assert_int_equal(heard.r, 7);
    assert_true(heard.taken);
    c205_set_pc(fixture.machine, 0);
    run(&fixture);
    assert_int_equal(heard.count[C205_EVENT_TRAP], 1);
    for (unsigned i = 1; i < C205_LISTENERS; i++)
        assert_true(c205_listen(fixture.machine, listen, &heard));
    assert_false(c205_listen(fixture.machine, listen, &heard));
}

TEST(step)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    c205_stop stop;
    add(&fixture, "ES", F(.r = 1, .immediate = 7));
    add(&fixture, "EXIT", F(.r = 1));
    load(&fixture, 1);
    assert_true(c205_step(fixture.machine, &stop));
    assert_int_equal(c205_pc(fixture.machine), CODE + 32);
    assert_false(c205_step(fixture.machine, &stop));
    assert_int_equal(stop.status, 7);
}

TEST(host_copies)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    c205_word words[2] = { 1, 2 };
    load(&fixture, 2);
    assert_true(c205_write(fixture.machine, DATA, words, 2));
    assert_false(c205_write(fixture.machine, DATA + 32, words, 2));
    assert_false(c205_read(fixture.machine, 0x800000 - 64, words, 2));
    assert_int_equal(words[0], 1);
}
