/* test_table.c - tables, JSON and atomic files. Printed tables of text, counts and
 * numbers are compared with expected texts in every format. Files that cannot be
 * replaced are compared with their old contents. A value that is truncated or quoted
 * incorrectly, or a temporary file that is left, fails here. */
#include <errno.h>
#include <float.h>
#include <math.h>

#include <sys/stat.h>
#include <unistd.h>

#include "base/table.h"
#include "base/atomic_file.h"
#include "tests/unit/csv_reading.h"
#include "tests/unit/temporary_folder.h"

static const struct table_column columns[] = {
    { "name", "name", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "percent", "%", TABLE_NUMBER, 1 },
    { "remark", "remark", TABLE_TEXT, 0 },
};

static const struct table_column named[] = {
    { "name", "name", TABLE_TEXT, 0 },
    { "text", "text", TABLE_TEXT, 0 },
};

FIXTURE(remove_file)
{
    return remove(in_folder("file")) && errno != ENOENT;
}

static void expect_text(const char *name, const char *expected)
{
    FREED char *text = text_of_file(name);
    assert_string_equal(text, expected);
}

static struct table *some_table(void)
{
    struct table *table = table_new(columns, COUNT(columns));
    table_text(table, "a");
    table_count(table, 12345678);
    table_number(table, 99.96);
    table_text(table, "say \"so\"");
    table_text(table, "longer");
    table_count(table, 7);
    table_number(table, NAN);
    table_text(table, "");
    return table;
}

/* Writes `count` random words of the letters a to z. */
static void random_words(unsigned *seed, size_t count, char *text)
{
    for (size_t i = 0; i < count; i++) {
        size_t length = 1 + (*seed = *seed * 1103515245u + 12345u) / 65536 % 12;
        memset(text, (int)('a' + i % 26), length);
        text[length] = i + 1 < count ? ' ' : '\0';
        text += length + 1;
    }
}

/* The column's lines contain the whole text and are as full as possible. */
static void assert_folded(const char *printed, size_t begins, const char *text)
{
    enum { WIDE = 100 };
    const char *line = strchr(printed, '\n') + 1;
    while (*text) {
        size_t length = strcspn(line, "\n"), rest, word;
        assert_in_range(length, begins + 1, WIDE);
        assert_memory_equal(line + begins, text, length - begins);
        text += length - begins;
        rest = strspn(text, " ");
        word = strcspn(text + rest, " ");
        assert_true(word == 0 || length + rest + word > WIDE);
        text += rest;
        line += length + 1;
        assert_int_equal(strspn(line, " "), *text ? begins : 0);
    }
    assert_string_equal(line, "");
}

/* Texts that could break a format: separators, line ends, and long numbers. */
static const char *const odd_names[] = { "a, b", "\"c\"",      "# d",
                                         "e|f",  "two\nlines", "\\ <g> *h* `i`" };

static struct table *odd_table(void)
{
    struct table *table = table_new(columns, COUNT(columns));
    for (size_t i = 0; i < COUNT(odd_names); i++) {
        table_text(table, odd_names[i]);
        table_count(table, i);
        table_number(table, i ? 1.0 / (double)i : NAN);
        table_text(table, i ? "" : "so, \"so\"");
    }
    return table;
}

/* Returns the printed table. The caller frees it. */
static char *written(const struct table *table, enum table_format format)
{
    char *text = NULL;
    size_t length = 0;
    FILE *file = NON_NULL(open_memstream(&text, &length));
    assert_true(table_write(table, format, file));
    assert_int_equal(fclose(file), 0);
    return text;
}

static void expect_written(const struct table *table, enum table_format format,
                           const char *expected)
{
    FREED char *text = written(table, format);
    assert_string_equal(text, expected);
}

TEST_WITH(formats, NULL, remove_file)
{
    SCOPED(table) *table = some_table();
    struct json *json = json_open(in_folder("file"), &failure);
    table_json(table, json, "rows");
    assert_true(json_close(json, &failure));
    expect_text("file", "{\n  \"rows\": [\n"
                        "    {\n      \"name\": \"a\",\n"
                        "      \"clocks\": 12345678,\n"
                        "      \"percent\": 99.96,\n"
                        "      \"remark\": \"say \\\"so\\\"\"\n    },\n"
                        "    {\n      \"name\": \"longer\",\n"
                        "      \"clocks\": 7,\n"
                        "      \"percent\": null,\n"
                        "      \"remark\": \"\"\n    }\n  ]\n}\n");
    expect_written(table, TABLE_PLAIN,
                   "name      clocks      %  remark\n"
                   "a       12345678  100.0  say \"so\"\n"
                   "longer         7         \n");
    expect_written(table, TABLE_CSV,
                   "name,clocks,percent,remark\n"
                   "a,12345678,99.96,\"say \"\"so\"\"\"\n"
                   "longer,7,,\n");
    expect_written(table, TABLE_MARKDOWN,
                   "| name   |   clocks |     % | remark   |\n"
                   "|:-------|---------:|------:|:---------|\n"
                   "| a      | 12345678 | 100.0 | say \"so\" |\n"
                   "| longer |        7 |       |          |\n");
}

/* Only the plain format wraps a text that is too long for a line. */
TEST(long_text_is_folded)
{
    enum { FIRST = 76 };
    unsigned seed = 12;
    for (size_t words = 1; words < 200; words++) {
        char name[FIRST + 1] = "", text[13 * 200];
        SCOPED(table) *table = table_new(TABLE_COLUMNS(named));
        memset(name, 'x', words % FIRST > 0 ? words % FIRST : 1);
        random_words(&seed, words, text);
        table_text(table, name);
        table_text(table, text);
        char *printed = written(table, TABLE_PLAIN), *csv = written(table, TABLE_CSV);
        assert_folded(printed, 2 + (strlen(name) > 4 ? strlen(name) : 4), text);
        assert_non_null(strstr(csv, text));
        free(printed);
        free(csv);
    }
}

TEST(csv_comes_back)
{
    static struct csv_table back;
    SCOPED(table) *table = odd_table();
    FREED char *text = written(table, TABLE_CSV);
    assert_null(strstr(text, "\n#")); /* a CSV reader would ignore the line */
    assert_string_equal(csv_table(text, &back), "");
    assert_int_equal(back.rows, 7);
    assert_int_equal(back.cells[0], 4);
    for (size_t i = 0; i < COUNT(odd_names); i++)
        assert_string_equal(back.cell[i + 1][0], odd_names[i]);
    assert_string_equal(back.cell[1][2], "");
    assert_string_equal(back.cell[1][3], "so, \"so\"");
    assert_true(strtod(back.cell[4][2], NULL) == 1.0 / 3.0);
}

/* No cell can be read as a formula of a spreadsheet, whatever its first character is.
 * Numbers do not change. Other control characters are escaped. */
TEST(csv_has_no_formulas)
{
    static const char marks[] = "=+-@\t\n";
    static const char *const ends[] = { "",    "1",  "1.5e3", "1+1", "x",
                                        "1,2", "\"", "-1",    "0x10" };
    static struct csv_table back;
    for (char first = 1; first < 127; first++) {
        bool escaped = first < ' ' && !strchr(marks, first);
        for (size_t i = 0; !escaped && i < COUNT(ends); i++) {
            char text[8];
            snprintf(text, sizeof text, "%c%s", first, ends[i]);
            struct table_column column = { text, "", TABLE_TEXT, 0 };
            SCOPED(table) *table = table_new(&column, 1);
            table_text(table, text);
            FREED char *csv = written(table, TABLE_CSV);
            bool number = strchr("+-", first) && (i == 1 || i == 2);
            bool marked = strchr(marks, first) && !number;
            assert_string_equal(csv_table(csv, &back), "");
            for (int row = 0; row < 2; row++) {
                const char *cell = back.cell[row][0];
                assert_string_equal(cell + marked, text);
                assert_true(!marked || *cell == '\'');
            }
        }
    }
}

static size_t markdown_cells(const char *line)
{
    size_t bars = 0;
    for (; *line && *line != '\n'; line++)
        if (*line == '\\')
            line++;
        else
            bars += *line == '|';
    return bars - 1;
}

TEST(markdown_has_all_cells)
{
    SCOPED(table) *table = odd_table();
    FREED char *text = written(table, TABLE_MARKDOWN);
    size_t lines = 0;
    for (const char *line = text; *line; line = strchr(line, '\n') + 1) {
        assert_int_equal(markdown_cells(line), 4);
        lines++;
    }
    assert_int_equal(lines, 8);
    assert_non_null(strstr(text, "| e\\|f "));
    assert_non_null(strstr(text, "| two lines "));
    assert_non_null(strstr(text, "| \\\\ \\<g> \\*h\\* \\`i\\` |"));
}

TEST(signs_and_decimals)
{
    static const struct table_column column = { "e", "e", TABLE_NUMBER, 4 };
    static const double values[] = { 1.06, -12, NAN };
    SCOPED(table) *table = table_new(&column, 1);
    for (size_t i = 0; i < 3; i++)
        table_signed(table, values[i], 1);
    expect_written(table, TABLE_CSV, "e\n1.06\n-12\n\n");
    expect_written(table, TABLE_PLAIN, "    e\n +1.1\n-12.0\n     \n");
}

/* All digits of large numbers are printed. */
TEST(huge_numbers)
{
    static const struct table_column column = { "e", "e", TABLE_NUMBER, 1 };
    SCOPED(table) *table = table_new(&column, 1);
    table_number(table, -1e300);
    table_signed(table, DBL_MAX, 1);
    FREED char *text = written(table, TABLE_PLAIN);
    char *number = text + strcspn(text, "\n");
    assert_true(strtod(number, &number) == -1e300);
    assert_true(strtod(number, &number) == DBL_MAX);
    assert_string_equal(number, "\n");
}

TEST_WITH(headings, NULL, remove_file)
{
    FILE *file = fopen(in_folder("file"), "w");
    table_heading("Rows", TABLE_PLAIN, file);
    table_heading("Rows", TABLE_CSV, file);
    table_heading("Rows", TABLE_MARKDOWN, file);
    fclose(file);
    expect_text("file", "\nRows:\n\n\n# Rows\n\n## Rows\n\n");
    assert_string_equal(table_remark(TABLE_PLAIN), "");
    assert_string_equal(table_remark(TABLE_CSV), "# ");
    assert_string_equal(table_remark(TABLE_MARKDOWN), "");
}

/* JSON on a stream and in a file must be equal. */
TEST_WITH(json_on_stream, NULL, remove_file)
{
    FREED char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    struct json *json = json_open_stream(stream, in_folder("file"), &failure);
    json_count(json, "one", 1);
    assert_true(json_close(json, &failure));
    expect_text("file", "{\n  \"one\": 1\n}\n");
    json = json_open_stream(stream, NULL, &failure);
    json_count(json, "two", 2);
    assert_true(json_close(json, &failure));
    json = json_open_stream(stream, in_folder("file"), &failure);
    json_count(json, "three", 3);
    json_discard(json);
    expect_text("file", "{\n  \"one\": 1\n}\n");
    assert_null(json_open_stream(stream, "/nonexistent/file", &failure));
    fclose(stream);
    assert_string_equal(text, "{\n  \"one\": 1\n}\n{\n  \"two\": 2\n}\n");
}

TEST_WITH(json_values, NULL, remove_file)
{
    struct json *json = json_open(in_folder("file"), &failure);
    json_text(json, "text", "line\n\ttab \\ \x01");
    json_number(json, "tenth", 0.1);
    json_number(json, "third", 1.0 / 3.0);
    json_number(json, "none", INFINITY);
    json_bool(json, "true", true);
    json_array(json, "empty");
    json_end(json);
    assert_true(json_close(json, &failure));
    expect_text("file", "{\n  \"text\": \"line\\u000a\\u0009tab \\\\ \\u0001\",\n"
                        "  \"tenth\": 0.1,\n"
                        "  \"third\": 0.33333333333333331,\n"
                        "  \"none\": null,\n"
                        "  \"true\": true,\n"
                        "  \"empty\": []\n}\n");
}

TEST_WITH(old_file_stays, NULL, remove_file)
{
    struct atomic_file *whole = atomic_file_open(in_folder("file"), &failure);
    fputs("old", whole->file);
    assert_true(atomic_file_commit(whole, &failure));
    whole = atomic_file_open(in_folder("file"), &failure);
    fputs("new", whole->file);
    expect_text("file", "old");
    atomic_file_discard(whole);
    expect_text("file", "old");
    assert_true(atomic_file_check(in_folder("file"), &failure));
    expect_text("file", "old");
}

/* The new file cannot replace a folder with the same name. */
TEST_WITH(nothing_is_left, NULL, remove_file)
{
    c205_error error;
    struct atomic_file *whole = atomic_file_open(in_folder("file"), &error);
    fputs("lost", whole->file);
    assert_int_equal(mkdir(in_folder("file"), 0700), 0);
    assert_false(atomic_file_commit(whole, &error));
    assert_non_null(strstr(error.message, in_folder("file")));
    assert_int_equal(rmdir(in_folder("file")), 0);
}

/* A third-party file may already have the temporary name. */
TEST_WITH(other_file_stays, NULL, remove_file)
{
    write_file("file.new0", "theirs");
    struct atomic_file *whole = atomic_file_open(in_folder("file"), &failure);
    fputs("ours", whole->file);
    assert_true(atomic_file_commit(whole, &failure));
    expect_text("file", "ours");
    expect_text("file.new0", "theirs");
    assert_int_equal(unlink(in_folder("file.new0")), 0);
}

TEST(no_folder)
{
    static const char path[] = "/nonexistent/file";
    static const char message[] = "cannot write /nonexistent/file: "
                                  "No such file or directory";
    c205_error error = { "" }, other = { "" };
    assert_null(atomic_file_open(path, &error));
    assert_string_equal(error.message, message);
    assert_false(atomic_file_check(path, &other));
    assert_string_equal(other.message, message);
    assert_true(atomic_file_check("/dev/full", &error));
}

/* A device must not be replaced by a file. */
TEST(device_stays)
{
    struct stat status;
    struct atomic_file *whole = NON_NULL(atomic_file_open("/dev/full", &failure));
    fputs("lost", whole->file);
    assert_false(atomic_file_commit(whole, &failure));
    assert_int_equal(stat("/dev/full", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
}
