/* object_file.c - writes object files; object_read.c reads them. */
#include "asm/object/object_file.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "asm/object/address_space.h"
#include "asm/object/expectation.h"
#include "base/atomic_file.h"
#include "vm/error.h"

const char *expectation_name(enum expectation_kind kind)
{
    static const char *const names[EXPECT_KINDS] = {
        [EXPECT_REGISTER] = "register", [EXPECT_HALF_REGISTER] = "half",
        [EXPECT_WORDS] = "words",       [EXPECT_HALVES] = "halves",
        [EXPECT_BITS] = "bits",         [EXPECT_FLAGS] = "flags",
        [EXPECT_CLOCKS] = "clocks",     [EXPECT_TRAP] = "trap",
        [EXPECT_PRINT] = "print",       [EXPECT_MODEL] = "model",
        [EXPECT_WARNING] = "warning"
    };
    return names[kind];
}

/* Writes a name and a newline. Control characters are replaced by "?", because a
 * newline in the name would end the line of the object file. */
static void put_name(const struct sink *sink, const char *name)
{
    for (; *name; name++)
        sink->put(sink->context, iscntrl((unsigned char)*name) ? "?" : name, 1);
    sink_put(sink, "\n");
}

static void write_words(const struct sink *sink, const c205_word *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        sink_print(sink, "%016" PRIX64 "\n", words[i]);
}

static void write_segment(const struct sink *sink, const c205_segment *segment)
{
    sink_print(sink, "%s %" PRIX64 " %zu\n", segment->words ? "segment" : "zeros",
               segment->address, segment->length);
    if (segment->words)
        write_words(sink, segment->words, segment->length);
}

static void write_symbol(const struct sink *sink, const struct asm_symbol *symbol)
{
    const char *kind = symbol->is_word ? "word" : "integer";
    sink_print(sink, "%s %" PRIX64 " ", symbol->is_label ? "label" : kind,
               (uint64_t)symbol->value);
    put_name(sink, symbol->name);
}

static void write_expectation(const struct sink *sink,
                              const struct asm_expectation *expectation)
{
    size_t count = expectation->count;
    sink_print(sink, "expect %s %u %" PRIX64 " %zu %zu ",
               expectation_name(expectation->kind), expectation->number,
               expectation->address, count, expectation->line);
    put_name(sink, expectation->file);
    if (expectation->kind == EXPECT_BITS)
        count = (count + 63) / 64;
    write_words(sink, expectation->words, count);
    if (expectation->has_tolerance)
        sink_print(sink, "within %016" PRIX64 "\n", expectation->tolerance);
    if (expectation->text) {
        sink_put(sink, "text ");
        put_name(sink, expectation->text);
    }
}

void object_write(const struct object *object, const struct sink *sink)
{
    const c205_program *program = &object->program;
    sink_print(sink, "c205-object 1\nentry %" PRIX64 "\n", program->entry);
    if (program->warm)
        sink_put(sink, "warm\n");
    for (size_t i = 0; i < program->segment_count; i++)
        write_segment(sink, &program->segments[i]);
    for (size_t i = 0; i < program->region_count; i++) {
        const c205_region *region = &program->regions[i];
        sink_print(sink, "region %" PRIX64 " %" PRIX64 " ", region->begin, region->end);
        put_name(sink, region->name);
    }
    for (size_t i = 0; i < object->symbol_count; i++)
        write_symbol(sink, &object->symbols[i]);
    for (size_t i = 0; i < object->expectation_count; i++)
        write_expectation(sink, &object->expectations[i]);
    sink_put(sink, "end\n");
}

bool object_save(const struct object *object, const char *path, c205_error *error)
{
    struct atomic_file *whole = atomic_file_open(path, error);
    struct sink sink;
    if (!whole)
        return false;
    sink = stream_sink(whole->file);
    object_write(object, &sink);
    return atomic_file_commit(whole, error);
}

/* Checks that a program has instructions. The entry of an empty program is the default
 * start of the code, CODE_ORIGIN, so only this entry is checked. */
bool object_check(const struct object *object, c205_error *error)
{
    const c205_program *program = &object->program;
    if (program->entry != CODE_ORIGIN)
        return true;
    for (size_t i = 0; i < program->segment_count; i++)
        if (program->segments[i].address <= CODE_ORIGIN
            && (CODE_ORIGIN - program->segments[i].address) / 64
                   < program->segments[i].length)
            return true;
    return error_set(error, "the program is empty: it has no instructions");
}

bool object_recognise(const char *text, size_t length)
{
    static const char magic[] = "c205-object ";
    return length >= sizeof magic - 1 && memcmp(text, magic, sizeof magic - 1) == 0;
}
