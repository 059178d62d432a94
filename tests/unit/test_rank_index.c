/* test_rank_index.c - the ranks of numbers are compared with their definition, over
 * random lists with repetitions, some of which are empty. A number with another rank,
 * or a missing number that has a rank, fails here. */
#include "base/rank_index.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

enum { MAX = 40, TRIES = 300 };

/* The rank of a number is the number of distinct numbers up to it. */
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
        size_t numbers[MAX], count = xorshift(&random) % (MAX + 1), largest = 0;
        SCOPED_VALUE(rank_index) ranks;
        assert_true(rank_index_begin(&ranks, count));
        for (size_t i = 0; i < count; i++) {
            numbers[i] = xorshift(&random) % (try % 2 ? 30 : SIZE_MAX);
            rank_index_add(&ranks, numbers[i]);
            largest = numbers[i] > largest ? numbers[i] : largest;
        }
        rank_index_sort(&ranks);
        assert_int_equal(ranks.count, place_of(numbers, count, largest));
        for (size_t i = 0; i < count; i++)
            assert_int_equal(rank_index_place(&ranks, numbers[i]),
                             place_of(numbers, count, numbers[i]));
        for (size_t i = 0; i < 30; i++)
            assert_int_equal(rank_index_place(&ranks, i), place_of(numbers, count, i));
    }
}
