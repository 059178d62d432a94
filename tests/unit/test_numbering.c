/* test_numbering.c - numbers that are counted anew: each once, in their order. */
#include "base/numbering.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

enum { MAX = 40, TRIES = 300 };

TEST(few)
{
    struct numbering numbering;

    assert_true(numbering_begin(&numbering, 3));
    numbering_add(&numbering, 70);
    numbering_add(&numbering, 20);
    numbering_add(&numbering, 70);
    numbering_settle(&numbering);
    assert_int_equal(numbering.count, 2);
    assert_int_equal(numbering_place(&numbering, 20), 1);
    assert_int_equal(numbering_place(&numbering, 70), 2);
    assert_int_equal(numbering_place(&numbering, 50), 0);
    numbering_free(&numbering);
    assert_true(numbering_begin(&numbering, 0));
    numbering_settle(&numbering);
    assert_int_equal(numbering_place(&numbering, 0), 0);
    numbering_free(&numbering);
}

/* A place is how many other numbers are not above. */
static size_t place_of(const size_t *numbers, size_t count, size_t number)
{
    size_t place = 0, found = 0;

    for (size_t i = 0; i < count; i++) {
        size_t before = 0;
        while (before < i && numbers[before] != numbers[i])
            before++;
        place += before == i && numbers[i] <= number;
        found += numbers[i] == number;
    }
    return found > 0 ? place : 0;
}

TEST(random)
{
    uint64_t random = RANDOM_SEED;

    for (int try = 0; try < TRIES; try++) {
        size_t numbers[MAX], count = xorshift(&random) % (MAX + 1);
        struct numbering numbering;

        assert_true(numbering_begin(&numbering, count));
        for (size_t i = 0; i < count; i++) {
            numbers[i] = xorshift(&random) % (try % 2 ? 30 : SIZE_MAX);
            numbering_add(&numbering, numbers[i]);
        }
        numbering_settle(&numbering);
        for (size_t i = 0; i < count; i++)
            assert_int_equal(numbering_place(&numbering, numbers[i]),
                             place_of(numbers, count, numbers[i]));
        for (size_t i = 0; i < 30; i++)
            assert_int_equal(numbering_place(&numbering, i),
                             place_of(numbers, count, i));
        numbering_free(&numbering);
    }
}
