/* unit_file.h - the finished units of a long run, in a file.
 *
 * Each unit, a number and words, is added as soon as it is finished, with a checksum, so
 * whatever ends the run leaves a file that a later one can go on from: a last part
 * that is not whole is dropped.  The key says which run the units belong to:
 * everything that they depend on.
 */
#ifndef RT_FARM_UNIT_FILE_H
#define RT_FARM_UNIT_FILE_H

#include "rt/farm/words.h"

struct unit_file;

/* A new file, or one of the same key; an empty one is as good as none.  NULL: it is a
 * file of something else, cannot be read or written, or another run has it open. */
struct unit_file *unit_file_open(const char *path, uint64_t key, c205_error *error);
/* All units of another file, of the same key, that this one does not have; that file
 * must be there, and stays as it is. */
bool unit_file_merge(struct unit_file *file, const char *path, c205_error *error);

size_t unit_file_count(const struct unit_file *file);
bool unit_file_has(const struct unit_file *file, uint64_t number);
/* False: it has none of that number, it cannot be read, no memory. */
bool unit_file_read(struct unit_file *file, uint64_t number, struct unit_words *words);
/* One that it has already is not added again. */
bool unit_file_add(struct unit_file *file, uint64_t number,
                   const struct unit_words *words, c205_error *error);
/* remove_it: nobody needs it any more. */
void unit_file_close(struct unit_file *file, bool remove_it);

#endif
