/* command_output.c - prints results in the chosen format and to a JSON file. */
#include "base/command_output.h"
#include "vm/error.h"

#include <stdio.h>
#include <string.h>

#include "base/provenance.h"
#include "base/sink.h"
#include "base/visible_text.h"

const char *output_format_choice(size_t number)
{
    static const char *const names[] = { [OUTPUT_TEXT] = "text",
                                         [OUTPUT_CSV] = "csv",
                                         [OUTPUT_MARKDOWN] = "md",
                                         [OUTPUT_JSON] = "json" };
    return number <= OUTPUT_JSON ? names[number] : NULL;
}

static bool is_stream(const char *path)
{
    return path && strcmp(path, "-") == 0;
}

/* Treats "--json -" as "--format json". */
static void choose_format(struct command_output *results)
{
    if (is_stream(results->path)) {
        results->format = OUTPUT_JSON;
        results->path = NULL;
    }
}

static bool open_json(struct command_output *results)
{
    c205_error error;
    results->json = NULL;
    if (results->format == OUTPUT_JSON)
        results->json = json_open_stream(stdout, results->path, &error);
    else if (results->path)
        results->json = json_open(results->path, &error);
    else
        return true;
    if (!results->json)
        cmd_failed(results->command, "%s", error.message);
    return results->json != NULL;
}

bool output_open(struct command_output *results, const char *command,
                 const char *output)
{
    results->command = command;
    choose_format(results);
    results->file = results->format == OUTPUT_JSON ? NULL
                    : is_stream(output)            ? stderr
                                                   : stdout;
    if (results->format == OUTPUT_JSON && is_stream(output)) {
        cmd_failed(
            command,
            "stdout cannot hold both the output and JSON; write one of them to a file");
        return false;
    }
    return open_json(results);
}

int output_close(struct command_output *results, int code)
{
    c205_error error;
    if (results->json && code != CMD_DONE)
        json_discard(results->json);
    else if (results->json && !json_close(results->json, &error))
        code = cmd_failed(results->command, "%s", error.message);
    results->json = NULL;
    return code;
}

enum table_format output_table_format(const struct command_output *results)
{
    return results->format == OUTPUT_JSON ? TABLE_PLAIN
                                          : (enum table_format)results->format;
}

static void put_line(const struct command_output *results, const char *line,
                     size_t length)
{
    const char *remark = table_remark(output_table_format(results));
    size_t mark = length > 0 ? strlen(remark) : strcspn(remark, " ");
    struct sink sink = stream_sink(results->file);
    fprintf(results->file, "%.*s", (int)mark, remark);
    visible_put(&sink, line, length);
    putc('\n', results->file);
}

void output_printf(const struct command_output *results, const char *format, ...)
{
    char text[1024];
    if (!results->file)
        return;
    PRINTF_TEXT(text, format);
    for (const char *line = text; *line;) {
        size_t length = strcspn(line, "\n");
        put_line(results, line, length);
        line += length + (line[length] == '\n');
    }
}

void output_gap(const struct command_output *results)
{
    if (results->format == OUTPUT_TEXT)
        putc('\n', results->file);
}

void output_model(const struct command_output *results, const c205_model *model)
{
    if (results->file) {
        provenance_print(model, results->provenance,
                         table_remark(output_table_format(results)), results->file);
    }
}

static bool add_table(const struct command_output *results, const struct table *table,
                      const char *key, const char *heading)
{
    enum table_format format = output_table_format(results);
    if (!table)
        return false;
    if (results->file && heading)
        table_heading(heading, format, results->file);
    if (results->file && !table_write(table, format, results->file))
        return false;
    return !results->json || table_json(table, results->json, key);
}

bool output_part(const struct command_output *results, struct table *table,
                 const char *key, const char *heading)
{
    bool good = add_table(results, table, key, heading);
    table_free(table);
    return good;
}

bool output_table(const struct command_output *results, const struct table *table,
                  const char *key, const char *heading)
{
    bool headed = results->format != OUTPUT_TEXT;
    return add_table(results, table, key, headed ? heading : NULL);
}

int output_show(const struct command_output *results, struct table *table,
                const char *key, const char *heading)
{
    bool good = output_table(results, table, key, heading);
    table_free(table);
    return good ? CMD_DONE : cmd_failed(results->command, "out of memory");
}
