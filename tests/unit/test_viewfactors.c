/* test_viewfactors.c - factors between surfaces, estimated with rays, are compared with
 * viewfactors.csv, and the forms with each other. A biased ray or a factor of another
 * surface fails here.
 *
 * HEAT_POINTS is the number of points on a primitive in each of 16 repeats. The default
 * is 64. Surfaces that are infinite in the table are long here, and the emitter is a
 * short piece in the middle.
 */
#include "base/file.h"
#include "tests/unit/csv_reading.h"
#include "tests/unit/heat_study.h"

/* The error is estimated from 16 repeats. 4.6 such errors are as rare as 4 standard
 * deviations of a normal distribution. */
#define SIGMAS 4.6

struct factor_case {
    const char *id;
    const char *from, *to; /* names of surfaces; `to` NULL is the environment */
    int which;             /* index among the values of the row */
};

struct factor_scene {
    const char *text;
    struct factor_case cases[10];
};

#define SQUARE(name, a, b, c, d) \
    "#declare " name " = mesh { triangle { " a "," b "," c " }" \
    " triangle { " a "," c "," d " } } object { " name " }\n"
#define BAY(r1, r2, gap) \
    "#declare Tube = cylinder { 0, " gap "*y, " r1 " open }\n" \
    "#declare Fin = disc { 0, y, " r2 ", " r1 " }\n" \
    "#declare Other = disc { " gap "*y, -y, " r2 ", " r1 " }\n" \
    "object { Tube } object { Fin } object { Other }\n"
/* A bore of a given length, and the wall around it. */
#define BORE(name, radius, from, to) \
    "#declare " name " = difference { cylinder { " from "*y, " to "*y, 9 }" \
    " cylinder { (" from "-1)*y, (" to "+1)*y, " radius " } }" \
    " object { " name " }\n"
#define ROW(name, pitch, height, shift) \
    "#declare " name " = cylinder { -900*z, 900*z, .5 }\n" \
    "#for (I, -200, 200) object { " name " translate <" pitch "*I+" shift ", " height \
    ", 0> } #end\n"
#define BANK \
    "#declare Plane = mesh { triangle { <-1,0,0>, <-1,0,.001>, <1,0,.001> }" \
    " triangle { <-1,0,0>, <1,0,.001>, <1,0,0> } } object { Plane }\n"

static const char radial[] =
    "#declare Tube = cylinder { -900*z, 900*z, 1 open } object { Tube }\n"
    "#declare Fin = mesh { triangle { <1,0,-900>, <2,0,-900>, <2,0,900> }"
    " triangle { <1,0,-900>, <2,0,900>, <1,0,900> } }\n"
    "#declare First = mesh { triangle { <1,0,-.001>, <2,0,.001>, "
    "<2,0,-.001> } triangle { <1,0,-.001>, <1,0,.001>, <2,0,.001> } }\n"
    "object { First }\n#for (I, 0, 7) object { Fin rotate 45*I*z } #end\n";

static const char two_tubes[] =
    "#declare Tube1 = cylinder { -1.05*x, 1.05*x, .5 }\n"
    "#declare Fins1 = cylinder { -.03*x, .03*x, .9 }\n"
    "#declare Tube2 = cylinder { -1.05*x, 1.05*x, .5 translate 2*y }\n"
    "#declare Fins2 = cylinder { -.03*x, .03*x, .9 translate 2*y }\n"
    "#declare End = cylinder { 1.05*x, 1.0501*x, .5 }\n"
    "object { Tube1 } object { Tube2 }\n"
    "#for (I, -2, 2) object { Fins1 translate .35*I*x }"
    " object { Fins2 translate .35*I*x } #end\n"
    "object { End } object { End rotate 180*z }\n"
    "object { End translate 2*y } object { End rotate 180*z translate 2*y }\n";

static const struct factor_scene scenes[] = {
    { SQUARE("A", "0", "z", "x+z", "x") SQUARE("B", "y", "x+y", "x+y+z", "y+z"),
      { { "parallel_cube", "A", "B", 0 } } },
    { SQUARE("A", "0", "z", "x+z", "x") SQUARE("B", "0", "x", "x+y", "y"),
      { { "perp_cube", "A", "B", 0 } } },
    { "#declare A = disc { 0, y, 1 } #declare B = disc { .9*y, -y, .6 }"
      " object { A } object { B }",
      { { "disks", "A", "B", 0 } } },
    { "#declare A = disc { 0, y, 1 } #declare B = disc { y, -y, 1 }"
      " object { A } object { B }",
      { { "disks_equal", "A", "B", 0 } } },
    { "#declare Sphere = sphere "
      "{ 0, .5 } #declare B = disc { .8*y, -y, 1 } object { Sphere } object { B }",
      { { "sphere_disk", "Sphere", "B", 0 } } },
    { "#declare A = sphere { 0, 1 } #declare B = sphere { 3*x, 1 }"
      " object { A } object { B }",
      { { "sphere_sphere_1_1_3", "A", "B", 0 } } },
    { "#declare Inner = sphere { 0, 1 } object { Inner }\n"
      "#declare Room = sphere { 0, 2 inverse } object { Room }",
      { { "spheres_concentric", "Room", "Inner", 0 },
        { "spheres_concentric", "Room", "Room", 1 } } },
    { "#declare Piece = cylinder { -9*y, 9*y, 1 open }\n"
      "#declare Rest = cylinder { 9*y, 900*y, 1 }\n"
      "#declare B = cylinder { -900*y, 900*y, 1 translate 2.5*x }\n"
      "object { Piece } object { Rest } object { Rest rotate 180*z } object { B }",
      { { "cylinders_equal", "Piece", "B", 0 } } },
    { "#declare Plane = mesh { triangle { 0, <0,0,.001>, <1.7,0,.001> }"
      " triangle { 0, <1.7,0,.001>, <1.7,0,0> } } object { Plane }\n" ROW("Row", "1.7",
                                                                          "3", "0"),
      { { "plane_row_1.7", "Plane", "Row", 0 } } },
    { BANK ROW("Row", "2", "1", "0") ROW("Second", "2", "1+sqrt(3)", "1"),
      { { "plane_row_2", "Plane", "Row", 0 },
        { "bank_triangle_row1", "Plane", "Row", 0 },
        { "bank_triangle_row2", "Plane", "Second", 0 } } },
    { BAY("1", "1.8", ".7"),
      { { "finned_bay_A_te", "Tube", NULL, 0 },
        { "finned_bay_A_tf", "Tube", "Fin", 0 },
        { "finned_bay_A_fe", "Fin", NULL, 0 },
        { "finned_bay_A_ft", "Fin", "Tube", 0 },
        { "finned_bay_A_ff", "Fin", "Other", 0 } } },
    { BAY(".5", ".9", ".29"),
      { { "finned_bay_B_te", "Tube", NULL, 0 },
        { "finned_bay_B_tf", "Tube", "Fin", 0 },
        { "finned_bay_B_fe", "Fin", NULL, 0 },
        { "finned_bay_B_ft", "Fin", "Tube", 0 },
        { "finned_bay_B_ff", "Fin", "Other", 0 } } },
    { radial,
      { { "longfin_1_2_8_ff", "First", "Fin", 0 },
        { "longfin_1_2_8_f_arc", "First", "Tube", 0 },
        { "longfin_1_2_8_f_o", "First", NULL, 0 },
        { "longfin_1_2_8_arc_o", "Tube", NULL, 0 } } },
    { two_tubes,
      { { "FT2_tube1_fins1", "Tube1", "Fins1", 0 },
        { "FT2_tube1_tube2", "Tube1", "Tube2", 0 },
        { "FT2_tube1_fins2", "Tube1", "Fins2", 0 },
        { "FT2_tube1_environment", "Tube1", NULL, 0 },
        { "FT2_fins1_tube1", "Fins1", "Tube1", 0 },
        { "FT2_fins1_fins1", "Fins1", "Fins1", 0 },
        { "FT2_fins1_tube2", "Fins1", "Tube2", 0 },
        { "FT2_fins1_fins2", "Fins1", "Fins2", 0 },
        { "FT2_fins1_environment", "Fins1", NULL, 0 } } },
};

/* Enclosed bores, with primitives as surfaces. The second primitive is the bore. */
static const struct factor_scene bores[] = {
    { BORE("A", "1", "0", "2"), { { "cylinder_self", "2", "2", 0 } } },
    { BORE("A", "1.8", "0", ".7") "cylinder { 0, .7*y, 1 }",
      { { "coax_oi_1.8_.7", "2", "3", 0 }, { "coax_oo_1.8_.7", "2", "2", 0 } } },
    { BORE("A", "2", "-9", "9")
          BORE("B", "2", "9", "900") "object { B rotate 180*x }\n"
                                     "cylinder { -900*y, 900*y, 1 }",
      { { "coax_inf", "2", "7", 0 } } },
};

/* ---- The table ------------------------------------------------------------------ */

static struct csv_table table;
static bool seen[CSV_ROWS];

FIXTURE(read_table)
{
    size_t length;
    FREED char *text = NON_NULL(
        file_read("tests/unit/viewfactors.csv", 1 << 20, &length, &failure));
    csv_table(text, &table);
    return set_up_model(test_state);
}

/* Returns the value, and sets *off: "0.25 and 0.75", "0.015 +- 0.001". */
static double known(const struct factor_case *which, double *off)
{
    for (size_t row = 1; row < table.rows; row++) {
        const char *text = table.cell[row][3];
        char *end;
        if (strcmp(table.cell[row][0], which->id) != 0)
            continue;
        seen[row] = true;
        double value = strtod(text, &end);
        const char *behind = strstr(end, "and");
        if (which->which > 0)
            return behind ? strtod(behind + 3, NULL) : NAN;
        behind = strstr(end, "+-");
        *off = behind ? strtod(behind + 2, NULL) : 0;
        return value;
    }
    fail_msg("no row is called %s", which->id);
    return NAN;
}

/* ---- Results --------------------------------------------------------------------- */

static size_t named(const struct surfaces *surfaces, const char *name)
{
    size_t i = 0;
    while (name && i < surfaces->count && strcmp(surfaces->list[i].name, name) != 0)
        i++;
    if (!name)
        return surfaces->count;
    assert_true(i < surfaces->count);
    return i;
}

/* Rays start at the surfaces from which a factor is known. */
static struct study begin(const struct factor_scene *what, enum surfaces_by by,
                          enum trace_mode mode, size_t points)
{
    struct study study = study_of(what->text, by);
    FREED const char **refusals = calloc(study.scene->primitive_count + 1,
                                         sizeof *refusals);
    for (size_t i = 0; i < study.scene->primitive_count; i++) {
        const struct factor_case *which = what->cases;
        while (which->id
               && named(&study.surfaces, which->from) != study.surfaces.surface_of[i])
            which++;
        refusals[i] = which->id ? NULL : "no factor";
    }
    study_find(&study, refusals, mode, points);
    return study;
}

static void check_case(const struct factor_case *which, const struct surfaces *surfaces)
{
    double off = 0, expected = known(which, &off);
    struct estimate found = surfaces->list[named(surfaces, which->from)]
                                .factor[named(surfaces, which->to)];
    FAIL_IF(!(fabs(found.value - expected)
              <= SIGMAS * (found.error + off) + 1e-5 * expected),
            "%s: %.7g +- %.2g is not %.7g", which->id, found.value, found.error,
            expected);
}

/* Another form must compute the same values as the vector form. */
static void check_form(const struct factor_scene *what, enum surfaces_by by,
                       enum trace_mode mode, size_t points)
{
    SCOPED_VALUE(study) study = begin(what, by, mode, points);
    SCOPED_VALUE(study) vector = begin(what, by, TRACE_VECTOR, points);
    for (const struct factor_case *which = what->cases; which->id; which++) {
        size_t from = named(&study.surfaces, which->from);
        const struct surface *one = &study.surfaces.list[from];
        const struct surface *other = &vector.surfaces.list[from];
        assert_memory_equal(&one->area, &other->area, sizeof one->area);
        assert_memory_equal(one->factor, other->factor,
                            (study.surfaces.count + 1) * sizeof *one->factor);
    }
}

static void check_scene(const struct factor_scene *what, enum surfaces_by by)
{
    const char *asked = getenv("HEAT_POINTS");
    size_t points = asked ? strtoul(asked, NULL, 10) : 64;
    SCOPED_VALUE(study) study = begin(what, by, TRACE_VECTOR, points);
    for (const struct factor_case *which = what->cases; which->id; which++)
        check_case(which, &study.surfaces);
    check_form(what, by, TRACE_SCALAR, 1 + points / 32);
    check_form(what, by, TRACE_KERNELS, 1 + points / 32);
}

TEST(factors)
{
    for (size_t i = 0; i < COUNT(scenes); i++)
        check_scene(&scenes[i], BY_PART);
    for (size_t i = 0; i < COUNT(bores); i++)
        check_scene(&bores[i], BY_PRIMITIVE);
    for (size_t row = 1; row < table.rows; row++)
        FAIL_IF(!seen[row], "row %s is not tried", table.cell[row][0]);
}

GROUP(read_table, tear_down_model);
