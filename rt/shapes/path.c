/* path.c - walks over the edges of a path, bounds the path, and counts the crossings of
 * a line with the path. */
#include "rt/shapes/path.h"

#include <math.h>

#include "rt/scene/elementary.h"
#include "rt/scene/vector3.h"

#define CLOSED 1e-10

double path_closeness(const double (*points)[2], size_t count)
{
    double size = 0;
    for (size_t i = 1; i < count; i++)
        for (int k = 0; k < 2; k++)
            size = fmax(size, fabs(points[i][k] - points[0][k]));
    return CLOSED * fmin(size, 1);
}

bool path_is_near(const double a[2], const double b[2], double closeness)
{
    return fabs(a[0] - b[0]) <= closeness && fabs(a[1] - b[1]) <= closeness;
}

bool path_next(struct path_walk *walk)
{
    const double(*points)[2] = (const double(*)[2])walk->path->points;
    walk->begins = walk->at == walk->first;
    if (walk->at + 1 >= walk->path->count)
        return false;
    walk->from = points[walk->at++];
    walk->to = points[walk->at];
    if ((walk->at - walk->first) % walk->apart == 0
        && equal2(walk->to, points[walk->first]))
        walk->first = ++walk->at;
    return true;
}

/* ---- Bounds -------------------------------------------------------------- */

/* Bounds a cylinder that contains the path swept between the two heights. */
void path_bound(const struct primitive *primitive, const struct outline *path,
                double low_end, double high_end, struct bound *bound)
{
    double low[2] = { INFINITY, INFINITY }, high[2] = { -INFINITY, -INFINITY };
    double base[3], cap[3], radius = 0;
    struct hull hull = { .count = 0 };
    for (size_t i = 0; i < path->count; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], path->points[i][k]);
            high[k] = fmax(high[k], path->points[i][k]);
        }
    for (int k = 0; k < 2; k++)
        base[2 * k] = cap[2 * k] = (low[k] + high[k]) / 2;
    base[1] = low_end;
    cap[1] = high_end;
    for (size_t i = 0; i < path->count; i++)
        radius = fmax(radius, elementary_hypot(path->points[i][0] - base[0],
                                               path->points[i][1] - base[2]));
    hull_rings(&hull, primitive, base, radius, cap, radius);
    bound_hull(&hull, bound);
}

/* ---- Crossings of a line ------------------------------------------------- */

/* Returns the side of a direction to which an edge turns; 0: nearly parallel. */
static int side_of(const struct path_walk *edge, const double direction[2])
{
    double x = edge->to[0] - edge->from[0], z = edge->to[1] - edge->from[1];
    double across = direction[0] * z - direction[1] * x;
    return fabs(across) <= 1e-9 * elementary_hypot(x, z)
                               * elementary_hypot(direction[0], direction[1])
               ? 0
           : across > 0 ? 1
                        : -1;
}

/* The state of a count: how often successive edges of a loop change sides. An edge that
 * is parallel to the direction counts as on either side. */
struct changes {
    int first, last;        /* side of the first and of the last edge that is not
                             * parallel */
    size_t before, between; /* number of parallel edges before the first such edge, and
                             * since the last */
    size_t count;
};

/* Returns the largest number of times that successive edges change sides, from side a
 * to side b with `along` parallel edges between them. Each parallel edge may count as
 * on either side. */
static size_t changes_between(int a, int b, size_t along)
{
    return along + 1 - ((along + 1) % 2 != (size_t)(a != b));
}

static void add_edge(struct changes *changes, int side)
{
    if (side == 0) {
        changes->between++;
        return;
    }
    if (changes->last == 0) {
        changes->first = side;
        changes->before = changes->between;
    } else {
        changes->count += changes_between(changes->last, side, changes->between);
    }
    changes->last = side;
    changes->between = 0;
}

/* Returns the number of changes in the whole loop, including those from its last edge
 * to its first. */
static size_t close_changes(const struct changes *changes)
{
    if (changes->last == 0)
        return changes->between;
    return changes->count
           + changes_between(changes->last, changes->first,
                             changes->between + changes->before);
}

/* Returns the largest number of crossings of the path with a line in this direction.
 * The line crosses a sequence of edges that all turn to the same side of the direction
 * at most once. */
static size_t crossings_along(const struct outline *path, size_t apart,
                              const double direction[2])
{
    struct path_walk walk = { .path = path, .apart = apart };
    struct changes changes = { 0, 0, 0, 0, 0 };
    size_t count = 0;
    while (path_next(&walk)) {
        if (walk.begins) {
            count += close_changes(&changes);
            changes = (struct changes){ 0, 0, 0, 0, 0 };
        }
        add_edge(&changes, side_of(&walk, direction));
    }
    return count + close_changes(&changes);
}

/* Tries only the directions of the edges, because the result of crossings_along has its
 * maximum at one of them. */
size_t path_crossings(const struct outline *path, size_t apart)
{
    struct path_walk walk = { .path = path, .apart = apart };
    size_t most = 2;
    while (path_next(&walk)) {
        const double direction[2] = { walk.to[0] - walk.from[0],
                                      walk.to[1] - walk.from[1] };
        size_t count = direction[0] == 0 && direction[1] == 0
                           ? 0
                           : crossings_along(path, apart, direction);
        most = count > most ? count : most;
    }
    return most;
}
