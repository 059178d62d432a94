/* test_source.c - assembles the text of a test and checks it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/check/expect.h"
#include "asm/lesson/lesson_internal.h"
#include "asm/text/assemble.h"
#include "vm/error.h"
#include "base/named_model.h"

const char *lesson_wanted(const char *label)
{
    static const char prefix[] = "want_";
    size_t length = sizeof prefix - 1;
    return strncmp(label, prefix, length) == 0 ? label + length : NULL;
}

bool lesson_is_constant(const struct asm_symbol *symbol)
{
    return !symbol->is_label && !symbol->is_word;
}

/* Rejects expectations that contain an address of the test. A test uses a label
 * want_LABEL instead. */
static bool check_expectations(const struct object *object, c205_error *error)
{
    for (size_t i = 0; i < object->expectation_count; i++) {
        const struct asm_expectation *expectation = &object->expectations[i];
        if (expectation->kind == EXPECT_WORDS || expectation->kind == EXPECT_HALVES
            || expectation->kind == EXPECT_BITS || expectation->kind == EXPECT_WARNING)
            return error_set(
                error,
                "%.80s:%zu: a test cannot contain this expectation; put the expected "
                "data at want_LABEL",
                expectation->file, expectation->line);
    }
    return true;
}

bool test_wants(const struct object *object, const char *label)
{
    size_t i = 0;
    while (i < object->symbol_count) {
        const struct asm_symbol *symbol = &object->symbols[i++];
        const char *wanted = lesson_wanted(symbol->name);
        if (symbol->is_label && wanted
            && (label ? strcmp(wanted, label) == 0 : symbol->contents != ASM_NOTHING))
            return true;
    }
    return false;
}

/* Rejects the label "want_", and code at a label want_LABEL. */
static bool check_wanted(const struct lesson_test *test, const struct object *object,
                         c205_error *error)
{
    for (size_t i = 0; i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];
        const char *wanted = lesson_wanted(symbol->name);
        if (symbol->is_label && wanted && (!*wanted || symbol->contents == ASM_CODE))
            return error_set(error, "%.48s: expected data at want_LABEL, not %.60s",
                             test->file, *wanted ? "instructions" : symbol->name);
    }
    return true;
}

static bool check_labels(const struct lesson_test *test, const struct object *object,
                         c205_error *error)
{
    const struct lesson_tolerance *tolerance = test->tolerances;
    if (!check_wanted(test, object, error))
        return false;
    if (!test_wants(object, NULL) && !expect_anything(object))
        return error_set(error, "%.48s expects nothing", test->file);
    while (tolerance && test_wants(object, tolerance->label))
        tolerance = tolerance->next;
    return !tolerance
           || error_set(error,
                        "%.48s has a tolerance for %.40s, but no label want_%.40s",
                        test->file, tolerance->label, tolerance->label);
}

static bool check_model(const struct lesson_test *test, const struct object *object,
                        c205_error *error)
{
    const char *name = expect_model(object);
    c205_error why = { "programs cannot run on its model, which only gives times" };
    c205_model *model = name ? model_find(name, &why) : NULL;
    bool good = !name || (model && !c205_model_is_projection(model));
    c205_model_free(model);
    return good || error_set(error, "%.48s: %.160s", test->file, why.message);
}

static void print_first(const struct diagnostics *said, c205_error *error)
{
    const struct diagnostic *first = said->items;
    while (first < said->items + said->count && first->severity != SEVERITY_ERROR)
        first++;
    if (said->errors == 0 || first == said->items + said->count)
        error_set(error, "out of memory");
    else
        error_set(error, "%.80s:%zu:%zu: %.120s", first->file, first->line,
                  first->column, first->message);
}

static struct object *assemble(const struct lesson_test *test,
                               const struct asm_define *defines, c205_error *error)
{
    struct asm_options options = { .defines = defines, .sealed = true };
    struct diagnostics said = { 0 };
    struct object *object = assemble_bytes(test->file, test->text, test->length,
                                           &options, &said);
    if (!object)
        print_first(&said, error);
    diagnostics_free(&said);
    if (object
        && (!check_expectations(object, error) || !check_labels(test, object, error)
            || !check_model(test, object, error))) {
        object_free(object);
        return NULL;
    }
    return object;
}

struct object *lesson_assemble_test(const struct lesson_test *test, c205_error *error)
{
    return assemble(test, NULL, error);
}

/* Returns the constants of the test for the answer. A fresh test passes only constants
 * of the names that the other test has. Returns NULL if memory is exhausted. */
static struct asm_define *make_defines(const struct object *object,
                                       const struct object *like)
{
    struct asm_define *defines = calloc(object->symbol_count + 1, sizeof *defines);
    size_t count = 0;
    for (size_t i = 0; defines && i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];
        const struct asm_symbol *other = like ? object_symbol(like, symbol->name)
                                              : symbol;
        if (lesson_is_constant(symbol) && other && lesson_is_constant(other))
            defines[count++] = (struct asm_define){ symbol->name, symbol->value };
    }
    return defines;
}

bool test_case_open(struct test_case *test, const struct lesson_test *notes,
                    const struct asm_define *defines, const struct object *like,
                    c205_error *error)
{
    const char *model;
    test->notes = notes;
    test->object = assemble(notes, defines, error);
    if (!test->object)
        return false;
    test->defines = make_defines(test->object, like);
    if (!test->defines)
        return error_set(error, "out of memory");
    model = expect_model(test->object);
    if (!model && like)
        model = expect_model(like);
    test->model = model_find(model ? model : C205_DEFAULT_MODEL, error);
    test->data = test->model ? c205_new(test->model, error) : NULL;
    return test->data && c205_load(test->data, &test->object->program, error);
}

void test_case_close(struct test_case *test)
{
    c205_free(test->data);
    c205_model_free(test->model);
    free(test->defines);
    object_free(test->object);
}
