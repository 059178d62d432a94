/* polygon.c - tessellates a polygon. A flat outline of one or more loops becomes a mesh
 * of triangles.
 *
 * The outline is projected along the axis that is closest to its normal. Horizontal
 * lines through all points, and through all crossings of edges, divide it into slabs.
 * Within a slab no edge ends and no two edges cross. In each slab the edges are sorted
 * across. The inside is between the first and the second edge, between the third and
 * the fourth, and so on. By this even-odd rule an area that is covered twice is a hole,
 * as in POV-Ray. A trapezoid is the area between the same two edges in adjacent slabs.
 * A new trapezoid starts only where an edge begins, ends or is crossed.
 */
#include "rt/scene/language/scene_statement.h"

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_mesh.h"
#include "rt/scene/vector3.h"

#include <stdlib.h>

/* POV-Ray's tolerances. A length or product counts as 0 if its square is below
 * SQUARE_NONE. Two points are equal if each pair of components differs by less than
 * POINT_SAME. A point is in the plane if its distance is below PLANE_SAME. For a
 * polygon smaller than 1 the tolerances are relative to its size. */
#define SQUARE_NONE 1e-10
#define POINT_SAME 1e-10
#define PLANE_SAME 1e-10
/* Lengths below ROUNDING times the greatest coordinate are rounding errors. */
#define ROUNDING 1e-14

/* Each crossing adds CROSSING_COST to the cost of reading. The limit of this cost also
 * limits the memory for crossings. */
enum { MIN_POINTS = 3, MAX_POINTS = 100000, CROSSING_COST = 256 };

/* An edge, which points upwards. Horizontal edges are dropped. */
struct polygon_edge {
    const double *low, *high;
    double from, to;            /* heights of its ends */
    double middle;              /* position across, at the middle of the slab */
    struct polygon_edge *right; /* the right side if this is the left side of a
                                 * trapezoid; else NULL */
    double since;               /* height at which this trapezoid begins */
};

struct polygon {
    struct reader *reader;
    const struct scene_token *at;
    struct arena arena; /* storage of the arrays below, except the triangles */
    size_t count;
    double (*points)[3];
    int across, up;  /* the two axes of the projection */
    double rounding; /* smaller lengths count as 0 */
    double size;     /* extent along the axes, at most 1 */

    size_t edge_count;
    struct polygon_edge *edges; /* sorted by their lower ends */
    size_t height_count, height_room;
    double *heights;
    size_t begun;        /* number of edges that begin at or below the current height */
    size_t active_count; /* edges that cross the current height, sorted across */
    struct polygon_edge **active;

    struct triangles triangles;
    size_t triangle_room;
};

static bool is_near(const double a[3], const double b[3], double near)
{
    for (int i = 0; i < 3; i++)
        if (!(fabs(a[i] - b[i]) < near))
            return false;
    return true;
}

/* ---- Points of a polygon ------------------------------------------------- */

static bool read_count(struct polygon *polygon)
{
    struct reader *reader = polygon->reader;
    struct scene_token at = reader->token;
    double number;
    if (!read_number(reader, &number))
        return false;
    if (number < MIN_POINTS)
        return reader_fault(reader, &at, "a polygon must have at least three points");
    if (number >= MAX_POINTS + 1)
        return reader_fault(reader, &at, "more than %d points in one polygon",
                            MAX_POINTS);
    polygon->count = (size_t)number;
    return true;
}

static bool read_points(struct polygon *polygon)
{
    double way[3];
    size_t count;
    if (!read_count(polygon))
        return false;
    count = polygon->count;
    polygon->points = arena_take(&polygon->arena, count * sizeof *polygon->points);
    if (!polygon->points)
        return reader_no_memory(polygon->reader);
    for (size_t i = 0; i < count; i++) {
        double *point = polygon->points[i];
        reader_comma(polygon->reader);
        if (!read_vector(polygon->reader, point))
            return false;
        polygon->rounding = fmax(polygon->rounding, ROUNDING * greatest3(point));
        subtract3(point, polygon->points[0], way);
        polygon->size = fmax(polygon->size, greatest3(way));
    }
    polygon->size = fmin(polygon->size, 1);
    return true;
}

/* ---- Plane of a polygon -------------------------------------------------- */

/* Computes the normal from three points, as in POV-Ray: the first point, the next point
 * that differs from it, and the next point that is not on a line with both. Returns
 * false if there are no such points. */
static bool find_normal(const struct polygon *polygon, double normal[3])
{
    double(*points)[3] = polygon->points, along[3] = { 0 }, way[3];
    double none = SQUARE_NONE * polygon->size * polygon->size;

    for (size_t i = 1; i < polygon->count; i++) {
        subtract3(points[i], points[0], way);
        if (!(dot3(way, way) > none))
            continue;
        if (!(dot3(along, along) > none)) {
            copy3(way, along);
            continue;
        }
        cross3(along, way, normal);
        if (dot3(normal, normal) > none * polygon->size * polygon->size)
            return true;
    }
    return false;
}

static bool is_flat(const struct polygon *polygon, const double normal[3])
{
    double off = fmax(PLANE_SAME * polygon->size, polygon->rounding);
    for (size_t i = 1; i < polygon->count; i++) {
        double way[3];
        subtract3(polygon->points[i], polygon->points[0], way);
        if (!(fabs(dot3(way, normal)) <= off))
            return false;
    }
    return true;
}

static void choose_axes(struct polygon *polygon, const double normal[3])
{
    int seen = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(normal[i]) > fabs(normal[seen]))
            seen = i;
    polygon->across = (seen + 1) % 3;
    polygon->up = (seen + 2) % 3;
}

/* Finds the plane of the polygon, and chooses the axes of the projection. Returns the
 * reason why POV-Ray does not show the polygon, or NULL. */
static const char *find_plane(struct polygon *polygon)
{
    double normal[3];
    if (!find_normal(polygon, normal))
        return "the polygon has no area, or one that is too small";
    scale3(1 / length3(normal), normal);
    if (!is_flat(polygon, normal))
        return "the points of the polygon are not in one plane";
    choose_axes(polygon, normal);
    return NULL;
}

/* ---- Edges of a polygon -------------------------------------------------- */

static void add_edge(struct polygon *polygon, const double *a, const double *b)
{
    struct polygon_edge *edge = &polygon->edges[polygon->edge_count];
    bool rises = a[polygon->up] < b[polygon->up];
    if (a[polygon->up] == b[polygon->up])
        return;
    edge->low = rises ? a : b;
    edge->high = rises ? b : a;
    edge->from = edge->low[polygon->up];
    edge->to = edge->high[polygon->up];
    polygon->edge_count++;
}

/* Closes the last loop of a polygon if its first point is not repeated. */
static bool close_part(struct polygon *polygon, size_t first)
{
    if (first + 1 == polygon->count)
        return reader_fault(polygon->reader, polygon->at,
                            "the polygon has a single point after a closed part");
    reader_report(polygon->reader, polygon->at,
                  "the polygon is not closed; its first point is "
                  "repeated after the last");
    add_edge(polygon, polygon->points[polygon->count - 1], polygon->points[first]);
    return true;
}

/* Adds the edges of all loops. A loop ends where its first point is repeated. The next
 * point begins the next loop. */
static bool add_edges(struct polygon *polygon)
{
    double(*points)[3] = polygon->points;
    size_t first = 0;

    for (size_t i = 1; i < polygon->count; i++) {
        bool closes = is_near(points[first], points[i], POINT_SAME * polygon->size);
        add_edge(polygon, points[i - 1], points[closes ? first : i]);
        if (closes)
            first = ++i;
    }
    return first >= polygon->count || close_part(polygon, first);
}

static int compare(double a, double b)
{
    return (a > b) - (a < b);
}

static int compare_low_ends(const void *a, const void *b)
{
    const struct polygon_edge *one = a, *other = b;
    return compare(one->from, other->from);
}

static bool make_edges(struct polygon *polygon)
{
    struct arena *arena = &polygon->arena;
    size_t count = polygon->count;
    polygon->edges = arena_take(arena, count * sizeof *polygon->edges);
    polygon->active = arena_take(arena, count * sizeof *polygon->active);
    if (!polygon->edges || !polygon->active)
        return reader_no_memory(polygon->reader);
    if (!add_edges(polygon))
        return false;
    qsort(polygon->edges, polygon->edge_count, sizeof *polygon->edges,
          compare_low_ends);
    return true;
}

/* Computes the point of an edge at a height. At the ends of the edge the result is
 * exact. */
static void point_at(const struct polygon *polygon, const struct polygon_edge *edge,
                     double height, double point[3])
{
    double part = (height - edge->from) / (edge->to - edge->from);
    if (height == edge->from || height == edge->to) {
        copy3(height == edge->from ? edge->low : edge->high, point);
        return;
    }
    for (int i = 0; i < 3; i++)
        point[i] = edge->low[i] + part * (edge->high[i] - edge->low[i]);
    point[polygon->up] = height;
}

static double across_at(const struct polygon *polygon, const struct polygon_edge *edge,
                        double height)
{
    double point[3];
    point_at(polygon, edge, height, point);
    return point[polygon->across];
}

/* ---- The heights --------------------------------------------------------- */

static bool add_height(struct polygon *polygon, double height)
{
    return arena_add(&polygon->arena, &polygon->heights, &polygon->height_count,
                     &polygon->height_room, &height, sizeof height)
           || reader_no_memory(polygon->reader);
}

/* Adds the height at which two edges cross. Edges that touch without crossing do so at
 * a point of the outline, whose height has already been added. */
static bool add_crossing(struct polygon *polygon, const struct polygon_edge *a,
                         const struct polygon_edge *b)
{
    double low = fmax(a->from, b->from), high = fmin(a->to, b->to);
    double below = across_at(polygon, a, low) - across_at(polygon, b, low);
    double above = across_at(polygon, a, high) - across_at(polygon, b, high);
    if (!((below < 0 && above > 0) || (below > 0 && above < 0)))
        return true;
    return reader_spend(polygon->reader, CROSSING_COST)
           && add_height(polygon, low + (high - low) * (below / (below - above)));
}

/* Adds the crossings of edge i with all edges whose lower end is below its upper
 * end. */
static bool add_crossings(struct polygon *polygon, size_t i)
{
    const struct polygon_edge *edges = polygon->edges;
    size_t k = i + 1;
    for (; k < polygon->edge_count && edges[k].from < edges[i].to; k++)
        if (!add_crossing(polygon, &edges[i], &edges[k]))
            return false;
    return reader_spend(polygon->reader, TOKEN_COST * (k - i));
}

static int compare_heights(const void *a, const void *b)
{
    const double *one = a, *other = b;
    return compare(*one, *other);
}

/* Sorts the heights at which the slabs begin and end, and removes duplicates. */
static void sort_heights(struct polygon *polygon)
{
    double *heights = polygon->heights;
    size_t kept = 0;
    if (!heights)
        return;
    qsort(heights, polygon->height_count, sizeof *heights, compare_heights);
    for (size_t i = 0; i < polygon->height_count; i++)
        if (i == 0 || heights[i] != heights[kept - 1])
            heights[kept++] = heights[i];
    polygon->height_count = kept;
}

static bool find_heights(struct polygon *polygon)
{
    for (size_t i = 0; i < polygon->edge_count; i++)
        if (!add_height(polygon, polygon->edges[i].from)
            || !add_height(polygon, polygon->edges[i].to) || !add_crossings(polygon, i))
            return false;
    sort_heights(polygon);
    return true;
}

/* ---- The trapezoids ------------------------------------------------------ */

static bool add_triangle(struct polygon *polygon, const double a[3], const double b[3],
                         const double c[3])
{
    struct triangle triangle = { .smooth = false };
    copy3(a, triangle.corners[0]);
    copy3(b, triangle.corners[1]);
    copy3(c, triangle.corners[2]);
    return mesh_keep_triangle(polygon->reader, &polygon->triangles,
                              &polygon->triangle_room, &triangle, polygon->at);
}

/* Adds a trapezoid. If its sides meet at an end, it is one triangle. */
static bool add_trapezoid(struct polygon *polygon, double low[2][3], double high[2][3])
{
    double near = polygon->rounding;
    return (is_near(low[0], low[1], near)
            || add_triangle(polygon, low[0], low[1], high[1]))
           && (is_near(high[0], high[1], near)
               || add_triangle(polygon, low[0], high[1], high[0]));
}

static bool end_trapezoid(struct polygon *polygon, struct polygon_edge *left,
                          double height)
{
    struct polygon_edge *right = left->right;
    double low[2][3], high[2][3];
    left->right = NULL;
    if (!right || height - left->since < polygon->rounding)
        return true;
    point_at(polygon, left, left->since, low[0]);
    point_at(polygon, right, left->since, low[1]);
    point_at(polygon, left, height, high[0]);
    point_at(polygon, right, height, high[1]);
    return add_trapezoid(polygon, low, high);
}

/* Removes the edges that end at this height, and completes the trapezoids of which they
 * are the left sides. */
static bool end_edges(struct polygon *polygon, double height)
{
    struct polygon_edge **active = polygon->active;
    size_t kept = 0;
    for (size_t i = 0; i < polygon->active_count; i++) {
        bool ends = active[i]->to <= height;
        if (ends && !end_trapezoid(polygon, active[i], height))
            return false;
        if (!ends)
            active[kept++] = active[i];
    }
    polygon->active_count = kept;
    return true;
}

static void begin_edges(struct polygon *polygon, double height)
{
    struct polygon_edge *edges = polygon->edges;
    for (; polygon->begun < polygon->edge_count && edges[polygon->begun].from <= height;
         polygon->begun++)
        polygon->active[polygon->active_count++] = &edges[polygon->begun];
}

/* Compares the positions of two edges. Edges at the same position are ordered by index,
 * so that the order is the same in all slabs. */
static int compare_places(const void *a, const void *b)
{
    const struct polygon_edge *one = *(struct polygon_edge *const *)a;
    const struct polygon_edge *other = *(struct polygon_edge *const *)b;
    int order = compare(one->middle, other->middle);
    return order ? order : (one > other) - (one < other);
}

static bool sort_active(struct polygon *polygon, double middle)
{
    size_t count = polygon->active_count;
    struct polygon_edge **active = polygon->active;
    for (size_t i = 0; i < count; i++)
        active[i]->middle = across_at(polygon, active[i], middle);
    qsort(active, count, sizeof *active, compare_places);
    return reader_spend(polygon->reader, TOKEN_COST * (count + 1));
}

/* Pairs the edges: every second edge is the left side of a trapezoid. If the right side
 * changes, the old trapezoid is completed. */
static bool pair_edges(struct polygon *polygon, double height)
{
    struct polygon_edge **active = polygon->active;
    for (size_t i = 0; i < polygon->active_count; i++) {
        struct polygon_edge *right = i % 2 == 0 ? active[i + 1] : NULL;
        if (active[i]->right == right)
            continue;
        if (!end_trapezoid(polygon, active[i], height))
            return false;
        active[i]->right = right;
        active[i]->since = height;
    }
    return true;
}

/* Finds the left and right edges of the trapezoids in the slab above height i. */
static bool take_slab(struct polygon *polygon, size_t i)
{
    double low = polygon->heights[i], high = polygon->heights[i + 1];
    begin_edges(polygon, low);
    return sort_active(polygon, low / 2 + high / 2) && pair_edges(polygon, low);
}

static bool cut(struct polygon *polygon)
{
    size_t count = polygon->height_count;
    for (size_t i = 0; i < count; i++)
        if (!end_edges(polygon, polygon->heights[i])
            || (i + 1 < count && !take_slab(polygon, i)))
            return false;
    return true;
}

/* ---- The statement ------------------------------------------------------- */

static bool make_mesh(struct polygon *polygon, struct scene_object *object)
{
    const char *why = find_plane(polygon);
    if (why)
        return shape_leave_out(polygon->reader, object, polygon->at, why);
    return make_edges(polygon) && find_heights(polygon) && cut(polygon)

           && mesh_object_add(polygon->reader, object, &polygon->triangles, polygon->at,
                              "the polygon has no area");
}

bool polygon_read(struct reader *reader, struct scene_object *object,
                  const struct scene_token *at)
{
    struct polygon polygon = { .reader = reader, .at = at };
    bool done = read_points(&polygon) && make_mesh(&polygon, object);
    arena_free(&polygon.arena);
    return done;
}
