/* test_model.c - machine models. The built-in models are compared with a list of names,
 * changed models with their changes, and wrong texts with the position and message of
 * their error. A model that is missing, a change that affects other constants, or an
 * error at another column fails here. */
#include "tests/unit/named_model.h"

#include <math.h>

#define PRIOR "title T\nlike cyber205-2pipe-prior\n"

TEST(built_in)
{
    char names[400] = "";
    for (const char *const *name = c205_model_names(); *name; name++)
        strcat(strcat(names, *name), " ");
    assert_string_equal(names,
                        "cdc6600 cyber205-1pipe-32bit cyber205-1pipe-prior "
                        "cyber205-1pipe cyber205-2pipe-32bit cyber205-2pipe-prior "
                        "cyber205-2pipe-small cyber205-2pipe cyber205-4pipe-32bit "
                        "cyber205-4pipe-prior cyber205-4pipe cyber720-prior cyber720 "
                        "eta10g-prior eta10g ");
    for (int pipes = 1; pipes <= 4; pipes *= 2) {
        char name[40];
        snprintf(name, sizeof name, "cyber205-%dpipe-prior", pipes);
        SCOPED(c205_model) *model = named_model(name);
        assert_string_equal(c205_model_name(model), name);
        assert_true(c205_model_lookup(model, "machine.pipes")->value == pipes);
        assert_true(c205_model_lookup(model, "startup.vadd")->value == 51);
    }
}

/* Variants: the most similar model, and the constant in which both differ. */
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
        SCOPED(c205_model) *model = named_model(cases[i].name);
        const c205_model *like = c205_model_like(model);
        assert_string_equal(c205_model_name(like), cases[i].like);
        for (size_t k = 0; k < c205_model_size(model); k++) {
            const c205_constant *constant = c205_model_constant(model, k);
            if (!strcmp(constant->name, cases[i].constant))
                assert_true(constant->value == cases[i].value);
            else
                assert_true(constant->value == c205_model_constant(like, k)->value);
        }
    }
}

/* Every constant has all columns, and is found by its name. */
TEST(constants)
{
    SCOPED(c205_model) *model = named_model("cyber205-2pipe-prior");
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
}

TEST(exact_values)
{
    SCOPED(c205_model) *model = parsed_model("title test\nlike cyber205-4pipe-prior\n"
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
}

/* A model contains the name of the model that it extends, and its changes. */
TEST(like)
{
    SCOPED(c205_model) *model = parsed_model(
        "# a remark\n\n  title  A slower one  # remark\n"
        "like cyber205-2pipe-prior\r\n"
        "startup.vadd 100 clk R   # twice the wait\n");
    const c205_constant *startup = c205_model_lookup(model, "startup.vadd");
    assert_string_equal(c205_model_title(model), "A slower one");
    assert_string_equal(startup->text, "100");
    assert_int_equal(startup->source, 'R');
    assert_string_equal(startup->remark, "twice the wait");
    assert_string_equal(c205_model_lookup(model, "startup.vsum")->text, "96");
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
    SCOPED(c205_model) *model = named_model("cyber205-2pipe");
    SCOPED(c205_model) *changed = NON_NULL(
        c205_model_change(model, settings, 3, &failure));
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
}

/* A changed model can be changed again. No change gives a copy of any model. */
TEST(change_again)
{
    static const c205_setting first = { "machine.pipes", 4 };
    static const c205_setting second = { "machine.pipes", 1 };
    static const c205_setting third = { "time.add", 10 };
    SCOPED(c205_model) *model = parsed_model(PRIOR);
    SCOPED(c205_model) *projection = parsed_model("title T\nlike cyber720-prior\n");
    SCOPED(c205_model) *four = c205_model_change(model, &first, 1, &failure);
    SCOPED(c205_model) *one = c205_model_change(four, &second, 1, &failure);
    SCOPED(c205_model) *same = c205_model_change(one, NULL, 0, &failure);
    SCOPED(c205_model) *other = c205_model_change(projection, &third, 1, &failure);
    assert_int_equal(model_whole(four, CONSTANT_PIPES), 4);
    assert_string_equal(c205_model_name(same), "test with machine.pipes 4 "
                                               "with machine.pipes 1");
    assert_constant(same, "machine.pipes", "1", 'R');
    assert_true(c205_model_is_projection(other));
    assert_constant(other, "time.add", "10", 'R');
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
    SCOPED(c205_model) *model = parsed_model(PRIOR);
    for (size_t i = 0; i < COUNT(cases); i++) {
        c205_error error = { "" };
        assert_null(c205_model_change(model, &cases[i].setting, 1, &error));
        assert_string_equal(error.message, cases[i].message);
    }
}

/* ---- Errors in models ---------------------------------------------------- */

/* Fails unless the text has this error at the wrong word (column 0: anywhere). */
static void assert_fails(const char *text, unsigned line, unsigned column,
                         const char *message)
{
    c205_error error;
    c205_place place;
    assert_null(c205_model_read("test", text, &place, &error));
    FAIL_IF(strcmp(error.message, message) != 0 || place.line != line
                || (column > 0 && place.column != column),
            "%s%u:%u: %s, not %u:%u: %s", text, place.line, place.column, error.message,
            line, column, message);
    const char *whole = formatted("test:%u: %s", line, message);
    assert_null(c205_model_parse("test", text, &error));
    assert_string_equal(error.message, whole);
}

#define NO_TITLE "expected 'title TEXT' at the beginning of the model"
#define LATE_LIKE "'like' must be before the constants"
#define NO_NUMBER(word) "'" word "' is not a number with at most six decimals"
#define FIGURES "3 figures, at most 5 % off: x\n"

TEST(errors)
{
    static const struct {
        const char *text;
        unsigned line, column;
        const char *message;
    } rows[] = {
        { "", 1, 0, NO_TITLE },
        { "machine.pipes 2 pipes P", 1, 0, NO_TITLE },
        { "title T\ntitle T", 2, 0, "'title' is given more than once" },
        { PRIOR "like cyber205-2pipe-prior", 3, 0, "'like' is given more than once" },
        { "title T\nlike cray1", 2, 0, "unknown machine model 'cray1'" },
        { "title t\nlike no\n", 2, 6, "unknown machine model 'no'" },
        { "title T\nprojection\nlike cyber205-2pipe-prior", 3, 0,
          "cyber205-2pipe-prior is not a projection" },
        { "title T\nlike ./cyber205.model", 2, 0,
          "expected the name of a built-in model after 'like'" },
        { "title T\nmachine.pipes 2 pipes P\nlike cyber205-2pipe-prior", 3, 0,
          LATE_LIKE },
        { "title T\nstream.vlink 1 clk*pipe/element P\nlike cyber720", 3, 0,
          LATE_LIKE },
        { "title T\nmachine.pipes 2 pipes P", 2, 0,
          "the constant clock.period is missing" },
        { "title T\nlike cyber205-2pipe\nvector.word_rate 4 results R", 3, 0,
          "vector.word_rate must not be more than vector.half_rate" },
        { "title T\ncompared " FIGURES "compared " FIGURES, 3, 0,
          "'compared' is given more than once" },
        { PRIOR "warp 9 clk R\n", 3, 0, "unknown constant 'warp'" },
        { "title t\n  speed 3 clk R\n", 2, 3, "unknown constant 'speed'" },
        { PRIOR "machine.pipes 2 pipes P\nmachine.pipes 2 pipes P\n", 4, 0,
          "machine.pipes is already defined in line 3" },
        { PRIOR "machine.pipes two pipes P\n", 3, 0, NO_NUMBER("two") },
        { PRIOR "machine.pipes\n", 3, 0, NO_NUMBER("") },
        { PRIOR "machine.pipes -1 pipes P\n", 3, 0, NO_NUMBER("-1") },
        { PRIOR "stream.vadd 0.0000001 clk/element R\n", 3, 0, NO_NUMBER("0.0000001") },
        { PRIOR "machine.pipes 99999999999 pipes R\n", 3, 0, NO_NUMBER("99999999999") },
        { "title t\nclock.period x ns P\n", 2, 14, NO_NUMBER("x") },
        { PRIOR "machine.pipes 0 pipes P\n", 3, 0,
          "machine.pipes must be between 1 and 64" },
        { PRIOR "machine.pipes 1.5 pipes P\n", 3, 0,
          "machine.pipes must be a whole number, not 1.5" },
        { PRIOR "page.words 1024 words R\n", 3, 0,
          "page.words must be 512, 2048, 8192 or 65536, not 1024" },
        { PRIOR "page.words 512.5 words R\n", 3, 0,
          "page.words must be a whole number, not 512.5" },
        { PRIOR "memory.real_words 300000000 words R\n", 3, 0,
          "memory.real_words must be between 1 and 268435456" },
        { PRIOR "machine.pipes 2 clk P\n", 3, 0,
          "the unit of machine.pipes must be pipes, not 'clk'" },
        { PRIOR "stream.vadd 1 clk R\n", 3, 0,
          "the unit of stream.vadd must be "
          "clk*pipe/element, clk/element or clk/bit, not 'clk'" },
        { "title t\nclock.period 20  clk P\n", 2, 18,
          "the unit of clock.period must be ns, not 'clk'" },
        { PRIOR "machine.pipes 2 pipes\n", 3, 0,
          "the source of machine.pipes must be P, S, D, R or F, not ''" },
        { PRIOR "machine.pipes 2 pipes X # no such source\n", 3, 0,
          "the source of machine.pipes must be P, S, D, R or F, not 'X'" },
        { "title t\nclock.period 20 ns Q\n", 2, 20,
          "the source of clock.period must be P, S, D, R or F, not 'Q'" },
        { PRIOR "machine.pipes 2 pipes P more words\n", 3, 0,
          "expected the end of the line, found 'more words'" },
        { "title t\nclock.period 20 ns P 7 # r\n", 2, 22,
          "expected the end of the line, found '7'" },
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_fails(rows[i].text, rows[i].line, rows[i].column, rows[i].message);
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
        assert_fails(formatted("title T\nfitted %s\nlike cyber205-2pipe\n", beliefs[i]),
                     2, 0,
                     "expected 'N figures, at most E % off: NAME' after 'fitted'");
    }
}

/* Returns the model of a file that consists of a text, remarks and a second text. */
static c205_model *model_of_file(const char *path, const char *text, int remarks,
                                 const char *end)
{
    FILE *file = NON_NULL(fopen(path, "w"));
    fputs(text, file);
    for (int i = 0; i < remarks; i++)
        fputs("# a remark that takes some room\n", file);
    fputs(end, file);
    fclose(file);
    c205_model *model = named_model(path);
    remove(path);
    return model;
}

TEST(files)
{
    static const char path[] = "test_model.tmp.model";
    c205_error error;
    SCOPED(c205_model) *small = model_of_file(path,
                                              "title From a file\n"
                                              "like cyber205-1pipe-prior\n",
                                              0, "");
    SCOPED(c205_model) *large = model_of_file(path,
                                              "title Long\nlike cyber205-1pipe-prior\n",
                                              5000, "latency.load 99 clk R\n");
    assert_string_equal(c205_model_name(small), path);
    assert_string_equal(c205_model_title(small), "From a file");
    assert_string_equal(c205_model_lookup(large, "latency.load")->text, "99");
    assert_null(c205_model_find("no/such/file", &error));
    assert_string_equal(error.message, "cannot read the machine model no/such/file: "
                                       "No such file or directory");
    assert_null(c205_model_find("/", &error));
    assert_null(c205_model_find("", &error));
    assert_string_equal(error.message, "unknown machine model ''");
}
