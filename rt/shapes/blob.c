/* blob.c - the descriptor of blobs: checks their arguments, computes their bounds and
 * the words of their records, and names their kernels. */
#include "rt/shapes/blob.h"

#include <math.h>
#include <string.h>

#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"

/* rt/scene/language/scene_blob.c parses the arguments. */
static const struct shape_field fields[] = {
    { TAKES_END, 0, NULL, 0, NULL },
};

/* Removes components without strength or radius, which do not contribute to the
 * field. */
static const char *finish(struct primitive *primitive)
{
    struct blob_parts *parts = &primitive->shape.blob.parts;
    size_t kept = 0;
    double most = 0;
    for (size_t i = 0; i < parts->count; i++) {
        if (parts->list[i].strength == 0 || parts->list[i].radius == 0)
            continue;
        most += fmax(0, parts->list[i].strength);
        parts->list[kept++] = parts->list[i];
    }
    parts->count = kept;
    if (primitive->shape.blob.threshold <= 0)
        return shape_empty(primitive, "the threshold is not above 0");
    return most >= primitive->shape.blob.threshold
               ? NULL
               : shape_empty(primitive, "the components of the blob never reach its "
                                        "threshold");
}

/* ---- Bound --------------------------------------------------------------- */

/* Bounds a sphere that is in the space of a component. `placed` maps this space to the
 * world. */
static void bound_ball(const double center[3], double radius,
                       const struct transform *placed, struct bound *bound)
{
    struct primitive ball;
    memset(&ball, 0, sizeof ball);
    ball.kind = PRIMITIVE_SPHERE;
    copy3(center, ball.shape.sphere.center);
    ball.shape.sphere.radius = radius;
    ball.to_world = *placed;
    shapes[PRIMITIVE_SPHERE]->bound(&ball, bound);
}

static void bound_part(const struct blob_part *part, const struct transform *placed,
                       struct bound *bound)
{
    struct transform to_there = transform_then(&part->to_blob, placed);
    struct bound ends[2];
    bound_ball(part->base, part->radius, &to_there, &ends[0]);
    bound_ball(part->cylinder ? part->cap : part->base, part->radius, &to_there,
               &ends[1]);
    bound_enclose(ends, 2, bound);
}

/* Bounds the components of positive strength. Those of negative strength only shrink
 * the surface. */
static void bound_parts(const struct primitive *primitive,
                        const struct transform *placed, struct bound *bound)
{
    const struct blob_parts *parts = &primitive->shape.blob.parts;
    enum { AT_A_TIME = 256 };
    struct bound bounds[AT_A_TIME];
    size_t count = 0;
    for (size_t i = 0; i < parts->count; i++) {
        if (parts->list[i].strength <= 0)
            continue;
        if (count == AT_A_TIME) {
            bound_enclose(bounds, count, bound);
            bounds[0] = *bound;
            count = 1;
        }
        bound_part(&parts->list[i], placed, &bounds[count++]);
    }
    bound_enclose(bounds, count, bound);
}

static void put_bound(const struct primitive *primitive, struct bound *bound)
{
    bound_parts(primitive, &primitive->to_world, bound);
}

/* ---- Crossings of a ray -------------------------------------------------- */

static bool takes_away(const struct blob_parts *parts)
{
    for (size_t i = 0; i < parts->count; i++)
        if (parts->list[i].strength < 0)
            return true;
    return false;
}

/* Returns the largest number of segments of a ray inside the blob. A ray enters and
 * leaves each component; in a cylinder it also passes two boundaries between three
 * pieces. Between two successive events of this kind the field along the ray is a
 * quartic. A quartic has one segment above the threshold, or up to two segments if a
 * component has negative strength. */
static size_t segments(const struct primitive *primitive)
{
    const struct blob_parts *parts = &primitive->shape.blob.parts;
    size_t events = 0;
    for (size_t i = 0; i < parts->count; i++)
        events += parts->list[i].cylinder ? 4 : 2;
    return (events - 1) * (takes_away(parts) ? 2 : 1);
}

size_t blob_pieces(const struct primitive *primitive)
{
    const struct blob_parts *parts = &primitive->shape.blob.parts;
    size_t pieces = 0;
    for (size_t i = 0; i < parts->count; i++)
        pieces += parts->list[i].cylinder ? 3 : 1;
    return pieces;
}

size_t blob_pieces_most(const struct scene *scene)
{
    size_t most = 0;
    for (size_t i = 0; i < scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        if (primitive->kind == PRIMITIVE_BLOB && blob_pieces(primitive) > most)
            most = blob_pieces(primitive);
    }
    return most;
}

/* ---- Words and table ----------------------------------------------------- */

/* The fields of a row of the table, as in records.s. */
enum {
    ROW_KIND,
    ROW_CENTER,
    ROW_SQUARE = ROW_CENTER + 3,
    ROW_INVERSE,
    ROW_STRENGTH,
    ROW_LENGTH,
    ROW_MATRIX,
    ROW = ROW_MATRIX + 12
};
enum part_kind { BALL, ELLIPSOID, CYLINDER };

/* Bounds the blob in the blob's own space. */
static void find_center(const struct primitive *primitive, struct bound *bound)
{
    bound_parts(primitive, &placement_none.to_world, bound);
}

static size_t put_words(const struct primitive *primitive, double *words)
{
    struct bound bound;
    double radius;
    find_center(primitive, &bound);
    radius = 1.001 * bound.radius;
    copy3(bound.center, words);
    words[3] = radius * radius;
    words[4] = primitive->shape.blob.threshold;
    words[5] = (double)primitive->shape.blob.parts.count;
    words[6] = radius * ROOT_RESOLUTION;
    return 7;
}

/* Returns true if the transform is a translation. */
static bool keeps_balls(const struct transform *transform)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (transform->rows[i][j] != (i == j))
                return false;
    return true;
}

/* Computes three orthogonal unit vectors; the last is along the axis of a cylinder. */
static void put_axes(const struct blob_part *part, double axes[3][3])
{
    int across;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            axes[i][j] = i == j;
    if (!part->cylinder)
        return;
    subtract3(part->cap, part->base, axes[2]);
    scale3(1 / length3(axes[2]), axes[2]);
    across = fabs(axes[2][0]) < .7 ? 0 : 1;
    axes[0][0] = across == 0 ? 1 : 0;
    axes[0][1] = across == 1 ? 1 : 0;
    cross3(axes[2], axes[0], axes[1]);
    scale3(1 / length3(axes[1]), axes[1]);
    cross3(axes[1], axes[2], axes[0]);
}

/* Computes the matrix from points relative to the blob's centre to a component's
 * normalised space. There the radius is 1, the base is the origin, and a cylinder's
 * axis is z. */
static void put_matrix(const struct blob_part *part, const double center[3],
                       double *matrix)
{
    double axes[3][3], origin[3];
    put_axes(part, axes);
    copy3(center, origin);
    transform_point(&part->to_local, origin);
    subtract3(origin, part->base, origin);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                matrix[4 * i + j] += axes[i][k] * part->to_local.rows[k][j]
                                     / part->radius;
        matrix[4 * i + 3] = dot3(axes[i], origin) / part->radius;
    }
}

static void put_component(const struct blob_part *part, const double center[3],
                          double *row)
{
    double axis[3];
    row[ROW_KIND] = part->cylinder                 ? CYLINDER
                    : keeps_balls(&part->to_local) ? BALL
                                                   : ELLIPSOID;
    copy3(part->base, row + ROW_CENTER);
    transform_point(&part->to_blob, row + ROW_CENTER);
    subtract3(row + ROW_CENTER, center, row + ROW_CENTER);
    row[ROW_SQUARE] = part->radius * part->radius;
    row[ROW_INVERSE] = 1 / row[ROW_SQUARE];
    row[ROW_STRENGTH] = part->strength;
    subtract3(part->cap, part->base, axis);
    row[ROW_LENGTH] = part->cylinder ? length3(axis) / part->radius : 0;
    put_matrix(part, center, row + ROW_MATRIX);
}

static size_t put_table(const struct primitive *primitive,
                        const struct viewpoints *viewpoints, double *table)
{
    const struct blob_parts *parts = &primitive->shape.blob.parts;
    struct bound bound;
    (void)viewpoints;
    if (table) {
        find_center(primitive, &bound);
        for (size_t i = 0; i < parts->count; i++)
            put_component(&parts->list[i], bound.center, table + ROW * i);
    }
    return ROW * parts->count;
}

const struct shape shape_blob = {
    .fields = fields,
    .finish = finish,
    .povray = true,
    .bound = put_bound,
    .words = put_words,
    .table = put_table,
    .segments = segments,
    .region = "blob",
    .kernels = { .kernel = "blob",
                 .normal = "normal_blob",
                 .segments = 1,
                 .solid = "blob_solid" },
};
