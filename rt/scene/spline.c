/* spline.c - splines. Their ends follow the rules of POV-Ray. */
#include "rt/scene/spline.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

/* ---- Points -------------------------------------------------------------- */

size_t spline_find(const struct spline *spline, double t)
{
    size_t low = 0, high = spline->count;
    if (!high || t >= spline->points[high - 1].t)
        return high;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (spline->points[middle].t < t)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Adds a point with the latest value. As in POV-Ray, it replaces a point with the same
 * parameter, unless that is the last point: the new point is then ignored. */
static bool put(struct spline *spline, double t)
{
    size_t count = spline->count, place = spline_find(spline, t);
    struct spline_point *points = spline->points;
    if (count && place == count && points[count - 1].t == t)
        return true;
    if (place == count || points[place].t != t) {
        if (!array_add(&spline->points, &spline->count, NULL, sizeof *points))
            return false;
        points = spline->points;
        memmove(points + place + 1, points + place, (count - place) * sizeof *points);
        points[place].t = t;
    }
    memcpy(points[place].value, spline->latest, sizeof spline->latest);
    return true;
}

/* Adds a point. As in POV-Ray, missing terms of its value are taken from the previous
 * value. */
bool spline_add(struct spline *spline, double t, const double *value, int terms)
{
    if (spline->terms < terms)
        spline->terms = terms;
    memcpy(spline->latest, value, (size_t)terms * sizeof *value);
    return put(spline, t);
}

struct spline *spline_new(const struct spline *from)
{
    struct spline *spline = calloc(1, sizeof *spline);
    if (!spline)
        return NULL;
    spline->holders = 1;
    for (size_t i = 0; from && i < from->count; i++)
        if (!spline_add(spline, from->points[i].t, from->points[i].value,
                        SPLINE_TERMS)) {
            spline_release(spline);
            return NULL;
        }
    memset(spline->latest, 0, sizeof spline->latest);
    spline->terms = from ? from->terms : 2;
    if (from)
        spline->kind = from->kind;
    return spline;
}

void spline_release(struct spline *spline)
{
    if (--spline->holders)
        return;
    free(spline->points);
    free(spline);
}

/* ---- Values -------------------------------------------------------------- */

/* Returns the slope of a term from a point to the next point. */
static double slope(const struct spline_point *point, int term)
{
    return (point[1].value[term] - point[0].value[term]) / (point[1].t - point[0].t);
}

/* Solves the tridiagonal system of one term by elimination. Its equations are: the
 * second derivatives are 0 at both ends, and the first derivatives agree at each inner
 * point. */
static void solve_term(struct spline *spline, int term)
{
    struct spline_point *point = spline->points;
    size_t last = spline->count - 1;
    point[0].bend[term] = point[last].bend[term] = 0;
    for (size_t i = 1; i < last; i++) {
        double width = point[i].t - point[i - 1].t;
        double carry = i > 1 ? width / point[i - 1].pivot : 0;
        point[i].pivot = 2 * (point[i + 1].t - point[i - 1].t) - carry * width;
        point[i].bend[term] = 6 * (slope(&point[i], term) - slope(&point[i - 1], term))
                              - carry * point[i - 1].bend[term];
    }
    for (size_t i = last; i-- > 1;)
        point[i].bend[term] = (point[i].bend[term]
                               - (point[i + 1].t - point[i].t)
                                     * point[i + 1].bend[term])
                              / point[i].pivot;
}

void spline_solve(struct spline *spline)
{
    for (int term = 0; term < SPLINE_TERMS; term++)
        solve_term(spline, term);
}

/* Computes one term at t. t is between the points end - 1 and end, both of which are in
 * the spline. */
typedef double term_value(const struct spline *spline, size_t end, int term, double t);

static double linear(const struct spline *spline, size_t end, int term, double t)
{
    const struct spline_point *point = &spline->points[end - 1];
    return point->value[term] + (t - point->t) * slope(point, term);
}

/* Computes a term by the parabola through the points end - 2, end - 1 and end. In the
 * first interval, the parabola goes through the first three points. */
static double quadratic(const struct spline *spline, size_t end, int term, double t)
{
    const struct spline_point *point = &spline->points[end > 1 ? end - 2 : 0];
    double first, change;
    if (spline->count == 2)
        return linear(spline, end, term, t);
    first = slope(&point[0], term);
    change = (slope(&point[1], term) - first) / (point[2].t - point[0].t);
    return point->value[term] + (t - point[0].t) * (first + change * (t - point[1].t));
}

static double cubic(const struct spline *spline, size_t end, int term, double t)
{
    const struct spline_point *point = &spline->points[end - 1];
    double width = point[1].t - point[0].t, u = (t - point[0].t) / width;
    double middle = slope(&point[0], term);
    double from = (slope(&point[-1], term) + middle) / 2 * width;
    double to = (slope(&point[1], term) + middle) / 2 * width;
    return point[0].value[term]
           + u
                 * (from
                    + u
                          * ((3 * middle * width - 2 * from - to)
                             + u * (from + to - 2 * middle * width)));
}

static double natural(const struct spline *spline, size_t end, int term, double t)
{
    const struct spline_point *point = &spline->points[end - 1];
    double width = point[1].t - point[0].t, d = t - point[0].t;
    double bend = point[0].bend[term], next = point[1].bend[term];
    return point[0].value[term]
           + d
                 * (slope(point, term) - width * (2 * bend + next) / 6
                    + d * (bend / 2 + d * (next - bend) / (6 * width)));
}

/* Returns the end point whose value is the result. Returns NULL if the parameter is
 * between the ends. */
static const struct spline_point *at_end(const struct spline *spline, bool inner,
                                         size_t end)
{
    size_t last = spline->count - 1, inset = inner && last > 0;
    if (end <= inset)
        return &spline->points[inset];
    return end + inset > last ? &spline->points[last - inset] : NULL;
}

/* Computes the value of a spline. A cubic spline ends at its second and at its second
 * to last point. As in POV-Ray, a cubic spline of two points is their mean. */
void spline_value(const struct spline *spline, enum spline_kind kind, double t,
                  double value[SPLINE_TERMS])
{
    static term_value *const rows[SPLINE_KINDS] = { linear, quadratic, cubic, natural };
    bool inner = kind == SPLINE_CUBIC, mean = inner && spline->count == 2;
    size_t end = spline_find(spline, t);
    const struct spline_point *held = at_end(spline, inner, end);
    for (int term = 0; term < spline->terms; term++) {
        const struct spline_point *point = spline->points;
        if (mean)
            value[term] = (point[0].value[term] + point[1].value[term]) / 2;
        else
            value[term] = held ? held->value[term] : rows[kind](spline, end, term, t);
    }
}
