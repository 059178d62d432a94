/* test_included_numbers.c - words of number files that are included as data are
 * compared with random tables in all permitted notations, and reports about invalid
 * files with expected reports. A skipped number or an accepted error fails here. */
#include <inttypes.h>

#include "tests/oracle/chance.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/scene_reading.h"

enum { TRIES = 300, ROWS = 12, COLUMNS = 5, TEXT = 8000 };

static uint64_t state = RANDOM_SEED;
static const char path[] = "test_numbers.tmp";

struct random_table {
    size_t rows, columns;
    bool integers, commas;
    c205_word words[ROWS][COLUMNS];
    char text[TEXT];
};

static void add_blanks(struct random_table *table)
{
    static const char *const blanks[] = { "", "", " ", "\t", "  " };
    strcat(table->text, blanks[below(&state, 5)]);
}

static void add_separator(struct random_table *table)
{
    add_blanks(table);
    strcat(table->text, table->commas ? "," : " ");
    add_blanks(table);
}

static void end_line(struct random_table *table)
{
    static const char *const ends[] = { "\n",   "\n",     "\r\n",      " # 1, 2\n",
                                        "\n\n", "\n  \n", "\n# a, b\n" };
    add_blanks(table);
    strcat(table->text, ends[below(&state, 7)]);
}

static void draw_table(struct random_table *table, bool headed)
{
    table->rows = below(&state, ROWS + 1);
    table->columns = below(&state, COLUMNS) + 1;
    table->integers = one_in(&state, 2);
    table->commas = table->columns > 1 && one_in(&state, 2);
    *table->text = '\0';
    if (one_in(&state, 5))
        strcat(table->text, "\xEF\xBB\xBF");
    if (one_in(&state, 3))
        strcat(table->text, "# a table\n");
    for (size_t i = 0; headed && i < table->columns; i++) {

        const char *name = formatted(one_in(&state, 2) ? "\"c %zu\""
                                     : table->commas   ? "c %zu"
                                                       : "\"c %zu\"",
                                     i + 1);
        strcat(table->text, name);
        if (i + 1 < table->columns)
            add_separator(table);
        else
            end_line(table);
    }
    for (size_t row = 0; row < table->rows; row++) {
        for (size_t i = 0; i < table->columns; i++) {
            c205_word *word = &table->words[row][i];
            char number[60];
            const char *end;
            if (table->integers) {
                int64_t integer = xorshift_between(&state, -1000000, 1000000);
                snprintf(number, sizeof number,
                         one_in(&state, 4) ? "%" PRId64 ".0" : "%" PRId64, integer);
                *word = c205_from_integer(integer);
            } else {
                snprintf(number, sizeof number, "%.*g", (int)below(&state, 17) + 1,
                         between(&state, -1, 1) * of_any_size(&state, 1e-30, 1e30));
                *word = c205_from_text(number, &end);
            }
            strcat(table->text, number);
            if (i + 1 < table->columns)
                add_separator(table);
        }
        end_line(table);
    }
}

static struct object *include_file(const char *expectations, struct diagnostics *errors)
{
    const char
        *program = formatted("        .data\nhere:   .incfile \"%s\"%s\nend:\n"
                             "        .equ count, (end - here) / 64\n        .code\n"
                             "        EXIT\n",
                             path, expectations);
    return assemble_text("test.s", program, NULL, errors);
}

static void check_words(const struct random_table *table, const char *expectations,
                        size_t column)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    SCOPED(object) *object = include_file(expectations, &errors);
    uint64_t at = 0x800000;
    FAIL_IF(!object, "%s, of\n%s", errors.items[0].message, table->text);
    for (size_t k = 0; k < table->rows * table->columns; k++) {
        size_t row = k / table->columns, i = k % table->columns;
        if (column && column != i + 1)
            continue;
        FAIL_IF(word_of(&object->program, at) != table->words[row][i],
                "row %zu, column %zu%s of\n%s", row, i + 1, expectations, table->text);
        at += 64;
    }
    assert_int_equal(object_symbol(object, "count")->value, (at - 0x800000) / 64);
}

TEST(tables)
{
    static struct random_table table;
    for (int i = 0; i < TRIES; i++) {
        bool headed = one_in(&state, 2);
        char expectations[60];
        draw_table(&table, headed);
        write_bytes(path, table.text, strlen(table.text));
        check_words(&table, table.integers ? ", integers" : "", 0);
        size_t column = below(&state, table.columns) + 1;
        snprintf(expectations, sizeof expectations, ", %zu%s", column,
                 table.integers ? ", integers" : "");
        check_words(&table, expectations, column);
        if (headed) {
            snprintf(expectations, sizeof expectations, "%s, \"c %zu\"",
                     table.integers ? ", integers" : "", column);
            check_words(&table, expectations, column);
        }
    }
    remove(path);
}

TEST(faults)
{
    static const struct {
        const char *text, *expectations;
        size_t line, column;
        const char *message;
    } cases[] = {
        { "1, 2\n3, x\n", "", 2, 4, "not a number" },
        { "1, 2\n3\n", ", 2", 2, 1, "too few columns" },
        { "1\n2,,3\n", "", 2, 3, "expected a number before this" },
        { "a b\n1 2\n", ", \"c\"", 1, 1, "no column of this name" },
        { "1 2\n", ", \"c\"", 1, 1, "expected a heading" },
        { "1 2.5\n", ", integers", 1, 3, "expected an integer" },
        { "1 200000000000000\n", ", integers", 1, 3, "expected an integer" },
        { "1e9000\n", "", 1, 1, "outside the range" },
        { "1\n1.5.2\n", "", 2, 1, "not a number" },
        { "1\n", ", 0", 2, 38, "expected a column" },
        { "1.5.2\n2\n", ", 1, 2", 2, 41, "at most one column" },
        { "", ", \"b\"", 2, 1, "has no heading" },
        { "max load,place\n1,2\n", ", \"load\"", 1, 1, "no column of this name" },
        { "a b\n1.5.2 1\n", "", 2, 1, "not a number" },
        { "1.5 a\n", "", 1, 5, "not a number" },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        SCOPED_VALUE(diagnostics) errors = { 0 };
        write_bytes(path, cases[i].text, strlen(cases[i].text));
        assert_null(include_file(cases[i].expectations, &errors));
        assert_one_error(&errors, cases[i].text, cases[i].line, cases[i].column,
                         cases[i].message);
    }
    remove(path);
}
