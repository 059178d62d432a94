#include "operands.h"

/* splitmix64: Steele, Lea, Flood, "Fast splittable pseudorandom number
 * generators", 2014. */
uint64_t random_bits(uint64_t *random)
{
    uint64_t z = *random += UINT64_C(0x9E3779B97F4A7C15);

    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

int64_t random_between(uint64_t *random, int64_t low, int64_t high)
{
    const uint64_t span = (uint64_t)(high - low) + 1;

    return low + (int64_t)(random_bits(random) % span);
}

static c205_word pack(int64_t exponent, int64_t coefficient)
{
    return (c205_word)exponent << 48
           | ((c205_word)coefficient & UINT64_C(0xFFFFFFFFFFFF));
}

/* ---- The edges ---------------------------------------------------------- */

#define TWO(n) (INT64_C(1) << (n))

static const int64_t edge_exponents[] = {
    -32768, -32767, -28673,                /* machine zeros */
    28672, 32767,                          /* indefinites */
    28671, 28670, 28624,                   /* the largest numbers */
    -28672, -28671, -28626, -28625,        /* the smallest */
    -48, -47, -46, -45, -1, 0, 1, 47,
};

static const int64_t edge_coefficients[] = {
    0, 1, -1, 2, -2, 3, -3, 5, TWO(23), -TWO(23), TWO(24) - 1,
    TWO(45), -TWO(45), TWO(46) - 1, TWO(46), TWO(46) + 1,
    TWO(47) - 2, TWO(47) - 1, -TWO(47), -TWO(47) + 1,
    -TWO(46) - 1, -TWO(46), -TWO(46) + 1, INT64_C(0x555555555555),
};

enum {
    EDGE_EXPONENTS = sizeof edge_exponents / sizeof edge_exponents[0],
    EDGE_COEFFICIENTS = sizeof edge_coefficients
                        / sizeof edge_coefficients[0],
    EDGES = EDGE_EXPONENTS * EDGE_COEFFICIENTS
};

static c205_word edge(size_t i)
{
    return pack(edge_exponents[i / EDGE_COEFFICIENTS],
                edge_coefficients[i % EDGE_COEFFICIENTS]);
}

/* ---- Coefficients and words --------------------------------------------- */

/* Of either sign, with a number of significant bits; one in four with long
 * runs of zeros or of ones. */
static int64_t coefficient(uint64_t *random, int64_t digits)
{
    uint64_t bits = random_bits(random);
    const uint64_t choice = random_bits(random);

    if (choice % 8 == 0)
        bits &= random_bits(random) & random_bits(random);
    if (choice % 8 == 1)
        bits |= random_bits(random) | random_bits(random);
    if (digits == 0)
        return choice & 8 ? 0 : -1;
    const int64_t top = INT64_C(1) << (digits - 1);
    const int64_t magnitude = top | (int64_t)(bits & (uint64_t)(top - 1));
    return choice & 8 ? magnitude : ~magnitude;
}

static c205_word any_digits(uint64_t *random, int64_t exponent)
{
    return pack(exponent, coefficient(random, random_between(random, 0, 47)));
}

static c205_word normalised(uint64_t *random, int64_t exponent)
{
    return pack(exponent, coefficient(random, 47));
}

static int64_t usual_exponent(uint64_t *random)
{
    return random_between(random, -110, 20);
}

static int64_t clamp(int64_t exponent)
{
    return exponent < -28672 ? -28672 : exponent > 28671 ? 28671 : exponent;
}

c205_word random_word(uint64_t *random)
{
    const uint64_t bits = random_bits(random);

    return bits % 4 == 0 ? edge(bits / 4 % EDGES) : random_bits(random);
}

/* ---- Families of pairs -------------------------------------------------- */

typedef void family(uint64_t *random, c205_word *a, c205_word *b);

static void fast_path(uint64_t *random, c205_word *a, c205_word *b)
{
    *a = normalised(random, usual_exponent(random));
    *b = normalised(random, usual_exponent(random));
}

/* Exponents 0 to 100 apart, either way. */
static void aligned_normalised(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t exponent = usual_exponent(random);

    *a = normalised(random, exponent);
    *b = normalised(random, exponent + random_between(random, -100, 100));
}

static void aligned_unnormalised(uint64_t *random, c205_word *a,
                                 c205_word *b)
{
    const int64_t exponent = usual_exponent(random);

    *a = any_digits(random, exponent);
    *b = any_digits(random, exponent + random_between(random, -100, 100));
}

/* b is plus or minus a, or nearly. */
static void cancelling(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t exponent = usual_exponent(random);
    const int64_t c = coefficient(random, random_between(random, 20, 47));
    const int64_t near = random_between(random, -3, 3);
    const int64_t sign = random_bits(random) & 1 ? 1 : -1;
    const int64_t doubled = random_between(random, 0, 1);

    *a = pack(exponent, c);
    *b = pack(exponent + doubled, sign * (c / (1 + doubled)) + near);
}

/* The same value, or nearly, differently shifted. */
static void equal_values(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t digits = random_between(random, 1, 47);
    const int64_t places = random_between(random, 0, 47 - digits);
    const int64_t c = coefficient(random, digits);
    const int64_t exponent = usual_exponent(random);
    const int64_t near = random_between(random, -4, 4) / 4;

    *a = pack(exponent, c);
    *b = pack(exponent - places, c * (INT64_C(1) << places) + near);
}

static int64_t end_of_range(uint64_t *random)
{
    return random_bits(random) & 1 ? 28671 : -28672;
}

/* Results near the ends of the range: the exponents or their opposites add
 * up to about 28671 or -28672. */
static void extreme(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t end = end_of_range(random);
    const int64_t first = random_between(random, -28672, 28671);
    const int64_t second = end - first + random_between(random, -150, 150);
    const int64_t sign = random_bits(random) & 1 ? 1 : -1;

    *a = any_digits(random, first);
    *b = any_digits(random, clamp(sign * second));
}

static void extreme_sums(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t end = end_of_range(random);

    *a = any_digits(random, clamp(end + random_between(random, -99, 99)));
    *b = any_digits(random, clamp(end + random_between(random, -99, 99)));
}

static void extreme_normalised(uint64_t *random, c205_word *a, c205_word *b)
{
    extreme(random, a, b);
    *a = normalised(random, (int64_t)*a >> 48);
    *b = normalised(random, (int64_t)*b >> 48);
}

/* a is a square, or one off it. */
static void squares(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t root = random_between(random, 1, INT64_C(11863283));

    *a = pack(usual_exponent(random),
              root * root + random_between(random, -1, 1));
    *b = pack(usual_exponent(random), root);
}

/* a is a multiple of b, or one off it. */
static void multiples(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t digits = random_between(random, 1, 46);
    const int64_t divisor = coefficient(random, digits);
    const int64_t quotient = coefficient(random, 46 - digits);

    *a = pack(usual_exponent(random),
              divisor * quotient + random_between(random, -1, 1));
    *b = pack(usual_exponent(random), divisor);
}

/* b is a count to shift by. */
static void counts(uint64_t *random, c205_word *a, c205_word *b)
{
    *a = random_bits(random);
    *b = pack(0, random_between(random, -200, 200));
}

/* Numbers with a special among them here and there. */
static void sprinkled(uint64_t *random, c205_word *a, c205_word *b)
{
    fast_path(random, a, b);
    if (random_bits(random) % 8 == 0)
        *a = random_word(random);
    if (random_bits(random) % 8 == 0)
        *b = random_word(random);
}

/* As in vectors with gaps: nothing but normalised words and zeros. */
static void with_zeros(uint64_t *random, c205_word *a, c205_word *b)
{
    fast_path(random, a, b);
    if (random_bits(random) % 4 == 0)
        *a = C205_MACHINE_ZERO;
    if (random_bits(random) % 4 == 0)
        *b = C205_MACHINE_ZERO;
}

/* b is an exponent to be brought to, near that of a. */
static void other_exponents(uint64_t *random, c205_word *a, c205_word *b)
{
    const int64_t exponent = usual_exponent(random);

    *a = pack(exponent, random_between(random, -9, 9)
                            * (INT64_C(1) << random_between(random, 0, 43)));
    *b = pack(0, exponent + random_between(random, -50, 50));
}

static void anything(uint64_t *random, c205_word *a, c205_word *b)
{
    *a = random_word(random);
    *b = random_word(random);
}

static family *const families[] = {
    fast_path,    aligned_normalised, aligned_unnormalised, cancelling,
    equal_values, extreme,            extreme_sums,         extreme_normalised,
    squares,      multiples,          counts,               sprinkled,
    with_zeros,   other_exponents,    anything,
};

/* ---- The stream --------------------------------------------------------- */

enum { FAMILIES = sizeof families / sizeof families[0], BLOCK = EDGES };

struct operands operands_begin(uint64_t seed)
{
    return (struct operands){.random = seed, .position = 0};
}

/* One edge word with all of them; neighbouring blocks far apart, so that a
 * short run has seen a bit of everything. */
static void edge_pair(size_t block, size_t i, c205_word *a, c205_word *b)
{
    enum { STRIDE = 199 }; /* prime to EDGES */

    *a = edge(block * STRIDE % EDGES);
    *b = edge(i);
}

void operands_next(struct operands *operands, c205_word *a, c205_word *b,
                   size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const size_t at = operands->position++;
        const size_t block = at / BLOCK;
        if (block % 2 == 0 && block / 2 < EDGES)
            edge_pair(block / 2, at % BLOCK, a + i, b + i);
        else
            families[block / 2 % FAMILIES](&operands->random, a + i, b + i);
    }
}
