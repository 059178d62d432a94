/* test_lesson_texts.c - texts of lessons are compared with the expectations, notes,
 * names and errors that they must give. Random texts must be rejected or graded. An
 * error without a reason, or a wrong explanation of results, fails here. */
#include "asm/lesson/lesson_internal.h"
#include "tests/random.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/random_lesson.h"

static size_t tries = 5000;
static uint64_t random_state = RANDOM_SEED;

/* Opens a lesson with one test. Returns false if it is rejected. */
static bool open_with(struct lesson *lesson, const char *test, c205_error *error)
{
    static const char title[] = "# A\n";
    *lesson = (struct lesson){ 0 };
    return lesson_begin(lesson, "12-it", error)
           && lesson_take(lesson, "lesson.md", title, strlen(title), error)
           && lesson_take(lesson, "start.s", "", 0, error)
           && lesson_take(lesson, "test-a.s", test, strlen(test), error)
           && lesson_end(lesson, error);
}

/* ---- Expectations of a run ------------------------------------------------- */

static void check_run(const char *test, const char *answer, const char *wanted)
{
    SCOPED_VALUE(lesson) lesson;
    SCOPED_VALUE(lesson_verdict) verdict;
    assert_true(open_with(&lesson, test, &failure));
    grade_well(&verdict, &lesson, answer);
    const struct lesson_report *report = verdict.graded ? &verdict.trials[0].report
                                                        : &verdict.report;
    assert_int_equal(verdict.passed, wanted == NULL);
    assert_int_equal(report->count, wanted != NULL);
    if (wanted)
        assert_string_equal(report->sentences[0], wanted);
}

TEST(runs)
{
    static const char reg[] = "; test: a\n; expect: r10 = 5\n";
    static const char print[] = "; test: a\n; expect-print: 5\n";
    static const char trap[] = "; test: a\n; expect-trap: unmapped-address\n";
    static const char five[] = "        ES      r10, 5\n        EXIT\n";
    static const char prints[] = "        .include \"print.s\"\n"
                                 "        ES      r10, 5\n"
                                 "        print_integer r10\n"
                                 "        newline\n        EXIT\n";
    static const char endless[] = "here:   ES      r10, 5\n"
                                  "        EXIT    r10, r0, 2\n"
                                  "        BIM     here\n";
    check_run(reg, five, NULL);
    check_run(reg, "        EXIT\n",
              "Expected r10 = X'0000 0000 0000 0005' (5), found X'0000 0000 "
              "0000 0000' (0).");
    check_run(
        "; test: a\n        .equ    five, 3\n; expect: r10 = 5\n",
        "        .reg    five, r10\n        ES      five, 5\n"
        "        EXIT\n",
        "Line 1 uses the name five of a constant that the tests set: choose another "
        "name.");
    check_run(print, prints, NULL);
    check_run(print, five, "Expected '5' printed, found ''.");
    check_run(print, endless,
              "It printed more than 65536 characters, and was stopped.");
    check_run(trap, "        LOD     [r0], r1\n        EXIT\n", NULL);
    check_run(trap, five,
              "Expected trap unmapped-address, found: ended at 400020 with status 0.");
}

/* ---- Invalid lessons ------------------------------------------------------- */

TEST(notes)
{
    static const char goals[] =
        "12-it/test-a.s:2: expected 'goals: gold "
        "CLOCKS, silver CLOCKS, bronze CLOCKS' in rising order, once";
    static const char tolerance[] =
        "12-it/test-a.s:2: expected 'tolerance: LABEL NUMBER'";
    static const char *const rows[][2] = {
        { "; test: a\n", "" },
        { "x: .word 1\n", "12-it/test-a.s:1: the note '; test: SENTENCE' is missing" },
        { ";test:a\n; goals: gold 1, silver 2, bronze 3\n", "" },
        { "; test: a\n; goals: gold 2, silver 1, bronze 3\n", goals },
        { "; test: a\n; goals: gold 1, silver 2\n", goals },
        { "; test: a\n; goals: gold 0, silver 2, bronze 3\n", goals },
        { "; test: a\n; goals: gold 1, silver 2, bronze 3 4\n", goals },
        { "; test: a\n; goals: gold 1, gold 2, bronze 3\n", goals },
        { "; test: a\n; goals: gold 1, silver 2, bronze 3e9\n", goals },
        { "; test: a\n; goals: gold 1, silver 2, bronze 99999999999\n", goals },
        { "; test: a\n; goal: gold 1, silver 2, bronze 3\n",
          "12-it/test-a.s:2: unknown note; expected 'test:', 'goals:' or "
          "'tolerance:'" },
        { "; test: a\n; tolerance: y\n", tolerance },
        { "; test: a\n; tolerance: y -1\n", tolerance },
        { "; test: a\n; tolerance: y 1e999\n", tolerance },
        { "; test: a\n; tolerance: y 1 2\n",
          "12-it/test-a.s:2: expected nothing after the tolerance" },
        { "; test: a\n; test: b\n",
          "12-it/test-a.s:2: expected one sentence after 'test:', once" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(lesson) lesson = { 0 };
        c205_error error = { "" };
        assert_int_equal(open_with(&lesson, rows[i][0], &error), *rows[i][1] == '\0');
        assert_string_equal(error.message, rows[i][1]);
    }
}

TEST(refused)
{
    static const char answer[] = "        EXIT\n";
    static const char *const rows[][2] = {
        { "", "expects nothing" },
        { ".word\n", ":2:6: expected a number, a name or '(', found the end of the "
                     "statement" },
        { "; tolerance: y 1\nwant_x: .word 1\n",
          "has a tolerance for y, but no label want_y" },
        { "x: .word 1\n; expect: [x] = 1\n",
          ":3: a test cannot contain this expectation; put the expected data at "
          "want_LABEL" },
        { "want_y: EXIT\n", ": expected data at want_LABEL, not instructions" },
        { "want_: .word 1\n", ": expected data at want_LABEL, not want_" },
        { " .data\nx: .word 1\nwant_y:\n", "expects nothing" },
        { "; expect: r1 = 0\n; expect-model: x\n", ": unknown machine model 'x'" },
        { "; expect: r1 = 0\n; expect-model: cdc6600\n",
          ": programs cannot run on its model, which only gives times" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(lesson) lesson = { 0 };
        SCOPED_VALUE(lesson_verdict) verdict = { 0 };
        const char *wanted = rows[i][1];
        c205_error error = { "" };
        char test[200], message[200];
        snprintf(test, sizeof test, "; test: a\n%s", rows[i][0]);
        snprintf(message, sizeof message, "test-a.s%s%s", *wanted == ':' ? "" : " ",
                 wanted);
        assert_true(open_with(&lesson, test, &error));
        assert_false(lesson_grade(&verdict, &lesson, (struct lesson_draws){ 0 }, "my.s",
                                  answer, strlen(answer), &error));
        assert_string_equal(error.message, message);
    }
}

TEST(names)
{
    static const char *const first[] = { "3", "03", "first-vector" };
    struct lesson items[2] = { { 0 } };
    struct lessons lessons = { 2, items };
    c205_error error;
    assert_true(lesson_begin(&items[0], "03-first-vector", &error));
    assert_true(lesson_begin(&items[1], "11-sieve", &error));
    for (size_t i = 0; i < COUNT(first); i++)
        assert_ptr_equal(lessons_find(&lessons, first[i], &error), &items[0]);
    assert_ptr_equal(lessons_find(&lessons, "11-sieve", &error), &items[1]);
    assert_null(lessons_find(&lessons, "1", &error));
    assert_null(lessons_find(&lessons, "seive", &error));
    assert_string_equal(error.message, "unknown lesson 'seive'; did you mean 'sieve'?");
    lesson_free(&items[0]);
    lesson_free(&items[1]);
}

/* ---- Any texts -------------------------------------------------------------- */

static void mutate(char *text)
{
    static const char bytes[] = ";:,_.0159 \n\tgnwxy\"";
    size_t length = strlen(text);
    for (int64_t i = xorshift_between(&random_state, 0, 3); i > 0; i--)
        text[xorshift(&random_state) % length] =
            bytes[xorshift(&random_state) % (sizeof bytes - 1)];
}

/* The text must be rejected or graded. Both have a message. */
static void grade_any(const char *test, const char *answer)
{
    SCOPED_VALUE(lesson) lesson = { 0 };
    SCOPED_VALUE(lesson_verdict) verdict = { 0 };
    c205_error error = { "" };
    bool good = open_with(&lesson, test, &error)
                && lesson_grade(&verdict, &lesson, (struct lesson_draws){ 0 }, "my.s",
                                answer, strlen(answer), &error);
    FAIL_IF(good != (*error.message == '\0'), "'%s'\n%s\n%s", error.message, test,
            answer);
    FAIL_IF(good && !verdict.passed
                && verdict.report.count + verdict.trials[0].report.count == 0,
            "nothing is said\n%s\n%s", test, answer);
}

TEST(any)
{
    static const char test[] = "; test: a\n; goals: gold 7000, silver 8000, "
                               "bronze 9000\n; tolerance: y 1e-9\n"
                               "        .equ    n, 3\n        .data\n"
                               "x:      .word   1.0, 2.0, 3.5\n"
                               "want_y: .word   2.0, 4.0, 7.0\n"
                               "        .bitvector want_z, n, \"111\"\n"
                               "; expect: r1 = 0\n; expect-print: 3\n";
    static const char answer[] = "        .include \"core.s\"\n"
                                 "        .ifndef n\n        .equ    n, 5\n"
                                 "        .endif\n        .data\n"
                                 "        .vector x, n\n"
                                 "        .vector y, n\n"
                                 "        .bitvector z, n\n"
                                 "        .code\n        .regs   r16, a, b, c\n"
                                 "        descriptor a, x, n\n"
                                 "        descriptor b, y, n\n"
                                 "        descriptor c, z, n\n"
                                 "        ADDNV   [a], [a], [b]\n"
                                 "        CMPGEV  [a], r0, [c]\n"
                                 "        ES      r5, n\n"
                                 "        EXIT    r5, r0, 2\n        EXIT\n";
    check_run(test, answer, NULL);
    for (size_t i = 0; i < tries; i++) {
        char other_test[sizeof test], other_answer[sizeof answer];
        mutate(strcpy(other_test, test));
        mutate(strcpy(other_answer, answer));
        grade_any(other_test, other_answer);
    }
}

/* ---- Explanations of results ------------------------------------------------ */

enum { ELEMENTS = 16 };

/* Reads elements: "1.0" is a number, "2" an integer, "i" indefinite, "0 1" bits,
 * "p" LESSON_POISON. */
static size_t take_elements(const char *text, enum asm_contents contents,
                            c205_word elements[ELEMENTS])
{
    size_t count = 0;
    for (; *text; text += strspn(text, " ")) {
        size_t length = strcspn(text, " ");
        const char *end;
        elements[count++] = *text == 'p'           ? LESSON_POISON
                            : contents == ASM_BITS ? (c205_word)(*text == '1') << 63
                            : *text == 'i'         ? C205_INDEFINITE
                            : memchr(text, '.', length) ? c205_from_text(text, &end)
                                                        : c205_from_integer(atoi(text));
        text += length;
    }
    return count;
}

TEST(likeness)
{
    static const struct {
        enum asm_contents contents;
        const char *before, *wanted, *found, *said;
    } rows[] = {
        { ASM_WORDS, "0 0", "1.0 2.0", "0 0", "The run did not change it" },
        { ASM_WORDS, "1 1", "1.0 2.0", "0 0.0", "It contains only zeros" },
        { ASM_WORDS, "0 0", "1.0 2.0", "1 2", "The numbers are equal" },
        { ASM_WORDS, "0 0 0", "1.0 2.0 3.0", "9.0 1.0 2.0", "one place too late" },
        { ASM_WORDS, "0 0 0", "1.0 2.0 3.0", "2.0 3.0 9.0", "one place too early" },
        { ASM_WORDS, "0 0 0", "1.0 2.0 3.0", "3.0 2.0 1.0", "in reverse order" },
        { ASM_WORDS, "0 0 0", "1.0 1.0 1.0", "9.0 1.0 1.0", NULL },
        { ASM_WORDS, "0 0 0 0", "1.0 2.0 3.0 4.0", "2.0 1.0 3.0 4.0",
          "they are not sorted" },
        { ASM_WORDS, "0 0 0 0", "4.0 1.0 3.0 2.0", "1.0 4.0 3.0 2.0",
          "in another order" },
        { ASM_WORDS, "0 0", "1.0 -2.0", "-1.0 2.0", "The sign is wrong" },
        { ASM_WORDS, "0 0", "1.0 -2.0", "-1.0 -2.0", NULL },
        { ASM_BITS, "0 0 0", "0 1 1", "1 0 0", "Each bit is the opposite" },
        { ASM_BITS, "0 0 0", "0 0 1", "0 1 0", NULL },
        { ASM_BITS, "1 1 1", "0 0 1", "0 1 0", NULL },
        { ASM_BITS, "0 0 0 1", "0 0 1 1", "0 1 0 1", NULL },
        { ASM_BITS, "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0",
          "0 0 1 1 0 1 0 1 0 0 0 1 0 1 0 0", "0 1 1 0 1 0 1 0 0 0 1 0 1 0 0 1",
          "one place too early" },
        { ASM_WORDS, "0 0", "1.0 2.0", "1.0 2.00000000001", "Only the last" },
        { ASM_WORDS, "0 0", "1.0 2.0", "1.0 2.0001", NULL },
        { ASM_WORDS, "0 0", "1.0 2.0", "i 2.0", "Indefinite results from" },
        { ASM_WORDS, "0 0", "7.0 1.0", "6 1.0", "They are not normalised" },
        { ASM_WORDS, "0 0", "7 1.0", "6 1.0", NULL },
        { ASM_WORDS, "9.0 9.0 9.0", "1.0 2.0 3.0", "1.0 9.0 9.0",
          "Nothing new was stored after" },
        { ASM_WORDS, "9.0 9.0 9.0", "1.0 2.0 3.0", "1.0 9.0 8.0", NULL },
        { ASM_WORDS, "p p", "1.0 2.0", "p p", "Nothing was stored there." },
        { ASM_WORDS, "p p", "1.0 2.0", "1.0 p", "Nothing was stored at the wrong" },
        { ASM_WORDS, "p p p", "1.0 2.0 3.0", "p i 3.0", "Indefinite results from" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        c205_word before[ELEMENTS], wanted[ELEMENTS], found[ELEMENTS];
        SCOPED_VALUE(arena) arena = { 0 };
        struct lesson_report report = { .kept = &arena };
        struct test_item item = { .label = "y",
                                  .contents = rows[i].contents,
                                  .expected = wanted,
                                  .initial = before,
                                  .poisoned = *rows[i].before == 'p',
                                  .actual = found };
        take_elements(rows[i].before, rows[i].contents, before);
        take_elements(rows[i].found, rows[i].contents, found);
        item.count = take_elements(rows[i].wanted, rows[i].contents, wanted);
        assert_false(mismatch_report(&item, &report));
        FAIL_IF(rows[i].said ? !strstr(report.sentences[0], rows[i].said)
                             : !strstr(report.sentences[0], " (counted from 0).")
                                   || strstr(report.sentences[0], ").  "),
                "row %zu: %s", i, report.sentences[0]);
    }
}

COUNT_AND_SEED(tries, random_state);
