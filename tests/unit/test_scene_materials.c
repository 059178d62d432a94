/* test_scene_materials.c - the scene language. Reports about named materials are
 * compared with the objects that use the materials, over texts and random scenes. A
 * report without a use, or a use without a report, fails here. */
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

/* ---- Reports and their places ------------------------------------------ */

/* Each text has exactly this report, or no report. */
TEST(reported_when_used)
{
    /* Column 0: no report. `message` is the end of the report. */
    static const struct line_error rows[] = {
        { "#declare F = finish { crand 1 }", 0, "" },
        { "#declare F = finish { crand 1 } #declare G = finish { F }", 0, "" },
        { "#declare F = finish { crand 1 } #declare S = sphere { 0, 1 finish { F } }",
          0, "" },
        { "#declare F = finish { crand 1 } sphere { 0, 1 finish { F } }", 23,
          "is ignored" },
        { "#declare F = finish { crand 1 } #declare G = finish { F }"
          " sphere { 0, 1 finish { G } } sphere { 0, 1 finish { F } }",
          23, "is ignored" },
        { "#declare T = texture { normal { dents 1 } }"
          " #declare S = sphere { 0, 1 texture { T } }"
          " union { object { S } object { S } }",
          33, "is ignored" },
        { "#declare M = material { texture { normal { dents 1 } } }"
          " sphere { 0, 1 material { M } }",
          44, "is ignored" },
        { "#declare I = interior { media { scattering { 1, 1 } } }"
          " sphere { 0, 1 interior { I } }",
          25, "is ignored" },
        { "#declare A = array[2] { finish { crand 1 }, finish { irid { 1 } } }"
          " sphere { 0, 1 finish { A[1] } }",
          54, "'irid' is not supported and is ignored" },
        { "#declare P = pigment { bozo color_map { [0 rgb 1] [1 rgb 0] } }"
          " #macro Ball(What) sphere { 0, 1 pigment { What } } #end Ball(P) Ball(P)",
          24, "its first colour is used instead" },
        { "#declare L = light_source { 0, 1 area_light x, y, 2, 2 jitter } light_source { L }",
          56, "is ignored" },
        { "#declare N = normal { bumps 1 } #declare G = fog { distance 2 }"
          " #declare S = sky_sphere { pigment { rgb 1 } }"
          " #declare D = media { emission 1 }",
          0, "" },
        { "#declare N = normal { bumps 1 } sphere { 0, 1 normal { N } }", 23,
          "is ignored" },
        { "#declare S = sphere { 0, 1 #warning \"said\" }", 28, "said" },
        { "#default { finish { crand 1 } }", 21, "is ignored" },
        { "default { finish { crand 1 } }", 20, "is ignored" },
        { "sphere { 0, 1 uv_mapping } box { 0, 1 uv_mapping }"
          " sphere { 0, 2 uv_mapping }",
          15, "ignored (3 places, this is the first)" },
        { "#for (I, 1, 9) sphere { 0, I uv_mapping } #end", 30, "is ignored" },
        { "global_settings { noise_generator 2 max_intersections 64 }"
          " light_source { 0, 1 point_at 0 photons { refraction on } }"
          " sphere { 0, 1 hollow on photons { target } }",
          0, "" },
        { "sphere { 0, 1 texture { pigment { rgb 1 } }"
          " texture { pigment { rgbt 1 } } }",
          45, "the lowest one is used instead" },
        { "#declare T = texture { pigment { rgb 1 } }"
          " texture { pigment { rgbt 1 } } sphere { 0, 1 texture { T } }",
          44, "the lowest one is used instead" },
        { "sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgb 2 } } }",
          0, "" },
        { "#declare F = function { transform { scale <1, 0, 1> } }"
          " sphere { F(1, 2, 3), 1 }",
          37, "along y is replaced by 1" },
        { "#declare S = sphere { 0, 1 #default { finish { crand 1 } } }", 48,
          "is ignored" },
        { "light_group { sphere { 0, 1 } }", 1, "shine on all objects" },
        { "#fopen F \"a\" write #write (F, 1, x concat(\"a\", \"b\") \",\") #fclose F",
          10, "is ignored" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        SCOPED(scene) *scene = read_reported(rows[i].text, &reading_options, &reports);
        const char *found = reports.count ? reports.items->message : "";
        size_t length = strlen(found), end = strlen(rows[i].message);
        if (reports.count != (rows[i].column != 0)
            || (reports.count && reports.items->column != rows[i].column)
            || length < end || strcmp(found + length - end, rows[i].message)) {
            diagnostics_print(&reports, stderr);
            fail_msg("expected %zu %s, of: %s", rows[i].column, rows[i].message,
                     rows[i].text);
        }
        if (rows[i].column)
            assert_error(rows[i].text, &strict_options, 1, rows[i].column,
                         rows[i].message);
        else
            scene_free(read_reported(rows[i].text, &strict_options, &reports));
        assert_int_equal(reports.count, rows[i].column != 0);
    }
}

/* Random objects, some of which have names, are built from each other. A material is
 * reported if and only if an object of the scene uses it. */
enum { NAMES = 12, LOOKS = 4 };
struct drawing {
    FILE *text;
    uint64_t random;
    size_t names;
    unsigned has[NAMES]; /* bits: the materials of each name */
};

/* Adds a sphere with a material, a named object, or a union of both. */
static unsigned put_thing(struct drawing *drawing)
{
    uint64_t *random = &drawing->random;
    unsigned has;
    int64_t which;
    switch (drawing->names ? xorshift_between(random, 0, 2) : 0) {
    case 0:
        which = xorshift_between(random, 0, LOOKS);
        if (which < LOOKS)
            fprintf(drawing->text, "sphere { 0, 1 texture { T%d } }\n", (int)which);
        else
            fputs("sphere { 0, 1 }\n", drawing->text);
        return which < LOOKS ? 1u << which : 0;
    case 1:
        which = xorshift_between(random, 0, (int64_t)drawing->names - 1);
        fprintf(drawing->text, "object { N%d }\n", (int)which);
        return drawing->has[which];
    default:
        fputs("union {\n", drawing->text);
        has = put_thing(drawing);
        has |= put_thing(drawing);
        fputs("}\n", drawing->text);
        return has;
    }
}

/* Declares the materials first. Returns the materials that the scene uses. */
static unsigned draw(struct drawing *drawing)
{
    static const char *const words[LOOKS] = { "crand", "irid", "subsurface",
                                              "conserve_energy" };
    unsigned reported = 0;
    drawing->names = 0;
    for (int i = 0; i < LOOKS; i++)
        fprintf(drawing->text, "#declare T%d = texture { finish { %s 1 } }\n", i,
                words[i]);
    while (drawing->names < NAMES) {
        if (xorshift_between(&drawing->random, 0, 3) == 0) {
            reported |= put_thing(drawing);
            continue;
        }
        fprintf(drawing->text, "#declare N%zu = ", drawing->names);
        drawing->has[drawing->names] = put_thing(drawing);
        drawing->names++;
    }
    return reported;
}

static unsigned reported_of(const char *text)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = read_reported(text, &reading_options, &reports);
    unsigned reported = 0;
    for (size_t i = 0; i < reports.count; i++)
        reported |= 1u << (reports.items[i].line - 1);
    return reported;
}

TEST(reported_by_chance)
{
    enum { SCENES = 300 };
    struct drawing drawing = { .random = RANDOM_SEED };
    for (int i = 0; i < SCENES; i++) {
        FREED char *text = NULL;
        size_t length;
        drawing.text = NON_NULL(open_memstream(&text, &length));
        unsigned expected = draw(&drawing);
        fclose(drawing.text);
        unsigned reported = reported_of(text);
        FAIL_IF(reported != expected, "told %X, expected %X, of:\n%s", reported,
                expected, text);
    }
}

/* ---- Maps and layers ---------------------------------------------------- */

/* For an unsupported map, list or layers, the first colour is used. Only the last text,
 * whose upper layer is opaque, causes no report. */
TEST(maps_and_layers)
{
    static const char *const texts[] = {
        "sphere { 0, 1 pigment { bozo color_map { [0 rgb <1, 2, 3>] [1 rgb 0] } } }",
        "sphere { 0, 1 pigment { granite"
        " colour_map { [0, .5 color C color rgb 0] [.5, 1 x x] } } }",
        "sphere { 0, 1 pigment { square color rgb <1, 2, 3>, color rgb 0 } }",
        "sphere { 0, 1 pigment { triangular C, C*2, C*3 } }",
        "sphere { 0, 1 pigment { wood pigment_map { [0 C] [1 checker C, rgb 0] } } }",
        "sphere { 0, 1 pigment { image_map { hdr \"a.hdr\" } color C } }",
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
    for (size_t i = 0; i < COUNT(texts); i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        const char *text = formatted("#declare C = rgb <1, 2, 3>; %s", texts[i]);
        SCOPED(scene) *scene = read_reported(text, &reading_options, &reports);
        assert_vector(scene->primitives->pigment.color[0], 1, 2, 3);
        assert_int_equal(reports.count > 0, i + 1 < COUNT(texts));
    }
}
