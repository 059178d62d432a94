/* lesson.c - builds lessons from their files. */
#include "asm/lesson/lesson.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "vm/error.h"
#include "base/text_file.h"
#include "base/spelling.h"
#include "vm/text.h"

const char *medal_name(enum medal medal)
{
    static const char *const names[MEDALS] = { "", "bronze", "silver", "gold" };
    return names[medal];
}

/* ---- Lessons from their files ---------------------------------------------- */

/* Begins a lesson. The name of its folder is NUMBER-NAME. */
bool lesson_begin(struct lesson *lesson, const char *folder, c205_error *error)
{
    char *end;
    unsigned long number = strtoul(folder, &end, 10);
    bool numbered = isdigit((unsigned char)*folder) && *end == '-';
    lesson->folder = arena_text(&lesson->kept, folder, strlen(folder));
    if (!lesson->folder)
        return error_set(error, "out of memory");
    lesson->number = numbered ? (unsigned)number : 0;
    lesson->name = lesson->folder + (numbered ? end + 1 - folder : 0);
    return true;
}

/* Reads the title from the first line of the text, "# Title". */
static bool take_title(struct lesson *lesson, c205_error *error)
{
    size_t length = strcspn(lesson->text, "\n");
    if (strncmp(lesson->text, "# ", 2) != 0 || length == 2)
        return error_set(error, "%.80s/lesson.md:1: expected '# Title'",
                         lesson->folder);
    lesson->title = arena_text(&lesson->kept, lesson->text + 2, length - 2);
    return lesson->title || error_set(error, "out of memory");
}

/* Reads a test of a file. The length of its name in the name of the file may be 0. */
static bool take_test(struct lesson *lesson, struct lesson_test *test, const char *file,
                      const char *name, size_t name_length, const char *text,
                      size_t length, c205_error *error)
{
    *test = (struct lesson_test){
        .name = arena_text(&lesson->kept, name, name_length),
        .file = arena_text(&lesson->kept, file, strlen(file)),
        .text = text,
        .length = length,
    };
    if (!test->name || !test->file)
        return error_set(error, "out of memory");
    return lesson_read_notes(lesson, test, error);
}

static bool take_fresh(struct lesson *lesson, const char *text, size_t length,
                       c205_error *error)
{
    return take_test(lesson, &lesson->fresh, "fresh.s", "fresh", strlen("fresh"), text,
                     length, error)
           && (!lesson->fresh.has_goals
               || error_set(error, "%.80s/fresh.s has goals, which the tests define",
                            lesson->folder));
}

bool lesson_take(struct lesson *lesson, const char *file, const char *text,
                 size_t length, c205_error *error)
{
    static const char before[] = "test-", behind[] = ".s";
    size_t name = strlen(file), around = sizeof before + sizeof behind - 2;
    bool is_test = name > around && strncmp(file, before, sizeof before - 1) == 0
                   && strcmp(file + name - (sizeof behind - 1), behind) == 0;
    bool is_text = strcmp(file, "lesson.md") == 0;
    bool is_fresh = strcmp(file, "fresh.s") == 0;
    bool is_start = strcmp(file, "start.s") == 0;
    const char **place = is_start                          ? &lesson->start
                         : is_text                         ? &lesson->text
                         : strcmp(file, "solution.s") == 0 ? &lesson->solution
                                                           : NULL;
    const char *kept;
    struct lesson_test *test;
    if (!is_test && !is_fresh && !place)
        return true;
    kept = arena_text(&lesson->kept, text, length);
    if (!kept)
        return error_set(error, "out of memory");
    if (is_fresh)
        return take_fresh(lesson, kept, length, error);
    if (place) {
        *place = kept;
        return !is_text || take_title(lesson, error);
    }
    test = arena_add(&lesson->kept, &lesson->tests, &lesson->test_count,
                     &lesson->test_capacity, NULL, sizeof *test);
    return test ? take_test(lesson, test, file, file + sizeof before - 1, name - around,
                            kept, length, error)
                : error_set(error, "out of memory");
}

static int compare_tests(const void *a, const void *b)
{
    const struct lesson_test *one = a, *other = b;
    return one->has_goals != other->has_goals ? one->has_goals - other->has_goals
                                              : strcmp(one->name, other->name);
}

bool lesson_end(struct lesson *lesson, c205_error *error)
{
    const char *missing = !lesson->text             ? "lesson.md"
                          : !lesson->start          ? "start.s"
                          : lesson->test_count == 0 ? "test-NAME.s"
                                                    : NULL;
    if (missing)
        return error_set(error, "%.160s is not a lesson: it has no %s", lesson->folder,
                         missing);
    qsort(lesson->tests, lesson->test_count, sizeof *lesson->tests, compare_tests);
    return true;
}

void lesson_free(struct lesson *lesson)
{
    arena_free(&lesson->kept);
}

bool lesson_is_named(const struct lesson *lesson, const char *name)
{
    char *end;
    unsigned long number = strtoul(name, &end, 10);
    bool is_number = isdigit((unsigned char)*name) && !*end;
    return strcmp(lesson->name, name) == 0 || strcmp(lesson->folder, name) == 0
           || (is_number && lesson->number > 0 && lesson->number == number);
}

/* ---- The lessons of the library ------------------------------------------ */

/* Adds a text to its lesson. The texts are named "folder/file", and the texts of a
 * folder are consecutive. */
static bool take_text(struct lesson *lesson, const struct text *text, c205_error *error)
{
    struct text_buffer joined = { 0 };
    struct sink sink = text_buffer_sink(&joined);
    bool good;
    text_put(text, &sink);
    good = !joined.failed
               ? lesson_take(lesson, strchr(text->name, '/') + 1,
                             joined.text ? joined.text : "", joined.length, error)
               : error_set(error, "out of memory");
    text_buffer_free(&joined);
    return good;
}

static bool is_of(const struct text *text, const char *name, size_t length)
{
    return text->name && strncmp(text->name, name, length) == 0;
}

/* Builds the lesson whose first text is `text`. Returns the first text of the next
 * lesson, or NULL with the error. */
static const struct text *open_next(struct lesson *lesson, const struct text *text,
                                    c205_error *error)
{
    const char *name = text->name;
    size_t length = (size_t)(strchr(name, '/') + 1 - name);
    struct text_line folder = { 0 };
    struct sink sink = text_line_sink(&folder);
    sink_print(&sink, "%.*s", (int)length - 1, name);
    if (!lesson_begin(lesson, folder.text, error))
        return NULL;
    for (; is_of(text, name, length); text++)
        if (!take_text(lesson, text, error))
            return NULL;
    return lesson_end(lesson, error) ? text : NULL;
}

bool lessons_open(struct lessons *lessons, c205_error *error)
{
    const struct text *text = lesson_texts;
    size_t most = 0;
    while (lesson_texts[most].name)
        most++;
    lessons->count = 0;
    lessons->items = calloc(most + 1, sizeof *lessons->items);
    if (!lessons->items)
        return error_set(error, "out of memory");
    while (text && text->name)
        text = open_next(&lessons->items[lessons->count++], text, error);
    return text;
}

void lessons_free(struct lessons *lessons)
{
    for (size_t i = 0; i < lessons->count; i++)
        lesson_free(&lessons->items[i]);
    free(lessons->items);
}

struct lesson *lessons_find(const struct lessons *lessons, const char *name,
                            c205_error *error)
{
    struct spelling nearest = { .word = name };
    for (size_t i = 0; i < lessons->count; i++) {
        struct lesson *lesson = &lessons->items[i];
        if (lesson_is_named(lesson, name))
            return lesson;
        spelling_try(&nearest, lesson->name);
    }
    if (nearest.name)
        error_set(error, "unknown lesson '%.80s'; did you mean '%.80s'?", name,
                  nearest.name);
    else
        error_set(error, "unknown lesson '%.80s'; c205 check lists all lessons", name);
    return NULL;
}
