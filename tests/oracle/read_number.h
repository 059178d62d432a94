/* read_number.h - a number among the arguments of a check. */
#ifndef READ_NUMBER_H
#define READ_NUMBER_H

#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* False: the text is no number from 0 on, or is too large. */
static inline bool read_number(const char *text, uint64_t *number)
{
    char *end;

    errno = 0;
    *number = strtoull(text, &end, 0);
    return errno == 0 && end != text && *end == '\0' && *text != '-';
}

#endif
