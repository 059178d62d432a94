/* outputs.h - the files that a command writes, which it must not read.
 *
 * The command line names them before anything is read. They are identified by device
 * and inode, so other paths, symbolic links and hard links to them are recognised.
 * file_read refuses to read them, and atomic_file_commit refuses to write one that was
 * to be read. No command overwrites one of its inputs.
 *
 * The list belongs to the process. It is empty unless a command line is parsed, so it
 * has no effect on users of the libraries.
 */
#ifndef BASE_OUTPUTS_H
#define BASE_OUTPUTS_H

#include <stdbool.h>
#include <sys/stat.h>

/* Adds a file. A file that does not exist cannot be read, and is not added. Returns
 * false if memory is exhausted. */
bool outputs_add(const char *path);
bool outputs_has(const char *path);
/* Returns true if this file, which is about to be read, is in the list, and marks
 * it. */
bool outputs_refuse(const struct stat *input);
/* Returns true if the path names a marked file. */
bool outputs_refused(const char *path);
void outputs_clear(void);

#endif
