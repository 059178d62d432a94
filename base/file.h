/* file.h - reads whole files, and tests paths. */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include "vm/c205.h"

/* Returns true for "-", which is stdin when reading and stdout when writing. */
bool file_is_stream(const char *path);
/* Returns true if a path has a name before this ending: ".svg". */
bool file_ends_with(const char *path, const char *ending);

enum { FILE_LARGEST = (1 << 28) - 2 }; /* bytes */

/* Returns the bytes of a file, or of stdin, followed by a NUL; the caller frees them.
 * NULL: the error has the reason without the file name, and errno is set. Files of more
 * than largest bytes, including endless ones, are rejected (EFBIG), and also a file
 * that the command writes (ETXTBSY, see outputs.h). */
char *file_read(const char *path, size_t largest, size_t *length, c205_error *error);
/* Returns the text of such an errno. */
const char *file_reason(int code);

/* Returns true if a path names an existing regular file. Otherwise the error names
 * the kind of file ("a folder"). */
bool file_is_plain(const char *path, c205_error *error);

/* Returns true if two paths name one file, also through links. Neither needs to
 * exist. */
bool file_is_one(const char *a, const char *b);

#endif
