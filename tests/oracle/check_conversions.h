/* check_conversions.h - words from and to doubles, integers and text. */
#ifndef CHECK_CONVERSIONS_H
#define CHECK_CONVERSIONS_H

#include "vm/c205.h"

struct conversion {
    const char *name;
    /* One case by chance; prints what differs. */
    bool (*agrees)(uint64_t *random);
};

extern const struct conversion conversions[];
extern const size_t conversion_count;

bool check_conversion(const struct conversion *conversion, uint64_t seed,
                      size_t cases);

#endif
