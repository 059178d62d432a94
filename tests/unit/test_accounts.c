/* test_accounts.c - the accounts of several runs as one, by cause and by
 * region. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "base/accounts.h"

static c205_account account(const char *name, uint64_t scale)
{
    c205_account made = { .name = name,
                          .instructions = 30 * scale,
                          .vector_instructions = 7 * scale,
                          .elements = 500 * scale,
                          .entries = 2 * scale };

    made.clocks[C205_ISSUE] = 60 * scale;
    made.clocks[C205_MEMORY_WAIT] = 15 * scale;
    return made;
}

/* The cell of a row in the column with a key. */
static double cell(const struct table *table, size_t row, const char *key)
{
    size_t column = 0;

    while (strcmp(table_key(table, column), key) != 0)
        column++;
    return table_value(table, row, column);
}

static void check(double found, double expected)
{
    if (!(fabs(found - expected) <= 1e-12 * expected))
        fail_msg("%.17g, expected %.17g", found, expected);
}

static void add_all(struct accounts *accounts)
{
    const c205_account runs[] = { account("one", 1), account("two", 2),
                                  account("one", 4), account("", 3) };

    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++)
        assert_true(accounts_add_account(accounts, &runs[i]));
}

static void check_row(const struct table *table, size_t row, double scale)
{
    check(cell(table, row, "entries"), 2 * scale);
    check(cell(table, row, "instructions"), 30 * scale);
    check(cell(table, row, "vector_instructions"), 7 * scale);
    check(cell(table, row, "elements"), 500 * scale);
    check(cell(table, row, "clocks"), 75 * scale);
    check(cell(table, row, "seconds"), 75 * scale * 20e-9);
    check(cell(table, row, "percent"), 10 * scale);
}

static void regions_are_summed(void **state)
{
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe-prior", &error);
    struct accounts accounts = { .model = model };

    (void)state;
    add_all(&accounts);
    struct table *table = accounts_by_region(&accounts);
    assert_int_equal(table_rows(table), 3);
    check_row(table, 0, 5);
    check_row(table, 1, 2);
    check_row(table, 2, 3);
    table_free(table);
    accounts_free(&accounts);
    c205_model_free(model);
}

/* The run's own rows, then three regions with as many. */
static void causes_are_summed(void **state)
{
    static const double scales[] = { 10, 5, 2, 3 };
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe-prior", &error);
    struct accounts accounts = { .model = model };

    (void)state;
    add_all(&accounts);
    struct table *table = accounts_by_cause(&accounts);
    assert_int_equal(table_rows(table), 12);
    for (size_t i = 0; i < 4; i++) {
        check(cell(table, 3 * i, "clocks"), 75 * scales[i]);
        check(cell(table, 3 * i, "percent"), 10 * scales[i]);
        check(cell(table, 3 * i + 1, "clocks")
                  + cell(table, 3 * i + 2, "clocks"),
              75 * scales[i]);
        check(cell(table, 3 * i + 2, "percent"), 2 * scales[i]);
    }
    table_free(table);
    accounts_free(&accounts);
    c205_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(regions_are_summed),
                                        cmocka_unit_test(causes_are_summed) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
