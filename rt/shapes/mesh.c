/* mesh.c - the descriptor of meshes: checks their arguments, computes their bounds and
 * the words of their records, and names their kernels. */
#include "rt/shapes/mesh.h"
#include "rt/shapes/shape.h"

#include <stdlib.h>
#include <string.h>

#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/bvh/mesh_hierarchy.h"
#include "rt/bvh/screen_bounds.h"
#include "rt/shapes/flat_faces.h"

/* There are no fields, because rt/scene/language/scene_mesh.c and mesh2.c parse the
 * arguments of meshes. */
static const struct shape_field fields[] = {
    { TAKES_END, 0, NULL, 0, NULL },
};

/* ---- Settling ------------------------------------------------------------ */

/* Returns true if the triangle has an area, which is decided by the ratio of its height
 * and its length. The edges are scaled first, because products of small edges may
 * underflow. */
static bool has_area(const struct triangle *triangle)
{
    double edges[2][3], normal[3], size;
    for (int k = 0; k < 2; k++)
        subtract3(triangle->corners[1 + k], triangle->corners[0], edges[k]);
    size = fmax(greatest3(edges[0]), greatest3(edges[1]));
    if (size == 0 || !isfinite(size)) /* not finite: reported by another check */
        return size != 0;
    scale3(1 / size, edges[0]);
    scale3(1 / size, edges[1]);
    cross3(edges[0], edges[1], normal);
    return length3(normal) > 1e-12;
}

static bool has_normals(const struct triangle *triangle)
{
    return triangle->smooth && length3(triangle->normals[0]) > 0
           && length3(triangle->normals[1]) > 0 && length3(triangle->normals[2]) > 0;
}

/* Removes triangles without area, as POV-Ray does. */
static const char *finish(struct primitive *primitive)
{
    struct triangles *triangles = &primitive->shape.mesh.triangles;
    size_t kept = 0;
    for (size_t i = 0; i < triangles->count; i++) {
        struct triangle *triangle = &triangles->list[i];
        triangle->smooth = has_normals(triangle);
        if (has_area(triangle))
            triangles->list[kept++] = *triangle;
    }
    triangles->count = kept;
    return kept > 0 ? NULL : shape_empty(primitive, "no triangle has an area");
}

static bool has_body(const struct primitive *primitive)
{
    return primitive->shape.mesh.body.count > 0;
}

/* ---- In the world -------------------------------------------------------- */

/* Transforms the unit vector of a normal to world space, where its length may differ
 * from 1. */
static void carry_normal(const struct primitive *primitive, double normal[3])
{
    double length = length3(normal);
    transform_normal(&primitive->to_local, normal);
    for (int i = 0; i < 3; i++)
        normal[i] /= length;
}

static struct triangle carried(const struct primitive *primitive,
                               const struct triangles *triangles, size_t i)
{
    struct triangle triangle = triangles->list[i];
    for (int k = 0; k < 3; k++) {
        transform_point(&primitive->to_world, triangle.corners[k]);
        if (triangle.smooth)
            carry_normal(primitive, triangle.normals[k]);
    }
    return triangle;
}

static struct boxed boxed_of(const struct triangle *triangle)
{
    struct boxed boxed = { box_empty, { 0 } };
    for (int k = 0; k < 3; k++) {
        struct box corner;
        copy3(triangle->corners[k], corner.low);
        copy3(triangle->corners[k], corner.high);
        box_join(&boxed.box, &corner);
    }
    for (int i = 0; i < 3; i++)
        boxed.place[i] = boxed.box.low[i] / 2 + boxed.box.high[i] / 2;
    return boxed;
}

static struct box box_of(const struct primitive *primitive,
                         const struct triangles *triangles)
{
    struct box box = box_empty;
    for (size_t i = 0; i < triangles->count; i++) {
        struct triangle triangle = carried(primitive, triangles, i);
        struct boxed boxed = boxed_of(&triangle);
        box_join(&box, &boxed.box);
    }
    return box;
}

static double reach_of(const struct triangle *triangle, const double center[3])
{
    double reach = 0, away[3];
    for (int k = 0; k < 3; k++) {
        subtract3(triangle->corners[k], center, away);
        reach = fmax(reach, length3(away));
    }
    return reach;
}

/* Computes the box of the triangles, and the sphere about its centre that contains all
 * corners. */
static void bound_many(const struct primitive *primitive,
                       const struct triangles *triangles, struct bound *bound)
{
    size_t count = triangles->count;
    struct box box = box_of(primitive, triangles);
    copy3(box.low, bound->low);
    copy3(box.high, bound->high);
    for (int i = 0; i < 3; i++)
        bound->center[i] = box.low[i] / 2 + box.high[i] / 2;
    bound->radius = 0;
    for (size_t i = 0; i < count; i++) {
        struct triangle triangle = carried(primitive, triangles, i);
        bound->radius = fmax(bound->radius, reach_of(&triangle, bound->center));
    }
}

/* Bounds the triangles of the mesh, or those of its body, which contains the whole
 * surface. If there are few, the bound of their hull has a smaller sphere. */
static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    const struct triangles *triangles = has_body(primitive)
                                            ? &primitive->shape.mesh.body
                                            : &primitive->shape.mesh.triangles;
    struct hull hull = { .count = 0 };
    if (triangles->count > MAX_HULL / 3) {
        bound_many(primitive, triangles, bound);
        return;
    }
    for (size_t i = 0; i < 3 * triangles->count; i++)
        hull_point(&hull, primitive, triangles->list[i / 3].corners[i % 3]);
    bound_hull(&hull, bound);
}

/* ---- Words and table ----------------------------------------------------- */

/* The table consists of four parts: the end row, the rows of the nodes, the rows of the
 * triangles in the order of the leaves, and the screen bounds. The end row ends a
 * traversal; it is zero except for the offset and the number of the viewpoints. A row
 * is identified by its offset in words. records.s defines the rows. */
enum {
    NODE_ROW = 25,
    NODE_LINKS = 6, /* this word and those after it are integers */
    DIRECTIONS = 8, /* combinations of the signs of x (bit 0), y (bit 1) and z (bit 2)
                     * of a ray */
    NODE_FIRST = NODE_LINKS + 2 * DIRECTIONS,
    NODE_COUNT,
    VIEWPOINTS_FIRST = NODE_FIRST, /* word of the end row */
    VIEWPOINTS_COUNT = NODE_COUNT,
    FLAT_ROW = 13,
    SMOOTH_ROW = 21
};

static bool is_flat(const struct primitive *primitive)
{
    const struct triangles *triangles = &primitive->shape.mesh.triangles;
    for (size_t i = 0; i < triangles->count; i++)
        if (triangles->list[i].smooth)
            return false;
    return true;
}

static size_t row_size(const struct primitive *primitive)
{
    return is_flat(primitive) ? FLAT_ROW : SMOOTH_ROW;
}

static double node_place(size_t node)
{
    return (double)(NODE_ROW * (node + 1));
}

struct mesh_table {
    const struct mesh_hierarchy *hierarchy;
    size_t row;    /* words in a triangle's row */
    double margin; /* enlarges the boxes by more than the rounding errors */
    double *nodes; /* rows of the nodes */
};

static void put_node(const struct mesh_table *table, size_t node)
{
    const struct mesh_node *from = &table->hierarchy->nodes[node];
    double *row = table->nodes + NODE_ROW * node;
    for (int i = 0; i < 3; i++) {
        row[i] = from->box.low[i] / 2 + from->box.high[i] / 2;
        row[3 + i] = from->box.high[i] / 2 - from->box.low[i] / 2 + table->margin;
    }
    row[NODE_FIRST] = node_place(table->hierarchy->node_count)
                      + (double)(table->row * from->first);
    row[NODE_COUNT] = (double)from->count;
}

/* Computes the unit normal of the triangle's plane. */
static void plane_normal(const struct triangle *triangle, double normal[3])
{
    double edges[2][3], size;
    for (int k = 0; k < 2; k++) {
        subtract3(triangle->corners[1 + k], triangle->corners[0], edges[k]);
        size = greatest3(edges[k]);
        scale3(1 / size, edges[k]);
    }
    cross3(edges[0], edges[1], normal);
    scale3(1 / length3(normal), normal);
}

/* Computes the gradient of the barycentric coordinate of corner k. The other corners
 * are a and b. */
static void share_gradient(const struct triangle *triangle, int k, int a, int b,
                           double gradient[3])
{
    double base[3], way[3], along;
    subtract3(triangle->corners[b], triangle->corners[a], base);
    subtract3(triangle->corners[k], triangle->corners[a], way);
    along = dot3(way, base) / dot3(base, base);
    for (int i = 0; i < 3; i++)
        gradient[i] = way[i] - along * base[i];
    scale3(1 / dot3(gradient, gradient), gradient);
}

/* Writes the normal at the first corner and the gradient of the normal, which has three
 * rows. */
static void put_smooth(const struct triangle *triangle, double *row)
{
    double shares[2][3];
    share_gradient(triangle, 1, 0, 2, shares[0]);
    share_gradient(triangle, 2, 0, 1, shares[1]);
    copy3(triangle->normals[0], row);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 2; k++)
                row[3 + 3 * i + j] += (triangle->normals[1 + k][i]
                                       - triangle->normals[0][i])
                                      * shares[k][j];
}

static void turn_up(const struct primitive *primitive, double normal[3])
{
    double up[3] = { 0, 1, 0 };
    transform_normal(&primitive->to_local, up);
    if (dot3(up, normal) < 0)
        scale3(-1, normal);
}

/* Writes the row of a triangle. A triangle that has no area in the world gets an
 * arbitrary normal. In a mesh with a body, normals point upwards, away from the
 * body. */
static void put_triangle(const struct primitive *primitive,
                         const struct triangles *triangles, size_t i, double *row)
{
    struct triangle triangle = carried(primitive, triangles, i);
    memcpy(row, triangle.corners, sizeof triangle.corners);
    if (!has_area(&triangle))
        row[9] = 1;
    else if (triangle.smooth)
        put_smooth(&triangle, row + 9);
    else
        plane_normal(&triangle, row + 9);
    if (has_body(primitive) && !triangle.smooth)
        turn_up(primitive, row + 9);
}

/* Writes the links of the nodes for rays in a combination of signs: bit 0, 1 or 2 of
 * `direction` is set if x, y or z is negative. */
static void put_links(const struct mesh_table *table, size_t direction,
                      unsigned char *orders)
{
    const struct mesh_hierarchy *hierarchy = table->hierarchy;
    for (size_t i = 0; i < hierarchy->node_count; i++) {
        const struct mesh_node *node = &hierarchy->nodes[i];
        orders[i] = node->is_passed ? MESH_PASSED : 0;
        if (direction >> node->axis & 1)
            orders[i] |= MESH_UPPER_FIRST;
    }
    mesh_hierarchy_thread(hierarchy, orders,
                          &(struct mesh_rows){
                              table->nodes + NODE_LINKS + 2 * direction, NODE_ROW });
}

static bool put_nodes(const struct mesh_table *table)
{
    unsigned char *orders = malloc(table->hierarchy->node_count);
    for (size_t i = 0; i < table->hierarchy->node_count; i++)
        put_node(table, i);
    for (size_t i = 0; orders && i < DIRECTIONS; i++)
        put_links(table, i, orders);
    free(orders);
    return orders;
}

static bool fill_table(const struct primitive *primitive,
                       const struct triangles *triangles,
                       const struct mesh_hierarchy *hierarchy, double *table)
{
    const struct box *whole = &hierarchy->nodes[0].box;
    struct mesh_table filled = {
        .hierarchy = hierarchy,
        .row = row_size(primitive),
        .margin = 0x1p-36 * fmax(greatest3(whole->low), greatest3(whole->high)),
        .nodes = table + NODE_ROW,
    };
    double *row = filled.nodes + NODE_ROW * hierarchy->node_count;
    for (size_t i = 0; i < triangles->count; i++)
        put_triangle(primitive, triangles, hierarchy->order[i], row + filled.row * i);
    return put_nodes(&filled);
}

static bool plan(const struct primitive *primitive, const struct triangles *triangles,
                 struct mesh_hierarchy *hierarchy)
{
    struct boxed *boxes = malloc((triangles->count + 1) * sizeof *boxes);
    bool good;
    for (size_t i = 0; boxes && i < triangles->count; i++) {
        struct triangle triangle = carried(primitive, triangles, i);
        boxes[i] = boxed_of(&triangle);
    }
    good = boxes && mesh_hierarchy_build(boxes, triangles->count, hierarchy);
    free(boxes);
    return good;
}

/* nodes_size returns the number of words before the rows of the triangles. table_size
 * returns the number of words including these rows. */
static size_t nodes_size(const struct triangles *triangles)
{
    return NODE_ROW * (mesh_hierarchy_nodes(triangles->count) + 1);
}

static size_t table_size(const struct primitive *primitive,
                         const struct triangles *triangles)
{
    return nodes_size(triangles) + row_size(primitive) * triangles->count;
}

static bool put_screen_bounds(const struct primitive *primitive,
                              const struct mesh_hierarchy *hierarchy,
                              const struct viewpoints *viewpoints, size_t place,
                              double *table)
{
    size_t nodes = NODE_ROW * (hierarchy->node_count + 1);
    struct screen_bounds bounds = { .hierarchy = hierarchy,
                                    .triangles = table + nodes,
                                    .row = row_size(primitive),
                                    .triangles_place = (double)nodes };
    size_t planned;
    bool good = screen_bounds_put(&bounds, viewpoints, (double)place, table + place,
                                  &planned);
    table[VIEWPOINTS_FIRST] = (double)place;
    table[VIEWPOINTS_COUNT] = (double)planned;
    return good;
}

/* Writes the rows of the nodes and the triangles, and, at the offset `place`, the
 * screen bounds. */
static bool put_hierarchy(const struct primitive *primitive,
                          const struct triangles *triangles,
                          const struct viewpoints *viewpoints, size_t place,
                          double *table)
{
    struct mesh_hierarchy hierarchy = { 0 };
    bool good = plan(primitive, triangles, &hierarchy)
                && fill_table(primitive, triangles, &hierarchy, table)
                && put_screen_bounds(primitive, &hierarchy, viewpoints, place, table);
    mesh_hierarchy_free(&hierarchy);
    return good;
}

size_t *mesh_order(const struct primitive *mesh)
{
    struct mesh_hierarchy hierarchy = { 0 };
    size_t *order = NULL;
    if (plan(mesh, &mesh->shape.mesh.triangles, &hierarchy)) {
        order = hierarchy.order;
        hierarchy.order = NULL;
    }
    mesh_hierarchy_free(&hierarchy);
    return order;
}

size_t mesh_row(const struct primitive *mesh, size_t words)
{
    return (words - nodes_size(&mesh->shape.mesh.triangles)) / row_size(mesh);
}

/* Returns the size in words of the screen bounds of the visible triangles. Sets *seeing
 * to the number of viewpoints outside the mesh. */
static size_t bounds_size(const struct primitive *primitive,
                          const struct viewpoints *viewpoints, size_t *seeing)
{
    const struct triangles *seen = &primitive->shape.mesh.triangles;
    struct box box = box_of(primitive, seen);
    return screen_bounds_size(viewpoints, &box, mesh_hierarchy_nodes(seen->count),
                              seeing);
}

/* Returns the offset of the screen bounds in the table. They follow the rows of the
 * visible triangles and of the body. */
static size_t bounds_place(const struct primitive *primitive)
{
    const struct triangles *body = &primitive->shape.mesh.body;
    return table_size(primitive, &primitive->shape.mesh.triangles)
           + (body->count > 0 ? table_size(primitive, body) : 0);
}

/* Writes the rows of the visible triangles, the rows of the body, and the screen bounds
 * (rt/bvh/screen_bounds.h). Returns the number of words, or 0 if out of memory. */
static size_t put_table(const struct primitive *primitive,
                        const struct viewpoints *viewpoints, double *table)
{
    const struct triangles *seen = &primitive->shape.mesh.triangles;
    const struct triangles *body = &primitive->shape.mesh.body;
    size_t size = table_size(primitive, seen), place = bounds_place(primitive);
    size_t seeing;
    if (table && !put_hierarchy(primitive, seen, viewpoints, place, table))
        return 0;
    if (table && body->count > 0
        && !put_hierarchy(primitive, body, NULL, 0, table + size))
        return 0;
    return place + bounds_size(primitive, viewpoints, &seeing);
}

/* Checks the words of the triangles. The words of the boxes need no check, because they
 * are averages of the coordinates of corners. */
static bool is_finite(const struct primitive *primitive)
{
    const struct triangles *triangles = &primitive->shape.mesh.triangles;
    for (size_t i = 0; i < triangles->count; i++) {
        double row[SMOOTH_ROW] = { 0 };
        put_triangle(primitive, triangles, i, row);
        for (size_t k = 0; k < SMOOTH_ROW; k++)
            if (!isfinite(row[k]))
                return false;
    }
    return true;
}

/* Marks the words after the box of each node, which are integers. */
static void mark_links(const struct triangles *triangles, bool *marks)
{
    size_t size = nodes_size(triangles);
    for (size_t i = 0; i < size; i++)
        marks[i] = i % NODE_ROW >= NODE_LINKS;
}

static void mark_integers(const struct primitive *primitive,
                          const struct viewpoints *viewpoints, bool *marks)
{
    const struct triangles *seen = &primitive->shape.mesh.triangles;
    const struct triangles *body = &primitive->shape.mesh.body;
    size_t seeing;
    mark_links(seen, marks);
    if (body->count > 0)
        mark_links(body, marks + table_size(primitive, seen));
    bounds_size(primitive, viewpoints, &seeing);
    screen_bounds_mark(seeing, mesh_hierarchy_nodes(seen->count),
                       marks + bounds_place(primitive));
}

/* Returns the largest number of crossings with `count` triangles. A ray crosses a
 * triangle at most once. An odd number means that the ray starts inside, which adds one
 * crossing. */
static size_t even(size_t count)
{
    return count + count % 2;
}

static size_t crossings(const struct primitive *primitive)
{
    return even(primitive->shape.mesh.triangles.count);
}

static size_t segments(const struct primitive *primitive)
{
    return primitive->shape.mesh.solid ? crossings(primitive) / 2
                                       : even(primitive->shape.mesh.body.count) / 2;
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    const struct triangles *body = &primitive->shape.mesh.body;
    words[0] = (double)row_size(primitive);
    words[1] = (double)crossings(primitive);
    if (body->count == 0)
        return 2;
    words[2] = (double)table_size(primitive, &primitive->shape.mesh.triangles);
    words[3] = (double)even(body->count);
    return 4;
}

/* Returns true, because the words of a mesh are always in world space. */
static bool carry(const struct primitive *primitive, double *words)
{
    (void)primitive;
    (void)words;
    return true;
}

static const char *emit(const struct primitive *primitive, struct emitter *emitter)
{
    const struct triangles *triangles = &primitive->shape.mesh.triangles;
    if (!emitter_begin(emitter, "emit_triangle", triangles->count, TRIANGLE_WORDS))
        return emitter_no_memory;
    for (size_t i = 0; i < triangles->count; i++)
        emitter_add_triangle(emitter, triangles->list[i].corners[0],
                             triangles->list[i].corners[1],
                             triangles->list[i].corners[2]);
    return NULL;
}

static bool put_faces(const struct primitive *primitive, struct face_search *search)
{
    faces_add_triangles(search, &primitive->shape.mesh.triangles);
    return false;
}

const struct shape shape_mesh = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .table = put_table,
    .mark_integers = mark_integers,
    .is_finite = is_finite,
    .carry = carry,
    .segments = segments,
    .crossings = crossings,
    .has_body = has_body,
    .flat_faces = put_faces,
    .region = "mesh",
    .emit = emit,
    .kernels = { .kernel = "mesh",
                 .normal = "normal_smooth_mesh",
                 .solid = "mesh_crossings",
                 .inside = "mesh_solid",
                 .body = "mesh_body" },
    .is_other = is_flat,
    .other = { .kernel = "mesh",
               .normal = "normal_mesh",
               .solid = "mesh_crossings",
               .inside = "mesh_solid",
               .body = "mesh_body" },
};
