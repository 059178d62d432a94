/* test_asm_text.c - directives, macros and conditions. The words that short programs
 * write to memory are compared with words computed by hand, and wrong texts with a
 * table of their errors. A directive that moves or drops a word fails here. */
#include "tests/unit/asm_helper.h"

#include "asm/check/expect.h"

enum { CODE = 0x400000, DATA = 0x800000 };

TEST(data)
{
    SCOPED(object) *object = good(" .data\n"
                                  " .half 1\n"
                                  "label:\n"
                                  "same: .word 5\n"
                                  " .vector v, 3, 1.0\n"
                                  " .bitvector b, 70, \"1\", \"0 1\"\n"
                                  " .text \"12345678\\x39\"\n"
                                  " .descriptor 3, v\n"
                                  " .space 2\n"
                                  "end:\n"
                                  " .half -1, 0xFFFFFFFF, -0x80000000\n");
    const c205_program *program = &object->program;
    assert_int_equal(object_symbol(object, "label")->value, DATA + 64);
    assert_int_equal(object_symbol(object, "same")->value, DATA + 64);
    assert_true(object_symbol(object, "v")->is_label);
    assert_null(object_symbol(object, "w"));
    assert_int_equal(word_of(program, DATA), 0x0000000100000000);
    assert_int_equal(word_of(program, DATA + 64), 5);
    assert_int_equal(word_of(program, DATA + 128), C205_ONE);
    assert_int_equal(word_of(program, DATA + 5 * 64), 0xA000000000000000);
    assert_int_equal(word_of(program, DATA + 7 * 64), 0x3132333435363738);
    assert_int_equal(word_of(program, DATA + 8 * 64), 0x3900000000000000);
    assert_int_equal(word_of(program, DATA + 9 * 64), 0x0003000000800080);
    assert_int_equal(object_symbol(object, "end")->value, DATA + 12 * 64);
    assert_int_equal(word_of(program, DATA + 12 * 64), UINT64_MAX);
    assert_int_equal(word_of(program, DATA + 13 * 64), 0x8000000000000000);
}

TEST(half_words)
{
    SCOPED(object) *object = good(
        " .equ tenth, 0.1\n"
        " .data\n"
        " .halfword 1.5, -2.0, -2, tenth, X'7012 3456', 1e99, 1e-99\n"
        "odd: .halfvector v, 3, 1.0, -0.1\n"
        " .halfvector large, 1001\n"
        "last: .half 7\n"
        " .halfvector none, 0\n"
        " .word 8\n");
    const c205_program *program = &object->program;
    assert_int_equal(word_of(program, DATA), 0xEA600000EA800000);
    assert_int_equal(word_of(program, DATA + 64), 0x00FFFFFEE6666666);
    assert_int_equal(word_of(program, DATA + 128), 0x7012345670000000);
    assert_int_equal(word_of(program, DATA + 192), 0x80000000EA400000);
    assert_int_equal(word_of(program, DATA + 256), 0xE699999900000000);
    assert_int_equal(object_symbol(object, "odd")->value, DATA + 7 * 32);
    assert_int_equal(object_symbol(object, "v")->value, DATA + 7 * 32);
    assert_int_equal(object_symbol(object, "large")->value, DATA + 10 * 32);
    assert_int_equal(object_symbol(object, "last")->value, DATA + 1011 * 32);
    assert_int_equal(word_of(program, DATA + 1010 * 32), 7);
    assert_int_equal(object_symbol(object, "none")->value, DATA + 1012 * 32);
    assert_int_equal(word_of(program, DATA + 1012 * 32), 8);
}

TEST(places)
{
    SCOPED(object) *object = good(" .include \"core.s\"\n"
                                  " EXIT\n"
                                  " .data\n"
                                  " .word 1\n"
                                  " .code\n"
                                  " .align 64\n"
                                  "here: ES r1, 2\n"
                                  " .org 0x10000020\n"
                                  " ES r1, 3\n"
                                  " .org 0x20000000\n"
                                  " .space 1000\n"
                                  " .entry here\n");
    const c205_program *program = &object->program;
    assert_int_equal(program->entry, CODE + 64);
    assert_int_equal(word_of(program, CODE + 64), 0x3E01000200000000);
    assert_int_equal(word_of(program, 0x10000000), 0x3E010003);
    assert_int_equal(program->segment_count, 4);
    assert_null(program->segments[3].words);
    assert_int_equal(program->segments[3].length, 1000);
}

TEST(entry_is_the_first_instruction)
{
    SCOPED(object) *object = good(" .data\n .word 1\n .code\n .org 0x500000\n"
                                  " EXIT\n .org 0x400000\n EXIT\n");
    assert_int_equal(object->program.entry, 0x500000);
}

TEST(regions)
{
    SCOPED(object) *object = good(
        " EXIT\n .kernel one\n EXIT\n .data\n .org 0x20000000\n .word 1\n"
        " .code\n EXIT\n"
        " .endkernel\n .kernel two\n .endkernel\n"
        " .kernel \"a b\"\n EXIT\n .endkernel\n");
    const c205_program *program = &object->program;
    assert_int_equal(program->region_count, 2);
    assert_string_equal(program->regions[0].name, "one");
    assert_int_equal(program->regions[0].begin, CODE + 32);
    assert_int_equal(program->regions[0].end, CODE + 96);
    assert_string_equal(program->regions[1].name, "a b");
}

#define NESTED \
    " .data\n .rept 2\n .rept 3\n .word \\+\n .endr\n .word 10 + \\+\n .endr\n"

/* Texts, and the word that each text writes to an address. */
TEST(words)
{
    static const struct {
        const char *text;
        uint64_t address;
        c205_word word;
    } cases[] = {
        /* Macros. */
        { " .macro put a, b=7\n .word \\a + \\b\n .endm\n .data\n put 5\n", DATA, 12 },
        { " .macro put a, b=7\n .word \\a + \\b\n .endm\n .data\n put 5, 1\n", DATA,
          6 },
        { " .macro put a\n x\\a\\()0: .word x\\a\\()0\n .endm\n .data\n put 3\n", DATA,
          DATA },
        { " .macro two\n l\\@: .word l\\@\n .endm\n .data\n two\n two\n", DATA + 64,
          DATA + 64 },
        { " .macro out n\n .macro in m\n .word \\m * \\n\n .endm\n .endm\n"
          " .data\n out 6\n in 7\n",
          DATA, 42 },
        { " .macro text s\n .text \\s\n .endm\n .data\n text \"a,\\x62\"\n", DATA,
          0x612C620000000000 },
        /* Parameters. */
        { " .macro put a=7, b\n .word \\a + \\b\n .endm\n .data\n put , 1\n", DATA, 8 },
        { " .macro put ab, a\n .word \\a\n .endm\n .data\n put 5, 6\n", DATA, 6 },
        /* Each expansion has its own number. */
        { " .macro out\n .macro in\n l\\@: .word l\\@\n .endm\n .endm\n .data\n"
          " out\n in\n in\n",
          DATA + 64, DATA + 64 },
        /* Arguments in brackets. */
        { " .macro add a, b\n ADDNV \\a, \\b, [r3]\n .endm\n"
          "l: add [r1, r9], r2 ; a comment\n",
          CODE, 0x8208090100020003 },
        /* Repetitions. */
        { " .data\n .rept 3\n .word \\+\n .endr\n", DATA + 128, 2 },
        { NESTED, DATA + 2 * 64, 2 },
        { NESTED, DATA + 3 * 64, 10 },
        { NESTED, DATA + 7 * 64, 11 },
        { " .data\n .rept 0\n .word 1\n .endr\n .word 2\n", DATA, 2 },
        /* Registers that are renamed. */
        { " .reg x, r1\n .reg x, r2\n RTOR x, r3\n", CODE, 0x7802000300000000 },
        { " .reg x, r1\n .regs h8, y, x\n RTORH y, x\n", CODE, 0x5808000900000000 },
        { " .reg x, h1\n .reg x, r9\n RTOR x, r3\n", CODE, 0x7809000300000000 },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        SCOPED(object) *object = good(cases[i].text);
        c205_word word = word_of(&object->program, cases[i].address);
        FAIL_IF(word != cases[i].word, "%s: %016llX", cases[i].text,
                (unsigned long long)word);
    }
}

TEST(lines_of_dos)
{
    SCOPED(object) *object = good(" EXIT\r\n; expect-print: a\r\n");
    assert_string_equal(object->expectations[0].text, "a");
    assert_string_equal(object->lines[0].source, " EXIT");
}

/* Every overlap with a long block is reported. */
TEST(overlaps)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    assert_null(assemble_text("test.s",
                              " .data\n .space 4\n .org 0x800040\n .word 1\n"
                              " .org 0x8000C0\n .word 2\n",
                              NULL, &errors));
    assert_int_equal(errors.count, 2);
}

TEST(conditions)
{
    static const char text[] = " .data\n"
                               " .if N == 1\n .word 1\n"
                               " .elseif N == 2\n .word 2\n .if 0\n .error \"no\"\n"
                               " .else\n .word 22\n .endif\n"
                               " .else\n .word 3\n .endif\n"
                               " .ifdef N\n .ifndef M\n .word 4\n .endif\n .endif\n";
    static const struct asm_define defines[] = { { "N", 2 }, { NULL, 0 } };
    const struct asm_options options = { .defines = defines };
    struct diagnostics errors = { 0 };
    SCOPED(object) *object = NON_NULL(assemble_text("t.s", text, &options, &errors));
    assert_int_equal(word_of(&object->program, DATA), 2);
    assert_int_equal(word_of(&object->program, DATA + 64), 22);
    assert_int_equal(word_of(&object->program, DATA + 128), 4);
}

static const struct asm_error wrong_texts[] = {
    { " .frob 1\n", 1, 0, "a directive" },
    { "a:\n\na: EXIT\n", 3, 0, "already defined, in test.s:1" },
    { "r5: EXIT\n", 1, 0, "is a register" },
    { "h5: EXIT\n", 1, 0, "is a register" },
    { " .equ A, 1\n .equ A, 2\n", 2, 0, "already defined" },
    { " .equ A, later\nlater:\n", 1, 0, "not defined before this line" },
    { " .space later\nlater:\n", 1, 0, "not defined before this line" },
    { " .space -1\n", 1, 0, "a number of words" },
    { " .space 0x4000001\n", 1, 0, "a number of words" },
    { " .data\n .space 0x4000000\n .word 1\n", 3, 0, "more than 67108864 words" },
    { " .org 5\n", 1, 0, "a multiple of 32" },
    { " .org -1\n", 1, 0, "a bit address from 0 to 281474976710655," },
    { " .org 0x1000000000000\n", 1, 0, "a bit address" },
    { " .align 48\n", 1, 0, "a multiple of 32" },
    { " .align 0\n", 1, 0, "a number of bits from 32 to 281474976710656," },
    { " .align 0x1000000000020\n", 1, 0, "a number of bits" },
    { " .org 0xFFFFFFFFFFE0\n BIM 0\n", 2, 0, "beyond the last address" },
    { " .rept 65537\n .word 1\n .endr\n", 2, 0, "is larger than its page" },
    { " .rept 99999\n .word 1\n .endr\n", 2, 0, "is larger than its page" },
    { " .rept 70000\n ES r1, 1\n ADDN r1, r2, r3\n EXIT\n .endr\n", 4, 0,
      "is larger than its page" },
    { " .org 0xFFFFFFFFFFC0\n .rept 300\n .word 1\n .endr\n", 3, 0,
      "beyond the last address" },
    { " .data\n .rept 300\n .space 0x3FFFFFF\n .endr\n", 3, 0,
      "more than 67108864 words" },
    { " .org 0x400000\n .rept 300\n .word 1\n .endr\n"
      " .org 0x400000\n .rept 300\n .word 2\n .endr\n",
      7, 0, "already used, by test.s:3" },
    { " .org 0x400040\n EXIT\n .org 0x400000\n .space 2\n", 2, 0,
      "already used, by test.s:4" },
    { " .org 0x400000\n EXIT\n .org 0x400000\n EXIT\n", 4, 0,
      "already used, by test.s:2" },
    { " .regs r254, a, b, c\n", 1, 0, "after r255" },
    { " .regs h254, a, b, c\n", 1, 0, "after h255" },
    { " .reg a, b\n", 1, 0, "a register" },
    { " .reg a, h5\n .word a\n", 2, 0, "found the register 'a'" },
    { " .vector v, 2, 1, 2, 3\n", 1, 0, "but the vector holds only" },
    { " .bitvector v, 2, \"111\"\n", 1, 0, "more bits" },
    { " .bitvector v, 2, \"12\"\n", 1, 0, "the digits 0 and 1" },
    { " .text \"\\q\"\n", 1, 0, "expected one of" },
    { " .text \"abc\n", 1, 0, "expected a closing" },
    { " .descriptor 65536, 0\n", 1, 0, "a length" },
    { " .half 0x100000000\n", 1, 0, "32 bits" },
    { " .half -0x80000001\n", 1, 0, "32 bits" },
    { " .halfword 0x1000000\n", 1, 0, "24 bits" },
    { " .halfword -0x800001\n", 1, 0, "24 bits" },
    { " .halfword X'1 0000 0000'\n", 1, 0, "8 hex digits" },
    { " .halfvector v, 2, 1, 2, 3\n", 1, 0, "but the vector holds only" },
    { " .halfvector v, -1\n", 1, 0, "a length" },
    { " .entry 0\n .entry 0\n", 2, 0, ".entry is already defined" },
    { " .entry nowhere\n", 1, 0, "not defined" },
    { " .kernel a\n EXIT\n", 1, 0, "no .endkernel" },
    { " .endkernel\n", 1, 0, "without a .kernel" },
    { " .kernel a\n .kernel b\n .endkernel\n", 2, 0, ".endkernel first" },
    { " .kernel a\n .org 0x500000\n .endkernel\n", 2, 0, ".org cannot be used inside" },
    { " .error \"mine\"\n", 1, 0, "mine" },
    { " .include \"no such file\"\n", 1, 0, "cannot read '" },
    { " .macro ADDN\n .endm\n", 1, 0, "is an instruction" },
    { " .macro a\n .endm\n .macro a\n .endm\n", 3, 0, "is already defined" },
    { " .macro a\n", 1, 0, "no .endm" },
    { " .endm\n", 1, 0, ".endm without .macro" },
    { " .rept 2\n EXIT\n", 1, 0, "no .endr" },
    { " .macro m a\n EXIT\n .endm\n m\n", 4, 0, "expected argument 'a'" },
    { " .macro m a\n EXIT\n .endm\n m 1, 2\n", 4, 0,
      "too many arguments: macro m has 1 parameter" },
    { " .macro m\n m\n .endm\n m\n", 2, 0, "nested includes and macros" },
    { " .macro m\n .word x\n .endm\n m\n", 2, 0, "from test.s:4" },
    { " .if 1\n", 1, 0, "no .endif" },
    { " .endif\n", 1, 0, "expected an .if" },
    { " .else\n", 1, 0, "expected an .if" },
    { " .if 0\n .else\n .else\n .endif\n", 3, 0, "expected .endif" },
    { " .if x\n .endif\n", 1, 0, "not defined before" },
    { " .macro m\n .endif\n .endm\n .if 1\n m\n .endif\n", 2, 0, "expected an .if" },
    { " .rept 0x4000000\n\n .endr\n", 2, 0, "expand to more than" },
    { "; expect-nothing: 5\n", 1, 0, "expected expect:" },
    { "; expect: r5 = 1, 2\n", 1, 0, "one value" },
    { "; expect: h5 = 1, 2\n", 1, 0, "one value" },
    { "; expect: h5 = 0x1000000\n", 1, 0, "24 bits" },
    { "; expect-halves: [0]\n", 1, 0, "'='" },
    { "; expect: 5 = 1\n", 1, 0, "a register" },
    { "; expect-trap: none\n", 1, 0, "the name of a trap" },
    { "; expect-bits: [0] = 12\n", 1, 0, "digits 0 and 1" },
    { "\1\n", 1, 0, "unexpected character" }
};

TEST_CALL(errors, assert_asm_errors(wrong_texts, COUNT(wrong_texts)))

TEST(all_errors_with_carets)
{
    static const char text[] = " ADDN r1, r2\n\n\tES\tr1, nowhere\n FROB\n";
    static const char printed[] =
        "test.s:1:13: error: expected ',', found the end of the statement; "
        "syntax: ADDN r, r, r\n"
        "     ADDN r1, r2\n"
        "                ^\n"
        "test.s:4:2: error: expected an instruction or a macro, found"
        " 'FROB'; did you mean XORB?\n"
        "     FROB\n"
        "     ^\n"
        "test.s:3:9: error: 'nowhere' is not defined\n"
        "            ES      r1, nowhere\n"
        "                        ^\n";
    SCOPED_VALUE(diagnostics) errors = { 0 };
    SCOPED_VALUE(text_buffer) buffer = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&buffer);
    assert_null(assemble_text("test.s", text, NULL, &errors));
    diagnostics_put(&errors, &sink);
    assert_string_equal(buffer.text, printed);
}

TEST(missing_file)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    assert_null(assemble_file("no such file.s", NULL, &errors));
    assert_int_equal(errors.count, 1);
    assert_int_equal(errors.items[0].line, 0);
}
