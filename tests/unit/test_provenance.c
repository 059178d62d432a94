/* test_provenance.c - what is told of the model with every table: where its
 * constants are from, and how near it came to published figures. */
#include "base/provenance.h"
#include "tests/unit/unit.h"

#include <unistd.h>

#include "base/file.h"

#define MOVED "latency.add 8 clk F\nlatency.load 20 clk F\n"

static const char compared_model[] =
    "title T\n"
    "fitted 3 figures, at most -12.5 % off: the worst\n"
    "compared 1 figures, at most 7 % off: another\n"
    "like cyber205-2pipe-prior\n" MOVED;

static c205_model *parsed(const char *text)
{
    c205_error error;
    c205_model *model = c205_model_parse("test", text, &error);
    if (!model) {
        fail_msg("%s", error.message);
    }
    return model;
}

static char *text_of(const char *path)
{
    c205_error error;
    size_t length;
    char *text = file_read(path, FILE_LARGEST, &length, &error);
    assert_non_null(text);
    assert_int_equal(remove(path), 0);
    return text;
}

/* What is printed; the caller frees it, here as below. */
static char *printed_as(const c205_model *model, bool whole, const char *before)
{
    char path[] = "/tmp/test_provenance.XXXXXX";
    int file = mkstemp(path), out;
    assert_true(file >= 0);
    fflush(stdout);
    out = dup(STDOUT_FILENO);
    dup2(file, STDOUT_FILENO);
    provenance_print(model, whole, before, stdout);
    fflush(stdout);
    dup2(out, STDOUT_FILENO);
    close(out);
    close(file);
    return text_of(path);
}

static char *printed(const c205_model *model, const char *before)
{
    return printed_as(model, true, before);
}

static char *as_json(const c205_model *model)
{
    char path[] = "/tmp/test_provenance.XXXXXX";
    int file = mkstemp(path);
    c205_error error;
    struct json *json = json_open(path, &error);
    assert_true(file >= 0 && close(file) == 0);
    assert_non_null(json);
    provenance_json(model, json);
    assert_true(json_close(json, &error));
    return text_of(path);
}

static void begins(const char *text, const char *expected)
{
    if (strncmp(text, expected, strlen(expected)) != 0) {
        fail_msg("'%s' does not begin with '%s'", text, expected);
    }
}

static void holds(const char *text, const char *expected)
{
    if (!strstr(text, expected)) {
        fail_msg("'%s' does not hold '%s'", text, expected);
    }
}

/* ---- How far to believe it ---- */

TEST(belief)
{
    c205_model *model = parsed(compared_model);
    char *text = printed(model, "# ");
    begins(text, "# Cycle-accounted, not cycle-accurate, on the model test,\n"
                 "# fitted to 3 published figures, the largest error -12.5 % "
                 "(the worst),\n"
                 "# compared with 1 published figure, the largest error "
                 "+7.0 % (another).\n"
                 "# Not modelled: fetching instructions, ");
    free(text);
    text = as_json(model);
    holds(text, "\"name\": \"test\",\n    \"title\": \"T\",\n"
                "    \"fitted\": true,\n"
                "    \"fit\": {\n      \"figures\": 3,\n"
                "      \"largest_error_percent\": -12.5,\n"
                "      \"of\": \"the worst\"\n    },\n"
                "    \"comparison\": {\n      \"figures\": 1,\n"
                "      \"largest_error_percent\": 7,\n"
                "      \"of\": \"another\"\n    },\n"
                "    \"not_modelled\": \"fetching instructions, ");
    free(text);
    c205_model_free(model);
}

TEST(no_figure)
{
    c205_model *model = parsed("title T\nlike cyber205-2pipe-prior\n");
    char *text = printed(model, "");
    begins(text, "Cycle-accounted, not cycle-accurate, on the model test,\n"
                 "compared with no published figure.\nNot modelled: ");
    free(text);
    text = as_json(model);
    holds(text, "\"fitted\": false,\n    \"fit\": null,\n"
                "    \"comparison\": null,\n    \"not_modelled\": ");
    assert_false(provenance_is_fitted(model));
    free(text);
    c205_model_free(model);
}

/* What is known of the other model is told as the other's. */
TEST(changed)
{
    c205_model *model = parsed("title T\nlike cyber205-2pipe\n" MOVED);
    const c205_model *other = c205_model_like(model);
    c205_belief belief = c205_model_fitted(other);
    char *text = printed(model, ""), expected[300];
    assert_true(belief.figures > 1);
    snprintf(expected, sizeof expected,
             "Cycle-accounted, not cycle-accurate, on the model test,\n"
             "compared with no published figure; it changes "
             "cyber205-2pipe,\n"
             "which was fitted to %u published figures, the largest error "
             "%+.1f %% (%s).\n",
             belief.figures, belief.largest, belief.worst);
    begins(text, expected);
    free(text);
    text = as_json(model);
    snprintf(expected, sizeof expected,
             "\"changes\": {\n      \"name\": \"cyber205-2pipe\",\n"
             "      \"fit\": {\n        \"figures\": %u,\n",
             belief.figures);
    holds(text, expected);
    free(text);
    c205_model_free(model);
}

TEST(projection)
{
    c205_model *model = parsed("title T\nlike cyber720-prior\n");
    char *text = printed(model, "");
    begins(text, "Projected, not emulated, on the model test,\n");
    holds(text, "Not modelled: its own compiler ");
    free(text);
    text = as_json(model);
    holds(text, "\"not_modelled\": \"its own compiler ");
    free(text);
    c205_model_free(model);
}

/* Where nobody asked for the whole, its first line stands for it. */
TEST(short)
{
    static const struct {
        const char *text, *line;
    } cases[] = {
        { compared_model, "# Cycle-accounted, not cycle-accurate, on the "
                          "model test; more by --provenance\n" },
        { "title T\nlike cyber205-2pipe\n" MOVED,
          "# Cycle-accounted, not cycle-accurate, on the model test; more by "
          "--provenance\n" },
        { "title T\nlike cyber720-prior\n",
          "# Projected, not emulated, on the model test; more by "
          "--provenance\n" },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        c205_model *model = parsed(cases[i].text);
        char *text = printed_as(model, false, "# ");
        char *whole = printed_as(model, true, "# ");
        assert_string_equal(text, cases[i].line);
        assert_memory_equal(text, whole, strcspn(text, ";"));
        assert_true(strlen(whole) > 2 * strlen(text));
        free(text);
        free(whole);
        c205_model_free(model);
    }
}

/* ---- From where its constants are ---- */

static size_t count_from(const c205_model *model, char source)
{
    size_t count = 0;
    for (size_t i = 0; i < c205_model_size(model); i++) {
        count += c205_model_constant(model, i)->source == source;
    }
    return count;
}

TEST(sources)
{
    static const struct {
        char letter;
        const char *name;
    } sources[] = { { 'P', "from a primary source" },
                    { 'S', "secondary" },
                    { 'D', "derived" },
                    { 'R', "reconstructed" },
                    { 'F', "fitted" } };
    c205_model *model = parsed(compared_model);
    char *text = printed(model, ""), *json = as_json(model);
    char expected[100];
    size_t sum = 0;
    for (size_t i = 0; i < COUNT(sources); i++) {
        size_t count = count_from(model, sources[i].letter);
        assert_true(count > 0);
        snprintf(expected, sizeof expected, "%c %zu %s (%c)", i ? ',' : ':', count,
                 sources[i].name, sources[i].letter);
        holds(text, expected);
        snprintf(expected, sizeof expected, "\"%c\": %zu", sources[i].letter, count);
        holds(json, expected);
        sum += count;
    }
    snprintf(expected, sizeof expected, "\n%zu constants: ", sum);
    holds(text, expected);
    assert_int_equal(count_from(model, 'F'), 2);
    assert_true(provenance_is_fitted(model));
    free(text);
    free(json);
    c205_model_free(model);
}

/* A projection whose constants are all of one source, and not the first. */
TEST(one_source)
{
    c205_model *model = parsed("title T\nlike cyber720-prior\n"
                               "clock.period 50 ns R\nmachine.overlap 0 truth R\n"
                               "units.single 1 units R\nunits.add 1 units R\n"
                               "units.multiply 1 units R\nunits.divide 1 units R\n"
                               "units.logical 1 units R\n");
    char *text = printed(model, "");
    assert_int_equal(count_from(model, 'R'), c205_model_size(model));
    holds(text, " constants: ");
    assert_null(strstr(strstr(text, " constants: "), ","));
    free(text);
    c205_model_free(model);
}

static void assert_line(const char *text, const char *expected)
{
    char line[PROVENANCE_LINE];
    c205_model *model = parsed(text);

    provenance_line(model, line);
    assert_string_equal(line, expected);
    c205_model_free(model);
}

/* What is told where there is room for one line. */
TEST(line)
{
    assert_line("title T\nfitted 3 figures, at most -7.5 % off: a b\n"
                "compared 1 figures, at most 2 % off: c\n"
                "like cyber205-2pipe-prior\n",
                "fitted to 3 published figures, the largest error -7.5 % "
                "(a b)");
    assert_line("title T\ncompared 1 figures, at most 2 % off: c\n"
                "like cyber205-2pipe-prior\n",
                "compared with 1 published figure, the largest error "
                "+2.0 % (c)");
    assert_line("title T\nlike cyber205-2pipe\n", "compared with no published figure");
}
