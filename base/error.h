/* error.h - formats error messages. */
#ifndef BASE_ERROR_H
#define BASE_ERROR_H

#include "vm/c205.h"

#include <stdbool.h>

/* Formats a message like printf, cut to the size of the buffer. Always returns
 * false. */
bool error_set(c205_error *error, const char *format, ...);

/* The digits of a macro, for a message about a limit: "at most " LIMIT_TEXT(MAX). */
#define LIMIT_TEXT(macro) LIMIT_DIGITS(macro)
#define LIMIT_DIGITS(digits) #digits

#endif
