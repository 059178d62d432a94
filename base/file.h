/* file.h - whole files into memory. */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include "vm/c205.h"

enum { FILE_LARGEST = (1 << 28) - 2 }; /* bytes */

/* The bytes of a file and a NUL after them, to be freed; NULL: the error says
 * why, without naming the file, and errno is set.  Files of more than so many
 * bytes are refused (EFBIG), endless ones among them. */
char *file_read(const char *path, size_t largest, size_t *length,
                c205_error *error);

/* Whether two paths name one file, however they are written; neither needs to
 * be there. */
bool file_is_one(const char *a, const char *b);

#endif
