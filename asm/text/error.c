/* error.c - reports errors, and records warnings until the end of an assembly. */
#include "asm/text/assembler.h"
#include "vm/error.h"

#include <stdio.h>
#include <string.h>

#include "asm/object/syntax.h"
#include "asm/text/shown_line.h"

bool report_file(struct diagnostics *diagnostics, const char *file, const char *message)
{
    const struct position position = { .file = file };
    diagnostics_add(diagnostics, SEVERITY_ERROR, &position, message);
    return false;
}

static void print_caller(char *message, size_t size, const struct line *line)
{
    size_t used = strlen(message);
    if (reported_line(line) != line)
        snprintf(message + used, size - used, " (in a macro, at %s:%zu)", line->file,
                 line->number);
    else if (line->call)
        snprintf(message + used, size - used, " (expanded from %s:%zu)",
                 line->call->line->file, line->call->line->number);
}

/* Returns the column of an error. An error of a whole line is at its first word. */
static size_t column_of(const struct line *line, const char *at)
{
    if (at == line->begin)
        while (at < line->text_end && (*at == ' ' || *at == '\t'))
            at++;
    return (size_t)(at - line->text) + 1;
}

/* Returns the position of an error. An error in a macro of asm/lib is at its call. */
static struct position position_of(const struct line *line, const char *at)
{
    if (reported_line(line) != line) {
        line = reported_line(line);
        at = line->begin;
    }
    const struct position position = { line->file, line->number, column_of(line, at),
                                       line->text,
                                       (size_t)(line->text_end - line->text) };
    return position;
}

/* Appends the syntax of an instruction to the first error in its operands. */
static void print_form(char *message, size_t size, struct assembler *assembler)
{
    const struct instruction *writing = assembler->writing;
    struct text_line form = { "", 0 };
    struct sink sink = text_line_sink(&form);
    size_t used = strlen(message);
    assembler->writing = NULL;
    if (!writing)
        return;
    syntax_write(writing->insn, writing->fields.g & C205_G_HALF, &sink);
    snprintf(message + used, size - used, "; syntax: %s", form.text);
}

bool report(struct assembler *assembler, const struct line *line, const char *at,
            const char *format, ...)
{
    char message[512];
    struct position position = position_of(line, at);
    if (too_many_errors(assembler))
        return false;
    PRINTF_TEXT(message, format);
    print_form(message, sizeof message, assembler);
    print_caller(message, sizeof message, line);
    diagnostics_add(assembler->diagnostics, SEVERITY_ERROR, &position, message);
    return false;
}

bool too_many_errors(const struct assembler *assembler)
{
    return assembler->diagnostics->errors - assembler->first_error >= MAX_ERRORS;
}

void warn(struct assembler *assembler, enum warning warning, const struct line *line,
          const char *at, const char *format, ...)
{
    char message[512];
    struct pending_warning pending = { warning, position_of(line, at), NULL };
    if (assembler->pending_count >= MAX_ERRORS)
        return;
    PRINTF_TEXT(message, format);
    print_caller(message, sizeof message, line);
    pending.message = arena_text(assembler->arena, message, strlen(message));
    if (pending.message)
        arena_add(assembler->arena, &assembler->pending_warnings,
                  &assembler->pending_count, &assembler->pending_capacity, &pending,
                  sizeof pending);
}

/* Returns the warnings that the program declares as intended. */
static warning_set meant(const struct assembler *assembler)
{
    warning_set set = 0;
    for (size_t i = 0; i < assembler->expectation_count; i++)
        if (assembler->expectations[i].kind == EXPECT_WARNING)
            set |= WARNING_BIT(warning_named(assembler->expectations[i].text));
    return set;
}

warning_set report_pending_warnings(struct assembler *assembler)
{
    static const struct warning_choice all;
    const struct asm_options *options = assembler->options;
    const struct warning_choice *choice = options ? &options->warnings : &all;
    warning_set silent = choice->off | meant(assembler), found = 0;
    for (size_t i = 0; i < assembler->pending_count; i++) {
        const struct pending_warning *pending = &assembler->pending_warnings[i];
        warning_set bit = WARNING_BIT(pending->warning);
        found |= bit;
        if (!(silent & bit))
            warning_add(assembler->diagnostics, choice, pending->warning,
                        &pending->position, pending->message);
    }
    return found;
}
