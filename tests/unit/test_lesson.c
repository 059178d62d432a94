/* test_lesson.c - the verdicts on random answers are compared with the known mistakes
 * of the answers, and the clocks of the answers with plain runs. A mistake that is not
 * reported, or a sentence about something else, fails here. */
#include <inttypes.h>
#include <math.h>

#include "asm/measure/line_profile.h"
#include "base/accounts.h"
#include "base/json_read.h"
#include "tests/unit/draw.h"
#include "tests/unit/random_verdict.h"
#include "tests/unit/saved_machine.h"

static size_t tries = 150;

/* ---- Plain runs ------------------------------------------------------------ */

/* A run of an answer in a test, without the grader. */
struct plain_trial {
    struct object *object;
    c205_model *model;
    c205 *machine;
    struct line_profile *profile;
};

static void run_plainly(const struct random_lesson *drawn,
                        const struct random_test *test, struct plain_trial *plain)
{
    struct asm_define defines[] = { { "n", (int64_t)test->n }, { NULL, 0 } };
    struct asm_options options = { .defines = defines };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    plain->object = assemble_text("my.s", drawn->answer, &options, &errors);
    FAIL_IF(!plain->object, "%s\n%s", errors.items[0].message, drawn->answer);
    plain->model = c205_model_find(test->model, &failure);
    plain->machine = machine_with(&plain->object->program, plain->model);
    plain->profile = line_profile_new(plain->object);
    const struct asm_symbol *x = object_symbol(plain->object, "x");
    unsigned width = random_width(drawn);

    for (size_t i = 0; i < test->n; i++) {
        uint64_t at = (uint64_t)x->value + i * width;
        c205_word word;
        assert_true(c205_read(plain->machine, at / 64 * 64, &word, 1));
        word |= test->x[i] >> at % 64;
        c205_write(plain->machine, at / 64 * 64, &word, 1);
    }
    if (test->warm)
        c205_warm(plain->machine);
    c205_listen(plain->machine, line_profile_listen, plain->profile);
    c205_run(plain->machine, 100000);
}

static void plain_free(struct plain_trial *plain)
{
    line_profile_free(plain->profile);
    c205_free(plain->machine);
    c205_model_free(plain->model);
    object_free(plain->object);
}

/* ---- Goals ----------------------------------------------------------------- */

/* ---- Output ---------------------------------------------------------------- */

/* Fails unless a sentence of the verdict begins with the formatted text. */
#define check_begins(drawn, trial, sentence, ...) \
    check_sentence(drawn, trial, sentence, formatted(__VA_ARGS__))

static void check_sentence(const struct random_lesson *drawn,
                           const struct lesson_trial *trial, size_t sentence,
                           const char *wanted)
{
    FAIL_IF(sentence >= trial->report.count, "'%s' is not said\n%s", wanted,
            drawn->answer);
    FAIL_IF(strncmp(trial->report.sentences[sentence], wanted, strlen(wanted)) != 0,
            "'%s' is said for '%s'\n%s", trial->report.sentences[sentence], wanted,
            drawn->answer);
}

/* ---- Slow texts ------------------------------------------------------------ */

static uint64_t clocks_of(const struct profile_row *row)
{
    uint64_t sum = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++)
        sum += row->clocks[cause];
    return sum;
}

static void check_cause(const struct random_lesson *drawn,
                        const struct lesson_trial *trial,
                        const struct plain_trial *plain)
{
    SCOPED_VALUE(accounts) accounts = { .model = plain->model };
    int most = 0, wait = 1;
    assert_true(accounts_add(&accounts, plain->machine));
    c205_account all = accounts_together(&accounts);
    for (int cause = 1; cause < C205_CAUSES; cause++) {
        if (all.clocks[cause] > all.clocks[most])
            most = cause;
        if (all.clocks[cause] > all.clocks[wait])
            wait = cause;
    }
    if (most != C205_ISSUE || all.clocks[wait] == 0 || all.vector_instructions > 0
        || all.instructions >= 1000)
        wait = 0;
    if (wait > 0)
        most = wait;
    check_begins(drawn, trial, 1, "%s is %s: %" PRIu64 " clocks, %.0f %%.  ",
                 wait > 0 ? "The longest wait" : "The largest part",
                 c205_cause_name((c205_cause)most), all.clocks[most],
                 floor(100.0 * (double)all.clocks[most] / (double)trial->clocks + 0.5));
}

/* Checks the lines with most clocks. Equal lines are in the order of the source. At
 * most three lines are listed, each with at least a tenth of the clocks. */
static void check_lines(const struct random_lesson *drawn,
                        const struct lesson_trial *trial,
                        const struct plain_trial *plain)
{
    enum { LINES = 200 };
    bool reported[LINES] = { false };
    size_t count = line_profile_count(plain->profile);
    assert_true(count < LINES);
    for (size_t i = 2;; i++) {
        const struct profile_row *row = NULL;
        for (size_t k = 0; k < count; k++) {
            const struct profile_row *other = line_profile_row(plain->profile, k);
            if (other->file && !reported[k]
                && clocks_of(other) > (row ? clocks_of(row) : 0))
                row = other;
        }
        if (!row || i == 5 || (i > 2 && clocks_of(row) * 10 < trial->clocks)) {
            /* If the program is a scalar loop, the verdict then reports this. */
            uint64_t instructions = 0;
            for (size_t k = 0; k < c205_account_count(plain->machine); k++) {
                const c205_account *account = c205_account_at(plain->machine, k);
                instructions += account->instructions;
                if (account->vector_instructions > 0)
                    instructions = 0;
            }
            assert_int_equal(trial->report.count, i + (instructions >= 1000));
            return;
        }
        bool link = strstr(row->source, "; a pair");
        reported[row - line_profile_row(plain->profile, 0)] = true;
        check_begins(drawn, trial, i,
                     "Line %zu took %" PRIu64 " clocks, %.0f %%, in %" PRIu64
                     " %s%s:%s",
                     row->number, clocks_of(row),
                     floor(100.0 * (double)clocks_of(row) / (double)trial->clocks
                           + 0.5),
                     row->executions, link ? "linked pair" : "instruction",
                     row->executions == 1 ? "" : "s",
                     link ? "\n    MPYSV   [xs], value, [one]\n    ADDNV   [one], "
                            "[xs], [ys]"
                          : " ");
    }
}

static void check_right(const struct random_lesson *drawn,
                        const struct lesson_trial *trial,
                        const struct plain_trial *plain, enum medal medal)
{
    FAIL_IF(!trial->right, "%s\n%s", trial->report.sentences[0], drawn->answer);
    assert_int_equal(trial->clocks, c205_clock(plain->machine));
    assert_int_equal(trial->medal, trial->test->has_goals ? medal : MEDAL_NONE);
    assert_int_equal(trial->passed, !trial->test->has_goals || medal);
    if (!trial->test->has_goals || medal == MEDAL_GOLD) {
        assert_int_equal(trial->report.count, 0);
        return;
    }
    uint64_t goal = trial->test->goals[medal + 1];
    check_begins(drawn, trial, 0,
                 "It took %" PRIu64 " clocks, %" PRIu64 " more than the %" PRIu64
                 " of %s.",
                 trial->clocks, trial->clocks - goal, goal, medal_name(medal + 1));
    check_cause(drawn, trial, plain);
    check_lines(drawn, trial, plain);
}

/* ---- Verdicts -------------------------------------------------------------- */

static const struct lesson_trial *trial_of(const struct lesson_verdict *verdict,
                                           size_t n)
{
    char tries_text[40];
    snprintf(tries_text, sizeof tries_text, "so many as %zu", n);
    for (size_t i = 0; i < verdict->count; i++)
        if (strcmp(verdict->trials[i].test->tries, tries_text) == 0)
            return &verdict->trials[i];
    fail_msg("no trial %s", tries_text);
    return NULL;
}

static void check_texts(const struct lesson_report *report,
                        const struct json_value *object)
{
    const struct json_value *text = json_member_first(object, "report");
    for (size_t i = 0; i < report->count; i++, text = text->next)
        assert_string_equal(text->text, report->sentences[i]);
    assert_null(text);
}

static void check_json(const struct lesson_verdict *verdict)
{
    SCOPED_VALUE(text_buffer) line = { 0 };
    SCOPED_VALUE(arena) arena = { 0 };
    const struct json_value *read, *test;
    struct json *json = json_open_line(&line, &failure);
    lesson_verdict_json(verdict, json);
    assert_true(json_close(json, &failure));
    read = NON_NULL(json_read(&arena, line.text, line.length, &failure));
    assert_string_equal(json_member_text(read, "lesson"), "drawn");
    assert_string_equal(json_member_text(read, "title"), "Drawn at random");
    assert_string_equal(json_member_text(read, "answer"), "my.s");
    assert_string_equal(json_member_text(read, "medal"), medal_name(verdict->medal));
    assert_int_equal(json_member_truth(read, "passed", false), verdict->passed);
    assert_int_equal(json_member(read, "clocks")->number, verdict->clocks);
    check_texts(&verdict->report, read);
    test = json_member_first(read, "tests");
    for (size_t i = 0; i < verdict->count; i++, test = test->next) {
        const struct lesson_trial *trial = &verdict->trials[i];
        assert_string_equal(json_member_text(test, "name"), trial->test->name);
        assert_int_equal(json_member_truth(test, "right", false), trial->right);
        assert_int_equal(json_member(test, "clocks")->number, trial->clocks);
        check_texts(&trial->report, test);
        if (trial->test->has_goals)
            assert_int_equal(json_member(json_member(test, "goals"), "silver")->number,
                             trial->test->goals[MEDAL_SILVER]);
        else
            assert_null(json_member_first(test, "goals"));
    }
}

static void check_whole(const struct lesson_verdict *verdict)
{
    enum medal worst = MEDAL_GOLD;
    bool passed = true, goals = false;
    uint64_t slowest = 0;
    for (size_t i = 0; i < verdict->count; i++) {
        const struct lesson_trial *trial = &verdict->trials[i];
        passed = passed && trial->passed;
        if (i > 0)
            assert_true(trial->test->has_goals
                        >= verdict->trials[i - 1].test->has_goals);
        if (!trial->test->has_goals)
            continue;
        goals = true;
        worst = trial->medal < worst ? trial->medal : worst;
        if (trial->right && trial->clocks > slowest)
            slowest = trial->clocks;
    }
    assert_int_equal(verdict->passed, passed);
    assert_int_equal(verdict->medal, passed && goals ? worst : MEDAL_NONE);
    assert_int_equal(verdict->clocks, slowest);
    check_json(verdict);
}

static void check_trial(const struct random_lesson *drawn, size_t index,
                        const struct lesson_trial *trial,
                        const struct plain_trial *plain, enum medal medal)
{
    bool faulty = index == drawn->faulty;
    if (faulty && drawn->fault == FAULT_TRAP) {
        assert_int_equal(trial->report.count, 1);
        check_begins(
            drawn, trial, 0,
            "It was stopped by a trap:\nmy.s:%zu:9: error: trap unmapped-address",
            random_fault_line(drawn));
        assert_int_equal(trial->clocks, c205_clock(plain->machine));
    } else if (faulty && drawn->fault == FAULT_LOOP) {
        assert_int_equal(trial->report.count, 1);
        check_begins(drawn, trial, 0,
                     "It had not ended after %" PRIu64
                     " clocks: look for an endless loop.  It was at line %zu: "
                     "here:   BIM     here ; fault",
                     trial->clocks, random_fault_line(drawn));
    } else if (faulty && random_count_wrong(drawn) > 0) {
        SCOPED_VALUE(text_buffer) text = { 0 };
        struct sink sink = text_buffer_sink(&text);
        const char *likeness = random_likeness(drawn);
        random_mismatch(drawn, random_count_wrong(drawn), &sink);
        sink_put(&sink, likeness ? likeness : "");
        assert_false(trial->right);
        assert_int_equal(trial->report.count, 1);
        check_begins(drawn, trial, 0, "%s", text.text);
        if (likeness)
            assert_string_equal(trial->report.sentences[0], text.text);
    } else
        check_right(drawn, trial, plain, medal);
}

static void check_drawn(struct random_lesson *drawn)
{
    struct plain_trial plain[DRAWN_TESTS];
    enum medal medals[DRAWN_TESTS];
    SCOPED_VALUE(lesson) lesson;
    SCOPED_VALUE(lesson_verdict) verdict;
    for (size_t i = 0; i < drawn->count; i++) {
        run_plainly(drawn, &drawn->tests[i], &plain[i]);
        medals[i] = (enum medal)below(MEDALS);
        /* The clocks must get exactly this medal. The goals often leave no margin. */
        struct random_test *test = &drawn->tests[i];
        uint64_t above_it = c205_clock(plain[i].machine), below_it = above_it - 1;

        for (int k = (int)medals[i]; k > MEDAL_NONE; k--) {
            above_it += below(2) * below(100);
            test->goals[k] = above_it;
        }
        for (int k = (int)medals[i] + 1; k < MEDALS; k++) {
            if (below(2))
                below_it -= below(below_it);
            test->goals[k] = below_it;
        }
    }
    random_open(drawn, &lesson);
    grade_well(&verdict, &lesson, drawn->answer);
    for (size_t i = 0; i < drawn->count; i++) {
        const struct lesson_trial *trial = trial_of(&verdict, drawn->tests[i].n);
        assert_int_equal(trial->test->warm, drawn->tests[i].warm);
        check_trial(drawn, i, trial, &plain[i], medals[i]);
    }
    check_whole(&verdict);
    for (size_t i = 0; i < drawn->count; i++)
        plain_free(&plain[i]);
}

TEST(drawn)
{
    size_t seen[DRAWN_FAULTS] = { 0 };
    for (size_t i = 0; i < tries; i++) {
        struct random_lesson drawn = { 0 };
        draw_lesson(&drawn, &random_state);
        check_drawn(&drawn);
        seen[drawn.fault]++;
    }
    for (int i = 0; i < DRAWN_FAULTS; i++)
        assert_true(seen[i] > tries / 100);
}

/* Correct answers that use other methods are compared with the goals. */
TEST(ways)
{
    for (size_t i = 0; i < tries; i++) {
        struct random_lesson drawn = { 0 };
        do
            draw_lesson(&drawn, &random_state);
        while (drawn.way == WAY_VECTOR || !drawn.tests[drawn.faulty].has_goals);
        check_drawn(&drawn);
    }
}

/* ---- Sentences about all tests --------------------------------------------- */

/* Grades a copy of the answer in which the first occurrence of a text is replaced. */
static void check_said(const struct random_lesson *drawn, const char *old,
                       const char *new, bool of_all, const char *wanted)
{
    SCOPED_VALUE(lesson) lesson;
    SCOPED_VALUE(lesson_verdict) verdict;
    const char *at = NON_NULL(strstr(drawn->answer, old));
    char answer[sizeof drawn->answer + 200];
    snprintf(answer, sizeof answer, "%.*s%s%s", (int)(at - drawn->answer),
             drawn->answer, new, at + strlen(old));
    random_open(drawn, &lesson);
    grade_well(&verdict, &lesson, answer);
    const struct lesson_report *report = of_all ? &verdict.report
                                                : &trial_of(&verdict, drawn->tests[0].n)
                                                       ->report;
    assert_int_equal(verdict.graded, !of_all);
    assert_false(verdict.passed);
    FAIL_IF(report->count != 1
                || strncmp(report->sentences[0], wanted, strlen(wanted)) != 0,
            "'%s' for '%s'\n%s", report->count ? report->sentences[0] : "nothing",
            wanted, answer);
    check_json(&verdict);
}

/* A change of a correct answer, and the sentence that it causes, about all tests or
 * about the first test. "%zu" is the length of the first test minus `less`. */
static const struct {
    const char *old, *new;
    bool of_all;
    size_t less;
    const char *wanted;
} said[] = {
    { "y, n\n", "z, n\ny = 5\n", true, 0,
      "The answer cannot be assembled:\nmy.s:9:1: error: " },
    { ".vector y, n\n", ".vector z, n\n.equ y, z\n", true, 0,
      "The answer has no label y, which must hold results." },
    { ".vector y,", ".halfvector y,", true, 0,
      "Expected words at the answer's label y, but there are half words." },
    { ".ifndef n\n", ".ifndef n\n        .endif\n        .if 1\n", true, 0,
      "Line 5 sets n, which the tests set: put '.ifndef n' before it and '.endif' "
      "after it." },
    { ".vector y, n\n", ".vector y, n - 1\n", false, 1, "y has room for %zu word" },
    { "        EXIT\n",
      "        .if n == 5\n        EXIT\n        .else\n        NOPE\n        .endif\n",
      false, 0, "With n = %zu the answer cannot be assembled:\nmy.s:" },
    { "        EXIT\n", "        ES      value, 3\n        EXIT    value\n", false, 0,
      "It ended with the status 3, not with 0." },
};

TEST(said_of_all)
{
    struct random_lesson drawn = { 0 };
    for (size_t i = 0; i < 10 * COUNT(said); i++) {
        size_t row = i % COUNT(said);
        char wanted[200];
        if (row == 0) {
            do
                draw_lesson(&drawn, &random_state);
            while (drawn.fault != FAULT_NONE || drawn.kind != DRAWN_WORDS
                   || drawn.tests[0].n == 1);
            for (size_t k = 0; k < drawn.count; k++)
                drawn.tests[k].has_goals = false;
        }
        snprintf(wanted, sizeof wanted, said[row].wanted,
                 drawn.tests[0].n - said[row].less);
        check_said(&drawn, said[row].old, said[row].new, said[row].of_all, wanted);
    }
}

COUNT_AND_SEED(tries, random_state);
