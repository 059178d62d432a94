/* scene_mesh.c - parses triangle, smooth_triangle and mesh. Each of them becomes one
 * primitive. */
#include "rt/scene/language/scene_mesh.h"

#include "base/array.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"

#include <stdlib.h>
#include <string.h>

/* POV-Ray's EPSILON. A normal counts as 0 if all components are below it. Two normals
 * are equal if their squared distance is below it. */
#define NORMAL_SAME 1e-10

/* ---- Normals ------------------------------------------------------------- */

/* Normalises a vector. Returns false if it is 0. */
static bool make_unit(double normal[3])
{
    double size = greatest3(normal);
    if (size == 0)
        return false;
    for (int i = 0; i < 3; i++)
        normal[i] /= size;
    scale3(1 / length3(normal), normal);
    return true;
}

/* Replaces a zero normal and warns, as POV-Ray does. */
void mesh_direct(struct reader *reader, const struct scene_token *at, double normal[3])
{
    bool none = true;
    for (int i = 0; i < 3; i++)
        none = none && fabs(normal[i]) < NORMAL_SAME;
    if (none) {
        reader_report(reader, at, "a normal of a mesh is 0; <1, 0, 0> is used instead");
        for (int i = 0; i < 3; i++)
            normal[i] = i == 0;
    }
    make_unit(normal);
}

/* Returns true if the normals of a triangle differ. As in POV-Ray, a triangle with
 * three equal normals is flat, whatever their direction. */
bool mesh_is_smooth(const struct triangle *triangle)
{
    const double(*normals)[3] = triangle->normals;
    for (int k = 1; k < 3; k++) {
        double apart[3];
        subtract3(normals[0], normals[k], apart);
        if (dot3(apart, apart) > NORMAL_SAME)
            return true;
    }
    return false;
}

/* ---- Textures of triangles ----------------------------------------------- */

static bool has_bumps(const struct bumps *own, const struct bumps *other)
{
    return own->list == other->list && own->unscaled == other->unscaled
           && !memcmp(&own->to_local, &other->to_local, sizeof own->to_local);
}

static bool has_texture(const struct primitive *primitive,
                        const struct texture *texture)
{
    const struct pigment *own = &primitive->pigment;
    const struct pigment *other = &texture->pigment;
    size_t numbers = offsetof(struct pigment, color); /* color and all members after
                                                       * it */

    return own->kind == other->kind
           && !memcmp(own->color, other->color, sizeof *own - numbers)
           && !memcmp(&primitive->finish, &texture->finish, sizeof texture->finish)
           && has_bumps(&primitive->bumps, &texture->bumps);
}

void mesh_look(struct mesh_reading *mesh, const struct texture *texture,
               const struct scene_token *at)
{
    struct scene_part *part = mesh->object.parts;
    mesh->looked = true;
    if (part->textured) {
        mesh->differ |= !has_texture(&part->primitive, texture);
        return;
    }
    mesh->look_at = *at;
    part->textured = true;
    part->primitive.pigment = texture->pigment;
    part->primitive.bumps = texture->bumps;
    part->primitive.finish = texture->finish;
}

/* ---- A mesh -------------------------------------------------------------- */

bool mesh_begin(struct reader *reader, struct mesh_reading *mesh,
                const struct item *item)
{
    struct primitive primitive;
    *mesh = (struct mesh_reading){ .at = item->at };
    memset(&primitive, 0, sizeof primitive);
    primitive.kind = PRIMITIVE_MESH;
    return shape_add(reader, &mesh->object, &primitive, &item->at);
}

size_t mesh_triangles(const struct scene_object *object)
{
    size_t count = 0;
    for (size_t i = 0; i < object->part_count; i++) {
        const struct primitive *primitive = &object->parts[i].primitive;
        if (primitive->kind == PRIMITIVE_MESH)
            count += primitive->shape.mesh.triangles.count
                     + primitive->shape.mesh.body.count;
    }
    return count;
}

bool mesh_count(struct reader *reader, size_t more, const struct scene_token *at)
{
    reader->triangles += more;
    return reader->triangles <= MAX_TRIANGLES
           || reader_fault(reader, at, "more than %d triangles, including copies",
                           MAX_TRIANGLES);
}

bool mesh_add(struct reader *reader, struct mesh_reading *mesh,
              const struct triangle *triangle, const struct scene_token *at)
{
    struct triangles *triangles = &mesh->triangles;
    if (!mesh_count(reader, 1, at))
        return false;
    if (!array_add(&triangles->list, &triangles->count, triangle, sizeof *triangle))
        return reader_no_memory(reader);
    mesh->looks += mesh->looked;
    mesh->looked = false;
    return true;
}

bool mesh_keep_triangle(struct reader *reader, struct triangles *triangles,
                        size_t *capacity, const struct triangle *triangle,
                        const struct scene_token *at)
{
    return mesh_count(reader, 1, at)
           && (arena_add(&reader->scene->kept, &triangles->list, &triangles->count,
                         capacity, triangle, sizeof *triangle)
               || reader_no_memory(reader));
}

bool mesh_object_add(struct reader *reader, struct scene_object *object,
                     const struct triangles *triangles, const struct scene_token *at,
                     const char *reason)
{
    struct primitive primitive;
    memset(&primitive, 0, sizeof primitive);
    primitive.kind = PRIMITIVE_MESH;
    primitive.shape.mesh.triangles = *triangles;
    return shapes[PRIMITIVE_MESH]->finish(&primitive)
               ? shape_leave_out(reader, object, at, reason)
               : shape_add(reader, object, &primitive, at);
}

/* Removes an invisible mesh. This is reported, but it is not an error. */
static bool leave_out(struct reader *reader, struct mesh_reading *mesh)
{
    primitive_leave_out(reader, &mesh->object.parts->primitive, &mesh->at,
                        mesh->lone ? "the triangle has no area, or a normal that is 0"
                                   : "no triangle of the mesh has an area");
    return true;
}

/* Copies the triangles of a mesh to storage that the scene owns. */
static bool keep(struct reader *reader, struct mesh_reading *mesh)
{
    struct primitive *primitive = &mesh->object.parts->primitive;
    size_t count = mesh->triangles.count;
    struct triangle *list;
    const char *fault;
    if (count == 0)
        return leave_out(reader, mesh);
    list = reader_keep(reader, mesh->triangles.list, count * sizeof *list);
    if (!list)
        return false;
    primitive->shape.mesh.triangles = (struct triangles){ count, list };
    fault = shapes[PRIMITIVE_MESH]->finish(primitive);
    if (fault)
        return leave_out(reader, mesh);
    /* In POV-Ray the texture of a triangle overrides the texture of the mesh. */
    if (mesh->differ || mesh->looks != mesh->triangles.count)
        shape_choose_texture(reader, &mesh->object, &mesh->look_at, "mesh triangles",
                             "the texture of the mesh");
    return true;
}

bool mesh_end(struct reader *reader, struct mesh_reading *mesh, bool good,
              struct scene_object *object)
{
    bool done = good && keep(reader, mesh);
    free(mesh->triangles.list);
    *object = mesh->object;
    return done;
}

bool mesh_close(struct reader *reader, const struct block *block, bool good)
{
    if (good && !reader_at_sign(reader, '}'))
        good = reader_expected(reader, "'}'");
    return block_finish(reader, block) && good;
}

/* ---- Keywords of a mesh -------------------------------------------------- */

static bool read_corners(struct reader *reader, bool smooth, struct triangle *triangle)
{
    size_t each = smooth ? 2 : 1; /* a corner, and its normal */
    double vectors[6][3];
    *triangle = (struct triangle){ .smooth = smooth };
    if (!read_vectors(reader, vectors, 3 * each))
        return false;
    for (size_t i = 0; i < 3; i++) {
        copy3(vectors[each * i], triangle->corners[i]);
        if (smooth)
            copy3(vectors[each * i + 1], triangle->normals[i]);
    }
    return true;
}

/* Skips uv coordinates, which are not used. */
static bool read_uv_vectors(struct reader *reader, const struct item *item)
{
    double ignored[3][3];
    (void)item;
    return read_vectors(reader, ignored, 3);
}

static bool read_texture(struct reader *reader, const struct item *item)
{
    struct texture texture = reader->default_texture;
    if (!texture_read(reader, &texture))
        return false;
    mesh_look(item->subject, &texture, &item->at);
    return true;
}

/* Reads the names of three textures, one for each corner of a triangle. */
static bool read_names(struct reader *reader, struct mesh_reading *mesh,
                       const struct item *item)
{
    for (int i = 0; i < 3; i++) {
        const struct scene_value *value = reader_use(reader, VALUE_TEXTURE);
        if (!value)
            return reader_expected(reader, "the name of a texture");
        mesh_look(mesh, &value->is.texture, &item->at);
        reader_next(reader);
        reader_comma(reader);
    }
    return true;
}

static bool read_texture_list(struct reader *reader, const struct item *item)
{
    struct block block;
    return block_open(reader, &block, '{')
           && mesh_close(reader, &block, read_names(reader, item->subject, item));
}

static const struct keyword triangle_words[] = {
    { "uv_vectors", read_uv_vectors, 0 },
    { "texture", read_texture, 0 },
    { "texture_list", read_texture_list, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar triangle_grammar = { "a keyword of a mesh triangle",
                                                 .tables = { triangle_words } };

/* Reads a triangle. The keyword's detail is true for smooth_triangle. */
static bool read_triangle(struct reader *reader, const struct item *item)
{
    bool smooth = item->keyword->detail;
    struct mesh_reading *mesh = item->subject;
    struct triangle triangle;
    struct block block;
    bool good;
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_corners(reader, smooth, &triangle);
    if (!block_items(reader, &block, &triangle_grammar, mesh, good))
        return false;
    for (int i = 0; i < 3 && smooth; i++)
        mesh_direct(reader, &item->at, triangle.normals[i]);
    triangle.smooth = smooth && mesh_is_smooth(&triangle);
    return mesh_add(reader, mesh, &triangle, &item->at);
}

/* Makes a mesh solid if it has an inside_vector. As in POV-Ray, a zero vector has no
 * effect. */
bool read_inside_vector(struct reader *reader, const struct item *item)
{
    struct mesh_reading *mesh = item->subject;
    double vector[3];
    if (!read_vector(reader, vector))
        return false;
    mesh->object.parts->primitive.shape.mesh.solid = greatest3(vector) >= NORMAL_SAME;
    return true;
}

static const struct keyword mesh_words[] = {
    { "triangle", read_triangle, false },
    { "smooth_triangle", read_triangle, true },
    { "inside_vector", read_inside_vector, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar mesh_grammar = { "a triangle or an object modifier",
                                             { mesh_words },
                                             .then = &modifier_grammar };

/* ---- The statements ------------------------------------------------------ */

/* Reads a triangle that is not inside a mesh. As in POV-Ray, it stays smooth even if
 * its three normals are equal. */
static bool read_lone(struct reader *reader, struct mesh_reading *mesh, bool smooth)
{
    struct triangle triangle;
    bool seen = true;
    mesh->lone = true;
    if (!read_corners(reader, smooth, &triangle))
        return false;
    for (int i = 0; i < 3 && smooth; i++)
        seen = make_unit(triangle.normals[i]) && seen;
    return !seen || mesh_add(reader, mesh, &triangle, &mesh->at);
}

bool mesh_read(struct reader *reader, struct scene_object *object,
               const struct item *item)
{
    enum shape_word shape = (enum shape_word)item->keyword->detail;
    bool lone = shape != (enum shape_word)PRIMITIVE_MESH;
    struct mesh_reading mesh;
    struct block block;
    bool good;
    if (shape == SHAPE_MESH2)
        return mesh2_read(reader, object, item);
    if (!mesh_begin(reader, &mesh, item) || !block_open(reader, &block, '{'))
        return mesh_end(reader, &mesh, false, object);
    good = !lone || read_lone(reader, &mesh, shape == SHAPE_SMOOTH_TRIANGLE);
    good = block_items(reader, &block, lone ? &modifier_grammar : &mesh_grammar, &mesh,
                       good);
    return mesh_end(reader, &mesh, good, object);
}
