/* test_table.c - tables, JSON, and files that are written whole. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "asm/table.h"
#include "asm/whole.h"

static const struct table_column columns[] = {
    { "name", "name", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "percent", "%", TABLE_NUMBER, 1 },
    { "remark", "remark", TABLE_TEXT, 0 },
};

struct folder {
    char name[32];
    char path[64];
};

static int set_up(void **state)
{
    struct folder *folder = calloc(1, sizeof *folder);
    strcpy(folder->name, "/tmp/test_table.XXXXXX");
    if (!mkdtemp(folder->name)) {
        return -1;
    }
    snprintf(folder->path, sizeof folder->path, "%s/file", folder->name);
    *state = folder;
    return 0;
}

/* The folder must be empty but for the file: nothing temporary is left. */
static int tear_down(void **state)
{
    struct folder *folder = *state;
    unlink(folder->path);
    int result = rmdir(folder->name);
    free(folder);
    return result;
}

static void expect_text(const char *path, const char *expected)
{
    char text[2048] = "";
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(text, expected);
}

static struct table *some_table(void)
{
    struct table *table =
        table_new(columns, sizeof columns / sizeof *columns);
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

static void columns_line_up(void **state)
{
    struct folder *folder = *state;
    struct table *table = some_table();
    FILE *file = fopen(folder->path, "w");
    assert_true(table_print(table, file));
    fclose(file);
    table_free(table);
    expect_text(folder->path, "name      clocks      %  remark\n"
                              "a       12345678  100.0  say \"so\"\n"
                              "longer         7         \n");
}

static void table_as_json(void **state)
{
    struct folder *folder = *state;
    struct table *table = some_table();
    c205_error error;
    struct json *json = json_open(folder->path, &error);
    assert_non_null(json);
    table_json(table, json, "rows");
    assert_true(json_close(json, &error));
    table_free(table);
    expect_text(folder->path,
                "{\n  \"rows\": [\n"
                "    {\n      \"name\": \"a\",\n"
                "      \"clocks\": 12345678,\n"
                "      \"percent\": 99.96,\n"
                "      \"remark\": \"say \\\"so\\\"\"\n    },\n"
                "    {\n      \"name\": \"longer\",\n"
                "      \"clocks\": 7,\n"
                "      \"percent\": null,\n"
                "      \"remark\": \"\"\n    }\n  ]\n}\n");
}

static void json_values(void **state)
{
    struct folder *folder = *state;
    c205_error error;
    struct json *json = json_open(folder->path, &error);
    json_text(json, "text", "line\n\ttab \\ \x01");
    json_number(json, "tenth", 0.1);
    json_number(json, "third", 1.0 / 3.0);
    json_number(json, "none", INFINITY);
    json_truth(json, "true", true);
    json_array(json, "empty");
    json_end(json);
    assert_true(json_close(json, &error));
    expect_text(folder->path,
                "{\n  \"text\": \"line\\u000a\\u0009tab \\\\ \\u0001\",\n"
                "  \"tenth\": 0.1,\n"
                "  \"third\": 0.33333333333333331,\n"
                "  \"none\": null,\n"
                "  \"true\": true,\n"
                "  \"empty\": []\n}\n");
}

static void old_file_stays(void **state)
{
    struct folder *folder = *state;
    c205_error error;
    struct whole *whole = whole_open(folder->path, &error);
    fputs("old", whole->file);
    assert_true(whole_commit(whole, &error));
    whole = whole_open(folder->path, &error);
    fputs("new", whole->file);
    expect_text(folder->path, "old");
    whole_discard(whole);
    expect_text(folder->path, "old");
}

static void no_folder(void **state)
{
    c205_error error;
    (void)state;
    assert_null(whole_open("/nonexistent/file", &error));
    assert_string_equal(error.message,
                        "/nonexistent/file: No such file or directory");
}

/* A device must not be replaced by a file. */
static void device_stays(void **state)
{
    c205_error error;
    struct stat status;
    (void)state;
    struct whole *whole = whole_open("/dev/full", &error);
    assert_non_null(whole);
    fputs("lost", whole->file);
    assert_false(whole_commit(whole, &error));
    assert_int_equal(stat("/dev/full", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(columns_line_up, set_up, tear_down),
        cmocka_unit_test_setup_teardown(table_as_json, set_up, tear_down),
        cmocka_unit_test_setup_teardown(json_values, set_up, tear_down),
        cmocka_unit_test_setup_teardown(old_file_stays, set_up, tear_down),
        cmocka_unit_test(no_folder),
        cmocka_unit_test(device_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
