/* test_interrupt.c - vector instructions that are interrupted between any two elements,
 * by the clock limit or by a missing page, are compared with uninterrupted runs. State,
 * clock and accounts must be the same. An element that is lost or computed twice, or a
 * clock that is charged twice, fails here. */
#include "tests/unit/machine_fixture.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"

#include "vm/machine.h"

static c205_model *slow; /* one element or bit per clock, and cheap page faults */

/* for each row of the instruction table: it was interrupted between elements */
static bool *divided;

/* ---- Slices -------------------------------------------------------------- */

/* Runs a machine to its end in slices of `clocks` clocks. If `saving` is set, saves and
 * restores it after each slice. */
static c205_stop run_broken(c205 **machine, uint64_t clocks, bool saving)
{
    c205_stop stop;
    for (;;) {
        uint64_t limit = c205_clock(*machine) + clocks;
        stop = c205_run(*machine, limit);
        if (stop.trap != C205_TRAP_CLOCK_LIMIT)
            return stop;
        assert_sum(*machine);
        assert_int_equal(stop.pc, c205_pc(*machine));
        if ((*machine)->resume.interrupted) {
            assert_int_equal(c205_clock(*machine), limit);
            assert_true(c205_unit_is_vector(stop.insn->unit));
            divided[stop.insn - c205_insns] |= (*machine)->resume.first > 0;
        } else {
            assert_true(c205_clock(*machine) >= limit);
        }
        if (saving)
            *machine = replace(*machine);
    }
}

/* The length of a slice. SAVED selects a run of a few slices, each on a machine that
 * was restored after the previous slice. */
enum { SAVED = 0, SAVED_PIECES = 40 };

/* Runs two equal machines to their ends, one of them in slices, and compares them. */
static void compare_ends(c205 *whole, c205 *broken, uint64_t clocks)
{
    c205_stop one = c205_run(whole, C205_NO_LIMIT);
    bool saving = clocks == SAVED;
    if (saving)
        clocks = c205_clock(whole) / SAVED_PIECES + 1;
    c205_stop other = run_broken(&broken, clocks, saving);
    assert_same_stop(&one, &other);
    assert_same(whole, broken);
    c205_free(whole);
    c205_free(broken);
}

/* ---- Every vector instruction -------------------------------------------- */

static void compare_file(const char *path)
{
    compare_ends(machine_from(path, slow), machine_from(path, slow), 1);
    compare_ends(machine_from(path, slow), machine_from(path, slow), SAVED);
    compare_ends(machine_from(path, prior_model), machine_from(path, prior_model), 7);
}

TEST(rows)
{
    each_file("tests/programs/*.s", compare_file);
    for (size_t i = 0; i < c205_insn_count; i++)
        FAIL_IF(c205_unit_is_vector(c205_insns[i].unit) && !divided[i],
                "%s was never interrupted between elements", c205_insns[i].mnemonic);
    assert_true(each_file("asm/examples/*.s", compare_file) > 6);
}

/* ---- Long vectors -------------------------------------------------------- */

/* a = 1, 1.5, 2 ..; b = .5, 1.5, ..; index lists; every third bit is one. */
static const char preamble[] =
    "        .include \"core.s\"\n"
    "        .equ    n, 3000\n"
    "        .regs   r10, a, b, c, list, bits, more, next, one, half, x, y, z\n"
    "        .regs   r30, zero, seven, three, short, coefficients, two\n"
    "        .regs   r40, sum, sum_low, dot, dot_low, most, where\n"
    "        .data\n"
    "in_a:   .space  4000\n"
    "in_b:   .space  4000\n"
    "in_c:   .space  4000\n"
    "in_list: .space 4000\n"
    "in_bits: .space 100\n"
    "in_more: .space 100\n"
    "        .code\n"
    "        descriptor a, in_a, n\n"
    "        descriptor b, in_b, n\n"
    "        descriptor c, in_c, n\n"
    "        descriptor list, in_list, n\n"
    "        descriptor bits, in_bits, n\n"
    "        descriptor more, in_more, n\n"
    "        descriptor next, in_a + 64, n\n"
    "        descriptor short, in_b, 40\n"
    "        descriptor coefficients, in_b, 7\n"
    "        load_constant one, 1.0\n"
    "        load_constant half, 0.5\n"
    "        ES      zero, 0\n"
    "        ES      two, 2\n"
    "        ES      three, 3\n"
    "        ES      seven, 7\n"
    "        INTVLV  one, half, [a]\n"
    "        INTVLV  half, one, [b]\n"
    "        INTVLV  zero, seven, [list]\n"
    "        MRKO    two, three, [bits]\n"
    "        MRKZ    two, seven, [more]\n";

/* Recurrences, results that overlap operands, and other vector instructions. */
static const char *const long_programs[] = {
    "        ADDNV   [a], one, [next]\n",
    "        ADDNV   [a, seven], [b], [a] ? [bits]\n",
    "        LINKV\n"
    "        MPYSV   [a], half, [c]\n"
    "        ADDNV   [c], [b], [next] ?! [bits]\n",
    "        LINKV\n"
    "        DIVSV   [a], [b], [c]\n"
    "        SHIFTV  [c], two, [next] ? [bits]\n"
    "        LINKV\n"
    "        ORV     [a], [b], [c]\n"
    "        CMPGEV  [c], one, [more]\n",
    "        INTVLV  one, half, [c] ? [bits]\n",
    "        VREVV   [a], [a]\n",
    "        MRGV    [a], [b], [next] ? [bits]\n"
    "        MASKV   [a], [b], [b] ? [more]\n",
    "        CPSV    [a], [a] ? [bits]\n"
    "        CPSV    [b], [next] ?! [more]\n",
    "        ACPSV   [a], [b], [next], [bits]\n",
    "        SUMV    [a], sum ? [bits]\n"
    "        DOTV    [a], [b], dot\n"
    "        MAXV    [a], where, most ?! [bits]\n"
    "        SELGEV  [a], two, z\n",
    "        ELEN    list, 500\n"
    "        VXTOV   [list], [a], [list]\n",
    "        EX      x, in_list\n"
    "        ELEN    list, 500\n"
    "        VTOVX   [list], [a], [x]\n",
    "        ES      x, -3\n"
    "        EX      y, in_a + 64*3900\n"
    "        ELEN    a, 1200\n"
    "        VGATHP  x, [y], [a] ? [bits]\n",
    "        ELEN    b, 600\n"
    "        EX      x, in_b\n"
    "        VSCATP  seven, [b], [x] ?! [more]\n",
    "        POLYV   [a], [coefficients], [next]\n",
    "        SCHGEV  [short], [a], [c]\n"
    "        SCHEQV  [b], [short], [next]\n",
    "        ADDNS   [a, bits], [b, more], [c], [z]\n",
    "        EX      x, in_bits\n"
    "        ELEN    x, 900\n"
    "        SUBNS   [a, more], |[b, bits]|, [x] ? [bits]\n",
    "        EX      z, in_more + 640\n"
    "        RTOR    bits, c\n"
    "        MPYSS   [a, bits], [b, more], [c], [z]\n",
    "        XORB    [bits], [more], [bits]\n"
    "        EX      x, in_bits + 1\n"
    "        ELEN    x, 2500\n"
    "        ORNB    [bits], [more], [x]\n"
    "        MRGB    [bits], [more], [x] ? [more]\n"
    "        CPSB    [bits], [x] ? [more]\n"
    "        CNTLB   [bits], y\n"
    "        CNTOB   [bits], z\n",
};

TEST(long_vectors)
{
    for (size_t i = 0; i < 2 * COUNT(long_programs); i++) {
        const c205_model *on = i % 2 ? slow : prior_model;
        SCOPED(object) *object = good(
            formatted("%s%s        EXIT\n", preamble, long_programs[i / 2]));
        compare_ends(machine_with(&object->program, on),
                     machine_with(&object->program, on), i % 2 ? SAVED : 61);
    }
}

/* The instruction's result overwrites the instruction itself with two EXITs. */
TEST(overwritten_instruction)
{
    static const char program[] =
        "        .data\n"
        "code:   .word   X'0900000009000000', X'0900000009000000'\n"
        "        .code\n"
        "        EX      r5, code\n"
        "        ELEN    r5, 2\n"
        "        EX      r6, there\n"
        "        ELEN    r6, 2\n"
        "        .align  64\n"
        "there:  VTOV    [r5], [r6]\n"
        "        SUMV    [r6], r8\n"
        "        EXIT\n";
    SCOPED(object) *object = good(program);
    SCOPED(c205) *whole = machine_with(&object->program, slow);
    SCOPED(c205) *broken = machine_with(&object->program, slow);
    c205_stop one = c205_run(whole, C205_NO_LIMIT);
    c205_stop other = run_broken(&broken, 1, true);
    assert_int_equal(c205_register(whole, 8), 0);
    assert_same_stop(&one, &other);
    assert_same(whole, broken);
    c205_set_pc(broken, one.pc - 64); /* executes the new instruction */
    assert_int_equal(c205_run(broken, C205_NO_LIMIT).pc, one.pc - 64);
}

/* ---- In the middle of an instruction -------------------------------------- */

/* Loads the code, an operand of 100 ones, and the descriptor of a result. The first
 * element of the result is `offset` words after the first element of the operand. */
static void load_ones(struct small_machine *fixture, uint64_t offset)
{
    load(fixture, 300);
    set(fixture, 1, descriptor(DATA, 100));
    set(fixture, 2, descriptor(DATA + offset * 64, 100));
    for (size_t i = 0; i < 100; i++)
        put_at(fixture, DATA + i * 64, C205_ONE);
}

/* Computes c = a + a for 100 elements, then their sum. */
static void load_sum(struct small_machine *fixture)
{
    begin(fixture);
    add(fixture, "ADDNV", F(.a = 1, .b = 1, .c = 2));
    add(fixture, "SUMV", F(.a = 2, .c = 4));
    add(fixture, "EXIT", F(.r = 0));
    load_ones(fixture, 200);
}

static void assert_doubled(const struct small_machine *fixture, size_t count)
{
    for (size_t i = 0; i < 100; i++)
        assert_int_equal(word_at(fixture, DATA + (200 + i) * 64),
                         i < count ? c205_from_double(2) : 0);
}

static uint64_t charged(const struct small_machine *fixture, c205_cause cause)
{
    return c205_account_at(fixture->machine, 0)->clocks[cause];
}

TEST(in_the_middle)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    load_sum(&fixture);
    c205_stop stop = c205_run(fixture.machine, 51 + 20);
    assert_int_equal(stop.trap, C205_TRAP_CLOCK_LIMIT);
    assert_int_equal(stop.pc, CODE);
    assert_string_equal(stop.insn->mnemonic, "ADDNV");
    assert_int_equal(c205_clock(fixture.machine), 71);
    assert_int_equal(charged(&fixture, C205_VECTOR_STARTUP), 51);
    assert_int_equal(charged(&fixture, C205_VECTOR_STREAM), 20);
    assert_int_equal(c205_account_at(fixture.machine, 0)->instructions, 0);
    assert_doubled(&fixture, 40);
    /* a limit that has passed has no effect */
    stop = c205_run(fixture.machine, 60);
    assert_int_equal(stop.trap, C205_TRAP_CLOCK_LIMIT);
    assert_int_equal(c205_clock(fixture.machine), 71);
    assert_doubled(&fixture, 40);
    stop = c205_run(fixture.machine, 51 + 30);
    assert_doubled(&fixture, 60);
    /* one step completes the instruction */
    assert_true(c205_step(fixture.machine, &stop));
    assert_doubled(&fixture, 100);
    assert_int_equal(c205_pc(fixture.machine), CODE + 64);
}

/* A sum is written to its register only when it is complete. */
TEST(result_at_the_end)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    c205_stop stop;
    load_sum(&fixture);
    assert_true(c205_step(fixture.machine, &stop));
    uint64_t limit = c205_clock(fixture.machine) + 1;
    while (c205_run(fixture.machine, limit).pc == CODE + 64
           && !fixture.machine->resume.first)
        limit++;
    assert_int_equal(c205_pc(fixture.machine), CODE + 64);
    assert_int_equal(get(&fixture, 4), 0);
    assert_int_equal(run(&fixture).trap, C205_TRAP_NONE);
    assert_int_equal(get(&fixture, 4), c205_from_double(200));
}

/* A linked pair computes A / 2 + 1: k / 1.625 elements at clock 113 + k. */
TEST(in_the_middle_of_a_pair)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    c205_word one_and_half = c205_from_double(1.5);
    add(&fixture, "LINKV", F(.f = 0));
    add(&fixture, "DIVSV", F(.g = C205_G_BROADCAST_B, .a = 1, .b = 3, .c = 2));
    add(&fixture, "ADDNV", F(.g = C205_G_BROADCAST_B, .a = 2, .b = 4, .c = 2));
    load_ones(&fixture, 200);
    set(&fixture, 3, c205_from_double(2));
    set(&fixture, 4, C205_ONE);
    c205_stop stop = c205_run(fixture.machine, 113 + 26);
    assert_int_equal(stop.trap, C205_TRAP_CLOCK_LIMIT);
    assert_int_equal(stop.pc, CODE);
    assert_int_equal(charged(&fixture, C205_VECTOR_STARTUP), 113);
    assert_int_equal(charged(&fixture, C205_VECTOR_STREAM), 26);
    for (size_t i = 0; i < 100; i++)
        assert_int_equal(word_at(&fixture, DATA + (200 + i) * 64),
                         i < 16 ? one_and_half : 0);
}

/* Each operation of a pair waits for its own operand, even if interrupted. */
TEST(pair_that_waits)
{
    for (uint8_t late = 3; late <= 4; late++) {
        SCOPED_VALUE(small_machine) fixture = make_small_machine();
        add(&fixture, "DIVU", F(.r = 5, .s = 6, .t = late));
        add(&fixture, "LINKV", F(.f = 0));
        add(&fixture, "DIVSV", F(.g = C205_G_BROADCAST_B, .a = 1, .b = 3, .c = 2));
        add(&fixture, "ADDNV", F(.g = C205_G_BROADCAST_B, .a = 2, .b = 4, .c = 2));
        load_ones(&fixture, 200);
        set(&fixture, 5, c205_from_double(2));
        set(&fixture, 6, C205_ONE);
        set(&fixture, 3, C205_ONE);
        set(&fixture, 4, C205_ONE);
        c205_stop stop = c205_run(fixture.machine, 54 + 113 + 26);
        assert_int_equal(stop.trap, C205_TRAP_CLOCK_LIMIT);
        assert_int_equal(charged(&fixture, C205_OPERAND_WAIT), 53);
        assert_int_equal(charged(&fixture, C205_VECTOR_STARTUP), 113);
    }
}

/* If an interruption comes while an element waits for the result of an earlier one, the
 * waiting element is not among the elements done. */
TEST(in_the_middle_of_a_recurrence)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    uint64_t fault = 1030;
    add(&fixture, "ADDNV", F(.g = C205_G_BROADCAST_B, .a = 1, .b = 3, .c = 2));
    add(&fixture, "EXIT", F(.r = 0));
    load(&fixture, 300);
    set(&fixture, 1, descriptor(DATA, 100));
    set(&fixture, 2, descriptor(DATA + 64, 100));
    set(&fixture, 3, C205_ONE);
    c205_run(fixture.machine, 51 + 20);
    assert_int_equal(c205_clock(fixture.machine), 51 + 20);
    assert_int_equal(word_at(&fixture, DATA + 40 * 64), c205_from_double(40));
    assert_int_equal(word_at(&fixture, DATA + 41 * 64), 0);
    assert_int_equal(run(&fixture).trap, C205_TRAP_NONE);
    assert_int_equal(word_at(&fixture, DATA + 100 * 64), c205_from_double(100));
    assert_int_equal(c205_clock(fixture.machine), 51 + fault + 50 + 99 * 51);
}

/* Setting the program counter abandons the instruction, but its time remains. Resetting
 * the clock does not abandon it, because its first operand has been read. */
TEST(given_up_or_reset)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    load_sum(&fixture);
    assert_int_equal(run(&fixture).trap, C205_TRAP_NONE);
    uint64_t whole = c205_clock(fixture.machine);
    for (int reset = 0; reset < 2; reset++) {
        load_sum(&fixture);
        c205_run(fixture.machine, 71);
        if (reset) {
            c205_reset_clock(fixture.machine);
            put_at(&fixture, DATA, C205_MACHINE_ZERO);
        } else {
            c205_set_pc(fixture.machine, CODE);
            assert_int_equal(c205_clock(fixture.machine), 71);
        }
        assert_int_equal(run(&fixture).trap, C205_TRAP_NONE);
        assert_doubled(&fixture, 100);
        assert_int_equal(c205_clock(fixture.machine), whole + (reset ? 0 : 71));
    }
}

/* After the clock is reset in the middle of an instruction, the remaining time of the
 * job interval timer is unchanged. This also holds after a restore. */
TEST(reset_timer)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    add(&fixture, "WJTIME", F(.r = 3));
    add(&fixture, "ADDNV", F(.a = 1, .b = 1, .c = 2));
    add(&fixture, "RJTIME", F(.t = 4));
    add(&fixture, "EXIT", F(.r = 0));
    load_ones(&fixture, 200);
    set(&fixture, 3, 1000);
    c205_run(fixture.machine, 71);
    assert_true(fixture.machine->resume.first > 0);
    fixture.machine = replace(fixture.machine);
    c205_reset_clock(fixture.machine);
    assert_int_equal(run(&fixture).trap, C205_TRAP_NONE);
    assert_int_equal(get(&fixture, 4), 1000 - 71 - 1);
}

/* The clock limit is checked before the instruction is decoded. */
TEST(limit_before_undefined)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    load(&fixture, 1);
    c205_stop stop = c205_run(fixture.machine, 0);
    assert_int_equal(stop.trap, C205_TRAP_CLOCK_LIMIT);
    assert_null(stop.insn);
    assert_int_equal(run(&fixture).trap, C205_TRAP_UNDEFINED_INSTRUCTION);
}

/* ---- Pages --------------------------------------------------------------- */

#define NEXT_PAGE (DATA + C205_PAGE_WORDS * UINT64_C(64))

static void map_next_page(c205 *machine)
{
    c205_word words[60];
    for (size_t i = 0; i < 60; i++)
        words[i] = C205_ONE;
    assert_true(c205_map(machine, NEXT_PAGE, 60, C205_READ_WRITE, &failure));
    assert_true(c205_write(machine, NEXT_PAGE, words, 60));
}

/* A vector across a page's end, or short before it, with other results in flight. */
static void load_crossing(struct small_machine *fixture, bool short_one)
{
    begin(fixture);
    add(fixture, "LOD", F(.r = 4, .t = 5));
    add(fixture, "DIVS", F(.r = 6, .s = 6, .t = 7));
    add(fixture, "ADDNV", F(.a = 1, .b = 1, .c = 2));
    add(fixture, "LOD", F(.r = 8, .t = 9));
    add(fixture, "ADDN", F(.r = 9, .s = 7, .t = 10));
    add(fixture, "EXIT", F(.r = 0));
    load(fixture, 300);
    set(fixture, 1,
        short_one ? descriptor(DATA, 30) : descriptor(NEXT_PAGE - 40 * 64, 100));
    set(fixture, 2, descriptor(DATA, 100));
    set(fixture, 4, DATA);
    set(fixture, 6, C205_ONE);
    set(fixture, 8, NEXT_PAGE);
}

/* After the missing page is mapped, the run ends as if the page had always been mapped.
 * A vector, or a load of a scalar after a short vector, accesses the missing page. */
TEST(missing_page)
{
    for (int scalar = 0; scalar < 2; scalar++) {
        SCOPED_VALUE(small_machine) with = make_small_machine();
        SCOPED_VALUE(small_machine) without = make_small_machine();
        load_crossing(&with, scalar);
        load_crossing(&without, scalar);
        map_next_page(with.machine);
        c205_stop stop = run(&without);
        assert_int_equal(stop.trap, C205_TRAP_UNMAPPED_ADDRESS);
        assert_int_equal(stop.address, NEXT_PAGE);
        assert_int_equal(word_at(&without, DATA) != 0, scalar);
        assert_sum(without.machine);
        if (!scalar) /* results in flight */
            assert_true(charged(&without, C205_OPERAND_WAIT) > 30);
        without.machine = replace(without.machine);
        map_next_page(without.machine);
        assert_int_equal(run(&without).trap, C205_TRAP_NONE);
        assert_int_equal(run(&with).trap, C205_TRAP_NONE);
        assert_same(with.machine, without.machine);
    }
}

static void set_access(struct small_machine *fixture, c205_access access)
{
    assert_true(c205_map(fixture->machine, DATA, 300, access, &failure));
}

/* An instruction that traps when it continues stays at the same element. */
TEST(trap_in_the_middle)
{
    SCOPED_VALUE(small_machine) broken = make_small_machine();
    SCOPED_VALUE(small_machine) whole = make_small_machine();
    load_sum(&broken);
    load_sum(&whole);
    c205_run(broken.machine, 71);
    set_access(&broken, C205_READ_ONLY);
    c205_stop stop = run(&broken);
    assert_int_equal(stop.trap, C205_TRAP_PROTECTED_ADDRESS);
    assert_int_equal(c205_clock(broken.machine), 71);
    assert_sum(broken.machine);
    assert_doubled(&broken, 40);
    set_access(&broken, C205_READ_WRITE);
    assert_int_equal(run(&broken).trap, C205_TRAP_NONE);
    assert_int_equal(run(&whole).trap, C205_TRAP_NONE);
    assert_same(broken.machine, whole.machine);
}

/* An index list that its result overwrites traps before any element is computed. */
TEST(bad_index_behind_the_limit)
{
    SCOPED_VALUE(small_machine) fixture = make_small_machine();
    add(&fixture, "VXTOV", F(.a = 1, .b = 2, .c = 3));
    load(&fixture, 300);
    set(&fixture, 1, descriptor(DATA, 40));
    set(&fixture, 2, DATA);
    set(&fixture, 3, descriptor(DATA + 64, 40));
    put_at(&fixture, DATA, 50);
    put_at(&fixture, DATA + 50 * 64, 51);
    put_at(&fixture, DATA + 51 * 64, UINT64_C(1) << 40);
    c205_stop stop = c205_run(fixture.machine, 69 + 2);
    assert_int_equal(stop.trap, C205_TRAP_UNMAPPED_ADDRESS);
    assert_int_equal(word_at(&fixture, DATA + 64), 0);
}

/* ---- The models ---------------------------------------------------------- */

FIXTURE(find_models)
{
    slow = c205_model_parse("slow",
                            "title one element a clock\n"
                            "like cyber205-1pipe-prior\n"
                            "stream.vbits 1 clk/bit R\n"
                            "page_fault.clocks 1 clk R\n",
                            &failure);
    divided = calloc(c205_insn_count, sizeof *divided);
    return set_up_model(test_state) || !slow || !divided;
}

FIXTURE(drop_models)
{
    c205_model_free(slow);
    free(divided);
    return tear_down_model(test_state);
}

GROUP(find_models, drop_models);
