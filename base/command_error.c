/* command_error.c - prints error messages with escapes. */
#include "base/command_error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/sink.h"
#include "base/visible_text.h"

enum { LONGEST = 8192 /* bytes; longer messages are truncated */ };

static void put_line(FILE *file, const char *format, va_list list)
{
    struct sink sink = stream_sink(file);
    char text[LONGEST];
    vsnprintf(text, sizeof text, format, list);
    visible_put(&sink, text, strlen(text));
    putc('\n', file);
}

static void print_error(const char *command, const char *format, va_list list)
{
    fflush(stdout);
    fprintf(stderr, "%s: ", command);
    put_line(stderr, format, list);
}

int cmd_usage(const char *command, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    print_error(command, format, list);
    va_end(list);
    fprintf(stderr, "%s --help prints the usage\n", command);
    return CMD_USAGE;
}

int cmd_failed(const char *command, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    print_error(command, format, list);
    va_end(list);
    return CMD_FAILED;
}

void cmd_print_line(FILE *file, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    put_line(file, format, list);
    va_end(list);
}
