/* test_accounts.c - the tables and CSV of random accounts are compared with the
 * accounts themselves. A matrix whose sums differ, that has an empty row or column, or
 * that is wider than a page fails here. */
#include <inttypes.h>
#include <math.h>

#include "base/accounts_show.h"
#include "base/word_wrap.h"
#include "tests/unit/prior_model.h"

enum { MAX_REGIONS = 20, TRIES = 300 };

static unsigned seed = 205;

static unsigned any(unsigned below)
{
    seed = seed * 1103515245u + 12345u;
    return (seed >> 16) % below;
}

/* Returns accounts of regions "r0".. with some clocks below a random power of two. */
static struct accounts random_accounts(void)
{
    struct accounts accounts = { .model = prior_model };
    unsigned regions = 1 + any(MAX_REGIONS), scale = 1u << any(24);
    unsigned causes = any(1u << C205_CAUSES);
    for (unsigned i = 0; i < regions; i++) {
        char name[C205_TEXT_SIZE] = "";
        c205_account account = { .name = name };
        snprintf(name, sizeof name, "r%u%.*s", i, (int)any(9), "_of_many");
        for (int cause = 0; any(5) > 0 && cause < C205_CAUSES; cause++)
            account.clocks[cause] = (causes >> cause & 1) * any(3) * any(scale);
        if (accounts_clocks(&account) > 0) {
            account.instructions = 1 + any(1000);
            account.entries = 1 + any(100);
            account.vector_instructions = any(2) * account.instructions;
            account.elements = account.vector_instructions * any(100);
            account.operations = account.elements + any(50);
        }
        assert_true(accounts_add_account(&accounts, &account));
    }
    return accounts;
}

/* Returns the value of a cell; an empty cell is 0. */
static double cell(const struct table *table, size_t row, size_t column)
{
    double value = table_value(table, row, column);
    return isnan(value) ? 0 : value;
}

static void assert_near(double a, double b)
{
    FAIL_IF(!(fabs(a - b) <= 1e-9 * (1 + fabs(b))), "%.17g is not %.17g", a, b);
}

static double in_unit(const struct accounts *accounts, uint64_t clocks)
{
    const struct accounts_unit *unit = accounts_unit(
        accounts_seconds(prior_model, accounts->clocks));
    return accounts_seconds(prior_model, clocks) * unit->per_second;
}

/* A matrix whose rows are causes or regions. The functions below have the row first and
 * the column second, as in this view. */
struct view {
    const struct table *table;
    bool causes_down;
};

static double at(struct view view, size_t line, size_t place)
{
    return view.causes_down ? cell(view.table, line, place)
                            : cell(view.table, place, line + 1);
}

static void check_place(struct view view, const struct accounts *accounts,
                        const c205_account *sum, const c205_account *account,
                        size_t place)
{
    size_t line = 0;
    double all = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        if (sum->clocks[cause] > 0) {
            double value = at(view, line++, place);
            assert_near(value, in_unit(accounts, account->clocks[cause]));
            all += value;
        }
    }
    assert_near(at(view, line, place), all);
    line += view.causes_down ? 1 : 2;
    assert_near(at(view, line++, place), (double)account->instructions);
    if (sum->vector_instructions > 0)
        assert_near(at(view, line++, place), (double)account->vector_instructions);
    if (sum->elements > 0) {
        assert_near(at(view, line++, place),
                    account->vector_instructions > 0
                        ? (double)account->elements
                              / (double)account->vector_instructions
                        : 0);
    }
    if (sum->operations > 0) {
        double seconds = accounts_seconds(prior_model, accounts_clocks(account));
        assert_near(at(view, line, place), (double)account->operations / seconds / 1e6);
    }
}

/* Fails unless the matrix has the accounts' values and no row or column of zeros. */
static void check_matrix(const struct accounts *accounts, enum accounts_rows rows)
{
    c205_account sum = accounts_together(accounts);
    SCOPED(table) *table = NON_NULL(accounts_matrix(accounts, rows, 0, MAX_REGIONS));
    size_t regions = accounts_regions(accounts), place = 0, used = 0;
    struct view view = { table, rows == ACCOUNTS_CAUSES };
    size_t figures = 1u + (sum.vector_instructions > 0) + (sum.elements > 0)
                     + (sum.operations > 0);
    for (int cause = 0; cause < C205_CAUSES; cause++)
        used += sum.clocks[cause] > 0;
    size_t rows_of_regions = regions > 1 ? regions + 1 : 1;
    assert_int_equal(table_rows(table),
                     view.causes_down ? used + 1 + figures : rows_of_regions);
    for (size_t i = 0; regions > 1 && i < accounts->count; i++) {
        if (accounts_clocks(&accounts->items[i]) > 0) {
            check_place(view, accounts, &sum, &accounts->items[i],
                        view.causes_down ? 3 + place : place);
            place++;
        }
    }
    check_place(view, accounts, &sum, &sum, view.causes_down ? 1 : place);
}

TEST(matrices_add_up)
{
    for (int i = 0; i < TRIES; i++) {
        SCOPED_VALUE(accounts) accounts = random_accounts();
        if (accounts.clocks > 0) {
            check_matrix(&accounts, ACCOUNTS_CAUSES);
            check_matrix(&accounts, ACCOUNTS_REGIONS);
        }
    }
}

/* Writes the accounts in a format. The caller frees the text. */
static void show(const struct accounts *accounts, enum output_format format,
                 char **text)
{
    size_t size;
    FILE *file = NON_NULL(open_memstream(text, &size));
    struct command_output results = { .format = format, .file = file };
    assert_int_equal(accounts_show(accounts, &results), CMD_DONE);
    assert_int_equal(fclose(file), 0);
}

static size_t times_in(const char *text, const char *word)
{
    size_t count = 0, length = strlen(word);
    for (const char *found = text; (found = strstr(found, word)); found += length) {
        count += strchr(" \n", found[length]) != NULL
                 && (found == text || strchr(" \n", found[-1]));
    }
    return count;
}

/* In either layout, each region with clocks occurs once, and no other region occurs. No
 * line is longer than a page is wide. */
TEST(matrices_are_narrow)
{
    for (int i = 0; i < TRIES; i++) {
        SCOPED_VALUE(accounts) accounts = random_accounts();
        size_t regions = accounts_regions(&accounts);
        FREED char *text = NULL;
        show(&accounts, OUTPUT_TEXT, &text);
        for (const char *line = text; *line;) {
            size_t length = strcspn(line, "\n");
            assert_in_range(length, 0, WORD_WRAP_WIDTH);
            line += length + 1;
        }
        for (size_t k = 0; k < accounts.count; k++) {
            const c205_account *account = &accounts.items[k];
            assert_int_equal(times_in(text, account->name),
                             regions > 1 && accounts_clocks(account) > 0);
        }
    }
}

/* Fails unless the row continues with the clocks' seconds and percentage. */
static void check_share(const struct accounts *accounts, const char *text,
                        const char *row, uint64_t clocks)
{
    double all = (double)accounts->clocks;
    const char *found = NON_NULL(strstr(text, row));
    char *end;
    assert_near(strtod(found + strlen(row), &end),
                accounts_seconds(prior_model, clocks));
    assert_int_equal(*end, ',');
    assert_near(strtod(end + 1, &end), all > 0 ? 100 * (double)clocks / all : 0);
    assert_int_equal(*end, '\n');
}

/* The CSV has the exact clocks. */
TEST(csv_is_exact)
{
    for (int i = 0; i < TRIES; i++) {
        SCOPED_VALUE(accounts) accounts = random_accounts();
        FREED char *text = NULL;
        show(&accounts, OUTPUT_CSV, &text);
        for (size_t k = 0; k < accounts.count; k++) {
            const c205_account *account = &accounts.items[k];
            uint64_t clocks = accounts_clocks(account);
            const char *row = formatted("\n%s,%" PRIu64 ",%" PRIu64 ",%" PRIu64
                                        ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",",
                                        account->name, account->entries,
                                        account->instructions,
                                        account->vector_instructions, account->elements,
                                        account->operations, clocks);
            check_share(&accounts, text, row, clocks);
        }
    }
}

static void assert_twice(const c205_account *twice, const c205_account *once)
{
    for (int cause = 0; cause < C205_CAUSES; cause++)
        assert_int_equal(twice->clocks[cause], 2 * once->clocks[cause]);
    assert_int_equal(twice->instructions, 2 * once->instructions);
    assert_int_equal(twice->vector_instructions, 2 * once->vector_instructions);
    assert_int_equal(twice->elements, 2 * once->elements);
    assert_int_equal(twice->operations, 2 * once->operations);
    assert_int_equal(twice->entries, 2 * once->entries);
}

/* Adding a run to itself doubles the clocks of each region, and adds no region. */
TEST(runs_add_up)
{
    for (int i = 0; i < TRIES; i++) {
        SCOPED_VALUE(accounts) once = random_accounts();
        SCOPED_VALUE(accounts) twice = { .model = prior_model };
        for (size_t k = 0; k < 2 * once.count; k++)
            assert_true(accounts_add_account(&twice, &once.items[k % once.count]));
        assert_int_equal(twice.count, once.count);
        assert_int_equal(twice.clocks, 2 * once.clocks);
        for (size_t k = 0; k < once.count; k++)
            assert_twice(accounts_find(&twice, once.items[k].name), &once.items[k]);
    }
}

/* Times are printed in the shortest unit. A clock is 20 ns. */
TEST(times_are_short)
{
    static const struct {
        uint64_t clocks;
        const char *text;
    } times[] = {
        { 0, "0.00 us" },          { 1, "0.02 us" },
        { 1139, "22.78 us" },      { 499999, "9999.98 us" },
        { 500000, "10.000 ms" },   { 499999999, "10000.000 ms" },
        { 500000000, "10.000 s" }, { 50000000000, "1000.000 s" },
    };
    for (size_t i = 0; i < COUNT(times); i++) {
        char text[ACCOUNTS_TIME];
        accounts_time(prior_model, times[i].clocks, text);
        assert_string_equal(text, times[i].text);
    }
}
