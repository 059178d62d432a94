/* test_scene_versions.c - syntax of old versions. The fields of scenes and the reports
 * are compared with expected values. A kind that is not reported once fails here. */
#include "tests/unit/scene_reading.h"

/* Texts of two primitives with this number of reports. */
TEST(reports)
{
    static const struct {
        const char *text;
        size_t reports;
    } rows[] = {
        { "#declare A = sphere { 0, 1 } A A", 1 },
        { "#declare A = sphere { 0, 1 } union { A object { A } }", 1 },
        { "#declare A = sphere { 0, 1 } difference { A sphere { x, 1 } }", 1 },
        { "#declare A = sphere { 0, 1 } #if (1) A #end object { A scale 2 }", 1 },
        { "#declare L = light_source { x, 1 } L sphere { 0, 1 } box { 0, 1 }", 1 },
        { "declare A = 1; sphere { 0, A } declare A = sphere { 0, 1 } A", 2 },
        { "#declare A = sphere { 0, 1 } declare A = box { 0, 1 } A A", 2 },
        { "include \"colors.inc\" version 3.7; sphere { 0, version } "
          "sphere { 0, 1 pigment { Red } }",
          2 },
        { "#version 3.1; global_settings { assumed_gamma 1 } "
          "declare A = 1 declare B = A sphere { 0, A } sphere { 0, B }",
          3 },
        { "#version 3.1; global_settings { assumed_gamma 1 } "
          "#declare A = 1 #declare B = A sphere { 0, A } sphere { 0, B }",
          2 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_with(rows[i].text, rows[i].reports);
        assert_int_equal(scene->primitive_count, 2);
    }
}

static void assert_ior(const char *text, size_t reports, double ior)
{
    SCOPED(scene) *scene = read_with(text, reports);
    assert_close(scene->primitives[0].ior, ior, 0);
}

/* As in POV-Ray, the index in the finish overrides the index of the interior. */
TEST(ior)
{
    assert_ior("sphere { 0, 1 finish { refraction 1 ior 1.4 } }", 2, 1.4);
    assert_ior("sphere { 0, 1 texture { finish { ior 1.4 } } }", 1, 1.4);
    assert_ior("#declare F = finish { ior 1.4 } sphere { 0, 1 finish { F } }", 1, 1.4);
    assert_ior("sphere { 0, 1 finish { ior 1.4 } interior { ior 1.2 } }", 1, 1.4);
    assert_ior("sphere { 0, 1 interior { ior 1.2 } finish { phong 1 } }", 0, 1.2);
}
