/* complain.c - see complain.h. */
#include "base/complain.h"

#include <stdarg.h>
#include <stdio.h>

static void complain(const char *command, const char *format, va_list list)
{
    fflush(stdout);
    fprintf(stderr, "%s: ", command);
    vfprintf(stderr, format, list);
    putc('\n', stderr);
}

int cmd_usage(const char *command, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    complain(command, format, list);
    va_end(list);
    fprintf(stderr, "%s --help tells how it is used\n", command);
    return CMD_USAGE;
}

int cmd_failed(const char *command, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    complain(command, format, list);
    va_end(list);
    return CMD_FAILED;
}
