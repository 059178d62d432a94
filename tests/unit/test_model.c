/* test_model.c - machine models: the built-in ones are compared with a list of names,
 * changed ones with their changes, and wrong texts with the place and message of their
 * error. A model that is missing, a change that affects other constants, or an error at
 * another column fails here.
 */
#include "tests/unit/unit.h"
#include "vm/time/model.h"

#include <math.h>

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

TEST(built_in)
{
    static const double pipes[] = { 1, 2, 4 };
    static const char *const expected_names[] = { "cdc6600",
                                                  "cyber205-1pipe-32bit",
                                                  "cyber205-1pipe-prior",
                                                  "cyber205-1pipe",
                                                  "cyber205-2pipe-32bit",
                                                  "cyber205-2pipe-prior",
                                                  "cyber205-2pipe-small",
                                                  "cyber205-2pipe",
                                                  "cyber205-4pipe-32bit",
                                                  "cyber205-4pipe-prior",
                                                  "cyber205-4pipe",
                                                  "cyber720-prior",
                                                  "cyber720",
                                                  "eta10g-prior",
                                                  "eta10g" };
    enum { NAMES = COUNT(expected_names) };
    const char *const *names = c205_model_names();
    for (size_t i = 0; i < NAMES; i++)
        assert_string_equal(names[i], expected_names[i]);
    for (size_t i = 0; i < 3; i++) {
        char expected[] = "cyber205-0pipe-prior";
        c205_error error;
        expected[9] = (char)('0' + (int)pipes[i]);
        c205_model *model = c205_model_find(expected, &error);
        assert_non_null(model);
        assert_string_equal(c205_model_name(model), expected);
        assert_true(c205_model_lookup(model, "machine.pipes")->value == pipes[i]);
        assert_true(c205_model_lookup(model, "startup.vadd")->value == 51);
        c205_model_free(model);
    }
    assert_null(names[NAMES]);
}

/* Variants: the model that each resembles, and the constant in which it differs. */
TEST(variants)
{
    static const struct {
        const char *name, *like, *constant;
        double value;
    } cases[] = { { "cyber205-1pipe-32bit", "cyber205-1pipe", "vector.word_rate", 2 },
                  { "cyber205-2pipe-32bit", "cyber205-2pipe", "vector.word_rate", 2 },
                  { "cyber205-4pipe-32bit", "cyber205-4pipe", "vector.word_rate", 2 },
                  { "cyber205-2pipe-small", "cyber205-2pipe", "page.words", 512 } };
    for (size_t i = 0; i < COUNT(cases); i++) {
        c205_error error;
        c205_model *model = c205_model_find(cases[i].name, &error);
        assert_non_null(model);
        const c205_model *like = c205_model_like(model);
        assert_string_equal(c205_model_name(like), cases[i].like);
        for (size_t k = 0; k < c205_model_size(model); k++) {
            const c205_constant *constant = c205_model_constant(model, k);
            if (!strcmp(constant->name, cases[i].constant))
                assert_true(constant->value == cases[i].value);
            else
                assert_true(constant->value == c205_model_constant(like, k)->value);
        }
        c205_model_free(model);
    }
}

/* Every constant has all its columns and is found by its name. */
TEST(constants)
{
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe-prior", &error);
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

TEST(exact_values)
{
    c205_model *model = parsed("title test\nlike cyber205-4pipe-prior\n"
                               "clock.period 12.5 ns R\n"
                               "stream.vadd 0.000001 clk*pipe/element R\n"
                               "stream.vbits 2. clk/bit R\n");
    assert_int_equal(model_millionths(model, CONSTANT_CLOCK_PERIOD), 12500000);
    assert_int_equal(model_whole(model, CONSTANT_PIPES), 4);
    struct rate rate = model_rate(model, stream_constant(C205_TIMING_vadd));
    assert_int_equal(rate.clocks, 1);
    assert_int_equal(rate.per, 4 * MILLION);
    rate = model_rate(model, stream_constant(C205_TIMING_vbits));
    assert_int_equal(rate.clocks, 2 * MILLION);
    assert_int_equal(rate.per, MILLION);
    assert_int_equal(model_whole(model, latency_constant(C205_TIMING_sqrt)), 54);
    assert_int_equal(model_whole(model, startup_constant(C205_TIMING_vlink)), 84);
    c205_model_free(model);
}

/* A model names the model that it extends, and its changes. */
TEST(like)
{
    c205_model *model = parsed("# a remark\n\n  title  A slower one  # remark\n"
                               "like cyber205-2pipe-prior\r\n"
                               "startup.vadd 100 clk R   # twice the wait\n");
    const c205_constant *startup = c205_model_lookup(model, "startup.vadd");
    assert_string_equal(c205_model_title(model), "A slower one");
    assert_string_equal(startup->text, "100");
    assert_int_equal(startup->source, 'R');
    assert_string_equal(startup->remark, "twice the wait");
    assert_string_equal(c205_model_lookup(model, "startup.vsum")->text, "96");
    c205_model_free(model);
}

/* ---- Changed models ------------------------------------------------------ */

static void assert_constant(const c205_model *model, const char *name, const char *text,
                            char source)
{
    const c205_constant *constant = c205_model_lookup(model, name);
    assert_string_equal(constant->text, text);
    assert_int_equal(constant->source, source);
}

TEST(change)
{
    static const c205_setting settings[] = { { "machine.pipes", 4 },
                                             { "page.words", 2048 },
                                             { "stream.vadd", 1.25 } };
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe", &error);
    c205_model *changed = c205_model_change(model, settings, 3, &error);
    assert_non_null(changed);
    assert_string_equal(c205_model_name(changed),
                        "cyber205-2pipe with machine.pipes 4, "
                        "page.words 2048, stream.vadd 1.25");
    assert_string_equal(c205_model_title(changed), c205_model_title(model));
    assert_ptr_equal(c205_model_like(changed), model);
    assert_true(c205_model_fitted(model).figures > 0);
    assert_int_equal(c205_model_fitted(changed).figures, 0);
    assert_int_equal(c205_model_compared(changed).figures, 0);
    assert_constant(changed, "machine.pipes", "4", 'R');
    assert_constant(changed, "page.words", "2048", 'R');
    assert_constant(changed, "stream.vadd", "1.25", 'R');
    assert_constant(changed, "memory.loads_in_flight", "6", 'R');
    assert_constant(model, "machine.pipes", "2", 'P');
    assert_int_equal(model_whole(changed, CONSTANT_PIPES), 4);
    assert_int_equal(model_rate(changed, stream_constant(C205_TIMING_vadd)).per,
                     4 * MILLION);
    c205_model_free(changed);
    c205_model_free(model);
}

/* A changed model can be changed again. Without changes the result is a copy, also for
 * a projection. */
TEST(change_again)
{
    static const c205_setting first = { "machine.pipes", 4 };
    static const c205_setting second = { "machine.pipes", 1 };
    static const c205_setting third = { "time.add", 10 };
    c205_model *model = parsed("title T\nlike cyber205-2pipe-prior\n");
    c205_model *projection = parsed("title T\nlike cyber720-prior\n");
    c205_error error;
    c205_model *four = c205_model_change(model, &first, 1, &error);
    c205_model *one = c205_model_change(four, &second, 1, &error);
    c205_model *same = c205_model_change(one, NULL, 0, &error);
    c205_model *other = c205_model_change(projection, &third, 1, &error);
    assert_int_equal(model_whole(four, CONSTANT_PIPES), 4);
    assert_string_equal(c205_model_name(same), "test with machine.pipes 4 "
                                               "with machine.pipes 1");
    assert_constant(same, "machine.pipes", "1", 'R');
    assert_true(c205_model_is_projection(other));
    assert_constant(other, "time.add", "10", 'R');
    c205_model_free(other);
    c205_model_free(same);
    c205_model_free(one);
    c205_model_free(four);
    c205_model_free(projection);
    c205_model_free(model);
}

TEST(errors_in_changes)
{
    static const struct {
        c205_setting setting;
        const char *message;
    } cases[] = {
        { { "warp", 9 }, "unknown constant 'warp'" },
        { { "time.add", 9 }, "unknown constant 'time.add'" },
        { { "machine.pipes", 0 }, "machine.pipes must be between 1 and 64" },
        { { "machine.pipes", -1 }, "machine.pipes must be between 1 and 64" },
        { { "machine.pipes", 1e300 }, "machine.pipes must be between 1 and 64" },
        { { "machine.pipes", NAN }, "machine.pipes must be between 1 and 64" },
        { { "machine.pipes", 1.5 }, "machine.pipes must be a whole number, not 1.5" },
        { { "page.words", 1024 },
          "page.words must be 512, 2048, 8192 or 65536, not 1024" },
        { { "page.words", -3 }, "page.words must be 512, 2048, 8192 or 65536, not -3" },
        { { "memory.real_words", 0 },
          "memory.real_words must be between 1 and 268435456" },
        { { "vector.word_rate", 3 },
          "vector.word_rate must not be more than vector.half_rate" }
    };
    c205_model *model = parsed("title T\nlike cyber205-2pipe-prior\n");
    for (size_t i = 0; i < COUNT(cases); i++) {
        c205_error error = { "" };
        assert_null(c205_model_change(model, &cases[i].setting, 1, &error));
        assert_string_equal(error.message, cases[i].message);
    }
    c205_model_free(model);
}

/* ---- Errors in models ---------------------------------------------------- */

TEST(errors)
{
    assert_fails("", "test:1: expected 'title TEXT' at the beginning of the model");
    assert_fails("machine.pipes 2 pipes P",
                 "test:1: expected 'title TEXT' at the beginning of the model");
    assert_fails("title T\ntitle T", "test:2: 'title' is given more than once");
    assert_fails("title T\nlike cyber205-2pipe-prior\n"
                 "like cyber205-2pipe-prior",
                 "test:3: 'like' is given more than once");
    assert_fails("title T\nlike cray1", "test:2: unknown machine model 'cray1'");
    assert_fails("title T\nprojection\nlike cyber205-2pipe-prior",
                 "test:3: cyber205-2pipe-prior is not a projection");
    assert_fails("title T\nlike ./cyber205.model",
                 "test:2: expected the name of a built-in model after 'like'");
    assert_fails("title T\nmachine.pipes 2 pipes P\nlike cyber205-2pipe-prior",
                 "test:3: 'like' must be before the constants");
    assert_fails("title T\nstream.vlink 1 clk*pipe/element P\nlike cyber720",
                 "test:3: 'like' must be before the constants");
    assert_fails("title T\nmachine.pipes 2 pipes P",
                 "test:2: the constant clock.period is missing");
    assert_fails("title T\nlike cyber205-2pipe\n"
                 "vector.word_rate 4 results R",
                 "test:3: vector.word_rate must not be more than "
                 "vector.half_rate");
}

TEST(errors_in_beliefs)
{
    static const char *const beliefs[] = { "",
                                           "0 figures, at most 5 % off: x",
                                           "-3 figures, at most 5 % off: x",
                                           "9999999 figures, at most 5 % off: x",
                                           "3 figures, at most 5 % off:",
                                           "3 figures, at most nan % off: x",
                                           "3 figures, at most inf % off: x",
                                           "3 figures, at most 1e300 % off: x",
                                           "3 figures, at most 5 off: x" };
    for (size_t i = 0; i < COUNT(beliefs); i++) {
        char text[200];
        snprintf(text, sizeof text, "title T\nfitted %s\nlike cyber205-2pipe\n",
                 beliefs[i]);
        assert_fails(text, "test:2: expected 'N figures, at most E % off: NAME' "
                           "after 'fitted'");
    }
    assert_fails("title T\ncompared 3 figures, at most 5 % off: x\n"
                 "compared 3 figures, at most 5 % off: x\n",
                 "test:3: 'compared' is given more than once");
}

TEST(errors_in_constants)
{
    static const struct {
        const char *line, *message;
    } cases[] = {
        { "warp 9 clk R", "unknown constant 'warp'" },
        { "machine.pipes 2 pipes P\nmachine.pipes 2 pipes P",
          "machine.pipes is already defined in line 3" },
        { "machine.pipes two pipes P",
          "'two' is not a number with at most six decimals" },
        { "machine.pipes", "'' is not a number with at most six decimals" },
        { "machine.pipes -1 pipes P",
          "'-1' is not a number with at most six decimals" },
        { "stream.vadd 0.0000001 clk/element R",
          "'0.0000001' is not a number with at most six decimals" },
        { "machine.pipes 99999999999 pipes R",
          "'99999999999' is not a number with at most six decimals" },
        { "machine.pipes 0 pipes P", "machine.pipes must be between 1 and 64" },
        { "machine.pipes 1.5 pipes P",
          "machine.pipes must be a whole number, not 1.5" },
        { "page.words 1024 words R",
          "page.words must be 512, 2048, 8192 or 65536, not 1024" },
        { "page.words 512.5 words R", "page.words must be a whole number, not 512.5" },
        { "memory.real_words 300000000 words R",
          "memory.real_words must be between 1 and 268435456" },
        { "machine.pipes 2 clk P",
          "the unit of machine.pipes must be pipes, not 'clk'" },
        { "stream.vadd 1 clk R",
          "the unit of stream.vadd must be "
          "clk*pipe/element, clk/element or clk/bit, not 'clk'" },
        { "machine.pipes 2 pipes",
          "the source of machine.pipes must be P, S, D, R or F, not ''" },
        { "machine.pipes 2 pipes X # no such source",
          "the source of machine.pipes must be P, S, D, R or F, not 'X'" },
        { "machine.pipes 2 pipes P more words",
          "expected the end of the line, found 'more words'" }
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[200], message[200];
        unsigned line = strchr(cases[i].line, '\n') ? 4 : 3;
        snprintf(text, sizeof text, "title T\nlike cyber205-2pipe-prior\n%s\n",
                 cases[i].line);
        snprintf(message, sizeof message, "test:%u: %s", line, cases[i].message);
        assert_fails(text, message);
    }
}

TEST(files)
{
    static const char path[] = "test_model.tmp.model";
    c205_error error;
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("title From a file\nlike cyber205-1pipe-prior\n", file);
    fclose(file);
    c205_model *model = c205_model_find(path, &error);
    remove(path);
    assert_non_null(model);
    assert_string_equal(c205_model_name(model), path);
    assert_string_equal(c205_model_title(model), "From a file");
    c205_model_free(model);
    file = fopen(path, "w");
    assert_non_null(file);
    fputs("title Long\nlike cyber205-1pipe-prior\n", file);
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
    assert_string_equal(error.message, "cannot read the machine model no/such/file: "
                                       "No such file or directory");
    assert_null(c205_model_find("/", &error));
    assert_null(c205_model_find("", &error));
    assert_string_equal(error.message, "unknown machine model ''");
}

static void assert_place(const char *text, unsigned line, unsigned column,
                         const char *message)
{
    c205_error error;
    c205_place place;
    assert_null(c205_model_read("test", text, &place, &error));
    assert_string_equal(error.message, message);
    assert_int_equal(place.line, line);
    assert_int_equal(place.column, column);
}

/* The column is that of the wrong word. */
TEST(places)
{
    assert_place("title t\n  speed 3 clk R\n", 2, 3, "unknown constant 'speed'");
    assert_place("title t\nclock.period x ns P\n", 2, 14,
                 "'x' is not a number with at most six decimals");
    assert_place("title t\nclock.period 20  clk P\n", 2, 18,
                 "the unit of clock.period must be ns, not 'clk'");
    assert_place("title t\nclock.period 20 ns Q\n", 2, 20,
                 "the source of clock.period must be P, S, D, R or F, "
                 "not 'Q'");
    assert_place("title t\nclock.period 20 ns P 7 # r\n", 2, 22,
                 "expected the end of the line, found '7'");
    assert_place("title t\nlike no\n", 2, 6, "unknown machine model 'no'");
}
