/* cmd_check_folder.c - grades folders of answers. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "asm/command/cmd_check.h"
#include "vm/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/text_file.h"

/* ---- Answers --------------------------------------------------------------- */

/* The code of an answer that was graded. */
struct known_code {
    const struct lesson *lesson;
    const char *path;
    uint64_t hash;
};

/* The answers of a class, and the table of their results. */
struct handed_in {
    const struct check_command *check;
    struct table *table;
    struct feedback feedback;
    size_t code_count, code_capacity;
    struct known_code *codes;
    struct arena kept;
    struct progress progress;
    size_t refused;
    bool failed; /* memory is exhausted */
};

/* Sets the modification time of a file, or "" if it is unknown. */
static void set_date(struct hand_in *hand_in, const char *path)
{
    struct stat status;
    struct tm *time = stat(path, &status) == 0 ? gmtime(&status.st_mtime) : NULL;
    if (!time
        || strftime(hand_in->date, sizeof hand_in->date, "%Y-%m-%d %H:%M", time) == 0)
        *hand_in->date = '\0';
}

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

static void add_first(struct handed_in *all, const struct lesson_verdict *verdict)
{
    struct text_buffer report = { 0 };
    join_first(&report, verdict);
    table_text(all->table, report.text ? report.text : "");
    all->failed = all->failed || report.failed;
    text_buffer_free(&report);
}

static void add_remarks(struct handed_in *all, const struct lesson_report *remarks)
{
    struct text_buffer text = { 0 };
    check_join(&text, remarks);
    table_text(all->table, text.text ? text.text : "");
    all->failed = all->failed || text.failed;
    text_buffer_free(&text);
}

/* Remarks that an earlier answer to the same lesson has the same code, or keeps the
 * code. */
static void compare_code(struct handed_in *all, struct lesson_verdict *verdict,
                         const char *path)
{
    struct known_code code = { verdict->lesson, NULL, verdict->code };
    size_t i = 0;
    if (code.hash == 0)
        return;
    while (i < all->code_count
           && (all->codes[i].lesson != code.lesson || all->codes[i].hash != code.hash))
        i++;
    if (i < all->code_count) {
        lesson_remark_same_code(verdict, all->codes[i].path);
        return;
    }
    code.path = arena_text(&all->kept, path, strlen(path));
    arena_add(&all->kept, &all->codes, &all->code_count, &all->code_capacity, &code,
              sizeof code);
    all->failed = all->failed || all->kept.failed;
}

static void add_count(struct handed_in *all, uint64_t count, bool known)
{
    if (known)
        table_count(all->table, count);
    else
        table_gap(all->table);
}

static void add_row(struct handed_in *all, const struct hand_in *hand_in)
{
    const struct lesson_verdict *verdict = hand_in->verdict;
    bool known = verdict->of_count > 0;
    table_text(all->table, hand_in->student);
    if (verdict->lesson)
        table_text(all->table, verdict->lesson->name);
    else
        table_gap(all->table);
    table_text(all->table, verdict->passed ? "yes" : "no");
    table_text(all->table, medal_name(verdict->medal));
    add_count(all, verdict->clocks, verdict->clocks > 0);
    add_count(all, verdict->right_count, known);
    add_count(all, verdict->of_count, known);
    add_count(all, verdict->points, known);
    table_text(all->table, hand_in->date);
    add_remarks(all, &verdict->remarks);
    add_first(all, verdict);
}

/* Returns the part of a path after the folder of the class. */
static const char *path_within(const char *folder, const char *path)
{
    size_t length = strlen(folder);
    return strlen(path) > length ? path + length + 1 : path;
}

static void add(struct handed_in *all, const char *student, const char *path,
                struct lesson_verdict *verdict)
{
    struct json *json = all->check->results.json;
    struct hand_in hand_in = { .student = student,
                               .path = path_within(all->check->args->folder, path),
                               .verdict = verdict };
    set_date(&hand_in, path);
    compare_code(all, verdict, hand_in.path);
    add_row(all, &hand_in);
    if (all->check->args->feedback)
        feedback_add(&all->feedback, &hand_in);
    if (json) {
        json_object(json, NULL);
        json_text(json, "student", student);
        json_text(json, "date", hand_in.date);
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
    add(all, student, path, &verdict);
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
        add(all, student, path, &verdict);
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
        if (check_join_path(&inner, path, folder.names[i]))
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
        { "student", "student", TABLE_TEXT, 0 },
        { "lesson", "lesson", TABLE_TEXT, 0 },
        { "passed", "passed", TABLE_TEXT, 0 },
        { "medal", "medal", TABLE_TEXT, 0 },
        { "clocks", "clocks", TABLE_COUNT, 0 },
        { "right", "right", TABLE_COUNT, 0 },
        { "tests", "tests", TABLE_COUNT, 0 },
        { "points", "points", TABLE_COUNT, 0 },
        { "date", "date", TABLE_TEXT, 0 },
        { "remarks", "remarks", TABLE_TEXT, 0 },
        { "report", "report", TABLE_TEXT, 0 },
    };
    return table_new(TABLE_COLUMNS(columns));
}

static int take_class(struct handed_in *all)
{
    const struct check_arguments *args = all->check->args;
    const struct command_output *results = &all->check->results;
    c205_error error;
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
    if (args->feedback && !feedback_write(&all->feedback, args->feedback, &error))
        return cmd_failed(args->shared.command, "%s", error.message);
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
               : args->feedback && !folder_is(args->feedback)
                   ? cmd_failed(args->shared.command, "%s is not a folder",
                                args->feedback)
                   : take_class(&all);
    table_free(all.table);
    feedback_free(&all.feedback);
    arena_free(&all.kept);
    *all_graded = all.refused == 0;
    return code;
}
