/* verdict.c - prints a verdict as text and as JSON. */
#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "base/word_wrap.h"
#include "base/plural.h"
#include "vm/error.h"

/* ---- Sentences ------------------------------------------------------------- */

static void report_text(struct lesson_report *report, const char *text)
{
    size_t length = strlen(text);
    const char *copy;
    while (length > 0 && text[length - 1] == '\n')
        length--;
    copy = arena_text(report->kept, text, length);
    if (copy)
        arena_add(report->kept, &report->sentences, &report->count, &report->capacity,
                  &copy, sizeof copy);
}

void report_buffer(struct lesson_report *report, struct text_buffer *buffer)
{
    if (buffer->failed)
        report->kept->failed = true;
    else
        report_text(report, buffer->text);
    text_buffer_free(buffer);
}

void report_printf(struct lesson_report *report, const char *format, ...)
{
    enum { SIZE = 1024 };
    char text[SIZE];
    PRINTF_TEXT(text, format);
    report_text(report, text);
}

void report_first(struct lesson_report *report)
{
    const char *last;
    if (report->count == 0)
        return;
    last = report->sentences[report->count - 1];
    memmove(report->sentences + 1, report->sentences,
            (report->count - 1) * sizeof *report->sentences);
    report->sentences[0] = last;
}

const char *lesson_source(const char *line)
{
    while (isspace((unsigned char)*line))
        line++;
    return line;
}

void lesson_verdict_free(struct lesson_verdict *verdict)
{
    arena_free(&verdict->kept);
}

/* ---- Text ---------------------------------------------------------------- */

/* Prints each sentence with an indentation. Lines of a program are not wrapped. */
void lesson_report_put(const struct lesson_report *report, const struct sink *sink)
{
    enum { COLUMN = 4 };
    for (size_t i = 0; i < report->count; i++) {
        const char *text = report->sentences[i];
        if (!strchr(text, '\n')) {
            sink_print(sink, "%*s", COLUMN, "");
            word_wrap_put(text, COLUMN, sink);
            continue;
        }
        while (*text) {
            size_t length = strcspn(text, "\n");
            sink_print(sink, "%*s%.*s\n", COLUMN, "", (int)length, text);
            text += length + (text[length] != '\0');
        }
    }
}

static void put_trial(const struct lesson_trial *trial, const struct sink *sink)
{
    const struct lesson_test *test = trial->test;
    sink_put(sink, test->name);
    if (trial->draw > 0)
        sink_print(sink, ", draw %" PRIu64, trial->draw);
    sink_print(sink, ": %s", trial->right ? "right" : "not right");
    if (trial->right && test->has_goals)
        sink_print(sink, ", %" PRIu64 " clock%s: %s", trial->clocks,
                   plural(trial->clocks),
                   trial->medal ? medal_name(trial->medal) : "too slow");
    sink_print(sink, " (%s)\n", test->tries);
    lesson_report_put(&trial->report, sink);
}

void lesson_verdict_put(const struct lesson_verdict *verdict, const struct sink *sink)
{
    bool medal = verdict->medal != MEDAL_NONE;
    if (verdict->graded)
        for (size_t i = 0; i < verdict->count; i++)
            put_trial(&verdict->trials[i], sink);
    lesson_report_put(&verdict->report, sink);
    sink_print(sink, "%s: %s%s%s", verdict->lesson->name,
               verdict->passed ? "passed" : "not passed", medal ? ", " : "",
               medal_name(verdict->medal));
    if (verdict->graded && !verdict->passed)
        sink_print(sink, ", %zu of %zu tests right", verdict->right_count,
                   verdict->of_count);
    sink_put(sink, "\n");
}

/* ---- JSON ------------------------------------------------------------------ */

static void write_report(const char *key, const struct lesson_report *report,
                         struct json *json)
{
    json_array(json, key);
    for (size_t i = 0; i < report->count; i++)
        json_text(json, NULL, report->sentences[i]);
    json_end(json);
}

static void write_goals(const struct lesson_test *test, struct json *json)
{
    json_object(json, "goals");
    for (int medal = MEDAL_GOLD; test->has_goals && medal > MEDAL_NONE; medal--)
        json_count(json, medal_name((enum medal)medal), test->goals[medal]);
    json_end(json);
}

static void write_trial(const struct lesson_trial *trial, struct json *json)
{
    json_object(json, NULL);
    json_text(json, "name", trial->test->name);
    json_text(json, "tries", trial->test->tries);
    json_count(json, "draw", trial->draw);
    json_bool(json, "passed", trial->passed);
    json_bool(json, "right", trial->right);
    json_count(json, "clocks", trial->clocks);
    json_text(json, "medal", medal_name(trial->medal));
    write_goals(trial->test, json);
    write_report("report", &trial->report, json);
    json_end(json);
}

static void write_lesson(const struct lesson *lesson, struct json *json)
{
    if (lesson) {
        json_text(json, "lesson", lesson->name);
        json_text(json, "title", lesson->title);
    } else {
        json_null(json, "lesson");
        json_null(json, "title");
    }
}

void lesson_verdict_json(const struct lesson_verdict *verdict, struct json *json)
{
    write_lesson(verdict->lesson, json);
    json_text(json, "answer", verdict->answer);
    json_bool(json, "passed", verdict->passed);
    json_text(json, "medal", medal_name(verdict->medal));
    json_count(json, "clocks", verdict->clocks);
    json_array(json, "tests");
    for (size_t i = 0; i < verdict->count; i++)
        write_trial(&verdict->trials[i], json);
    json_end(json);
    write_report("report", &verdict->report, json);
    json_count(json, "right_tests", verdict->right_count);
    json_count(json, "test_count", verdict->of_count);
    json_count(json, "points", verdict->points);
    write_report("remarks", &verdict->remarks, json);
}
