/* plain_area.c - areas and centroids of surfaces as sums over grids (plain_area.h). */
#include "tests/oracle/plain_area.h"

#include <stddef.h>

#include "rt/scene/transform.h"
#include "tests/oracle/plain_shapes.h"

#define TURN 6.28318530717958647692

/* Computes the point of a piece of the surface at the parameters u and v, in local
 * space. Both parameters are in [0, 1]. */
typedef void place_point(const struct primitive *primitive, size_t piece, double u,
                         double v, double point[3]);
#define UNUSED __attribute__((unused))
#define PLACE(name) \
    static void name(const struct primitive *primitive, size_t piece UNUSED, double u, \
                     double v, double point[3])

/* ---- The kinds ------------------------------------------------------------ */

PLACE(place_sphere)
{
    double r = primitive->shape.sphere.radius;
    const double on[3] = { sin(TURN / 2 * u) * cos(TURN * v), cos(TURN / 2 * u),
                           sin(TURN / 2 * u) * sin(TURN * v) };
    add_scaled(point, primitive->shape.sphere.center, r, on);
}

PLACE(place_torus)
{
    struct torus torus = torus_of(primitive);
    double from_axis = torus.major + torus.radial * cos(TURN * u);
    point[0] = from_axis * cos(TURN * v);
    point[1] = torus.axial * sin(TURN * u);
    point[2] = from_axis * sin(TURN * v);
}

/* Computes a point of the circle about `center` perpendicular to the axis. */
static void place_on_circle(const double center[3], const double axis[3], double radius,
                            double v, double point[3])
{
    double across[3] = { 0, 0, 0 }, first[3], second[3];
    int least = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(axis[i]) < fabs(axis[least]))
            least = i;
    across[least] = 1;
    cross_product(axis, across, first);
    normalise(first);
    cross_product(axis, first, second);
    normalise(second);
    add_scaled(point, center, radius * cos(TURN * v), first);
    add_scaled(point, point, radius * sin(TURN * v), second);
}

/* Computes a point on the side, or on the disc of the base or the cap. */
PLACE(place_cone)
{
    struct round cone = round_of(primitive);
    double axis[3], center[3];
    double along = piece == 0 ? u : piece == 1 ? 0 : 1;
    double radius = (1 - along) * cone.base_radius + along * cone.cap_radius;
    add_scaled(axis, cone.cap, -1, cone.base);
    add_scaled(center, cone.base, along, axis);
    place_on_circle(center, axis, piece == 0 ? radius : radius * u, v, point);
}

PLACE(place_disc)
{
    double hole = primitive->shape.disc.hole;
    place_on_circle(primitive->shape.disc.center, primitive->shape.disc.normal,
                    hole + u * (primitive->shape.disc.radius - hole), v, point);
}

PLACE(place_box)
{
    const double(*corner)[3] = primitive->shape.box.corner;
    size_t axis = piece / 2, j = (axis + 1) % 3, k = (axis + 2) % 3;
    point[axis] = corner[piece % 2][axis];
    point[j] = corner[0][j] + u * (corner[1][j] - corner[0][j]);
    point[k] = corner[0][k] + v * (corner[1][k] - corner[0][k]);
}

PLACE(place_mesh)
{
    const double(*corners)[3] =
        (const double(*)[3])primitive->shape.mesh.triangles.list[piece].corners;
    for (int i = 0; i < 3; i++)
        point[i] = (1 - u) * corners[0][i]
                   + u * ((1 - v) * corners[1][i] + v * corners[2][i]);
}

PLACE(place_steiner_patch)
{
    double s = u * (1 - v), t = u * v, rest = 1 - u, sum = 0;
    const double basis[STEINER_POINTS] = { s * s,     t * t,        rest * rest,
                                           2 * s * t, 2 * t * rest, 2 * rest * s };
    point[0] = point[1] = point[2] = 0;
    for (int k = 0; k < STEINER_POINTS; k++) {
        double share = basis[k] * primitive->shape.steiner_patch.weights[k];
        sum += share;
        add_scaled(point, point, share, primitive->shape.steiner_patch.points[k]);
    }
    scale_by(point, 1 / sum);
}

/* ---- Grids ---------------------------------------------------------------- */

struct surface_grid {
    const struct primitive *primitive;
    place_point *place;
    size_t pieces, cells; /* numbers of pieces, and of cells of a piece along u and
                           * along v */
};

static struct surface_grid grid_over(const struct primitive *primitive)
{
    static place_point *const places[PRIMITIVE_KINDS] = {
        [PRIMITIVE_SPHERE] = place_sphere,
        [PRIMITIVE_TORUS] = place_torus,
        [PRIMITIVE_ELLIPTICAL_TORUS] = place_torus,
        [PRIMITIVE_CYLINDER] = place_cone,
        [PRIMITIVE_CONE] = place_cone,
        [PRIMITIVE_DISC] = place_disc,
        [PRIMITIVE_BOX] = place_box,
        [PRIMITIVE_MESH] = place_mesh,
        [PRIMITIVE_STEINER_PATCH] = place_steiner_patch,
    };
    struct surface_grid grid = { primitive, places[primitive->kind], 1, 100 };
    if (primitive->kind == PRIMITIVE_BOX)
        grid.pieces = 6;
    else if (primitive->kind == PRIMITIVE_MESH)
        grid.pieces = primitive->shape.mesh.triangles.count;
    else if (primitive->kind == PRIMITIVE_CYLINDER || primitive->kind == PRIMITIVE_CONE)
        grid.pieces = round_of(primitive).open ? 1 : 3;
    return grid;
}

static void place_in_world(const struct surface_grid *grid, size_t piece, size_t i,
                           size_t j, double point[3])
{
    grid->place(grid->primitive, piece, (double)i / (double)grid->cells,
                (double)j / (double)grid->cells, point);
    transform_point(&grid->primitive->to_world, point);
}

/* Adds the area of a cell: the quadrilateral of its corners. */
static void add_cell(const struct surface_grid *grid, size_t piece, size_t i, size_t j,
                     struct plain_area *sum)
{
    double corner[4][3], diagonals[2][3], product[3], area;
    for (size_t k = 0; k < 4; k++)
        place_in_world(grid, piece, i + k % 2, j + k / 2, corner[k]);
    add_scaled(diagonals[0], corner[3], -1, corner[0]);
    add_scaled(diagonals[1], corner[2], -1, corner[1]);
    cross_product(diagonals[0], diagonals[1], product);
    area = sqrt(dot(product, product)) / 2;
    sum->area += area;
    for (size_t k = 0; k < 4; k++)
        add_scaled(sum->middle, sum->middle, area / 4, corner[k]);
}

static struct plain_area sum_cells(const struct surface_grid *grid)
{
    struct plain_area sum = { 0, { 0, 0, 0 } };
    for (size_t piece = 0; piece < grid->pieces; piece++)
        for (size_t i = 0; i < grid->cells; i++)
            for (size_t j = 0; j < grid->cells; j++)
                add_cell(grid, piece, i, j, &sum);
    return sum;
}

/* Removes the quadratic error of the cell size by Richardson extrapolation. */
struct plain_area plain_area(const struct primitive *primitive)
{
    struct surface_grid grid = grid_over(primitive);
    struct plain_area coarse = sum_cells(&grid), fine;
    grid.cells *= 2;
    fine = sum_cells(&grid);
    fine.area = (4 * fine.area - coarse.area) / 3;
    for (int i = 0; i < 3; i++)
        fine.middle[i] = (4 * fine.middle[i] - coarse.middle[i]) / (3 * fine.area);
    return fine;
}
