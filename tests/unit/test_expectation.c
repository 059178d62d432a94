/* test_expectation.c - expectations of a program are compared with its results, for
 * correct and slightly wrong expectations of every kind. A wrong expectation that
 * passes, or a correct expectation that fails, is an error here. */
#include "tests/unit/asm_helper.h"

#include "asm/check/expect.h"
#include "asm/view/print.h"

static const char program[] = " .include \"print.s\"\n"
                              " .data\n"
                              " .half 0\n"
                              "odd: .half X'A0000000'\n"
                              "v: .word 1, 2\n"
                              " .code\n"
                              " EX r10, 5\n"
                              " print_integer r10\n"
                              " EXIT\n";

/* Runs the program with one expectation. Returns true if the expectation holds. */
static bool holds(const char *expectation)
{
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe-prior", &failure);
    SCOPED(c205) *machine = c205_new(model, &failure);
    SCOPED_VALUE(text_buffer) printed = { NULL, 0, 0, false };
    SCOPED_VALUE(text_buffer) said = { NULL, 0, 0, false };
    struct printer printer = { text_buffer_sink(&printed) };
    struct sink report = text_buffer_sink(&said);
    SCOPED(object) *object = good(formatted("%s; %s\n", program, expectation));
    assert_true(c205_listen(machine, printer_listen, &printer));
    assert_true(c205_load(machine, &object->program, &failure));
    c205_stop stop = c205_run(machine, 100000);
    bool good_end = expect_check(object, machine, &stop, printed.text, 0, &report);
    assert_int_equal(good_end, said.length == 0);
    return good_end;
}

TEST(expectations)
{
    static const struct {
        const char *right, *wrong;
    } cases[] = {
        { "expect: r10 = 5", "expect: r10 = 6" },
        { "expect: h21 = X'5'", "expect: h21 = X'6'" },
        { "expect: [v] = 1, 2", "expect: [v] = 1, 3" },
        { "expect-halves: [v - 32] = X'A0000000', 0", "expect-halves: [v - 32] = 0" },
        { "expect-bits: [v - 32] = 10100", "expect-bits: [v - 32] = 101 1" },
        { "expect-flags: 0", "expect-flags: 1" },
        { "expect-print: 5", "expect-print: 55" },
        { "expect-print: 5", "expect-print:" },
        /* an unmapped address */
        { "expect: [v] = 1, 2", "expect: [0x7000000000] = 0" },
        { "expect-halves: [v - 32] = X'A0000000', 0",
          "expect-halves: [0x7000000000] = 0" },
        { "expect-bits: [v - 32] = 10100", "expect-bits: [0x7000000000] = 0" },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        FAIL_IF(!holds(cases[i].right), "fails: %s", cases[i].right);
        FAIL_IF(holds(cases[i].wrong), "holds: %s", cases[i].wrong);
    }
}
