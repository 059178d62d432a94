/* report.c - reports: kept, printed, freed. */
#include "rt/scene/language/report.h"

#include <stdlib.h>
#include <string.h>

#define TAB 8
#define LONGEST_LINE 1000 /* bytes of a source line that are kept */

static char *copy(const char *text, size_t length)
{
    char *own = malloc(length + 1);

    if (own) {
        memcpy(own, text, length);
        own[length] = '\0';
    }
    return own;
}

/* The array's room is its count rounded up to a power of two. */
static struct report *room_for_one(struct reports *reports)
{
    size_t n = reports->count;

    if ((n & (n - 1)) == 0) {
        size_t room = n ? 2 * n : 1;
        struct report *items = realloc(reports->items, room * sizeof *items);
        if (!items)
            return NULL;
        reports->items = items;
    }
    return &reports->items[reports->count++];
}

void reports_add(struct reports *reports, bool error,
                 const struct position *position, const char *message)
{
    struct report *report = room_for_one(reports);
    size_t length = position->source_length;

    if (error)
        reports->errors++;
    if (!report)
        return;
    if (length > LONGEST_LINE)
        length = LONGEST_LINE;
    report->said = false;
    report->error = error;
    report->file = copy(position->file, strlen(position->file));
    report->line = position->line;
    report->column = position->column;
    report->message = copy(message, strlen(message));
    report->source = copy(position->source ? position->source : "", length);
}

bool reports_have(const struct reports *reports,
                  const struct position *position, const char *message)
{
    for (size_t i = 0; i < reports->count; i++) {
        const struct report *report = &reports->items[i];
        if (report->line == position->line
            && report->column == position->column && report->message
            && report->file && !strcmp(report->message, message)
            && !strcmp(report->file, position->file))
            return true;
    }
    return false;
}

/* Another report for what is said; NULL: no memory. */
static struct report *room_for_saying(struct reports *reports)
{
    struct report *report;

    for (size_t i = 0; i < reports->count; i++)
        if (reports->items[i].said)
            return &reports->items[i];
    report = room_for_one(reports);
    if (report) {
        memset(report, 0, sizeof *report);
        report->said = true;
    }
    return report;
}

bool reports_say(struct reports *reports, const char *text)
{
    struct report *report = room_for_saying(reports);
    size_t before = report && report->message ? strlen(report->message) : 0;
    size_t length = strlen(text);
    char *message;

    if (!report || length > SAID_MOST - before)
        return false;
    message = realloc(report->message, before + length + 1);
    if (!message)
        return false;
    memcpy(message + before, text, length + 1);
    report->message = message;
    return true;
}

void reports_free(struct reports *reports)
{
    for (size_t i = 0; i < reports->count; i++) {
        free(reports->items[i].file);
        free(reports->items[i].message);
        free(reports->items[i].source);
    }
    free(reports->items);
    memset(reports, 0, sizeof *reports);
}

/* Later bytes of a UTF-8 character take no column of their own. */
static bool starts_character(char c)
{
    return ((unsigned char)c & 0xc0) != 0x80;
}

/* One character as a terminal can bear it, tabs as blanks; the new column. */
static size_t print_character(FILE *out, char c, size_t column)
{
    if (c == '\t') {
        size_t next = (column / TAB + 1) * TAB;
        fprintf(out, "%*s", (int)(next - column), "");
        return next;
    }
    if ((unsigned char)c < ' ' || c == 0x7f)
        c = '?';
    putc(c, out);
    return column + starts_character(c);
}

static void print_source(FILE *out, const struct report *report)
{
    size_t column = 0, caret = 0, i;

    fputs("    ", out);
    for (i = 0; report->source[i]; i++) {
        if (i + 1 == report->column)
            caret = column;
        column = print_character(out, report->source[i], column);
    }
    if (i + 1 == report->column)
        caret = column;
    putc('\n', out);
    if (report->column <= i + 1)
        fprintf(out, "    %*s^\n", (int)caret, "");
}

static void print_report(FILE *out, const struct report *report)
{
    fprintf(out, "%s:", report->file);
    if (report->line)
        fprintf(out, "%zu:%zu:", report->line, report->column);
    fputs(report->error ? " error: " : " report: ", out);
    for (const char *c = report->message; *c; c++)
        print_character(out, *c, 0);
    putc('\n', out);
    if (report->line)
        print_source(out, report);
}

/* As it is, but for what a terminal takes as a command. */
static void print_said(FILE *out, const char *text)
{
    for (; *text; text++)
        if (*text == '\n' || *text == '\t')
            putc(*text, out);
        else
            print_character(out, *text, 0);
}

void reports_print(FILE *out, const struct reports *reports)
{
    for (size_t i = 0; i < reports->count; i++) {
        const struct report *report = &reports->items[i];
        if (report->said && report->message)
            print_said(out, report->message);
        else if (report->file && report->message && report->source)
            print_report(out, report);
    }
}
