/* checkpoint_file.h - stores the finished units of a long run in a file.
 *
 * Each unit, a number and words, is appended with a checksum as soon as it is
 * finished. However the run ends, a later run can therefore continue from the
 * file; an incomplete unit at its end is dropped. The key identifies the run: it
 * is a hash of everything that the units depend on.
 */
#ifndef RT_FARM_CHECKPOINT_FILE_H
#define RT_FARM_CHECKPOINT_FILE_H

#include "rt/jobs/serialized_result.h"

struct checkpoint_file;

/* Opens a file with this key, or creates it. An empty file counts as new. Returns
 * NULL if the file has other contents, cannot be read or written, or is open in
 * another run. */
struct checkpoint_file *checkpoint_open(const char *path, uint64_t key,
                                        c205_error *error);
/* Adds all units of another file with the same key that this one lacks. The other
 * file must exist, and is not changed. */
bool checkpoint_merge(struct checkpoint_file *file, const char *path,
                      c205_error *error);

size_t checkpoint_count(const struct checkpoint_file *file);
bool checkpoint_has(const struct checkpoint_file *file, uint64_t number);
/* Returns false if the file lacks the unit or cannot be read, or if out of memory. */
bool checkpoint_read(struct checkpoint_file *file, uint64_t number,
                     struct serialized_result *words);
/* Adds a unit, unless the file already has it. */
bool checkpoint_add(struct checkpoint_file *file, uint64_t number,
                    const struct serialized_result *words, c205_error *error);
/* Closes the file. remove_it: also removes it, since it is no longer needed. */
void checkpoint_close(struct checkpoint_file *file, bool remove_it);

#endif
