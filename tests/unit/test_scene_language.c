/* test_scene_language.c - the scene language. Values, strings, arrays, conditions and
 * loops are compared with POV-Ray's output, and errors with their positions. A wrong
 * value, or an error at another position, fails here. */
#include "tests/unit/scene_reading.h"

#include "base/file.h"

static const char *said(const struct diagnostics *reports)
{
    for (size_t i = 0; i < reports->count; i++)
        if (reports->items[i].severity == SEVERITY_SAID)
            return reports->items[i].message;
    return "";
}

/* ---- Lists -------------------------------------------------------------- */

/* NAME.txt is the output of #debug in POV-Ray for NAME.pov. */
TEST(lists)
{
    static const char *const names[] = { "values", "strings",   "flow",   "macros",
                                         "arrays", "functions", "splines" };
    for (size_t i = 0; i < COUNT(names); i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        size_t length;
        char path[100];
        snprintf(path, sizeof path, "tests/language/%s.pov", names[i]);
        SCOPED(scene) *scene = scene_read(path, &reading_options, &reports);
        snprintf(path, sizeof path, "tests/language/%s.txt", names[i]);
        FREED char *expected = NON_NULL(
            file_read(path, FILE_LARGEST, &length, &failure));
        if (!scene || reports.count != 1) {
            diagnostics_print(&reports, stderr);
            fail_msg("%s.pov has other reports", names[i]);
        }
        assert_string_equal(said(&reports), expected);
    }
}

/* ---- Errors ------------------------------------------------------------- */

/* Each text has exactly this error. */
TEST(errors)
{
    static const struct line_error rows[] = {
        { "#if (1 sphere { #end", 8, "expected ')'" },
        { "#if 1 sphere { #end", 5, "expected '('" },
        { "#if (x) sphere { #end", 6, "expected a number" },
        { "#if (1) sphere { 0, 1 }", 1, "'#if' has no matching '#end'" },
        { "#if (0) sphere { 0, 1 }", 1, "'#if' has no matching '#end'" },
        { "#if (0) #else #else #end", 15, "'#else' without a matching '#if'" },
        { "#elseif (1)", 1, "'#elseif' without a matching '#if'" },
        { "#while (Foo) } #end", 9, "'Foo', which is not declared" },
        { "#while (1) #break", 1, "'#while' has no matching '#end'" },
        { "#while (1) #end", 1, "more than 2000000 iterations" },
        { "#declare I = 0; #while (I < 3) sphere { 0, Q } #end", 44, "'Q'" },
        { "#while (1 #end ) #end", 11, "'#end' without a matching directive" },
        { "#for (I, 1, 2, 0) } #end", 16, "the step must not be 0" },
        { "#for (I, 1) } #end", 11, "expected ','" },
        { "#for (x, 1, 2) } #end", 7, "keyword, not a name" },
        { "#for (3, 1, 2) } #end", 7, "expected a name" },
        { "#for (I, 1, 2) #local I = x; #end", 7, "no longer a number" },
        { "#for (I, 0, 1) #else #end", 16, "'#else' without a matching '#if'" },
        { "#switch (1) #case (1)", 1, "'#switch' has no matching '#end'" },
        { "#switch (1) #case (x) } #end", 20, "expected a number" },
        { "#switch (1) #range (1) } #end", 22, "expected ','" },
        { "#switch (1) #else #case (1) #end", 19, "'#case' without a" },
        { "#case (1)", 1, "'#case' without a matching '#switch'" },
        { "#break", 1, "'#break' outside of a loop" },
        { "#if (1) #break #end", 9, "'#break' outside of a loop" },
        { "#declare A = \"a\"; sphere { 0, A }", 31, "found 'A'" },
        { "sphere { 0, strlen(1) }", 20, "expected a string" },
        { "#declare A = concat();", 21, "expected a string" },
        { "#declare A = concat(\"a\" \"b\");", 25, "expected ')'" },
        { "#declare A = \"a\\q\";", 14, "escape" },
        { "#declare A = \"\\u00\";", 14, "escape" },
        { "#declare A = str(1, 2);", 22, "expected ','" },
        { "#declare A = str(1, 2e9, 0);", 19, "at most 1000" },
        { "#declare A = vstr(6, x, \"\", 0, 0);", 19, "between 2 and 5" },
        { "#declare A = substr(\"abc\", 2, 3);", 26, "has only 3 characters" },
        { "#declare A = substr(\"abc\", 0, 1);", 26, "has only 3 characters" },
        { "#declare A = chr(0);", 18, "not a character" },
        { "#declare A = (\"a\" + \"b\");", 19, "a comparison" },
        { "#declare A = (\"a\" = 1);", 21, "expected a string" },
        { "#declare A = rand(0);", 19, "unknown random stream" },
        { "#declare A = seed(1e12);", 19, "is out of range" },
        { "#declare A = vturbulence(1, 2, 3, x);", 14, "not supported" },
        { "#declare A = trace(1, 2, 3);", 14, "not supported" },
        { "#declare A = pow(0, 0);", 14, "not a finite number" },
        { "#declare A = array[0];", 19, "no elements" },
        { "#declare A = array[-1];", 20, "not between 0 and" },
        { "#declare A = array[1e5][1e5];", 14, "100000 elements" },
        { "#declare A = array[2] { 1, x }", 28, "of another kind" },
        { "#declare A = array[2] { 1 }", 27, "expected a value" },
        { "#declare A = array[1] { 1, 2 }", 28, "expected '}'" },
        { "#declare A = array[2]; #declare A[2] = 1;", 35, "between 0 and 1" },
        { "#declare A = array[2]; sphere { 0, A[0] }", 36, "is not set" },
        { "#declare A = array[2][2]; #declare A[1] = 3;", 41, "expected '['" },
        { "#declare A = array[2] { 1, 2 } #declare A[0] = x;", 41, "of another kind" },
        { "#declare A = 1; sphere { 0, A[0] }", 30, "found '['" },
        { "sphere { 0, dimensions(x) }", 24, "expected an array" },
        { "#declare str = 1;", 10, "keyword, not a name" },
        { "#declare array = 1;", 10, "keyword, not a name" },
        { "#declare A = 3 sphere { 0, A }", 15, "';' is missing" },
        { "#debug 3", 8, "expected a string" },
        { "#include strlen(\"a\")", 10, "a file name in quotes" },
        { "#include concat(\"no/\", \"such\")", 10, "no such file" },
        { "#version x;", 10, "expected a number" },
        { "#fopen A \"no/such\" read", 10, "no such file" },
        { "#fopen A \"a\" reed", 14, "expected read, write or append" },
        { "#fopen A read", 10, "expected a string" },
        { "#read (A, B)", 8, "the name of an open file" },
        { "#declare A = 1; #read (A, B)", 24, "the name of an open file" },
        { "#read A", 7, "expected '('" },
        { "#fclose A", 9, "the name of an open file" },
        { "#declare A = array[2]; #fopen A[0] \"a\" write", 31,
          "an array element cannot be used as a file" },
        { "#declare A = array[2] { 1, 2 } sphere { 0, A[0 #undef A] }", 44,
          "the array of this element no longer exists" },
        { "#declare A = array[2]; #declare A[0 #undef A] = 1;", 33,
          "the array of this element no longer exists" },
        { "#declare A = function(a) { 1/(1/a) } sphere { 0, A(0) }", 50,
          "not a finite number" },
        { "#declare A = function(a) { !a }", 28, "expected a number" },
        { "#declare A = function(a, 1) { 1 }", 26, "name of a parameter" },
        { "#declare A = function { a }", 25, "expected a number or" },
        { "#declare A = function { x y }", 27, "expected '}'" },
        { "#declare A = function { vlength(x) }", 25, "function of floats" },
        { "#declare A = function { <1, 2> }", 25, "expected a number" },
        { "#declare A = function { sin(x, y) }", 30, "expected ')'" },
        { "#declare A = function { max() }", 29, "expected a number" },
        { "#declare A = function(a, b) { transform { scale 2 } }", 29,
          "3 parameters, found 2" },
        { "#declare A = function(a) { a/(a - 1) } sphere { 0, A(1) }", 52,
          "not a finite number" },
        { "#declare A = function(a) { a } sphere { 0, A(1, 2) }", 47, "expected ')'" },
        { "#declare A = function(a, b) { a } sphere { 0, A(1) }", 50, "expected ','" },
        { "#declare A = function { pattern { wood } } sphere { A(1, 2, 3), 1 }", 53,
          "a function with 'pattern' is not supported" },
        { "#declare A = function { internal(9) }"
          " #declare B = function { A(x, 1, 2, 3).x } sphere { B(1, 2, 3) 1 }",
          90, "a function with 'internal' is not supported" },
        { "#declare A = spline { linear_spline }", 37, "expected a number" },
        { "#declare A = spline { 0 }", 25, "expected a number" },
        { "#declare A = spline { x, 1 }", 23, "expected a number" },
        { "#declare A = spline { akima_spline 0, 1 }", 23, "'akima_spline'" },
        { "#declare A = spline { 0, 1 } sphere { A, 1 }", 40, "expected '('" },
        { "#declare A = spline { 0, 1 } sphere { A(x), 1 }", 41, "expected a number" },
        { "#declare A = spline { 0, 1 } sphere { A(1, 2), 1 }", 44,
          "a kind of spline" },
        { "#declare A = spline { 0, 1 } sphere { A(1).z, 1 }", 44,
          "a component of the value" },
        { "#declare A = spline { 0, -1e308 1e-9, 1e308 } sphere { A(1e-10), 1 }", 56,
          "not a finite number" },
        { "#error concat(\"a\", \"b\")", 1, "ab" },
    };
    assert_errors(rows, COUNT(rows));
    assert_refused("#declare F = function(x) { x } #for (I, 1, 1000000)"
                   " #declare F = function(x) { F(x) + 1 } #end",
                   1, "200 nested function calls");
    assert_refused("#declare A = array[2]; sphere { 0, A[2] }", 2,
                   "2 is not between 0 and 1");
}

/* ---- Messages ----------------------------------------------------------- */

TEST(debug)
{
    static const char text[] =
        "#debug \"one, \"\n#declare A = 2; #debug str(A, 0, 1)\n"
        "#render \"\\n\" #statistics \"three\\n\" sphere { 0, 1 }";
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = read_reported(text, &strict_options, &reports);
    assert_int_equal(reports.count, 1);
    assert_int_equal(reports.errors, 0);
    assert_string_equal(said(&reports), "one, 2.0\nthree\n");
}

/* A report with the same place and text is issued only once. */
TEST(warnings)
{
    static const char text[] = "#for (I, 1, 9)\n"
                               "    #warning \"same\"\n"
                               "    #warning concat(\"other \", str(div(I, 5), 0, 0))\n"
                               "#end";
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = read_reported(text, &reading_options, &reports);
    assert_int_equal(reports.count, 3);
    assert_string_equal(reports.items[2].message, "other 1");
}

TEST(too_much_said)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = read_reported("#for (I, 1, 9999) #debug \"0123456789\" #end",
                                         &reading_options, &reports);
    assert_int_equal(reports.count, 2);
    assert_non_null(strstr(reports.items[1].message, "bytes of messages"));
}
