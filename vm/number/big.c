/* big.c - arithmetic on big natural numbers, one 32-bit limb at a time. */
#include "vm/number/big.h"

#include <assert.h>
#include <string.h>

enum {
    LIMB_BITS = 32,
    FIVES = 13 /* 5^13 is the greatest power of 5 in a limb */
};

static uint32_t power_of_5(int32_t power)
{
    uint32_t value = 1;
    while (power-- > 0)
        value *= 5;
    return value;
}

/* Removes leading zero limbs. */
static void trim(big *number)
{
    while (number->count > 0 && number->limb[number->count - 1] == 0)
        number->count--;
}

static void append(big *number, uint32_t limb)
{
    if (limb != 0) {
        assert(number->count < BIG_LIMBS);
        number->limb[number->count++] = limb;
    }
}

void big_set(big *number, uint64_t value)
{
    number->count = 2;
    number->limb[0] = (uint32_t)value;
    number->limb[1] = (uint32_t)(value >> LIMB_BITS);
    trim(number);
}

int32_t big_bit_length(const big *number)
{
    if (number->count == 0)
        return 0;
    int32_t bits = (int32_t)(number->count - 1) * LIMB_BITS;
    for (uint32_t top = number->limb[number->count - 1]; top != 0; top >>= 1)
        bits++;
    return bits;
}

uint64_t big_low(const big *number)
{
    uint64_t low = number->count > 0 ? number->limb[0] : 0;
    uint64_t high = number->count > 1 ? number->limb[1] : 0;
    return high << LIMB_BITS | low;
}

void big_multiply(big *number, uint32_t factor, uint32_t addend)
{
    uint64_t carry = addend;
    for (size_t i = 0; i < number->count; i++) {
        carry += (uint64_t)number->limb[i] * factor;
        number->limb[i] = (uint32_t)carry;
        carry >>= LIMB_BITS;
    }
    append(number, (uint32_t)carry);
}

void big_multiply_power_of_5(big *number, int32_t power)
{
    for (; power > 0; power -= FIVES)
        big_multiply(number, power_of_5(power < FIVES ? power : FIVES), 0);
}

static uint32_t divide(big *number, uint32_t divisor)
{
    uint64_t remainder = 0;
    for (size_t i = number->count; i-- > 0;) {
        remainder = remainder << LIMB_BITS | number->limb[i];
        number->limb[i] = (uint32_t)(remainder / divisor);
        remainder %= divisor;
    }
    trim(number);
    return (uint32_t)remainder;
}

/* Divides by small powers in steps. This is exact, because the floor of a floor equals
 * the floor of the total quotient. */
bool big_divide_power_of_5(big *number, int32_t power)
{
    bool lost = false;
    for (; power > 0; power -= FIVES)
        if (divide(number, power_of_5(power < FIVES ? power : FIVES)) != 0)
            lost = true;
    return lost;
}

void big_shift_left(big *number, int32_t places)
{
    size_t limbs = (size_t)(places / LIMB_BITS);
    big_multiply(number, UINT32_C(1) << places % LIMB_BITS, 0);
    if (number->count == 0)
        return;
    assert(number->count + limbs <= BIG_LIMBS);
    memmove(number->limb + limbs, number->limb, number->count * sizeof number->limb[0]);
    memset(number->limb, 0, limbs * sizeof number->limb[0]);
    number->count += limbs;
}

bool big_shift_right(big *number, int32_t places)
{
    size_t limbs = (size_t)(places / LIMB_BITS);
    bool lost = false;
    if (limbs > number->count)
        limbs = number->count;
    for (size_t i = 0; i < limbs; i++)
        lost |= number->limb[i] != 0;
    number->count -= limbs;
    memmove(number->limb, number->limb + limbs, number->count * sizeof number->limb[0]);
    return (divide(number, UINT32_C(1) << places % LIMB_BITS) != 0) | lost;
}
