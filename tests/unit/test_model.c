/* test_model.c - machine models: the built-in ones, and errors in others. */
#include "vm/model.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static c205_model *parsed(const char *text)
{
    c205_error error;
    c205_model *model = c205_model_parse("test", text, &error);
    if (!model)
        fail_msg("%s", error.message);
    return model;
}

static void assert_fails(const char *text, const char *message)
{
    c205_error error;
    assert_null(c205_model_parse("test", text, &error));
    assert_string_equal(error.message, message);
}

static void test_built_in(void **state)
{
    (void)state;
    static const double pipes[] = { 1, 2, 4 };
    static const size_t order[] = { 1, 3, 4 };
    const char *const *names = c205_model_names();
    assert_string_equal(names[0], "cdc6600");
    assert_string_equal(names[5], "cyber720");
    assert_string_equal(names[order[1] - 1], "cyber205-2pipe-fitted");
    for (size_t i = 0; i < 3; i++) {
        char expected[] = "cyber205-0pipe";
        c205_error error;
        expected[9] = (char)('0' + (int)pipes[i]);
        assert_string_equal(names[order[i]], expected);
        c205_model *model = c205_model_find(expected, &error);
        assert_non_null(model);
        assert_string_equal(c205_model_name(model), expected);
        assert_true(c205_model_lookup(model, "machine.pipes")->value ==
                    pipes[i]);
        assert_true(c205_model_lookup(model, "startup.vadd")->value == 51);
        c205_model_free(model);
    }
    assert_null(names[6]);
}

/* Every constant has all its columns, and is found under its name. */
static void test_constants(void **state)
{
    (void)state;
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe", &error);
    assert_int_equal(c205_model_size(model), CONSTANTS);
    for (size_t i = 0; i < c205_model_size(model); i++) {
        const c205_constant *constant = c205_model_constant(model, i);
        assert_true(*constant->text && *constant->unit);
        assert_non_null(strchr("PSDR", constant->source));
        assert_ptr_equal(c205_model_lookup(model, constant->name), constant);
    }
    assert_null(c205_model_lookup(model, "startup"));
    assert_string_equal(c205_model_lookup(model, "clock.period")->remark,
                        "stated for the machine");
    c205_model_free(model);
}

static void test_exact_values(void **state)
{
    (void)state;
    c205_model *model = parsed("title test\nlike cyber205-4pipe\n"
                               "clock.period 12.5 ns R\n"
                               "stream.vadd 0.000001 clk*pipe/element R\n"
                               "stream.vbits 2. clk/bit R\n");
    assert_int_equal(model_millionths(model, CONSTANT_CLOCK_PERIOD),
                     12500000);
    assert_int_equal(model_whole(model, CONSTANT_PIPES), 4);
    struct rate rate =
        model_rate(model, stream_constant(C205_TIMING_vadd));
    assert_int_equal(rate.clocks, 1);
    assert_int_equal(rate.per, 4 * MILLION);
    rate = model_rate(model, stream_constant(C205_TIMING_vbits));
    assert_int_equal(rate.clocks, 2 * MILLION);
    assert_int_equal(rate.per, MILLION);
    assert_int_equal(
        model_whole(model, latency_constant(C205_TIMING_sqrt)), 54);
    assert_int_equal(
        model_whole(model, startup_constant(C205_TIMING_vlink)), 84);
    c205_model_free(model);
}

/* A model says what it takes over and what it changes. */
static void test_like(void **state)
{
    (void)state;
    c205_model *model = parsed(
        "# a remark\n\n  title  A slower one  # remark\n"
        "like cyber205-2pipe\r\n"
        "startup.vadd 100 clk R   # twice the wait\n");
    const c205_constant *startup = c205_model_lookup(model, "startup.vadd");
    assert_string_equal(c205_model_title(model), "A slower one");
    assert_string_equal(startup->text, "100");
    assert_int_equal(startup->source, 'R');
    assert_string_equal(startup->remark, "twice the wait");
    assert_string_equal(c205_model_lookup(model, "startup.vsum")->text, "96");
    c205_model_free(model);
}

static void test_errors(void **state)
{
    (void)state;
    assert_fails("", "test:1: a model begins with 'title TEXT'");
    assert_fails("machine.pipes 2 pipes P",
                 "test:1: a model begins with 'title TEXT'");
    assert_fails("title T\ntitle T",
                 "test:2: 'title' stands here for the second time");
    assert_fails("title T\nlike cyber205-2pipe\nlike cyber205-2pipe",
                 "test:3: 'like' stands here for the second time");
    assert_fails("title T\nlike cray1",
                 "test:2: there is no machine model 'cray1'");
    assert_fails("title T\nlike ./cyber205.model",
                 "test:2: 'like' names a built-in model");
    assert_fails("title T\nmachine.pipes 2 pipes P\nlike cyber205-2pipe",
                 "test:3: 'like' must stand before the constants");
    assert_fails("title T\nmachine.pipes 2 pipes P",
                 "test:2: the constant clock.period is missing");
}

static void test_errors_in_constants(void **state)
{
    (void)state;
    static const struct {
        const char *line, *message;
    } cases[] = {
        { "warp 9 clk R", "there is no constant 'warp'" },
        { "machine.pipes 2 pipes P\nmachine.pipes 2 pipes P",
          "machine.pipes is already given in line 3" },
        { "machine.pipes two pipes P",
          "'two' is not a number with at most six decimals" },
        { "machine.pipes", "'' is not a number with at most six decimals" },
        { "machine.pipes -1 pipes P",
          "'-1' is not a number with at most six decimals" },
        { "stream.vadd 0.0000001 clk/element R",
          "'0.0000001' is not a number with at most six decimals" },
        { "machine.pipes 99999999999 pipes R",
          "'99999999999' is not a number with at most six decimals" },
        { "machine.pipes 0 pipes P",
          "machine.pipes must lie between 1 and 64" },
        { "machine.pipes 1.5 pipes P",
          "machine.pipes must be a whole number, not 1.5" },
        { "machine.pipes 2 clk P",
          "the unit of machine.pipes is pipes, not 'clk'" },
        { "stream.vadd 1 clk R", "the unit of stream.vadd is "
          "clk*pipe/element, clk/element or clk/bit, not 'clk'" },
        { "machine.pipes 2 pipes",
          "the source of machine.pipes must be P, S, D, R or F, not ''" },
        { "machine.pipes 2 pipes X # no such source",
          "the source of machine.pipes must be P, S, D, R or F, not 'X'" },
        { "machine.pipes 2 pipes P more words",
          "'more words' is not expected here" }
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[200], message[200];
        unsigned line = strchr(cases[i].line, '\n') ? 4 : 3;
        snprintf(text, sizeof text, "title T\nlike cyber205-2pipe\n%s\n",
                 cases[i].line);
        snprintf(message, sizeof message, "test:%u: %s", line,
                 cases[i].message);
        assert_fails(text, message);
    }
}

static void test_files(void **state)
{
    (void)state;
    static const char path[] = "test_model.tmp.model";
    c205_error error;
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("title From a file\nlike cyber205-1pipe\n", file);
    fclose(file);
    c205_model *model = c205_model_find(path, &error);
    remove(path);
    assert_non_null(model);
    assert_string_equal(c205_model_name(model), path);
    assert_string_equal(c205_model_title(model), "From a file");
    c205_model_free(model);
    file = fopen(path, "w");
    assert_non_null(file);
    fputs("title Long\nlike cyber205-1pipe\n", file);
    for (int i = 0; i < 5000; i++)
        fputs("# a remark that takes some room\n", file);
    fputs("latency.load 99 clk R\n", file);
    fclose(file);
    model = c205_model_find(path, &error);
    remove(path);
    assert_non_null(model);
    assert_string_equal(c205_model_lookup(model, "latency.load")->text, "99");
    c205_model_free(model);
    assert_null(c205_model_find("no/such/file", &error));
    assert_string_equal(error.message,
                        "cannot read the machine model no/such/file");
    assert_null(c205_model_find("/", &error));
    assert_null(c205_model_find("", &error));
    assert_string_equal(error.message, "there is no machine model ''");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_built_in),
        cmocka_unit_test(test_constants),
        cmocka_unit_test(test_exact_values),
        cmocka_unit_test(test_like),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_errors_in_constants),
        cmocka_unit_test(test_files)
    };
    return cmocka_run_group_tests_name("model", tests, NULL, NULL);
}
