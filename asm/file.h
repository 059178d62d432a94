/* file.h - whole files into memory. */
#ifndef ASM_FILE_H
#define ASM_FILE_H

#include "vm/c205.h"

/* The bytes of a file and a NUL after them, to be freed; NULL: the error says
 * why, without naming the file.  Files of more than 256 MB, endless ones among
 * them, are refused. */
char *file_read(const char *path, size_t *length, c205_error *error);

#endif
