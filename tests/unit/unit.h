/* unit.h - the tests of one program.
 *
 * TEST(name) begins the body of a test, in which `test_state` may be used.  The build
 * (main.awk) lists the tests of a file in the order of their definitions and
 * writes the main that runs them; no test can be left out.
 */
#ifndef TESTS_UNIT_H
#define TESTS_UNIT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tests/unit/scoped.h"

/* A function of asm/expect.h has this name; the macro of cmocka is not used. */
#undef expect_check

#define COUNT(array) (sizeof(array) / sizeof *(array))

#define STATE void **test_state __attribute__((unused))

#define TEST(name) static void test_##name(STATE)

/* Unless the value is true the test fails with the message of `error`. */
#define REQUIRE(value) \
    do { \
        if (!(value)) \
            fail_msg("%s", error.message); \
    } while (0)

/* A test of one statement. */
#define TEST_CALL(name, statement) \
    static void test_##name(STATE) \
    { \
        statement; \
    }

/* A test with functions that run before and after it; each may be NULL. */
#define TEST_WITH(name, before, after) \
    static const CMFixtureFunction before_##name = before, after_##name = after; \
    static void test_##name(STATE)

/* Such a function returns 0 if it succeeds. */
#define FIXTURE(name) static int name(STATE)

/* At the end of a file: the functions that run before and after all its tests. */
#define GROUP(before, after) \
    static const CMFixtureFunction before_all = before, after_all = after

/* Is the test to try all that it can, as in make check-long?  Else it leaves out what
 * takes long, or draws a third of its random cases. */
static inline bool thorough(void)
{
    return getenv("THOROUGH") != NULL;
}

static inline size_t share_of(size_t all)
{
    return thorough() ? all : (all + 2) / 3;
}

/* Begins a function that reads the arguments of the program. */
#define ARGUMENTS(count, words) static void read_arguments(int count, char **words)

/* The number that is the argument at a place; without one, the default. */
static inline uint64_t argument(int count, char **words, int place, uint64_t otherwise)
{
    return count > place ? strtoull(words[place], NULL, 0) : otherwise;
}

/* The first argument replaces a number of cases, the second one changes a seed. */
#define COUNT_AND_SEED(cases, seed) \
    ARGUMENTS(argc, argv) \
    { \
        cases = argument(argc, argv, 1, share_of(cases)); \
        seed ^= argument(argc, argv, 2, 0) << 13; \
    } \
    struct unit_end

#endif
