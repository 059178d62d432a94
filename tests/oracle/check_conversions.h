/* check_conversions.h - tests of conversions between words of both sizes and doubles,
 * integers and text. */
#ifndef CHECK_CONVERSIONS_H
#define CHECK_CONVERSIONS_H

#include "arithmetic_oracle.h"

/* The conversions of one size of word. */
struct converters {
    const struct oracle_format *format;
    c205_word (*from_double)(double value);
    double (*to_double)(c205_word word);
    c205_word (*from_text)(const char *text, const char **end);
    void (*to_text)(c205_word word, char text[C205_TEXT_SIZE]);
};

struct conversion {
    const char *name;
    const struct converters *converters;
    /* Tests one random case and prints the difference. */
    bool (*agrees)(const struct converters *converters, uint64_t *random);
};

extern const struct conversion conversions[];
extern const size_t conversion_count;

bool check_conversion(const struct conversion *conversion, uint64_t seed, size_t cases);

#endif
