/* double_bits.h - converts between a double and its bits as an integer. */
#ifndef C205_DOUBLE_BITS_H
#define C205_DOUBLE_BITS_H

#include <stdint.h>
#include <string.h>

static inline double double_of_bits(uint64_t bits)
{
    double d;
    memcpy(&d, &bits, sizeof d);
    return d;
}

static inline uint64_t bits_of_double(double d)
{
    uint64_t bits;
    memcpy(&bits, &d, sizeof bits);
    return bits;
}

#endif
