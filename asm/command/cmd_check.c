/* cmd_check.c - c205 check: prints lessons and grades answers. */
#include <stdlib.h>
#include <string.h>

#include "asm/command/cmd_check.h"
#include "base/folder.h"
#include "base/text_file.h"

/* ---- An answer ------------------------------------------------------------- */

/* Returns the draws of fresh tests. A folder has one by default. */
static struct lesson_draws draws_of(const struct check_arguments *args)
{
    size_t least = !args->no_fresh && (args->folder || args->seed > 0);
    return (struct lesson_draws){ args->fresh > least ? args->fresh : least,
                                  args->seed };
}

bool check_grade(const struct check_command *check, const struct lesson *lesson,
                 const char *path, struct lesson_verdict *verdict, c205_error *error)
{
    size_t length;
    char *text = text_file_read(path, FILE_LARGEST, &length, error);
    bool good = text
                && lesson_grade(verdict, lesson, draws_of(check->args), path, text,
                                length, error);
    free(text);
    return good;
}

static struct table *trial_table(const struct lesson_verdict *verdict)
{
    static const struct table_column columns[] = {
        { "test", "test", TABLE_TEXT, 0 },   { "passed", "passed", TABLE_TEXT, 0 },
        { "medal", "medal", TABLE_TEXT, 0 }, { "clocks", "clocks", TABLE_COUNT, 0 },
        { "draw", "draw", TABLE_COUNT, 0 },  { "report", "report", TABLE_TEXT, 0 },
    };
    struct table *table = table_new(TABLE_COLUMNS(columns));
    for (size_t i = 0; table && i < verdict->count; i++) {
        const struct lesson_trial *trial = &verdict->trials[i];
        struct text_buffer report = { 0 };
        check_join(&report, &verdict->report);
        check_join(&report, &trial->report);
        table_text(table, trial->test->name);
        table_text(table, trial->passed ? "yes" : "no");
        table_text(table, medal_name(trial->medal));
        table_count(table, trial->clocks);
        if (trial->draw > 0)
            table_count(table, trial->draw);
        else
            table_gap(table);
        table_text(table, report.text ? report.text : "");
        text_buffer_free(&report);
    }
    return table;
}

/* Joins the sentences. If source lines follow a sentence, only the first of them is
 * included. */
void check_join(struct text_buffer *buffer, const struct lesson_report *report)
{
    struct sink sink = text_buffer_sink(buffer);
    for (size_t i = 0; i < report->count; i++) {
        const char *text = report->sentences[i];
        size_t length = strcspn(text, "\n");
        sink_print(&sink, "%s%.*s", buffer->length > 0 ? " " : "", (int)length, text);
        if (text[length]) {
            text += length + 1;
            sink_print(&sink, " %.*s", (int)strcspn(text, "\n"), text);
        }
    }
}

static int show_verdict(const struct check_command *check,
                        const struct lesson_verdict *verdict)
{
    const struct command_output *results = &check->results;
    bool good = true;
    if (results->file && results->format == OUTPUT_TEXT) {
        struct sink sink = visible_stream(results->file);
        lesson_verdict_put(verdict, &sink);
    } else if (results->file) {
        struct table *table = trial_table(verdict);
        good = table && table_write(table, output_table_format(results), results->file);
        table_free(table);
    }
    if (results->json)
        lesson_verdict_json(verdict, results->json);
    return good ? CMD_DONE : cmd_failed(check->args->shared.command, "out of memory");
}

static int check_answer(const struct check_command *check, bool *passed)
{
    struct lesson_verdict verdict = { 0 };
    c205_error error;
    const char *path = check->args->answer;
    int code = check_grade(check, check->lesson, path, &verdict, &error)
                   ? show_verdict(check, &verdict)
                   : cmd_failed(check->args->shared.command, "%s: %s", path,
                                error.message);
    *passed = verdict.passed;
    lesson_verdict_free(&verdict);
    return code;
}

/* ---- The command ----------------------------------------------------------- */

/* Finds the lesson that the user names: a built-in lesson, or else the lesson in the
 * folder with this path. Also reads the tests of the option --tests. */
static bool find_lesson(struct check_command *check, c205_error *error)
{
    const char *name = check->args->lesson;
    check->lesson = name ? lessons_find(&check->lessons, name, error) : NULL;
    if (name && !check->lesson && folder_is(name)) {
        check->lesson = &check->own;
        if (!check_read_lesson(&check->own, name, error))
            return false;
    }
    return (!name || check->lesson)
           && (!check->args->tests || check_read_tests(check, error));
}

/* Writes the results even if the answer has not passed; *good is then false. */
static int work(const struct check_command *check, bool *good)
{
    const struct check_arguments *args = check->args;
    return args->folder     ? check_folder(check, good)
           : !check->lesson ? check_list(check)
           : args->answer   ? check_answer(check, good)
           : args->seed > 0 ? check_fresh(check)
                            : check_show(check);
}

static int check_usage(const struct check_arguments *args)
{
    const char *command = args->shared.command;
    return args->start && !args->lesson
               ? cmd_usage(command, "--start requires a LESSON")
           : args->start && (args->answer || args->folder)
               ? cmd_usage(command,
                           "--start cannot be combined with an ANSWER or --folder")
           : args->output && !args->start ? cmd_usage(command, "-o requires --start")
           : args->hints
                   && (!args->lesson || args->answer || args->folder || args->start)
               ? cmd_usage(
                   command,
                   "--hints requires a LESSON, without ANSWER, --folder or --start")
           : args->tests && !args->answer && !args->folder
               ? cmd_usage(command, "--tests requires an ANSWER or --folder")
           : args->feedback && !args->folder
               ? cmd_usage(command, "--feedback requires --folder")
           : args->fresh > 0 && !args->answer && !args->folder
               ? cmd_usage(command, "--fresh requires an ANSWER or --folder")
           : args->seed > 0 && !args->lesson && !args->folder
               ? cmd_usage(command, "--fresh-seed requires a LESSON or --folder")
           : args->no_fresh && (args->fresh > 0 || args->seed > 0)
               ? cmd_usage(command,
                           "--no-fresh cannot be combined with --fresh or --fresh-seed")
           : args->folder && args->answer
               ? cmd_usage(command, "an ANSWER cannot be combined with --folder")
               : CMD_DONE;
}

static int cmd_check(void *given)
{
    const struct check_arguments *args = given;
    struct check_command check = { .args = args, .results = args->shared.results };
    c205_error error;
    bool good = true;
    int code = check_usage(args);
    if (code != CMD_DONE)
        return code;
    if (!lessons_open(&check.lessons, &error) || !find_lesson(&check, &error))
        code = cmd_failed(args->shared.command, "%s", error.message);
    else if (args->start)
        code = check_start(&check);
    else if (!output_open(&check.results, args->shared.command, NULL))
        code = CMD_FAILED;
    else
        code = output_close(&check.results, work(&check, &good));
    lesson_free(&check.own);
    lessons_free(&check.lessons);
    return good ? code : CMD_FAILED;
}

#define PLACE(member) offsetof(struct check_arguments, member)

static const struct command_option options[] = {
    OPTION_FLAG("hints", PLACE(hints), "print the lesson with its hints"),
    OPTION_FLAG("start", PLACE(start), "write the lesson's program to complete"),
    OPTION_OUTPUT(PLACE(output), "write the program to FILE (-)"),
    { OPTION_ROW("folder", "DIR", COMMAND_FOLDER, PLACE(folder),
                 "grade all hand-ins: DIR/STUDENT/LESSON.s, DIR/LESSON.s, "
                 "or DIR/STUDENT.s of one lesson") },
    { OPTION_COUNT("fresh", PLACE(fresh), 1, 100, 0,
                   "also test with N draws of fresh inputs; 1 with --folder") },
    { OPTION_COUNT("fresh-seed", PLACE(seed), 1, 1000000000, 0,
                   "number of the first draw (each answer has its own); without an "
                   "ANSWER, print its fresh tests") },
    { OPTION_ROW("tests", "DIR", COMMAND_FOLDER, PLACE(tests),
                 "also run unpublished tests: DIR/test-NAME.s of one lesson, or "
                 "DIR/NN-LESSON/test-NAME.s") },
    { OPTION_ROW("feedback", "DIR", COMMAND_FOLDER, PLACE(feedback),
                 "write a file DIR/STUDENT.txt with the reports for each student") },
    OPTION_FLAG("no-fresh", PLACE(no_fresh),
                "grade hand-ins without fresh inputs, for lessons that have none"),
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("LESSON", COMMAND_TEXT, PLACE(lesson),
                  "the name, number or folder of a lesson; without it, all lessons are "
                  "listed"),
      .optional = true },
    { OPERAND_ROW("ANSWER", COMMAND_INPUT, PLACE(answer),
                  "a program text to grade; without it, the lesson is printed"),
      .optional = true },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 check LESSON --start -o FILE", "start an exercise" },
    { "c205 check LESSON ANSWER", "report what is wrong or slow" },
    { "c205 check --folder DIR --format csv", "grade a class, a row for each answer" },
    { NULL, NULL }
};

const struct command check_command = {
    COMMAND_ROW("check", cmd_check, struct check_arguments,
                "print lessons and grade answers to their exercises"),
    .examples = examples,
};
