/* fresh.c - makes tests with new inputs from fresh.s, and their expected data from
 * solution.s. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "vm/error.h"

bool lesson_has_fresh(const struct lesson *lesson, c205_error *error)
{
    const char *missing = !lesson->fresh.text ? "fresh.s"
                          : !lesson->solution ? "solution.s"
                                              : NULL;
    return !missing
           || error_set(error,
                        "%.80s has no %s, which fresh tests need (--no-fresh grades "
                        "without them)",
                        lesson->folder, missing);
}

/* ---- Constants ------------------------------------------------------------- */

/* The constants that fresh.s receives: `draw`, and test_NAME for each constant NAME of
 * the test that the fresh test is like. */
static struct asm_define *make_defines(const struct object *like, uint64_t draw,
                                       struct arena *kept)
{
    size_t most = like ? like->symbol_count : 0, count = 0;
    struct asm_define *defines = arena_take(kept, (most + 2) * sizeof *defines);
    if (defines)
        defines[count++] = (struct asm_define){ "draw", (int64_t)draw };
    for (size_t i = 0; defines && i < most; i++) {
        struct text_line name = { 0 };
        struct sink sink = text_line_sink(&name);
        if (!lesson_is_constant(&like->symbols[i]))
            continue;
        sink_print(&sink, "test_%s", like->symbols[i].name);
        defines[count++] = (struct asm_define){
            arena_text(kept, name.text, name.length), like->symbols[i].value
        };
    }
    return kept->failed ? NULL : defines;
}

/* Rejects a fresh.s without a label of the inputs or results of a test. Initial data of
 * results are optional. */
static bool check_labels(const struct object *fresh, const struct object *test,
                         const char *file, c205_error *error)
{
    for (size_t i = 0; i < test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test->symbols[i];
        const char *name = symbol->name;
        struct text_line wanted = { 0 };
        struct sink sink = text_line_sink(&wanted);
        sink_print(&sink, "want_%s", name);
        if (symbol->is_label && symbol->contents != ASM_NOTHING
            && !object_symbol(fresh, name) && !object_symbol(test, wanted.text))
            return error_set(error, "fresh.s has no label %.60s, which %.48s has", name,
                             file);
    }
    return true;
}

/* ---- The solution ---------------------------------------------------------- */

/* Runs the solution in a test. Sets the expected data to its results if `keep`, and
 * otherwise compares them. */
static bool run_solution(const struct lesson *lesson, const struct test_case *test,
                         bool keep, uint64_t *clocks, c205_error *error)
{
    struct arena kept = { 0 };
    struct lesson_report report = { .kept = &kept };
    struct answer_run run = { .name = "solution.s",
                              .text = lesson->solution,
                              .length = strlen(lesson->solution),
                              .test = test,
                              .report = &report,
                              .general = &report,
                              .kept = &kept,
                              .error = error };
    bool good = answer_run(&run);
    if (good && (!run.ended || (!keep && !answer_is_right(&run)))) {
        const char *why = report.count > 0 ? report.sentences[0] : "out of memory";
        good = error_set(error, "solution.s fails in %.48s: %.160s", test->notes->file,
                         why);
    }
    if (good && keep)
        good = test_data_keep(&run.data, test->data, error);
    *clocks = run.clocks;
    answer_run_free(&run);
    arena_free(&kept);
    return good;
}

/* ---- The test -------------------------------------------------------------- */

static const struct lesson_tolerance *
join_tolerances(const struct lesson_tolerance *of_fresh,
                const struct lesson_tolerance *of_test, struct arena *kept)
{
    const struct lesson_tolerance *all = of_fresh;
    for (; of_test; of_test = of_test->next) {
        struct lesson_tolerance *copy = arena_take(kept, sizeof *copy);
        const struct lesson_tolerance *own = of_fresh;
        if (!copy)
            return NULL;
        while (own && strcmp(own->label, of_test->label) != 0)
            own = own->next;
        *copy = *of_test;
        if (own && own->most > copy->most)
            copy->most = own->most;
        copy->next = all;
        all = copy;
    }
    return all;
}

/* Sets the goals: those of the test, times the ratio of the solution's clocks. */
static bool scale_goals(struct fresh_test *fresh, const struct lesson *lesson,
                        const struct test_case *like, c205_error *error)
{
    uint64_t clocks;
    if (!run_solution(lesson, like, false, &clocks, error))
        return false;
    for (int medal = MEDAL_BRONZE; medal < MEDALS; medal++)
        fresh->notes.goals[medal] = (like->notes->goals[medal] * fresh->clocks + clocks
                                     - 1)
                                    / clocks;
    return true;
}

static bool set_notes(struct fresh_test *fresh, const struct lesson *lesson,
                      const struct lesson_test *like, struct arena *kept)
{
    struct text_line name = { 0 };
    struct sink sink = text_line_sink(&name);
    fresh->notes = lesson->fresh;
    if (!like)
        return true;
    sink_print(&sink, "fresh-%s", like->name);
    fresh->notes.name = arena_text(kept, name.text, name.length);
    fresh->notes.tries = "other inputs";
    fresh->notes.warm = like->warm;
    fresh->notes.has_goals = like->has_goals;
    memcpy(fresh->notes.goals, like->goals, sizeof like->goals);
    fresh->notes.tolerances = join_tolerances(lesson->fresh.tolerances,
                                              like->tolerances, kept);
    return !kept->failed;
}

/* Each fresh test of a draw has another constant `draw`. The factor is a prime, so the
 * remainders of `draw` differ, too. */
static uint64_t draw_constant(const struct lesson *lesson,
                              const struct lesson_test *like, uint64_t draw)
{
    enum { TESTS = 1009 };
    size_t i = like ? (size_t)(like - lesson->tests) : lesson->test_count;
    return draw * TESTS + i;
}

bool fresh_open(struct fresh_test *fresh, const struct lesson *lesson,
                const struct test_case *model, bool like, uint64_t draw,
                struct arena *kept, c205_error *error)
{
    const struct lesson_test *test = like ? model->notes : NULL;
    const struct asm_define *defines = make_defines(like ? model->object : NULL,
                                                    draw_constant(lesson, test, draw),
                                                    kept);
    if (!defines || !set_notes(fresh, lesson, test, kept))
        return error_set(error, "out of memory");
    return test_case_open(&fresh->test, &fresh->notes, defines, model->object, error)
           && check_labels(fresh->test.object, model->object, model->notes->file, error)
           && run_solution(lesson, &fresh->test, true, &fresh->clocks, error)
           && (!fresh->notes.has_goals || scale_goals(fresh, lesson, model, error));
}

void fresh_close(struct fresh_test *fresh)
{
    test_case_close(&fresh->test);
}
