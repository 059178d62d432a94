/* answer_run.c - assembles an answer with the constants of a test, runs it on the data
 * of the test, and compares the results. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/check/expect.h"
#include "asm/lesson/lesson_internal.h"
#include "asm/object/object_file.h"
#include "asm/text/assemble.h"
#include "asm/view/trap_report.h"
#include "vm/error.h"

/* Limits that end an endless loop. A run stops after 20,000,000 clocks plus ten times
 * the clocks of the goal bronze, or after printing more than MAX_PRINTED characters. */
static const uint64_t patience_least = 20000000;
enum { TIME_LIMIT_FACTOR = 10, MAX_PRINTED = 1 << 16 };

static bool no_memory(c205_error *error)
{
    return error_set(error, "out of memory");
}

/* ---- The answer ------------------------------------------------------------ */

void report_diagnostics(struct lesson_report *report, const char *sentence,
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
static bool find_redefined(struct answer_run *run, const struct diagnostics *said,
                           const struct asm_define *defines)
{
    struct lesson_report *report = run->general;
    size_t reported = report->count;
    for (; defines->name; defines++)
        for (size_t i = 0; i < said->count; i++)
            if (asm_is_redefined(&said->items[i], defines->name))
                print_redefined(report, defines->name, &said->items[i]);
    return report->count > reported;
}

/* Reports errors after a heading such as "With n = 5 the answer cannot be
 * assembled:". */
static void print_errors(struct answer_run *run, const struct diagnostics *said,
                         const struct asm_define *defines)
{
    struct text_line line = { 0 };
    struct sink sink = text_line_sink(&line);
    for (size_t i = 0; defines[i].name; i++)
        sink_print(&sink, "%s%s = %" PRId64, i > 0 ? ", " : "With ", defines[i].name,
                   defines[i].value);
    sink_put(&sink, " the answer cannot be assembled:");
    report_diagnostics(run->report, line.text, said, SEVERITY_ERROR);
}

static void assemble(struct answer_run *run)
{
    const struct asm_define *defines = run->test->defines;
    struct asm_options options = { .defines = defines, .sealed = true };
    c205_error why;
    run->object = assemble_bytes(run->name, run->text, run->length, &options,
                                 &run->said);
    if (!run->object && !find_redefined(run, &run->said, defines))
        print_errors(run, &run->said, defines);
    if (run->object && !object_check(run->object, &why)) {
        report_printf(run->report, "It cannot run: %s.", why.message);
        object_free(run->object);
        run->object = NULL;
    }
}

/* ---- The run --------------------------------------------------------------- */

static void listen(void *context, const c205 *machine, const c205_event *event)
{
    struct answer_run *run = context;
    printer_listen(&run->printer, machine, event);
    if (run->printed.length > MAX_PRINTED)
        c205_pause(run->machine);
}

/* Starts the runtime checks if the warnings are wanted. */
static bool start_checks(struct answer_run *run)
{
    static const struct warning_choice all;
    if (!run->checked)
        return true;
    run->checks = runtime_new(run->object, run->name, &all, NULL);
    if (!run->checks || !c205_listen(run->machine, runtime_listen, run->checks))
        return no_memory(run->error);
    runtime_begin(run->checks, run->machine);
    return true;
}

/* Loads the answer. The test, not the answer, determines whether pages are warm. */
static bool load(struct answer_run *run)
{
    c205_program program = run->object->program;
    program.warm = run->test->notes->warm;
    run->printer.sink = text_buffer_sink(&run->printed);
    run->machine = c205_new(run->test->model, run->error);
    run->profile = line_profile_new(run->object);
    if (!run->profile)
        return no_memory(run->error);
    return run->machine && c205_load(run->machine, &program, run->error)
           && ((c205_listen(run->machine, line_profile_listen, run->profile)
                && c205_listen(run->machine, listen, run))
               || no_memory(run->error));
}

static void print_endless(struct answer_run *run, const c205_stop *stop)
{
    const struct asm_line *line = object_line(run->object, stop->pc);
    struct text_line where = { 0 };
    struct sink sink = text_line_sink(&where);
    if (line)
        sink_print(&sink, "  It was at line %zu: %s", line->shown.number,
                   lesson_source(line->shown.source));
    report_printf(run->report,
                  "It had not ended after %" PRIu64
                  " clocks: look for an endless loop.%s",
                  c205_clock(run->machine), where.text);
}

static void print_trap(struct answer_run *run, const c205_stop *stop)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    sink_put(&sink, "It was stopped by a trap:\n");
    trap_report(run->object, run->name, run->machine, stop, &sink);
    report_buffer(run->report, &text);
}

/* Returns true if the run ended with EXIT. Otherwise reports why it stopped. */
static bool check_stop(struct answer_run *run, const c205_stop *stop)
{
    if (stop->trap == C205_TRAP_CLOCK_LIMIT)
        print_endless(run, stop);
    else if (stop->trap == C205_TRAP_PAUSED)
        report_printf(run->report,
                      "It printed more than %d characters, and was stopped.",
                      MAX_PRINTED);
    else if (stop->trap != C205_TRAP_NONE
             && !expect_find(run->test->object, EXPECT_TRAP))
        print_trap(run, stop);
    else if (stop->status != 0)
        report_printf(run->report, "It ended with the status %" PRId64 ", not with 0.",
                      stop->status);
    else
        return true;
    return false;
}

/* Runs the answer, and reports an end other than that which the test expects. */
static bool execute(struct answer_run *run)
{
    uint64_t limit = run->limit ? run->limit
                                : patience_least
                                      + TIME_LIMIT_FACTOR
                                            * run->test->notes->goals[MEDAL_BRONZE];
    run->stop = c205_run(run->machine, limit);
    run->clocks = c205_clock(run->machine);
    if (run->stop.trap == C205_TRAP_NO_MEMORY || run->printed.failed)
        return no_memory(run->error);
    run->ended = check_stop(run, &run->stop);
    return true;
}

bool answer_run(struct answer_run *run)
{
    assemble(run);
    if (!run->object)
        return true;
    if (!load(run))
        return false;
    run->data = (struct lesson_test_data){ .test = run->test->object,
                                           .answer = run->object,
                                           .data = run->test->data,
                                           .machine = run->machine,
                                           .notes = run->test->notes,
                                           .report = run->report,
                                           .general = run->general,
                                           .kept = run->kept };
    if (!test_data_begin(&run->data))
        return true;
    if (run->spoilt)
        test_data_spoil(&run->data, run->spoilt);
    return start_checks(run) && execute(run);
}

void answer_run_free(struct answer_run *run)
{
    text_buffer_free(&run->printed);
    diagnostics_free(&run->said);
    runtime_free(run->checks);
    line_profile_free(run->profile);
    c205_free(run->machine);
    object_free(run->object);
}

/* ---- The results ----------------------------------------------------------- */

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

static bool check_expected(struct answer_run *run)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    const char *printed = run->printed.text;
    bool good = expect_check(run->test->object, run->machine, &run->stop,
                             printed ? printed : "", 0, &sink);
    if (text.text)
        print_expectations(run->report, text.text);
    text_buffer_free(&text);
    return good;
}

bool answer_is_right(struct answer_run *run)
{
    bool right = run->ended && test_data_end(&run->data);
    return run->ended && check_expected(run) && right;
}

/* ---- The warnings ---------------------------------------------------------- */

/* Returns true if a trial of the verdict, other than the last report, begins with the
 * same sentence as the report. */
static bool is_reported(const struct lesson_verdict *verdict,
                        const struct lesson_report *report)
{
    for (size_t i = 0; i < verdict->count; i++) {
        const struct lesson_report *other = &verdict->trials[i].report;
        if (other != report && other->count > 0 && report->count > 0
            && strcmp(other->sentences[0], report->sentences[0]) == 0)
            return true;
    }
    return false;
}

static void put_warnings(const struct diagnostics *diagnostics, const struct sink *sink)
{
    for (size_t i = 0; i < diagnostics->count; i++)
        if (diagnostics->items[i].severity == SEVERITY_WARNING)
            diagnostic_put(&diagnostics->items[i], sink);
}

void answer_report_warnings(const struct answer_run *run,
                            const struct lesson_verdict *verdict)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    struct lesson_report *report = run->report;
    size_t heading, count = report->count;
    sink_put(&sink, "Look at these warnings first:\n");
    heading = text.length;
    put_warnings(&run->said, &sink);
    if (run->checks)
        put_warnings(runtime_found(run->checks), &sink);
    if (text.length == heading) {
        text_buffer_free(&text);
        return;
    }
    report_buffer(report, &text);
    if (report->count == count)
        return;
    report_first(report);
    if (is_reported(verdict, report)) {
        report->count--;
        memmove(report->sentences, report->sentences + 1,
                report->count * sizeof *report->sentences);
    }
}
