/* test_scene_reports.c - the scene language. Reports and errors of short texts are
 * compared with their positions and messages. A report that is lost, misplaced or
 * repeated, or memory without a limit, fails here.
 *
 * The texts are large, so the test is slow with the leak sanitizer.
 */
#include "tests/unit/scene_reading.h"

/* Texts with exactly one error each, its position and a part of its message. */
TEST(errors)
{
    static const struct place_error rows[] = {
        { "ovus { }", 1, 1, "'ovus' is not supported" },
        { "union { sphere { 0, 1 }\n ovus { 0, 1, y, 0 } }", 2, 2, "'ovus'" },
        { "difference { sphere { 0 1 } sor { } }", 1, 29, "'sor'" },
        { "sphere { 0, 1 interior { ior 0 } }", 1, 26, "ior must be above 0" },
        { "merge { sphere { 0 1 } inverse sphere { 0 1 } }", 1, 32, "found 'sphere'" },
        { "sphere { 0, 1 clipped_by { triangle { 0, x, y } } }", 1, 28,
          "a mesh has no inside and cannot clip" },
        { "sphere { 0, 1 clipped_by { bounded_by } }", 1, 28, "bounded_by" },
        { "sphere { 0, 1 clipped_by { union { box { 0, 1 } light_source { 0, 1 } } } }",
          1, 28, "a light has no inside" },
        { "sphere { 0, 1 #for (I, 1, 10000) clipped_by { plane { y, 2 } } #end }", 1,
          34, "more than 10000 primitives in one solid" },
        { "sphere { 0, 1 clipped_by { light_source { 0, 1 } } }", 1, 28,
          "a light has no inside" },
        { "sphere { 0, 1 inverted }", 1, 15, "found 'inverted'" },
        { "camera { fisheye }", 1, 10, "'fisheye'" },
        { "sphere { 0, Foo }", 1, 13, "'Foo', which is not declared" },
        { "sphere { 0, 1", 1, 14, "expected '}' to close the '{' of line 1" },
        { "sphere 0, 1", 1, 8, "expected '{', found '0'" },
        { "sphere { <1, 2, 3, 4, 5, 6>, 1 }", 1, 26, "expected '>'" },
        { "sphere { <1>, 1 }", 1, 12, "expected a number or a vector" },
        { "sphere { rgb 1, 1 }", 1, 10, "found 'rgb'" },
        { "sphere { x, y }", 1, 13, "expected a number, found 3" },
        { "#declare C = rgb 1; sphere { C, 1 }", 1, 30, "a vector of 3" },
        { "plane { 0, 1 }", 1, 9, "the normal has no direction" },
        { "sphere { 0, 1/0 }", 1, 14, "division by 0" },
        { "sphere { 0, sqrt(-1) }", 1, 13, "not a finite number" },
        { "sphere { 0, 1e300*1e300 }", 1, 18, "not a finite number" },
        { "sphere { 0, 1e999 }", 1, 13, "the number is too large" },
        { "sphere { 0, x.foo }", 1, 15, "a component" },
        { "sphere { 0, x.t }", 1, 15, "a component" },
        { "sphere { 0, sin(1, 2) }", 1, 18, "expected ')'" },
        { "sphere { 0, 1 scale 2 colr 1 }", 1, 23, "found 'colr'" },
        { "sphere { 0, 1 matrix <1,1,0,1,1,0,0,0,1,0,0,0> }", 1, 15, "no inverse" },
        { "sphere { 0, 1 finish { roughness 0 } }", 1, 24, "roughness" },
        { "sphere { 0, 1 pigment { rgb <1, 2, 3, 4> } }", 1, 29, "'rgb' takes 3" },
        { "camera { angle 180 }", 1, 10, "at least 0 and below 180" },
        { "camera { blur_samples 0 }", 1, 10, "must be at least 1" },
        { "camera { aperture z }", 1, 19, "expected a number" },
        { "camera { location x look_at x }", 1, 1, "are the same" },
        { "camera { up x }", 1, 1, "linearly independent" },
        { "union { sphere { 0 1 } scale 2 sphere { 0 1 } }", 1, 32, "found 'sphere'" },
        { "#declare A = 1 sphere { 0, 1 }", 1, 15, "';' is missing" },
        { "#declare x = 1;", 1, 10, "'x' is a keyword, not a name" },
        { "#declare A = ;", 1, 14, "expected a value, found ';'" },
        { "#if (1) sphere { 0, 1 #end", 1, 27, "to close the '{' of line 1" },
        { "#while (1) #if (1) #end } #end", 1, 25, "found '}'" },
        { "#end", 1, 1, "'#end'" },
        { "#frob", 1, 1, "unknown directive '#frob'" },
        { "#include \"no/such.inc\"", 1, 10, "no such file" },
        { "#include \"colors.inc\"\n#include \"\"", 2, 10, "the file name is empty" },
        { "#error \"gone\"", 1, 1, "gone" },
        { "sphere { 0, 1 } }", 1, 17, "found '}'" },
        { "sphere { 0, 1 } @", 1, 17, "unknown character" },
        { "sphere { 0, 1 }\n/* /* */", 2, 1, "comment is not closed" },
        { "sphere { 0, 1 } \"", 1, 17, "string is not closed" },
        { "object { sphere { 0, 1 } sphere { 0, 1 } }", 1, 26, "'sphere'" },
        { "light_source { 0, rgb 1 shadowless looks_like { sphere {0 x} } }", 1, 59,
          "expected a number" },
        { "light_source { 0, rgb 1 looks_like { } }", 1, 38, "the name of an object" },
        { "light_source { 0, 1 spotlight point_at 0 }", 1, 14,
          "location and point_at of the light are the same" },
        { "light_source { 0, 1 radius 3 spotlight }", 1, 21,
          "'radius' requires 'spotlight'" },
        { "light_source { 0, 1 spotlight tightness -101 }", 1, 14,
          "the tightness must be at least -100" },
        { "light_source { x, 1 cylinder falloff 0 }", 1, 14,
          "the falloff of a cylinder light must be above 0" },
        { "light_source { 0, 1 area_light x, y, 0, 2 }", 1, 21,
          "points along a side of an area_light must be between 1 and 65536" },
        { "light_source { 0, 1 area_light x, y, 300, 300 }", 1, 21,
          "has 90000 points, but at most 65536" },
        { "light_source { 0, 1 circular area_light x, y, 3, 1 }", 1, 14,
          "at least 2 points" },
        { "sphere { 0, 1 pigment { brick brick_size <1, 0, 1> } }", 1, 31,
          "the size of a brick must not be 0" },
        { "sphere { 0, 1 pigment { onion poly_wave -101 } }", 1, 31,
          "the exponent must be at least -100" },
        { "poly { 5, <1> }", 1, 8, "the order must be between 2 and 4" },
        { "poly { 2, <1, 2> }", 1, 11, "expected 10 coefficients, found 2" },
        { "cubic { <1> }", 1, 9, "expected 20 coefficients, found 1" },
        { "#declare B = sphere { 0, Foo } object { B } object { B scale 2 }", 1, 26,
          "'Foo'" },
        { "sphere { 0, 1 scale 1e200 scale 1e200 }", 1, 1, "out of range" },
    };
    assert_place_errors(rows, COUNT(rows), &reading_options);
}

/* Texts with exactly one report each, which is an error in strict mode. */
TEST(reports)
{
    static const struct line_error rows[] = {
        { "sphere { 0, 1 normal { bumps .5 scale { } } }", 24, "'bumps'" },
        { "sphere { 0, 1e200 } sphere { 0, 1 }", 1,
          "sphere is too large or too small to be traced: the shape is ignored" },
        { " merge { box { 0, 1 } sphere { 0, 1e-310 } }", 2,
          "the sphere is too large or too small" },
        { "cylinder { 0, 1e-200*x, 1 } sphere { 0, 1 }", 1,
          "the cylinder is too large" },
        { "cone { 0, -1, y, 1 } sphere { 0, 1 }", 8,
          "a radius of the cone is below 0" },
        { "sphere { 0, 1 normal { bozo normal_map { [0 gradient x] } } }", 24,
          "a normal of the pattern 'bozo'" },
        { "sphere { 0, 1 normal { bump_map { png \"a.png\" } scale 2 } }", 24,
          "'bump_map'" },
        { "sphere { 0, 1 normal { gradient x turbulence 1 } }", 35, "'turbulence'" },
        { "sphere { 0, 1 normal { average normal_map { [onion] [bumps] } } }", 54,
          "'bumps'" },
        { "sphere { 0, 1 normal { onion normal_map { [0 onion] [1 planar"
          " normal_map { [0 radial] [1 boxed] } ] } } }",
          53, "its first normal is used instead" },
        { "sphere { 0, 1 normal { quilted normal_map { [0 onion] } } }", 22,
          "of a quilted normal" },
        { "sphere { 0, 1 normal { onion normal_map { [0 onion no_bump_scale] } } }", 43,
          "inside a map" },
        { "sphere { 0, 1 double_illuminate }", 15, "'double_illuminate'" },
        { "difference { sphere { 0, 1 } sphere { x, 1 } cutaway_textures }", 46,
          "'cutaway_textures'" },
        { "merge { sphere { 0, 1 no_image } sphere { x, 1 } }", 9,
          "'no_image' on a part" },
        { "difference { union { sphere { 0, 1 no_reflection }"
          " sphere { x, 1 no_image } } sphere { y, 1 } }",
          14, "'no_reflection' on a part" },
        { "sphere { 0, 1 finish { reflection { .1 exponent 2 } } }", 40, "'exponent'" },
        { "sphere { 0, 1 interior { ior 1.5 caustics 1 } }", 34, "'caustics'" },
        { "union { sphere { 0, 1 } }", 1, "fewer than two objects" },
        { "intersection { }", 1, "fewer than two objects" },
        { "sphere { 0 1 } merge { light_source { 0, 1 } }", 16, "in this 'merge'" },
        { "difference { sphere { 0, 1 } steiner_patch { x, y, z, 0, 0, 0 } }", 30,
          "no inside" },
        { "sphere { 0, 1 pigment { rgb 1 } texture { pigment { rgbt 1 } } }", 33,
          "layered" },
        { "sphere { 0, 1 finish { subsurface { 1 } phong 1 } }", 24, "'subsurface'" },
        { "sphere { 0, 1 finish { diffuse albedo .5 } }", 32, "'albedo'" },
        { "sphere { 0, 1 finish { diffuse .5, .2 } }", 34, "inside" },
        { "sphere { 0, 1 pigment { granite } }", 25, "'granite'" },
        { "sphere { 0, 1 texture { gradient y texture_map {"
          " [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } } }",
          25, "'gradient'" },
        { "sphere { 0, 1 scale <1, 0, 1> }", 15, "along y" },
        { "fog { fog_type 2 distance 10 color rgb 1 }", 1, "type 2" },
        { "fog { distance -10 color rgb 1 }", 1, "below 0" },
        { "fog { distance 10 color rgb 1 turbulence .3 }", 31, "'turbulence'" },
        { "sphere { 0, 1 pigment { rgbt .5 } } fog { distance 1 rgb 1 }", 37,
          "fog also fills transparent objects" },
        { "sky_sphere { emission 2 }", 14, "'emission'" },
        { "camera { normal { bumps .5 } location x }", 10, "normal" },
        { "global_settings { radiosity { count 9 } }", 19, "'radiosity'" },
        { "global_settings { charset utf8 }", 19, "'charset'" },
        { "light_source { 0, 1 projected_through { sphere { 0, 1 } } }", 21,
          "'projected_through'" },
        { "light_group { light_source { 0, 1 } sphere { 0, 1 } }", 1, "'light_group'" },
        { "light_source { 0, 1 area_light x, <0, 1, 0>, 4, 4 jitter }", 51,
          "'jitter'" },
        { "light_source { 0, 1 area_light x, y, 4, 4 parallel point_at z }", 14,
          "for a parallel light" },
        { "#warning \"old\"", 1, "old" },
        { "#version 3.1; global_settings { assumed_gamma 1 }", 10, "version 3.7" },
        { "#version 3.6;", 10, "without gamma correction" },
        { "#undef A", 8, "'A' is not declared" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        scene_free(read_with(rows[i].text, 1));
        assert_error(rows[i].text, &strict_options, 1, rows[i].column, rows[i].message);
    }
}

/* One reading finds all errors. It continues after each error. */
TEST(all_errors)
{
    static const char text[] = "sphere { 0, foo finish { wibble 2 phong x } scale }\n"
                               "ovus { 0, y, 1 }\n"
                               "union { box { 0, 1 rotate <1, 2 } sphere { } bar }\n"
                               "camera { location }\n";
    static const size_t lines[] = { 1, 1, 1, 1, 2, 3, 3, 3, 4 };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    assert_null(read_versioned("test.pov", text, &reading_options, &reports));
    if (reports.count != COUNT(lines))
        diagnostics_print(&reports, stderr);
    assert_int_equal(reports.count, COUNT(lines));
    for (size_t i = 0; i < COUNT(lines); i++)
        assert_int_equal(reports.items[i].line, lines[i]);
}

TEST(print)
{
    static const char expected[] = "test.pov:2:10: error: 'ovus' is not supported\n"
                                   "    \xc3\xa4? */   ovus { 1, 2 }\n"
                                   "            ^\n";
    SCOPED_VALUE(diagnostics) reports = { 0 };
    FREED char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    read_versioned("test.pov", "/*\n\xc3\xa4\x01 */  \tovus { 1, 2 }\r\n",
                   &reading_options, &reports);
    diagnostics_print(&reports, out);
    fclose(out);
    assert_string_equal(text, expected);
}

static void write_file(const char *folder, const char *name, const char *text)
{
    write_bytes(formatted("%s/%s", folder, name), text, strlen(text));
}

static void delete_files(const char *folder, const char *const *names)
{
    for (; *names; names++)
        assert_int_equal(remove(formatted("%s/%s", folder, *names)), 0);
    assert_int_equal(remove(folder), 0);
}

TEST(includes)
{
    static const char *const names[] = { "main.pov", "part.inc", "loop.inc", NULL };
    char folder[] = "/tmp/scene-XXXXXX", path[200];
    struct diagnostics reports = { 0 };
    assert_non_null(mkdtemp(folder));
    write_file(folder, "main.pov",
               "#version 3.7;\n#include \"part.inc\"\nsphere { 0, R }\n");
    write_file(folder, "part.inc",
               "#local L = 2;\n#declare R = L + 1;\n"
               "\n\nbox { -1, L }");
    write_file(folder, "loop.inc", "#include \"loop.inc\"\n");
    snprintf(path, sizeof path, "%s/main.pov", folder);
    struct scene *scene = NON_NULL(scene_read(path, &reading_options, &reports));
    assert_int_equal(scene->primitives[0].line, 2); /* line of the #include */
    assert_int_equal(scene->primitives[1].line, 3);
    assert_close(scene->primitives[1].shape.sphere.radius, 3, 0);
    scene_free(scene);

    write_file(folder, "main.pov", "#include \"part.inc\"\nsphere { 0, L }");
    /* L was a local name of the included file */
    assert_null(scene_read(path, &reading_options, &reports));
    assert_int_equal(reports.count, 1);
    assert_int_equal(reports.items[0].line, 2);
    diagnostics_free(&reports);

    write_file(folder, "main.pov", "#include \"loop.inc\"\n");
    assert_null(scene_read(path, &reading_options, &reports));
    assert_non_null(strstr(reports.items[0].file, "loop.inc"));
    assert_non_null(strstr(reports.items[0].message, "nested include files"));
    diagnostics_free(&reports);

    const char *const search[] = { folder, NULL };
    const struct scene_options searching = { 4, 3, false, search, NULL, NULL, NULL, 0 };
    scene = NON_NULL(
        read_versioned("x.pov", "#include \"part.inc\"", &searching, &reports));
    scene_free(scene);
    delete_files(folder, names);
    assert_null(scene_read(path, &reading_options, &reports));
    assert_int_equal(reports.items[0].line, 0);
    diagnostics_free(&reports);
}

/* The stack, the memory and the list of reports are limited. */
TEST(bounds)
{
    static const struct {
        const char *head, *part;
        const char *message;
    } rows[] = {
        { "", "union{", "levels of nesting" },
        { "sphere{0,", "(", "levels of nesting" },
        { "sphere{0,", "-", "levels of nesting" },
        { "#declare A=sphere{0,1} ", "#declare A=union{object{A}object{A}}",
          "primitives and lights, including copies" },
    };
    FREED char *faults = repeated("", "foo{}\n", 10000);
    for (size_t i = 0; i < COUNT(rows); i++) {
        FREED char *text = repeated(rows[i].head, rows[i].part, 10000);
        assert_refused(text, 201, rows[i].message);
    }
    assert_refused_last(faults, 201, "too many errors");
}

/* A scene is not rejected because of a large number of ignored words. */
TEST(many_places)
{
    enum { COUNT_OF_SPHERES = 1000 };
    FREED char *text = repeated("", "sphere { 0, 1 finish { crand 2 } }\n",
                                COUNT_OF_SPHERES);
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = read_reported(text, &reading_options, &reports);
    assert_int_equal(scene->primitive_count, COUNT_OF_SPHERES);
    assert_int_equal(reports.errors, 0);
    assert_int_equal(reports.count, 1);
    assert_int_equal(reports.items->line, 1);
    assert_non_null(strstr(reports.items->message, "(1000 places"));
}

TEST(many_reports)
{
    enum { MAX_TOLD = 200 };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene =
        read_reported("#for (I, 1, 1000)\n#warning concat(\"no \", str(I, 0, 0))\n#end",
                      &reading_options, &reports);
    assert_int_equal(reports.errors, 0);
    assert_int_equal(reports.count, MAX_TOLD + 1);
    assert_string_equal(reports.items[MAX_TOLD - 1].message, "no 200");
    assert_non_null(strstr(reports.items[MAX_TOLD].message, "omitted"));
}

/* The report states if there are more places than can be recorded. */
TEST(lost_notes)
{
    enum { NOTES = 100001 };
    FREED char *text = repeated("", "sphere{0,1 uv_mapping}\n", NOTES);
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = read_reported(text, &reading_options, &reports);
    assert_int_equal(reports.count, 2);
    assert_non_null(strstr(reports.items[0].message, "(100000 places"));
    assert_int_equal(reports.items[1].line, NOTES);
    assert_non_null(strstr(reports.items[1].message, "too many reports"));
}

/* The limit counts each file once, however often it is opened. */
TEST(many_files)
{
    enum { FILES = 1000 };
    char folder[] = "/tmp/scene-XXXXXX", path[60], text[300];
    struct diagnostics reports = { 0 };
    assert_non_null(mkdtemp(folder));
    for (int i = 1; i <= FILES + 1; i++) {
        snprintf(path, sizeof path, "%d", i);
        write_file(folder, path, "1");
    }
    for (int more = 0; more < 2; more++) {
        snprintf(text, sizeof text,
                 "#for (J, 1, 3) #for (I, 1, %d) #fopen F concat(\"%s/\","
                 " str(I, 0, 0)) read #fclose F #end #end",
                 FILES - 1 + more, folder);
        SCOPED(scene) *scene = NON_NULL(
            read_versioned("x.pov", text, &reading_options, &reports));
    }
    snprintf(text, sizeof text,
             "#for (I, 1, %d) #fopen F concat(\"%s/\", str(I, 0, 0)) read #end",
             FILES + 1, folder);
    assert_refused(text, 1, "more than 1000 files are read");
    for (int i = 1; i <= FILES + 1; i++) {
        snprintf(path, sizeof path, "%s/%d", folder, i);
        assert_int_equal(remove(path), 0);
    }
    assert_int_equal(remove(folder), 0);
}

/* A report about a library is issued once for each used file of the library. */
TEST(libraries)
{
    static const char *const names[] = { "one.inc", "two.inc", NULL };
    char folder[] = "/tmp/scene-XXXXXX";
    const char *const search[] = { folder, NULL };
    const struct scene_options searching = { 4, 3, false, search, NULL, NULL, NULL, 0 };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene;
    assert_non_null(mkdtemp(folder));
    write_file(folder, "one.inc",
               "#include \"two.inc\"\n"
               "#declare A = finish { crand 1 }\n"
               "#declare B = finish { crand 1 }\n");
    write_file(folder, "two.inc",
               "#declare C = finish { crand 1 }\n"
               "#declare D = finish { crand 1 }\n"
               "#declare E = finish { irid { 1 } }\n");
    scene = NON_NULL(read_versioned("x.pov",
                                    "#include \"one.inc\"\n"
                                    "sphere { 0, 1 finish { B } }\n"
                                    "sphere { 0, 1 finish { A } }\n"
                                    "sphere { 0, 1 finish { C } }\n"
                                    "sphere { 0, 1 finish { D } }\n"
                                    "sphere { 0, 1 finish { crand 1 } }\n"
                                    "sphere { 0, 1 finish { crand 1 } }\n",
                                    &searching, &reports));
    assert_int_equal(reports.count, 1);
    assert_non_null(strstr(reports.items->file, "one.inc"));
    assert_non_null(strstr(reports.items->message, "(4 places"));
    delete_files(folder, names);
}
