/* test_runtime_checks.c - runtime warnings are compared with expected warnings and
 * their lines, for faulty programs and for similar correct programs. The loss of bits
 * is compared with the arithmetic of the machine. A warning that is missing or false
 * fails here. */
#include <math.h>

#include "tests/unit/saved_machine.h"

#include "asm/check/precision.h"
#include "asm/check/runtime_check.h"
#include "tests/random.h"
#include "vm/number/arith.h"

static char *watched(const struct object *object, const struct warning_choice *choice)
{
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &failure);
    SCOPED(c205) *machine = machine_with(&object->program, model);
    struct text_buffer report = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&report);
    struct runtime_checker *watch = NON_NULL(
        runtime_new(object, "test.o", choice, &sink));
    assert_true(c205_listen(machine, runtime_listen, watch));
    runtime_begin(watch, machine);
    c205_run(machine, 1000000);
    assert_int_equal(runtime_warned(watch) != 0, report.length > 0);
    assert_int_equal(runtime_found(watch)->count, count_of(report.text, "[-W"));
    runtime_free(watch);
    return report.text;
}

/* Fails unless the program causes one warning with `said`, or none for "". */
static void check(const char *text, const char *said)
{
    static const struct warning_choice all;
    SCOPED(object) *object = good(text);
    FREED char *report = watched(object, &all);
    FAIL_IF(*said ? count_of(report, said) != 1 || count_of(report, "[-W") != 1
                  : report != NULL,
            "%s\nexpected '%s', found '%s'", text, said, report ? report : "");
}

#define DATA \
    " .include \"core.s\"\n .data\n .vector x, 3, 1, 2, 3\n" \
    " .vector f, 3, 1.0, 2.0, 3.5\n .vector y, 3\n .vector after, 8\n" \
    " .bitvector odd, 3, \"010\"\n .code\n" \
    " .regs r10, xs, fs, ys, zs, a\n" \
    " descriptor xs, x, 3\n descriptor fs, f, 3\n descriptor ys, y, 3\n" \
    " descriptor zs, odd, 3\n"
#define LINE "test.s:14:2: warning: "
/* Checks a program that consists of the data, these instructions and EXIT. */
#define check_data(instructions, said) check(DATA instructions " EXIT\n", said)

TEST(integers)
{
    check_data(" MPYSV [xs], a, [ys]\n", "");
    check_data("\n ES a, 3\n MPYSV [xs], a, [ys]\n",
               "test.s:16:2: warning: element 0 of [r10] is the integer 1, not"
               " 1.0, so bits are lost: 3 becomes 2");
    check_data(" MPYSV [xs], [fs], [xs]\n", LINE "element 2 of [r10] is the integer 3");
    check_data(" MPYSV [xs], [fs], [ys] ? [zs]\n", "");
    check_data(" MPYSV [xs], [fs], [ys] ?! [zs]\n", LINE "element 2");
    check_data(" DOTV [fs], [xs], r20\n", "");
    check_data(" SQRTV [xs], [ys]\n", LINE "element 1 of [r10]");
    check_data(" ADDUV [xs], [fs], [ys]\n", LINE "element 2");
    check_data(" ADDNV [xs], [fs], [ys]\n", "");
    check_data(" MPYLV [xs], [xs], [ys]\n", "");
    check_data(" MPYSV [fs], [fs], [ys]\n", "");
    check_data(" LINKV\n MPYSV [xs], [fs], [ys]\n ADDNV [ys], [fs], [ys]\n",
               "test.s:15:2: warning: element 2");
    check(" ES r1, 3\n ES r2, 1\n MPYS r1, r2, r1\n EXIT\n",
          "test.s:3:2: warning: r1 is the integer 3, not 3.0, so bits are"
          " lost: 3 becomes 2");
    check(" ES r1, 3\n ADDN r1, r0, r1\n MPYS r1, r1, r1\n EXIT\n", "");
    check(" ES r1, 4\n ES r2, 2\n MPYS r1, r2, r1\n EXIT\n", "");
    check(" ES r1, 2\n SQRT r1, r1\n EXIT\n", "1.4142135623731 becomes 1");
    check(" EXH h2, 3\n EXH h4, 1\n MPYSH h2, h4, h2\n EXIT\n", "h2 is the integer 3");
    check(" ES r1, 9\n EX r2, top\n"
          "top: ES r3, 3\n DIVS r1, r1, r4\n ES r5, 1\n MPYS r3, r5, r4\n"
          " DBNZ r1, [r2]\n EXIT\n",
          "test.s:6:2: warning: r3 is the integer 3");
}

TEST(recurrences)
{
    check_data(" RTOR fs, a\n IX a, 64\n ELEN a, 2\n ADDNV [fs], [fs], [a]\n",
               "test.s:17:2: warning: 1 element of [r11] is a result of this");
    check_data(" RTOR fs, a\n IX a, 128\n ELEN a, 1\n ADDNV [fs], [fs], [a]\n", "");
    check_data(" ADDNV [fs], [fs], [fs]\n", "");
    check_data(" RTOR fs, a\n IX fs, 64\n ELEN fs, 2\n ELEN a, 2\n"
               " ADDNV [fs], [fs], [a]\n",
               "");
    check_data(" RTOR fs, a\n IX a, 64\n ELEN a, 2\n ELEN fs, 2\n"
               " ELEN ys, 2\n LINKV\n ADDNV [fs], r0, [ys]\n MPYSV [ys], [fs], [a]\n",
               "warning: 1 element of a source is a result of this pair");
}

TEST(lengths)
{
    check_data(" EX a, y\n ADDNV [fs], [fs], [a]\n",
               "test.s:15:2: warning: r14 has the address 800180 but no length");
    check_data(" EX a, y\n ADDNV [a], [fs], [ys]\n", "r14 has the");
    check_data(" EX a, y\n ELEN a, 0\n ADDNV [fs], [fs], [a]\n",
               "the length of [r14] was set to 0 [-Wzero-length]");
    check_data(" EX a, y\n CPSV [fs], [a] ? [zs]\n ADDNV [a], [a], [a]\n", "");
    check_data(" EX a, y\n SUBX r0, r0, r20\n ADDLEN a, r20, a\n"
               " ADDNV [fs], [fs], [a]\n",
               "r14 has the");
    check_data(" .data\nempty: .descriptor 0, y\n .code\n EX a, empty\n"
               " LOD [a], a\n ADDNV [fs], [fs], [a]\n",
               "");
}

TEST(indices)
{
    check_data(" VXTOV [fs], [xs], [ys]\n",
               LINE "element 0 of the index list [r11] is 1, not an integer");
    check_data(" ELEN xs, 2\n VXTOV [xs], [fs], [ys]\n", "");
    /* 2 x 2^3 is not normalised, and its low 48 bits are the index 2. */
    check(" .include \"core.s\"\n .data\nlist: .word 0, X'0003 0000 0000 0002'\n"
          " .vector f, 3, 1.0, 2.0, 3.0\n .vector y, 2\n .code\n"
          " descriptor r10, list, 2\n descriptor r11, f, 3\n descriptor r12, y, 2\n"
          " VXTOV [r10], [r11], [r12]\n EXIT\n",
          "element 1 of the index list [r10] is 16, not an integer");
    check_data(" VTOVX [fs], [fs], [ys]\n", "[-Wfloat-index]");
    check_data(" load_constant a, 2.0\n VGATHP a, [fs], [ys]\n", "[-Wfloat-index]");
    check_data(" ES a, 3\n VGATHP a, [fs], [ys]\n", "");
    check_data(" load_constant a, 2.0\n LOD [fs, a], r20\n",
               "the index in r14 is 2, not an integer");
    check_data(" ES a, 2\n LOD [fs, a], r20\n", "");
    check_data(" load_constant a, 0.0\n LOD [fs, a], r20\n", "");
}

TEST(storage)
{
    /* A result without elements does not change its length. */
    check(DATA
          " EX ys, y\n ELEN zs, 1\n CPSV [fs], [ys] ? [zs]\n ADDNV [ys], [ys], [ys]\n "
          "EXIT\n",
          "");
    /* After the end no instruction is executed. */
    check_data(" ES a, 11\n EXIT\n STO [ys, a], a\n", "");
    check_data(" ES a, 11\n STO [ys, a], a\n", "index 11 is beyond the storage of 'y'");
    check_data(" ELEN ys, 4\n VTOV [fs], [ys]\n",
               "test.s:15:2: warning: the result extends to address 800280, but"
               " the storage of 'y' ends at 800240 [-Wpast-storage]");
    check_data(" ELEN ys, 2\n VTOV [fs], [ys]\n", "");
    check_data(" ES r13, 1\n VTOV [fs], [ys, r13]\n", "");
    check_data(" EX ys, y\n ADDLEN ys, xs, ys\n ELEN ys, 3\n"
               " IX ys, 64\n VTOV [fs], [ys]\n",
               "'y' ends at 800240");
    check_data(" ELEN fs, 3\n VTOVX [xs], [fs], [ys]\n",
               "test.s:15:2: warning: index 3 is beyond the storage of 'y'");
    check_data(" ELEN fs, 3\n ES a, 2\n VSCATP a, [fs], [ys]\n",
               "test.s:16:2: warning: index 4 is beyond the storage of 'y'");
    check_data(" ELEN fs, 3\n ES a, 1\n VSCATP a, [fs], [ys]\n", "");
    check_data(" ES a, 3\n STO [ys, a], a\n",
               "index 3 is beyond the storage of 'y', which ends at 800240");
    check_data(" ES a, 2\n STO [ys, a], a\n", "");
    check_data(" EX ys, after\n EX zs, odd\n ELEN zs, 65\n"
               " ELEN ys, 8\n CMPEQV [ys], [ys], [zs]\n",
               "'odd' ends at");
    check(DATA " EX a, y\n ELEN fs, 3\n EX zs, ones\n ELEN zs, 7\n"
               " EX xs, after\n ELEN xs, 7\n CPSV [xs], [a] ? [zs]\n EXIT\n"
               " .data\n .bitvector ones, 7, \"1111111\"\n",
          "'y' ends at 800240");
}

/* A program that executes an instruction `times` times, and then with integers. */
#define LATE(times) \
    DATA " ES r20, " #times "\n EX r21, top\n ES r24, 1\n ES r25, 2\n" \
         " ES r23, 0\n" \
         "top: MPYSV [fs], [fs], [ys]\n DBNZ r20, [r21]\n RTOR xs, fs\n" \
         " ES r20, 1\n IBXLT r23, r24, r25, top, r23\n EXIT\n"

TEST(how_often)
{
    check(LATE(9), "element 2 of [r11] is the integer 3");
    check(LATE(15), "element 2 of [r11] is the integer 3");
    check(LATE(16), "");
    check(LATE(31), "element 2 of [r11] is the integer 3");
    check(" .include \"core.s\"\n .data\nalias: .vector y, 3\n"
          " .vector after, 3\n .code\n descriptor r10, y, 4\n"
          " descriptor r11, after, 3\n VTOV [r11], [r11]\n VTOV [r11], [r10]\n EXIT\n",
          "the storage of 'y' ends at 8000C0");
}

TEST(choice)
{
    static const char text[] = " ES r1, 3\n ES r2, 1\n"
                               "a: MPYS r1, r2, r3\n EXIT\n";
    struct warning_choice choice = { 0, true };
    SCOPED(object) *object = good(text);
    struct object bare = *object;
    FREED char *of_lines = watched(object, &choice);
    assert_int_equal(count_of(of_lines, "error: r1 is the integer 3"), 1);
    choice.errors = false;
    bare.line_count = 0;
    FREED char *of_words = watched(&bare, &choice);
    assert_int_equal(count_of(of_words, "test.o: warning: MPYS at 400040: r1 is"
                                        " the integer 3"),
                     1);
    SCOPED(object) *expected = good(" EX r1, 64\n ADDNV [r1], [r1], [r1]\n EXIT\n"
                                    "; expect-warning: unset-length\n");
    struct sink sink = stream_sink(stderr);
    struct runtime_checker *watch = NON_NULL(runtime_new(expected, "", &choice, &sink));
    assert_int_equal(runtime_warned(watch), 0);
    runtime_free(watch);
}

/* ---- The loss of bits --------------------------------------------------- */

static c205_word some_operand(uint64_t *seed, bool half)
{
    int64_t small = xorshift_between(seed, -1000, 1000);
    double number = ldexp((double)xorshift_between(seed, -100000, 100000),
                          (int)xorshift_between(seed, -20, 5));
    if (xorshift(seed) % 2)
        return half ? (c205_word)(small & 0xFFFFFF) << 32 : c205_from_integer(small);
    return half ? c205_half_from_double(number) : c205_from_double(number);
}

static double exact(char sign, double a, double b)
{
    return sign == '+' ? a + b : sign == '-' ? a - b : sign == '*' ? a * b : a / b;
}

/* A loss is reported if and only if the result's error is larger than allowed. */
static void check_loss(const char *mnemonic, arith_binary *operation, char sign,
                       bool half, uint64_t *seed)
{
    const c205_insn *insn = c205_insn_named(mnemonic, strlen(mnemonic));
    double (*value)(c205_word) = half ? c205_half_to_double : c205_to_double;
    double most = half ? 0x1p-16 : 0x1p-40;
    int lost = 0;
    assert_non_null(insn);
    for (int i = 0; i < 20000; i++) {
        c205_word a = some_operand(seed, half), b = some_operand(seed, half);
        struct precision precision;
        uint64_t flags = 0;
        double wanted = exact(sign, value(a), value(b));
        double found = value(operation(a, b, &flags));
        double off = fabs(found - wanted) / fabs(wanted);
        bool reported = precision_is_lost(precision_rule(insn), half, a, b, &precision);
        if (!isfinite(wanted) || wanted == 0)
            assert_false(reported);
        else if (reported ? off < 0.9 * most : off > 1.1 * most)
            fail_msg("%s %llX %llX: %g off by %g", mnemonic, (unsigned long long)a,
                     (unsigned long long)b, wanted, off);
        if (reported && wanted > 0 && isfinite(wanted))
            assert_true(fabs(precision.kept - found) <= fabs(found) * 0x1p-12);
        lost += reported;
    }
    assert_true(lost > 100);
}

TEST(loss)
{
    uint64_t seed = RANDOM_SEED;
    check_loss("ADDU", arith_add_upper, '+', false, &seed);
    check_loss("SUBUV", arith_subtract_upper, '-', false, &seed);
    check_loss("MPYU", arith_multiply_upper, '*', false, &seed);
    check_loss("MPYSV", arith_multiply_significant, '*', false, &seed);
    check_loss("DIVU", arith_divide_upper, '/', false, &seed);
    check_loss("DIVS", arith_divide_significant, '/', false, &seed);
    check_loss("ADDUH", half_add_upper, '+', true, &seed);
    check_loss("MPYSH", half_multiply_significant, '*', true, &seed);
    check_loss("DIVSH", half_divide_significant, '/', true, &seed);
    assert_int_equal(precision_rule(c205_insn_named("ADDN", 4)), PRECISION_FULL);
    assert_int_equal(precision_rule(c205_insn_named("MPYL", 4)), PRECISION_FULL);
}
