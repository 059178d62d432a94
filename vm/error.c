/* error.c - formats error messages. */
#include "vm/error.h"

#include <stdio.h>

bool error_set_list(c205_error *error, const char *format, va_list arguments)
{
    vsnprintf(error->message, sizeof error->message, format, arguments);
    return false;
}

bool error_set(c205_error *error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    error_set_list(error, format, arguments);
    va_end(arguments);
    return false;
}
