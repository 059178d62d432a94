/* band_file.h - the finished bands of a long frame, in a file.
 *
 * Each band is added as soon as it is finished, with a checksum, so whatever
 * ends the work leaves a file that a later run can go on from: a last part
 * that is not whole is passed over.  The key says which frame the bands
 * belong to: everything that its pixels and clocks depend on.
 */
#ifndef RT_BAND_FILE_H
#define RT_BAND_FILE_H

#include "rt/trace/band.h"

struct band_file;

/* What is done with a band of the file, which is freed then.  False: there is no
 * memory for that. */
typedef bool band_taker(void *context, const struct band *band);

/* A new file, or one of the same key and width: the bands that it has are
 * taken, one after another; an empty one is as good as none.  NULL: it is a file
 * of something else, cannot be read or written, or another process has it
 * open. */
struct band_file *band_file_open(const char *path, uint64_t key, size_t width,
                                 const c205_model *model, band_taker *taker,
                                 void *context, c205_error *error);
bool band_file_add(struct band_file *file, const struct band *band,
                   c205_error *error);
/* remove_it: nobody needs it any more. */
void band_file_close(struct band_file *file, bool remove_it);

/* The key of a frame by the machine that traces its first band: all of its
 * state (c205_save); 0 when memory is short. */
uint64_t band_file_key(const c205 *machine);

#endif
