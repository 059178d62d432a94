/* asm_helper.c - assembles texts and compares programs for the assembler's tests. */
#include "asm_helper.h"

#include <glob.h>

static struct object *checked(struct object *object, const struct diagnostics *errors)
{
    struct sink sink = stream_sink(stderr);
    if (errors->errors > 0)
        diagnostics_put(errors, &sink);
    assert_int_equal(errors->errors, 0);
    assert_non_null(object);
    return object;
}

struct object *good(const char *text)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    return checked(assemble_text("test.s", text, NULL, &errors), &errors);
}

struct object *good_file(const char *path)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    return checked(assemble_file(path, NULL, &errors), &errors);
}

size_t each_file(const char *pattern, void (*use)(const char *path))
{
    glob_t found;
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++)
        use(found.gl_pathv[i]);
    size_t count = found.gl_pathc;
    globfree(&found);
    return count;
}

size_t count_of(const char *text, const char *part)
{
    size_t count = 0;
    for (; text && (text = strstr(text, part)) != NULL; text += strlen(part))
        count++;
    return count;
}

uint64_t clocks_of_cause(const c205 *machine, c205_cause cause)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < c205_account_count(machine); i++)
        sum += c205_account_at(machine, i)->clocks[cause];
    return sum;
}

void assert_sum(const c205 *machine)
{
    uint64_t sum = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++)
        sum += clocks_of_cause(machine, (c205_cause)cause);
    assert_int_equal(sum, c205_clock(machine));
}

c205_word word_of(const c205_program *program, uint64_t address)
{
    for (size_t i = 0; i < program->segment_count; i++) {
        const c205_segment *segment = &program->segments[i];
        uint64_t index = (address - segment->address) / 64;
        if (address >= segment->address && index < segment->length)
            return segment->words ? segment->words[index] : 0;
    }
    return 0;
}

/* Fails unless every word of `program` is also in `other`, at the same address. */
static void assert_words_in(const c205_program *program, const c205_program *other)
{
    for (size_t i = 0; i < program->segment_count; i++) {
        const c205_segment *segment = &program->segments[i];
        for (size_t j = 0; segment->words && j < segment->length; j++)
            assert_int_equal(word_of(other, segment->address + 64 * j),
                             segment->words[j]);
    }
}

void assert_same_program(const c205_program *a, const c205_program *b)
{
    assert_int_equal(a->entry, b->entry);
    assert_int_equal(a->warm, b->warm);
    assert_words_in(a, b);
    assert_words_in(b, a);
    assert_int_equal(a->region_count, b->region_count);
    for (size_t i = 0; i < a->region_count; i++) {
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
        SCOPED_VALUE(diagnostics) found = { 0 };
        assert_null(assemble_text("test.s", error->text, NULL, &found));
        assert_one_error(&found, error->text, error->line, error->column,
                         error->message);
    }
}

void assert_asm_warnings(const struct asm_error *warning, size_t count)
{
    for (; count > 0; count--, warning++) {
        SCOPED_VALUE(diagnostics) found = { 0 };
        SCOPED(object) *object = assemble_text("test.s", warning->text, NULL, &found);
        FAIL_IF(!object || found.errors > 0 || (!warning->line && found.count > 0),
                "%s\n%s", warning->text, found.count ? found.items->message : "");
        if (warning->line)
            assert_one_error(&found, warning->text, warning->line, warning->column,
                             warning->message);
    }
}
