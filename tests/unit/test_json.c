/* test_json.c - random values that are written as JSON and read again are compared with
 * the originals. Truncated or altered texts must give a tree or an error. A value that
 * changes, or a read after the end, fails here. */
#include <math.h>

#include "base/json.h"
#include "base/json_read.h"
#include "base/sink.h"
#include "base/utf8.h"
#include "tests/unit/draw.h"
#include "tests/unit/unit.h"

enum { ROUNDS = 3000, DEEPEST = 6 };

static const struct json_value *read_in(struct arena *arena, const char *text,
                                        c205_error *error)
{
    return json_read(arena, text, strlen(text), error);
}

/* ---- Written and read ------------------------------------------------------- */

/* Makes a random text. The same sequence of texts is made while reading. */
static void draw_text(char text[40])
{
    static const char *const pieces[] = {
        "a",        "\"",   "\\",           "\n", "\x1f",
        "\xc3\xa4", "\x7f", "\xe2\x82\xac", "/",  "\xf0\x9f\x98\x80",
        "\t"
    };
    size_t length = below(8);
    for (*text = '\0'; length > 0; length--)
        strcat(text, pieces[below(COUNT(pieces))]);
}

static double draw_number(void)
{
    double number = (double)(int64_t)xorshift(&random_state);
    return ldexp(number, (int)below(200) - 100);
}

static void write_value(struct json *json, const char *key, unsigned depth)
{
    char text[40];
    size_t count;
    switch (below(depth < DEEPEST ? 6 : 4)) {
    case 0: json_null(json, key); break;
    case 1: json_bool(json, key, below(2)); break;
    case 2: json_number(json, key, draw_number()); break;
    case 3:
        draw_text(text);
        json_text(json, key, text);
        break;
    case 4:
        json_array(json, key);
        for (count = below(5); count > 0; count--)
            write_value(json, NULL, depth + 1);
        json_end(json);
        break;
    default:
        json_object(json, key);
        for (count = below(5); count > 0; count--) {
            draw_text(text);
            write_value(json, text, depth + 1);
        }
        json_end(json);
    }
}

static void check_value(const struct json_value *value, unsigned depth);

static void check_items(const struct json_value *value, bool has_keys, unsigned depth)
{
    const struct json_value *item = value->first;
    char text[40];
    for (size_t count = below(5); count > 0; count--, item = item->next) {
        assert_non_null(item);
        if (has_keys) {
            draw_text(text);
            assert_string_equal(item->key, text);
        } else {
            assert_null(item->key);
        }
        check_value(item, depth + 1);
    }
    assert_null(item);
}

static void check_value(const struct json_value *value, unsigned depth)
{
    char text[40];
    enum json_kind kind = (enum json_kind)below(depth < DEEPEST ? 6 : 4);
    assert_int_equal(value->kind, kind);
    switch (kind) {
    case JSON_NULL: break;
    case JSON_TRUTH: assert_int_equal(value->truth, below(2)); break;
    case JSON_NUMBER: assert_true(value->number == draw_number()); break;
    case JSON_TEXT:
        draw_text(text);
        assert_string_equal(value->text, text);
        break;
    default: check_items(value, kind == JSON_OBJECT, depth);
    }
}

static void write_document(struct text_buffer *text)
{
    struct json *json = json_open_line(text, &failure);
    write_value(json, "value", 0);
    assert_true(json_close(json, &failure));
    assert_null(strchr(text->text, '\n'));
}

TEST(written_and_read)
{
    for (size_t i = 0; i < ROUNDS; i++) {
        uint64_t seed = random_state;
        SCOPED_VALUE(text_buffer) text = { 0 };
        SCOPED_VALUE(arena) arena = { 0 };
        write_document(&text);
        random_state = seed;
        const struct json_value *tree = read_in(&arena, text.text, &failure);
        FAIL_IF(!tree, "%s: %s", failure.message, text.text);
        check_value(tree->first, 0);
        assert_string_equal(tree->first->key, "value");
    }
}

/* ---- Damaged ------------------------------------------------------------------ */

/* Reads a copy of exact size, so that the sanitizers detect reads after its end. */
static bool is_read(const char *text, size_t length)
{
    SCOPED_VALUE(arena) arena = { 0 };
    c205_error error = { "" };
    FREED char *copy = malloc(length + !length);
    memcpy(copy, text, length);
    const struct json_value *tree = json_read(&arena, copy, length, &error);
    assert_true(tree || *error.message);
    return tree;
}

TEST(damaged)
{
    for (size_t i = 0; i < ROUNDS; i++) {
        SCOPED_VALUE(text_buffer) text = { 0 };
        write_document(&text);
        assert_true(is_read(text.text, text.length));
        assert_false(is_read(text.text, below(text.length)));
        text.text[below(text.length)] = (char)below(256);
        is_read(text.text, text.length);
    }
}

/* ---- Examples ------------------------------------------------------------------ */

TEST(right_and_wrong)
{
    static const char *const right[] = {
        "0",           "-0",           " [ ] ", "{}",
        "1e5",         "-1.5E-3",      "true",  "\"\\ud83d\\ude00\"",
        "\"\\u00e4\"", "[[],{},null]", "\"\"",
    };
    static const struct {
        const char *text, *error;
    } wrong[] = {
        { "", "expected a value at byte 0" },
        { "01", "expected the end of the text at byte 1" },
        { "-", "expected a value" },
        { "1.", "expected a value" },
        { "1e", "expected a value" },
        { "+1", "expected a value" },
        { "1e999", "a number above 1.8e308" },
        { "nul", "expected a value" },
        { "[1,]", "expected a value at byte 3" },
        { "[1 2]", "expected ',' or a closing bracket" },
        { "{1:2}", "expected a key" },
        { "{\"a\" 2}", "expected ':'" },
        { "{\"a\":2,}", "expected a key" },
        { "\"a", "unterminated string" },
        { "\"\\x\"", "unknown escape" },
        { "\"\\u12g4\"", "four hex digits" },
        { "\"\\u0000\"", "a NUL" },
        { "\"\\ud83d\"", "unpaired surrogate" },
        { "\"\\ude00\\ud83d\"", "unpaired surrogate" },
        { "\"\\ud83d\\u0041\"", "unpaired surrogate" },
        { "\"\x01\"", "a control character" },
        { "\"\xff\"", "invalid UTF-8" },
        { "\"\xed\xa0\x80\"", "invalid UTF-8" },
        { "\"\xc0\x80\"", "invalid UTF-8" },
    };
    SCOPED_VALUE(arena) arena = { 0 };
    c205_error error;
    for (size_t i = 0; i < COUNT(right); i++)
        FAIL_IF(!read_in(&arena, right[i], &error), "%s: %s", right[i], error.message);
    for (size_t i = 0; i < COUNT(wrong); i++) {
        FAIL_IF(read_in(&arena, wrong[i].text, &error), "%s is read", wrong[i].text);
        FAIL_IF(!strstr(error.message, wrong[i].error), "%s: %s", wrong[i].text,
                error.message);
    }
    assert_string_equal(read_in(&arena, "\"\\ud83d\\ude00\\u00e4\"", &error)->text,
                        "\xf0\x9f\x98\x80\xc3\xa4");
}

TEST(depth)
{
    char text[2 * JSON_DEEPEST + 3] = "";
    size_t depth = JSON_DEEPEST;
    memset(text, '[', depth);
    memset(text + depth, ']', depth);
    assert_true(is_read(text, 2 * depth));
    memset(text, '[', depth + 1);
    memset(text + depth + 1, ']', depth + 1);
    assert_false(is_read(text, 2 * (depth + 1)));
}

TEST(members)
{
    static const char *const keys[] = { "a", "none", "b", "d", "e", "g" };
    SCOPED_VALUE(arena) arena = { 0 };
    const struct json_value
        *tree = read_in(&arena,
                        "{\"a\": 1, \"a\": 2, \"b\": null, \"c\": [5], \"d\": 1.5, "
                        "\"e\": \"x\", \"f\": false, \"g\": 9007199254740992}",
                        &failure);
    int64_t value = 7;
    for (size_t i = 0; i < COUNT(keys); i++) /* the last three are no integers */
        FAIL_IF(json_member_whole(tree, keys[i], &value) != (i < 3) || value != 1,
                "%s: %lld", keys[i], (long long)value);
    assert_null(json_member(tree, "b"));
    assert_null(json_member(NULL, "b"));
    assert_null(json_member(tree->first, "b"));
    assert_true(json_member_first(tree, "c")->number == 5);
    assert_null(json_member_first(tree, "a"));
    assert_string_equal(json_member_text(tree, "e"), "x");
    assert_null(json_member_text(tree, "a"));
    assert_false(json_member_truth(tree, "f", true));
    assert_true(json_member_truth(tree, "a", true));
}

/* Output is valid UTF-8 and readable, whatever the bytes are. */
TEST(bytes)
{
    for (size_t i = 0; i < ROUNDS; i++) {
        SCOPED_VALUE(text_buffer) line = { 0 };
        struct json *json = json_open_line(&line, &failure);
        char bytes[30];
        size_t length = below(sizeof bytes);
        for (size_t k = 0; k < length; k++)
            bytes[k] = (char)(1 + below(255));
        bytes[length] = '\0';
        json_text(json, "bytes", bytes);
        assert_true(json_close(json, &failure));
        assert_true(is_read(line.text, line.length));
    }
}

/* All code points, and the values just outside of the range. */
TEST(utf8)
{
    static const char *const outside[] = { "\xf4\x90\x80\x80", "\xe0\x9f\xbf",
                                           "\xf0\x8f\xbf\xbf", "\x80" };
    char text[MAX_UTF8];
    for (unsigned long code = 0; code < 0x110000; code++) {
        size_t length = utf8_put(text, code);
        bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
        assert_int_equal(utf8_length(text, length), is_surrogate ? 0 : length);
        assert_int_equal(utf8_length(text, length - 1), 0);
    }
    for (size_t i = 0; i < COUNT(outside); i++)
        assert_int_equal(utf8_length(outside[i], strlen(outside[i])), 0);
}
