/* checkpoint_file.h - stores the finished units of a long run in a file.
 *
 * A unit consists of a number and words. It is appended with a checksum as soon as it
 * is finished. If a run ends early, a later run can therefore continue from the file.
 * An incomplete unit at the end is dropped. The key identifies the run. It is a hash of
 * all data that the units depend on.
 */
#ifndef RT_CHECKPOINT_FILE_H
#define RT_CHECKPOINT_FILE_H

#include "rt/jobs/serialized_result.h"

struct checkpoint_file;

/* Opens a file with this key, or creates it. An empty file counts as new. Returns NULL
 * if the file has other contents, if it cannot be read or written, or if another run
 * has opened it. */
struct checkpoint_file *checkpoint_open(const char *path, uint64_t key,
                                        c205_error *error);
/* Adds the units of another file with the same key that are not in this file. The other
 * file must exist, and is not changed. On failure sets the error and returns false. */
bool checkpoint_merge(struct checkpoint_file *file, const char *path,
                      c205_error *error);

size_t checkpoint_count(const struct checkpoint_file *file);
bool checkpoint_has(const struct checkpoint_file *file, uint64_t number);
/* Reads the words of a unit. Returns false if the unit is not in the file, if the file
 * cannot be read, or if out of memory. */
bool checkpoint_read(struct checkpoint_file *file, uint64_t number,
                     struct serialized_result *words);
/* Adds a unit, unless the file contains it. */
bool checkpoint_add(struct checkpoint_file *file, uint64_t number,
                    const struct serialized_result *words, c205_error *error);
/* Closes the file. remove_it: also removes it, because it is no longer needed. */
void checkpoint_close(struct checkpoint_file *file, bool remove_it);

#endif
