/* cmd_check_read.c - reads lessons, and unpublished tests of lessons, from folders. */
#include <stdlib.h>
#include <string.h>

#include "asm/command/cmd_check.h"
#include "vm/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/text_file.h"

bool check_join_path(struct text_buffer *path, const char *folder, const char *name)
{
    struct sink sink = text_buffer_sink(path);
    sink_put(&sink, folder);
    sink_put(&sink, "/");
    sink_put(&sink, name);
    return !path->failed;
}

/* ---- A lesson -------------------------------------------------------------- */

static bool read_file(struct lesson *lesson, const char *folder, const char *name,
                      c205_error *error)
{
    struct text_buffer path = { 0 };
    c205_error reason;
    size_t length;
    char *text = check_join_path(&path, folder, name)
                     ? text_file_read(path.text, FILE_LARGEST, &length, &reason)
                     : NULL;
    bool good = text ? lesson_take(lesson, name, text, length, error)
                     : error_set(error, "%.160s: %.80s", path.failed ? name : path.text,
                                 path.failed ? "out of memory" : reason.message);
    text_buffer_free(&path);
    free(text);
    return good;
}

/* Starts a lesson. Its name is the last component of the path: "b" for "a/b/". */
static bool begin_lesson(struct lesson *lesson, const char *path, c205_error *error)
{
    struct text_line name = { 0 };
    struct sink sink = text_line_sink(&name);
    size_t end = strlen(path), begin;
    while (end > 1 && path[end - 1] == '/')
        end--;
    for (begin = end; begin > 0 && path[begin - 1] != '/';)
        begin--;
    sink_print(&sink, "%.*s", (int)(end - begin), path + begin);
    return lesson_begin(lesson, name.text, error);
}

/* Checks all tests, so an error in a lesson is reported before the first answer is
 * graded. */
static bool check_tests(const struct lesson *lesson, c205_error *error)
{
    bool good = true;
    for (size_t i = 0; good && i < lesson->test_count; i++) {
        struct object *test = lesson_assemble_test(&lesson->tests[i], error);
        good = test;
        object_free(test);
    }
    return good;
}

bool check_read_lesson(struct lesson *lesson, const char *path, c205_error *error)
{
    struct folder folder;
    c205_error reason;
    bool good = folder_read(&folder, path, &reason)
                    ? begin_lesson(lesson, path, error)
                    : error_set(error, "%.160s: %.80s", path, reason.message);
    for (size_t i = 0; good && i < folder.count; i++) {
        const char *name = folder.names[i];
        if (file_ends_with(name, ".s") || file_ends_with(name, ".md"))
            good = read_file(lesson, path, name, error);
    }
    folder_free(&folder);
    return good && lesson_end(lesson, error) && check_tests(lesson, error);
}

/* ---- Unpublished tests ----------------------------------------------------- */

/* Adds the tests in a folder to a lesson. */
static bool add_tests(struct lesson *lesson, const char *path, c205_error *error)
{
    struct folder folder;
    c205_error reason;
    bool good = folder_read(&folder, path, &reason)
                || error_set(error, "%.160s: %.80s", path, reason.message);
    for (size_t i = 0; good && i < folder.count; i++)
        if (strncmp(folder.names[i], "test-", strlen("test-")) == 0)
            good = read_file(lesson, path, folder.names[i], error);
    folder_free(&folder);
    return good && lesson_end(lesson, error) && check_tests(lesson, error);
}

/* Adds the tests in the folder of a lesson, if there is one. */
static bool add_tests_of(struct lesson *lesson, const char *path, const char *name,
                         c205_error *error)
{
    struct text_buffer inner = { 0 };
    bool good = check_join_path(&inner, path, name)
                || error_set(error, "out of memory");
    if (good && folder_is(inner.text))
        good = add_tests(lesson, inner.text, error);
    text_buffer_free(&inner);
    return good;
}

bool check_read_tests(struct check_command *check, c205_error *error)
{
    const char *path = check->args->tests;
    struct lesson *asked = check->lesson;
    if (!folder_is(path))
        return error_set(error, "%.200s is not a folder", path);
    if (asked)
        return add_tests(asked, path, error);
    for (size_t i = 0; i < check->lessons.count; i++)
        if (!add_tests_of(&check->lessons.items[i], path,
                          check->lessons.items[i].folder, error))
            return false;
    return true;
}
