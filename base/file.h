/* file.h - whole files into memory; what paths name. */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include "vm/c205.h"

/* Whether a path is "-": stdin where it is read, stdout where it is written. */
bool file_is_stream(const char *path);
/* It has a name, and this ending: ".svg". */
bool file_ends_with(const char *path, const char *ending);

enum { FILE_LARGEST = (1 << 28) - 2 }; /* bytes */

/* The bytes of a file, or of stdin, and a NUL after them, to be freed; NULL: the error says
 * why, without naming the file, and errno is set.  Files of more than so many
 * bytes are refused (EFBIG), endless ones among them; so is one that the command
 * writes (ETXTBSY, see outputs.h). */
char *file_read(const char *path, size_t largest, size_t *length, c205_error *error);
/* The text of such an errno. */
const char *file_reason(int code);

/* Whether a path names a file that ends: no folder, pipe or device, and it is there.  If not,
 * the error has what it is instead ("a folder"). */
bool file_is_plain(const char *path, c205_error *error);

/* Whether two paths name one file, however they are written, links included;
 * neither needs to exist. */
bool file_is_one(const char *a, const char *b);

#endif
