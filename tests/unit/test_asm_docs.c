/* test_asm_docs.c - the examples of the pages: every block marked c205 must assemble,
 * and must meet its expectations. An example that no longer works fails here. */
#include "tests/unit/saved_machine.h"

#include "asm/check/expect.h"
#include "asm/check/runtime_check.h"
#include "asm/view/print.h"
#include "base/file.h"

static const char fence[] = "```c205\n";
static size_t blocks; /* number of blocks that were checked */

static void run(const struct object *object, const char *name)
{
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe-prior", &failure);
    SCOPED(c205) *machine = machine_with(&object->program, model);
    SCOPED_VALUE(text_buffer) printed = { NULL, 0, 0, false };
    struct printer printer = { text_buffer_sink(&printed) };
    struct sink report = stream_sink(stderr);
    const struct warning_choice choice = { .errors = true };
    assert_true(c205_listen(machine, printer_listen, &printer));
    struct runtime_checker *watch = NON_NULL(
        runtime_new(object, name, &choice, &report));
    assert_true(c205_listen(machine, runtime_listen, watch));
    runtime_begin(watch, machine);
    c205_stop stop = c205_run(machine, 1000000);
    FAIL_IF(!expect_check(object, machine, &stop, printed.text ? printed.text : "",
                          object->warned | runtime_warned(watch), &report),
            "%s", name);
    assert_int_equal(runtime_errors(watch), 0);
    runtime_free(watch);
}

static void check_block(const char *name, const char *text, size_t length)
{
    FREED char *copy = NON_NULL(calloc(1, length + 1));
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct sink sink = stream_sink(stderr);
    memcpy(copy, text, length);
    SCOPED(object) *object = NON_NULL(assemble_text(name, copy, NULL, &errors));
    diagnostics_put(&errors, &sink);
    if (object->expectation_count > 0)
        run(object, name);
}

/* Checks the blocks of a file, which are named by file and first line. */
static void check_file(const char *path)
{
    size_t length;
    FREED char *text = NON_NULL(file_read(path, FILE_LARGEST, &length, &failure));
    const char *at = text;
    while ((at = strstr(at, fence)) != NULL) {
        unsigned number = 1;
        for (const char *line = text; (line = strchr(line, '\n')) && line < at; line++)
            number++;
        at += sizeof fence - 1;
        const char *end = NON_NULL(strstr(at, "```"));
        check_block(formatted("%s:%u", path, number), at, (size_t)(end - at));
        at = end + 3;
        blocks++;
    }
}

TEST(examples)
{
    each_file("docs/*.md", check_file);
    assert_true(blocks > 10);
}
