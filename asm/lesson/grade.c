/* grade.c - judges an answer by the tests of its lesson and by fresh tests, and builds
 * the verdict. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "vm/error.h"
#include "vm/hash.h"

/* The state of grading one answer. */
struct grading {
    struct lesson_verdict *verdict;
    const struct lesson *lesson;
    struct lesson_draws draws;
    const char *text;
    size_t length;
    struct test_case *tests; /* the tests of the lesson that have begun */
    c205_error *error;       /* error of the lesson */
};

/* ---- One test -------------------------------------------------------------- */

static enum medal medal_for(const struct lesson_test *test, uint64_t clocks)
{
    enum medal medal = MEDAL_NONE;
    while (medal < MEDAL_GOLD && clocks <= test->goals[medal + 1])
        medal++;
    return medal;
}

static void judge(struct lesson_trial *trial, struct answer_run *run)
{
    trial->clocks = run->clocks;
    trial->right = answer_is_right(run);
    trial->passed = trial->right;
    if (!trial->right || !trial->test->has_goals)
        return;
    trial->medal = medal_for(trial->test, trial->clocks);
    trial->passed = trial->medal != MEDAL_NONE;
    if (trial->medal != MEDAL_GOLD)
        performance_hint_report(trial, run->machine, run->profile, &trial->report);
}

static bool try_case(struct grading *grading, struct lesson_trial *trial,
                     const struct test_case *test)
{
    struct lesson_verdict *verdict = grading->verdict;
    struct answer_run run = { .name = verdict->answer,
                              .text = grading->text,
                              .length = grading->length,
                              .test = test,
                              .checked = true,
                              .report = &trial->report,
                              .general = &verdict->report,
                              .kept = &verdict->kept,
                              .error = grading->error };
    bool good = answer_run(&run);
    if (good)
        judge(trial, &run);
    if (good && !trial->right && run.object)
        answer_report_warnings(&run, verdict);
    answer_run_free(&run);
    return good;
}

static bool try_test(struct grading *grading, size_t i)
{
    struct lesson_trial *trial = &grading->verdict->trials[i];
    return test_case_open(&grading->tests[i], trial->test, NULL, NULL, grading->error)
           && try_case(grading, trial, &grading->tests[i]);
}

/* ---- Fresh tests ----------------------------------------------------------- */

/* Returns the number of the first draw for an answer. The text determines it, so an
 * answer cannot contain the results of its own fresh tests: they change with it. */
static uint64_t draw_of(const char *text)
{
    return 1 + hash_text(HASH_BEGIN, text) % LESSON_DRAWS;
}

/* Reports how to see the inputs, and remarks that an answer is too fast to be true. */
static void finish_fresh(struct lesson_verdict *verdict, struct lesson_trial *trial,
                         uint64_t solution_clocks)
{
    if (!trial->right)
        report_printf(&trial->report,
                      "c205 check LESSON --fresh-seed %" PRIu64 " prints its data.",
                      trial->draw);
    if (trial->test->has_goals && trial->clocks > 0
        && trial->clocks < solution_clocks / 2)
        report_printf(&verdict->remarks,
                      "It took %" PRIu64 " clocks in %s, and the solution %" PRIu64 ".",
                      trial->clocks, trial->test->name, solution_clocks);
}

/* Tries a fresh test that is like test i of the lesson, or has other lengths. */
static bool try_fresh(struct grading *grading, size_t i, bool like, uint64_t draw)
{
    struct lesson_verdict *verdict = grading->verdict;
    struct lesson_trial *trial = &verdict->trials[verdict->count];
    struct lesson_test *notes = arena_take(&verdict->kept, sizeof *notes);
    struct fresh_test fresh = { .test = { 0 } };
    bool good = notes ? fresh_open(&fresh, grading->lesson, &grading->tests[i], like,
                                   draw, &verdict->kept, grading->error)
                      : error_set(grading->error, "out of memory");
    if (good) {
        *notes = fresh.notes;
        trial->test = notes;
        trial->draw = draw;
        trial->like = like ? &grading->lesson->tests[i] : NULL;
        verdict->count++;
        good = try_case(grading, trial, &fresh.test);
        finish_fresh(verdict, trial, fresh.clocks);
    }
    fresh_close(&fresh);
    return good;
}

/* Tries the fresh tests of a draw. A fresh test is omitted if the answer has failed the
 * test that it is like, and the one of other lengths if the answer has failed any. */
static bool try_draw(struct grading *grading, uint64_t draw)
{
    const struct lesson *lesson = grading->lesson;
    bool good = true, right = true;
    for (size_t i = 0; good && i < lesson->test_count; i++)
        if (grading->verdict->trials[i].right)
            good = try_fresh(grading, i, true, draw);
        else
            right = false;
    return good && (!right || try_fresh(grading, 0, false, draw));
}

/* ---- All tests ------------------------------------------------------------- */

/* Returns true if all fresh tests that are like a test are right. NULL: the fresh tests
 * of other lengths, of which there is at least one. */
static bool is_right_afresh(const struct lesson_verdict *verdict,
                            const struct lesson_test *like)
{
    bool right = like, all = true;
    for (size_t i = 0; i < verdict->count; i++) {
        const struct lesson_trial *trial = &verdict->trials[i];
        if (trial->draw > 0 && trial->like == like) {
            right = true;
            all = all && trial->right;
        }
    }
    return right && all;
}

/* Gives points: 70 for the share of right tests, and 10 for each rank of the medal. A
 * lesson without medals gives 100 for the share. */
static void give_points(struct lesson_verdict *verdict, bool medals, bool fresh)
{
    enum { ALL = 100, RIGHT = 70, RANK = 10 };
    size_t tests = verdict->lesson->test_count;
    verdict->right_count = fresh && is_right_afresh(verdict, NULL);
    for (size_t i = 0; i < tests; i++)
        verdict->right_count += verdict->trials[i].right
                                && is_right_afresh(verdict, &verdict->lesson->tests[i]);
    verdict->points = (unsigned)((medals ? RIGHT : ALL) * verdict->right_count
                                 / verdict->of_count)
                      + RANK * verdict->medal;
}

static void conclude(struct lesson_verdict *verdict, bool fresh)
{
    bool medals = false;
    verdict->passed = true;
    verdict->medal = MEDAL_GOLD;
    for (size_t i = 0; i < verdict->count; i++) {
        const struct lesson_trial *trial = &verdict->trials[i];
        verdict->passed = verdict->passed && trial->passed;
        if (!trial->test->has_goals)
            continue;
        medals = true;
        if (trial->medal < verdict->medal)
            verdict->medal = trial->medal;
        if (trial->right && trial->draw == 0 && trial->clocks > verdict->clocks)
            verdict->clocks = trial->clocks;
    }
    if (!medals || !verdict->passed)
        verdict->medal = MEDAL_NONE;
    give_points(verdict, medals, fresh);
}

static bool grade_begin(struct grading *grading, const char *name)
{
    struct lesson_verdict *verdict = grading->verdict;
    const struct lesson *lesson = grading->lesson;
    size_t fresh = grading->draws.count * (lesson->test_count + 1);
    size_t most = lesson->test_count + fresh;
    verdict->lesson = lesson;
    verdict->answer = name;
    verdict->count = lesson->test_count;
    verdict->of_count = lesson->test_count + (fresh > 0);
    verdict->report.kept = &verdict->kept;
    verdict->remarks.kept = &verdict->kept;
    if (fresh > 0 && !lesson_has_fresh(lesson, grading->error))
        return false;
    verdict->trials = arena_take(&verdict->kept, most * sizeof *verdict->trials);
    grading->tests = arena_take(&verdict->kept, most * sizeof *grading->tests);
    if (verdict->kept.failed)
        return error_set(grading->error, "out of memory");
    for (size_t i = 0; i < most; i++) {
        verdict->trials[i].test = i < verdict->count ? &lesson->tests[i] : NULL;
        verdict->trials[i].report.kept = &verdict->kept;
    }
    return true;
}

void lesson_refuse(struct lesson_verdict *verdict, const struct lesson *lesson,
                   const char *name, const char *reason)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    verdict->lesson = lesson;
    verdict->answer = name;
    verdict->report.kept = &verdict->kept;
    sink_put(&sink, name);
    sink_put(&sink, ": not graded: ");
    sink_put(&sink, reason);
    report_buffer(&verdict->report, &text);
}

/* Returns true if the answer is right in all tests of the lesson. */
static bool all_right(const struct lesson_verdict *verdict)
{
    size_t i = 0;
    while (i < verdict->lesson->test_count && verdict->trials[i].right)
        i++;
    return i == verdict->lesson->test_count;
}

/* Runs the tests in order, then the fresh tests. Stops after a test with a report that
 * would be the same for all tests. */
static bool try_tests(struct grading *grading)
{
    struct lesson_verdict *verdict = grading->verdict;
    const struct lesson_report *general = &verdict->report;
    bool fresh = grading->draws.count > 0;
    for (size_t i = 0; i < grading->lesson->test_count && general->count == 0; i++)
        if (!try_test(grading, i))
            return false;
    for (size_t i = 0; i < grading->draws.count && general->count == 0; i++)
        if (!try_draw(grading, grading->draws.first + i))
            return false;
    verdict->graded = general->count == 0;
    if (!verdict->graded)
        return true;
    conclude(verdict, fresh);
    return !fresh || !all_right(verdict)
           || lesson_find_unread(verdict, grading->tests, grading->text,
                                 grading->length, grading->error);
}

/* Grades an answer. A test that is not right reports the warnings of the answer. If the
 * answer cannot run in the tests, those of the assembler are reported here, because they
 * may explain the failure. */
bool lesson_grade(struct lesson_verdict *verdict, const struct lesson *lesson,
                  struct lesson_draws draws, const char *name, const char *text,
                  size_t length, c205_error *error)
{
    static const struct asm_options options = { .sealed = true };
    struct diagnostics said = { 0 };
    struct object *object;
    bool good = true;
    struct grading grading = { .verdict = verdict,
                               .lesson = lesson,
                               .draws = draws,
                               .text = text,
                               .length = length,
                               .error = error };
    if (draws.first == 0)
        grading.draws.first = draw_of(text);
    if (!grade_begin(&grading, name))
        return false;
    object = assemble_bytes(name, text, length, &options, &said);
    if (!object)
        report_diagnostics(&verdict->report, "The answer cannot be assembled:", &said,
                           SEVERITY_ERROR);
    else
        good = try_tests(&grading);
    for (size_t i = 0; i < lesson->test_count; i++)
        test_case_close(&grading.tests[i]);
    if (object && good && draws.count > 0)
        lesson_compare_code(verdict, object);
    if (object && !verdict->graded && said.count > 0)
        report_diagnostics(&verdict->report, "The assembler warns:", &said,
                           SEVERITY_WARNING);
    diagnostics_free(&said);
    object_free(object);
    return good && (!verdict->kept.failed || error_set(error, "out of memory"));
}
