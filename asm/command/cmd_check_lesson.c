/* cmd_check_lesson.c - prints lessons for c205 check. */
#include <inttypes.h>
#include <string.h>

#include "asm/command/cmd_check.h"
#include "base/atomic_file.h"

int check_list(const struct check_command *check)
{
    static const struct table_column columns[] = {
        { "number", "", TABLE_COUNT, 0 },
        { "name", "lesson", TABLE_TEXT, 0 },
        { "title", "title", TABLE_TEXT, 0 },
    };
    struct table *table = table_new(TABLE_COLUMNS(columns));
    for (size_t i = 0; table && i < check->lessons.count; i++) {
        const struct lesson *lesson = &check->lessons.items[i];
        table_count(table, lesson->number);
        table_text(table, lesson->name);
        table_text(table, lesson->title);
    }
    return output_show(&check->results, table, "lessons", NULL);
}

/* ---- The data of a test ---------------------------------------------------- */

static void put_name(struct text_line *line, const char *name)
{
    struct sink sink = text_line_sink(line);
    sink_print(&sink, "%s%s", line->length > 0 ? ", " : "", name);
}

static void put_constant(struct text_line *line, const struct asm_symbol *symbol)
{
    struct sink sink = text_line_sink(line);
    put_name(line, symbol->name);
    sink_print(&sink, " = %" PRId64, symbol->value);
}

/* Writes the constants of a test, the labels of its inputs, and the labels of its
 * results. */
static void print_symbols(struct table *table, const struct object *test)
{
    struct text_line constants = { 0 }, data = { 0 }, results = { 0 };
    for (size_t i = 0; i < test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test->symbols[i];
        const char *wanted = lesson_wanted(symbol->name);
        if (lesson_is_constant(symbol))
            put_constant(&constants, symbol);
        else if (symbol->is_label)
            put_name(wanted ? &results : &data, wanted ? wanted : symbol->name);
    }
    table_text(table, constants.text);
    table_text(table, data.text);
    table_text(table, results.text);
}

static bool add_test(struct table *table, const struct lesson_test *test,
                     c205_error *error)
{
    struct object *object = lesson_assemble_test(test, error);
    if (!object)
        return false;
    table_text(table, test->name);
    for (int medal = MEDAL_GOLD; medal > MEDAL_NONE; medal--)
        if (test->has_goals)
            table_count(table, test->goals[medal]);
        else
            table_gap(table);
    print_symbols(table, object);
    table_text(table, test->tries);
    object_free(object);
    return true;
}

static int show_tests(const struct check_command *check)
{
    static const struct table_column columns[] = {
        { "name", "test", TABLE_TEXT, 0 },
        { "gold", "gold", TABLE_COUNT, 0 },
        { "silver", "silver", TABLE_COUNT, 0 },
        { "bronze", "bronze", TABLE_COUNT, 0 },
        { "constants", "constants", TABLE_TEXT, 0 },
        { "data", "data at", TABLE_TEXT, 0 },
        { "results", "results at", TABLE_TEXT, 0 },
        { "tries", "what it tests", TABLE_TEXT, 0 },
    };
    struct table *table = table_new(TABLE_COLUMNS(columns));
    c205_error error;
    for (size_t i = 0; table && i < check->lesson->test_count; i++) {
        if (!add_test(table, &check->lesson->tests[i], &error)) {
            table_free(table);
            return cmd_failed(check->args->shared.command, "%s", error.message);
        }
    }
    return output_show(&check->results, table, "tests", "Tests");
}

/* ---- A lesson -------------------------------------------------------------- */

/* The state of printing a lesson. Comments are omitted, and so are hints unless they
 * are requested. */
struct lesson_reading {
    FILE *file;
    bool hints, hidden, blank; /* blank: the previous line was blank */
};

static bool begins(const char *line, const char *text)
{
    return strncmp(line, text, strlen(text)) == 0;
}

/* Prints a line of the lesson, except comments and hints that are not requested.
 * "<details><summary>First hint</summary>" is printed as "First hint". */
static void put_line(struct lesson_reading *reading, const char *line, size_t length)
{
    static const char before[] = "<details><summary>", behind[] = "</summary>";
    if (begins(line, "## "))
        reading->hidden = begins(line, "## Hints") && !reading->hints;
    if (reading->hidden || begins(line, "<!--") || begins(line, "</details>")
        || (length == 0 && reading->blank))
        return;
    reading->blank = length == 0;
    if (begins(line, before)) {
        line += sizeof before - 1;
        length -= sizeof before + sizeof behind - 2;
    }
    fprintf(reading->file, "%.*s\n", (int)length, line);
}

static void put_text(const struct check_command *check)
{
    struct lesson_reading reading = { .file = check->results.file,
                                      .hints = check->args->hints };
    const char *line = check->lesson->text;
    while (*line) {
        size_t length = strcspn(line, "\n");
        put_line(&reading, line, length);
        line += length + (line[length] == '\n');
    }
}

int check_show(const struct check_command *check)
{
    const struct lesson *lesson = check->lesson;
    const struct command_output *results = &check->results;
    if (results->json) {
        json_text(results->json, "lesson", lesson->name);
        json_text(results->json, "title", lesson->title);
        json_text(results->json, "text", lesson->text);
        json_text(results->json, "start", lesson->start);
    }
    if (results->file && results->format == OUTPUT_TEXT)
        put_text(check);
    output_gap(results);
    return show_tests(check);
}

int check_fresh(const struct check_command *check)
{
    const struct command_output *results = &check->results;
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    c205_error error = { "out of memory" };
    bool good = lesson_fresh_put(check->lesson, check->args->seed, &sink, &error)
                && !text.failed;
    if (good && results->file)
        fputs(text.text, results->file);
    if (good && results->json)
        json_text(results->json, "text", text.text);
    text_buffer_free(&text);
    return good ? CMD_DONE
                : cmd_failed(check->args->shared.command, "%s", error.message);
}

int check_start(const struct check_command *check)
{
    const char *command = check->args->shared.command;
    const char *path = check->args->output;
    c205_error error;
    struct atomic_file *whole = atomic_file_open(path ? path : "-", &error);
    if (!whole)
        return cmd_failed(command, "%s", error.message);
    fputs(check->lesson->start, whole->file);
    return atomic_file_commit(whole, &error) ? CMD_DONE
                                             : cmd_failed(command, "%s", error.message);
}
