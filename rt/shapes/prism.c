#include "rt/shapes/shape.h"

#include <math.h>
#include <string.h>

/* Points so near to a loop's first close it, as in POV-Ray. */
#define CLOSED 1e-10

static const struct shape_field fields[] = {
    { TAKES_USUAL, 0, "linear_spline", 0, NULL },
    { TAKES_USUAL, 0, "linear_sweep", 0, NULL },
    { TAKES_USUAL, 0, "linear_spline", 0, NULL },
    { TAKES_OTHER, 0, "conic_sweep", 0, NULL },
    { TAKES_OTHER, 0, "quadratic_spline", 0, NULL },
    { TAKES_OTHER, 0, "cubic_spline", 0, NULL },
    { TAKES_OTHER, 0, "bezier_spline", 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(prism, low), NULL, 0, NULL },
    { TAKES_NUMBER, SHAPE_AT(prism, high), NULL, 0, NULL },
    { TAKES_PATH, SHAPE_AT(prism, path), NULL, 3, NULL },
    { TAKES_WORD, SHAPE_AT(prism, open), "open", 0, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* ---- The path ------------------------------------------------------------ */

static bool is_at(const double a[2], const double b[2])
{
    return a[0] == b[0] && a[1] == b[1];
}

static bool is_near(const double a[2], const double b[2])
{
    return fabs(a[0] - b[0]) < CLOSED && fabs(a[1] - b[1]) < CLOSED;
}

/* Edge by edge, the loops one after another: begin with { .path = .. }. */
struct walk {
    const struct outline *path;
    size_t at, first; /* the point that is next, the first of its loop */
    bool begins;      /* the edge is the first of its loop */
    const double *from, *to;
};

static bool next_edge(struct walk *walk)
{
    const double(*points)[2] = (const double(*)[2])walk->path->points;

    walk->begins = walk->at == walk->first;
    if (walk->at + 1 >= walk->path->count)
        return false;
    walk->from = points[walk->at++];
    walk->to = points[walk->at];
    if (is_at(walk->to, points[walk->first]))
        walk->first = ++walk->at;
    return true;
}

/* Behind the loop that begins at first: points without the ones that repeat
 * the one before, the last of them the first again.  As many as are left stand
 * from kept on; a loop of less than three edges encloses nothing and goes. */
static size_t close_loop(struct outline *path, size_t first, size_t *kept)
{
    double(*points)[2] = path->points, start[2];
    size_t begin = *kept, next = first;

    memcpy(start, points[first], sizeof start);
    do {
        if (*kept == begin || !is_near(points[next], points[*kept - 1]))
            memcpy(points[(*kept)++], points[next], sizeof *points);
        next++;
    } while (next < path->count && !is_near(points[next], start));
    memcpy(points[(*kept)++], start, sizeof start);
    if (*kept - begin < 4)
        *kept = begin;
    return next + 1;
}

static const char *settle(struct primitive *primitive)
{
    struct outline *path = &primitive->shape.prism.path;
    double a = primitive->shape.prism.low, b = primitive->shape.prism.high;
    size_t kept = 0;

    primitive->shape.prism.low = fmin(a, b);
    primitive->shape.prism.high = fmax(a, b);
    for (size_t next = 0; next < path->count;)
        next = close_loop(path, next, &kept);
    path->count = kept;
    return a == b      ? "the prism has no height"
           : kept == 0 ? "the path of the prism encloses nothing"
                       : NULL;
}

/* ---- Its bound ----------------------------------------------------------- */

/* A circle about the path, at both ends. */
static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    const struct outline *path = &primitive->shape.prism.path;
    double low[2] = { INFINITY, INFINITY },
           high[2] = { -INFINITY, -INFINITY };
    double base[3], cap[3], radius = 0;
    struct hull hull = { .count = 0 };

    for (size_t i = 0; i < path->count; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], path->points[i][k]);
            high[k] = fmax(high[k], path->points[i][k]);
        }
    for (int k = 0; k < 2; k++)
        base[2 * k] = cap[2 * k] = (low[k] + high[k]) / 2;
    base[1] = primitive->shape.prism.low;
    cap[1] = primitive->shape.prism.high;
    for (size_t i = 0; i < path->count; i++)
        radius = fmax(radius, hypot(path->points[i][0] - base[0],
                                    path->points[i][1] - base[2]));
    hull_rings(&hull, primitive, base, radius, cap, radius);
    bound_hull(&hull, bound);
}

/* ---- How often a ray crosses it ------------------------------------------ */

/* On which side of a direction an edge goes; 0: along it, or nearly. */
static int side_of(const struct walk *edge, const double direction[2])
{
    double x = edge->to[0] - edge->from[0], z = edge->to[1] - edge->from[1];
    double across = direction[0] * z - direction[1] * x;

    return fabs(across)
                   <= 1e-9 * hypot(x, z) * hypot(direction[0], direction[1])
               ? 0
           : across > 0 ? 1
                        : -1;
}

/* How often edges, one after another, may change sides: those along the
 * direction go to either. */
struct changes {
    int first, last;        /* the side of the first edge that has one, and of
                                 the last */
    size_t before, between; /* edges along it before the first, since the
                                 last */
    size_t count;
};

/* Between two sides with so many edges along it. */
static size_t changes_between(int a, int b, size_t along)
{
    return along + 1 - ((along + 1) % 2 != (size_t)(a != b));
}

static void add_edge(struct changes *changes, int side)
{
    if (side == 0) {
        changes->between++;
        return;
    }
    if (changes->last == 0) {
        changes->first = side;
        changes->before = changes->between;
    } else {
        changes->count += changes_between(changes->last, side,
                                          changes->between);
    }
    changes->last = side;
    changes->between = 0;
}

/* Round the loop, from the last edge to the first. */
static size_t close_changes(const struct changes *changes)
{
    if (changes->last == 0)
        return changes->between;
    return changes->count
           + changes_between(changes->last, changes->first,
                             changes->between + changes->before);
}

/* A line crosses each run of edges on one side of its direction once at most.
 */
static size_t crossings_along(const struct outline *path,
                              const double direction[2])
{
    struct walk walk = { .path = path };
    struct changes changes = { 0, 0, 0, 0, 0 };
    size_t count = 0;

    while (next_edge(&walk)) {
        if (walk.begins) {
            count += close_changes(&changes);
            changes = (struct changes){ 0, 0, 0, 0, 0 };
        }
        add_edge(&changes, side_of(&walk, direction));
    }
    return count + close_changes(&changes);
}

/* The number of runs changes only where a line turns past an edge. */
static size_t segments(const struct primitive *primitive)
{
    const struct outline *path = &primitive->shape.prism.path;
    struct walk walk = { .path = path };
    size_t most = 2;

    while (next_edge(&walk)) {
        const double direction[2] = { walk.to[0] - walk.from[0],
                                      walk.to[1] - walk.from[1] };
        size_t count = crossings_along(path, direction);

        most = count > most ? count : most;
    }
    return (most + 1) / 2;
}

/* ---- Its words ----------------------------------------------------------- */

/* Does what the ray crosses from a point of an edge on, that edge left out,
 * come to an odd number? */
static bool is_inside(const struct outline *path, size_t edge,
                      const double point[2], const double direction[2])
{
    struct walk walk = { .path = path };
    bool inside = false;

    for (size_t i = 0; next_edge(&walk); i++) {
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

/* x, z; 1 where a loop begins, and then no more.  Of the edge back to the point
 * before: its direction, length, outward normal. */
static void put_edge(const struct walk *edge, size_t number, double *row)
{
    double x = edge->from[0] - edge->to[0], z = edge->from[1] - edge->to[1];
    double length = hypot(x, z), normal[2] = { z / length, -x / length };
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
    struct walk walk = { .path = path };

    for (size_t edge = 0; next_edge(&walk); edge++) {
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

static size_t put_table(const struct primitive *primitive, double *table)
{
    const struct outline *path = &primitive->shape.prism.path;

    if (table)
        put_rows(path, table);
    return ROW * path->count;
}

static bool is_open(const struct primitive *primitive)
{
    return primitive->shape.prism.open;
}

const struct shape shape_prism = {
    .fields = fields,
    .settle = settle,
    .povray = "prism",
    .bound = put_bound,
    .words = put_words,
    .table = put_table,
    .segments = segments,
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
