/* test_scene_csg.c - the scene language. The trees, materials and interiors of solids
 * are compared with expected values. A wrong operation, complement or body fails here.
 *
 * The texts are deeply nested, so the test is slow with the leak sanitizer.
 */
#include "tests/unit/scene_reading.h"

/* ---- Trees -------------------------------------------------------------- */

/* Writes a region as text: `&(a, b)`, `|(a, b)` or `!a`. A leaf is its index. */
static size_t write_tree(const struct scene *scene, size_t i, FILE *out)
{
    static const char signs[] = { ' ', '&', '|', '!' };
    const struct tree_node *node = &scene->nodes[i];
    if (node->operation == TREE_LEAF) {
        fprintf(out, "%zu", node->primitive);
        return i + 1;
    }
    fprintf(out, "%c(", signs[node->operation]);
    for (i++; i < node->next;) {
        i = write_tree(scene, i, out);
        fputs(i < node->next ? "," : ")", out);
    }
    return i;
}

static void check_regions(const char *text, size_t reports, const char *expected)
{
    SCOPED(scene) *scene = read_with(text, reports);
    size_t leaf = 0, node = 0, length;
    FREED char *found = NULL;
    FILE *out = open_memstream(&found, &length);
    for (size_t i = 0; i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        assert_int_equal(region->first_primitive, leaf);
        assert_int_equal(region->first_node, node);
        node = write_tree(scene, node, out);
        fputc(' ', out);
        assert_int_equal(region->first_node + region->node_count, node);
        leaf += region->primitive_count;
    }
    for (size_t i = 0; i < scene->primitive_count; i++)
        fputc(scene->primitives[i].inverted ? '-' : '+', out);
    fclose(out);
    assert_int_equal(leaf, scene->primitive_count);
    assert_int_equal(node, scene->node_count);
    FAIL_IF(strcmp(found, expected) != 0, "%s: %s, expected %s", text, found, expected);
}

#define A "sphere { 0, 1 }"
#define B "box { 0, 1 }"
#define C "plane { y, 0 }"
#define D "torus { 1, .2 }"
#define E "triangle { 0, x, y }"

TEST(trees)
{
    static const char *const rows[][2] = {
        { "", "" },
        { A B, "0 1 ++" },
        { "union { " A B " }", "0 1 ++" },
        { "intersection { " A B " }", "&(0,1) ++" },
        { "merge { " A B C " }", "|(0,1,2) +++" },
        { "difference { " A B C " }", "&(0,!(1),!(2)) +--" },
        { "sphere { 0, 1 inverse }", "!(0) -" },
        { "sphere { 0, 1 inverse inverse }", "0 +" },
        { "union { " A B " inverse }", "!(|(0,1)) --" },
        { "union { union { " A B " inverse } " C " inverse }",
          "!(|(!(|(0,1)),2)) ++-" },
        { "union { merge { " A B " } " C D " }", "|(0,1) 2 3 ++++" },
        { "intersection { union { " A B " } " C " }", "&(|(0,1),2) +++" },
        { "merge { union { " A B " } " C " }", "|(|(0,1),2) +++" },
        { "difference { " A " union { " B C " } }", "&(0,!(|(1,2))) +--" },
        { "difference { " A " difference { " B C " } " D " }",
          "&(0,!(&(1,!(2))),!(3)) +-+-" },
        { "difference { " A " box { 0, 1 inverse } }", "&(0,1) ++" },
        { "intersection { light_source { 0, 1 } " A " }", "0 +" },
        { "#declare U = union { " A B " }\n"
          "object { U } object { U inverse } merge { object { U } " C " }",
          "0 1 !(|(2,3)) |(|(4,5),6) ++--+++" },
        { "#declare H = difference { " A B " scale 2 }\n"
          "intersection { object { H inverse translate x } " C " }",
          "&(!(&(0,!(1))),2) -++" },
        { "object { difference { " A B " } inverse }", "!(&(0,!(1))) -+" },
        { "sphere { 0, 1 clipped_by { " C " } }", "&(0,1) ++" },
        { "sphere { 0, 1 clipped_by { " B C " } clipped_by { " D " } }",
          "&(&(0,1,2),3) ++++" },
        { "union { " A B " clipped_by { " C " } }", "&(0,1) &(2,3) ++++" },
        { "merge { " A B " clipped_by { union { " C D " } } }",
          "&(|(0,1),|(2,3)) ++++" },
        { "sphere { 0, 1 clipped_by { " C " } inverse }", "&(!(0),1) -+" },
        { "sphere { 0, 1 inverse clipped_by { " C " } inverse }", "&(0,1) ++" },
        { "difference { " A " sphere { 0, 1 clipped_by { difference { " B C " } } } }",
          "&(0,&(!(1),&(2,!(3)))) +-+-" },
        { "intersection { " A " merge { sphere { 0, 1 clipped_by { " C " } } " B
          " inverse } }",
          "&(0,&(&(!(1),2),!(3))) +-+-" },
        { "intersection { " A B " clipped_by { " C " } inverse }",
          "&(|(!(0),!(1)),2) --+" },
        { "#declare H = sphere { 0, 1 clipped_by { " C " } }\n"
          "object { H } difference { " A " object { H } }",
          "&(0,1) &(2,&(!(3),4)) +++-+" },
        { "sphere { 0, 1 clipped_by { " C D " scale 2 } }", "&(0,1,2) +++" },
        { "sphere { 0, 1 bounded_by { " B " } }", "0 +" },
        { "plane { y, 0 bounded_by { " B " } }", "0 +" },
        { "intersection { " A B " bounded_by { box { -2, 2 } } }", "&(0,1) ++" },
        { "intersection { " A C " bounded_by { sphere { 0, 2 } } }", "&(0,1) ++" },
        { "intersection { quadric { <1, 0, 1>, 0, 0, -1 } " A
          " bounded_by { sphere { 0, 1.001 } } }",
          "&(0,1) ++" },
        { "intersection { box { <-2, 0, -.1>, <2, 5, 1.1> } "
          "merge { box { -9*y, 1 } box { <-1, -1, 0>, <0, 9, 1> } } "
          "bounded_by { box { <-2, 0, 0>, <2, 5, 1> } } }",
          "&(0,|(1,2)) +++" },
        { "merge { sphere { 0, 1 } sphere { x, 1 } bounded_by { sphere { "
          ".25*x, .76 } scale 2 rotate 0 } }",
          "|(0,1) ++" },
        { "union { " A B " bounded_by { box { -.9, 2 } scale 1.2 } }", "0 1 ++" },
        { "union { " A B " bounded_by { clipped_by } }", "0 1 ++" },
        /* As in POV-Ray, surfaces are not inverted, even within an inverted solid. */
        { "difference { " B " mesh { " E " inside_vector z } }", "&(0,!(1)) +-" },
        { "union { " B E A " inverse }", "&(!(0),1,!(2)) -+-" },
        { "object { union { " B E " inverse } inverse }", "|(0,1) ++" },
    };
    static const char *const reported[][2] = {
        { "intersection { " A " }", "0 +" },
        { "intersection { }", "" },
        { "difference { " A " }", "0 +" },
        { "intersection { " A " union { light_source { 0, 1 } } }", "0 +" },
        { "quadric { <1, 0, 1>, 0, 0, -1 bounded_by { " B " } }", "0 +" },
        { "union { " A B " bounded_by { box { -.9, 2 } } }", "0 1 ++" },
        { "merge { sphere { 0, 1 } sphere { x, 1 } bounded_by { sphere { "
          ".25*x, .7 } scale 2 } }",
          "|(0,1) ++" },
        { "difference { " B " mesh { " E " } }", "&(0,1) ++" },
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        check_regions(rows[i][0], 0, rows[i][1]);
    for (size_t i = 0; i < COUNT(reported); i++)
        check_regions(reported[i][0], 1, reported[i][1]);
}

/* A clipping shape is invisible, without shadow or material. Transforms move it. */
TEST(clips)
{
    SCOPED(scene) *scene = read_scene(
        "#default { pigment { rgbf 1 } }\n"
        "sphere { 0, 1 translate y clipped_by { " C " } translate 2*y "
        "pigment { rgbf <1, 0, 0, .5> } interior { ior 1.5 } }");
    const struct primitive *p = scene->primitives;
    assert_true(!p[0].invisible && !p[0].no_shadow);
    assert_true(p[1].invisible && p[1].no_shadow);
    assert_close(p[0].to_world.rows[1][3], 3, CLOSE);
    assert_close(p[1].to_world.rows[1][3], 2, CLOSE);
    assert_true(pigment_is_clear(&p[0].pigment));
    assert_false(pigment_is_clear(&p[1].pigment));
    assert_close(p[1].ior, 1, CLOSE);
}

/* A transform of the solid moves all parts. */
TEST(transforms)
{
    SCOPED(scene) *scene = read_scene("#declare H = difference { " A
                                      " box { 0, 1 translate x } scale 2 }\n"
                                      "object { H translate <0, 3, 0> no_shadow }");
    const struct primitive *p = scene->primitives;
    assert_close(p[0].to_world.rows[0][0], 2, CLOSE);
    assert_close(p[0].to_world.rows[1][3], 3, CLOSE);
    assert_close(p[1].to_world.rows[0][3], 2, CLOSE);
    assert_close(p[1].to_local.rows[0][3], -1, CLOSE);
    assert_true(p[0].no_shadow && p[1].no_shadow);
}

/* no_shadow applies to a solid as a unit, and to each part of a union separately. An
 * object hides all parts without such a keyword. On a part of a solid the keywords have
 * no effect. For each primitive the letters s, i and r mean no_shadow, no_image and
 * no_reflection; `-` means none. */
TEST(hidden)
{
    static const char *const rows[][2] = {
        { "union { sphere { 0, 1 no_shadow } " B " }", "s -" },
        { "union { " A B " no_shadow }", "s s" },
        { "merge { sphere { 0, 1 no_shadow } " B " }", "- -" },
        { "merge { sphere { 0, 1 no_shadow } " B " no_shadow }", "s s" },
        { "intersection { sphere { 0, 1 no_shadow } sphere { x, 1 no_shadow } }",
          "- -" },
        { "difference { union { sphere { 0, 1 no_shadow } " B " } " C " }", "- - -" },
        { "union { difference { " A C " no_shadow } " B " }", "s s -" },
        { "union { merge { " A B " } " C " no_shadow }", "s s s" },
        { "union { " A B " no_image }", "i i" },
        { "union { sphere { 0, 1 no_reflection } " B " no_image }", "ir i" },
        { "union { sphere { 0, 1 no_image } " B " no_image off }", "i -" },
        { "#declare U = union { " A B " no_image no_reflection }"
          " object { U no_image off }",
          "r r" },
        { "#declare U = union { sphere { 0, 1 no_image } " B " }"
          " union { object { U no_image 0 } " C " no_reflection -1 }",
          "i - -" },
        { "object { merge { " A B " no_image } no_reflection .5 }", "ir ir" },
        { "intersection { sphere { 0, 1 no_image } box { 0, 1 no_image } }", "- -" },
        { "intersection { sphere { 0, 1 no_image no_reflection } " B " no_image }",
          "i i" },
        { "sphere { 0, 1 clipped_by { " C " } no_image }", "i sir" },
        { "light_source { 0, 1 looks_like {"
          " union { sphere { 0, 1 no_image } " B " no_reflection } } }",
          "s s" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_scene(rows[i][0]);
        char found[40] = "", *to = found;
        for (size_t k = 0; k < scene->primitive_count; k++) {
            const struct primitive *p = &scene->primitives[k];
            bool none = !p->no_shadow && !p->hidden_from;
            to += sprintf(to, "%s%s%s%s%s", k > 0 ? " " : "", none ? "-" : "",
                          p->no_shadow ? "s" : "", p->hidden_from & 1 ? "i" : "",
                          p->hidden_from & 2 ? "r" : "");
        }
        FAIL_IF(strcmp(found, rows[i][1]) != 0, "%s: %s, expected %s", rows[i][0],
                found, rows[i][1]);
    }
}

/* ---- Inheritance -------------------------------------------------------- */

TEST(textures)
{
    SCOPED(scene) *scene = read_scene(
        "difference {\n"
        "    sphere { 0, 1 pigment { rgb <1, 0, 0> } }\n"
        "    union { " B C " pigment { rgb <0, 1, 0> } }\n"
        "    intersection { " A D " }\n"
        "    pigment { rgb <0, 0, 1> } finish { reflection .3 }\n"
        "}");
    const struct primitive *p = scene->primitives;
    assert_vector(p[0].pigment.color[0], 1, 0, 0);
    assert_vector(p[1].pigment.color[0], 0, 1, 0);
    assert_vector(p[2].pigment.color[0], 0, 1, 0);
    assert_vector(p[3].pigment.color[0], 0, 0, 1);
    assert_vector(p[4].finish.reflection, .3, .3, .3);
    assert_vector(p[1].finish.reflection, 0, 0, 0);
}

TEST(interiors)
{
    SCOPED(scene) *scene = read_scene(
        "#declare L = intersection {\n"
        "    sphere { 0, 1 interior { ior 1.2 } }\n" B "    interior { ior 1.5 }\n"
        "}\n"
        "object { L } object { L interior { ior 2 } }\n"
        "union { " A " sphere { 0, 1 interior { } }\n"
        "    material { texture { pigment { rgbf 1 } } interior { ior 3 } } }" A);
    static const double expected[] = { 1.2, 1.5, 1.2, 2, 3, 1, 1 };
    assert_int_equal(scene->primitive_count, COUNT(expected));
    for (size_t i = 0; i < COUNT(expected); i++)
        assert_close(scene->primitives[i].ior, expected[i], 0);
}

/* Compares the primitives' bodies: letters from `a`, and `.` for invisible ones. */
static void check_bodies(const char *text, const char *expected)
{
    SCOPED(scene) *scene = read_scene(text);
    const struct primitive *p = scene->primitives;
    size_t bodies[10];
    int count = 0;
    char found[30] = "";
    for (size_t i = 0; i < scene->primitive_count; i++) {
        int k = 0;
        assert_true(p[i].invisible || p[i].interior > 0);
        while (k < count && bodies[k] != p[i].interior)
            k++;
        if (!p[i].invisible && k == count)
            bodies[count++] = p[i].interior;
        found[i] = p[i].invisible ? '.' : (char)('a' + k);
    }
    FAIL_IF(strcmp(found, expected) != 0, "%s: %s, expected %s", text, found, expected);
}

#define FILLED "sphere { 0, 1 interior { ior 1.5 } } "

/* Each object is a body. Each use of an interior is another one, also in copies. */
TEST(bodies)
{
    static const char *const rows[][2] = {
        { A B, "ab" },
        { "union { " A B " } union { " A B " }", "aabb" },
        { "difference { " A B " } merge { " C D " }", "aabb" },
        { FILLED FILLED, "ab" },
        { "union { " A B " interior { ior 1.5 } }", "aa" },
        { "union { " A B " material { interior { } } }", "aa" },
        { "union { " FILLED B C " }", "abb" },
        { "union { " FILLED B C " interior { ior 1.5 } }", "abb" },
        { "union { union { " A B " interior { } } " C D " interior { } }", "aabb" },
        { "union { " A " union { " FILLED B " } }", "aba" },
        { "sphere { 0, 1 clipped_by { " C " } }", "a." },
        { "#declare I = interior { ior 1.5 } sphere { 0, 1 interior { I } } "
          "union { " A " sphere { 0, 1 interior { I } } interior { I } }",
          "abc" },
        { "#declare M = material { interior { ior 1.5 } } "
          "sphere { 0, 1 material { M } } sphere { 0, 1 material { M } }",
          "ab" },
        { "#declare S = " A " object { S } object { S }", "ab" },
        { "#declare S = " FILLED "object { S } object { S }", "ab" },
        { "#declare S = " FILLED "object { S } object { S interior { } }", "ab" },
        { "#declare S = " A " union { object { S } object { S } }", "aa" },
        { "#declare S = " FILLED "union { object { S } object { S } " A
          " interior { } }",
          "abc" },
        { "#declare U = union { " A B " interior { } } object { U } object { U }",
          "aabb" },
        { "#declare U = union { " FILLED A B " interior { } } "
          "object { U } union { object { U } " C " object { U } }",
          "abbcddefgg" },
        { "#for (I, 1, 2) union { " A FILLED "} #end", "abcd" },
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        check_bodies(rows[i][0], rows[i][1]);
}

/* The result of one statement of the scene is one object, whatever its parts are. */
TEST(objects)
{
    static const size_t expected[] = { 0, 1, 1, 1, 2, 2, 3, 4 };
    SCOPED(scene) *scene = read_scene(
        A "union { " B " union { " C D " } } difference { " A B " }"
          "#declare S = " A " object { S } object { S translate x }");
    assert_int_equal(scene->primitive_count, COUNT(expected));
    assert_int_equal(scene->object_count, 5);
    for (size_t i = 0; i < COUNT(expected); i++)
        assert_int_equal(scene->primitives[i].object, expected[i]);
}

/* Materials are used by name. Further words may follow the name. */
TEST(materials)
{
    SCOPED(scene) *scene = read_scene(
        "#declare I = interior { ior 1.25 }\n"
        "#declare J = interior { I }\n"
        "#declare M = material { interior { J }\n"
        "    texture { pigment { rgb <1, 0, 0> } } translate x }\n"
        "#declare N = material { M interior { ior 1.5 } }\n"
        "sphere { 0, 1 interior { J } }\n"
        "sphere { 0, 1 material { M } }\n"
        "sphere { 0, 1 material { N translate y } translate z }\n"
        "sphere { 0, 1 pigment { rgb <0, 1, 0> }\n"
        "    material { interior { J ior 1.75 } } }\n"
        "union { " A " sphere { 0, 1 interior { } } material { N } }");
    static const double iors[] = { 1.25, 1.25, 1.5, 1.75, 1.5, 1 };
    const struct primitive *p = scene->primitives;
    for (size_t i = 0; i < COUNT(iors); i++)
        assert_close(p[i].ior, iors[i], 0);
    assert_vector(p[0].pigment.color[0], 0, 0, 0);
    assert_vector(p[1].pigment.color[0], 1, 0, 0);
    assert_vector(p[3].pigment.color[0], 0, 1, 0);
    assert_vector(p[4].pigment.color[0], 1, 0, 0);
    for (int i = 0; i < 3; i++)
        assert_close(p[2].pigment.to_local.rows[i][3], -1, CLOSE);
}

/* ---- Surfaces ----------------------------------------------------------- */

TEST(clear_pigments)
{
    static const struct {
        const char *text;
        double filter[2], transmit[2];
    } rows[] = {
        { "rgb 1", { 0, 0 }, { 0, 0 } },
        { "rgbf <1, .5, .2, .7>", { .7, 0 }, { 0, 0 } },
        { "rgbt <1, .5, .2, .7>", { 0, 0 }, { .7, 0 } },
        { "color rgbft <1, .5, .2, .6, .3>", { .6, 0 }, { .3, 0 } },
        { "rgb <1, 1, 1> filter .2 transmit .4", { .2, 0 }, { .4, 0 } },
        { "Glass", { .9, 0 }, { .1, 0 } },
        { "rgbf .5 rgb 1", { 0, 0 }, { 0, 0 } },
        { "checker rgbf 1, rgbt <0, 0, 0, .5>", { 1, 0 }, { 0, .5 } },
        { "checker pigment { Glass } color Glass", { .9, .9 }, { .1, .1 } },
        { "rgbf 1 checker", { 0, 0 }, { 0, 0 } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_format("#declare Glass = rgbft <1, 1, 1, .9, .1>;\n"
                                           "sphere { 0, 1 pigment { %s } }",
                                           rows[i].text);
        const struct pigment *pigment = &scene->primitives->pigment;
        assert_numbers(rows[i].text, pigment->filter, rows[i].filter, 2, 0);
        assert_numbers(rows[i].text, pigment->transmit, rows[i].transmit, 2, 0);
    }
}

/* As measured in POV-Ray, a second reflection keeps values that it does not set. */
TEST(reflections)
{
    static const struct {
        const char *text;
        /* The least and the largest reflection, falloff, metallic and fresnel. */
        double numbers[9];
    } rows[] = {
        { "", { 0, 0, 0, 0, 0, 0, 1, 0, false } },
        { "reflection .25", { .25, .25, .25, .25, .25, .25, 1, 0, false } },
        { "reflection rgb <.1, .2, .3>", { .1, .2, .3, .1, .2, .3, 1, 0, false } },
        { "reflection { <.1, .2, .3> }", { .1, .2, .3, .1, .2, .3, 1, 0, false } },
        { "reflection { color rgb .5 } phong 1",
          { .5, .5, .5, .5, .5, .5, 1, 0, false } },
        { "reflection { .1, rgb <.2, .3, .4> falloff 3 metallic }",
          { .1, .1, .1, .2, .3, .4, 3, 1, false } },
        { "reflection { .1 .2 fresnel metallic .5 }",
          { .1, .1, .1, .2, .2, .2, 1, .5, true } },
        { "reflection { .5 fresnel on }", { 0, 0, 0, .5, .5, .5, 1, 0, true } },
        { "reflection { .5 fresnel off }", { .5, .5, .5, .5, .5, .5, 1, 0, false } },
        { "reflection { 0, 1 fresnel off } reflection { .5, 1 }",
          { .5, .5, .5, 1, 1, 1, 1, 0, false } },
        { "reflection { 0, 1 fresnel falloff 2 metallic } reflection { .5 }",
          { .5, .5, .5, .5, .5, .5, 2, 1, true } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_format("sphere { 0, 1 finish { %s } }",
                                           rows[i].text);
        const struct finish *finish = &scene->primitives->finish;
        const double rest[] = { finish->reflection_falloff, finish->reflection_metallic,
                                finish->fresnel };
        assert_numbers(rows[i].text, finish->reflection, rows[i].numbers, 3, CLOSE);
        assert_numbers(rows[i].text, finish->reflection_most, rows[i].numbers + 3, 3,
                       CLOSE);
        assert_numbers(rows[i].text, rest, rows[i].numbers + 6, 3, 0);
    }
}

/* ---- Depth -------------------------------------------------------------- */

enum { DEEP = 10000 };

TEST(deep_text)
{
    FREED char *open = repeated("", "difference { " A " ", DEEP);
    FREED char *middle = repeated(open, B, 1);
    FREED char *text = repeated(middle, " }", DEEP);
    assert_refused(text, 3, "levels of nesting");
}

/* A union and a scene have the same limit. A single solid has a lower limit. */
TEST(large_solids)
{
    char text[2000] = "#declare U = union { " A " " A " }";
    for (int i = 1; i < 14; i++)
        strcat(text, "#declare U = union { object { U } object { U } }\n");
    scene_free(read_scene(text));
    char *end = text + strlen(text);
    strcpy(end, "object { U inverse }");
    assert_refused(text, 1, "more than 10000 primitives in one solid");
    strcpy(end, "merge { object { U } " A " }");
    assert_refused(text, 1, "more than 10000 primitives in one solid");
}

/* Solids are named through many levels. Each copy of a primitive is counted. */
TEST(deep_names)
{
    FREED char *solids = repeated("#declare H = " A " ",
                                  "#declare H = difference { object { H } " A " } ",
                                  DEEP);
    FREED char *inverses = repeated("#declare H = " A " ",
                                    "#declare H = object { H inverse } ", DEEP + 1);
    FREED char *text = repeated(inverses, "object { H }", 1);
    assert_refused(solids, 201, "including copies");
    check_regions(text, 0, "!(0) -");
}
