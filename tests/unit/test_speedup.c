/* test_speedup.c - the rows of rt205 speedup, in small frames. */
#include "rt/speedup_report.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static c205_model *model;
static const struct speedup_view view = { .distance = 5, .angle = 37 };

static void measure(const struct speedup_subject *subject,
                    const struct speedup_view *from,
                    struct speedup_measure measures[TRACE_FORMS])
{
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        struct trace_options options = { .mode = (enum trace_mode)mode,
                                         .width = 80,
                                         .height = 50,
                                         .queue = TRACE_QUEUE,
                                         .model = model };
        c205_error error = { "" };

        if (!speedup_measure(subject, from, &options, &measures[mode],
                             &error))
            fail_msg("%s", error.message);
    }
}

/* All clocks have a cause and lie in a region. */
static void check_sums(const struct speedup_measure *measure)
{
    uint64_t causes = 0, regions = 0;

    for (int i = 0; i < C205_CAUSES; i++)
        causes += measure->clocks[i];
    for (int i = 0; i < SPEEDUP_REGIONS_MOST; i++)
        regions += measure->regions[i];
    assert_true(causes == measure->total);
    assert_true(regions == measure->total);
}

static void test_subjects(void **state)
{
    (void)state;
    for (size_t i = 0; i < speedup_subject_count; i++) {
        struct speedup_measure measures[TRACE_FORMS];

        measure(&speedup_subjects[i], &view, measures);
        for (int mode = 0; mode < TRACE_FORMS; mode++) {
            check_sums(&measures[mode]);
            assert_int_equal(measures[mode].rays, 4000);
            assert_in_range(measures[mode].hits, 1000, 3000);
        }
        assert_true(measures[TRACE_SCALAR].checksum
                    == measures[TRACE_VECTOR].checksum);
        assert_true(measures[TRACE_SCALAR].total
                    > 3 * measures[TRACE_VECTOR].total);
    }
}

/* The solver's region has clocks where falsi has taken steps; the scalar form
 * takes one bracket at a time. */
static void check_solver(const struct speedup_subject *subject,
                         const struct speedup_measure measures[TRACE_FORMS])
{
    for (size_t i = 0; i < SPEEDUP_REGIONS_MOST; i++) {
        const struct stage_count *count =
            measures[TRACE_SCALAR].iterations.stage;

        if (subject->regions[i] == NULL
            || strcmp(subject->regions[i], speedup_solver) != 0)
            continue;
        for (int stage = 0; stage < STAGES; stage++) {
            assert_true(count[stage].steps >= count[stage].brackets);
            assert_true(count[stage].steps == count[stage].passes);
        }
        assert_true(count[STAGE_VALUE].brackets
                    >= measures[TRACE_SCALAR].hits);
        for (int mode = 0; mode < TRACE_FORMS; mode++) {
            assert_true(measures[mode].regions[i] > 0);
            assert_int_equal(measures[mode].falsi == FALSI_PAPER,
                             subject->historical);
        }
    }
}

/* Whether a subject names the solver is whether it solves. */
static void test_solvers(void **state)
{
    (void)state;
    for (size_t i = 0; i < speedup_subject_count; i++) {
        const struct speedup_subject *subject = &speedup_subjects[i];
        struct speedup_measure measures[TRACE_FORMS];
        bool solves = false;

        measure(subject, &view, measures);
        for (int k = 0; k < SPEEDUP_REGIONS_MOST; k++)
            solves |= subject->regions[k] != NULL
                      && strcmp(subject->regions[k], speedup_solver) == 0;
        for (int mode = 0; mode < TRACE_FORMS; mode++)
            assert_int_equal(
                measures[mode].iterations.stage[STAGE_VALUE].brackets > 0,
                solves);
        check_solver(subject, measures);
    }
}

/* The paper's way is not ours: it has a kernel and a falsi of its own. */
static void test_historical(void **state)
{
    (void)state;
    for (size_t i = 0; i < speedup_subject_count; i++) {
        struct speedup_subject subject = speedup_subjects[i];
        struct speedup_measure then[TRACE_FORMS], ours[TRACE_FORMS];

        if (!subject.historical)
            continue;
        measure(&subject, &view, then);
        subject.historical = false;
        measure(&subject, &view, ours);
        for (int mode = 0; mode < TRACE_FORMS; mode++) {
            assert_int_equal(then[mode].hits, ours[mode].hits);
            assert_true(then[mode].regions[1] != ours[mode].regions[1]);
        }
    }
}

/* From farther away, and across less. */
static void test_view(void **state)
{
    static const struct speedup_view far = { .distance = 20, .angle = 37 };
    static const struct speedup_view narrow = { .distance = 5, .angle = 5 };
    struct speedup_measure measures[TRACE_FORMS];

    (void)state;
    measure(&speedup_subjects[0], &far, measures);
    assert_in_range(measures[TRACE_VECTOR].hits, 50, 300);
    measure(&speedup_subjects[0], &narrow, measures);
    assert_int_equal(measures[TRACE_VECTOR].hits, 4000);
}

static void check_error(const struct speedup_subject *subject,
                        const char *message)
{
    struct trace_options options = { .width = 4, .height = 4, .queue = 4,
                                     .model = model };
    struct speedup_measure measured;
    c205_error error = { "" };

    assert_false(speedup_measure(subject, &view, &options, &measured,
                                 &error));
    assert_non_null(strstr(error.message, message));
}

static void test_errors(void **state)
{
    struct speedup_subject subject = speedup_subjects[0];

    (void)state;
    subject.regions[1] = "nowhere";
    check_error(&subject, "no region nowhere");
    subject.shape = "sphere { 0 }";
    check_error(&subject, "sphere");
}

/* The passes are a table of their own, which comes if asked for. */
static void check_print(const struct speedup_report *report, bool passes)
{
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);

    assert_non_null(stream);
    assert_true(speedup_report_print(report, passes, stream));
    assert_int_equal(fclose(stream), 0);
    assert_non_null(strstr(text, "paper: speedup"));
    assert_int_equal(strstr(text, "pass by pass") != NULL, passes);
    assert_int_equal(strstr(text, "% of brackets") != NULL, passes);
    free(text);
}

static void test_report(void **state)
{
    struct speedup_report *report = speedup_report_new(model);

    (void)state;
    assert_non_null(report);
    for (size_t i = 0; i < speedup_subject_count; i++) {
        struct speedup_measure measures[TRACE_FORMS];

        measure(&speedup_subjects[i], &view, measures);
        speedup_report_add(report, &speedup_subjects[i], &view, measures);
    }
    check_print(report, false);
    check_print(report, true);
    speedup_report_free(report);
}

static int set_up(void **state)
{
    c205_error error;

    (void)state;
    model = c205_model_find("cyber205-2pipe", &error);
    return model == NULL;
}

static int tear_down(void **state)
{
    (void)state;
    c205_model_free(model);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_subjects),
        cmocka_unit_test(test_solvers),
        cmocka_unit_test(test_historical),
        cmocka_unit_test(test_view),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_report),
    };

    return cmocka_run_group_tests(tests, set_up, tear_down);
}
