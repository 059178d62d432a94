/* band_words.h - converts a band to a sequence of words and back, for files and for
 * messages to other processes. */
#ifndef RT_BAND_WORDS_H
#define RT_BAND_WORDS_H

#include "rt/jobs/serialized_result.h"
#include "rt/trace/band.h"

/* Appends all fields of the band except its position. `width` is the width of the frame
 * in pixels. */
void band_put(const struct band *band, size_t width, struct serialized_result *words);
/* Reads a band; band->rows must be set. The caller frees the band. Returns false if the
 * words do not describe such a band, or if out of memory. */
bool band_take(struct band *band, size_t width, struct serialized_result *words);

#endif
