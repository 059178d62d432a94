/* bicubic_patch.c - parses and tessellates bicubic_patch, a Bezier patch of 4 x 4
 * points.
 *
 * As in POV-Ray, a piece is halved in u and in v until it is flat or the limit of
 * halvings is reached. It then becomes two triangles. Flatness is a distance in world
 * space, so the patch is divided after its transform is final.
 */
#include "rt/scene/language/scene_statement.h"

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_mesh.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"

#include <string.h>

/* POV-Ray's tolerances. Corners closer than CORNER_SAME are equal. A cross product
 * counts as 0 if its square is below NO_AREA times the squares of its factors. */
#define CORNER_SAME 1e-10
#define NO_AREA 1e-10

enum { MAX_STEPS = 20 };

/* The keywords before the points. */
enum patch_word { PATCH_TYPE, PATCH_FLATNESS, PATCH_U, PATCH_V, PATCH_WORDS };
static const char *const patch_words[PATCH_WORDS] = { "type", "flatness", "u_steps",
                                                      "v_steps" };

/* The control points at[i][j]: i is the index along u, j along v. */
struct patch_points {
    double at[4][4][3];
};

struct bicubic_patch {
    bool given[PATCH_WORDS];
    double numbers[PATCH_WORDS];
    struct patch_points points;
};

/* The state of a tessellation. */
struct patch_cutting {
    struct reader *reader;
    const struct scene_token *at;
    const struct bicubic_patch *patch;
    struct patch_points points; /* in world space */
    struct triangles triangles;
    size_t capacity; /* capacity of the triangles */
};

/* A piece of a patch: its control points and its range of parameters. */
struct piece {
    struct patch_points points;
    double from[2], to[2]; /* range of u and v */
    int depth;
};

/* ---- The surface --------------------------------------------------------- */

/* Computes the weights of the four control points of a Bezier curve at t, and the
 * weights of their three differences in the derivative at t. */
static void weigh(double t, double points[4], double differences[3])
{
    double s = 1 - t;
    points[0] = s * s * s;
    points[1] = 3 * t * s * s;
    points[2] = 3 * t * t * s;
    points[3] = t * t * t;
    differences[0] = 3 * s * s;
    differences[1] = 6 * t * s;
    differences[2] = 3 * t * t;
}

/* Computes the unit vector of the cross product. Returns false if the vectors are
 * parallel, or if one of them is 0. */
static bool unit_product(const double a[3], const double b[3], double product[3])
{
    double square;
    cross3(a, b, product);
    square = dot3(product, product);
    if (!(square > NO_AREA * dot3(a, a) * dot3(b, b)))
        return false;
    scale3(1 / sqrt(square), product);
    return true;
}

/* Computes the unit normal. As in POV-Ray, it is the x axis where the patch has no
 * normal. */
static void patch_normal(const struct patch_points *points, double u, double v,
                         double normal[3])
{
    static const double none[3] = { 1, 0, 0 };
    const double(*at)[4][3] = points->at;
    double weights[2][4], slopes[2][3], along[2][3] = { { 0 }, { 0 } };
    weigh(u, weights[0], slopes[0]);
    weigh(v, weights[1], slopes[1]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 3; k++) {
                along[0][k] += slopes[0][i] * weights[1][j]
                               * (at[i + 1][j][k] - at[i][j][k]);
                along[1][k] += slopes[1][i] * weights[0][j]
                               * (at[j][i + 1][k] - at[j][i][k]);
            }
    if (!unit_product(along[0], along[1], normal))
        copy3(none, normal);
}

/* Returns true if all points are within the distance `flatness` of the plane of three
 * corners. */
static bool is_flat(const struct patch_points *points, double flatness)
{
    const double(*at)[4][3] = points->at;
    double edges[2][3], normal[3], way[3];
    subtract3(at[0][3], at[0][0], edges[0]);
    if (length3(edges[0]) < CORNER_SAME)
        subtract3(at[3][3], at[0][0], edges[0]);
    subtract3(at[3][0], at[0][0], edges[1]);
    if (!unit_product(edges[0], edges[1], normal))
        return false;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            subtract3(at[i][j], at[0][0], way);
            if (!(fabs(dot3(way, normal)) < flatness))
                return false;
        }
    return true;
}

/* ---- Pieces of a patch --------------------------------------------------- */

/* Returns point i of a row or column. `line` is the index of the row or column. */
static double *point_of(struct patch_points *points, int axis, int line, int i)
{
    return axis == 0 ? points->at[i][line] : points->at[line][i];
}

static void middle(const double a[3], const double b[3], double between[3])
{
    for (int i = 0; i < 3; i++)
        between[i] = (a[i] + b[i]) / 2;
}

/* Applies de Casteljau's algorithm at 1/2. Points a b c d become a ab abc abcd (lower
 * half) and abcd bcd cd d (upper half). */
static void halve_line(struct patch_points *low, struct patch_points *high, int axis,
                       int line)
{
    double *l[4], *h[4], bc[3];
    for (int i = 0; i < 4; i++) {
        l[i] = point_of(low, axis, line, i);
        h[i] = point_of(high, axis, line, i);
    }
    middle(h[1], h[2], bc);
    middle(h[2], h[3], h[2]);
    middle(l[0], l[1], l[1]);
    middle(l[1], bc, l[2]);
    middle(bc, h[2], h[1]);
    middle(l[2], h[1], l[3]);
    copy3(l[3], h[0]);
}

/* Halves a piece along an axis. The piece becomes the lower half. Returns the upper
 * half. */
static struct piece cut_off(struct piece *piece, int axis)
{
    struct piece high = *piece;
    double between = (piece->from[axis] + piece->to[axis]) / 2;
    for (int line = 0; line < 4; line++)
        halve_line(&piece->points, &high.points, axis, line);
    piece->to[axis] = high.from[axis] = between;
    return high;
}

/* ---- Triangles ----------------------------------------------------------- */

static void put_corner(const struct patch_cutting *cutting, const struct piece *piece,
                       bool u, bool v, struct triangle *triangle, int k)
{
    copy3(piece->points.at[u ? 3 : 0][v ? 3 : 0], triangle->corners[k]);
    patch_normal(&cutting->points, u ? piece->to[0] : piece->from[0],
                 v ? piece->to[1] : piece->from[1], triangle->normals[k]);
}

static bool add_triangle(struct patch_cutting *cutting, const struct triangle *triangle)
{
    return mesh_keep_triangle(cutting->reader, &cutting->triangles, &cutting->capacity,
                              triangle, cutting->at);
}

/* Adds two triangles. Their common edge connects the corners with the least and the
 * greatest parameters. */
static bool add_leaf(struct patch_cutting *cutting, const struct piece *piece)
{
    struct triangle triangle = { .smooth = true };
    put_corner(cutting, piece, false, false, &triangle, 0);
    put_corner(cutting, piece, false, true, &triangle, 1);
    put_corner(cutting, piece, true, true, &triangle, 2);
    if (!add_triangle(cutting, &triangle))
        return false;
    put_corner(cutting, piece, true, false, &triangle, 1);
    return add_triangle(cutting, &triangle);
}

static bool add_piece(struct patch_cutting *cutting, struct piece *piece)
{
    const double *numbers = cutting->patch->numbers;
    bool cut[2];
    struct piece parts[4];
    size_t count = 0;
    for (int axis = 0; axis < 2; axis++)
        cut[axis] = piece->depth < numbers[PATCH_U + axis];
    if (!reader_spend(cutting->reader, TOKEN_COST))
        return false;
    if ((!cut[0] && !cut[1]) || is_flat(&piece->points, numbers[PATCH_FLATNESS]))
        return add_leaf(cutting, piece);
    piece->depth++;
    parts[count++] = *piece;
    for (int axis = 0; axis < 2; axis++)
        for (size_t i = cut[axis] ? count : 0; i > 0; i--)
            parts[count++] = cut_off(&parts[i - 1], axis);
    for (size_t i = 0; i < count; i++)
        if (!add_piece(cutting, &parts[i]))
            return false;
    return true;
}

#define PATCH_HAS_NO_AREA "the patch has no area"

bool bicubic_patch_cut(struct reader *reader, struct scene_part *part,
                       const struct scene_token *at)
{
    struct primitive *primitive = &part->primitive;
    struct patch_cutting cutting = {
        .reader = reader, .at = at, .patch = part->patch, .points = part->patch->points
    };
    struct piece whole = { .to = { 1, 1 } };
    for (int i = 0; i < 16; i++)
        transform_point(&primitive->to_world, cutting.points.at[i / 4][i % 4]);
    primitive->to_world = placement_none.to_world;
    primitive->to_local = placement_none.to_local;
    whole.points = cutting.points;
    if (!add_piece(&cutting, &whole))
        return false;
    primitive->shape.mesh.triangles = cutting.triangles;
    if (shapes[PRIMITIVE_MESH]->finish(primitive))
        primitive_leave_out(reader, primitive, at, PATCH_HAS_NO_AREA);
    return true;
}

/* ---- The statement ------------------------------------------------------- */

static bool read_word(struct reader *reader, struct bicubic_patch *patch,
                      enum patch_word word)
{
    struct scene_token at = reader->token;
    double number;
    if (!read_number(reader, &number))
        return false;
    if (word != PATCH_FLATNESS)
        number = trunc(number);
    if (word == PATCH_TYPE && number < 0)
        return reader_fault(reader, &at, "the type of a patch must be at least 0");
    if ((word == PATCH_U || word == PATCH_V) && number > MAX_STEPS)
        return reader_fault(reader, &at, "'%s' must be at most %d", patch_words[word],
                            MAX_STEPS);
    patch->given[word] = true;
    patch->numbers[word] = number;
    return true;
}

/* Reads the keywords, in any order. The types differ in how much of the subdivision
 * POV-Ray stores; all types have the same picture. */
static bool read_words(struct reader *reader, struct bicubic_patch *patch)
{
    size_t word = 0;
    while (word < PATCH_WORDS) {
        if (!reader_accept(reader, patch_words[word])) {
            word++;
            continue;
        }
        if (!read_word(reader, patch, (enum patch_word)word))
            return false;
        word = 0;
    }
    return patch->given[PATCH_TYPE] || reader_expected(reader, "'type'");
}

static bool read_points(struct reader *reader, struct patch_points *points)
{
    double ignored[4][3];
    reader_comma(reader);
    if (reader_accept(reader, "uv_vectors") && !read_vectors(reader, ignored, 4))
        return false;
    reader_comma(reader);
    return read_vectors(reader, points->at[0], 16);
}

/* Returns true if all points are on a line. Such a patch is always invisible. */
static bool is_on_line(const struct patch_points *points)
{
    const double *at = points->at[0][0];
    double axis[3] = { 0 }, across[3], to[3];
    for (int i = 1; i < 16; i++) {
        subtract3(points->at[i / 4][i % 4], at, to);
        if (length3(to) > length3(axis))
            copy3(to, axis);
    }
    for (int i = 1; i < 16; i++) {
        subtract3(points->at[i / 4][i % 4], at, to);
        cross3(axis, to, across);
        if (length3(across) > 1e-14 * dot3(axis, axis))
            return false;
    }
    return true;
}

bool bicubic_patch_read(struct reader *reader, struct scene_object *object,
                        const struct scene_token *at)
{
    struct bicubic_patch *patch = arena_take(&reader->arena, sizeof *patch);
    struct primitive primitive;
    if (!patch)
        return reader_no_memory(reader);
    memset(&primitive, 0, sizeof primitive);
    primitive.kind = PRIMITIVE_MESH;
    if (!read_words(reader, patch) || !read_points(reader, &patch->points))
        return false;
    if (is_on_line(&patch->points))
        return shape_leave_out(reader, object, at, PATCH_HAS_NO_AREA);
    if (!shape_add(reader, object, &primitive, at))
        return false;
    object->parts->patch = patch;
    return true;
}
