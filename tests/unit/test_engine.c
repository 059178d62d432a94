/* test_engine.c - replies of the engine to a page are compared with expected replies,
 * for lessons, programs, instructions and traps, and for invalid and mutated requests.
 * A wrong member, or a request that crashes the engine, fails here. */
#include "asm/lesson/lesson.h"
#include "base/json.h"
#include "tests/unit/draw.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/engine_client.h"

/* ---- Static information ---------------------------------------------------------- */

TEST(about)
{
    const struct json_value *about, *item;
    SCOPED_VALUE(lessons) lessons = { .count = 0 };
    SCOPED_VALUE(talk) talk = talk_with(NULL, "");
    size_t i = 0;
    about = talk_ask(&talk, "{'do': 'about'}");
    assert_string_equal(text_of(about, "version"), C205_VERSION);
    item = json_member_first(about, "instructions");
    for (; item; item = item->next, i++) {
        assert_string_equal(text_of(item, "mnemonic"), c205_insns[i].mnemonic);
        assert_string_equal(text_of(item, "effect"), c205_insns[i].effect);
    }
    assert_int_equal(i, c205_insn_count);
    talk_says(&talk, "'.rept'");
    talk_says(&talk, "'.word'");
    talk_says(&talk, "'.ifndef'");
    assert_true(lessons_open(&lessons, &failure));
    assert_int_equal(items_of(json_member(about, "lessons")), lessons.count);
    for (i = 0; i < lessons.count; i++)
        talk_ask(&talk, "{'do': 'grade', 'lesson': '%s', 'text': ' EXIT\\n'}",
                 lessons.items[i].name);
}

TEST(load)
{
    SCOPED_VALUE(talk) talk = talk_with(
        " .include \"own.inc\"\n EX r10, m\n EXIT\n .data\nx: .space 3\n",
        ", 'defines': {'n': 7}, 'warm': true, 'files': {'own.inc': ' .equ m, n + "
        "1\\n'}");
    talk_says(&talk, "'warm': true");
    talk_says(&talk, "'lines': [2, 3]");
    talk_says(&talk, "{'name': 'm', 'label': false, 'value': 8");
    talk_says(&talk, "'contents': 'words', 'count': 3");
    talk_ask(&talk, "{'do': 'breaks', 'lines': [0, 2]}");
    talk_says(&talk, "lines are counted from 1");
    talk_ask(&talk, "{'do': 'go', 'how': 'step'}");
    talk_refused(&talk, "program.s cannot be assembled: 1 error",
                 "{'do': 'load', 'text': ' EXIT\\n  ADDNX r1\\n'}");
    const struct json_value *said = json_member_first(talk.reply, "diagnostics");
    assert_true(number_of(said, "line") == 2 && number_of(said, "column") == 3
                && number_of(said, "length") == 5);
    talk_ask(&talk, "{'do': 'view'}");
    assert_true(number_of(talk.reply, "step") == 1);
}

/* The results are the data that differ from the program's text, in words, half words
 * and bits. Elements after the maximum are listed from the first difference on. */
TEST(results)
{
    SCOPED_VALUE(talk) talk = talk_with(
        " .include \"vectors.s\"\n .regs r16, a, b, z\n .data\nsame: .word 2.5\n"
        " .bitvector bits, 4, \"1010\"\nlong: .space 40\nhalves: .half 1, 2\n"
        " .code\n EX a, long+30*64\n ES b, 7\n STO [a], b\n EX a, halves+32\n"
        " STOH [a], h50\n EX a, bits\n STO [a], r0\n EXIT\n",
        AND_PRIOR);
    talk_ask(&talk, "{'do': 'results'}");
    talk_says(&talk, "'results': []");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    talk_ask(&talk, "{'do': 'results', 'elements': 4}");
    talk_says(&talk, "{'label': 'bits', 'kind': 'bits', 'count': 4, 'differs': 2, "
                     "'first': 0, 'values': ['0', '0', '0', '0'], "
                     "'changed': [true, false, true, false]}");
    talk_says(&talk, "{'label': 'long', 'kind': 'words', 'count': 40, 'differs': 1, "
                     "'first': 30, 'values': ['7', '0', '0', '0'], "
                     "'changed': [true, false, false, false]}");
    assert_int_equal(items_of(json_member(talk.reply, "results")), 3);
    talk_refused(&talk, "elements", "{'do': 'results', 'elements': -1}");
}

/* The shares of a timeline cover each clock of the range once. */
TEST(shares)
{
    SCOPED_VALUE(talk) talk = talk_with(
        " ES r10, 50\non: DIVS r11, r11, r11\n EX r12, on\n DBNZ r10, [r12]\n EXIT\n",
        AND_PRIOR);
    const struct json_value *cause;
    double sum = 0;
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    talk_ask(&talk, "{'do': 'timeline', 'from': 3, 'to': 303, 'most': 10, "
                    "'columns': 7}");
    talk_says(&talk, "'full': true");
    cause = json_member_first(talk.reply, "shares");
    for (; cause; cause = cause->next) {
        const struct json_value *clocks = json_member_first(cause, "clocks");
        for (; clocks; clocks = clocks->next)
            sum += clocks->number;
    }
    assert_true(sum == 300);
    talk_ask(&talk, "{'do': 'timeline', 'from': 3, 'to': 33, 'columns': 7}");
    talk_says(&talk, "'insns': [{");
    talk_refused(&talk, "columns",
                 "{'do': 'timeline', 'from': 3, 'to': 5, 'columns': 7}");
}

/* A view shows the last instruction, and the operands of the next instruction. */
TEST(instructions)
{
    SCOPED_VALUE(talk) talk =
        talk_with(" .include \"vectors.s\"\n .regs r16, a, b, z\n words a, 1.0, "
                  "-2.0\n words b\n bits z, \"10\"\n ADDNV [a], [a], [b] ? [z]\n "
                  "EXIT\n",
                  AND_PRIOR);
    talk_ask(&talk, "{'do': 'breaks', 'lines': [6]}");
    talk_ask(&talk, "{'do': 'go', 'how': 'continue'}");
    talk_ask(&talk, "{'do': 'view'}");
    talk_says(&talk, "'next': 'ADDNV [r16], [r16], [r17] ? [r18]'");
    talk_says(&talk, "'kind': 'words', 'control': ");
    talk_ask(&talk, "{'do': 'go', 'how': 'step'}");
    talk_ask(&talk, "{'do': 'view'}");
    talk_says(&talk, "'name': 'startup.vadd', 'value': '51', "
                     "'unit': 'clk', 'source': 'S'");
    talk_says(
        &talk,
        "= 51 vector start-up + 30 translation miss + 1000 page fault + 2 vector stream, 4 elements");
    talk_says(&talk, "'label': 'b.words', 'kind': 'words', ");
    talk_says(&talk,
              "'values': ['2', '0', '0', '0'], 'stored': [{'first': 0, 'count': 4}], "
              "'changed': true");
    talk_says(&talk, "'kind': 'bits'");
    talk_says(&talk, "'values': '10'");
}

TEST(trap)
{
    SCOPED_VALUE(talk) talk = talk_with(" ES r10, 64\n LOD [r10], r11\n EXIT\n", "");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    assert_string_equal(text_of(talk.reply, "why"), "trap");
    assert_non_null(strstr(text_of(talk.reply, "message"), "program.s:2"));
    double clocks = number_of(talk.reply, "clock");
    talk_ask(&talk, "{'do': 'profile'}");
    talk_ask(&talk, "{'do': 'view'}");
    assert_string_equal(text_of(talk.reply, "trap"), "unmapped-address");
    assert_true(number_of(talk.reply, "clock") == clocks);
}

/* ---- Bad requests ---------------------------------------------------------------- */

#define LOAD "{'do': 'load', 'text': ' EXIT', "
#define SWEEP_FROM "{'do': 'sweep', 'text': ' EXIT', 'constant': 'n', 'from': "
#define COMPARE "{'do': 'compare', 'texts': "

TEST(bad)
{
    static const struct {
        const char *request, *why;
    } cases[] = {
        { "", "" },
        { "{", "" },
        { "[]", "a request must be an object" },
        { "7", "a request must be an object" },
        { "{}", "'do' is missing" },
        { "{'do': 7}", "'do' is not a string" },
        { "{'do': 'dance'}", "unknown request 'dance'" },
        { "{'do': 'more'}", "no work is left" },
        { "{'do': 'view'}", "no program is loaded" },
        { "{'do': 'go', 'how': 'end'}", "no program is loaded" },
        { "{'do': 'say', 'line': 'why'}", "no program is loaded" },
        { "{'do': 'load'}", "'text' is missing" },
        { "{'do': 'load', 'text': 1}", "'text' is not a string" },
        { LOAD "'model': 'cray'}", "cray" },
        { LOAD "'model': 'a/b'}", "built-in" },
        { LOAD "'model': 'cdc6600'}", "only gives times" },
        { LOAD "'warm': 1}", "true or false" },
        { LOAD "'defines': [1]}", "names with integers" },
        { LOAD "'defines': {'n': 0.5}}", "names with integers" },
        { LOAD "'defines': {'n': 5}}",
          "'n' is defined, but the program does not use it" },
        { "{'do': 'load', 'text': ' ES r1, n\\n EXIT', 'defines': {'n': 5, 'm': 5}}",
          "'m' is defined, but the program does not use it" },
        { LOAD "'defines': {'r5': 5}}", "cannot be assembled: 1 error" },
        { LOAD "'defines': {'a b': 5}}", "cannot be assembled: 1 error" },
        { SWEEP_FROM "1, 'to': 9}", "'n' is defined, but the program does not use it" },
        { "{'do': 'sweep', 'text': ' ES r1, n\\n EXIT', 'constant': 'n', 'from': 1, "
          "'to': 9, 'defines': {'m': 3}}",
          "'m' is defined, but the program does not use it" },
        { SWEEP_FROM "1, 'to': 9, 'warm': 'yes'}", "'warm' must be true or false" },
        { COMPARE "[{'text': ' EXIT'}, {'text': ' ES r1, n\\n EXIT'}], 'defines': "
                  "{'n': 1, 'm': 2}}",
          "'m' is defined, but the program does not use it" },
        { LOAD "'files': {'n': 1}}", "names with strings" },
        { "{'do': 'sweep', 'constant': 'n', 'from': 1, 'to': 9}", "'text' is missing" },
        { SWEEP_FROM "9, 'to': 1}", "the range" },
        { SWEEP_FROM "1, 'to': 9, 'points': 1}", "2 to 1000" },
        { SWEEP_FROM "1, 'to': 99999999, 'step': 1}", "2 to 1000" },
        { COMPARE "[{'text': ' EXIT'}]}", "two programs" },
        { COMPARE "[7, 8]}", "'text' is missing" },
        { COMPARE "[{'text': ' EXIT'}, {'text': ' LOD [r2], r3\\n EXIT'}]}",
          "program.s: trap" },
        { "{'do': 'grade', 'lesson': 'none', 'text': ''}", "" },
        { NULL, NULL }, /* requests after a program has been loaded */
        { "{'do': 'go'}", "'how' is missing" },
        { "{'do': 'go', 'how': 'up'}", "unknown value of 'how': 'up'" },
        { "{'do': 'go', 'how': 'step-to'}", "'n' is missing" },
        { "{'do': 'go', 'how': 'step', 'n': -1}", "'n' is not an integer" },
        { "{'do': 'go', 'how': 'end', 'ms': '1'}", "'ms' is not an integer" },
        { "{'do': 'breaks'}", "'lines' must be a list" },
        { "{'do': 'breaks', 'lines': [1, 'x']}", "'lines' must be a list" },
        { "{'do': 'breaks', 'lines': [1e300]}", "'lines' must be a list" },
        { "{'do': 'view', 'elements': 70000}", "at most 65536" },
        { "{'do': 'view', 'all-registers': 1}",
          "'all-registers' must be true or false" },
        { "{'do': 'profile', 'in-order': 'yes'}", "'in-order' must be true or false" },
        { "{'do': 'view', 'first': 5}", "names with integers" },
        { "{'do': 'view', 'first': {'x': -1}}", "'x' is not an integer" },
        { "{'do': 'timeline', 'from': 5, 'to': 5}", "before" },
        { "{'do': 'timeline', 'file': 'x.png'}", ".kanata" },
        { "{'do': 'say', 'line': 'step\\nstep'}", "one line" },
    };
    SCOPED_VALUE(talk) talk = talk_with(NULL, "");
    for (size_t i = 0; i < COUNT(cases); i++)
        if (cases[i].request)
            talk_refused(&talk, cases[i].why, "%s", cases[i].request);
        else
            talk_load(&talk, " .data\nx: .space 4\n .code\n EXIT\n", "");
}

/* ---- Random requests ------------------------------------------------------------- */

static const char *const seeds[] = {
    "{'do': 'about'}",
    "{\"do\": \"load\", \"name\": \"x.s\", \"text\": \" .include "
    "\\\"vectors.s\\\"\\n .regs r16, a, b\\n words a, 1.5, 2.5\\n words "
    "b\\n ADDNV [a], [a], [b]\\n EXIT a, r0, 6\\n EXIT\\n\", \"model\": "
    "\"cyber205-2pipe\", \"warm\": true, \"defines\": {\"n\": 100}, "
    "\"files\": {\"y.inc\": \" EXIT\\n\"}}",
    "{'do': 'breaks', 'lines': [1, 5, 900]}",
    "{'do': 'go', 'how': 'end', 'n': 3, 'ms': 5, 'clocks': 100, 'limit': 9000}",
    "{'do': 'go', 'how': 'back', 'n': 2}",
    "{'do': 'go', 'how': 'next', 'n': 2}",
    "{'do': 'go', 'how': 'clock-to', 'n': 1000}",
    "{'do': 'go', 'how': 'reverse-continue'}",
    "{'do': 'view', 'elements': 3, 'first': {'a.words': 1}, 'all-registers': true}",
    "{'do': 'timeline', 'from': 10, 'to': 2000, 'most': 5, 'file': 'x.svg'}",
    "{'do': 'profile', 'in-order': true, 'ms': 0}",
    "{'do': 'accounts'}",
    "{'do': 'sweep', " SWEEP ", 'points': 4, 'ms': 0}",
    "{'do': 'compare', 'texts': [{'text': ' EXIT\\n'}, {'text': ' ES r10, 1\\n "
    "EXIT\\n'}], 'clocks': 1}",
    "{'do': 'grade', 'lesson': '1', 'text': ' EXIT\\n'}",
    "{'do': 'say', 'line': 'why'}",
    "{'do': 'say', 'line': 'watch a.words, 2', 'ms': 5}",
    "{'do': 'more', 'ms': 5}",
};
enum { SEEDS = COUNT(seeds) };

static const char *const values[] = {
    "null", "true", "[]",      "{}",       "''",    "-1",  "0",
    "1e99", "'x'",  "[[[7]]]", "{'n': 1}", "65536", "0.5", "4294967296",
};
enum { VALUES = COUNT(values) };

/* Replaces the value after a random colon by another value. */
static void change_value(char *text, size_t size)
{
    char *colon = text, copy[4096], *end;
    for (size_t n = below(6); n > 0 && colon; n--)
        colon = strchr(colon + 1, ':');
    if (!colon)
        return;
    end = colon + strcspn(colon, ",}");
    snprintf(copy, sizeof copy, "%.*s: %s%s", (int)(colon - text), text,
             values[below(VALUES)], end);
    snprintf(text, size, "%s", copy);
}

TEST(chance)
{
    enum { ROUNDS = 3000 };
    SCOPED_VALUE(talk) talk = talk_with(NULL, "");
    engine_bound(talk.engine, 200000);
    for (size_t i = 0; i < ROUNDS; i++) {
        char text[4096];
        snprintf(text, sizeof text, "%s", seeds[below(SEEDS)]);
        for (size_t n = below(3); n > 0; n--)
            change_value(text, sizeof text);
        talk_quote(text);
        if (below(3) == 0) {
            size_t length = strlen(text), at = below(length + 1);
            switch (below(3)) {
            case 0: text[at] = (char)(at < length ? 1 + below(255) : 0); break;
            case 1:
                memmove(text + at, text + at + (at < length), length - at + 1);
                break;
            default: text[at] = '\0';
            }
        }
        talk_bytes(&talk, text, strlen(text));
    }
}
