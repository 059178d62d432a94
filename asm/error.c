#include "asm/assembler.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool report_file(struct diagnostics *diagnostics, const char *file,
                 const char *message)
{
    const struct position position = { .file = file };

    diagnostics_add(diagnostics, SEVERITY_ERROR, &position, message);
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
    const struct position position = {
        line->file, line->number, column_of(line, at), line->text,
        (size_t)(line->text_end - line->text)
    };
    va_list arguments;

    if (too_many_errors(assembler))
        return false;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    say_caller(message, sizeof message, line);
    diagnostics_add(assembler->diagnostics, SEVERITY_ERROR, &position,
                    message);
    return false;
}

bool too_many_errors(const struct assembler *assembler)
{
    return assembler->diagnostics->errors - assembler->first_error
           >= MAX_ERRORS;
}
