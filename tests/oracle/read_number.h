/* read_number.h - reads a number from the arguments of a check. */
#ifndef READ_NUMBER_H
#define READ_NUMBER_H

#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* Returns false if the text is not a number from 0, or is too large. */
static inline bool read_number(const char *text, uint64_t *number)
{
    char *end;

    errno = 0;
    *number = strtoull(text, &end, 0);
    return errno == 0 && end != text && *end == '\0' && *text != '-';
}

#endif
