/* test_scene_looks.c - the scene language: looks that have names, when what
 * they lack is told, and formulas by chance. */
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

#include <stdio.h>

/* ---- What is told, and where -------------------------------------------- */

/* Each text has this one report, or none. */
static void test_told_when_used(void **state)
{
    static const struct {
        const char *text;
        size_t column;       /* 0: nothing is told */
        const char *message; /* how it ends */
    } rows[] = {
        { "#declare F = finish { crand 1 }", 0, "" },
        { "#declare F = finish { crand 1 } #declare G = finish { F }", 0,
          "" },
        { "#declare F = finish { crand 1 }"
          " #declare S = sphere { 0, 1 finish { F } }",
          0, "" },
        { "#declare F = finish { crand 1 } sphere { 0, 1 finish { F } }", 23,
          "left out" },
        { "#declare F = finish { crand 1 } #declare G = finish { F }"
          " sphere { 0, 1 finish { G } } sphere { 0, 1 finish { F } }",
          23, "left out" },
        { "#declare T = texture { normal { dents 1 } }"
          " #declare S = sphere { 0, 1 texture { T } }"
          " union { object { S } object { S } }",
          24, "left out" },
        { "#declare M = material { texture { normal { dents 1 } } }"
          " sphere { 0, 1 material { M } }",
          35, "left out" },
        { "#declare I = interior { media { scattering { 1, 1 } } }"
          " sphere { 0, 1 interior { I } }",
          25, "left out" },
        { "#declare A = array[2] { finish { crand 1 }, finish { irid { 1 } } }"
          " sphere { 0, 1 finish { A[1] } }",
          54, "'irid' is not supported and left out" },
        { "#declare P = pigment { bozo color_map { [0 rgb 1] [1 rgb 0] } }"
          " #macro Ball(What) sphere { 0, 1 pigment { What } } #end"
          " Ball(P) Ball(P)",
          24, "its first colour is used" },
        { "#declare L = light_source { 0, 1 parallel } light_source { L }",
          34, "left out" },
        { "#declare N = normal { bumps 1 } #declare G = fog { distance 2 }"
          " #declare S = sky_sphere { pigment { rgb 1 } }"
          " #declare D = media { emission 1 }",
          0, "" },
        { "#declare N = normal { bumps 1 } sphere { 0, 1 normal { N } }", 47,
          "left out" },
        { "#declare S = sphere { 0, 1 #warning \"said\" }", 28, "said" },
        { "#default { finish { crand 1 } }", 21, "left out" },
        { "default { finish { crand 1 } }", 20, "left out" },
        { "sphere { 0, 1 uv_mapping } box { 0, 1 uv_mapping }"
          " sphere { 0, 2 uv_mapping }",
          15, "left out (3 places, this is the first)" },
        { "#for (I, 1, 9) sphere { 0, I uv_mapping } #end", 30, "left out" },
        { "global_settings { noise_generator 2 max_intersections 64 }"
          " light_source { 0, 1 point_at 0 radius 9 photons { refraction on } }"
          " sphere { 0, 1 hollow on photons { target } }",
          0, "" },
        { "sphere { 0, 1 texture { pigment { rgb 1 } }"
          " texture { pigment { rgbt 1 } } }",
          45, "only the lowest is used" },
        { "#declare T = texture { pigment { rgb 1 } }"
          " texture { pigment { rgbt 1 } } sphere { 0, 1 texture { T } }",
          44, "only the lowest is used" },
        { "sphere { 0, 1 texture { pigment { rgb 1 } }"
          " texture { pigment { rgb 2 } } }",
          0, "" },
        { "#declare F = function { transform { scale <1, 0, 1> } }"
          " sphere { F(1, 2, 3), 1 }",
          37, "along y is replaced by 1" },
        { "#declare S = sphere { 0, 1 #default { finish { crand 1 } } }", 48,
          "left out" },
        { "light_group { sphere { 0, 1 } }", 1, "shine on all objects" },
        { "#fopen F \"a\" write #write (F, 1, x, concat(\"a\", \"b\"), \",\")"
          " #fclose F",
          10, "is left out" },
    };

    (void)state;
    for (size_t i = 0; i < COUNT(rows); i++) {
        struct diagnostics reports = { 0 };
        struct scene *scene = scene_read_text("test.pov", rows[i].text,
                                              &reading_options, &reports);
        const char *found = reports.count ? reports.items->message : "";
        size_t length = strlen(found), end = strlen(rows[i].message);
        if (!scene || reports.count != (rows[i].column != 0)
            || (reports.count && reports.items->column != rows[i].column)
            || length < end
            || strcmp(found + length - end, rows[i].message)) {
            diagnostics_print(&reports, stderr);
            fail_msg("expected %zu %s, of: %s", rows[i].column,
                     rows[i].message, rows[i].text);
        }
        scene_free(scene);
        diagnostics_free(&reports);
        if (rows[i].column)
            assert_error(rows[i].text, &strict_options, 1, rows[i].column,
                         rows[i].message);
        else
            scene_free(scene_read_text("test.pov", rows[i].text,
                                       &strict_options, &reports));
        assert_int_equal(reports.count, 0);
    }
}

/* Objects by chance, some with names, out of each other: a look's note is told
 * if and only if a thing of the scene has come of it. */
enum { NAMES = 12, LOOKS = 4 };
struct drawn {
    char text[8000];
    size_t length;
    unsigned has[NAMES]; /* bits: the looks that a name has */
    unsigned told;
};

static void put(struct drawn *drawn, const char *text)
{
    size_t length = strlen(text);

    assert_true(drawn->length + length < sizeof drawn->text);
    memcpy(drawn->text + drawn->length, text, length + 1);
    drawn->length += length;
}

static void put_number(struct drawn *drawn, const char *before, size_t number,
                       const char *behind)
{
    char text[100];

    snprintf(text, sizeof text, "%s%zu%s", before, number, behind);
    put(drawn, text);
}

/* A sphere with a look, or what a name has, or both of two. */
static unsigned put_thing(struct drawn *drawn, uint64_t *random, size_t names)
{
    unsigned has = 0;
    size_t which;

    switch (names ? xorshift_between(random, 0, 2) : 0) {
    case 0:
        which = (size_t)xorshift_between(random, 0, LOOKS);
        if (which == LOOKS) {
            put(drawn, "sphere { 0, 1 }\n");
            return 0;
        }
        put_number(drawn, "sphere { 0, 1 texture { T", which, " } }\n");
        return 1u << which;
    case 1:
        which = (size_t)xorshift_between(random, 0, (int64_t)names - 1);
        put_number(drawn, "object { N", which, " }\n");
        return drawn->has[which];
    default:
        put(drawn, "union {\n");
        has = put_thing(drawn, random, names);
        has |= put_thing(drawn, random, names);
        put(drawn, "}\n");
        return has;
    }
}

static void draw(struct drawn *drawn, uint64_t *random)
{
    size_t names = 0;

    drawn->length = drawn->told = 0;
    for (size_t i = 0; i < LOOKS; i++) {
        char text[100];
        snprintf(text, sizeof text,
                 "#declare T%zu = texture { finish { %s 1 } }\n", i,
                 ((const char *const[LOOKS]){ "crand", "brilliance",
                                              "emission", "metallic" })[i]);
        put(drawn, text);
    }
    while (names < NAMES) {
        if (xorshift_between(random, 0, 3) == 0) {
            drawn->told |= put_thing(drawn, random, names);
            continue;
        }
        put_number(drawn, "#declare N", names, " = ");
        drawn->has[names] = put_thing(drawn, random, names);
        names++;
    }
}

static void test_told_by_chance(void **state)
{
    enum { SCENES = 300 };
    static struct drawn drawn;
    uint64_t random = RANDOM_SEED;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        struct diagnostics reports = { 0 };
        struct scene *scene;
        unsigned told = 0;
        draw(&drawn, &random);
        scene = scene_read_text("test.pov", drawn.text, &reading_options,
                                &reports);
        assert_non_null(scene);
        for (size_t j = 0; j < reports.count; j++)
            told |= 1u << (reports.items[j].line - 1);
        if (told != drawn.told)
            fail_msg("told %X, expected %X, of:\n%s", told, drawn.told,
                     drawn.text);
        scene_free(scene);
        diagnostics_free(&reports);
    }
}

/* ---- What is used ------------------------------------------------------- */

static void test_maps_and_layers(void **state)
{
    static const char *const texts[] = {
        "#declare M = color_map { [0 C] [1 rgb 0] }"
        " sphere { 0, 1 pigment { wood color_map { M } } }",
        "#declare M = colour_map { [0, .5 color C color C] }"
        " sphere { 0, 1 pigment { wood colour_map { M } } }",
        "#declare M = pigment_map { [0 C] [1 rgb 0] }"
        " sphere { 0, 1 pigment { wood pigment_map { M } } }",
        "#declare M = texture_map { [0 pigment { C }] [1 pigment { x }] }"
        " sphere { 0, 1 texture { wood texture_map { M } } }",
        "sphere { 0, 1 pigment { average pigment_map { [C] [2 rgb 0] } } }",
        "sphere { 0, 1 texture { tiles { texture { pigment { C } } tile2"
        " texture { pigment { rgb 0 } } } } }",
        "sphere { 0, 1 pigment { density_file df3 \"a.df3\" interpolate 1"
        " color_map { [0 C] } } }",
        "#declare T = texture { pigment { C } } texture { pigment { rgbf 1 } }"
        " texture { pigment { rgbt 1 } } sphere { 0, 1 texture { T } }",
        "#declare T = texture { pigment { rgb 0 } } texture { pigment { C } }"
        " sphere { 0, 1 texture { T } }",
    };

    (void)state;
    for (size_t i = 0; i < COUNT(texts); i++) {
        struct diagnostics reports = { 0 };
        char text[400];
        struct scene *scene;
        snprintf(text, sizeof text, "#declare C = rgb <1, 2, 3>; %s",
                 texts[i]);
        scene = scene_read_text("test.pov", text, &reading_options, &reports);
        if (!scene)
            diagnostics_print(&reports, stderr);
        assert_non_null(scene);
        assert_vector(scene->primitives->pigment.color[0], 1, 2, 3);
        scene_free(scene);
        diagnostics_free(&reports);
    }
}

/* ---- Formulas ----------------------------------------------------------- */

/* An expression of floats that exists everywhere. */
static void put_formula(struct drawn *drawn, uint64_t *random, int depth)
{
    static const char *const forms[] = {
        "#",
        "(# + #)",
        "(# - #)",
        "(# * #)",
        "# * #",
        "-#",
        "+#",
        "(# / (2 + abs(#)))",
        "sin(#)",
        "max(#, #, #)",
        "select(#, #, #)",
        "(# < #)",
        "(# >= #)",
        "(# & # | #)",

        "atan2(#, 1 + #*#)",
        "floor(#)",
        "(# != #)",
        "min(#, #)",
        "select(#, #, #, #)",
        "pow(2, sin(#))",
        "(# = # | #)",
    };
    static const char *const leaves[] = { "a", "b",   "K", "1.5",
                                          "c", ".25", "pi" };
    const char *form;

    if (depth == 0) {
        put(drawn, leaves[xorshift(random) % COUNT(leaves)]);
        return;
    }
    for (form = forms[xorshift(random) % COUNT(forms)]; *form; form++) {
        const char one[] = { *form, '\0' };
        if (*form == '#')
            put_formula(drawn, random, depth - 1);
        else
            put(drawn, one);
    }
}

/* The value of a function is that of its body where its parameters are names,
 * bit for bit; what is declared later does not change it. */
static void test_formulas_by_chance(void **state)
{
    enum { FORMULAS = 500, DEPTH = 4 };
    static struct drawn drawn, formula;
    uint64_t random = RANDOM_SEED;

    (void)state;
    for (int i = 0; i < FORMULAS; i++) {
        const double *center;
        struct scene *scene;
        formula.length = drawn.length = 0;
        put_formula(&formula, &random, DEPTH);
        put(&drawn, "#declare K = -.75;\n#declare F = function(a, b, c) { ");
        put(&drawn, formula.text);
        put(&drawn, " }\n#declare a = 2.5; #declare b = -1.25;\n"
                    "#declare c = .5; #declare V = (");
        put(&drawn, formula.text);
        put(&drawn, ");\n#declare K = 9;\nsphere { <F(a, b, c), V, 0>, 1 }");
        scene = read_scene(drawn.text);
        center = scene->primitives->shape.sphere.center;
        if (memcmp(&center[0], &center[1], sizeof *center))
            fail_msg("%.17g and %.17g of:\n%s", center[0], center[1],
                     drawn.text);
        scene_free(scene);
    }
}

/* Formulas of formulas take as long as they are reckoned. */
static void test_long_formulas(void **state)
{
    static char text[20000];
    size_t length = (size_t)snprintf(text, sizeof text,
                                     "#declare F0 = function(x) { x + 1 }\n");

    (void)state;
    for (int i = 1; i < 100; i++)
        length += (size_t)
            snprintf(text + length, sizeof text - length,
                     "#declare F%d = function(x) { F%d(x) + F%d(x) }\n", i,
                     i - 1, i - 1);
    snprintf(text + length, sizeof text - length, "sphere { 0, F99(1) }");
    assert_refused(text, 1, "too long to read");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_told_when_used),
        cmocka_unit_test(test_told_by_chance),
        cmocka_unit_test(test_maps_and_layers),
        cmocka_unit_test(test_formulas_by_chance),
        cmocka_unit_test(test_long_formulas),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
