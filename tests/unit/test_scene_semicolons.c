/* test_scene_semicolons.c - texts in which a ';' is missing must have one error
 * directly after the value, whatever text follows. A second error or place fails. */
#include "tests/unit/scene_reading.h"

#include "tests/oracle/language_scene.h"

/* Each text of one line has exactly this error. */
static const struct line_error places_errors[] = {
    { "#declare A = 3 sphere { 0, A }", 15, "';' is missing" },
    { "#declare A = 3", 15, "';' is missing" },
    { "#declare A = 3 /* ; */ #if (A > 2) sphere { 0, A } #end", 15, "';' is missing" },
    { "#declare A = 3 #if (A > 2) #declare B = A; #end box { -B, A }", 15,
      "';' is missing" },
    { "#if (1) #declare A = 3 #else #declare A = 4; #end sphere { 0, A }", 23,
      "';' is missing" },
    { "#declare N = 0; #while (N < 3) sphere { N, 1 } #declare N = N + 1 #end", 66,
      "';' is missing" },
    { "#for (I, 1, 3) #declare A = I #end sphere { 0, A }", 30, "';' is missing" },
    { "#declare A = <1, 2, 3> #declare B = A; sphere { B, 1 }", 23, "';' is missing" },
    { "#declare C = rgb <1, 2, 3> plane { y, 0 pigment { C } }", 27, "';' is missing" },
    { "#declare C = rgb 1; #declare D = C.red #declare E = D; sphere { 0, E }", 39,
      "';' is missing" },
    { "#declare A = array[2] { 1, 2 } #declare A[1] = A[0] "
      "#if (A[1] = 1) sphere { 0, A[1] } #end",
      52, "';' is missing" },
    { "#macro P(Q) sphere { 0, Q } #end #declare A = 3 P(A)", 48, "';' is missing" },
    { "#macro P() #local A = 3 #end P() sphere { 0, 1 }", 24, "';' is missing" },
    { "#declare A = (1 > 2 ? 3 : 4) #ifdef (A) sphere { 0, A } #end", 29,
      "';' is missing" },
    { "#declare S = sphere { 0, 1 #declare A = 3 scale A } object { S }", 42,
      "';' is missing" },
    { "sphere { 0, 1 #local A = 3 }", 27, "';' is missing" },
    { "#declare A = 1 #include \"colors.inc\" sphere { A, 1 }", 15, "';' is missing" },
};

TEST_CALL(places, assert_errors(places_errors, COUNT(places_errors)))

/* The value continues after directives and macros, or needs no ';'. */
TEST(values_that_continue)
{
    static const char *const texts[] = {
        "#declare A = 2 #if (0) + 3 #else - 1 #end; sphere { A, 1 }",
        "#declare A = #if (0) 2 #else 3 #end; sphere { A, 1 }",
        "#declare A = 1 #for (I, 1, 3) + I #end; sphere { A, 1 }",
        "#declare A = #switch (2) #case (1) 2 #break #case (2) 3 #break #else "
        "4 #end + 1; sphere { A, 1 }",
        "#declare A = <1 #if (1) 2 #else 5 #end 3>; sphere { A, 1 }",
        "#declare A = 2 #local B = 3; + B; sphere { A, 1 }",
        "#macro P() + 3 #end #declare A = 2 P(); sphere { A, 1 }",
        "#macro P() 3 #end #declare A = P() + P(); sphere { A, 1 }",
        "#macro P(Q) #declare Q = 3 #end #declare A = 1; P(A); sphere { A, 1 }",
        "#declare A = color red 1 #if (1) green .5 #end; sphere { 0, 1 pigment { A } }",
        "#declare S = \"a\" #declare T = S #if (1) sphere { 0, 1 } #end",
        "#declare S = sphere { 0, 1 } #if (1) object { S } #end",
    };
    for (size_t i = 0; i < COUNT(texts); i++)
        scene_free(read_scene(texts[i]));
}

/* ---- Random scenes -------------------------------------------------------- */

static void find_place(const char *text, const char *at, size_t *line, size_t *column)
{
    const char *start = text;
    *line = 1;
    for (const char *c = text; c < at; c++)
        if (*c == '\n') {
            ++*line;
            start = c + 1;
        }
    *column = (size_t)(at - start) + 1;
}

/* This ';' is removed. The text must then have one error at its position if it is
 * mandatory, and no error otherwise. */
static void leave_out(char *text, char *semicolon)
{
    struct scene_options options = strict_options;
    SCOPED_VALUE(diagnostics) reports = { 0 };
    size_t line, column;
    options.read_raster = with_images.read_raster;
    find_place(text, semicolon, &line, &column);
    *semicolon = ' ';
    SCOPED(scene) *scene = scene_read_text("test.pov", text, &options, &reports);
    if (strchr("}\"", semicolon[-1]) || !strncmp(semicolon - 3, "3.7", 3)
            ? !scene
            : reports.count != 1 || reports.items[0].line != line
                  || reports.items[0].column != column
                  || !strstr(reports.items[0].message, "';' is missing")) {
        diagnostics_print(&reports, stderr);
        fail_msg("expected one error at %zu:%zu of: %s", line, column, text);
    }
    *semicolon = ';';
}

TEST(random_scenes)
{
    enum { SCENES = 60 };
    size_t count = 0;
    write_bytes(LANGUAGE_IMAGE, language_image, strlen(language_image));
    for (uint64_t seed = 1; seed <= SCENES; seed++) {
        FREED char *text = language_scene_text(seed);
        for (char *c = strchr(text, ';'); c; c = strchr(c + 1, ';'), count++)
            leave_out(text, c);
    }
    remove(LANGUAGE_IMAGE);
    assert_true(count > 5 * SCENES);
}
