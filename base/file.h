/* file.h - reads whole files, and tests paths. */
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include "vm/c205.h"

/* Returns true for "-", which means stdin for reading and stdout for writing. */
bool file_is_stream(const char *path);
/* Returns true if a path consists of a name and this ending, such as ".svg". */
bool file_ends_with(const char *path, const char *ending);

enum { FILE_LARGEST = (1 << 28) - 2 }; /* bytes */

/* Returns the bytes of a file, or of stdin, followed by a NUL; the caller frees them.
 * Returns NULL if it fails; the error has the reason without the file name, and errno
 * is set. It rejects files of more than `largest` bytes (EFBIG) and files that the
 * command writes (ETXTBSY, see outputs.h). */
char *file_read(const char *path, size_t largest, size_t *length, c205_error *error);
/* Returns the message for an errno of file_read. */
const char *file_reason(int code);

/* Returns true if a path names an existing regular file. Otherwise the error names the
 * kind of file, as in "a folder". */
bool file_is_plain(const char *path, c205_error *error);

/* Returns true if two paths refer to the same file, also through links. The file need
 * not exist. */
bool file_is_one(const char *a, const char *b);

#endif
