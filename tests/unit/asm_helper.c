/* asm_helper.c - programs from texts, and their words. */
#include "asm_helper.h"

struct object *good(const char *text)
{
    struct diagnostics errors = { 0 };
    struct object *object = assemble_text("test.s", text, NULL, &errors);
    struct sink sink = stream_sink(stderr);

    if (errors.errors > 0)
        diagnostics_put(&errors, &sink);
    assert_int_equal(errors.errors, 0);
    assert_non_null(object);
    diagnostics_free(&errors);
    return object;
}

c205_word word_of(const c205_program *program, uint64_t address)
{
    size_t i;

    for (i = 0; i < program->segment_count; i++) {
        const c205_segment *segment = &program->segments[i];
        uint64_t index = (address - segment->address) / 64;

        if (address >= segment->address && index < segment->length)
            return segment->words ? segment->words[index] : 0;
    }
    return 0;
}

/* Every word of one program is in the other as well. */
static void assert_words_in(const c205_program *program, const c205_program *other)
{
    size_t i, j;

    for (i = 0; i < program->segment_count; i++) {
        const c205_segment *segment = &program->segments[i];

        for (j = 0; segment->words && j < segment->length; j++)
            assert_int_equal(word_of(other, segment->address + 64 * j),
                             segment->words[j]);
    }
}

void assert_same_program(const c205_program *a, const c205_program *b)
{
    size_t i;

    assert_int_equal(a->entry, b->entry);
    assert_int_equal(a->warm, b->warm);
    assert_words_in(a, b);
    assert_words_in(b, a);
    assert_int_equal(a->region_count, b->region_count);
    for (i = 0; i < a->region_count; i++) {
        assert_string_equal(a->regions[i].name, b->regions[i].name);
        assert_int_equal(a->regions[i].begin, b->regions[i].begin);
        assert_int_equal(a->regions[i].end, b->regions[i].end);
    }
}

void assert_one_error(const struct diagnostics *errors, const char *text, size_t line,
                      size_t column, const char *message)
{
    const struct diagnostic *first = errors->items;

    if (errors->count != 1 || first->line != line
        || (column > 0 && first->column != column) || !strstr(first->message, message))
        fail_msg("%.200s\n%zu errors: %zu:%zu: %s", text, errors->count,
                 errors->count ? first->line : 0, errors->count ? first->column : 0,
                 errors->count ? first->message : "");
}

void assert_asm_errors(const struct asm_error *error, size_t count)
{
    for (; count > 0; count--, error++) {
        struct diagnostics found = { 0 };

        assert_null(assemble_text("test.s", error->text, NULL, &found));
        assert_one_error(&found, error->text, error->line, error->column,
                         error->message);
        diagnostics_free(&found);
    }
}
