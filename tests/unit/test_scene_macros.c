/* test_scene_macros.c - the scene language. The results of macros and loops, and the
 * positions of their errors, are compared with expected values. A wrong argument, a
 * lost call, or a text that is read without end, fails here. */
#include "tests/unit/scene_reading.h"

#include <time.h>

/* ---- Results ------------------------------------------------------------ */

/* Texts and the radii of their spheres. */
TEST(spheres)
{
    static const char *const rows[][2] = {
        { "#for (I, 1, 3) sphere { 0, I } #end", "1 2 3" },
        { "union { #for (I, 1, 2) sphere { 0, I } #end scale 1 }", "1 2" },
        { "#macro S(R) sphere { 0, R } #end S(2) S(1 + 2)", "2 3" },
        { "#macro S(R) sphere { 0, R } #end\n"
          "#declare A = S(2); #declare B = union { S(4) object { A } }\n"
          "object { B } object { A }",
          "4 2 2" },
        { "#macro R(N) N*10 #end sphere { 0, R(1) + R(2) }", "30" },
        { "#macro S(O) object { O } #end S(sphere { 0, 5 })", "5" },
        { "#declare O = sphere { 0, 5 } #macro S(O) object { O } #end S(O)", "5" },
        { "#macro S(R) #local O = sphere { 0, R } object { O } #end S(6)", "6" },
        { "#macro S(R) #local O = sphere { 0, R } O #end object { S(6) }", "6" },
        { "#macro S(T) sphere { 0, 1 texture { T } } #end\n"
          "S(texture { pigment { rgb 1 } })",
          "1" },
        { "#macro S() sphere { 0, 1 } #undef S #end\n"
          "#declare A = S(); object { A }",
          "1" },
        { "#macro B() union { #end #macro E() } #end\n"
          "B() sphere { 0, 3 } sphere { 0, 4 } E()",
          "3 4" },
        { "#macro Many(N) #if (N > 0) sphere { 0, N } Many(N - 1) #end #end\n"
          "Many(4)",
          "4 3 2 1" },
        { "#declare A = array[2] { sphere { 0, 1 }, sphere { 0, 2 } }\n"
          "#declare A[0] = A[1] object { A[0] }",
          "2" },
        { "#macro S() #break sphere { 0, 1 } #end S() sphere { 0, 2 }", "2" },
        { "#default { finish { ambient 0 } } #if (1) sphere { 0, 2 } #end", "2" },
        { "union { sphere { 0, 3 } #for (I, 1, 2) sphere { 0, I } #end }", "3 1 2" },
        { "#macro S() #break } #end union { sphere { 0, 1 } S() sphere { 0, 2 } }",
          "1 2" },
        { "#switch (2) #case (1) sphere { 0, 1 } #break #case (2)\n"
          "sphere { 0, 2 } #end",
          "2" },
        { "#macro M(x2) sphere { 0, x2 } #end #for (I, 1, 2) M(I) #end", "1 2" },
        { "sphere { 0, #include concat(\"col\", \"ors.inc\") 1 }", "1" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_scene(rows[i][0]);
        char found[100] = "", *to = found;
        for (size_t k = 0; k < scene->primitive_count; k++)
            to += sprintf(to, k > 0 ? " %.17g" : "%.17g",
                          scene->primitives[k].shape.sphere.radius);
        FAIL_IF(strcmp(found, rows[i][1]) != 0, "%s: radii %s, expected %s", rows[i][0],
                found, rows[i][1]);
    }
}

/* The line of a primitive is the line of the call in the main file. */
TEST(lines)
{
    SCOPED(scene) *scene = read_scene("#macro S(R)\n  sphere { 0, R }\n#end\n"
                                      "#macro T()\n  S(1)\n  S(2)\n#end\n\n"
                                      "S(3)\nT()\n");
    static const size_t lines[] = { 9, 10, 10 };
    assert_int_equal(scene->primitive_count, COUNT(lines));
    for (size_t i = 0; i < COUNT(lines); i++)
        assert_int_equal(scene->primitives[i].line, lines[i]);
}

/* ---- Errors ------------------------------------------------------------- */

TEST(errors)
{
    static const struct place_error rows[] = {
        { "#macro S(R)\n sphere { 0, Q }\n#end\nS(1) S(2)", 2, 14,
          "'Q', which is not declared, in 'S' called at test.pov:4:1" },
        { "#macro A(N)\nsphere { 0, N }\n#end\n#macro B(N)\nA(N)\n#end\nB(x)", 2, 13,
          "in 'A' called at test.pov:5:1, in 'B' called at test.pov:7:1" },
        { "#macro S(R)\n#error concat(\"no \", R)\n#end\nS(\"luck\")", 2, 1,
          "no luck, in 'S' called at test.pov:4:1" },
        { "#macro S(A, B) #end\nS(1)", 2, 4, "takes 2 arguments, found 1" },
        { "#macro S(A) #end\nS(1, 2)", 2, 6, "expected ')'" },
        { "#macro S(A) #end\nS(Nothing)", 2, 3, "'Nothing'" },
        { "#macro S() #end\nsphere { 0, S }", 2, 15, "expected '('" },
        { "#macro S() sphere { 0, 1 }", 1, 1, "'#macro' has no matching '#end'" },
        { "#macro (A) #end", 1, 8, "expected a name" },
        { "#macro S #end", 1, 10, "expected '('" },
        { "#macro S(1) } #end", 1, 10, "the name of a parameter" },
        { "#macro S(x) } #end", 1, 10, "keyword, not a name" },
        { "#macro sphere() } #end", 1, 8, "keyword, not a name" },
        { "#macro S() #if (1) #end sphere { 0, 1 }", 1, 1, "'#macro'" },
        { "#macro S() #end #end", 1, 17, "'#end' without a matching directive" },
        { "#macro R() R() #end\nR()", 1, 12, "200 nested macros and files" },
        { "#macro R() R() R() #end\nR()", 1, 12, "200 nested macros and files" },
        { "#macro R(A) R(A + 1) #end\nsphere { 0, R(1) }", 1, 13,
          "200 nested macros and files" },
        { "#macro R(A) R(R(A)) #end\nR(1)", 1, 15, "200" },
    };
    assert_place_errors(rows, COUNT(rows), &reading_options);
}

/* ---- Bounds ------------------------------------------------------------- */

struct bounded {
    const char *text, *message;
};

/* Each text must be rejected within a minute, with this reason. */
static void check_bounded(const struct bounded *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        clock_t start = clock();
        assert_refused(rows[i].text, 2, rows[i].message);
        FAIL_IF(clock() - start > 60 * CLOCKS_PER_SEC, "too long: %s", rows[i].text);
    }
}

TEST(bounds)
{
    static const struct bounded rows[] = {
        { "#while (1) #while (1) #end #end", "iterations" },
        { "#while (1) #while (1) #break #end #end", "iterations" },
        { "#for (I, 0, 1, 1e-300) #end", "iterations" },
        { "#for (I, 1e300, 1e301) #end", "iterations" },
        { "#declare S = \"a\"; #while (1) #declare S = concat(S, S); #end",
          "the string is longer" },
        { "#declare A = array[2]; #while (1) #declare A[0] = A; #end",
          "nested arrays" },
        { "#declare A = array[5000];\n"
          "#while (1) #declare B = A; #declare A = B; #end",
          "too long to read" },
        { "#declare A = array[2] { sphere { 0, 1 }, sphere { 0, 1 } }\n"
          "#while (1) #declare B = A; #end",
          "primitives and lights, including copies" },
        { "#declare A = union { #for (I, 1, 1000) light_source { 0, 1 } #end }\n"
          "#for (I, 1, 998) #declare B = A; #end\n"
          "#for (I, 1, 1500) light_source { 0, 1 } #end",
          "1000000 primitives and lights" },
        { "#declare I = 0; #declare S = spline { 0, 1 } #while (1)\n"
          "#declare I = I + 1; #declare S = spline { S I, 1 } #end",
          "more than 1073741824 bytes" },
        { "#while (1) #declare S = seed(1); #end", "random streams" },
        { "#while (1) #if (file_exists(\"no\")) #end #end", "files are read" },
    };
    check_bounded(rows, COUNT(rows));
}

/* The limits of these texts are reached only after seconds of reading. */
TEST(slow_bounds)
{
    static const struct bounded rows[] = {
        { "#for (I, 1, 1e9) #for (K, 1, 1e5) #end #end", "too long to read" },
        { "#macro M(N) #if (N) M(N - 1) M(N - 1) #end #end M(100)",
          "too long to read" },
        { "#declare S = sphere { 0, 1 } #while (1)\n"
          "#declare S = union { object { S } object { S } } #end",
          "primitives and lights, including copies" },
    };
    if (!thorough())
        skip();
    check_bounded(rows, COUNT(rows));
}

/* A go_on function that counts its calls and stops the reading at the first call. */
static bool end_at_once(void *context)
{
    ++*(size_t *)context;
    return false;
}

TEST(stopped)
{
    size_t asked = 0;
    const struct scene_options stopping = { .go_on = end_at_once, .context = &asked };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    assert_null(scene_read_text("test.pov", "#while (1) #while (1) #end #end",
                                &stopping, &reports));
    assert_int_equal(asked, 1);
    assert_int_equal(reports.count, 1);
    assert_non_null(strstr(reports.items[0].message, "stopped"));
}
