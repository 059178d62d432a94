#include "base/diagnostic.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

enum { TAB = 8, LONGEST_LINE = 1000 /* bytes of a source line kept */ };

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

static struct diagnostic *keep(struct diagnostics *diagnostics,
                               const struct diagnostic *item)
{
    struct diagnostic *items = array_grow(diagnostics->items,
                                          diagnostics->count, sizeof *items);

    if (!items)
        return NULL;
    diagnostics->items = items;
    items[diagnostics->count] = *item;
    return &items[diagnostics->count++];
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

    diagnostics->errors += severity == SEVERITY_ERROR;
    if (!item.file || !item.message || !item.source
        || !keep(diagnostics, &item))
        free_item(&item);
}

/* The one that holds what is said; NULL: no memory. */
static struct diagnostic *saying(struct diagnostics *diagnostics)
{
    const struct diagnostic empty = { .severity = SEVERITY_SAID };

    for (size_t i = 0; i < diagnostics->count; i++)
        if (diagnostics->items[i].severity == SEVERITY_SAID)
            return &diagnostics->items[i];
    return keep(diagnostics, &empty);
}

bool diagnostics_say(struct diagnostics *diagnostics, const char *text)
{
    struct diagnostic *item = saying(diagnostics);
    size_t before = item && item->message ? strlen(item->message) : 0;
    size_t length = strlen(text);
    char *message;

    if (!item || length > SAID_MOST - before)
        return false;
    message = realloc(item->message, before + length + 1);
    if (!message)
        return false;
    memcpy(message + before, text, length + 1);
    item->message = message;
    return true;
}

/* Later bytes of a UTF-8 character take no column of their own. */
static bool starts_character(char c)
{
    return ((unsigned char)c & 0xc0) != 0x80;
}

/* One character as a terminal can bear it, tabs as blanks; the new column. */
static size_t put_character(const struct sink *sink, char c, size_t column)
{
    if (c == '\t') {
        size_t next = (column / TAB + 1) * TAB;
        sink_print(sink, "%*s", (int)(next - column), "");
        return next;
    }
    if ((unsigned char)c < ' ' || c == 0x7f)
        c = '?';
    sink->put(sink->context, &c, 1);
    return column + starts_character(c);
}

/* The source line, and a caret below the column if the line has it. */
static void put_source(const struct sink *sink,
                       const struct diagnostic *diagnostic)
{
    size_t column = 0, caret = 0, i;

    sink_put(sink, "    ");
    for (i = 0; diagnostic->source[i]; i++) {
        if (i + 1 == diagnostic->column)
            caret = column;
        column = put_character(sink, diagnostic->source[i], column);
    }
    if (i + 1 == diagnostic->column)
        caret = column;
    sink_put(sink, "\n");
    if (diagnostic->column <= i + 1)
        sink_print(sink, "    %*s^\n", (int)caret, "");
}

/* As it is, but for what a terminal takes as a command. */
static void put_said(const struct sink *sink, const char *text)
{
    for (; *text; text++)
        if (*text == '\n' || *text == '\t')
            sink->put(sink->context, text, 1);
        else
            put_character(sink, *text, 0);
}

void diagnostic_put(const struct diagnostic *diagnostic,
                    const struct sink *sink)
{
    static const char *const words[] = {
        [SEVERITY_ERROR] = "error",
        [SEVERITY_WARNING] = "warning",
        [SEVERITY_REPORT] = "report",
    };

    if (diagnostic->severity == SEVERITY_SAID) {
        put_said(sink, diagnostic->message ? diagnostic->message : "");
        return;
    }
    sink_put(sink, diagnostic->file);
    if (diagnostic->line)
        sink_print(sink, ":%zu:%zu", diagnostic->line, diagnostic->column);
    sink_print(sink, ": %s: ", words[diagnostic->severity]);
    for (const char *c = diagnostic->message; *c; c++)
        put_character(sink, *c, 0);
    sink_put(sink, "\n");
    if (diagnostic->line)
        put_source(sink, diagnostic);
}

void diagnostics_put(const struct diagnostics *diagnostics,
                     const struct sink *sink)
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
