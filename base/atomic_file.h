/* atomic_file.h - files that are written completely or not at all.
 *
 * A file is written under a temporary name in the same folder. It gets its real name
 * after the whole file has reached the disk. A signal that ends the program removes the
 * temporary file. A symbolic link is kept, and the file that it refers to is replaced.
 * Devices, pipes, stdout and stderr ("-", "/dev/stdout") are written directly, because
 * they have no content to preserve. No input of the command is replaced (outputs.h).
 */
#ifndef BASE_ATOMIC_FILE_H
#define BASE_ATOMIC_FILE_H

#include <stdio.h>

#include "vm/c205.h"

struct atomic_file {
    FILE *file; /* the caller writes to this stream */
    char *path;
    char *temporary; /* NULL: the file is written directly */
};

/* Opens a temporary file for the path. Returns NULL with the error if it cannot be
 * written. */
struct atomic_file *atomic_file_open(const char *path, c205_error *error);
/* Returns true if the file can be written. A command calls this function before long
 * work. It leaves no file. */
bool atomic_file_check(const char *path, c205_error *error);
/* atomic_file_commit gives the file its real name; a failure leaves the old file
 * unchanged. atomic_file_discard removes the temporary file. Both free the struct. */
bool atomic_file_commit(struct atomic_file *whole, c205_error *error);
void atomic_file_discard(struct atomic_file *whole);

#endif
