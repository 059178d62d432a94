/* outputs.h - the files that a command writes, which it must not read.
 *
 * A command line names them before anything is read.  They are identified by device
 * and inode, so that another path, a symbolic link and a hard link are found as well.
 * file_read refuses to read them, and atomic_file_commit to write one that was to be read:
 * no command writes over one of its inputs.
 *
 * The list belongs to the process.  It is empty unless a command line is parsed, so it
 * does not exist for who uses the libraries.
 */
#ifndef BASE_OUTPUTS_H
#define BASE_OUTPUTS_H

#include <stdbool.h>
#include <sys/stat.h>

/* A file that does not exist cannot be read, and is not added.  False: no memory. */
bool outputs_add(const char *path);
bool outputs_has(const char *path);
/* Whether this file, which is about to be read, is one of them.  If so it is marked. */
bool outputs_refuse(const struct stat *input);
/* Whether the path names a file that is marked. */
bool outputs_refused(const char *path);
void outputs_clear(void);

#endif
