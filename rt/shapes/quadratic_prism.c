/* quadratic_prism.c - the descriptor of prisms with parabolic edges: checks their
 * arguments, computes their bounds and the words of their records, and names their
 * kernels. */
#include "rt/shapes/path.h"
#include "rt/shapes/shape.h"

#include <math.h>
#include <string.h>

#include "rt/scene/vector3.h"
#include "rt/shapes/flat_faces.h"

enum { MIN_POINTS = 5 };

static const struct shape_field fields[] = {
    { TAKES_NUMBER, SHAPE_AT(quadratic_prism, low), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(quadratic_prism, high), NULL, 0, NULL },
    { TAKES_PATH, SHAPE_AT(quadratic_prism, path), NULL, 3, NULL },
    { TAKES_WORD, SHAPE_AT(quadratic_prism, open), "open", 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* ---- The path ------------------------------------------------------------ */

/* The points of the spline in the order of the scene file. make_parabolas has already
 * converted the first `used` of the `count` points. */
struct spline_points {
    const double (*points)[2];
    size_t count, used;
    double closeness; /* tolerance for its points (path.h) */
};

static void add_point(struct outline *path, const double point[2])
{
    memcpy(path->points[path->count++], point, sizeof *path->points);
}

/* Appends the parabola from `here` to `next`. As in POV-Ray, it starts in the direction
 * from `before` to `next`. */
static void add_parabola(struct outline *path, const double before[2],
                         const double here[2], const double next[2])
{
    const double handle[2] = { here[0] + (next[0] - before[0]) / 4,
                               here[1] + (next[1] - before[1]) / 4 };
    if (equal2(before, here) && equal2(here, next))
        return;
    add_point(path, handle);
    add_point(path, next);
}

/* Appends a loop. Its first point only determines the initial direction. The loop
 * starts at the second point and ends where this point is repeated. Returns false if
 * the point is not repeated. */
static bool add_loop(struct outline *path, struct spline_points *spline)
{
    const double(*points)[2] = spline->points;
    const double *before = points[spline->used];
    const double *here = points[spline->used + 1];
    const double first[2] = { here[0], here[1] };
    add_point(path, first);
    for (size_t i = spline->used + 2; i < spline->count; i++) {
        bool closes = path_is_near(points[i], first, spline->closeness);
        const double *next = closes ? first : points[i];
        add_parabola(path, before, here, next);
        before = here;
        here = next;
        if (closes) {
            spline->used = i + 1;
            return true;
        }
    }
    return false;
}

/* Replaces the spline by its parabolas. The array has space for twice as many points,
 * and the parabolas with their handles need less. The spline is first copied to the
 * upper half of the array. */
static const char *make_parabolas(struct outline *path)
{
    struct spline_points spline = { (const double(*)[2])path->points + path->count,
                                    path->count, 0, 0 };
    if (path->count < MIN_POINTS)
        return "a quadratic spline must have at least five points";
    memcpy(path->points + path->count, path->points,
           path->count * sizeof *path->points);
    path->count = 0;
    spline.closeness = path_closeness(spline.points, spline.count);
    while (spline.used + 1 < spline.count)
        if (!add_loop(path, &spline))
            return "the quadratic spline does not return to its second point";
    return NULL;
}

static const char *finish(struct primitive *primitive)
{
    double a = primitive->shape.quadratic_prism.low;
    double b = primitive->shape.quadratic_prism.high;
    primitive->shape.quadratic_prism.low = fmin(a, b);
    primitive->shape.quadratic_prism.high = fmax(a, b);
    return a == b && primitive->shape.quadratic_prism.open
               ? shape_empty(primitive, "the prism has no height")
               : make_parabolas(&primitive->shape.quadratic_prism.path);
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    path_bound(primitive, &primitive->shape.quadratic_prism.path,
               primitive->shape.quadratic_prism.low,
               primitive->shape.quadratic_prism.high, bound);
}

static size_t segments(const struct primitive *primitive)
{
    return (path_crossings(&primitive->shape.quadratic_prism.path, 2) + 1) / 2;
}

/* ---- One parabola -------------------------------------------------------- */

/* A parabola. Its point at parameter w, 0 <= w <= 1, is from + (bend w + 2 lead) w. */
struct parabola {
    const double *from, *to;
    double bend[2], lead[2];
    bool begins; /* it is the first parabola of a loop */
};

static bool next_parabola(struct path_walk *walk, struct parabola *parabola)
{
    const double *handle;
    if (!path_next(walk))
        return false;
    parabola->begins = walk->begins;
    parabola->from = walk->from;
    handle = walk->to;
    path_next(walk);
    parabola->to = walk->to;
    for (int k = 0; k < 2; k++) {
        parabola->bend[k] = parabola->from[k] - 2 * handle[k] + parabola->to[k];
        parabola->lead[k] = handle[k] - parabola->from[k];
    }
    return true;
}

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

static double along(const struct parabola *parabola, int k, double w)
{
    return (parabola->bend[k] * w + 2 * parabola->lead[k]) * w;
}

/* Returns true if the parabola's point at parameter w is ahead of `point` in the
 * direction. */
static bool is_ahead(const struct parabola *parabola, double w, const double point[2],
                     const double direction[2])
{
    const double way[2] = { parabola->from[0] + along(parabola, 0, w) - point[0],
                            parabola->from[1] + along(parabola, 1, w) - point[1] };
    return dot(direction, way) > 0;
}

/* Returns how often the ray from a point crosses the parabola. As in quadratic_prism.s,
 * the number depends on the sides of the ray on which the two ends of the parabola are.
 * If `own` is true, the point is on this parabola at its middle, and the crossing at
 * the point is not counted. */
static size_t crossings_ahead(const struct parabola *parabola, bool own,
                              const double point[2], const double direction[2])
{
    const double from[2] = { parabola->from[0] - point[0],
                             parabola->from[1] - point[1] };
    const double to[2] = { parabola->to[0] - point[0], parabola->to[1] - point[1] };
    double a = cross(direction, parabola->bend);
    double b = cross(direction, parabola->lead), c = cross(direction, from);
    double square = b * b - a * c, root = sqrt(fmax(0, square));
    double q = b < 0 ? root - b : -root - b;
    bool left = cross(direction, to) >= 0;
    if (left != (c >= 0))
        return !own
               && is_ahead(parabola, left == (b >= 0) ? c / q : q / a, point,
                           direction);
    if (square <= 0 || (b < 0) == (a + b < 0) || left != (b < 0))
        return 0;
    if (own)
        return is_ahead(parabola, 2 * c / a, point, direction);
    return (size_t)is_ahead(parabola, q / a, point, direction)
           + (size_t)is_ahead(parabola, c / q, point, direction);
}

static bool is_inside(const struct outline *path, size_t number, const double point[2],
                      const double direction[2])
{
    struct path_walk walk = { .path = path, .apart = 2 };
    struct parabola parabola;
    size_t count = 0;
    for (size_t i = 0; next_parabola(&walk, &parabola); i++)
        count += crossings_ahead(&parabola, i == number, point, direction);
    return count % 2 != 0;
}

/* ---- Words and table ----------------------------------------------------- */

enum { ROW = 16 };

/* The offsets of the words in a row of the prism's table
 * (rt/kernels/frame/records.s). */
enum quadratic_word {
    POINT,
    BEGINS = POINT + 2,
    BEND,
    LEAD = BEND + 2,
    FOOT = LEAD + 2,
    BOW = FOOT + 2,
    WAY = BOW + 2,
    SHARE = WAY + 2,
    OUTWARD = SHARE + 2
};

/* A normal is computed as for a straight edge if the curvature relative to the length
 * is below this value. */
#define STRAIGHT 1e-8

/* Writes the words for the normal of a parabola that is nearly a straight line. The
 * parabola may turn back, so its part of the line may extend beyond the two end
 * points. */
static void put_straight(const struct parabola *parabola, double *row)
{
    const double *lead = parabola->lead, *bend = parabola->bend;
    const double *way = dot(lead, lead) > dot(bend, bend) ? lead : bend;
    double length = sqrt(dot(way, way));
    const double unit[2] = { way[0] / length, way[1] / length };
    double turn = -dot(unit, lead) / dot(unit, bend);
    double end = dot(unit, bend) + 2 * dot(unit, lead);
    double low = fmin(0, end), high = fmax(0, end);
    if (turn > 0 && turn < 1) {
        low = fmin(low, dot(unit, lead) * turn);
        high = fmax(high, dot(unit, lead) * turn);
    }
    for (int k = 0; k < 2; k++) {
        row[FOOT + k] = parabola->from[k] + low * unit[k];
        row[WAY + k] = (high - low) * unit[k];
        row[SHARE + k] = unit[k] / (high - low);
    }
}

static void put_bent(const struct parabola *parabola, double *row)
{
    const double *bend = parabola->bend;
    double across = 2 * cross(bend, parabola->lead);
    for (int k = 0; k < 2; k++) {
        row[FOOT + k] = parabola->from[k];
        row[BOW + k] = bend[k];
        row[WAY + k] = 2 * parabola->lead[k];
    }
    row[SHARE] = -bend[1] / across;
    row[SHARE + 1] = bend[0] / across;
}

static bool is_straight(const struct parabola *parabola)
{
    double least = STRAIGHT
                   * fmax(dot(parabola->bend, parabola->bend),
                          dot(parabola->lead, parabola->lead));
    return fabs(cross(parabola->bend, parabola->lead)) <= least;
}

static void put_parabola(const struct outline *path, size_t number,
                         const struct parabola *parabola, double *row)
{
    double middle[2], normal[2];
    memcpy(row + POINT, parabola->to, sizeof middle);
    memcpy(row + BEND, parabola->bend, sizeof middle);
    memcpy(row + LEAD, parabola->lead, sizeof middle);
    if (is_straight(parabola))
        put_straight(parabola, row);
    else
        put_bent(parabola, row);
    for (int k = 0; k < 2; k++)
        middle[k] = parabola->from[k] + along(parabola, k, .5);
    normal[0] = row[BOW + 1] + row[WAY + 1];
    normal[1] = -row[BOW] - row[WAY];
    row[OUTWARD] = is_inside(path, number, middle, normal) ? -1 : 1;
}

static void put_rows(const struct outline *path, double *table)
{
    struct path_walk walk = { .path = path, .apart = 2 };
    struct parabola parabola;
    for (size_t i = 0; next_parabola(&walk, &parabola); i++) {
        if (parabola.begins) {
            memcpy(table + POINT, parabola.from, 2 * sizeof *table);
            table[BEGINS] = 1;
            table += ROW;
        }
        put_parabola(path, i, &parabola, table);
        table += ROW;
    }
}

/* Returns the number of rows of a table. A loop of n parabolas has 2n + 1 points and n
 * + 1 rows. */
static size_t count_rows(const struct outline *path)
{
    struct path_walk walk = { .path = path, .apart = 2 };
    struct parabola parabola;
    size_t count = 0;
    while (next_parabola(&walk, &parabola))
        count += 1 + (size_t)parabola.begins;
    return count;
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    words[0] = primitive->shape.quadratic_prism.low;
    words[1] = primitive->shape.quadratic_prism.high;
    words[2] = (double)count_rows(&primitive->shape.quadratic_prism.path);
    return 3;
}

static size_t put_table(const struct primitive *primitive,
                        const struct viewpoints *viewpoints, double *table)
{
    const struct outline *path = &primitive->shape.quadratic_prism.path;
    (void)viewpoints;
    if (table)
        put_rows(path, table);
    return ROW * count_rows(path);
}

static bool is_open(const struct primitive *primitive)
{
    return primitive->shape.quadratic_prism.open;
}

/* A prism without height has no inside, so it cannot be traced as a solid. */
static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    double low = primitive->shape.quadratic_prism.low;
    double high = primitive->shape.quadratic_prism.high;
    if (low < high && !primitive->shape.quadratic_prism.open)
        faces_add_caps(search, &primitive->shape.quadratic_prism.path, low, high);
    return low < high;
}

const struct shape shape_quadratic_prism = {
    .fields = fields,
    .finish = finish,
    .bound = put_bound,
    .words = put_words,
    .table = put_table,
    .segments = segments,
    .flat_faces = put_faces,
    .region = "quadratic_prism",
    .symbol = "QUADRATIC_PRISMS",
    .kernels = { .kernel = "quadratic_prism",
                 .normal = "normal_quadratic_prism",
                 .segments = 1,
                 .solid = "quadratic_prism_solid" },
    .is_other = is_open,
    .other = { .kernel = "open_quadratic_prism",
               .normal = "normal_open_quadratic_prism",
               .segments = 1,
               .solid = "open_quadratic_prism_sides",
               .state = "quadratic_prism_solid" },
};
