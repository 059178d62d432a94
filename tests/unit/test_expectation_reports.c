/* test_expectation_reports.c - reports about expectations are compared with expected
 * texts: tolerances, the model that an expectation names, and messages of failures. A
 * wrong verdict about a value at the limit fails here. */
#include "tests/unit/saved_machine.h"

#include "asm/check/expect.h"

/* Returns the report of a program that runs on a model. */
static char *run_on(const char *model_name, const char *text)
{
    SCOPED(c205_model) *model = c205_model_find(model_name, &failure);
    struct text_buffer report = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&report);
    SCOPED(object) *object = good(text);
    SCOPED(c205) *machine = machine_with(&object->program, model);
    c205_stop stop = c205_run(machine, 1000000);
    bool met = expect_check(object, machine, &stop, "", object->warned, &sink);
    sink_put(&sink, "");
    assert_int_equal(met, report.length == 0);
    return report.text;
}

static void check_said(const char *text, const char *said)
{
    FREED char *report = run_on("cyber205-2pipe", text);
    FAIL_IF(!*said && report && *report, "%s\nexpected nothing said, found %s", text,
            report);
    FAIL_IF(*said && (!report || !strstr(report, said)),
            "%s\nexpected '%s', found '%s'", text, said, report ? report : "");
}

#define RUN \
    " .include \"core.s\"\n load_constant r10, 1.5\n load_half h40, 1.5, r9\n" \
    " ES r11, 5\n load_constant r12, 5.0\n EX r13, v\n EXIT\n .data\n" \
    "v: .word 1.0, 2.0, X'7000 0000 0000 0000'\n"

TEST(tolerance)
{
    check_said(RUN "; expect: r10 = 1.5\n", "");
    check_said(RUN "; expect: r10 = 1.5 ~ 1e-9\n", "");
    check_said(RUN "; expect: r10 = 1.25 ~ 0.25\n", "");
    check_said(RUN "; expect: r10 = 1.75 ~ 0.25\n", "");
    check_said(RUN "; expect: r10 = 1.25 ~ 0.2499\n",
               "(1.25) ~ 0.2499, found X'FFD2 6000 0000 0000' (1.5)");
    check_said(RUN "; expect: r10 = 1.25 ~ 0\n", "(1.25) ~ 0, found");
    check_said(RUN "; expect: r12 = 5 ~ 0\n", "");
    check_said(RUN "; expect: r11 = 5.0 ~ 1e-9\n", "");
    check_said(RUN "; expect: h40 = 1.25 ~ 0.25\n", "");
    check_said(RUN "; expect: h40 = 1.25 ~ 0.2\n", "found X'EA60 0000' (1.5)");
    check_said(RUN "; expect: [v] = 1.0, 2.25 ~ 0.25\n", "");
    check_said(RUN "; expect: [v] = 1.0, 2.25 ~ 0.2\n", "word 1, at");
    check_said(RUN "; expect: [v + 128] = 0.0 ~ 1e9\n", "indefinite");
    check_said(RUN "; expect: [v + 128] = X'7000 0000 0000 0000' ~ 1\n", "");
}

TEST(equal_decimals)
{
    check_said(RUN "; expect: r12 = 5\n",
               "r12 = X'0000 0000 0000 0005' (5), found X'FFD4 5000 0000"
               " 0000' (5): the numbers are equal, the words are not");
    check_said(RUN "; expect: r12 = 6\n", "(5)\n");
}

TEST(model)
{
    static const char text[] = " ES r1, 1\n EXIT\n; expect: r1 = 1\n"
                               "; expect-clocks: 7\n"
                               "; expect-model: cyber205-2pipe-prior\n";
    check_said(text, "");
    FREED char *report = NON_NULL(run_on("cyber205-2pipe-prior", text));
    assert_non_null(strstr(report, "test.s:4: expected 7 clocks, found"));
    check_said(" EXIT\n; expect-clocks: 7\n", "expected 7 clocks");
}
