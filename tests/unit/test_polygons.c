/* test_polygons.c - the triangles of a polygon are compared with the even-odd rule,
 * point by point, over random stars and grids. A point inside that no triangle covers,
 * or that several triangles cover, fails here.
 *
 *     test_polygons [POLYGONS [SEED]]
 */
#include "tests/oracle/plain_shapes.h"
#include "tests/unit/draw.h"
#include "tests/unit/scene_reading.h"

enum { MAX_POINTS = 64, SAMPLES = 200, LINES = 4000 };

static size_t polygon_count = 400;
/* ---- The oracle ---------------------------------------------------------- */

/* An outline in a plane with an origin and two axes. ends[i] is true where a loop ends,
 * at a copy of its first point. */
struct flat_outline {
    double origin[3], axes[2][3];
    size_t count;
    double points[MAX_POINTS][2];
    bool ends[MAX_POINTS];
};

/* Returns a positive value if p is left of the line from a to b. */
static double side(const double a[2], const double b[2], const double p[2])
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

static double distance(const double a[2], const double b[2], const double p[2])
{
    double way[2] = { b[0] - a[0], b[1] - a[1] };
    double square = way[0] * way[0] + way[1] * way[1], part = 0;
    if (square > 0)
        part = (way[0] * (p[0] - a[0]) + way[1] * (p[1] - a[1])) / square;
    part = fmax(0, fmin(1, part));
    return hypot(p[0] - a[0] - part * way[0], p[1] - a[1] - part * way[1]);
}

/* Returns true if the outline has an odd number of crossings right of the point. */
static bool is_inside(const struct flat_outline *outline, const double p[2])
{
    bool inside = false;
    for (size_t i = 0; i + 1 < outline->count; i++) {
        const double *a = outline->points[i], *b = outline->points[i + 1];
        bool above[2] = { a[1] > p[1], b[1] > p[1] };
        if (!outline->ends[i] && above[0] != above[1])
            inside ^= (side(a, b, p) > 0) == above[1];
    }
    return inside;
}

static bool is_near_edge(const struct flat_outline *outline, const double p[2],
                         double near)
{
    for (size_t i = 0; i + 1 < outline->count; i++)
        if (!outline->ends[i]
            && distance(outline->points[i], outline->points[i + 1], p) < near)
            return true;
    return false;
}

/* Computes the area with lines parallel to the second axis. */
static double area_by_lines(const struct flat_outline *outline)
{
    double sum = 0;
    for (int line = 0; line < LINES; line++) {
        double x = -4 + 8 * (line + .5) / LINES, crossings[MAX_POINTS];
        size_t count = 0;
        for (size_t i = 0; i + 1 < outline->count; i++) {
            const double *a = outline->points[i];
            const double *b = outline->points[i + 1];
            if (!outline->ends[i] && (a[0] > x) != (b[0] > x))
                crossings[count++] = a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
        }
        for (size_t i = 0; i < count; i++) {
            size_t before = 0;
            for (size_t k = 0; k < count; k++)
                before += crossings[k] < crossings[i]
                          || (crossings[k] == crossings[i] && k < i);
            sum += before % 2 ? crossings[i] : -crossings[i];
        }
    }
    return sum * 8 / LINES;
}

/* ---- Random cases ----------------------------------------------------------- */

static void add_point(struct flat_outline *outline, double x, double y)
{
    double *point = outline->points[outline->count++];
    point[0] = x;
    point[1] = y;
}

static void close_part(struct flat_outline *outline, size_t first)
{
    const double *point = outline->points[first];
    add_point(outline, point[0], point[1]);
    outline->ends[outline->count - 1] = true;
}

/* Adds a star around a point. Only with a step of 1 it is simple. */
static void add_star(struct flat_outline *outline, size_t count, size_t step)
{
    double x = between(-1, 1), y = between(-1, 1), turn = between(0, 6);
    size_t first = outline->count;
    for (size_t i = 0; i < count; i++) {
        double angle = turn + 2 * acos(-1) * (double)(i * step) / (double)count;
        double radius = between(.5, 2);
        add_point(outline, x + radius * cos(angle), y + radius * sin(angle));
    }
    close_part(outline, first);
}

/* Adds a loop of grid points, which are on edges and each other. Edges overlap. */
static void add_grid_part(struct flat_outline *outline, size_t count)
{
    size_t first = outline->count;
    for (size_t i = 0; i < count; i++) {
        double x, y;
        do {
            x = (double)xorshift_between(&random_state, -3, 3);
            y = (double)xorshift_between(&random_state, -3, 3);
        } while (i > 0 && x == outline->points[first][0]
                 && y == outline->points[first][1]);
        add_point(outline, x, y);
    }
    close_part(outline, first);
}

static void random_plane(struct flat_outline *outline)
{
    double turns[3];
    for (int i = 0; i < 3; i++)
        turns[i] = between(-3, 3);
    double a = turns[0], b = turns[1], c = turns[2];
    double axes[2][3] = {
        { cos(a) * cos(b), sin(a) * cos(b), -sin(b) },
        { cos(a) * sin(b) * sin(c) - sin(a) * cos(c),
          sin(a) * sin(b) * sin(c) + cos(a) * cos(c), cos(b) * sin(c) },
    };
    memcpy(outline->axes, axes, sizeof axes);
    for (int i = 0; i < 3; i++)
        outline->origin[i] = between(-2, 2);
}

static struct flat_outline random_outline(void)
{
    struct flat_outline outline = { .count = 0 };
    int parts = (int)xorshift_between(&random_state, 1, 3);
    bool grid = xorshift(&random_state) & 1;
    if (xorshift(&random_state) & 1) {
        random_plane(&outline);
    } else { /* one of the three coordinate planes */
        int first = (int)xorshift_between(&random_state, 0, 2);
        outline.axes[0][first] = 1;
        outline.axes[1][(first + 1) % 3] = -1;
        outline.origin[(first + 2) % 3] = 1;
    }
    for (int i = 0; i < parts; i++) {
        size_t count = (size_t)xorshift_between(&random_state, 3, 11);
        size_t step = (size_t)xorshift_between(&random_state, 1, 3);
        if (grid)
            add_grid_part(&outline, count);
        else
            add_star(&outline, count, count > 4 && count % step ? step : 1);
    }
    return outline;
}

static void put_in_space(const struct flat_outline *outline, const double p[2],
                         double point[3])
{
    add_scaled(point, outline->origin, p[0], outline->axes[0]);
    add_scaled(point, point, p[1], outline->axes[1]);
}

static void write_outline(const struct flat_outline *outline, char *text)
{
    text += sprintf(text, "polygon { %zu", outline->count);
    for (size_t i = 0; i < outline->count; i++) {
        double p[3];
        put_in_space(outline, outline->points[i], p);
        text += sprintf(text, ",\n<%.17g, %.17g, %.17g>", p[0], p[1], p[2]);
    }
    sprintf(text, " }\n");
}

/* ---- Comparison ---------------------------------------------------------- */

/* Returns a triangle as an outline in the same plane. */
static struct flat_outline put_in_plane(const struct flat_outline *outline,
                                        const struct triangle *triangle)
{
    struct flat_outline flat = { .count = 0 };
    assert_false(triangle->smooth);
    for (int k = 0; k < 3; k++) {
        double away[3], p[2], back[3];
        add_scaled(away, triangle->corners[k], -1, outline->origin);
        for (int axis = 0; axis < 2; axis++)
            p[axis] = dot(outline->axes[axis], away);
        add_point(&flat, p[0], p[1]);
        put_in_space(outline, p, back);
        for (int i = 0; i < 3; i++)
            assert_close(triangle->corners[k][i], back[i], 1e-9);
    }
    close_part(&flat, 0);
    return flat;
}

static void check_samples(const struct flat_outline *outline,
                          const struct flat_outline *flat, size_t count,
                          const char *text)
{
    for (int i = 0; i < SAMPLES; i++) {
        double p[2] = { between(-3.2, 3.2), between(-3.2, 3.2) };
        bool near = is_near_edge(outline, p, 1e-9);
        size_t times = 0;
        for (size_t k = 0; k < count; k++) {
            near = near || is_near_edge(&flat[k], p, 1e-9);
            times += is_inside(&flat[k], p);
        }
        FAIL_IF(!near && times != is_inside(outline, p),
                "%zu triangles at %g, %g of\n%s", times, p[0], p[1], text);
    }
}

static void check_outline(const struct flat_outline *outline)
{
    static char text[MAX_POINTS * 100];
    FREED struct flat_outline *flat;
    double area = 0;
    write_outline(outline, text);
    SCOPED(scene) *scene = read_scene(text);
    const struct triangles *triangles = triangles_of(scene);
    flat = NON_NULL(malloc(triangles->count * sizeof *flat));
    for (size_t i = 0; i < triangles->count; i++) {
        flat[i] = put_in_plane(outline, &triangles->list[i]);
        area += fabs(side(flat[i].points[0], flat[i].points[1], flat[i].points[2])) / 2;
        for (int k = 0; k < 3; k++)
            assert_true(is_near_edge(outline, flat[i].points[k], 1e-9));
    }
    check_samples(outline, flat, triangles->count, text);
    FAIL_IF(!(fabs(area - area_by_lines(outline)) < .01),
            "an area of %g, not %g, of\n%s", area, area_by_lines(outline), text);
}

TEST(random_polygons)
{
    size_t checked = 0;
    while (checked < polygon_count) {
        struct flat_outline outline = random_outline();
        if (area_by_lines(&outline) < .1)
            continue;
        check_outline(&outline);
        checked++;
    }
}

/* ---- Words and errors ---------------------------------------------------- */

static double total_area(const struct triangles *triangles)
{
    double sum = 0;
    for (size_t i = 0; i < triangles->count; i++) {
        double(*c)[3] = triangles->list[i].corners;
        double n[3];
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3, m = (k + 2) % 3;
            n[k] = (c[1][l] - c[0][l]) * (c[2][m] - c[0][m])
                   - (c[1][m] - c[0][m]) * (c[2][l] - c[0][l]);
        }
        sum += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
    }
    return sum;
}

static void check_area(const char *text, size_t reports, double area, size_t count)
{
    SCOPED(scene) *scene = read_with(text, reports);
    assert_close(total_area(triangles_of(scene)), area, CLOSE);
    assert_int_equal(triangles_of(scene)->count, count);
}

TEST(areas)
{
    double fifth = 2 * acos(-1) / 5;
    check_area("polygon { 4, 0, x, y, 0 }", 0, .5, 1);
    check_area("polygon { 4.9 <0, 0> <2, 0> <0, 3> <0, 0> }", 0, 3, 1);
    check_area("polygon { 5, <0, 0>, <2, 0>, <2, 3>, <0, 3>, <0, 0> }", 0, 6, 2);
    check_area("polygon { 5, 0, 2*y, 2*y + 3*z, 3*z, 0 inverse }", 0, 6, 2);
    /* A hole, and a loop inside the hole. */
    check_area("polygon { 15, 0, 8*x, <8, 8>, 8*y, 0, <1, 1>, <1, 7>, <7, 7>,"
               "<7, 1>, <1, 1>, <2, 2>, <4, 2>, <4, 4>, <2, 4>, <2, 2> }",
               0, 64 - 36 + 4, 10);
    /* Two equal loops cancel each other. Another loop is next to them. */
    check_area("polygon { 12, 0, x, y, 0, 0, x, y, 0, 2*x, 3*x, <3, 1>, 2*x }", 0, .5,
               1);
    /* Outlines that intersect themselves. */
    check_area("polygon { 5, <0, 0>, <2, 2>, <2, 0>, <0, 2>, <0, 0> }", 0, 2, 4);
    check_area("polygon { 6, #for (I, 0, 5) "
               "<sin(4*pi*mod(I, 5)/5), cos(4*pi*mod(I, 5)/5)> #end }",
               0,
               5 * cos(fifth) / cos(fifth / 2) * sin(fifth / 2)
                   - 2.5 * sin(fifth) * pow(cos(fifth) / cos(fifth / 2), 2),
               7);
    /* Because of a rounding error, the last point differs from the first. */
    check_area("polygon { 4, 0, x, y, <0, 5e-11> }", 0, .5, 1);
}

TEST(corners_are_given_points)
{
    SCOPED(scene) *scene = read_scene(
        "polygon { 5, <.1, .2, .7>, <.7, .3, 0>, <.6, .9, -.5>,"
        "<.3, .5, .2>, <.1, .2, .7> }");
    const struct triangle *list = triangles_of(scene)->list;
    static double given[4][3] = {
        { .1, .2, .7 }, { .7, .3, 0 }, { .6, .9, -.5 }, { .3, .5, .2 }
    };
    for (int i = 0; i < 4; i++) {
        bool found = false;
        for (size_t k = 0; k < 3 * triangles_of(scene)->count; k++)
            found = found
                    || memcmp(list[k / 3].corners[k % 3], given[i], sizeof given[i])
                           == 0;
        assert_true(found);
    }
}

/* POV-Ray closes an open polygon, and does not show a degenerate polygon. */
TEST(reports)
{
    static const char *const left_out[] = {
        "polygon { 3, 0, x, 2*x }",
        "polygon { 3, x, x, x }",
        "polygon { 4, <0, 0>, <1, 0>, <.5, 1e-6>, <0, 0> }",
        "polygon { 5, 0, x, <1, 1, 2e-9>, y, 0 }",
        "polygon { 5, 0, x, y, <1, 1, 1>, 0 }",
        "polygon { 8, 0, x, y, 0, 0, x, y, 0 }",
    };
    check_area("polygon { 3, 0, x, y }", 1, .5, 1);
    check_area("polygon { 4, 0, 1e-9*x, 1e-9*y, 0 scale 1e9 }", 0, 5e-19, 1);
    check_area("polygon { 7, 0, x, y, 0, 2*x, 3*x, <2, 1> }", 1, 1, 2);
    check_area("polygon { 5, 0, x, <1, 1, 5e-11>, y, 0 }", 0, 1, 2);
    for (size_t i = 0; i < COUNT(left_out); i++) {
        SCOPED(scene) *scene = read_with(left_out[i], 1);
        assert_int_equal(scene->primitive_count, 0);
        assert_error(left_out[i], &strict_options, 1, 1, "the shape is ignored");
    }
    assert_error("polygon { 3, 0, x, y }", &strict_options, 1, 1,
                 "the polygon is not closed");
}

TEST(errors)
{
    static const struct line_error rows[] = {
        { "polygon { 2, 0, x }", 11, "must have at least three points" },
        { "polygon { -1 }", 11, "must have at least three points" },
        { "polygon { 1e9, 0, x, y }", 11, "more than 100000 points" },
        { "polygon { 5, 0, x, <1, 1>, y pigment { rgb 1 } }", 30, "expected a number" },
        { "polygon { 4, 0, x, y, 0, 0 }", 24, "found ','" },
        { "polygon { 5, 0, x, y, 0, <1, 1> }", 1,
          "a single point after a closed part" },
        { "sphere { 0, 1 clipped_by { polygon { 4, 0, x, y, 0 } } }", 28,
          "a mesh has no inside and cannot clip" },
    };
    assert_errors(rows, COUNT(rows));
    /* all its edges cross each other */
    assert_refused("polygon { 3000, #for (I, 0, 2999) "
                   "<I/3000 + sin(7*I), mod(I, 2)*3 + cos(I)> #end }",
                   2, "takes too long");
}

COUNT_AND_SEED(polygon_count, random_state);
