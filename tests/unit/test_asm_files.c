/* test_asm_files.c - programs that are disassembled, or saved and loaded, are compared
 * with the originals, over all sources of the tree, random words and damaged object
 * files. A changed word or label, or a damaged file that is accepted, fails here. */
#include "tests/unit/asm_helper.h"

#include "asm/check/expect.h"
#include "asm/object/disassemble.h"
#include "asm/object/object_file.h"
#include "asm/view/listing.h"
#include "base/file.h"
#include "tests/random.h"

static struct text_buffer disassembled(const struct object *object)
{
    struct text_buffer text = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&text);
    assert_true(disassemble(object, &sink));
    return text;
}

static void check_disassembly(const struct object *object)
{
    SCOPED_VALUE(text_buffer) text = disassembled(object);
    SCOPED(object) *again = good(text.text);
    assert_same_program(&object->program, &again->program);
}

static void check_object_file(const struct object *object)
{
    SCOPED_VALUE(text_buffer) first = { NULL, 0, 0, false };
    SCOPED_VALUE(text_buffer) second = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&first);
    c205_error error = { "" };
    object_write(object, &sink);
    SCOPED(object) *again = object_read(first.text, first.length, &error);
    assert_string_equal(error.message, "");
    assert_same_program(&object->program, &again->program);
    sink = text_buffer_sink(&second);
    object_write(again, &sink);
    assert_string_equal(first.text, second.text);
}

static void check_source(const char *path)
{
    SCOPED(object) *object = good_file(path);
    SCOPED_VALUE(text_buffer) text = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&text);
    check_disassembly(object);
    check_object_file(object);
    listing(object, &sink);
    assert_true(object->line_count == 0 || text.length > 0);
}

TEST(sources)
{
    each_file("asm/lib/*.s", check_source);
    each_file("asm/examples/*.s", check_source);
    each_file("tests/programs/*.s", check_source);
}

static const char sample[] = " .include \"print.s\"\n"
                             " .warm\n"
                             " .equ n, 5\n .equ half, 0.5\n"
                             " .kernel \"a \\\"b\\\\\"\n"
                             "start: print_text \"hello\", r5\n"
                             " IBXLT r1, r2, r3, start, r1\n"
                             " .endkernel\n"
                             " .half X'FFFF FFFF'\n"
                             " .data\n"
                             "v: .word 1, 2, 3, 4, 5, 0, 0, 0, 0, 0, 0, 6\n"
                             " .space 100\n"
                             "; expect: r5 = -1.5 ~ 1e-3\n"
                             "; expect: h5 = -1.5\n"
                             "; expect: [v] = 1, 2\n"
                             "; expect-halves: [v] = 1, 2.5\n"
                             "; expect-bits: [v] = 1 0\n"
                             "; expect-flags: X'20'\n"
                             "; expect-clocks: 100\n"
                             "; expect-trap: bad-descriptor\n"
                             "; expect-print: a line\n"
                             "; expect-model: cyber205-1pipe\n"
                             "; expect-warning: run-off\n";

TEST(sample)
{
    static const char path[] = "test_asm_files.tmp";
    SCOPED(object) *object = good(sample);
    size_t length;
    assert_int_equal(object->expectation_count, EXPECT_KINDS);
    check_disassembly(object);
    check_object_file(object);
    assert_true(object_save(object, path, &failure));
    FREED char *text = NON_NULL(file_read(path, FILE_LARGEST, &length, &failure));
    assert_true(object_recognise(text, length));
    assert_false(object_recognise(text, 11));
    assert_false(object_recognise(text + 1, length - 1));
    SCOPED(object) *again = NON_NULL(object_read(text, length, &failure));
    assert_same_program(&object->program, &again->program);
    assert_int_equal(remove(path), 0);
    assert_false(object_save(object, "no/such/folder", &failure));
}

static bool is_disassembled_as(const struct object *object, const char *section)
{
    SCOPED_VALUE(text_buffer) text = disassembled(object);
    return strstr(text.text, section);
}

/* Disassembles random data as code. */
TEST(any_bits)
{
    enum { WORDS = 4000 };
    static c205_word words[WORDS];
    c205_segment segment = { 0x400000, WORDS, words };
    c205_region regions[] = { { "r", 0x400020, 0x400100 },
                              { "overlaps", 0x4000E0, 0x400200 },
                              { "ends", 0x400800, 0x400000 + 64 * WORDS } };
    struct object object = {
        .program = { .entry = 0x400060, .segments = &segment, .segment_count = 1 }
    };
    uint64_t seed = 84;
    for (size_t i = 0; i < WORDS; i++) {
        words[i] = xorshift(&seed);
        if (i % 3) /* defined opcodes */
            words[i] = words[i] << 8 >> 8
                       | (c205_word)c205_insns[xorshift(&seed) % c205_insn_count].opcode
                             << 56;
    }
    check_disassembly(&object);
    assert_true(is_disassembled_as(&object, ".code"));
    object.program.entry = 0;
    assert_true(is_disassembled_as(&object, ".data"));
    object.program.entry = 0x400060;
    object.program.regions = regions;
    object.program.region_count = 1;
    check_disassembly(&object);
    for (uint64_t end = 0x400040; end < 0x400400; end += 32) {
        regions[0].end = end;
        check_disassembly(&object);
    }
    regions[0].end = 0x400100;
    regions[1] = regions[2];
    object.program.region_count = 2;
    check_disassembly(&object);
}

/* Labels keep valid names. Each label occurs once, on its line. */
TEST(names)
{
    static const char file[] =
        "c205-object 1\nentry 400000\nsegment 400000 2\n3E010005BE020000\n"
        "0080004009000000\nsegment 800000 3\n0000000000000001\n"
        "0000000000000002\n0000000000000003\nlabel 400000 main\n"
        "label 800000 r5\nlabel 800000 a b\nlabel 800000 list\n"
        "label 800040 twice\nlabel 800080 twice\nlabel 800080 L5\n"
        "label 400040 inside\nlabel 800060 half\nlabel 900000 nowhere\n"
        "integer 800080 constant\nlabel 800080 $end.\nend\n";
    static const char *const lines[] = { ".entry main\n",  "\nmain:\n",
                                         "EX r2, twice\n", "\nlist:\n",
                                         "\ntwice:\n",     "\n$end.:\n" };
    SCOPED(object) *object = NON_NULL(object_read(file, sizeof file - 1, &failure));
    check_disassembly(object);
    SCOPED_VALUE(text_buffer) text = disassembled(object);
    for (size_t i = 0; i < COUNT(lines); i++)
        FAIL_IF(!strstr(text.text, lines[i]), "no '%s' in\n%s", lines[i], text.text);
    assert_null(strstr(text.text, "L5"));
    assert_null(strstr(text.text, "inside"));
}

/* No prefix of an object file and no changed byte in it causes a crash. */
TEST(broken_files)
{
    SCOPED(object) *object = good(sample);
    SCOPED_VALUE(text_buffer) text = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&text);
    uint64_t seed = 1;
    object_write(object, &sink);
    for (size_t i = 0; i < text.length; i++)
        assert_null(object_read(text.text, i, &failure));
    for (size_t i = 0; i < 20000; i++) {
        char *byte = &text.text[xorshift(&seed) % text.length];
        char kept = *byte;
        *byte = (char)xorshift(&seed);
        object_free(object_read(text.text, text.length, &failure));
        *byte = kept;
    }
}

static void check_refused(const char *text, const char *message)
{
    c205_error error;
    assert_null(object_read(text, strlen(text), &error));
    FAIL_IF(!strstr(error.message, message), "%s: %s", text, error.message);
}

TEST(refused_files)
{
    static const char last[] = "c205-object 1\nzeros FFFFFFFFFFC0 1\nend\n";
    SCOPED(object) *accepted = NON_NULL(object_read(last, sizeof last - 1, &failure));
    check_refused("", "the end line is missing");
    check_refused("hello\n", "not an object file");
    check_refused("c205-object 2\nend\n", "version");
    check_refused("c205-object 1\nfrob\nend\n", "line 2: unknown keyword");
    check_refused("c205-object 1\nentry 1000000000000\nend\n", "48 bits");
    check_refused("c205-object 1\nentry 00000000000400000\nend\n",
                  "1 to 16 hex digits");
    check_refused("c205-object 1\nsegment 20 0\nend\n", "on a word");
    check_refused("c205-object 1\nsegment 40 9999999\nend\n", "before its last word");
    check_refused("c205-object 1\nzeros 40 99999999\nend\n", "too large");
    check_refused("c205-object 1\nzeros FFFFFFFFFFC0 2\nend\n", "the last address");
    check_refused("c205-object 1\nzeros 0 40000000\nzeros 200000000 40000000\nend\n",
                  "too many words");
    check_refused("c205-object 1\nregion 40 40 x\nend\n", "after it begins");
    check_refused("c205-object 1\nexpect half 0 0 0 1 x\nend\n", "number of words");
    check_refused("c205-object 1\nexpect clocks 0 0 0 1 x\nend\n", "number of words");
    check_refused("c205-object 1\nend\nend\n", "after the end line");
}
