/* unit.h - defines and runs the tests of a program.
 *
 * TEST(name) begins the body of a test. The body may use `test_state`. The build
 * (main.awk) lists the tests of a file in the order of their definitions, and writes
 * the main function that runs them, so that no test can be left out.
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

#include "tests/scoped.h"
#include "vm/c205.h"

/* Undefines a macro of cmocka: asm/check/expect.h has a function of this name. */
#undef expect_check

#define COUNT(array) (sizeof(array) / sizeof *(array))

#define STATE void **test_state __attribute__((unused))

#define TEST(name) static void test_##name(STATE)

/* Fails the test with a message if the condition is true. */
#define FAIL_IF(condition, ...) \
    do { \
        if (condition) \
            fail_msg(__VA_ARGS__); \
    } while (0)

/* The error of the last failed call. */
static c205_error failure __attribute__((unused));

/* Fails the test with the message of `failure` or of an error if a value is false. */
#define REQUIRE(value) REQUIRE_OF(value, failure)
#define REQUIRE_OF(value, error) FAIL_IF(!(value), "%s", error.message)

/* Returns the pointer. Fails the test if it is NULL. */
#define NON_NULL(pointer) \
    ((__typeof__(pointer))non_null(pointer, #pointer, __FILE__, __LINE__))

static inline void *non_null(const void *pointer, const char *text, const char *file,
                             int line)
{
    if (!pointer)
        print_error("%s\n", failure.message);
    _assert_true(cast_ptr_to_largest_integral_type(pointer), text, file, line);
    return (void *)pointer;
}

/* Returns a text from printf, which is valid until 16 more texts are formatted. */
__attribute__((format(printf, 1, 2))) static inline const char *
formatted(const char *format, ...)
{
    static char texts[17][8192];
    static size_t count;
    char *text = texts[count++ % COUNT(texts)];
    va_list list;
    va_start(list, format);
    assert_in_range(vsnprintf(text, sizeof *texts, format, list), 0, sizeof *texts - 1);
    va_end(list);
    return text;
}

/* Defines a test that consists of one statement. */
#define TEST_CALL(name, statement) \
    static void test_##name(STATE) \
    { \
        statement; \
    }

/* Defines a test with functions before and after it, which may be NULL. */
#define TEST_WITH(name, before, after) \
    static const CMFixtureFunction before_##name = before, after_##name = after; \
    static void test_##name(STATE)

/* Begins a function that runs before or after tests. It returns 0 on success. */
#define FIXTURE(name) static int name(STATE)

/* Sets the functions that run before and after all tests of a file. It is at the end of
 * the file. A file without it uses the FILE_FIXTURES of the header that it includes. */
#define GROUP(before, after) \
    static const CMFixtureFunction before_all = before, after_all = after
#define FILE_FIXTURES NULL, NULL
#define RUN_TESTS(...) cmocka_run_group_tests_name(__VA_ARGS__)

/* Returns true if everything is tested, as by make check-long. Otherwise slow tests are
 * skipped, and a third of the random cases is used. */
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

/* Returns a numeric argument, or the default if there is no such argument. */
static inline uint64_t argument(int count, char **words, int place, uint64_t otherwise)
{
    return count > place ? strtoull(words[place], NULL, 0) : otherwise;
}

/* The first argument sets the number of cases. The second argument changes the seed. */
#define COUNT_AND_SEED(cases, seed) \
    ARGUMENTS(argc, argv) \
    { \
        cases = argument(argc, argv, 1, share_of(cases)); \
        seed ^= argument(argc, argv, 2, 0) << 13; \
    } \
    struct unit_end

#endif
