/* test_provenance.c - the text and the JSON about a table's model are compared with the
 * model. They contain the sources of its constants, and its errors against published
 * figures, for models that are fitted, compared, changed or projections. A figure of
 * another model, or a constant that is counted with another source, fails here. */
#include "base/provenance.h"
#include "tests/unit/named_model.h"

#define MOVED "latency.add 8 clk F\nlatency.load 20 clk F\n"

static const char compared_model[] =
    "title T\n"
    "fitted 3 figures, at most -12.5 % off: the worst\n"
    "compared 1 figures, at most 7 % off: another\n"
    "like cyber205-2pipe-prior\n" MOVED;

/* Returns the printed text, which the caller frees. */
static char *printed(const c205_model *model, bool whole, const char *before)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    provenance_print(model, whole, before, file);
    fclose(file);
    return text;
}

static char *as_json(const c205_model *model)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    struct json *json = json_open_stream(file, NULL, &failure);
    provenance_json(model, json);
    assert_true(json_close(json, &failure));
    fclose(file);
    return text;
}

static void holds(const char *text, const char *expected)
{
    FAIL_IF(!strstr(text, expected), "'%s' does not hold '%s'", text, expected);
}

/* ---- Uncertainty -------------- */

/* A report must begin with one text and contain another; its JSON must contain a third.
 * For a model that extends another model, the number of figures, the largest error and
 * the worst figure of the other model are printed. */
TEST(models)
{
    static const struct {
        const char *model, *begins, *holds, *json;
    } cases[] = {
        { compared_model,
          "# Cycle-accounted, not cycle-accurate, on the model test,\n"
          "# fitted to 3 published figures, the largest error -12.5 %% (the worst),\n"
          "# compared with 1 published figure, the largest error +7.0 %% (another).\n",
          "\n# Not modelled: instruction fetch, ",
          "\"name\": \"test\",\n    \"title\": \"T\",\n    \"fitted\": true,\n"
          "    \"fit\": {\n      \"figures\": 3,\n"
          "      \"largest_error_percent\": -12.5,\n"
          "      \"of\": \"the worst\"\n    },\n"
          "    \"comparison\": {\n      \"figures\": 1,\n"
          "      \"largest_error_percent\": 7,\n      \"of\": \"another\"\n    },\n"
          "    \"not_modelled\": \"instruction fetch, " },
        { "title T\nlike cyber205-2pipe-prior\n",
          "# Cycle-accounted, not cycle-accurate, on the model test,\n"
          "# not compared with published figures.\n",
          "\n# Not modelled: ",
          "\"fitted\": false,\n    \"fit\": null,\n    \"comparison\": null,\n"
          "    \"not_modelled\": " },
        { "title T\nlike cyber205-2pipe\n" MOVED,
          "# Cycle-accounted, not cycle-accurate, on the model test,\n"
          "# not compared with published figures; it is derived from cyber205-2pipe,\n"
          "# which was fitted to %u published figures, the largest error %+.1f %% (%s).\n",
          "\n# Not modelled: ",
          "\"changes\": {\n      \"name\": \"cyber205-2pipe\",\n"
          "      \"fit\": {\n        \"figures\": %u,\n" },
        { "title T\nlike cyber720-prior\n",
          "# Projected, not emulated, on the model test,\n",
          "Not modelled: its own compiler ", "\"not_modelled\": \"its own compiler " },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        SCOPED(c205_model) *model = parsed_model(cases[i].model);
        c205_belief belief = c205_model_fitted(c205_model_like(model));
        FREED char *text = printed(model, true, "# ");
        FREED char *line = printed(model, false, "# ");
        FREED char *json = as_json(model);
        char expected[1000];
        int first = (int)strcspn(text, "\n") - 1;
        snprintf(expected, sizeof expected, cases[i].begins, belief.figures,
                 belief.largest, belief.worst);
        FAIL_IF(strncmp(text, expected, strlen(expected)) != 0,
                "'%s' does not begin with '%s'", text, expected);
        holds(text, cases[i].holds);
        snprintf(expected, sizeof expected, cases[i].json, belief.figures);
        holds(json, expected);
        /* Only the first line is printed without --provenance. */
        snprintf(expected, sizeof expected, "%.*s; details: --provenance\n", first,
                 text);
        assert_string_equal(line, expected);
        assert_int_equal(provenance_is_fitted(model),
                         strstr(json, "\"fitted\": true") != NULL);
    }
}

/* ---- Sources of constants ------------ */

static size_t count_from(const c205_model *model, char source)
{
    size_t count = 0;
    for (size_t i = 0; i < c205_model_size(model); i++)
        count += c205_model_constant(model, i)->source == source;
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
    SCOPED(c205_model) *model = parsed_model(compared_model);
    FREED char *text = printed(model, true, "");
    FREED char *json = as_json(model);
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
}

/* A projection with constants of a single source, which is not the first source. */
TEST(one_source)
{
    SCOPED(c205_model) *model = parsed_model(
        "title T\nlike cyber720-prior\n"
        "clock.period 50 ns R\nmachine.overlap 0 truth R\n"
        "units.single 1 units R\nunits.add 1 units R\n"
        "units.multiply 1 units R\nunits.divide 1 units R\n"
        "units.logical 1 units R\n");
    FREED char *text = printed(model, true, "");
    assert_int_equal(count_from(model, 'R'), c205_model_size(model));
    holds(text, " constants: ");
    assert_null(strstr(strstr(text, " constants: "), ","));
}

/* A command prints one line about its model. */
TEST(line)
{
    static const char *const rows[][2] = {
        { "title T\nfitted 3 figures, at most -7.5 % off: a b\n"
          "compared 1 figures, at most 2 % off: c\nlike cyber205-2pipe-prior\n",
          "fitted to 3 published figures, the largest error -7.5 % (a b)" },
        { "title T\ncompared 1 figures, at most 2 % off: c\n"
          "like cyber205-2pipe-prior\n",
          "compared with 1 published figure, the largest error +2.0 % (c)" },
        { "title T\nlike cyber205-2pipe\n", "not compared with published figures" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(c205_model) *model = parsed_model(rows[i][0]);
        char line[PROVENANCE_LINE];
        provenance_line(model, line);
        assert_string_equal(line, rows[i][1]);
    }
}
