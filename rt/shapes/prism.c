/* prism.c - the descriptor of prisms with straight edges: checks their arguments,
 * computes their bounds and the words of their records, and names their kernels. */
#include "rt/scene/elementary.h"
#include "rt/shapes/flat_faces.h"
#include "rt/shapes/path.h"
#include "rt/shapes/shape.h"

#include <math.h>
#include <string.h>

static const struct shape_field fields[] = {
    { TAKES_USUAL, 0, "linear_sweep", 0, NULL },
    { TAKES_OTHER, 0, "conic_sweep", 0, NULL },
    { TAKES_USUAL, 0, "linear_spline", 0, NULL },
    { TAKES_WORD, SHAPE_AT(prism, quadratic), "quadratic_spline", 0, NULL },
    { TAKES_OTHER, 0, "cubic_spline", 0, NULL },
    { TAKES_OTHER, 0, "bezier_spline", 0, NULL },
    { TAKES_USUAL, 0, "linear_sweep", 0, NULL },
    { TAKES_OTHER, 0, "conic_sweep", 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(prism, low), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(prism, high), NULL, 0, NULL },
    { TAKES_PATH, SHAPE_AT(prism, path), NULL, 3, NULL },
    { TAKES_WORD, SHAPE_AT(prism, open), "open", 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* ---- The path ------------------------------------------------------------ */

/* Copies the loop that begins at `first`, without points that repeat their predecessor,
 * and ends it with a copy of its first point. The loop is appended at *kept. A loop of
 * fewer than three edges has no area and is dropped. Returns the index after the
 * loop. */
static size_t close_loop(struct outline *path, size_t first, double closeness,
                         size_t *kept)
{
    double(*points)[2] = path->points, start[2];
    size_t begin = *kept, next = first;

    memcpy(start, points[first], sizeof start);
    do {
        if (*kept == begin || !path_is_near(points[next], points[*kept - 1], closeness))
            memcpy(points[(*kept)++], points[next], sizeof *points);
        next++;
    } while (next < path->count && !path_is_near(points[next], start, closeness));
    memcpy(points[(*kept)++], start, sizeof start);
    if (*kept - begin < 4)
        *kept = begin;
    return next + 1;
}

static const char *become_quadratic(struct primitive *primitive)
{
    struct primitive prism = *primitive;
    primitive->kind = PRIMITIVE_QUADRATIC_PRISM;
    primitive->shape.quadratic_prism.low = prism.shape.prism.low;
    primitive->shape.quadratic_prism.high = prism.shape.prism.high;
    primitive->shape.quadratic_prism.path = prism.shape.prism.path;
    primitive->shape.quadratic_prism.open = prism.shape.prism.open;
    return shape_quadratic_prism.finish(primitive);
}

static const char *finish(struct primitive *primitive)
{
    struct outline *path = &primitive->shape.prism.path;
    double a = primitive->shape.prism.low, b = primitive->shape.prism.high;
    double closeness = path_closeness((const double(*)[2])path->points, path->count);
    size_t kept = 0;
    if (primitive->shape.prism.quadratic)
        return become_quadratic(primitive);
    primitive->shape.prism.low = fmin(a, b);
    primitive->shape.prism.high = fmax(a, b);
    for (size_t next = 0; next < path->count;)
        next = close_loop(path, next, closeness, &kept);
    path->count = kept;
    if (a == b && primitive->shape.prism.open)
        return shape_empty(primitive, "the prism has no height");
    return kept > 0 ? NULL
                    : shape_empty(primitive, "the path of the prism encloses nothing");
}

/* ---- Bound --------------------------------------------------------------- */

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    const struct outline *path = &primitive->shape.prism.path;
    path_bound(primitive, path, primitive->shape.prism.low, primitive->shape.prism.high,
               bound);
}

static size_t segments(const struct primitive *primitive)
{
    return (path_crossings(&primitive->shape.prism.path, 1) + 1) / 2;
}

/* ---- Words and table ----------------------------------------------------- */

/* Returns true if a point near an edge, in the given direction, is inside the path: a
 * ray from the middle of the edge crosses an odd number of the other edges. */
static bool is_inside(const struct outline *path, size_t edge, const double point[2],
                      const double direction[2])
{
    struct path_walk walk = { .path = path, .apart = 1 };
    bool inside = false;
    for (size_t i = 0; path_next(&walk); i++) {
        double x0 = walk.from[0] - point[0], z0 = walk.from[1] - point[1];
        double x1 = walk.to[0] - point[0], z1 = walk.to[1] - point[1];
        double side0 = direction[0] * z0 - direction[1] * x0;
        double side1 = direction[0] * z1 - direction[1] * x1;
        double way0 = direction[0] * x0 + direction[1] * z0;
        double way1 = direction[0] * x1 + direction[1] * z1;
        if (i != edge && (side0 >= 0) != (side1 >= 0)
            && way0 + (way1 - way0) * (side0 / (side0 - side1)) > 0)
            inside = !inside;
    }
    return inside;
}

enum { ROW = 8 };

/* Writes a row. The first row of a loop has x, z and a 1. Every other row has x, z and
 * the edge from the previous point: its direction, length and outward normal. */
static void put_edge(const struct path_walk *edge, size_t number, double *row)
{
    double x = edge->from[0] - edge->to[0], z = edge->from[1] - edge->to[1];
    double length = elementary_hypot(x, z), normal[2] = { z / length, -x / length };
    const double middle[2] = { edge->to[0] + x / 2, edge->to[1] + z / 2 };
    if (is_inside(edge->path, number, middle, normal)) {
        normal[0] = -normal[0];
        normal[1] = -normal[1];
    }
    row[0] = edge->to[0];
    row[1] = edge->to[1];
    row[3] = x / length;
    row[4] = z / length;
    row[5] = length;
    row[6] = normal[0];
    row[7] = normal[1];
}

static void put_rows(const struct outline *path, double *table)
{
    struct path_walk walk = { .path = path, .apart = 1 };
    for (size_t edge = 0; path_next(&walk); edge++) {
        if (walk.begins) {
            table[0] = walk.from[0];
            table[1] = walk.from[1];
            table[2] = 1;
            table += ROW;
        }
        put_edge(&walk, edge, table);
        table += ROW;
    }
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    words[0] = primitive->shape.prism.low;
    words[1] = primitive->shape.prism.high;
    words[2] = (double)primitive->shape.prism.path.count;
    return 3;
}

static size_t put_table(const struct primitive *primitive,
                        const struct viewpoints *viewpoints, double *table)
{
    const struct outline *path = &primitive->shape.prism.path;
    (void)viewpoints;
    if (table)
        put_rows(path, table);
    return ROW * path->count;
}

static bool is_open(const struct primitive *primitive)
{
    return primitive->shape.prism.open;
}

static void add_sides(const struct primitive *primitive, struct face_search *search)
{
    double ends[2] = { primitive->shape.prism.low, primitive->shape.prism.high };
    struct path_walk walk = { .path = &primitive->shape.prism.path, .apart = 1 };
    while (path_next(&walk)) {
        double normal[3] = { walk.from[1] - walk.to[1], 0, walk.to[0] - walk.from[0] };
        struct hull hull = { .count = 0 };
        double point[3];
        for (int i = 0; i < 4; i++) {
            const double *at = i & 1 ? walk.from : walk.to;
            point[0] = at[0];
            point[1] = ends[i >> 1];
            point[2] = at[1];
            hull_point(&hull, primitive, point);
        }
        faces_add_hull(search, normal, point, false, &hull);
    }
}

/* A prism without height has no inside, so it cannot be traced as a solid. */
static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    double low = primitive->shape.prism.low, high = primitive->shape.prism.high;
    if (low >= high)
        return false;
    if (!primitive->shape.prism.open)
        faces_add_caps(search, &primitive->shape.prism.path, low, high);
    add_sides(primitive, search);
    return true;
}

const struct shape shape_prism = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .table = put_table,
    .segments = segments,
    .flat_faces = put_faces,
    .region = "prism",
    .kernels = { .kernel = "prism",
                 .normal = "normal_prism",
                 .segments = 1,
                 .solid = "prism_solid" },
    .is_other = is_open,
    .other = { .kernel = "open_prism",
               .normal = "normal_open_prism",
               .segments = 1,
               .solid = "open_prism_sides",
               .state = "prism_solid" },
};
