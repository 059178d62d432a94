/* test_cheating_answers.c - grades answers that contain the results of the public
 * tests, and solutions without one of their instructions. An answer that gets a medal
 * although it does not solve the exercise fails here. */
#include "tests/unit/cheating_answer.h"
#include "tests/unit/draw.h"
#include "tests/unit/unit.h"

/* Number of instructions that are removed from each solution, one at a time, and number
 * of draws that an answer must pass if it has passed one. */
static size_t tries = 3;
enum { MORE_DRAWS = 4 };

static void grade(struct lesson_verdict *verdict, const struct lesson *lesson,
                  size_t count, uint64_t first, const char *answer)
{
    struct lesson_draws draws = { count, first };
    *verdict = (struct lesson_verdict){ 0 };
    FAIL_IF(!lesson_grade(verdict, lesson, draws, "my.s", answer, strlen(answer),
                          &failure),
            "%s: %s", lesson->name, failure.message);
}

static void print_verdict(const struct lesson_verdict *verdict)
{
    struct sink sink = stream_sink(stdout);
    lesson_verdict_put(verdict, &sink);
}

/* Number of cheats that were remarked because they took few clocks. */
static size_t fast;

/* ---- Copied results -------------------------------------------------------- */

static bool is_remarked(const struct lesson_verdict *verdict, const char *text)
{
    for (size_t i = 0; i < verdict->remarks.count; i++)
        if (strstr(verdict->remarks.sentences[i], text))
            return true;
    return false;
}

/* Copying takes few clocks, and reads no input unless it recognises the test. */
static void check_remarks(const struct lesson *lesson, enum cheat cheat,
                          const struct lesson_verdict *verdict)
{
    struct object *test = NON_NULL(lesson_assemble_test(lesson->tests, &failure));
    bool constants = false, inputs = false;
    for (size_t i = 0; i < test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test->symbols[i];
        constants = constants || lesson_is_constant(symbol);
        inputs = inputs
                 || (symbol->is_label && !lesson_wanted(symbol->name)
                     && !object_symbol(test, formatted("want_%s", symbol->name)));
    }
    object_free(test);
    if (cheat == CHEAT_DATA)
        assert_int_equal(verdict->remarks.count, 0);
    else if (inputs && constants && cheat < CHEAT_LOOK_UP)
        assert_true(is_remarked(verdict, "It does not read "));
    assert_false(is_remarked(verdict, "The same code as solution.s."));
    fast += is_remarked(verdict, "It took ");
}

/* An answer that copies the results is right in all public tests, and in no fresh
 * test. */
static void check_cheat(const struct lesson *lesson, enum cheat cheat)
{
    SCOPED_VALUE(text_buffer) text = { 0 };
    SCOPED_VALUE(lesson_verdict) verdict;
    struct sink sink = text_buffer_sink(&text);
    bool right = true;
    cheat_write(lesson, cheat, &sink);
    grade(&verdict, lesson, 1, 0, text.text);
    for (size_t i = 0; i < lesson->test_count; i++)
        right = right && verdict.trials[i].right;
    if (right != (cheat != CHEAT_DATA) || verdict.passed || verdict.medal) {
        print_verdict(&verdict);
        fail_msg("%s: cheat %d", lesson->name, (int)cheat);
    }
    check_remarks(lesson, cheat, &verdict);
}

/* Fails if an instruction is missing and a single draw does not notice this. The answer
 * may pass if its results are right in all draws: the instruction only saved clocks, or
 * had no effect. */
static void check_removed(const struct lesson *lesson, size_t i)
{
    SCOPED_VALUE(text_buffer) text = { 0 };
    SCOPED_VALUE(lesson_verdict) one;
    SCOPED_VALUE(lesson_verdict) more = { 0 };
    struct sink sink = text_buffer_sink(&text);
    assert_true(cheat_remove(lesson->solution, i, &sink));
    grade(&one, lesson, 1, 0, text.text);
    if (!one.passed)
        return;
    grade(&more, lesson, MORE_DRAWS, 1 + below(1000000), text.text);
    if (!more.passed) {
        print_verdict(&more);
        fail_msg("%s: a draw accepts the solution without instruction %zu",
                 lesson->name, i);
    }
}

/* Checks all cheats, or the data and one random way to copy them. */
static void check_cheats(const struct lesson *lesson)
{
    check_cheat(lesson, CHEAT_DATA);
    if (thorough())
        for (int cheat = CHEAT_DATA + 1; cheat < CHEATS; cheat++)
            check_cheat(lesson, (enum cheat)cheat);
    else
        check_cheat(lesson, (enum cheat)(CHEAT_DATA + 1 + below(CHEATS - 1)));
}

static void check_lesson(const struct lesson *lesson)
{
    size_t count = 0;
    for (;;) {
        SCOPED_VALUE(text_buffer) text = { 0 };
        struct sink sink = text_buffer_sink(&text);
        if (!cheat_remove(lesson->solution, count, &sink))
            break;
        count++;
    }
    check_cheats(lesson);
    for (size_t i = 0; i < tries; i++)
        check_removed(lesson, below(count));
}

TEST(course)
{
    SCOPED_VALUE(lessons) lessons;
    REQUIRE(lessons_open(&lessons, &failure));
    fast = 0;
    for (size_t i = 0; i < lessons.count; i++)
        check_lesson(&lessons.items[i]);
    assert_true(fast > 0);
}

/* Copies a text, and replaces a word wherever it occurs. */
static void replace(const char *text, const char *old, const char *new,
                    const struct sink *sink)
{
    for (const char *at; (at = strstr(text, old)); text = at + strlen(old)) {
        sink->put(sink->context, text, (size_t)(at - text));
        sink_put(sink, new);
    }
    sink_put(sink, text);
}

/* The solution has the same code with other registers and comments. This is the only
 * remark. */
TEST(same_code)
{
    SCOPED_VALUE(lessons) lessons;
    REQUIRE(lessons_open(&lessons, &failure));
    for (size_t i = 0; i < lessons.count; i++) {
        SCOPED_VALUE(text_buffer) text = { 0 };
        SCOPED_VALUE(text_buffer) other = { 0 };
        SCOPED_VALUE(lesson_verdict) verdict;
        struct sink sink = text_buffer_sink(&text), again = text_buffer_sink(&other);
        replace(lessons.items[i].solution, ".regs   r", ".regs   r1", &sink);
        replace(text.text, ";", "; another comment", &again);
        grade(&verdict, &lessons.items[i], 1, 0, other.text);
        if (verdict.remarks.count != 1
            || !is_remarked(&verdict, "The same code as solution.s.")
            || verdict.points != 100) {
            print_verdict(&verdict);
            fail_msg("%s: %zu remarks, %u points", lessons.items[i].name,
                     verdict.remarks.count, verdict.points);
        }
    }
}

/* ---- The lessons of a teacher ---------------------------------------------- */

/* An exercise: y := 2 x, or y := x < 3 for bits. */
static const struct teacher {
    const char *input, *result, *work, *test;
} teachers[] = {
    { "        .vector x, n\n", "        .vector y, n\n",
      "        ADDNV   [xs], [xs], [ys]\n",
      "x:      .word   1.0, -3.5, 9.0\nwant_y: .word   2.0, -7.0, 18.0\n" },
    { "        .halfvector x, n\n", "        .halfvector y, n\n",
      "        ADDNV,H [xs], [xs], [ys]\n",
      "x:      .halfword 1.0, -3.5, 9.0\n        .align  64\n"
      "want_y: .halfword 2.0, -7.0, 18.0\n" },
    { "        .vector x, n\n", "        .bitvector y, n\n",
      "        CMPLTV  [xs], three, [ys]\n",
      "x:      .word   1.0, -3.5, 9.0\n        .bitvector want_y, 3, \"110\"\n" },
};

static const char *solution_of(const struct teacher *teacher)
{
    return formatted("        .include \"core.s\"\n"
                     "        .ifndef n\n        .equ    n, 5\n        .endif\n"
                     "        .data\n%s        .align  64\n%s        .code\n"
                     "        .regs   r10, xs, ys, three\n"
                     "        load_constant three, 3.0\n"
                     "        descriptor xs, x, n\n        descriptor ys, y, n\n"
                     "%s        EXIT\n",
                     teacher->input, teacher->result, teacher->work);
}

static const char *fresh_of(const struct teacher *teacher)
{
    bool half = strstr(teacher->input, "half");
    return formatted(
        "; test: another length\n"
        "        .ifdef  test_n\n        .equ    n, test_n\n"
        "        .else\n        .equ    n, 3 + draw %% 40\n        .endif\n"
        "        .data\nx:\n        .rept   n\n"
        "        .%s   float((\\+ * 7 + draw) %% 11) - 2.5\n"
        "        .endr\n        .align  64\n%.*s want_%s",
        half ? "halfword" : "word", (int)strcspn(teacher->result, "y") - 1,
        teacher->result, strchr(teacher->result, 'y'));
}

static void take(struct lesson *lesson, const char *file, const char *text)
{
    FAIL_IF(!lesson_take(lesson, file, text, strlen(text), &failure), "%s\n%s",
            failure.message, text);
}

static void open_lesson(struct lesson *lesson, const struct teacher *teacher)
{
    *lesson = (struct lesson){ 0 };
    REQUIRE(lesson_begin(lesson, "01-mine", &failure));
    take(lesson, "lesson.md", "# Mine\n");
    take(lesson, "start.s", "        EXIT\n");
    take(lesson, "test-three.s",
         formatted("; test: three\n; goals: gold 3000, silver 4000, bronze 5000\n"
                   "        .equ    n, 3\n        .data\n%s",
                   teacher->test));
    REQUIRE(lesson_end(lesson, &failure));
}

TEST(teachers)
{
    for (size_t i = 0; i < COUNT(teachers); i++) {
        SCOPED_VALUE(lesson) lesson;
        SCOPED_VALUE(lesson_verdict) verdict;
        const char *solution = solution_of(&teachers[i]);
        open_lesson(&lesson, &teachers[i]);
        take(&lesson, "solution.s", solution);
        take(&lesson, "fresh.s", fresh_of(&teachers[i]));
        grade(&verdict, &lesson, MORE_DRAWS, 0, solution);
        if (verdict.medal != MEDAL_GOLD) {
            print_verdict(&verdict);
            fail_msg("teacher %zu", i);
        }
        check_lesson(&lesson);
    }
}

/* A lesson without fresh inputs is not graded with draws. */
TEST(missing)
{
    static const char *const rows[][3] = {
        { "", "", "01-mine has no fresh.s, which fresh tests need" },
        { "; test: a\nx: .word 1\nwant_y: .space 1\n", "",
          "01-mine has no solution.s, which fresh tests need" },
        { "; test: a\nwant_y: .space 1\n", "        EXIT\n",
          "fresh.s has no label x, which test-three.s has" },
        { "; test: a\nx: .word 1\n; expect: r1 = 0\n", "        EXIT\n",
          "fresh.s has no label want_y, which test-three.s has" },
        { "; test: a\nx: .word 1\nwant_y: .space 1\n", "        EXIT\n",
          "solution.s fails in fresh.s: The answer has no label y, which must hold "
          "results." },
        { "; test: a\nx: .word 1\nwant_y: .space 1\n",
          "        .data\ny: .space 1\n        .code\n        LOD     [r0], r1\n",
          "solution.s fails in fresh.s: It was stopped by a trap:" },
        { "; test: a\nx: .word 1\nwant_y: .space 1\n",
          "        .data\ny: .space 1\n        .code\n        EXIT\n",
          "solution.s fails in fresh.s: it stores nothing at y" },
    };
    static const char answer[] = "        .data\ny: .word 2.0, -7.0, 18.0\n"
                                 "        .code\n        EXIT\n";
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(lesson) lesson;
        SCOPED_VALUE(lesson_verdict) verdict = { 0 };
        struct lesson_draws draws = { .count = 1 };
        struct teacher teacher = teachers[0];
        c205_error error = { "" };
        teacher.test = "x: .word 1\ny: .word 2.0\nwant_y: .word 2.0\n";
        open_lesson(&lesson, &teacher);
        if (*rows[i][0])
            take(&lesson, "fresh.s", rows[i][0]);
        if (*rows[i][1])
            take(&lesson, "solution.s", rows[i][1]);
        assert_false(lesson_grade(&verdict, &lesson, draws, "my.s", answer,
                                  strlen(answer), &error));
        FAIL_IF(strncmp(error.message, rows[i][2], strlen(rows[i][2])) != 0,
                "row %zu: %s", i, error.message);
    }
}

COUNT_AND_SEED(tries, random_state);
