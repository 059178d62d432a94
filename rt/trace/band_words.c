/* band_words.c - serializes a band as words, and reads it back. */
#include "rt/trace/band_words.h"

#include <stdlib.h>

void band_put(const struct band *band, size_t width, struct serialized_result *words)
{
    for (int kind = 0; kind < RAY_KINDS; kind++)
        result_put(words, band->rays[kind]);
    result_put_accounts(words, &band->accounts);
    result_put_all(words, band->words, FRAME_CHANNELS * band->rows * width);
}

static bool take_samples(struct band *band, size_t width,
                         struct serialized_result *words)
{
    size_t count = FRAME_CHANNELS * band->rows * width;
    if (count != words->count - words->at)
        return false;
    band->words = malloc(count * sizeof *band->words);
    if (band->words)
        result_take_all(words, band->words, count);
    return band->words;
}

bool band_take(struct band *band, size_t width, struct serialized_result *words)
{
    for (int kind = 0; kind < RAY_KINDS; kind++)
        band->rays[kind] = result_take(words);
    band->rows_done = band->rows;
    return result_take_accounts(words, &band->accounts)
           && take_samples(band, width, words);
}
