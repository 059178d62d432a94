/* cmd_check_folder.c - reads lessons from folders, and grades folders of answers. */
#include <stdlib.h>
#include <string.h>

#include "asm/command/cmd_check.h"
#include "vm/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/text_file.h"

static bool join_path(struct text_buffer *path, const char *folder, const char *name)
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
    char *text = join_path(&path, folder, name)
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

/* ---- Answers --------------------------------------------------------------- */

/* The answers of a class, and the table of their results. */
struct handed_in {
    const struct check_command *check;
    struct table *table;
    struct progress progress;
    size_t refused;
    bool failed; /* memory is exhausted */
};

/* Reports the first test that failed. If all tests passed, reports the first test that
 * has a report. */
static void join_first(struct text_buffer *report, const struct lesson_verdict *verdict)
{
    const struct lesson_trial *reported = NULL;
    struct sink sink = text_buffer_sink(report);
    for (size_t i = 0; i < verdict->count; i++) {
        const struct lesson_trial *trial = &verdict->trials[i];
        if (trial->report.count > 0
            && (!reported || (reported->passed && !trial->passed)))
            reported = trial;
    }
    if (reported) {
        sink_print(&sink, "%s:", reported->test->name);
        check_join(report, &reported->report);
    }
    check_join(report, &verdict->report);
}

static void add_row(struct handed_in *all, const char *student,
                    const struct lesson_verdict *verdict)
{
    struct text_buffer report = { 0 };
    join_first(&report, verdict);
    table_text(all->table, student);
    if (verdict->lesson)
        table_text(all->table, verdict->lesson->name);
    else
        table_gap(all->table);
    table_text(all->table, verdict->passed ? "yes" : "no");
    table_text(all->table, medal_name(verdict->medal));
    if (verdict->clocks > 0)
        table_count(all->table, verdict->clocks);
    else
        table_gap(all->table);
    table_text(all->table, report.text ? report.text : "");
    all->failed = all->failed || report.failed;
    text_buffer_free(&report);
}

static void add(struct handed_in *all, const char *student,
                const struct lesson_verdict *verdict)
{
    struct json *json = all->check->results.json;
    add_row(all, student, verdict);
    if (json) {
        json_object(json, NULL);
        json_text(json, "student", student);
        lesson_verdict_json(verdict, json);
        json_end(json);
    }
}

/* Adds a row for an answer that cannot be graded, and prints the reason on stderr. */
static void refuse(struct handed_in *all, const char *student,
                   const struct lesson *lesson, const char *path, const char *reason)
{
    struct lesson_verdict verdict = { 0 };
    progress_hide(&all->progress);
    cmd_failed(all->check->args->shared.command, "%s: not graded: %s", path, reason);
    lesson_refuse(&verdict, lesson, path, reason);
    add(all, student, &verdict);
    all->refused++;
    all->failed = all->failed || verdict.kept.failed;
    lesson_verdict_free(&verdict);
}

/* Grades a file and adds a row in any case. lesson is NULL if the name of the file is
 * not the name of a lesson. */
static void grade(struct handed_in *all, const char *student,
                  const struct lesson *lesson, const char *path)
{
    struct lesson_verdict verdict = { 0 };
    c205_error error;
    if (!file_is_plain(path, &error)) {
        refuse(all, student, lesson, path, error.message);
    } else if (!lesson) {
        refuse(all, student, lesson, path,
               file_ends_with(path, ".s") ? "its name is not the name of a lesson"
                                          : "its name does not end in '.s'");
    } else if (!check_grade(all->check, lesson, path, &verdict, &error)) {
        refuse(all, student, lesson, path, error.message);
    } else {
        add(all, student, &verdict);
    }
    lesson_verdict_free(&verdict);
}

/* ---- Folders of answers ---------------------------------------------------- */

/* Handles a file or folder of a student. student is "" if the student is unknown. */
typedef void take_file(struct handed_in *all, const char *student, const char *name,
                       const char *path);

/* Calls the function for each entry of a folder. */
static void take_folder(struct handed_in *all, const char *student, const char *path,
                        take_file *take)
{
    struct folder folder;
    c205_error error;
    if (!folder_read(&folder, path, &error))
        refuse(all, student, all->check->lesson, path, error.message);
    for (size_t i = 0; i < folder.count && !interrupt_pending(); i++) {
        struct text_buffer inner = { 0 };
        if (join_path(&inner, path, folder.names[i]))
            take(all, student, folder.names[i], inner.text);
        all->failed = all->failed || inner.failed;
        text_buffer_free(&inner);
        if (!*student)
            progress_update(&all->progress, i + 1, folder.count);
    }
    folder_free(&folder);
}

/* Returns the name without ".s". The result is empty if the name does not end in ".s".
 * The caller frees it. */
static struct text_buffer stem_of(const char *name)
{
    struct text_buffer stem = { 0 };
    struct sink sink = text_buffer_sink(&stem);
    if (file_ends_with(name, ".s"))
        sink.put(sink.context, name, strlen(name) - 2);
    return stem;
}

/* Finds a lesson by name. A lesson from a folder has precedence over a built-in
 * lesson. */
static const struct lesson *lesson_named(const struct check_command *check,
                                         const char *name)
{
    const struct lesson *own = &check->own;
    c205_error error;
    return own->folder && lesson_is_named(own, name)
               ? own
               : lessons_find(&check->lessons, name, &error);
}

/* Grades LESSON.s. Answers to other lessons are ignored if the arguments name a
 * lesson. */
static void take_answer(struct handed_in *all, const char *student, const char *name,
                        const char *path)
{
    const struct lesson *asked = all->check->lesson;
    struct text_buffer stem = stem_of(name);
    const struct lesson *lesson = stem.text ? lesson_named(all->check, stem.text)
                                            : NULL;
    all->failed = all->failed || stem.failed;
    text_buffer_free(&stem);
    if (!lesson || !asked || lesson == asked)
        grade(all, student, lesson, path);
}

/* Grades the folder STUDENT. A folder without an answer has a row, too. */
static void take_student(struct handed_in *all, const char *name, const char *path)
{
    size_t rows = table_rows(all->table);
    take_folder(all, name, path, take_answer);
    if (table_rows(all->table) == rows && !interrupt_pending())
        refuse(all, name, all->check->lesson, path, "no answer was found");
}

/* Returns the name of the student of a file that is not in the folder of a student. The
 * file is STUDENT.s if all answers are to the lesson `asked`, and may be STUDENT
 * without an ending. The student of LESSON.s is unknown, so the result is empty. The
 * caller frees it. */
static struct text_buffer student_of(const char *name, const struct lesson *asked)
{
    struct text_buffer student = { 0 };
    struct sink sink = text_buffer_sink(&student);
    size_t length = file_ends_with(name, ".s") ? strlen(name) - 2 : strcspn(name, ".");
    if (asked || !name[length])
        sink.put(sink.context, name, length);
    return student;
}

/* Grades an entry of a folder of answers: a folder STUDENT, or a file LESSON.s or
 * STUDENT.s. `nobody` is the student if the name contains none. */
static void take_entry(struct handed_in *all, const char *nobody, const char *name,
                       const char *path)
{
    const struct lesson *asked = all->check->lesson;
    struct text_buffer student = student_of(name, asked);
    const char *of = student.text ? student.text : nobody;
    all->failed = all->failed || student.failed;
    if (folder_is(path))
        take_student(all, name, path);
    else if (!asked)
        take_answer(all, of, name, path);
    else
        grade(all, of, file_ends_with(name, ".s") ? asked : NULL, path);
    text_buffer_free(&student);
}

static struct table *new_table(void)
{
    static const struct table_column columns[] = {
        { "student", "student", TABLE_TEXT, 0 }, { "lesson", "lesson", TABLE_TEXT, 0 },
        { "passed", "passed", TABLE_TEXT, 0 },   { "medal", "medal", TABLE_TEXT, 0 },
        { "clocks", "clocks", TABLE_COUNT, 0 },  { "report", "report", TABLE_TEXT, 0 },
    };
    return table_new(TABLE_COLUMNS(columns));
}

static int take_class(struct handed_in *all)
{
    const struct check_arguments *args = all->check->args;
    const struct command_output *results = &all->check->results;
    if (results->json)
        json_array(results->json, "hand_ins");
    interrupt_catch();
    progress_begin(&all->progress);
    take_folder(all, "", args->folder, take_entry);
    progress_hide(&all->progress);
    if (results->json)
        json_end(results->json);
    if (interrupt_pending())
        return cmd_failed(args->shared.command, "interrupted");
    return !all->failed
                   && (!results->file
                       || table_write(all->table, output_table_format(results),
                                      results->file))
               ? CMD_DONE
               : cmd_failed(args->shared.command, "out of memory");
}

int check_folder(const struct check_command *check, bool *all_graded)
{
    struct handed_in all = { .check = check, .table = new_table() };
    const struct check_arguments *args = check->args;
    int code = !all.table ? cmd_failed(args->shared.command, "out of memory")
               : !folder_is(args->folder)
                   ? cmd_failed(args->shared.command, "%s is not a folder",
                                args->folder)
                   : take_class(&all);
    table_free(all.table);
    *all_graded = all.refused == 0;
    return code;
}
