/* fresh_text.c - writes fresh tests as the texts of tests. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "vm/error.h"

/* ---- Values ---------------------------------------------------------------- */

/* Writes a word as an integer, a number or in hexadecimal, so that the assembler makes
 * the same word. */
static void put_word(c205_word word, const struct sink *sink)
{
    int64_t integer = c205_to_integer(word);
    char text[C205_TEXT_SIZE];
    const char *end;
    c205_to_text(word, text);
    if (c205_from_integer(integer) == word)
        sink_print(sink, "%" PRId64, integer);
    else if (c205_from_text(text, &end) != word || *end)
        sink_print(sink, "X'%016" PRIX64 "'", word);
    else
        sink_print(sink, "%s%s", text, strpbrk(text, ".e") ? "" : ".0");
}

/* Writes elements in lines of at most PER_LINE. */
static void put_elements(const struct asm_symbol *symbol, const c205_word *elements,
                         const struct sink *sink)
{
    enum { PER_LINE = 4 };
    bool half = symbol->contents == ASM_HALF_WORDS;
    sink_print(sink, "%s:\n", symbol->name);
    for (size_t i = 0; i < symbol->count; i++) {
        sink_put(sink, i % PER_LINE > 0 ? ", "
                       : half           ? "        .half   "
                                        : "        .word   ");
        if (half)
            sink_print(sink, "0x%08" PRIX64, elements[i] >> 32);
        else
            put_word(elements[i], sink);
        if (i % PER_LINE == PER_LINE - 1 || i + 1 == symbol->count)
            sink_put(sink, "\n");
    }
}

static void put_bits(const struct asm_symbol *symbol, const c205_word *elements,
                     const struct sink *sink)
{
    sink_print(sink, "        .bitvector %s, %" PRIu64 ", \"", symbol->name,
               symbol->count);
    for (size_t i = 0; i < symbol->count; i++)
        sink_put(sink, elements[i] ? "1" : "0");
    sink_put(sink, "\"\n");
}

/* ---- Tests ----------------------------------------------------------------- */

static bool put_label(const struct test_case *test, const struct asm_symbol *symbol,
                      const struct sink *sink)
{
    struct arena kept = { 0 };
    struct test_item item = { .contents = symbol->contents,
                              .count = (size_t)symbol->count };
    c205_word *elements = arena_take(&kept, (item.count + 1) * sizeof *elements);
    if (elements) {
        test_data_read(test->data, (uint64_t)symbol->value, &item, elements);
        if (symbol->contents == ASM_BITS)
            put_bits(symbol, elements, sink);
        else
            put_elements(symbol, elements, sink);
    }
    arena_free(&kept);
    return elements;
}

static bool put_test(const struct test_case *test, uint64_t draw,
                     const struct sink *sink)
{
    const struct object *object = test->object;
    bool good = true;
    sink_print(sink, "; test: %s, draw %" PRIu64 "\n", test->notes->name, draw);
    for (const struct asm_define *define = test->defines; define->name; define++)
        sink_print(sink, "        .equ    %s, %" PRId64 "\n", define->name,
                   define->value);
    if (test->notes->warm)
        sink_put(sink, "        .warm\n");
    sink_put(sink, "        .data\n");
    for (size_t i = 0; good && i < object->symbol_count; i++)
        if (test_holds_data(&object->symbols[i])
            && object->symbols[i].contents != ASM_BYTES)
            good = put_label(test, &object->symbols[i], sink);
    return good;
}

static bool put_fresh(const struct lesson *lesson, const struct test_case *model,
                      bool like, uint64_t draw, const struct sink *sink,
                      c205_error *error)
{
    struct arena kept = { 0 };
    struct fresh_test fresh = { .test = { 0 } };
    bool good = fresh_open(&fresh, lesson, model, like, draw, &kept, error)
                && (put_test(&fresh.test, draw, sink)
                    || error_set(error, "out of memory"));
    fresh_close(&fresh);
    arena_free(&kept);
    return good;
}

bool lesson_fresh_put(const struct lesson *lesson, uint64_t draw,
                      const struct sink *sink, c205_error *error)
{
    bool good = lesson_has_fresh(lesson, error);
    for (size_t i = 0; good && i <= lesson->test_count; i++) {
        struct test_case model = { 0 };
        bool like = i < lesson->test_count;
        sink_put(sink, i > 0 ? "\n" : "");
        good = test_case_open(&model, &lesson->tests[like ? i : 0], NULL, NULL, error)
               && put_fresh(lesson, &model, like, draw, sink, error);
        test_case_close(&model);
    }
    return good;
}
