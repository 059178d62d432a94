/* test_named_parts.c - the names, materials and densities of a scene's objects are
 * compared with expected values. A part that is merged with another part, or a density
 * of another name, fails here. */
#include "rt/mass/bodies.h"
#include "rt/mass/densities.h"
#include "rt/mass/units.h"
#include "scene_reading.h"

static const char assembly[] =
    "#declare Copper = texture { pigment { rgb x } };\n"
    "#declare Steel = texture { pigment { rgb y } };\n"
    "#declare Copper_Density = 8.96;\n"
    "#declare Pin = cylinder { 0, y, .1 };\n"
    "#declare Plate = difference { box { 0, 1 } object { Pin } }\n"
    "object { Plate texture { Steel } }\n"
    "object { Pin texture { Copper } }\n"
    "object { Pin texture { Copper } translate x }\n"
    "object { Pin texture { Steel } translate 2*x }\n"
    "sphere { 0, 1 }\n"
    "union { sphere { 0, 1 texture { Steel } } box { 0, 1 texture { Copper } } }\n"
    "difference { box { 0, 1 texture { Copper } } sphere { 0, .5 texture { Steel } } }\n"
    "#macro Twice(Thing)\n"
    "object { Thing translate 5*x texture { Steel } }\n"
    "#end\n"
    "Twice(Pin)\n"
    "light_source { 9, 1 }\n";

/* ---- The scene ----------------------------------------------------------- */

static void assert_text(const char *text, const char *expected)
{
    if (expected)
        assert_string_equal(text, expected);
    else
        assert_null(text);
}

TEST(names)
{
    static const struct world_object expected[] = {
        { "Plate", "Steel", false, 6 }, { "Pin", "Copper", false, 7 },
        { "Pin", "Copper", false, 8 },  { "Pin", "Steel", false, 9 },
        { NULL, NULL, false, 10 },      { NULL, "Steel", true, 11 },
        { NULL, "Copper", false, 12 },  { "Pin", "Steel", false, 16 },
    };
    SCOPED(scene) *scene = read_scene(assembly);
    assert_int_equal(scene->object_count, COUNT(expected));
    for (size_t i = 0; i < COUNT(expected); i++) {
        assert_text(scene->objects[i].name, expected[i].name);
        assert_text(scene->objects[i].material, expected[i].material);
        assert_true(scene->objects[i].mixed == expected[i].mixed);
        assert_int_equal(scene->objects[i].line, expected[i].line);
    }
    assert_int_equal(scene->float_count, 1);
    assert_string_equal(scene->floats[0].name, "Copper_Density");
    assert_close(scene->floats[0].value, 8.96, 0);
}

/* ---- Parts and densities ------------------------------------------------- */

TEST(parts)
{
    static const size_t part_of[] = { 0, 1, 1, 2, 3, 4, 5, 2 };
    SCOPED(scene) *scene = read_scene(assembly);
    SCOPED_VALUE(named_parts) parts;
    assert_true(named_parts_find(scene, &parts));
    assert_int_equal(parts.count, 6);
    assert_memory_equal(parts.part_of, part_of, sizeof part_of);
    assert_string_equal(parts.list[3].name, "line 10");
    assert_true(parts.list[4].mixed);
}

/* Parts are selected by their names or by the names of their materials. Without names,
 * all bounded parts are selected. */
TEST(choice)
{
    static const char *const names[] = { "Plate", "Copper", "Brass" };
    SCOPED(scene) *scene = read_scene("plane { y, -9 }\n");
    SCOPED(scene) *solids = read_scene(assembly);
    struct named_parts parts;
    struct scene bodies;
    assert_true(named_parts_find(scene, &parts));
    assert_true(bodies_find_endless(scene, &parts));
    assert_true(named_parts_choose(&parts, NULL, 0, &failure));
    assert_true(parts.list[0].left_out);
    assert_true(bodies_take(scene, &parts, &bodies));
    assert_int_equal(bodies.region_count, 0);
    bodies_free(&bodies);
    named_parts_free(&parts);
    assert_true(named_parts_find(solids, &parts));
    assert_true(bodies_find_endless(solids, &parts));
    assert_true(named_parts_choose(&parts, names, 2, &failure));
    for (size_t i = 0; i < parts.count; i++)
        assert_true(parts.list[i].left_out == (i > 1 && i != 5));
    assert_true(bodies_take(solids, &parts, &bodies));
    assert_int_equal(bodies.region_count, 4);
    assert_int_equal(bodies.primitive_count, 6);
    bodies_free(&bodies);
    assert_true(named_parts_choose(&parts, names + 1, 1, &failure));
    assert_true(bodies_take(solids, &parts, &bodies));
    assert_int_equal(bodies.region_count, 3);
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(bodies.regions[i].first_node, i);
        assert_int_equal(bodies.nodes[i].next, i + 1);
        assert_int_equal(bodies.nodes[i].primitive, i);
        assert_int_equal(bodies.primitives[i].kind, PRIMITIVE_CYLINDER);
    }
    assert_false(named_parts_choose(&parts, names, 3, &failure));
    bodies_free(&bodies);
    named_parts_free(&parts);
}

/* Options precede the scene. In each, names precede materials and the default. */
TEST(densities)
{
    SCOPED(scene) *scene = read_scene(assembly);
    FREED_BY(named_free)
    struct named_values densities = { .kind = &density_kind, .others = NAN };
    SCOPED_VALUE(named_parts) parts;
    c205_error error;
    static const double expected[] = { 2, 8.96, 7.8, 3, 3 };
    double found[COUNT(expected)];
    assert_true(named_parts_find(scene, &parts));
    assert_true(named_add(&densities, "Steel=7.8", &error));
    assert_true(named_add(&densities, "Plate=2", &error));
    assert_true(named_check(&densities, &parts, NULL, &error));
    assert_true(named_add_scene(&densities, scene, &error));
    assert_false(densities_find(&densities, &parts, found, &error));
    assert_string_equal(error.message,
                        "no density is set for: line 10, line 11 (of several "
                        "materials); use --density NAME=VALUE, or --density default=1");
    assert_true(named_add(&densities, "default=3", &error));
    assert_true(densities_find(&densities, &parts, found, &error));
    for (size_t i = 0; i < COUNT(expected); i++)
        assert_close(found[i], expected[i], 0);
    assert_true(named_add(&densities, "Brass=8", &error));
    assert_false(named_check(&densities, &parts, NULL, &error));
    assert_string_equal(error.message,
                        "unknown part or material 'Brass'; parts: Plate, Pin, "
                        "line 10, line 11, line 12; materials: Steel, Copper");
}

TEST(wrong_densities)
{
    static const char *const wrong[] = { "",     "=1",    "a",    "a=",  "a=0",
                                         "a=-1", "a=inf", "a=1x", "a=x", "a=nan" };
    FREED_BY(named_free)
    struct named_values densities = { .kind = &density_kind, .others = NAN };
    SCOPED(scene) *scene = read_scene("#declare Lead_Density = 0;\n");
    c205_error error;
    for (size_t i = 0; i < COUNT(wrong); i++)
        assert_false(named_add(&densities, wrong[i], &error));
    assert_false(named_add_scene(&densities, scene, &error));
    assert_string_equal(error.message, "Lead_Density must be above 0");
    assert_int_equal(densities.count, 0);
}

static bool read_file(const char *text, struct named_values *densities,
                      struct diagnostics *reports)
{
    static const char path[] = "densities_test.txt";
    write_bytes(path, text, strlen(text));
    bool good = named_read(densities, path, reports);
    remove(path);
    return good;
}

TEST(file)
{
    FREED_BY(named_free)
    struct named_values densities = { .kind = &density_kind, .others = NAN };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    assert_true(read_file("# a table\n\n1 7.85 Carbon Steel\r\n"
                          "2\t8.96\t\"Copper\" # soft\n3 .5 Pine",
                          &densities, &reports));
    assert_int_equal(densities.count, 3);
    assert_string_equal(densities.list[0].name, "Carbon Steel");
    assert_string_equal(densities.list[1].name, "Copper");
    assert_close(densities.list[2].value, .5, 0);
    assert_false(
        read_file("1 7.85 Steel\n2 x Copper\n3 -1 Lead\n4 5\n", &densities, &reports));
    assert_int_equal(reports.count, 3);
    assert_int_equal(reports.items[0].line, 2);
    assert_string_equal(reports.items[1].message, "the density must be above 0");
    assert_string_equal(reports.items[2].message,
                        "expected a line with a number, a density and a name");
    assert_false(named_read(&densities, "no/such/file", &reports));
}

/* ---- Units --------------------------------------------------------------- */

TEST(units)
{
    static const char *const wrong[] = { "",     "mm",   "mm,",   ",g",
                                         "mm,x", "g,mm", "mm,g,", "m m,g" };
    struct mass_units units = { 0 };
    char text[MASS_UNIT];
    assert_close(mass_units_density(&units, 8.96), 8.96, 0);
    mass_units_text(&units, 1, 2, text);
    assert_string_equal(text, "");
    for (size_t i = 0; i < COUNT(wrong); i++)
        assert_false(mass_units_take(wrong[i], &units));
    assert_true(mass_units_take("mm,g", &units));
    assert_close(mass_units_density(&units, 8.96), .00896, 1e-15);
    mass_units_text(&units, 1, 2, text);
    assert_string_equal(text, "g mm^2");
    mass_units_text(&units, 0, 3, text);
    assert_string_equal(text, "mm^3");
    mass_units_text(&units, 0, 1, text);
    assert_string_equal(text, "mm");
    mass_units_text(&units, 1, 0, text);
    assert_string_equal(text, "g");
    assert_true(mass_units_take("m,kg", &units));
    assert_close(mass_units_density(&units, 1), 1000, 1e-9);
    assert_true(mass_units_take("in,lb", &units));
    assert_close(mass_units_density(&units, 7.85), .283598, 1e-5);
}
