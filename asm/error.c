#include "asm/assembler.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *copy(const char *text, size_t length)
{
    char *result = malloc(length + 1);

    if (result) {
        memcpy(result, text, length);
        result[length] = '\0';
    }
    return result;
}

static void free_item(struct asm_error *item)
{
    free(item->file);
    free(item->message);
    free(item->source);
}

/* Without memory for it, an error stays untold; that no object is made is
 * sign enough. */
static void add(struct asm_errors *errors, struct asm_error item)
{
    struct asm_error *items = NULL;

    if (item.file && item.message && item.source)
        items = realloc(errors->items, (errors->count + 1) * sizeof *items);
    if (!items) {
        free_item(&item);
        return;
    }
    errors->items = items;
    errors->items[errors->count++] = item;
}

bool report_file(struct asm_errors *errors, const char *file,
                 const char *message)
{
    struct asm_error item = { NULL, 0, 0, NULL, NULL };

    item.file = copy(file, strlen(file));
    item.message = copy(message, strlen(message));
    item.source = copy("", 0);
    add(errors, item);
    return false;
}

static void say_caller(char *message, size_t size, const struct line *line)
{
    size_t used = strlen(message);

    if (line->caller)
        snprintf(message + used, size - used, " (expanded from %s:%zu)",
                 line->caller->file, line->caller->number);
}

/* What is wrong with a line as a whole is told at its first word. */
static size_t column_of(const struct line *line, const char *at)
{
    if (at == line->begin)
        while (at < line->text_end && (*at == ' ' || *at == '\t'))
            at++;
    return (size_t)(at - line->text) + 1;
}

bool report(struct assembler *assembler, const struct line *line,
            const char *at, const char *format, ...)
{
    char message[512];
    struct asm_error item = { NULL, 0, 0, NULL, NULL };
    va_list arguments;

    if (too_many_errors(assembler))
        return false;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    say_caller(message, sizeof message, line);
    item.file = copy(line->file, strlen(line->file));
    item.line = line->number;
    item.column = column_of(line, at);
    item.message = copy(message, strlen(message));
    item.source = copy(line->text, (size_t)(line->text_end - line->text));
    add(assembler->errors, item);
    return false;
}

bool too_many_errors(const struct assembler *assembler)
{
    return assembler->errors->count - assembler->first_error >= MAX_ERRORS;
}

/* Tabs stay tabs under tabs, so that the caret stands where it should. */
static void print_caret(const struct asm_error *error,
                        const struct sink *sink)
{
    size_t i, length = strlen(error->source);

    sink_put(sink, "    ");
    for (i = 0; i + 1 < error->column && i < length; i++)
        sink_put(sink, error->source[i] == '\t' ? "\t" : " ");
    sink_put(sink, "^\n");
}

void asm_error_print(const struct asm_error *error, const struct sink *sink)
{
    sink_put(sink, error->file);
    if (error->line)
        sink_print(sink, ":%zu:%zu", error->line, error->column);
    sink_put(sink, ": error: ");
    sink_put(sink, error->message);
    sink_put(sink, "\n");
    if (error->line) {
        sink_put(sink, "    ");
        sink_put(sink, error->source);
        sink_put(sink, "\n");
        print_caret(error, sink);
    }
}

void asm_errors_print(const struct asm_errors *errors,
                      const struct sink *sink)
{
    size_t i;

    for (i = 0; i < errors->count; i++)
        asm_error_print(&errors->items[i], sink);
}

void asm_errors_free(struct asm_errors *errors)
{
    size_t i;

    for (i = 0; i < errors->count; i++)
        free_item(&errors->items[i]);
    free(errors->items);
    errors->items = NULL;
    errors->count = 0;
}
