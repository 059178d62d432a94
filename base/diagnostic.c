/* diagnostic.c - collects diagnostics and prints them with the source line. */
#include "base/diagnostic.h"

#include "base/array.h"
#include "base/utf8.h"
#include "base/visible_text.h"

#include <stdlib.h>
#include <string.h>

enum { TAB = 8, LONGEST_LINE = 1000 /* maximum bytes of a stored source line */ };

static char *copy(const char *text, size_t length)
{
    char *own = malloc(length + 1);
    if (own) {
        memcpy(own, text, length);
        own[length] = '\0';
    }
    return own;
}

static void free_item(struct diagnostic *item)
{
    free(item->file);
    free(item->message);
    free(item->source);
}

/* Returns the column of an invisible character in the word at the position, or 0. */
static size_t invisible_column(const struct position *position, unsigned long *code)
{
    size_t i = position->column - 1;
    for (; position->line && i < position->source_length; i++) {
        const char *at = position->source + i;
        if (*at && strchr(" \t,;\"'(){}[]<>=", *at))
            return 0;
        if (invisible_length(at, position->source_length - i, code))
            return i + 1;
    }
    return 0;
}

/* Adds the name of an invisible character to an error. A reader reports a word with
 * such a character only as a wrong word or number. */
static void name_invisible(struct diagnostic *item, const struct position *position)
{
    unsigned long code;
    size_t column = position->source ? invisible_column(position, &code) : 0;
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    if (!column || !item->message)
        return;
    sink_put(&sink, item->message);
    sink_put(&sink, " (at the caret: ");
    invisible_name(&sink, code);
    sink_put(&sink, ")");
    if (text.failed) {
        text_buffer_free(&text);
        return;
    }
    free(item->message);
    item->message = text.text;
    item->column = column;
}

void diagnostics_add(struct diagnostics *diagnostics, enum severity severity,
                     const struct position *position, const char *message)
{
    size_t length = position->source ? position->source_length : 0;
    struct diagnostic item = {
        .severity = severity,
        .file = copy(position->file, strlen(position->file)),
        .line = position->line,
        .column = position->column,
        .message = copy(message, strlen(message)),
        .source = copy(position->source ? position->source : "",
                       length < LONGEST_LINE ? length : LONGEST_LINE),
    };
    if (severity == SEVERITY_ERROR)
        name_invisible(&item, position);
    diagnostics->errors += severity == SEVERITY_ERROR;
    if (!item.file || !item.message || !item.source
        || !array_add(&diagnostics->items, &diagnostics->count, &item, sizeof item))
        free_item(&item);
}

void diagnostics_keep(struct diagnostics *diagnostics, size_t count)
{
    while (diagnostics->count > count) {
        struct diagnostic *last = &diagnostics->items[--diagnostics->count];
        diagnostics->errors -= last->severity == SEVERITY_ERROR;
        free_item(last);
    }
}

/* Returns the item to which output text is appended. NULL: out of memory. */
static struct diagnostic *next_diagnostic(struct diagnostics *diagnostics)
{
    const struct diagnostic empty = { .severity = SEVERITY_SAID };
    for (size_t i = 0; i < diagnostics->count; i++)
        if (diagnostics->items[i].severity == SEVERITY_SAID)
            return &diagnostics->items[i];
    return array_add(&diagnostics->items, &diagnostics->count, &empty, sizeof empty);
}

bool diagnostics_append(struct diagnostics *diagnostics, const char *text)
{
    struct diagnostic *item = next_diagnostic(diagnostics);
    size_t before = item && item->message ? strlen(item->message) : 0;
    size_t length = strlen(text);
    char *message;
    if (!item || length > MAX_SAID - before)
        return false;
    message = realloc(item->message, before + length + 1);
    if (!message)
        return false;
    memcpy(message + before, text, length + 1);
    item->message = message;
    return true;
}

/* Writes one character in printable form. A tab becomes blanks. Returns the new
 * column. */
static size_t put_character(const struct sink *sink, const char *text, size_t length,
                            size_t column)
{
    unsigned long code;
    if (*text == '\t') {
        size_t next = (column / TAB + 1) * TAB;
        sink_print(sink, "%*s", (int)(next - column), "");
        return next;
    }
    if (length == 0 || invisible_length(text, length, &code))
        sink_put(sink, "?");
    else
        sink->put(sink->context, text, length);
    return column + 1;
}

/* Writes the source line. If the line contains the column, a caret follows below it. */
static void put_source(const struct sink *sink, const struct diagnostic *diagnostic)
{
    const char *source = diagnostic->source;
    size_t column = 0, caret = 0, i = 0, all = strlen(source);
    sink_put(sink, "    ");
    while (i < all) {
        size_t length = utf8_length(source + i, all - i);
        if (i < diagnostic->column)
            caret = column;
        column = put_character(sink, source + i, length, column);
        i += length ? length : 1;
    }
    if (i + 1 == diagnostic->column)
        caret = column;
    sink_put(sink, "\n");
    if (diagnostic->column <= i + 1)
        sink_print(sink, "    %*s^\n", (int)caret, "");
}

void diagnostic_put(const struct diagnostic *diagnostic, const struct sink *sink)
{
    static const char *const words[] = {
        [SEVERITY_ERROR] = "error",
        [SEVERITY_WARNING] = "warning",
        [SEVERITY_REPORT] = "report",
    };
    if (diagnostic->severity == SEVERITY_SAID) {
        const char *said = diagnostic->message ? diagnostic->message : "";
        visible_put_lines(sink, said, strlen(said));
        return;
    }
    visible_put(sink, diagnostic->file, strlen(diagnostic->file));
    if (diagnostic->line)
        sink_print(sink, ":%zu:%zu", diagnostic->line, diagnostic->column);
    sink_print(sink, ": %s: ", words[diagnostic->severity]);
    visible_put(sink, diagnostic->message, strlen(diagnostic->message));
    sink_put(sink, "\n");
    if (diagnostic->line)
        put_source(sink, diagnostic);
}

void diagnostics_put(const struct diagnostics *diagnostics, const struct sink *sink)
{
    for (size_t i = 0; i < diagnostics->count; i++)
        diagnostic_put(&diagnostics->items[i], sink);
}

void diagnostics_print(const struct diagnostics *diagnostics, FILE *out)
{
    struct sink sink = stream_sink(out);
    diagnostics_put(diagnostics, &sink);
}

void diagnostics_free(struct diagnostics *diagnostics)
{
    for (size_t i = 0; i < diagnostics->count; i++)
        free_item(&diagnostics->items[i]);
    free(diagnostics->items);
    memset(diagnostics, 0, sizeof *diagnostics);
}
