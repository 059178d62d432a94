/* test_warning.c - warnings of the assembler for each text of a table are compared with
 * the expected warning, its line and its column, or with no warning. The warnings that
 * remain with each choice of options are compared, too. A warning that is missing,
 * superfluous or misplaced fails here. */
#include "tests/unit/asm_helper.h"

#include "base/file.h"

static struct object *assembled(const char *text, const char *choice,
                                struct diagnostics *diagnostics)
{
    struct asm_options options = { .defines = NULL };
    if (choice)
        assert_true(warning_choose(&options.warnings, choice));
    return assemble_text("test.s", text, &options, diagnostics);
}

static void check_none(const char *text, const char *choice)
{
    SCOPED_VALUE(diagnostics) diagnostics = { 0 };
    SCOPED(object) *object = assembled(text, choice, &diagnostics);
    FAIL_IF(!object || diagnostics.count > 0, "%s\n%s", text,
            diagnostics.count ? diagnostics.items[0].message : "");
}

static const struct asm_error warnings[] = {
    /* Misspelt expectations. */
    { "; expct: r1 = 5\n", 1, 3,
      "'expct' does not begin an expectation; did you mean '; expect:'?" },
    { "; Expect: r1 = 5\n", 1, 3, "[-Wmisspelt-expect]" },
    { "; expect r1 = 5\n", 1, 3, "'expect'" },
    { "; expect : r1 = 5\n", 1, 3, "'expect'" },
    { "; expects: [0x10000] = 5\n", 1, 3, "'expects'" },
    { "; expected: total = 5\n", 1, 3, "'expected'" },
    { " EXIT ; expcet: r1 = 5\n", 1, 9, "'expcet'" },
    { "; expct-trap: bad-link\n", 1, 3, "'expct-trap'" },
    { "; Expect-print: 5\n", 1, 3, "'Expect-print'" },
    { ";; expecct-clocks: 5\n", 1, 4, "'expecct-clocks'" },
    { "; we expect: r1 = 5\n", 0, 0, NULL },
    { "; expected is: r1 = 5\n", 0, 0, NULL },
    { "; except: this and that\n", 0, 0, NULL },
    { "; aspect-oriented programs\n", 0, 0, NULL },
    { "; inspect: r1 = 5\n", 0, 0, NULL },
    { "; r1 = 5\n", 0, 0, NULL },
    { ";\n;:\n;=\n; \n;-:\n;expect\n", 0, 0, NULL },
    /* Code that runs past its end. */
    { " ES r1, 5\n", 1, 2, "[-Wrun-off]" },
    { " EXIT\n ADDN r1, r1, r1\n", 2, 2, "can continue after this line" },
    { " EXIT r0, r0, 1\n", 1, 2, "EXIT or a branch" },
    { " BEQ r0, r0, [r0]\n", 1, 2, "can continue" },
    { " ES r1, 5\n .align 512\n EXIT\n", 1, 2, "can continue" },
    { " ES r1, 5\n .word 5\n", 1, 2, "can continue" },
    { " BIM far\n .org 0x900000\nfar: LINKV\n", 3, 1, "can continue" },
    { " .macro two\n ES r1, 1\n ES r1, 2\n .endm\n two\n", 3, 2,
      "(expanded from test.s:5)" },
    /* Registers that are read before they are written. */
    { " .reg sum, r5\n ES r1, 1\n ADDX sum, r1, r1\n EXIT\n", 3, 2,
      "sum (r5) is read before anything was written to it; in this language the result "
      "of ADDX comes last [-Wunwritten-register]" },
    { " EX r1, 64\n ELEN r1, 1\n ADDNV [r1], [r2], [r1]\n EXIT\n", 3, 2,
      "r2 is read before anything was written to it, so it describes no vector" },
    { " EX r1, 64\n ELEN r1, 1\n VTOV [r1, r3], [r1]\n EXIT\n", 3, 2, "r3 is read" },
    { " ADDNH h9, h0, h4\n RTOR r2, r5\n EXIT\n", 1, 2, "h9 is read before" },
    { " EXH h5, 1\n RTOR r2, r3\n EXIT\n", 0, 0, NULL },
    { " IS r1, 5\n IX r2, 64\n ELEN r3, 3\n INSB r0, r0, r4\n EXIT\n", 0, 0, NULL },
    { " SWAP [r0], r5, [r0]\n ADDX r5, r6, r7\n EXIT\n", 0, 0, NULL },
    { " BIM on\non: ADDX r5, r6, r7\n EXIT\n", 0, 0, NULL },
    { " EXIT\n ADDX r5, r6, r7\n EXIT\n", 0, 0, NULL },
    { " EXIT r0, r0, 6\n ADDX r0, r6, r7\n EXIT\n", 2, 2, "r6 is read" },
    { " ADDX r0, r6, r7\ngo: ADDX r0, r8, r7\n EXIT\n .entry go\n", 2, 1,
      "r8 is read" },
    { " ADDX r0, r8, r7\n EXIT\n; expect-warning: unwritten-register\n", 0, 0, NULL },
    { " EXIT\n", 0, 0, NULL },
    { " EXIT r0\n", 0, 0, NULL },
    { " EXIT r0, r0, zero\n .equ zero, 0\n", 0, 0, NULL },
    { "a: BIM a\n", 0, 0, NULL },
    { " ES r5, 0\n BIM 0, r5\n", 0, 0, NULL },
    { " BSAVE r5, [r0]\n", 0, 0, NULL },
    { " ES r1, 5\n .half X'09000000'\n", 0, 0, NULL },
    { " ES r1, 5\n; expect-trap: undefined-instruction\n", 0, 0, NULL },
    { " .data\n .word 5\n", 0, 0, NULL },
    { "", 0, 0, NULL },
};

TEST_CALL(warnings, assert_asm_warnings(warnings, COUNT(warnings)))

TEST(choice)
{
    static const char text[] = "; expct: r1 = 5\n ES r1, 5\n";
    SCOPED_VALUE(diagnostics) diagnostics = { 0 };
    struct warning_choice choice = { 0, false };
    check_none(" ES r1, 5\n", "no-run-off");
    check_none(text, "no-all");
    check_none(" ES r1, 5\n; expect-warning: run-off\n", NULL);
    check_none(" ES r1, 5\n; expect-warning: run-off\n", "error");
    assert_null(assembled(text, "error", &diagnostics));
    assert_int_equal(diagnostics.count, 2);
    assert_int_equal(diagnostics.errors, 2);
    diagnostics_free(&diagnostics);
    SCOPED(object) *object = assembled(text, "no-run-off", &diagnostics);
    assert_int_equal(diagnostics.count, 1);
    assert_int_equal(object->warned, WARNING_BIT(WARNING_RUN_OFF)
                                         | WARNING_BIT(WARNING_MISSPELT_EXPECT));

    assert_true(warning_choose(&choice, "no-all"));
    assert_true(warning_choose(&choice, "run-off"));
    assert_int_equal(choice.off, ~WARNING_BIT(WARNING_RUN_OFF));
    assert_true(warning_choose(&choice, "all"));
    assert_int_equal(choice.off, 0);
    assert_true(warning_choose(&choice, "error"));
    assert_true(warning_choose(&choice, "no-error"));
    assert_false(choice.errors);
    assert_false(warning_choose(&choice, "no-such"));
    assert_false(warning_choose(&choice, "no-"));
    assert_false(warning_choose(&choice, ""));
}

/* The manual describes each warning. */
TEST(manual)
{
    size_t length;
    FREED char *text = NON_NULL(
        file_read("docs/assembly.md", FILE_LARGEST, &length, &failure));
    for (unsigned i = 0; i < WARNINGS; i++) {

        const char *row = formatted("\n| `%s` | ", warning_name((enum warning)i));
        FAIL_IF(!strstr(text, row), "no row%s in docs/assembly.md", row);
        assert_int_equal(warning_named(warning_name((enum warning)i)), i);
    }
}
