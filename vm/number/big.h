/* big.h - natural numbers of up to 76,800 bits, with the in-place operations that exact
 * decimal conversion needs.
 */
#ifndef C205_BIG_H
#define C205_BIG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { BIG_LIMBS = 2400 }; /* 76,800 bits */

/* The value is the sum of limb[i] x 2^(32 i) for i < count. The last limb is not 0. */
typedef struct big {
    size_t count;
    uint32_t limb[BIG_LIMBS];
} big;

void big_set(big *number, uint64_t value);
int32_t big_bit_length(const big *number);
/* Returns the lowest 64 bits of a number. */
uint64_t big_low(const big *number);

/* number := number x factor + addend */
void big_multiply(big *number, uint32_t factor, uint32_t addend);
void big_multiply_power_of_5(big *number, int32_t power);
void big_shift_left(big *number, int32_t places);

/* These functions divide a number in place, round down, and return true if the
 * remainder is not 0. */
bool big_divide_power_of_5(big *number, int32_t power);
bool big_shift_right(big *number, int32_t places);

#endif
