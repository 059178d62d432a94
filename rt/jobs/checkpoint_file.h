/* checkpoint_file.h - the finished units of a long run, in a file.
 *
 * Each unit, a number and words, is added as soon as it is finished, with a checksum, so
 * whatever ends the run leaves a file that a later one can continue from: a last part
 * that is not whole is dropped.  The key says which run the units belong to:
 * everything that they depend on.
 */
#ifndef RT_FARM_CHECKPOINT_FILE_H
#define RT_FARM_CHECKPOINT_FILE_H

#include "rt/jobs/serialized_result.h"

struct checkpoint_file;

/* A new file, or one of the same key; an empty one is as good as none.  NULL: it is a
 * file of something else, cannot be read or written, or another run has it open. */
struct checkpoint_file *checkpoint_open(const char *path, uint64_t key,
                                        c205_error *error);
/* All units of another file, of the same key, that this one does not have; that file
 * must be there, and stays as it is. */
bool checkpoint_merge(struct checkpoint_file *file, const char *path,
                      c205_error *error);

size_t checkpoint_count(const struct checkpoint_file *file);
bool checkpoint_has(const struct checkpoint_file *file, uint64_t number);
/* False: it has none of that number, it cannot be read, no memory. */
bool checkpoint_read(struct checkpoint_file *file, uint64_t number,
                     struct serialized_result *words);
/* One that it has already is not added again. */
bool checkpoint_add(struct checkpoint_file *file, uint64_t number,
                    const struct serialized_result *words, c205_error *error);
/* remove_it: nobody needs it any more. */
void checkpoint_close(struct checkpoint_file *file, bool remove_it);

#endif
