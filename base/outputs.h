/* outputs.h - a list of the files that a command writes and therefore must not read.
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

/* Adds an output file if it exists. A file that does not exist yet cannot be an input,
 * too. Returns false if the host is out of memory. */
bool outputs_add(const char *path);
bool outputs_has(const char *path);
/* Returns true if the list contains a file that is about to be read, and records that
 * it is an input. */
bool outputs_refuse(const struct stat *input);
/* Returns true if outputs_refuse has rejected the file at the path. */
bool outputs_refused(const char *path);
void outputs_clear(void);

#endif
