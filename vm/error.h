/* error.h - formats error messages. */
#ifndef C205_ERROR_H
#define C205_ERROR_H

#include "vm/c205.h"

#include <stdarg.h>
#include <stdio.h>

/* Declares that a parameter is a printf format. `first` is the number of the first
 * argument that it formats. */
#if defined(__GNUC__)
#define PRINTF_FORMAT(format_at, first) \
    __attribute__((format(printf, format_at, first)))
#else
#define PRINTF_FORMAT(format_at, first)
#endif

/* Formats the arguments after the parameter `format` of a function into an array. */
#define PRINTF_TEXT(array, format) \
    do { \
        va_list printf_list; \
        va_start(printf_list, format); \
        vsnprintf(array, sizeof(array), format, printf_list); \
        va_end(printf_list); \
    } while (0)

/* Formats a message like printf, truncated to the size of the buffer. Always returns
 * false. */
bool error_set(c205_error *error, const char *format, ...) PRINTF_FORMAT(2, 3);
bool error_set_list(c205_error *error, const char *format, va_list arguments);

/* The digits of a macro's value, for a message about a limit: "at most "
 * LIMIT_TEXT(MAX). */
#define LIMIT_TEXT(macro) LIMIT_DIGITS(macro)
#define LIMIT_DIGITS(digits) #digits

#endif
