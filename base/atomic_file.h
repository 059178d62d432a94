/* atomic_file.h - a file that is written whole or not at all.
 *
 * It is written under a temporary name beside the real one, and gets the real
 * name when all of it has reached the disk; a signal that ends the program removes
 * it.  A symbolic link stays, and the file that it leads to is replaced.  What is
 * no regular file (a device, a pipe), and stdout and stderr ("-", "/dev/stdout")
 * are written directly, as there is nothing to keep.  An input of the command is
 * not replaced (outputs.h).
 */
#ifndef BASE_ATOMIC_FILE_H
#define BASE_ATOMIC_FILE_H

#include <stdio.h>

#include "vm/c205.h"

struct atomic_file {
    FILE *file; /* write here */
    char *path;
    char *temporary; /* NULL: written directly */
};

/* NULL: it cannot be written there. */
struct atomic_file *atomic_file_open(const char *path, c205_error *error);
/* Whether it could, for who has long work to do before; nothing is left. */
bool atomic_file_check(const char *path, c205_error *error);
/* Both free it.  A failed commit leaves the old file as it was. */
bool atomic_file_commit(struct atomic_file *whole, c205_error *error);
void atomic_file_discard(struct atomic_file *whole);

#endif
