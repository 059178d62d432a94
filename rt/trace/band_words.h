/* band_words.h - a band as a sequence of words, the form in which it is stored in
 * files and sent to other processes. */
#ifndef RT_BAND_WORDS_H
#define RT_BAND_WORDS_H

#include "rt/jobs/serialized_result.h"
#include "rt/trace/band.h"

/* Appends everything but the position of the band. The width is that of the frame,
 * in pixels. */
void band_put(const struct band *band, size_t width, struct serialized_result *words);
/* Reads a band whose number of rows is set. The caller frees the band. Returns
 * false if the words are not those of such a band, or if out of memory. */
bool band_take(struct band *band, size_t width, struct serialized_result *words);

#endif
