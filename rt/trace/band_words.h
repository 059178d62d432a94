/* band_words.h - a band as words, as files keep it and other processes send it. */
#ifndef RT_BAND_WORDS_H
#define RT_BAND_WORDS_H

#include "rt/jobs/serialized_result.h"
#include "rt/trace/band.h"

/* All but its place; width: of the frame, pixels. */
void band_put(const struct band *band, size_t width, struct serialized_result *words);
/* What a band of so many rows came to, which the caller frees.  False: the words are no
 * such band, or no memory. */
bool band_take(struct band *band, size_t width, struct serialized_result *words);

#endif
