/* lathe.c - the descriptor of lathes: checks their arguments, computes their bounds and
 * the words of their records, and names their kernels. */
#include "rt/scene/elementary.h"
#include "rt/shapes/flat_faces.h"
#include "rt/shapes/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points that are closer than this count as equal. */
#define CLOSED 1e-10

static const struct shape_field fields[] = {
    { TAKES_USUAL, 0, "linear_spline", 0, NULL },
    { TAKES_OTHER, 0, "quadratic_spline", 0, NULL },
    { TAKES_OTHER, 0, "cubic_spline", 0, NULL },
    { TAKES_OTHER, 0, "bezier_spline", 0, NULL },
    { TAKES_PATH, SHAPE_AT(lathe, path), NULL, 2, NULL },
    { TAKES_END, 0, NULL, 0, NULL },
};

/* ---- The path ------------------------------------------------------------ */

static bool is_near(const double a[2], const double b[2])
{
    return fabs(a[0] - b[0]) < CLOSED && fabs(a[1] - b[1]) < CLOSED;
}

/* Removes points that repeat their predecessor. A last point near the first point
 * becomes equal to it. */
static void drop_repeated(struct outline *path)
{
    double(*points)[2] = path->points;
    size_t kept = 1;

    for (size_t i = 1; i < path->count; i++)
        if (!is_near(points[i], points[kept - 1]))
            memcpy(points[kept++], points[i], sizeof *points);
    path->count = kept;
    if (kept > 2 && is_near(points[0], points[kept - 1]))
        memcpy(points[kept - 1], points[0], sizeof *points);
}

static const char *finish(struct primitive *primitive)
{
    struct outline *path = &primitive->shape.lathe.path;
    double greatest = 0;
    for (size_t i = 0; i < path->count; i++) {
        if (path->points[i][0] < 0)
            return shape_empty(primitive, "a radius of the lathe is below 0");
        greatest = fmax(greatest, path->points[i][0]);
    }
    drop_repeated(path);
    return path->count < 2 || greatest == 0
               ? shape_empty(primitive, "the lathe has no surface")
               : NULL;
}

/* An open path is closed as in POV-Ray, by up to three segments: a level segment to the
 * least radius, a vertical segment to the height of the first point, and a level
 * segment to the first point. A point that is closer to the axis than the path is
 * therefore outside. */
enum { CLOSING = 3 };

struct closed {
    const struct outline *path;
    double closing[CLOSING][2];
    size_t count; /* number of points of the path and of the closing segments */
};

/* The closing segments are moved by this fraction of the radius. Otherwise a segment of
 * the path could coincide with a closing segment. It would then not be a face of the
 * solid, and it would be invisible in other solids. */
#define ASIDE 1e-4

static const double *point_of(const struct closed *closed, size_t i)
{
    size_t seen = closed->path->count;
    return i < seen ? closed->path->points[i] : closed->closing[i - seen];
}

static void add_closing(struct closed *closed, double radius, double height)
{
    const double *last = point_of(closed, closed->count - 1);
    double *next = closed->closing[closed->count - closed->path->count];
    if (radius == last[0] && height == last[1])
        return;
    next[0] = radius;
    next[1] = height;
    closed->count++;
}

/* Returns the radius of the vertical segment that closes an open path: the least radius
 * of the path. It is reduced a little (ASIDE) if the path has a vertical segment
 * there. */
static double closing_radius(const struct outline *path)
{
    double least = INFINITY;
    bool stands = false;
    for (size_t i = 0; i < path->count; i++)
        least = fmin(least, path->points[i][0]);
    for (size_t i = 1; i < path->count; i++)
        stands |= path->points[i - 1][0] == least && path->points[i][0] == least;
    return stands ? least * (1 - ASIDE) : least;
}

/* Returns the height of the level segment that closes an open path at this end. It is
 * moved a little (ASIDE) if the path is level at this end, too. */
static double closing_height(const double *end, const double *neighbour)
{
    return end[1] == neighbour[1] && neighbour[0] < end[0] ? end[1] + ASIDE * end[0]
                                                           : end[1];
}

static struct closed close_path(const struct primitive *primitive)
{
    const struct outline *path = &primitive->shape.lathe.path;
    const double(*points)[2] = (const double(*)[2])path->points;
    const double *first = points[0], *last = points[path->count - 1];
    struct closed closed = { .path = path, .count = path->count };
    double radius = closing_radius(path);
    if ((first[0] == 0 && last[0] == 0) || (first[0] == last[0] && first[1] == last[1]))
        return closed;
    add_closing(&closed, radius, closing_height(last, points[path->count - 2]));
    add_closing(&closed, radius, closing_height(first, points[1]));
    add_closing(&closed, first[0], first[1]);
    return closed;
}

static bool is_open(const struct primitive *primitive)
{
    return close_path(primitive).count > primitive->shape.lathe.path.count;
}

/* ---- Bound --------------------------------------------------------------- */

struct cylinder_about {
    double low, high, radius;
};

static struct cylinder_about cylinder_of(const struct primitive *primitive)
{
    const struct outline *path = &primitive->shape.lathe.path;
    struct cylinder_about about = { INFINITY, -INFINITY, 0 };
    for (size_t i = 0; i < path->count; i++) {
        about.low = fmin(about.low, path->points[i][1]);
        about.high = fmax(about.high, path->points[i][1]);
        about.radius = fmax(about.radius, path->points[i][0]);
    }
    return about;
}

static void hull_at(struct hull *hull, const struct primitive *primitive, double radius,
                    double height)
{
    static const double axis[3] = { 0, 1, 0 };
    const double center[3] = { 0, height, 0 };
    hull_ring(hull, primitive, center, axis, radius);
}

/* Bounds a cylinder with the greatest radius, from the least to the greatest height. */
static void bound_cylinder(const struct primitive *primitive, struct bound *bound)
{
    struct cylinder_about about = cylinder_of(primitive);
    struct hull hull = { .count = 0 };
    hull_at(&hull, primitive, about.radius, about.low);
    hull_at(&hull, primitive, about.radius, about.high);
    bound_hull(&hull, bound);
}

/* Bounds a lathe by the circles that the points of its path describe. */
static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    const struct outline *path = &primitive->shape.lathe.path;
    struct bound *points = malloc(path->count * RING * sizeof *points);
    if (!points) {
        bound_cylinder(primitive, bound);
        return;
    }
    for (size_t i = 0; i < path->count; i++) {
        struct hull hull = { .count = 0 };
        hull_at(&hull, primitive, path->points[i][0], path->points[i][1]);
        memcpy(&points[i * RING], hull.points, RING * sizeof *points);
    }
    bound_enclose(points, path->count * RING, bound);
    free(points);
}

/* ---- Crossings of a ray -------------------------------------------------- */

/* A run of segments that is convex away from the axis. Each segment turns towards the
 * axis relative to its predecessor. All segments rise, or all fall. */
struct bulge {
    double along[2]; /* direction of the last segment */
    int sense;       /* 1: rising, -1: falling, 0: all segments so far are level */
    bool begun;
};

static int sense_of(const double along[2])
{
    return (along[1] > 0) - (along[1] < 0);
}

static bool bulges_on(const struct bulge *bulge, const double along[2])
{
    double turn = bulge->along[0] * along[1] - bulge->along[1] * along[0];
    int sense = bulge->sense ? bulge->sense : sense_of(along);
    if (sense_of(along) == -sense && sense != 0)
        return false;
    if (bulge->along[1] == 0 && along[1] == 0)
        return bulge->along[0] * along[0] > 0;
    return turn * sense >= 0;
}

/* Returns the largest number of segments of a ray inside the lathe. In coordinates of
 * radius and height, a ray is a hyperbola, and the area on its side away from the axis
 * is convex. The ray therefore crosses each run of segments (struct bulge) at most
 * twice, and a level run at most once. */
static size_t segments(const struct primitive *primitive)
{
    struct closed closed = close_path(primitive);
    struct bulge bulge = { .begun = false };
    size_t crossings = 0;
    for (size_t i = 1; i < closed.count; i++) {
        const double *from = point_of(&closed, i - 1);
        const double *to = point_of(&closed, i);
        const double along[2] = { to[0] - from[0], to[1] - from[1] };
        bool goes_on = bulge.begun && bulges_on(&bulge, along);
        if (!goes_on) {
            bulge.sense = 0;
            crossings++;
        }
        if (bulge.sense == 0 && sense_of(along) != 0) {
            bulge.sense = sense_of(along);
            crossings++;
        }
        memcpy(bulge.along, along, sizeof along);
        bulge.begun = true;
    }
    return (crossings + 1) / 2;
}

/* ---- Words and table ----------------------------------------------------- */

/* Returns true if a point of a segment is inside the closed path. It is inside if a ray
 * from it, along the radius or the axis, crosses an odd number of the other
 * segments. */
static bool is_inside(const struct closed *closed, size_t segment,
                      const double point[2], int across)
{
    int along = 1 - across;
    bool inside = false;
    for (size_t i = 1; i < closed->count; i++) {
        const double *from = point_of(closed, i - 1);
        const double *to = point_of(closed, i);
        double share = (point[across] - from[across]) / (to[across] - from[across]);
        if (i != segment
            && (from[across] > point[across]) != (to[across] > point[across])
            && from[along] + (to[along] - from[along]) * share > point[along])
            inside = !inside;
    }
    return inside;
}

enum { ROW = 16 };

/* The offsets of the words in a row of the lathe's table
 * (rt/kernels/frame/records.s). */
enum lathe_word {
    SQUARE,
    HEIGHT,
    BEGINS,
    LOW,
    HIGH,
    RISES,
    LINE_Y,
    LINE_K,
    LINE_R2,
    LINE_R,
    RADIUS,
    DIRECTION,
    LENGTH = DIRECTION + 2,
    NORMAL
};

static void put_corner(const double *point, double middle, double *row)
{
    row[SQUARE] = point[0] * point[0];
    row[HEIGHT] = point[1] - middle;
    row[RADIUS] = point[0];
}

/* Computes the normal that points away from the axis. The normal of a level segment
 * points upwards. */
static void put_normal(const double along[2], double length, double *normal)
{
    double sign = along[1] < 0 ? -1 : 1;
    normal[0] = sign * along[1] / length;
    normal[1] = along[1] == 0 ? 1 : -sign * along[0] / length;
}

/* Writes the row of the segment from point i back to point i - 1. */
static void put_segment(const struct closed *closed, size_t i, double middle,
                        double *row)
{
    const double *to = point_of(closed, i), *from = point_of(closed, i - 1);
    const double along[2] = { from[0] - to[0], from[1] - to[1] };
    const double amid[2] = { to[0] + along[0] / 2, to[1] + along[1] / 2 };
    double length = elementary_hypot(along[0], along[1]), normal[2];
    int across = along[1] == 0 ? 0 : 1;
    double outward = is_inside(closed, i, amid, across) ? -1 : 1;
    put_normal(along, length, normal);
    row[LOW] = fmin(from[1], to[1]) - middle;
    row[HIGH] = fmax(from[1], to[1]) - middle;
    row[RISES] = along[1] < 0;
    row[LINE_Y] = normal[1];
    row[LINE_K] = normal[0] * to[0] + normal[1] * row[HEIGHT];
    row[LINE_R2] = normal[0] * normal[0];
    row[LINE_R] = normal[0];
    row[DIRECTION] = along[0] / length;
    row[DIRECTION + 1] = along[1] / length;
    row[LENGTH] = length;
    row[NORMAL] = outward * normal[0];
    row[NORMAL + 1] = outward * normal[1];
}

static double middle_of(const struct primitive *primitive)
{
    struct cylinder_about about = cylinder_of(primitive);
    return (about.low + about.high) / 2;
}

/* A computed hit is within this distance of its surface, relative to the size of the
 * lathe. */
#define NEAR 1e-3

/* Writes the bounding cylinder, the numbers of rows, and the greatest distance of a hit
 * from its surface. The cylinder is enlarged by more than the rounding errors. */
static size_t put_words(const struct primitive *primitive, double *words)
{
    struct cylinder_about about = cylinder_of(primitive);
    double half = (about.high - about.low) / 2 + ASIDE * about.radius;
    words[0] = (about.low + about.high) / 2;
    words[1] = about.radius * about.radius * (1 + 1e-6);
    words[2] = half + 1e-6 * (half + about.radius);
    words[3] = (double)primitive->shape.lathe.path.count;
    words[4] = (double)close_path(primitive).count;
    words[5] = NEAR * NEAR * (half + about.radius) * (half + about.radius);
    words[6] = 1.01 * NEAR * (half + about.radius);
    return 7;
}

static size_t put_table(const struct primitive *primitive,
                        const struct viewpoints *viewpoints, double *table)
{
    struct closed closed = close_path(primitive);
    double middle = middle_of(primitive);
    (void)viewpoints;
    for (size_t i = 0; table && i < closed.count; i++, table += ROW) {
        put_corner(point_of(&closed, i), middle, table);
        table[BEGINS] = i == 0;
        if (i > 0)
            put_segment(&closed, i, middle, table);
    }
    return ROW * closed.count;
}

/* Returns true if a lathe is solid above a level edge: the number of edges above the
 * midpoint of the edge is odd. The axis closes the path. */
static bool is_solid_above(const struct outline *path, size_t edge)
{
    double radius = (path->points[edge][0] + path->points[edge + 1][0]) / 2;
    double height = path->points[edge][1];
    bool solid = false;
    for (size_t i = 0; i + 1 < path->count; i++) {
        const double *a = path->points[i], *b = path->points[i + 1];
        if (i != edge && (a[0] > radius) != (b[0] > radius)
            && a[1] + (radius - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) > height)
            solid = !solid;
    }
    return solid;
}

/* Adds the level rings, which are perpendicular to the axis. */
static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    const struct outline *path = &primitive->shape.lathe.path;
    for (size_t i = 0; i + 1 < path->count; i++) {
        const double *a = path->points[i], *b = path->points[i + 1];
        const double center[3] = { 0, a[1], 0 };
        const double axis[3] = { 0, is_solid_above(path, i) ? -1 : 1, 0 };
        if (a[1] == b[1])
            faces_add_ring(search, center, axis, fmax(a[0], b[0]), true);
    }
    return true;
}

const struct shape shape_lathe = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .table = put_table,
    .segments = segments,
    .flat_faces = put_faces,
    .region = "lathe",
    .symbol = "LATHES",
    .kernels = { .kernel = "lathe",
                 .normal = "normal_lathe",
                 .segments = 1,
                 .solid = "lathe_solid" },
    .is_other = is_open,
    .other = { .kernel = "lathe",
               .normal = "normal_lathe",
               .segments = 1,
               .solid = "open_lathe_crossings",
               .state = "lathe_solid" },
};
