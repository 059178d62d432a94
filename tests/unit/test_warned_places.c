/* test_warned_places.c - a program with each warning is run as c205 run does it, graded,
 * and run on the page. All three must report the same warning at the same line, and the
 * verdict must begin with it. A place that lacks a warning fails here. */
#include "asm/check/runtime_check.h"
#include "asm/lesson/lesson.h"
#include "tests/unit/engine_client.h"
#include "tests/unit/saved_machine.h"

#define DATA \
    " .include \"core.s\"\n .data\n .vector x, 3, 1, 2, 3\n" \
    " .vector f, 3, 1.0, 2.0, 3.5\n .vector y, 3\n .vector after, 8\n .code\n" \
    " .regs r10, xs, fs, ys, a, b\n" \
    " descriptor xs, x, 3\n descriptor fs, f, 3\n descriptor ys, y, 3\n"

static const struct place {
    const char *insns; /* the warning is at line 12 or 13 */
    size_t line;
    const char *name;
} places[] = {
    { " MPYSV [xs], [fs], [xs]\n", 12, "integer-operand" },
    { " VXTOV [fs], [xs], [ys]\n", 12, "float-index" },
    { " EX a, x\n ADDNV [xs], [fs], [a]\n", 13, "unset-length" },
    { " EX a, x\n ELEN a, 0\n ADDNV [xs], [fs], [a]\n", 14, "zero-length" },
    { " ELEN ys, 4\n VTOV [fs], [ys]\n", 13, "past-storage" },
    { " RTOR fs, a\n IX a, 64\n ELEN a, 2\n ADDNV [fs], [fs], [a]\n", 15,
      "recurrence" },
    { " ADDX a, a, b\n", 12, "unwritten-register" },
    { " BIM on\non: ADDX a, a, b\n", 13, "unwritten-register" },
};

static void check_run(const char *text, const struct place *place)
{
    static const struct warning_choice all;
    SCOPED_VALUE(diagnostics) said = { 0 };
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &failure);
    SCOPED(object) *object = NON_NULL(assemble_text("test.s", text, NULL, &said));
    SCOPED(c205) *machine = machine_with(&object->program, model);
    struct runtime_checker *watch = NON_NULL(runtime_new(object, "", &all, NULL));
    assert_true(c205_listen(machine, runtime_listen, watch));
    runtime_begin(watch, machine);
    c205_run(machine, 100000);
    const struct diagnostics *found = said.count > 0 ? &said : runtime_found(watch);
    FAIL_IF(said.count + runtime_found(watch)->count != 1
                || found->items[0].line != place->line
                || !strstr(found->items[0].message, place->name),
            "%s\n%s expected at %zu", text, place->name, place->line);
    runtime_free(watch);
}

static void check_verdict(const char *text, const struct place *place)
{
    static const char test[] = "; test: a test that no answer passes\n"
                               "; tolerance: y 0\n .data\nwant_y: .word 9.0, 9.0, 9.0\n"
                               "; goals: gold 100, silver 200, bronze 100000\n";
    struct lesson lesson = { .folder = NULL };
    struct lesson_verdict verdict = { .lesson = NULL };
    struct lesson_draws draws = { 0, 0 };
    assert_true(lesson_begin(&lesson, "01-test", &failure));
    assert_true(lesson_take(&lesson, "lesson.md", "# Test\n", 7, &failure));
    assert_true(lesson_take(&lesson, "start.s", " EXIT\n", 6, &failure));
    assert_true(lesson_take(&lesson, "test-one.s", test, strlen(test), &failure));
    FAIL_IF(!lesson_end(&lesson, &failure), "%s", failure.message);
    FAIL_IF(!lesson_grade(&verdict, &lesson, draws, "test.s", text, strlen(text),
                          &failure),
            "%s", failure.message);
    assert_int_equal(verdict.count, 1);
    const struct lesson_report *report = &verdict.trials[0].report;
    assert_true(report->count > 1);
    const char *at = formatted("test.s:%zu:", place->line);
    FAIL_IF(count_of(report->sentences[0], place->name) != 1
                || count_of(report->sentences[0], at) != 1,
            "%s\n%s expected at %zu, found\n%s", text, place->name, place->line,
            report->sentences[0]);
    lesson_verdict_free(&verdict);
    lesson_free(&lesson);
}

/* Returns the number of diagnostics of a reply at the line, and fails if there is another
 * one. */
static size_t count_diagnostics(const struct json_value *reply,
                                const struct place *place)
{
    size_t count = 0;
    const struct json_value *item = json_member_first(reply, "diagnostics");
    for (; item; item = item->next, count++) {
        assert_true((size_t)number_of(item, "line") == place->line);
        assert_true(strstr(text_of(item, "message"), place->name));
        assert_string_equal(text_of(item, "severity"), "warning");
    }
    return count;
}

static void check_page(const char *text, const struct place *place)
{
    SCOPED_VALUE(talk) talk = talk_with(NULL, "");
    size_t loaded = count_diagnostics(talk_load(&talk, text, ""), place);
    size_t before = count_diagnostics(talk_ask(&talk, "{'do': 'view'}"), place);
    assert_int_equal(before, 0);
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    assert_int_equal(loaded
                         + count_diagnostics(talk_ask(&talk, "{'do': 'view'}"), place),
                     1);
    talk_ask(&talk, "{'do': 'go', 'how': 'start'}");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    assert_int_equal(loaded
                         + count_diagnostics(talk_ask(&talk, "{'do': 'view'}"), place),
                     1);
}

TEST(places)
{
    for (size_t i = 0; i < COUNT(places); i++) {
        const char *text = formatted("%s%s EXIT\n", DATA, places[i].insns);
        check_run(text, &places[i]);
        check_verdict(text, &places[i]);
        check_page(text, &places[i]);
    }
}

/* After a change of the state, the warnings of the steps that it replaces are dropped. */
TEST(changed_runs)
{
    SCOPED_VALUE(talk) talk = talk_with(
        " EX r10, 0\n EX r11, 0\n BIM on\non: ES r12, 1\n CFPEQ r10, r0, past\n"
        " ADDX r20, r20, r21\npast: EXIT\n",
        "");
    talk_ask(&talk, "{'do': 'view'}");
    talk_says(&talk, "'diagnostics': []");
    talk_ask(&talk, "{'do': 'say', 'line': 'set r10 = 1.0'}");
    talk_ask(&talk, "{'do': 'go', 'how': 'step', 'n': 4}");
    talk_ask(&talk, "{'do': 'say', 'line': 'set r10 = 1.0'}");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    talk_ask(&talk, "{'do': 'view'}");
    talk_says(&talk, "r20 is read before");
    talk_ask(&talk, "{'do': 'go', 'how': 'step-to', 'n': 4}");
    talk_ask(&talk, "{'do': 'say', 'line': 'set r10 = 0.0'}");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    talk_ask(&talk, "{'do': 'view'}");
    talk_says(&talk, "'diagnostics': []");
}

/* A trap is an error at its line, with the values of its operands. */
TEST(traps)
{
    SCOPED_VALUE(talk) talk =
        talk_with(" .reg link, r15\n ES link, 64\n LOD [link], r16\n EXIT\n", "");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    talk_ask(&talk, "{'do': 'view'}");
    talk_says(&talk, "{'severity': 'error', 'file': 'program.s', 'line': 3, ");
    talk_says(&talk, "no memory is mapped there");
    talk_says(&talk, "    link (r15) = X");
    talk_ask(&talk, "{'do': 'go', 'how': 'back'}");
    talk_ask(&talk, "{'do': 'view'}");
    talk_says(&talk, "'diagnostics': []");
}
