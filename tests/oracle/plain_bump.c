/* plain_bump.c - normals changed by POV-Ray's bump patterns (plain_light.h). */
#include "tests/oracle/plain_light.h"

#include "tests/oracle/plain_shapes.h"

#include <math.h>

/* ---- Heights ------------------------------------------------------------- */

/* Interpolates between two ends with given slopes, by a cubic Hermite spline. */
static double between_ends(const struct slope_stop *a, const struct slope_stop *b,
                           double u)
{
    double v = 1 - u;
    return a->height * v * v * (1 + 2 * u) + b->height * u * u * (1 + 2 * v)
           + a->slope * u * v * v - b->slope * u * u * v;
}

static double height(const struct bump *bump, const double point[3])
{
    const struct slope_stop *stops = bump->stops;
    double value = plain_pattern(&bump->pattern, point);
    size_t last = bump->stop_count, k = 0;
    if (last == 0)
        return value;
    if (value < stops[0].at)
        return stops[0].height;
    while (k + 1 < last && stops[k + 1].at <= value)
        k++;
    if (k + 1 == last)
        return stops[k].height;
    return between_ends(&stops[k], &stops[k + 1],
                        (value - stops[k].at) / (stops[k + 1].at - stops[k].at));
}

/* ---- Transforms ---------------------------------------------------------- */

static double triple(const double a[3], const double b[3], const double c[3])
{
    double product[3];
    cross_product(b, c, product);
    return dot(a, product);
}

/* Computes the inverse of `transposed` by Cramer's rule. */
static void there_from(const struct transform *map, const double normal[3],
                       double there[3])
{
    double rows[3][3];
    for (int i = 0; i < 3; i++)
        copy(rows[i], map->rows[i]);
    double whole = triple(rows[0], rows[1], rows[2]);
    there[0] = triple(normal, rows[1], rows[2]) / whole;
    there[1] = triple(rows[0], normal, rows[2]) / whole;
    there[2] = triple(rows[0], rows[1], normal) / whole;
}

/* ---- Bumps --------------------------------------------------------------- */

/* Tilts the normal away from the gradient of the pattern. The gradient is computed from
 * differences between the corners of a tetrahedron. */
static void push(const struct bump *bump, const double point[3], double normal[3])
{
    double r = sqrt(8) / 3, h = sqrt(2. / 3), amount = -.1 * bump->amount;
    const double corners[4][3] = {
        { r, -1. / 3, 0 }, { -r / 2, -1. / 3, h }, { -r / 2, -1. / 3, -h }, { 0, 1, 0 }
    };
    for (int i = 0; i < 4; i++) {
        double corner[3];
        add_scaled(corner, point, bump->accuracy, corners[i]);
        add_scaled(normal, normal, amount * height(bump, corner) / bump->accuracy,
                   corners[i]);
    }
}

/* Tilts the normal, which depends on the position of the point within its unit cube. */
static void quilt(const struct bump *bump, const double point[3], double normal[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = point[i] - floor(point[i]) - .5;
    double t = sqrt(dot(from, from)), s = 1 - t;
    double curve = t * t * t + 3 * t * s * s * bump->controls[0]
                   + 3 * t * t * s * bump->controls[1];
    add_scaled(normal, normal, bump->amount * curve / sqrt(.75), from);
}

/* Applies a bump in the space of the pattern. */
static void change(const struct bump *bump, const struct transform *space,
                   bool unscaled, const double point[3], double normal[3])
{
    double there[3], at[3];
    to_other_space(space, point, at);
    there_from(space, normal, there);
    if (!unscaled)
        normalise(there);
    if (bump->pattern.kind != PIGMENT_COLOR
        && bump->pattern.pattern.function == PATTERN_QUILTED)
        quilt(bump, at, there);
    else if (bump->pattern.kind != PIGMENT_COLOR)
        push(bump, at, there);
    transposed(space, there, normal);
    if (!unscaled)
        normalise(normal);
}

static void change_by(const struct bump_entry *entry, bool unscaled, const double at[3],
                      const double before[3], double share, double sum[3])
{
    double normal[3];
    copy(normal, before);
    change(&entry->bump, &entry->bump.pattern.to_local, unscaled, at, normal);
    add_scaled(sum, sum, share, normal);
}

static void blend(const struct bump_list *list, bool unscaled, const double at[3],
                  const double before[3], double sum[3])
{
    const struct bump_entry *entries = list->entries;
    double value = plain_pattern(&list->bump.pattern, at);
    size_t k = 0;
    while (k < list->count && entries[k].at <= value)
        k++;
    if (k == 0 || k == list->count) {
        change_by(&entries[k ? k - 1 : 0], unscaled, at, before, 1, sum);
        return;
    }
    double u = (value - entries[k - 1].at) / (entries[k].at - entries[k - 1].at);
    change_by(&entries[k - 1], unscaled, at, before, 1 - u, sum);
    change_by(&entries[k], unscaled, at, before, u, sum);
}

void plain_bumps(const struct bumps *bumps, double unit, const double point[3],
                 double normal[3])
{
    const struct bump_list *list = bumps->list;
    double at[3], there[3], sum[3] = { 0, 0, 0 };
    if (!bumps_show(bumps))
        return;
    for (int i = 0; i < 3 && bumps->unscaled; i++)
        normal[i] *= unit;
    if (list->count == 0) {
        change(&list->bump, &bumps->to_local, bumps->unscaled, point, normal);
        normalise(normal);
        return;
    }
    to_other_space(&bumps->to_local, point, at);
    there_from(&bumps->to_local, normal, there);
    if (!bumps->unscaled)
        normalise(there);
    if (!list->average)
        blend(list, bumps->unscaled, at, there, sum);
    for (size_t i = 0; list->average && i < list->count; i++)
        change_by(&list->entries[i], bumps->unscaled, at, there, list->entries[i].at,
                  sum);
    transposed(&bumps->to_local, sum, normal);
    normalise(normal);
}
