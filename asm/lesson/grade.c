/* grade.c - runs an answer on the tests of its lesson and builds the verdict. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/check/expect.h"
#include "asm/lesson/lesson_internal.h"
#include "asm/object/object_file.h"
#include "asm/text/assemble.h"
#include "asm/view/print.h"
#include "asm/view/trap_report.h"
#include "vm/error.h"
#include "base/named_model.h"

/* Limits that end an endless loop. A run stops after 20,000,000 clocks plus ten times
 * the clocks of the goal bronze, or after printing more than MAX_PRINTED characters. */
static const uint64_t patience_least = 20000000;
enum { TIME_LIMIT_FACTOR = 10, MAX_PRINTED = 1 << 16 };

/* The state of grading one answer by one test. */
struct sitting {
    const char *name, *text;
    size_t length;
    struct lesson_trial *trial;
    struct lesson_report *general; /* reports that are the same for all tests */
    struct arena *kept;
    c205_error *error; /* error of the lesson */

    struct object *test, *answer;
    c205_model *model;
    c205 *data, *machine; /* data: the test; machine: the answer */
    struct line_profile *profile;
    struct lesson_test_data test_data;
    struct printer printer;
    struct text_buffer printed;
};

static bool no_memory(c205_error *error)
{
    return error_set(error, "out of memory");
}

/* ---- The answer ------------------------------------------------------------ */

/* Reports a sentence and all diagnostics of a severity. */
static void print_diagnostics(struct lesson_report *report, const char *sentence,
                              const struct diagnostics *said, enum severity severity)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    sink_put(&sink, sentence);
    sink_put(&sink, "\n");
    for (size_t i = 0; i < said->count; i++)
        if (said->items[i].severity == severity)
            diagnostic_put(&said->items[i], &sink);
    report_buffer(report, &text);
}

/* Returns the integer constants of the test, which are definitions for the answer.
 * Returns NULL if memory is exhausted. */
static struct asm_define *make_defines(struct sitting *sitting)
{
    const struct object *test = sitting->test;
    struct asm_define *defines = arena_take(sitting->kept,
                                            (test->symbol_count + 1) * sizeof *defines);
    size_t count = 0;
    for (size_t i = 0; defines && i < test->symbol_count; i++)
        if (lesson_is_constant(&test->symbols[i]))
            defines[count++] = (struct asm_define){ test->symbols[i].name,
                                                    test->symbols[i].value };
    return defines;
}

static void print_redefined(struct lesson_report *report, const char *name,
                            const struct diagnostic *diagnostic)
{
    if (diagnostic->source && strstr(diagnostic->source, ".equ"))
        report_printf(report,
                      "Line %zu sets %s, which the tests set: put '.ifndef %s' "
                      "before it and '.endif' after it.",
                      diagnostic->line, name, name);
    else
        report_printf(
            report,
            "Line %zu uses the name %s of a constant that the tests set: choose "
            "another name.",
            diagnostic->line, name);
}

/* Reports each constant that both the answer and the test define. Returns true if there
 * is one, because this is then the reason why the assembly failed. */
static bool find_redefined(struct sitting *sitting, const struct diagnostics *said,
                           const struct asm_define *defines)
{
    struct lesson_report *report = sitting->general;
    size_t reported = report->count;
    for (; defines->name; defines++)
        for (size_t i = 0; i < said->count; i++)
            if (asm_is_redefined(&said->items[i], defines->name))
                print_redefined(report, defines->name, &said->items[i]);
    return report->count > reported;
}

/* Reports errors after a heading such as "With n = 5 the answer cannot be
 * assembled:". */
static void print_errors(struct sitting *sitting, const struct diagnostics *said,
                         const struct asm_define *defines)
{
    struct text_line line = { 0 };
    struct sink sink = text_line_sink(&line);
    for (size_t i = 0; defines[i].name; i++)
        sink_print(&sink, "%s%s = %" PRId64, i > 0 ? ", " : "With ", defines[i].name,
                   defines[i].value);
    sink_put(&sink, " the answer cannot be assembled:");
    print_diagnostics(&sitting->trial->report, line.text, said, SEVERITY_ERROR);
}

/* Assembles the answer with the constants of the test. */
static bool assemble_answer(struct sitting *sitting)
{
    struct asm_define *defines = make_defines(sitting);
    struct asm_options options = { .defines = defines, .sealed = true };
    struct diagnostics said = { 0 };
    if (!defines)
        return no_memory(sitting->error);
    sitting->answer = assemble_bytes(sitting->name, sitting->text, sitting->length,
                                     &options, &said);
    if (!sitting->answer && !find_redefined(sitting, &said, defines))
        print_errors(sitting, &said, defines);
    diagnostics_free(&said);
    return true;
}

/* ---- The machines ---------------------------------------------------------- */

static bool load_test(struct sitting *sitting)
{
    const char *model = expect_model(sitting->test);
    sitting->model = model_find(model ? model : C205_DEFAULT_MODEL, sitting->error);
    if (!sitting->model)
        return false;
    sitting->data = c205_new(sitting->model, sitting->error);
    return sitting->data
           && c205_load(sitting->data, &sitting->test->program, sitting->error);
}

static void listen(void *context, const c205 *machine, const c205_event *event)
{
    struct sitting *sitting = context;
    printer_listen(&sitting->printer, machine, event);
    if (sitting->printed.length > MAX_PRINTED)
        c205_pause(sitting->machine);
}

/* Loads the answer. The test, not the answer, determines whether pages are warm. */
static bool load_answer(struct sitting *sitting)
{
    c205_program program = sitting->answer->program;
    program.warm = sitting->test->program.warm;
    sitting->machine = c205_new(sitting->model, sitting->error);
    sitting->profile = line_profile_new(sitting->answer);
    if (!sitting->profile)
        return no_memory(sitting->error);
    return sitting->machine && c205_load(sitting->machine, &program, sitting->error)
           && ((c205_listen(sitting->machine, line_profile_listen, sitting->profile)
                && c205_listen(sitting->machine, listen, sitting))
               || no_memory(sitting->error));
}

/* ---- The run --------------------------------------------------------------- */

static void print_endless(struct sitting *sitting, const c205_stop *stop)
{
    const struct asm_line *line = object_line(sitting->answer, stop->pc);
    struct text_line where = { 0 };
    struct sink sink = text_line_sink(&where);
    if (line)
        sink_print(&sink, "  It was at line %zu: %s", line->shown.number,
                   lesson_source(line->shown.source));
    report_printf(&sitting->trial->report,
                  "It had not ended after %" PRIu64
                  " clocks: look for an endless loop.%s",
                  c205_clock(sitting->machine), where.text);
}

static void print_trap(struct sitting *sitting, const c205_stop *stop)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    sink_put(&sink, "It was stopped by a trap:\n");
    trap_report(sitting->answer, sitting->name, sitting->machine, stop, &sink);
    report_buffer(&sitting->trial->report, &text);
}

/* Returns true if the run ended with EXIT. Otherwise reports why it stopped. */
static bool check_stop(struct sitting *sitting, const c205_stop *stop)
{
    if (stop->trap == C205_TRAP_CLOCK_LIMIT)
        print_endless(sitting, stop);
    else if (stop->trap == C205_TRAP_PAUSED)
        report_printf(&sitting->trial->report,
                      "It printed more than %d characters, and was stopped.",
                      MAX_PRINTED);
    else if (stop->trap != C205_TRAP_NONE && !expect_find(sitting->test, EXPECT_TRAP))
        print_trap(sitting, stop);
    else if (stop->status != 0)
        report_printf(&sitting->trial->report,
                      "It ended with the status %" PRId64 ", not with 0.",
                      stop->status);
    else
        return true;
    return false;
}

/* Reports each line "test-small.s:7: expected ..." as a sentence, without the position
 * in the test. */
static void print_expectations(struct lesson_report *report, const char *text)
{
    static const char before[] = "expected ";
    while (*text) {
        size_t length = strcspn(text, "\n");
        const char *what = strstr(text, before);
        size_t skipped = what && what < text + length
                             ? (size_t)(what - text) + sizeof before - 1
                             : 0;
        report_printf(report, "Expected %.*s.", (int)(length - skipped),
                      text + skipped);
        text += length + (text[length] != '\0');
    }
}

static bool check_expected(struct sitting *sitting, const c205_stop *stop)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    const char *printed = sitting->printed.text;
    bool good = expect_check(sitting->test, sitting->machine, stop,
                             printed ? printed : "", 0, &sink);
    if (text.text)
        print_expectations(&sitting->trial->report, text.text);
    text_buffer_free(&text);
    return good;
}

static enum medal medal_for(const struct lesson_test *test, uint64_t clocks)
{
    enum medal medal = MEDAL_NONE;
    while (medal < MEDAL_GOLD && clocks <= test->goals[medal + 1])
        medal++;
    return medal;
}

static void judge(struct sitting *sitting, const c205_stop *stop)
{
    struct lesson_trial *trial = sitting->trial;
    trial->clocks = c205_clock(sitting->machine);
    if (!check_stop(sitting, stop))
        return;
    trial->right = test_data_end(&sitting->test_data);
    trial->right = check_expected(sitting, stop) && trial->right;
    trial->passed = trial->right;
    if (!trial->right || !trial->test->has_goals)
        return;
    trial->medal = medal_for(trial->test, trial->clocks);
    trial->passed = trial->medal != MEDAL_NONE;
    if (trial->medal != MEDAL_GOLD)
        performance_hint_report(trial, sitting->machine, sitting->profile,
                                &trial->report);
}

static bool run_test(struct sitting *sitting)
{
    struct lesson_trial *trial = sitting->trial;
    uint64_t limit = patience_least
                     + TIME_LIMIT_FACTOR * trial->test->goals[MEDAL_BRONZE];
    c205_stop stop = c205_run(sitting->machine, limit);
    if (stop.trap == C205_TRAP_NO_MEMORY || sitting->printed.failed)
        return no_memory(sitting->error);
    judge(sitting, &stop);
    return true;
}

/* ---- All tests ------------------------------------------------------------- */

static bool sit(struct sitting *sitting)
{
    struct lesson_test_data *test_data = &sitting->test_data;
    c205_error why;
    sitting->printer.sink = text_buffer_sink(&sitting->printed);
    if (!(sitting->test = lesson_assemble_test(sitting->trial->test, sitting->error))
        || !load_test(sitting) || !assemble_answer(sitting))
        return false;
    if (!sitting->answer)
        return true;
    if (!object_check(sitting->answer, &why)) {
        report_printf(&sitting->trial->report, "It cannot run: %s.", why.message);
        return true;
    }
    if (!load_answer(sitting))
        return false;
    *test_data = (struct lesson_test_data){ .test = sitting->test,
                                            .answer = sitting->answer,
                                            .data = sitting->data,
                                            .machine = sitting->machine,
                                            .notes = sitting->trial->test,
                                            .report = &sitting->trial->report,
                                            .general = sitting->general,
                                            .kept = sitting->kept };
    return !test_data_begin(test_data) || run_test(sitting);
}

static void leave(struct sitting *sitting)
{
    text_buffer_free(&sitting->printed);
    line_profile_free(sitting->profile);
    c205_free(sitting->machine);
    c205_free(sitting->data);
    c205_model_free(sitting->model);
    object_free(sitting->answer);
    object_free(sitting->test);
}

static void conclude(struct lesson_verdict *verdict)
{
    bool medals = false;
    verdict->passed = true;
    verdict->medal = MEDAL_GOLD;
    for (size_t i = 0; i < verdict->count; i++) {
        const struct lesson_trial *trial = &verdict->trials[i];
        verdict->passed = verdict->passed && trial->passed;
        if (!trial->test->has_goals)
            continue;
        medals = true;
        if (trial->medal < verdict->medal)
            verdict->medal = trial->medal;
        if (trial->right && trial->clocks > verdict->clocks)
            verdict->clocks = trial->clocks;
    }
    if (!medals || !verdict->passed)
        verdict->medal = MEDAL_NONE;
}

static bool grade_begin(struct lesson_verdict *verdict, const struct lesson *lesson,
                        const char *name, c205_error *error)
{
    verdict->lesson = lesson;
    verdict->answer = name;
    verdict->count = lesson->test_count;
    verdict->report.kept = &verdict->kept;
    verdict->trials = arena_take(&verdict->kept,
                                 lesson->test_count * sizeof *verdict->trials);
    if (!verdict->trials)
        return no_memory(error);
    for (size_t i = 0; i < verdict->count; i++) {
        verdict->trials[i].test = &lesson->tests[i];
        verdict->trials[i].report.kept = &verdict->kept;
    }
    return true;
}

void lesson_refuse(struct lesson_verdict *verdict, const struct lesson *lesson,
                   const char *name, const char *reason)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    verdict->lesson = lesson;
    verdict->answer = name;
    verdict->report.kept = &verdict->kept;
    sink_put(&sink, name);
    sink_put(&sink, ": not graded: ");
    sink_put(&sink, reason);
    report_buffer(&verdict->report, &text);
}

/* Runs the tests in order. Stops after a test with a report that would be the same for
 * all tests. */
static bool try_tests(struct lesson_verdict *verdict, const char *text, size_t length,
                      c205_error *error)
{
    for (size_t i = 0; i < verdict->count && verdict->report.count == 0; i++) {
        struct sitting sitting = { .name = verdict->answer,
                                   .text = text,
                                   .length = length,
                                   .trial = &verdict->trials[i],
                                   .general = &verdict->report,
                                   .kept = &verdict->kept,
                                   .error = error };
        bool good = sit(&sitting);
        leave(&sitting);
        if (!good)
            return false;
    }
    verdict->graded = verdict->report.count == 0;
    if (verdict->graded)
        conclude(verdict);
    return true;
}

/* Grades an answer. The warnings of the assembler are reported if the answer has not
 * passed, because they may explain the failure. */
bool lesson_grade(struct lesson_verdict *verdict, const struct lesson *lesson,
                  const char *name, const char *text, size_t length, c205_error *error)
{
    static const struct asm_options options = { .sealed = true };
    struct diagnostics said = { 0 };
    struct object *object;
    bool good = true;
    if (!grade_begin(verdict, lesson, name, error))
        return false;
    object = assemble_bytes(name, text, length, &options, &said);
    if (!object)
        print_diagnostics(&verdict->report, "The answer cannot be assembled:", &said,
                          SEVERITY_ERROR);
    else
        good = try_tests(verdict, text, length, error);
    if (object && !verdict->passed && said.count > 0)
        print_diagnostics(&verdict->report, "The assembler warns:", &said,
                          SEVERITY_WARNING);
    diagnostics_free(&said);
    object_free(object);
    return good && (!verdict->kept.failed || no_memory(error));
}
