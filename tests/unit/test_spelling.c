/* test_spelling.c - the distance of two words is compared with its definition, and the
 * nearest of several names with the expected name. A distance that ignores a swap, or a
 * suggestion that is too distant, fails here. */
#include "base/spelling.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Computes the distance by its definition, starting with the first letters. */
static size_t plain(const char *a, const char *b)
{
    if (!*a || !*b)
        return strlen(a) + strlen(b);
    if (*a == *b)
        return plain(a + 1, b + 1);
    size_t d = 1 + least(plain(a + 1, b + 1), least(plain(a + 1, b), plain(a, b + 1)));
    if (a[0] == b[1] && a[1] == b[0])
        d = least(d, 1 + plain(a + 2, b + 2));
    return d;
}

static void some_word(uint64_t *seed, char word[7])
{
    size_t length = xorshift(seed) % 7, i;
    for (i = 0; i < length; i++)
        word[i] = (char)('a' + xorshift(seed) % 3);
    word[length] = '\0';
}

TEST(distance)
{
    uint64_t seed = RANDOM_SEED;
    char a[7], b[7];
    int i;
    for (i = 0; i < 3000; i++) {
        some_word(&seed, a);
        some_word(&seed, b);
        assert_int_equal(spelling_distance(a, strlen(a), b, strlen(b)), plain(a, b));
    }
    assert_int_equal(spelling_distance("ADDVN", 5, "addnv", 5), 1);
    assert_int_equal(spelling_distance("x", 65, "x", 1), 80);
}

static const char *of_these(const char *written)
{
    static const char *const names[] = { "ADDN", "ADDNV", "ES", "EX", "total", NULL };
    struct spelling nearest = { .word = written };
    size_t i;
    for (i = 0; names[i]; i++)
        spelling_try(&nearest, names[i]);
    return nearest.name;
}

TEST(nearest)
{
    assert_string_equal(of_these("ADDVN"), "ADDNV");
    assert_string_equal(of_these("addnv"), "ADDNV");
    assert_string_equal(of_these("ADN"), "ADDN");
    assert_string_equal(of_these("totla"), "total");
    assert_string_equal(of_these("EY"), "ES");
    assert_null(of_these("SUBX"));
    assert_null(of_these(""));
}
