/* transform.c - composes, inverts and applies affine maps. */
#include "rt/scene/transform.h"

#include "rt/scene/elementary.h"
#include "rt/scene/vector3.h"

#include <math.h>
#include <string.h>

/* clang-format off */
#define IDENTITY { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } }
/* clang-format on */

const struct placement placement_none = { IDENTITY, IDENTITY };

void transform_direction(const struct transform *transform, double vector[3])
{
    double turned[3];
    for (int i = 0; i < 3; i++)
        turned[i] = dot3(transform->rows[i], vector);
    memcpy(vector, turned, sizeof turned);
}

void transform_point(const struct transform *transform, double point[3])
{
    transform_direction(transform, point);
    for (int i = 0; i < 3; i++)
        point[i] += transform->rows[i][3];
}

void transform_normal(const struct transform *to_local, double normal[3])
{
    double carried[3];
    for (int i = 0; i < 3; i++)
        carried[i] = to_local->rows[0][i] * normal[0] + to_local->rows[1][i] * normal[1]
                     + to_local->rows[2][i] * normal[2];
    memcpy(normal, carried, sizeof carried);
}

struct transform transform_then(const struct transform *first,
                                const struct transform *second)
{
    struct transform both;
    for (int j = 0; j < 4; j++) {
        double column[3];
        for (int i = 0; i < 3; i++)
            column[i] = first->rows[i][j];
        if (j < 3)
            transform_direction(second, column);
        else
            transform_point(second, column);
        for (int i = 0; i < 3; i++)
            both.rows[i][j] = column[i];
    }
    return both;
}

struct placement placement_then(const struct placement *first,
                                const struct placement *step)
{
    struct placement both;
    both.to_world = transform_then(&first->to_world, &step->to_world);
    both.to_local = transform_then(&step->to_local, &first->to_local);
    return both;
}

struct placement placement_inverse(const struct placement *placement)
{
    struct placement inverse;
    inverse.to_world = placement->to_local;
    inverse.to_local = placement->to_world;
    return inverse;
}

struct placement placement_translation(const double by[3])
{
    struct placement placement = placement_none;
    for (int i = 0; i < 3; i++) {
        placement.to_world.rows[i][3] = by[i];
        placement.to_local.rows[i][3] = -by[i];
    }
    return placement;
}

struct placement placement_scaling(const double by[3])
{
    struct placement placement = placement_none;
    for (int i = 0; i < 3; i++) {
        placement.to_world.rows[i][i] = by[i];
        placement.to_local.rows[i][i] = 1 / by[i];
    }
    return placement;
}

static struct placement rotation_about(int axis, double degrees)
{
    struct placement placement = placement_none;
    double angle = degrees * (PI / 180), c = elementary_cos(angle),
           s = elementary_sin(angle);
    int a = (axis + 1) % 3, b = (axis + 2) % 3;
    placement.to_world.rows[a][a] = placement.to_local.rows[a][a] = c;
    placement.to_world.rows[b][b] = placement.to_local.rows[b][b] = c;
    placement.to_world.rows[a][b] = placement.to_local.rows[b][a] = -s;
    placement.to_world.rows[b][a] = placement.to_local.rows[a][b] = s;
    return placement;
}

struct placement placement_rotation(const double degrees[3])
{
    struct placement all = placement_none;
    for (int axis = 0; axis < 3; axis++) {
        struct placement one = rotation_about(axis, degrees[axis]);
        all = placement_then(&all, &one);
    }
    return all;
}

/* Computes each row of the inverse as the cross product of two columns of the map,
 * divided by the determinant. */
bool transform_invert(const struct transform *map, struct transform *inverse)
{
    double column[3][3], shift[3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            column[j][i] = map->rows[i][j];
    for (int i = 0; i < 3; i++) {
        double row[3];
        cross3(column[(i + 1) % 3], column[(i + 2) % 3], row);
        double determinant = dot3(row, column[i]);
        if (determinant == 0)
            return false;
        for (int j = 0; j < 3; j++)
            inverse->rows[i][j] = row[j] / determinant;
        inverse->rows[i][3] = 0;
        shift[i] = -map->rows[i][3];
    }
    transform_direction(inverse, shift);
    for (int i = 0; i < 3; i++)
        inverse->rows[i][3] = shift[i];
    return true;
}

bool placement_matrix(const double values[12], struct placement *placement)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            placement->to_world.rows[i][j] = values[3 * j + i];
    return transform_invert(&placement->to_world, &placement->to_local);
}

bool placement_is_none(const struct placement *placement)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            if (placement->to_world.rows[i][j] != placement_none.to_world.rows[i][j])
                return false;
    return true;
}

bool placement_is_finite(const struct placement *placement)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            if (!isfinite(placement->to_world.rows[i][j])
                || !isfinite(placement->to_local.rows[i][j]))
                return false;
    return true;
}
