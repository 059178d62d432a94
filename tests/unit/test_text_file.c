/* test_text_file.c - the lines of random texts are compared with a plain reader. Names
 * and messages that are printed to a terminal are compared with rules for their bytes.
 * A line end that is missed, or a control character that is printed, fails here. */
#include "asm/text/assemble.h"
#include "base/diagnostic.h"
#include "base/sink.h"
#include "base/text_file.h"
#include "base/visible_text.h"
#include "tests/unit/draw.h"
#include "tests/unit/unit.h"

enum { TEXTS = 20000, LONGEST = 40 };

/* ---- Lines ------------------------------------------------------------------- */

/* Makes a random text of a few different parts, which include all significant bytes
 * and, in any place, the mark of the byte order. */
static size_t draw_text(char *text)
{
    static const char *const parts[] = {
        "a",  "b",    " ",    "\n",   "\n",           "\r",
        "\r", "\x1A", "\xEF", "\xBB", "\xEF\xBB\xBF", "\xC2\xA0"
    };
    size_t count = below(LONGEST / 2);
    strcpy(text, below(4) == 0 ? "\xEF\xBB\xBF" : "");
    for (size_t i = 0; i < count; i++)
        strcat(text, parts[below(COUNT(parts))]);
    return strlen(text);
}

/* Reads a text by another method, which first splits it into lines. */
static void read_plainly(const char *text, char *plain)
{
    *plain = '\0';
    if (!strncmp(text, "\xEF\xBB\xBF", 3))
        text += 3;
    for (;;) {
        size_t length = strcspn(text, "\r\n\x1A");
        strncat(plain, text, length);
        text += length;
        if (*text == '\0' || *text == '\x1A')
            return;
        strcat(plain, "\n");
        text += !strncmp(text, "\r\n", 2) ? 2 : 1;
    }
}

TEST(any_text)
{
    for (size_t i = 0; i < TEXTS; i++) {
        char text[2 * LONGEST], plain[2 * LONGEST];
        size_t length = draw_text(text);
        read_plainly(text, plain);
        assert_null(c205_plain_text(text, &length));
        assert_string_equal(text, plain);
        assert_int_equal(length, strlen(plain));
    }
}

/* The lines of a stream must equal the lines of the whole text. */
TEST(any_stream)
{
    for (size_t i = 0; i < TEXTS / 20; i++) {
        char text[2 * LONGEST], plain[2 * LONGEST], *line = plain;
        size_t length = draw_text(text);
        struct text_stream stream = { .file = tmpfile() };
        assert_non_null(stream.file);
        fwrite(text, 1, length, stream.file);
        rewind(stream.file);
        assert_null(c205_plain_text(text, &length));
        memcpy(plain, text, length + 1);
        while (text_stream_next(&stream)) {
            size_t wanted = strcspn(line, "\n");
            assert_int_equal(strlen(stream.line), wanted);
            assert_memory_equal(stream.line, line, wanted);
            line += wanted + (line[wanted] == '\n');
        }
        assert_string_equal(line, "");
        assert_null(stream.fault);
        free(stream.line);
        fclose(stream.file);
    }
}

/* A line is open after a character other than a newline. An empty text after a newline
 * in memory changes nothing. */
TEST(open_lines)
{
    struct text_buffer printed = { 0 };
    struct line_tracker tracker = { text_buffer_sink(&printed), false };
    struct sink sink = line_tracker_sink(&tracker);
    static const char text[] = "a\nb";
    sink.put(sink.context, text, 1);
    assert_true(tracker.open);
    sink.put(sink.context, text + 2, 0);
    assert_true(tracker.open);
    sink.put(sink.context, text, 2);
    sink.put(sink.context, text + 1, 0);
    assert_false(tracker.open);
    text_buffer_free(&printed);
}

TEST(utf16)
{
    for (size_t i = 0; i < TEXTS; i++) {
        char text[4 * LONGEST];
        bool marked = i & 1, big = i & 2;
        size_t length = 0, count = 1 + below(LONGEST);
        if (marked) {
            memcpy(text, big ? "\xFE\xFF" : "\xFF\xFE", 2);
            length = 2;
        }
        for (size_t k = 0; k < count; k++) {
            size_t code = k % 3 ? ' ' + below(95) : below(0x2000);
            text[length++] = (char)(big ? code >> 8 : code);
            text[length++] = (char)(big ? code : code >> 8);
        }
        if (marked || count > 8) {
            const char *fault = NON_NULL(c205_plain_text(text, &length));
            assert_non_null(strstr(fault, "UTF-16"));
        }
    }
}

/* ---- Invisible characters ---- */

/* Returns the number of bytes of the UTF-8 form of a code point. */
static size_t put_utf8(unsigned long code, char *bytes)
{
    static const unsigned lead[] = { 0, 0, 0xC0, 0xE0, 0xF0 };
    size_t length = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    for (size_t i = length; i-- > 1; code >>= 6)
        bytes[i] = (char)(0x80 | (code & 0x3F));
    bytes[0] = (char)(lead[length] | code);
    return length;
}

/* Unicode 15 has 4,174 code points with the property Default_Ignorable_Code_Point, 65
 * controls (Cc), 18 separators (Z) other than the plain blank, and three annotation
 * marks (U+FFF9 to U+FFFB). The empty pattern of Braille, U+2800, is added. */
TEST(invisible_code_points)
{
    size_t count = 0;
    for (unsigned long code = 0; code <= 0x10FFFF; code++) {
        char bytes[4];
        unsigned long found = 0;
        size_t length = put_utf8(code, bytes);
        if (invisible_length(bytes, length, &found) == 0)
            continue;
        assert_int_equal(found, code);
        count++;
    }
    assert_int_equal(count, 4174 + 65 + 18 + 3 + 1);
}

/* An error at an invisible character names it. */
TEST(invisible_in_program)
{
    static const struct {
        const char *text, *name;
        size_t column;
    } cases[] = {
        { " addx\xC2\xA0r1, r2, r3\n", "U+00A0, a no-break space", 6 },
        { " addx r1,\xE2\x80\x8Br2, r3\n", "U+200B, a zero-width space", 10 },
        { "\xEF\xBB\xBF \xEF\xBB\xBF"
          "addx r1, r2, r3\n",
          "U+FEFF, a byte order mark", 2 },
        { " addx r1, r2, \x07r3\n", "U+0007, a control character", 15 },
        { " .word 1\xE3\x80\x80\n", "U+3000, a space", 9 },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        assert_null(assemble_text("a.s", cases[i].text, NULL, &reports));
        assert_non_null(strstr(reports.items->message, cases[i].name));
        assert_int_equal(reports.items->column, cases[i].column);
    }
}

static bool is_safe(const char *text)
{
    for (; *text; text++)
        if (((unsigned char)*text < ' ' && *text != '\t') || *text == 0x7F
            || (unsigned char)*text == 0xC2)
            return false;
    return true;
}

/* Names are printed without bytes that a terminal interprets, with all characters. */
TEST(any_name)
{
    static const char *const parts[] = {
        "\x1B[31m",     "\x1B]0;title\x07", "\x9B", "\xC2\x9B", "\r",  "\n", "a",
        "\xE2\x80\xAE", "\xEF\xBB\xBF",     "\x7F", "\xFF",     "b.s", " ",
    };
    for (size_t i = 0; i < TEXTS; i++) {
        char name[200] = "";
        SCOPED_VALUE(text_buffer) shown = { 0 };
        struct sink sink = text_buffer_sink(&shown);
        size_t visible = 0;
        for (size_t k = below(10); k > 0; k--)
            strcat(name, parts[below(COUNT(parts))]);
        visible_put(&sink, name, strlen(name));
        for (const char *at = name; *at; at++)
            visible += *at >= ' ' && *at < 0x7F;
        assert_true(visible == 0 || shown.length >= visible);
        assert_true(!shown.text || is_safe(shown.text));
    }
}

TEST(name_in_diagnostic)
{
    const struct position position = { "a\x1B[2J.s", 1, 3, "x\x1B\xC2\xA0y", 5 };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED_VALUE(text_buffer) shown = { 0 };
    struct sink sink = text_buffer_sink(&shown);
    diagnostics_add(&reports, SEVERITY_ERROR, &position, "no \x1B[31m\n");
    diagnostics_append(&reports, "said \x1B[31m\n\tnext\n");
    diagnostics_put(&reports, &sink);
    assert_string_equal(shown.text, "a\\x1b[2J.s:1:3: error: no \\x1b[31m\\x0a "
                                    "(at the caret: U+00A0, a no-break space)\n"
                                    "    x??y\n"
                                    "      ^\n"
                                    "said \\x1b[31m\n\tnext\n");
}
