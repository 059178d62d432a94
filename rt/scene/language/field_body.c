/* field_body.c - builds the body below a height field, from invisible triangles.
 *
 * In POV-Ray a field is solid below its surface, without limit, over its whole square.
 * Where the water level cuts the surface off, it is solid below this level. The body
 * has two closed parts. The upper part extends from the triangles of the surface down
 * to the lowest point. It has walls at the border, and a ground. The lower part is a
 * column below the ground. Where ground and column touch, a ray crosses both, which has
 * the effect of no crossing.
 */
#include "rt/scene/language/scene_statement.h"

#include "rt/scene/language/scene_mesh.h"
#include "rt/scene/vector3.h"

#include <math.h>
#include <stdlib.h>

#define COLUMN_DEPTH 1e4 /* depth of the column, instead of infinity */
/* Corners are rounded to a grid with this spacing. An edge at the water level is
 * computed once for each of its two triangles, and rounding makes the results equal. */
#define GRAIN 0x1p-40
enum { COLUMN_FACES = 12 };

struct field_body {
    struct triangles triangles;
    double ground;
};

static void add(struct field_body *body, const double a[3], const double b[3],
                const double c[3])
{
    struct triangle *triangle = &body->triangles.list[body->triangles.count++];
    *triangle = (struct triangle){ .smooth = false };
    copy3(a, triangle->corners[0]);
    copy3(b, triangle->corners[1]);
    copy3(c, triangle->corners[2]);
}

static void below(const struct field_body *body, const double point[3], double foot[3])
{
    copy3(point, foot);
    foot[1] = body->ground;
}

/* ---- Walls --------------------------------------------------------------- */

/* An edge of a triangle. Its ends are in lexicographic order, so that equal edges of
 * two triangles compare equal. */
struct field_edge {
    const double *ends[2];
};

static int compare_points(const double *a, const double *b)
{
    for (int i = 0; i < 3; i++)
        if (a[i] != b[i])
            return a[i] < b[i] ? -1 : 1;
    return 0;
}

static int compare_edges(const void *a, const void *b)
{
    const struct field_edge *one = a, *other = b;
    int first = compare_points(one->ends[0], other->ends[0]);
    return first ? first : compare_points(one->ends[1], other->ends[1]);
}

static void take_edges(const struct triangles *surface, struct field_edge *edges)
{
    for (size_t i = 0; i < 3 * surface->count; i++) {
        const struct triangle *triangle = &surface->list[i / 3];
        const double *a = triangle->corners[i % 3];
        const double *b = triangle->corners[(i + 1) % 3];
        bool turned = compare_points(a, b) > 0;
        edges[i].ends[0] = turned ? b : a;
        edges[i].ends[1] = turned ? a : b;
    }
    qsort(edges, 3 * surface->count, sizeof *edges, compare_edges);
}

static void add_wall(struct field_body *body, const struct field_edge *edge)
{
    const double *a = edge->ends[0], *b = edge->ends[1];
    double a_foot[3], b_foot[3];
    below(body, a, a_foot);
    below(body, b, b_foot);
    if (b[1] > body->ground)
        add(body, a, b, b_foot);
    if (a[1] > body->ground)
        add(body, a, b_foot, a_foot);
}

/* Adds a wall below each edge at the border. Such an edge belongs to only one
 * triangle. */
static void add_walls(struct field_body *body, const struct field_edge *edges,
                      size_t count)
{
    for (size_t i = 0, next; i < count; i = next) {
        for (next = i + 1; next < count; next++)
            if (compare_edges(&edges[i], &edges[next]) != 0)
                break;
        if ((next - i) % 2 != 0)
            add_wall(body, &edges[i]);
    }
}

/* ---- The body ------------------------------------------------------------ */

static void add_surface(struct field_body *body, const struct triangles *surface)
{
    for (size_t i = 0; i < surface->count; i++) {
        struct triangle triangle = surface->list[i];
        for (int k = 0; k < 9; k++)
            triangle.corners[k / 3][k % 3] = GRAIN
                                             * round(triangle.corners[k / 3][k % 3]
                                                     / GRAIN);
        add(body, triangle.corners[0], triangle.corners[1], triangle.corners[2]);
        for (int k = 0; k < 3; k++)
            body->ground = fmin(body->ground, triangle.corners[k][1]);
    }
}

static void add_ground(struct field_body *body, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        double feet[3][3];
        for (int k = 0; k < 3; k++)
            below(body, body->triangles.list[i].corners[k], feet[k]);
        add(body, feet[0], feet[1], feet[2]);
    }
}

/* Computes a corner of the column below the ground. Bit 0 of its number selects x, bit
 * 1 y and bit 2 z. */
static void column_corner(const struct field_body *body, int number, double corner[3])
{
    corner[0] = number & 1;
    corner[1] = number & 2 ? body->ground : body->ground - COLUMN_DEPTH;
    corner[2] = number >> 2;
}

static void add_column(struct field_body *body)
{
    static const int faces[COLUMN_FACES][3] = {
        { 0, 1, 3 }, { 0, 3, 2 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 2, 6 }, { 0, 6, 4 },
        { 1, 3, 7 }, { 1, 7, 5 }, { 0, 4, 5 }, { 0, 5, 1 }, { 2, 6, 7 }, { 2, 7, 3 },
    };
    for (int i = 0; i < COLUMN_FACES; i++) {
        double corners[3][3];
        for (int k = 0; k < 3; k++)
            column_corner(body, faces[i][k], corners[k]);
        add(body, corners[0], corners[1], corners[2]);
    }
}

static void fill(struct field_body *body, const struct triangles *surface,
                 struct field_edge *edges)
{
    struct triangles top;
    add_surface(body, surface);
    top = body->triangles;
    add_ground(body, top.count);
    take_edges(&top, edges);
    add_walls(body, edges, 3 * top.count);
    add_column(body);
}

/* Builds the body below a surface. There is space for the surface, for the ground, and
 * for a wall of two triangles below each of the three edges of a triangle. */
static bool make_body(struct reader *reader, const struct triangles *surface,
                      struct field_body *body)
{
    size_t most = 8 * surface->count + COLUMN_FACES;
    struct field_edge *edges = malloc((3 * surface->count + 1) * sizeof *edges);
    bool good;
    body->ground = INFINITY;
    body->triangles.count = 0;
    body->triangles.list = malloc(most * sizeof *body->triangles.list);
    good = edges && body->triangles.list;
    if (good)
        fill(body, surface, edges);
    free(edges);
    return good || reader_no_memory(reader);
}

static bool fill_part(struct reader *reader, struct scene_part *part,
                      const struct scene_token *at)
{
    struct triangles *own = &part->primitive.shape.mesh.body;
    struct field_body body;
    bool done;
    if (!part->field || own->count > 0)
        return true;
    done = reader_spend(reader, TOKEN_COST * part->primitive.shape.mesh.triangles.count)
           && make_body(reader, &part->primitive.shape.mesh.triangles, &body);
    if (!done)
        return false;
    done = mesh_count(reader, body.triangles.count, at);
    if (done) {
        *own = body.triangles;
        own->list = reader_keep(reader, body.triangles.list,
                                own->count * sizeof *own->list);
        done = own->list;
    }
    free(body.triangles.list);
    return done;
}

bool fields_fill(struct reader *reader, struct scene_object *object,
                 const struct scene_token *at)
{
    for (size_t i = 0; i < object->part_count; i++)
        if (!fill_part(reader, &object->parts[i], at))
            return false;
    return true;
}
