/* outputs.h - a list of the files that a command writes. It must not read them.
 *
 * The command line adds the files before any file is read. Device and inode identify a
 * file, so other paths, symbolic links and hard links to it are recognised. file_read
 * rejects these files, and atomic_file_commit rejects a file that file_read rejected.
 * No command overwrites one of its inputs.
 *
 * The process has one list. Only parsing a command line adds files, so the list has no
 * effect on users of the libraries.
 */
#ifndef BASE_OUTPUTS_H
#define BASE_OUTPUTS_H

#include <stdbool.h>
#include <sys/stat.h>

/* Adds a file if it exists. A file that does not exist cannot be read. Returns false if
 * the host is out of memory. */
bool outputs_add(const char *path);
bool outputs_has(const char *path);
/* Returns true if the list contains this file, and marks it as rejected. Called before
 * a file is read. */
bool outputs_refuse(const struct stat *input);
/* Returns true if the path refers to a marked file. */
bool outputs_refused(const char *path);
void outputs_clear(void);

#endif
