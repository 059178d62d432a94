/* test_asm_errors.c - wrong statements of every kind: each text has one error, and its
 * line, column and message are compared with a table. An error that is missing,
 * repeated or at another place fails here. */
#include "tests/unit/asm_helper.h"

static const struct asm_error wrong_texts[] = {
    /* Expressions. */
    { " .word\n", 1, 7, "expected a number, a name or '('" },
    { " .word 1,\n", 1, 10, "expected a number" },
    { " .word 1 2\n", 1, 10, "the end of the statement, found '2'" },
    { " .word (1\n", 1, 10, "expected ')'" },
    { " .word 1.5.2\n", 1, 8, "expected the end of the number" },
    { " .word 1/0\n", 1, 9, "division by zero" },
    { " .word 1 % 0\n", 1, 10, "division by zero" },
    { " .word 1 << 64\n", 1, 10, "between 0 and 63" },
    { " .word 1.5 % 1\n", 1, 12, "requires integers" },
    { " .word 1 + later\n", 1, 12, "'later' is not defined" },
    { " .word later + 1\n", 1, 8, "'later' is not defined" },
    { " .word bits(5\n", 1, 14, "expected ')'" },
    { " .word word(1.5)\n", 1, 13, "expected an integer" },
    { " .word word(later)\n", 1, 13, "'later' is not defined" },
    { " .word length(5)\n", 1, 15, "expected a string" },
    { " .word length(\"a\"\n", 1, 18, "expected ')'" },
    { " .word X'12345678901234567'\n", 1, 8, "1 to 16 hex digits" },
    { " .word X'12\n", 1, 8, "end with '" },
    { " .word 99999999999999999999\n", 1, 8, "63 bits" },
    { " .word -1000000000000000000000000000000000000000000000000000000000"
      "000000000000000000000000000000.0\n",
      1, 8, "78 characters" },
    /* Directives. */
    { " .reg\n", 1, 6, "expected a name" },
    { " .reg a r1\n", 1, 9, "expected ','" },
    { " .regs 5\n", 1, 8, "expected a register" },
    { " .regs r1, 5\n", 1, 12, "expected a name" },
    { " .reg a, r1\na: EXIT\n", 2, 1, "already defined, in test.s:1" },
    { "a: EXIT\n .reg a, r1\n", 2, 7, "already defined" },
    { "a: EXIT\n .regs r1, a\n", 2, 12, "already defined" },
    { " .equ r1, 5\n", 1, 7, "'r1' is a register" },
    { " .equ a 5\n", 1, 9, "expected ','" },
    { " .org )\n", 1, 7, "expected a number" },
    { " .align 0\n", 1, 9, "from 32 to" },
    { " .half )\n", 1, 8, "expected a number" },
    { " .descriptor 1\n", 1, 15, "expected ','" },
    { " .descriptor )\n", 1, 14, "expected a number" },
    { " .descriptor 1, )\n", 1, 17, "expected a number" },
    { " .descriptor 1, -5\n", 1, 17, "a bit address from 0" },
    { " .descriptor 1, later\n", 1, 17, "'later' is not defined" },
    { " .vector v, -1\n", 1, 13, "a length from 0" },
    { " .vector v, 2, )\n", 1, 16, "expected a number" },
    { " .bitvector v, 4, 5\n", 1, 19, "expected a string" },
    { " .bitvector v, 70000000\n", 1, 16, "a length from 0" },
    { " .text 5\n", 1, 8, "expected a string" },
    { " .text \"a\\x4\"\n", 1, 10, "expected one of" },
    { " .entry )\n", 1, 9, "expected a number" },
    { " .kernel\n", 1, 9, "expected the kernel's name" },
    { " .kernel \"\"\n EXIT\n", 1, 10, "a kernel must have a name" },
    { " .kernel \"a\\q\"\n", 1, 12, "expected one of" },
    { " .error 5\n", 1, 9, "expected a string" },
    /* Includes, macros, repetitions and conditions. */
    { " .include 5\n", 1, 11, "expected a string" },
    { " .include \"a\" b\n", 1, 15, "the end of the statement" },
    { " .include \"/no such file\"\n", 1, 11, "cannot read '" },
    { " .rept -1\n .endr\n", 1, 8, "a count from 0" },
    { " .rept 1 2\n .endr\n", 1, 10, "the end of the statement" },
    { " .macro\n .endm\n", 1, 8, "the macro's name" },
    { " .macro m 5\n .endm\n", 1, 11, "a parameter's name" },
    { " .macro m a b\n .endm\n", 1, 13, "expected ','" },
    { " .ifdef 5\n .endif\n", 1, 9, "expected a name" },
    { " .if 1 2\n .endif\n", 1, 8, "the end of the statement" },
    /* Instructions. */
    { " ADDN r1, r2, r256\n", 1, 15, "expected a register" },
    { " ADDN r1, r2, r3, r4\n", 1, 17, "the end of the statement" },
    { " ADDNV [r1, ], [r2], [r3]\n", 1, 13, "expected a register" },
    { " ADDNV [r1], [r2], [r3, r5]\n", 1, 25, "expected r4" },
    { " ADDNV |[r1], [r2], [r3]\n", 1, 13, "expected '|'" },
    { " ADDNV [r1], -[r2], [r3]\n", 1, 14, "only the first source" },
    { " VXTOV [r1], [r2, r3], [r4]\n", 1, 17, "has no offset" },
    { " CPSV [r1], [r2]\n", 1, 17, "expected a control vector" },
    { " ES r1, 1.5\n", 1, 9, "expected an integer" },
    { " IBXLT r1, r2, r3, 5, r1\n", 1, 2, "on a half word" },
    { " IBXLT r1, r2, r3, later, r1\n", 1, 20, "'later' is not defined" },
    { " BARB r1, r2, [r3], 16\n", 1, 21, "from 0 to 15" },
    { " 5\n", 1, 2, "expected an instruction" },
    { "a b\n", 1, 1, "an instruction or a macro" },
    { ".frob\n", 1, 1, "expected a directive" },
    /* Expectations. */
    { "; expect: r1\n", 1, 13, "expected '='" },
    { "; expect: [0] 5\n", 1, 15, "expected '='" },
    { "; expect: [0] = 5,\n", 1, 19, "expected a number" },
    { "; expect: [)] = 1\n", 1, 12, "expected a number" },
    { "; expect-bits: 5\n", 1, 16, "expected '['" },
    { "; expect-bits: [5\n", 1, 18, "expected ']'" },
    { "; expect-bits: [5] 1\n", 1, 20, "expected '='" },
    { "; expect-bits: [later] = 1\n", 1, 17, "'later' is not defined" },
    { "; expect-flags: 1, 2\n", 1, 18, "the end of the statement" },
    { "; expect-clocks: later\n", 1, 18, "'later' is not defined" },
    { "; expect-trap:\n", 1, 15, "the name of a trap" },
    { "; expect: r1 = 1 ~\n", 1, 19, "expected a number" },
    { "; expect: r1 = 1 ~ -1\n", 1, 11, "a tolerance must be" },
    { "; expect: r1 = 1 ~ X'7000000000000000'\n", 1, 11, "a tolerance must be" },
    { "; expect-model:\n", 1, 16, "the name of a model" },
    { "; expect-model: a\n; expect-model: b\n", 2, 17, "already defined, in test.s:1" },
    /* Suggestions. */
    { " ADDVN [r1], [r2], [r3]\n", 1, 2, "did you mean ADDNV?" },
    { " SUBN [r1], r2, r3\n", 1, 7, "did you mean SUBNV, which operates on vectors?" },
    { " ADDNH [r1], h2, h3\n", 1, 8, "did you mean ADDNV,H, which operates" },
    { " mul r1, r2, r3\n", 1, 2,
      "found 'mul'; MPYS multiplies numbers, MPYX multiplies integers" },
    { " HALT\n", 1, 2, "; EXIT ends the program" },
    /* An error in a macro of the library is at its call. */
    { " .include \"core.s\"\n .macro own\n descriptor r5, nosuch, 3\n .endm\n own\n", 3,
      2, "(in a macro, at core.s:11)" },
    { " CMPGTV [r1], [r2], [r3]\n", 1, 2, "; exchange the sources and use CMPLTV" },
    { " CMPLVT [r1], [r2], [r3]\n", 1, 2, "did you mean CMPLTV?" },
    { " .dta\n", 1, 2, "did you mean .data?" },
    { " .incldue \"core.s\"\n", 1, 2, "did you mean .include?" },
    { " .edif\n", 1, 2, "did you mean .endif?" },
    { " .include \"core.s\"\n descirptor r1, 0, 5\n", 2, 2,
      "did you mean descriptor?" },
    { " .reg total, r9\n ES totla, 5\n", 2, 5, "did you mean total?" },
    { "here: BIM hree\n", 1, 11, "did you mean here?" },
    { " ES r1, 1.0f\n", 1, 9, "a number must not have a suffix" },
    { " ES r1, 10x\n", 1, 9, "expected the end of the number" },
    { " ES r1, #5\n", 1, 9, "numbers have no prefix" },
    { " ELEN r1, 65536\n", 1, 11, "at most 65535 elements" },
    { " .descriptor 65536, 0\n", 1, 14, "at most 65535 elements" },
    { " LOD r1, r2\n", 1, 6, "expected '[', found 'r1'; syntax: LOD [r, r], r" },
    { " MPYSH 1, h2, h3\n", 1, 8, "syntax: MPYSH h, h, h" },
    { " EXIT 5\n", 1, 7, "syntax: EXIT (r, (r, (number)))" },
};

TEST_CALL(errors, assert_asm_errors(wrong_texts, COUNT(wrong_texts)))

/* ---- Bounds ------------------------------------------------------------ */

/* Returns `begin`, `times` copies of `part`, and `end`. */
static char *repeated(const char *begin, const char *part, size_t times,
                      const char *end)
{
    size_t length = strlen(part);
    char *text = NON_NULL(malloc(strlen(begin) + times * length + strlen(end) + 1));
    char *at = text + sprintf(text, "%s", begin);
    for (; times > 0; times--, at += length)
        memcpy(at, part, length);
    strcpy(at, end);
    return text;
}

static void check_long(char *text, size_t line, size_t column, const char *message)
{
    assert_asm_errors(&(struct asm_error){ text, line, column, message }, 1);
    free(text);
}

TEST(bounds)
{
    FREED char *model = repeated(" .macro m a\n .text \"", "\\a", 100,
                                 "\"\n .endm\n m ");
    check_long(repeated("a:", " ", 70000, "EXIT\n"), 1, 1, "the line has more than");
    check_long(repeated(model, "1234567890", 70, "\n"), 2, 2,
               "the line expands to more than");
    check_long(repeated("", " .if 1\n", 300, ""), 65, 2, "nested conditions");
    check_long(repeated(" .word ", "(", 300, "1\n"), 1, 208, "nested levels");
    check_long(repeated(" .word later", " + later", 300, "\n"), 1, 1614,
               "nested levels");
    check_long(repeated(" .include \"", "long/", 1000, "name\"\n"), 1, 11,
               "'long/long");
}

/* Carriage returns before line ends are ignored. */
TEST(line_ends)
{
    SCOPED(object) *object = good(" .data\r\n .word 5 \r\n .word 6\r\n");
    assert_int_equal(word_of(&object->program, 0x800000), 5);
    assert_int_equal(word_of(&object->program, 0x800040), 6);
}

/* ---- Names from the command line ---------------------------------------- */

TEST(names_of_the_command)
{
    static const struct asm_define defines[] = { { "N", 2 }, { NULL, 0 } };
    const struct asm_options options = { .defines = defines };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    assert_null(assemble_text("test.s", " EXIT\nN: EXIT\n", &options, &errors));
    assert_one_error(&errors, "N", 2, 1, "already defined by the command");
}

TEST(search_folders)
{
    static const char *const folders[][3] = { { "no such folder", "tests/programs/" },
                                              { "asm/examples", "tests/programs" } };
    for (size_t i = 0; i < COUNT(folders); i++) {
        const struct asm_options options = { .search = folders[i] };
        SCOPED_VALUE(diagnostics) errors = { 0 };
        SCOPED(object) *object = NON_NULL(
            assemble_text("test.s", " .include \"scalar.inc\"\n EXIT\n", &options,
                          &errors));
        assert_int_equal(errors.count, 0);
    }
}

/* Compares all errors of a text, with their places and messages, with a list. */
static void check_all(const char *text, const struct asm_error *wanted, size_t count)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    assert_null(assemble_text("test.s", text, NULL, &errors));
    for (size_t i = 0; i < errors.count; i++)
        FAIL_IF(i >= count || errors.items[i].line != wanted[i].line
                    || errors.items[i].column != wanted[i].column
                    || !strstr(errors.items[i].message, wanted[i].message),
                "%s\n%zu: %zu:%zu: %s", text, i, errors.items[i].line,
                errors.items[i].column, errors.items[i].message);
    assert_int_equal(errors.count, count);
}

#define ALL(text, ...) \
    check_all(text, (const struct asm_error[]){ __VA_ARGS__ }, \
              sizeof(const struct asm_error[]){ __VA_ARGS__ } \
                  / sizeof(struct asm_error))

TEST(all_of_a_line)
{
    ALL(" ADDNV [1], [r300], 5 ? [)]\n",
        { NULL, 1, 9,
          "expected a register, found '1'; syntax: ADDNV [r] or"
          " r, [r] or r, [r] (? [r])" },
        { NULL, 1, 14, "expected a register, r0 .. r255 or h0 .. h255" },
        { NULL, 1, 21, "expected '['" }, { NULL, 1, 26, "a register" });
    ALL(" ADDN r1, [r2], 5\n", { NULL, 1, 11, "a register" },
        { NULL, 1, 17, "a register" });
    ALL(" BEQ r1 r2, 5\n", { NULL, 1, 9, "expected ','" },
        { NULL, 1, 13, "a register" });
    ALL(" ADDN 1, 2 ; expect: r1\n", { NULL, 1, 7, "syntax: ADDN r, r, r" },
        { NULL, 1, 10, "a register" }, { NULL, 1, 24, "expected '='" });
    ALL("a: EXIT\na: NOPES\n", { NULL, 2, 1, "already defined" },
        { NULL, 2, 4, "expected an instruction" });
    ALL(" .word 1, ), 2+, 4, *\n", { NULL, 1, 11, "found ')'" },
        { NULL, 1, 16, "found ','" }, { NULL, 1, 21, "found '*'" });
    ALL(" .word one + two\n", { NULL, 1, 8, "'one'" }, { NULL, 1, 14, "'two'" });
}

/* A misspelt comparison never suggests a comparison with another relation, and each name
 * of another machine has its advice. */
TEST(advice)
{
    static const char *const foreign[] = { "MUL",    "ADD",  "SUB",  "DIV",   "MOV",
                                           "LD",     "ST",   "LI",   "JMP",   "NOP",
                                           "RET",    "CALL", "HALT", "CMPGT", "CMP",
                                           "SCHLEV", "bgt" };
    static const char *const relations[] = { "EQ", "NE", "GE", "GT", "LE", "LT" };
    static const char *const shapes[] = { "CMP%sV", "SEL%sV", "SCH%sV", "B%s",
                                          "BH%s",   "CFP%s",  "IBX%s",  "CPM%sV",
                                          "CM%sV",  "CMP%s",  "SEL%s",  "SCHH%sV",
                                          "B%sZ",   "IBX%sX", "CFPP%s" };
    for (size_t i = 0; i < COUNT(foreign); i++) {
        SCOPED_VALUE(diagnostics) said = { 0 };
        assert_null(assemble_text("test.s", formatted(" %s r1, r2\n", foreign[i]), NULL,
                                  &said));
        assert_true(strstr(said.items[0].message, "; "));
        FAIL_IF(strstr(said.items[0].message, "did you mean"), "%s",
                said.items[0].message);
    }
    for (size_t i = 0; i < COUNT(shapes); i++)
        for (size_t k = 0; k < COUNT(relations); k++) {
            char name[16];
            snprintf(name, sizeof name, shapes[i], relations[k]);
            if (c205_insn_named(name, strlen(name)))
                continue;
            SCOPED_VALUE(diagnostics) said = { 0 };
            assert_null(
                assemble_text("test.s", formatted(" %s r1, r2\n", name), NULL, &said));
            const char *meant = strstr(said.items[0].message, "did you mean ");
            for (size_t other = 0; meant && other < COUNT(relations); other++)
                FAIL_IF(strstr(meant, relations[other]) && !strstr(meant, relations[k]),
                        "%s", said.items[0].message);
        }
}
