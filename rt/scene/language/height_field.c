/* height_field.c - parses height_field and converts it to the triangles of a mesh.
 *
 * The field covers the square from <0, 0, 0> to <1, 0, 1>. Its heights are at the
 * points of a grid. Each cell is divided by the diagonal from the greater x to the
 * greater z:
 *
 *     z+1  *---*
 *          |\  |
 *          | \ |
 *          |  \|
 *      z   *---*
 *          x   x+1
 *
 * The part below the water level is removed.
 */
#include "rt/scene/language/scene_statement.h"

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/heights.h"
#include "rt/scene/language/scene_mesh.h"
#include "rt/scene/vector3.h"

#include <stdlib.h>
#include <string.h>

/* POV-Ray stores the components of a normal of a height field as integers, in units of
 * 1 / NORMAL_STEPS. */
#define NORMAL_STEPS 32767.

struct height_field {
    struct reader *reader;
    const struct scene_token *at;
    struct heights heights;
    bool smooth;
    double water;
    struct triangles triangles;
};

struct field_point {
    double place[3], normal[3];
};

/* ---- Points -------------------------------------------------------------- */

/* Adds the unit normal of the triangle that consists of a point, its neighbour in x and
 * its neighbour in z. The normal is in units of the grid: 1 is the distance of
 * neighbours in x and z, and one step of the heights in y. */
static void add_normal(const struct heights *heights, size_t x, size_t z, int right,
                       int up, double sum[3])
{
    double height = height_at(heights, x, z);
    double beside = height_at(heights, x + (size_t)right, z);
    double behind = height_at(heights, x, z + (size_t)up);
    double normal[3] = { right * (height - beside), 1, up * (height - behind) };
    double length = length3(normal);
    for (int i = 0; i < 3; i++)
        sum[i] += normal[i] / length;
}

/* Computes the normal of a point as POV-Ray does: the sum of the normals of up to four
 * triangles around it, however the cells are divided. Each component is truncated to an
 * integer. The length is arbitrary. */
static void point_normal(const struct heights *heights, size_t x, size_t z,
                         double normal[3])
{
    double steps[3] = { (double)(heights->columns - 1), HEIGHT_ONE,
                        (double)(heights->rows - 1) };
    double length;
    for (int i = 0; i < 3; i++)
        normal[i] = 0;
    for (int right = -1; right <= 1; right += 2)
        for (int up = -1; up <= 1; up += 2)
            if (x + (size_t)right < heights->columns && z + (size_t)up < heights->rows)
                add_normal(heights, x, z, right, up, normal);
    length = length3(normal);
    for (int i = 0; i < 3; i++)
        normal[i] = trunc(normal[i] / length * NORMAL_STEPS) * steps[i];
}

static struct field_point point_of(const struct height_field *field, size_t x, size_t z)
{
    const struct heights *heights = &field->heights;
    struct field_point point = { .place = { (double)x / (double)(heights->columns - 1),
                                            height_at(heights, x, z) / HEIGHT_ONE,
                                            (double)z / (double)(heights->rows - 1) } };
    if (field->smooth) {
        point_normal(heights, x, z, point.normal);
        scale3(1 / length3(point.normal), point.normal);
    }
    return point;
}

/* ---- Triangles ----------------------------------------------------------- */

/* Sets the corners of the lower or the upper half of a cell of a height field. */
static void take_corners(const struct height_field *field, size_t x, size_t z,
                         bool upper, struct field_point corners[3])
{
    corners[0] = point_of(field, x + upper, z + upper);
    corners[1] = point_of(field, x + 1, z);
    corners[2] = point_of(field, x, z + 1);
}

/* Computes the point where the water level cuts an edge. */
static struct field_point shore(const struct height_field *field,
                                const struct field_point *a,
                                const struct field_point *b)
{
    double part = (field->water - a->place[1]) / (b->place[1] - a->place[1]);
    struct field_point point;
    for (int i = 0; i < 3; i++) {
        point.place[i] = a->place[i] + part * (b->place[i] - a->place[i]);
        point.normal[i] = a->normal[i] + part * (b->normal[i] - a->normal[i]);
    }
    point.place[1] = field->water;
    return point;
}

/* Clips a triangle at the water level. Returns the number of corners of the part above
 * the level, or 0 if there is no such part. */
static size_t cut_triangle(const struct height_field *field,
                           const struct field_point corners[3],
                           struct field_point left[4])
{
    size_t count = 0;
    for (int i = 0; i < 3; i++) {
        const struct field_point *a = &corners[i], *b = &corners[(i + 1) % 3];
        bool dry = a->place[1] >= field->water;
        if (dry)
            left[count++] = *a;
        if (dry != (b->place[1] >= field->water))
            left[count++] = shore(field, a, b);
    }
    return count;
}

static void put_triangle(struct height_field *field, const struct field_point *a,
                         const struct field_point *b, const struct field_point *c)
{
    const struct field_point *points[3] = { a, b, c };
    struct triangle *triangle = &field->triangles.list[field->triangles.count];
    memset(triangle, 0, sizeof *triangle);
    triangle->smooth = field->smooth;
    for (int k = 0; k < 3; k++) {
        copy3(points[k]->place, triangle->corners[k]);
        copy3(points[k]->normal, triangle->normals[k]);
    }
    field->triangles.count++;
}

/* Adds the triangles of half a cell of the grid. If there is no list of triangles yet,
 * only counts them. */
static void add_half(struct height_field *field, size_t x, size_t z, bool upper)
{
    struct field_point corners[3], left[4];
    size_t count;
    take_corners(field, x, z, upper, corners);
    count = cut_triangle(field, corners, left);
    if (!field->triangles.list)
        field->triangles.count += count > 2 ? count - 2 : 0;
    else
        for (size_t i = 2; i < count; i++)
            put_triangle(field, &left[0], &left[i - 1], &left[i]);
}

static bool add_cells(struct height_field *field)
{
    size_t columns = field->heights.columns - 1;
    size_t rows = field->heights.rows - 1;
    field->triangles.count = 0;
    for (size_t i = 0; i < columns * rows; i++)
        for (int upper = 0; upper < 2; upper++)
            add_half(field, i % columns, i / columns, upper);
    return reader_spend(field->reader, TOKEN_COST * columns * rows);
}

static bool make_triangles(struct height_field *field)
{
    struct reader *reader = field->reader;
    size_t count;
    if (!add_cells(field))
        return false;
    count = field->triangles.count;
    if (!mesh_count(reader, count, field->at))
        return false;
    field->triangles.list = arena_take(&reader->scene->kept,
                                       (count + 1) * sizeof(struct triangle));
    return field->triangles.list ? add_cells(field) : reader_no_memory(reader);
}

/* ---- In the world -------------------------------------------------------- */

static void carry_normal(const struct transform *to_local, double normal[3])
{
    transform_normal(to_local, normal);
    scale3(1 / greatest3(normal), normal);
    scale3(1 / length3(normal), normal);
}

/* Moves triangles to world space. They are in a new list, because copies of the part
 * may share the old list. */
static bool place_triangles(struct reader *reader, const struct primitive *primitive,
                            struct triangles *triangles)
{
    size_t count = triangles->count;
    struct triangle *list = reader_keep(reader, triangles->list, count * sizeof *list);
    if (!list)
        return false;
    for (size_t i = 0; i < 3 * count; i++) {
        struct triangle *triangle = &list[i / 3];
        transform_point(&primitive->to_world, triangle->corners[i % 3]);
        if (triangle->smooth)
            carry_normal(&primitive->to_local, triangle->normals[i % 3]);
    }
    triangles->list = list;
    return true;
}

bool height_field_place(struct reader *reader, struct scene_part *part)
{
    struct primitive *primitive = &part->primitive;
    if (!place_triangles(reader, primitive, &primitive->shape.mesh.triangles)
        || !place_triangles(reader, primitive, &primitive->shape.mesh.body))
        return false;
    primitive->to_world = placement_none.to_world;
    primitive->to_local = placement_none.to_local;
    return true;
}

/* ---- The statement ------------------------------------------------------- */

static bool read_words(struct height_field *field)
{
    struct reader *reader = field->reader;
    for (;;)
        if (reader_accept(reader, "smooth"))
            field->smooth = true;
        else if (!reader_accept(reader, "water_level"))
            return true;
        else if (!read_number(reader, &field->water))
            return false;
}

static bool add_mesh(const struct height_field *field, struct scene_object *object)
{
    struct scene_part *part;
    if (!mesh_object_add(field->reader, object, &field->triangles, field->at,
                         "the height_field is below its water_level"))
        return false;
    part = &object->parts[object->part_count - 1];
    part->field = part->primitive.kind == PRIMITIVE_MESH;
    part->smooth_field = part->field && field->smooth;
    return true;
}

bool height_field_read(struct reader *reader, struct scene_object *object,
                       const struct scene_token *at)
{
    struct height_field field = { .reader = reader, .at = at };
    bool done = heights_read(reader, &field.heights) && read_words(&field)
                && make_triangles(&field) && add_mesh(&field, object);
    free(field.heights.list);
    return done;
}
