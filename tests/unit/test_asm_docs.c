/* test_asm_docs.c - the examples of the pages: every block marked c205 must assemble,
 * and the results of blocks with expectations are compared with them. An example that
 * no longer works fails here. */
#include "tests/unit/asm_helper.h"

#include <dirent.h>

#include "asm/expect.h"
#include "base/file.h"
#include "asm/print.h"
#include "asm/runtime_check.h"

static const char fence[] = "```c205\n";

static void run(const struct object *object, const char *name)
{
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe-prior", &error);
    c205 *machine = model ? c205_new(model, &error) : NULL;
    struct text_buffer printed = { NULL, 0, 0, false };
    struct printer printer = { text_buffer_sink(&printed) };
    struct sink report = stream_sink(stderr);
    const struct warning_choice choice = { .errors = true };
    struct runtime_checker *watch;
    warning_set warned;
    c205_stop stop;

    assert_non_null(machine);
    assert_true(c205_listen(machine, printer_listen, &printer));
    assert_true(c205_load(machine, &object->program, &error));
    watch = runtime_new(object, name, &choice, &report);
    assert_non_null(watch);
    assert_true(c205_listen(machine, runtime_listen, watch));
    runtime_begin(watch, machine);
    stop = c205_run(machine, 1000000);
    warned = object->warned | runtime_warned(watch);
    if (!expect_check(object, machine, &stop, printed.text ? printed.text : "", warned,
                      &report))
        fail_msg("%s", name);
    assert_int_equal(runtime_errors(watch), 0);
    runtime_free(watch);
    text_buffer_free(&printed);
    c205_free(machine);
    c205_model_free(model);
}

static void check_block(const char *name, const char *text, size_t length)
{
    char *copy = calloc(1, length + 1);
    struct diagnostics errors = { 0 };
    struct sink sink = stream_sink(stderr);
    struct object *object;

    assert_non_null(copy);
    memcpy(copy, text, length);
    object = assemble_text(name, copy, NULL, &errors);
    diagnostics_put(&errors, &sink);
    diagnostics_free(&errors);
    assert_non_null(object);
    if (object->expectation_count > 0)
        run(object, name);
    object_free(object);
    free(copy);
}

/* Checks the blocks of a file; each is named after the file and the line of its
 * start. */
static size_t check_file(const char *path)
{
    c205_error error;
    size_t length, blocks = 0;
    char *text = file_read(path, FILE_LARGEST, &length, &error), name[700];
    const char *at = text, *end, *line;

    assert_non_null(text);
    while ((at = strstr(at, fence)) != NULL) {
        unsigned number = 1;

        for (line = text; (line = strchr(line, '\n')) != NULL && line < at; line++)
            number++;
        at += sizeof fence - 1;
        end = strstr(at, "```");
        assert_non_null(end);
        snprintf(name, sizeof name, "%s:%u", path, number);
        check_block(name, at, (size_t)(end - at));
        at = end + 3;
        blocks++;
    }
    free(text);
    return blocks;
}

TEST(examples)
{
    DIR *docs = opendir("docs");
    struct dirent *entry;
    char path[600];
    size_t blocks = 0;

    assert_non_null(docs);
    while ((entry = readdir(docs)) != NULL) {
        size_t length = strlen(entry->d_name);

        if (length < 4 || strcmp(entry->d_name + length - 3, ".md") != 0)
            continue;
        snprintf(path, sizeof path, "docs/%s", entry->d_name);
        blocks += check_file(path);
    }
    closedir(docs);
    assert_true(blocks > 10);
}
