/* operands.c - generates all pairs of edge words and random families of pairs. */
#include "operands.h"

/* splitmix64: Steele, Lea, Flood, "Fast splittable pseudorandom generators", 2014. */
uint64_t random_bits(uint64_t *random)
{
    uint64_t z = *random += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

int64_t random_between(uint64_t *random, int64_t low, int64_t high)
{
    uint64_t span = (uint64_t)(high - low) + 1;
    return low + (int64_t)(random_bits(random) % span);
}

/* The format and the random numbers of a family. */
struct draw {
    const struct oracle_format *format;
    uint64_t *random;
};

static bool one_in(struct draw draw, uint64_t n)
{
    return random_bits(draw.random) % n == 0;
}

static int64_t between(struct draw draw, int64_t low, int64_t high)
{
    return random_between(draw.random, low, high);
}

static c205_word pack(const struct oracle_format *format, int64_t exponent,
                      int64_t coefficient)
{
    long exponent_bits = format->width - format->digits - 1;
    return (c205_word)exponent << (64 - exponent_bits)
           | (c205_word)coefficient << (63 - format->digits) >> exponent_bits;
}

/* ---- The edges ---------------------------------------------------------- */

static int64_t two(int64_t n)
{
    return INT64_C(1) << n;
}

/* clang-format off */
/* An exponent relative to an exponent of the format. The distance is `digits` times the
 * digits of the format, plus `more`. */
static const struct {
    enum { FIRST, SMALLEST, NOUGHT, LARGEST, LAST } beside;
    int64_t digits, more;
} edge_exponents[] = {
    /* machine zeros, indefinites */
    {FIRST, 0, 0}, {FIRST, 0, 1}, {SMALLEST, 0, -1}, {LARGEST, 0, 1},
    {LAST, 0, 0},
    /* the largest and the smallest numbers */
    {LARGEST, 0, 0}, {LARGEST, 0, -1}, {LARGEST, -1, 0}, {SMALLEST, 0, 0},
    {SMALLEST, 0, 1}, {SMALLEST, 1, -1}, {SMALLEST, 1, 0},
    /* integers, and numbers just outside them */
    {NOUGHT, -1, -1}, {NOUGHT, -1, 0}, {NOUGHT, -1, 1}, {NOUGHT, -1, 2},
    {NOUGHT, 0, -1}, {NOUGHT, 0, 0}, {NOUGHT, 0, 1}, {NOUGHT, 1, 0},
};
/* clang-format on */

/* clang-format off */
/* Coefficients times * 2^(digits * halves / 2 + places) + more. */
static const struct {
    int64_t times, halves, places, more;
} edge_coefficients[] = {
    {0, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0, -1}, {0, 0, 0, 2}, {0, 0, 0, -2},
    {0, 0, 0, 3}, {0, 0, 0, -3}, {0, 0, 0, 5},
    {1, 1, 0, 0}, {-1, 1, 0, 0}, {1, 1, 1, -1},
    {1, 2, -2, 0}, {-1, 2, -2, 0},
    {1, 2, -1, -1}, {1, 2, -1, 0}, {1, 2, -1, 1},
    {-1, 2, -1, -1}, {-1, 2, -1, 0}, {-1, 2, -1, 1},
    {1, 2, 0, -2}, {1, 2, 0, -1}, {-1, 2, 0, 0}, {-1, 2, 0, 1},
    {3, 2, -2, -1},
};
/* clang-format on */

enum {
    EDGE_EXPONENTS = sizeof edge_exponents / sizeof edge_exponents[0],
    EDGE_COEFFICIENTS = sizeof edge_coefficients / sizeof edge_coefficients[0],
    EDGES = EDGE_EXPONENTS * EDGE_COEFFICIENTS
};

static int64_t edge_exponent(const struct oracle_format *format, size_t i)
{
    int64_t past = two(format->width - format->digits - 2);
    const int64_t places[] = { [FIRST] = -past,
                               [SMALLEST] = format->exponent_min,
                               [NOUGHT] = 0,
                               [LARGEST] = format->exponent_max,
                               [LAST] = past - 1 };
    return places[edge_exponents[i].beside] + edge_exponents[i].digits * format->digits
           + edge_exponents[i].more;
}

static int64_t edge_coefficient(const struct oracle_format *format, size_t i)
{
    int64_t power = edge_coefficients[i].halves * format->digits / 2
                    + edge_coefficients[i].places;
    return edge_coefficients[i].times * two(power) + edge_coefficients[i].more;
}

static c205_word edge(const struct oracle_format *format, size_t i)
{
    return pack(format, edge_exponent(format, i / EDGE_COEFFICIENTS),
                edge_coefficient(format, i % EDGE_COEFFICIENTS));
}

/* ---- Coefficients and words --------------------------------------------- */

/* Returns a coefficient of either sign with this number of significant bits. One in
 * four has long runs of zeros or ones. */
static int64_t coefficient(struct draw draw, int64_t digits)
{
    uint64_t bits = random_bits(draw.random);
    uint64_t choice = random_bits(draw.random);
    if (choice % 8 == 0)
        bits &= random_bits(draw.random) & random_bits(draw.random);
    if (choice % 8 == 1)
        bits |= random_bits(draw.random) | random_bits(draw.random);
    if (digits == 0)
        return choice & 8 ? 0 : -1;
    int64_t top = two(digits - 1);
    int64_t magnitude = top | (int64_t)(bits & (uint64_t)(top - 1));
    return choice & 8 ? magnitude : ~magnitude;
}

static int64_t any_coefficient(struct draw draw)
{
    return coefficient(draw, between(draw, 0, draw.format->digits));
}

static c205_word any_digits(struct draw draw, int64_t exponent)
{
    return pack(draw.format, exponent, any_coefficient(draw));
}

static c205_word normalised(struct draw draw, int64_t exponent)
{
    return pack(draw.format, exponent, coefficient(draw, draw.format->digits));
}

/* Returns an exponent of values around one, which is far from the ends of the range. */
static int64_t usual_exponent(struct draw draw)
{
    int64_t digits = draw.format->digits;
    return between(draw, -2 * digits - 16, digits / 2 - 3);
}

/* Returns a difference of exponents, which may exceed the digits of a sum. */
static int64_t difference(struct draw draw)
{
    int64_t past = 2 * draw.format->digits + 6;
    return between(draw, -past, past);
}

static int64_t clamp(struct draw draw, int64_t exponent)
{
    return exponent < draw.format->exponent_min   ? draw.format->exponent_min
           : exponent > draw.format->exponent_max ? draw.format->exponent_max
                                                  : exponent;
}

c205_word random_word(const struct oracle_format *format, uint64_t *random)
{
    uint64_t bits = random_bits(random);
    long unused = 64 - format->width;
    return bits % 4 == 0 ? edge(format, bits / 4 % EDGES)
                         : random_bits(random) >> unused << unused;
}

/* ---- Families of pairs -------------------------------------------------- */

typedef void family(struct draw draw, c205_word *a, c205_word *b);

static void fast_path(struct draw draw, c205_word *a, c205_word *b)
{
    *a = normalised(draw, usual_exponent(draw));
    *b = normalised(draw, usual_exponent(draw));
}

static void aligned_normalised(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t exponent = usual_exponent(draw);
    *a = normalised(draw, exponent);
    *b = normalised(draw, exponent + difference(draw));
}

static void aligned_unnormalised(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t exponent = usual_exponent(draw);
    *a = any_digits(draw, exponent);
    *b = any_digits(draw, exponent + difference(draw));
}

/* b is nearly or exactly a or -a. */
static void cancelling(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t most = draw.format->digits;
    int64_t exponent = usual_exponent(draw);
    int64_t c = coefficient(draw, between(draw, most / 2 - 3, most));
    int64_t near = between(draw, -3, 3);
    int64_t sign = one_in(draw, 2) ? 1 : -1;
    int64_t doubled = between(draw, 0, 1);
    *a = pack(draw.format, exponent, c);
    *b = pack(draw.format, exponent + doubled, sign * (c / (1 + doubled)) + near);
}

/* a and b have different exponents, but nearly or exactly the same value. */
static void equal_values(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t digits = between(draw, 1, draw.format->digits);
    int64_t places = between(draw, 0, draw.format->digits - digits);
    int64_t c = coefficient(draw, digits);
    int64_t exponent = usual_exponent(draw);
    int64_t near = between(draw, -4, 4) / 4;
    *a = pack(draw.format, exponent, c);
    *b = pack(draw.format, exponent - places, c * two(places) + near);
}

static int64_t end_of_range(struct draw draw)
{
    return one_in(draw, 2) ? draw.format->exponent_max : draw.format->exponent_min;
}

/* Makes results near the ends of the range: the sum or the difference of the exponents
 * is near the largest or the smallest exponent. */
static void extreme_exponents(struct draw draw, int64_t *a, int64_t *b)
{
    const struct oracle_format *format = draw.format;
    int64_t end = end_of_range(draw);
    int64_t past = 3 * format->digits + 9;
    int64_t sign = one_in(draw, 2) ? 1 : -1;
    *a = between(draw, format->exponent_min, format->exponent_max);
    *b = clamp(draw, sign * (end - *a + between(draw, -past, past)));
}

static void extreme(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t first, second;
    extreme_exponents(draw, &first, &second);
    *a = any_digits(draw, first);
    *b = any_digits(draw, second);
}

static void extreme_normalised(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t first, second;
    extreme_exponents(draw, &first, &second);
    *a = normalised(draw, first);
    *b = normalised(draw, second);
}

static void extreme_sums(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t end = end_of_range(draw);
    int64_t first = clamp(draw, end + difference(draw));
    int64_t second = clamp(draw, end + difference(draw));
    *a = any_digits(draw, first);
    *b = any_digits(draw, second);
}

/* a is a square, or differs from it by one. Roots are less than that of 2^digits. */
static void squares(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t last = two(draw.format->digits / 2) * 1414 / 1000;
    int64_t root = between(draw, 1, last);
    int64_t near = between(draw, -1, 1);
    *a = pack(draw.format, usual_exponent(draw), root * root + near);
    *b = pack(draw.format, usual_exponent(draw), root);
}

/* a is a multiple of b, or differs from a multiple by one. */
static void multiples(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t most = draw.format->digits - 1;
    int64_t digits = between(draw, 1, most);
    int64_t divisor = coefficient(draw, digits);
    int64_t quotient = coefficient(draw, most - digits);
    int64_t near = between(draw, -1, 1);
    *a = pack(draw.format, usual_exponent(draw), divisor * quotient + near);
    *b = pack(draw.format, usual_exponent(draw), divisor);
}

/* Generates a random word and a shift count. */
static void counts(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t most = 3 * draw.format->width + 8;
    *a = random_word(draw.format, draw.random);
    *b = pack(draw.format, 0, between(draw, -most, most));
}

/* Generates operands of the fast path. One word in eight is of any kind. */
static void sprinkled(struct draw draw, c205_word *a, c205_word *b)
{
    fast_path(draw, a, b);
    if (one_in(draw, 8))
        *a = random_word(draw.format, draw.random);
    if (one_in(draw, 8))
        *b = random_word(draw.format, draw.random);
}

/* Makes only normalised words and zeros, as in vectors with gaps. */
static void with_zeros(struct draw draw, c205_word *a, c205_word *b)
{
    fast_path(draw, a, b);
    if (one_in(draw, 4))
        *a = C205_MACHINE_ZERO;
    if (one_in(draw, 4))
        *b = C205_MACHINE_ZERO;
}

/* b is an exponent near the exponent of a, for an adjustment. */
static void other_exponents(struct draw draw, c205_word *a, c205_word *b)
{
    int64_t digits = draw.format->digits;
    int64_t exponent = usual_exponent(draw);
    int64_t digit = between(draw, -9, 9);
    int64_t places = between(draw, 0, digits - 4);
    int64_t distance = between(draw, -digits - 3, digits + 3);
    *a = pack(draw.format, exponent, digit * two(places));
    *b = pack(draw.format, 0, exponent + distance);
}

/* The part of a that is removed for a half word is about half of a unit. The half words
 * are near the ends of their range. */
static void nearly_halves(struct draw draw, c205_word *a, c205_word *b)
{
    const struct oracle_format *format = draw.format;
    long cut = format->digits / 2 + 1;
    int64_t end = end_of_range((struct draw){ &oracle_half, draw.random });
    int64_t exponent = end - cut + between(draw, -3, 3);
    int64_t above = any_coefficient(draw) >> cut;
    int64_t near = between(draw, -2, 2);
    *a = pack(format, exponent, above * two(cut) + two(cut - 1) + near);
    *b = any_digits(draw, exponent);
}

static void anything(struct draw draw, c205_word *a, c205_word *b)
{
    *a = random_word(draw.format, draw.random);
    *b = random_word(draw.format, draw.random);
}

static family *const families[] = {
    fast_path, aligned_normalised, aligned_unnormalised, cancelling,      equal_values,
    extreme,   extreme_sums,       extreme_normalised,   squares,         multiples,
    counts,    sprinkled,          with_zeros,           other_exponents, nearly_halves,
    anything,
};

/* ---- The stream --------------------------------------------------------- */

enum { FAMILIES = sizeof families / sizeof families[0], BLOCK = EDGES };

struct operands operands_begin(const struct oracle_format *format, uint64_t seed)
{
    return (struct operands){ .format = format, .random = seed };
}

/* Pairs one edge word with all edge words. Successive blocks use distant edge words, so
 * that a short run covers all kinds. */
static void edge_pair(const struct oracle_format *format, size_t block, size_t i,
                      c205_word *a, c205_word *b)
{
    enum { STRIDE = 199 }; /* no common divisor with EDGES */
    *a = edge(format, block * STRIDE % EDGES);
    *b = edge(format, i);
}

void operands_next(struct operands *operands, c205_word *a, c205_word *b, size_t n)
{
    const struct draw draw = { operands->format, &operands->random };
    for (size_t i = 0; i < n; i++) {
        size_t at = operands->position++;
        size_t block = at / BLOCK;
        if (block % 2 == 0 && block / 2 < EDGES)
            edge_pair(draw.format, block / 2, at % BLOCK, a + i, b + i);
        else
            families[block / 2 % FAMILIES](draw, a + i, b + i);
    }
}
