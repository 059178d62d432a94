/* hits.c - measures the cost of a ray as a function of the fraction of rays that hit.
 *
 * A scout frame finds the pixels where rays hit the primitive. The narrow frames that
 * are measured have the size of its largest square of hits, reduced a little. The eye
 * does not move. The first frame shows this square. The next ones are shifted towards
 * the nearer side of the scout, and the last one is just past the primitive. The
 * density of rays is therefore constant, and only their direction changes.
 */
#include <math.h>
#include <stdlib.h>

#include "vm/error.h"
#include "rt/scene/elementary.h"
#include "rt/study/sweep/sweep_types.h"
#include "vm/min_max.h"

enum { SIDE = 256, SHARES = 10 };
static const double degrees = 57.29577951308232; /* in a radian */

struct scout {
    bool *hit;                /* SIDE x SIDE pixels */
    size_t side, row, column; /* side and first pixel of a square */
};

/* Finds the largest square of hits by dynamic programming. Consider the largest square
 * that ends at a pixel. Its side is 1 plus the least side of the largest squares that
 * end at the left, upper and upper left neighbours. */
static bool find_square(struct scout *scout)
{
    size_t *sides = calloc(SIDE * SIDE, sizeof *sides);
    if (!sides)
        return false;
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        size_t row = i / SIDE, column = i % SIDE;
        if (!scout->hit[i])
            continue;
        sides[i] = 1;
        if (row > 0 && column > 0)
            sides[i] += min_size(min_size(sides[i - 1], sides[i - SIDE]),
                                 sides[i - SIDE - 1]);
        if (sides[i] > scout->side) {
            scout->side = sides[i];
            scout->row = row + 1 - sides[i];
            scout->column = column + 1 - sides[i];
        }
    }
    free(sides);
    return true;
}

/* Shrinks the square so that every ray hits, at any position within its pixel. */
static void shrink(struct scout *scout)
{
    size_t edge = scout->side / 10;
    scout->side -= 2 * edge;
    scout->row += edge;
    scout->column += edge;
}

static bool read_hits(const struct trace *trace, struct scout *scout)
{
    const c205_word *words = trace_channel(trace, CHANNEL_ID);
    scout->hit = malloc(SIDE * SIDE * sizeof *scout->hit);
    for (size_t i = 0; scout->hit && i < SIDE * SIDE; i++)
        scout->hit[i] = c205_to_integer(words[i]) != 0;
    return scout->hit != NULL;
}

static bool send_scout(const struct sweep *sweep, struct scout *scout,
                       c205_error *error)
{
    struct sweep_point point = sweep->base;
    struct scene *scene;
    struct trace *trace;
    bool good;
    point.trace.width = point.trace.height = SIDE;
    point.trace.mode = TRACE_VECTOR;
    trace = speedup_trace(sweep->subject, &point.view, &point.trace, &scene, error);
    good = trace && trace_run(trace, error);
    if (good) {
        error_set(error, "out of memory");
        good = read_hits(trace, scout) && find_square(scout);
        shrink(scout);
    }
    trace_free(trace);
    scene_free(scene);
    return good;
}

/* ---- Directions ---------------------------------------------------------- */

/* Counts the hits in the square after a shift by up to SIDE columns. */
static size_t hits_at(const struct scout *scout, ptrdiff_t shift)
{
    size_t hits = 0;
    for (size_t i = 0; i < scout->side * scout->side; i++) {
        ptrdiff_t column = (ptrdiff_t)(scout->column + i % scout->side) + shift;
        if (column >= 0 && column < SIDE)
            hits += scout->hit[(scout->row + i / scout->side) * SIDE + (size_t)column];
    }
    return hits;
}

/* Returns the sign of the direction towards the side of the frame that is nearer to the
 * square: -1 or 1. */
static ptrdiff_t direction(const struct scout *scout)
{
    return 2 * scout->column + scout->side < SIDE ? -1 : 1;
}

/* Returns true if the primitive reaches the side of the frame that is nearer to the
 * square. It may then continue beyond the frame. */
static bool reaches_side(const struct scout *scout)
{
    size_t column = direction(scout) < 0 ? 0 : SIDE - 1;
    for (size_t row = scout->row; row < scout->row + scout->side; row++)
        if (scout->hit[row * SIDE + column])
            return true;
    return false;
}

/* Returns the shift to just past the last hit, with a margin for the error of one
 * pixel. */
static ptrdiff_t shift_past(const struct scout *scout)
{
    ptrdiff_t shift = SIDE;
    while (hits_at(scout, direction(scout) * (shift - 1)) == 0)
        shift--;
    return shift + 1 + (ptrdiff_t)scout->side / 10;
}

/* Returns the first shift at which the fraction of hits in the square is at most
 * `share`. */
static ptrdiff_t shift_to(const struct scout *scout, double share)
{
    size_t most = (size_t)(share * (double)(scout->side * scout->side));
    ptrdiff_t shift = 0;
    while (hits_at(scout, direction(scout) * shift) > most)
        shift++;
    return shift;
}

static void cross(const double a[3], const double b[3], double product[3])
{
    for (int i = 0; i < 3; i++)
        product[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void normalise(double vector[3])
{
    double length = sqrt(vector[0] * vector[0] + vector[1] * vector[1]
                         + vector[2] * vector[2]);
    for (int i = 0; i < 3; i++)
        vector[i] /= length;
}

/* Returns the width of the largest frame with these proportions in a square, as a
 * fraction of the side of the square. */
static double width_of_square(const struct trace_options *trace)
{
    return trace->width < trace->height ? (double)trace->width / (double)trace->height
                                        : 1;
}

/* Computes the view of the scout's square after a shift by columns. As in the camera of
 * the scene language, y is up, and `right` points to the right. */
static struct speedup_view look(const struct sweep *sweep, const struct scout *scout,
                                ptrdiff_t shift)
{
    const double *from = sweep->subject->from, sky[3] = { 0, 1, 0 };
    const double forward[3] = { -from[0], -from[1], -from[2] };
    struct speedup_view view = sweep->base.view;
    double half = elementary_tan(view.angle / 2 / degrees), middle, x, y;
    double right[3], up[3];
    cross(sky, forward, right);
    normalise(right);
    cross(forward, right, up);
    middle = (double)scout->side / 2;
    x = half * (2 * ((double)scout->column + middle + (double)shift) / SIDE - 1);
    y = half * (1 - 2 * ((double)scout->row + middle) / SIDE);
    for (int i = 0; i < 3; i++)
        view.aim[i] = view.distance * (x * right[i] + y * up[i]);
    view.angle = 2 * degrees
                 * elementary_atan(half * (double)scout->side / SIDE
                                   * width_of_square(&sweep->base.trace));
    return view;
}

static bool check_scout(const struct sweep *sweep, const struct scout *scout,
                        c205_error *error)
{
    if (scout->side >= 8 && !reaches_side(scout))
        return true;
    return error_set(error,
                     "%s is too %s in a frame of %g degrees from a distance of %g",
                     sweep->subject->name, scout->side < 8 ? "small" : "large",
                     sweep->base.view.angle, sweep->base.view.distance);
}

static bool measure(struct sweep *sweep, c205_error *error)
{
    struct sweep_point points[SHARES + 1];
    struct scout scout = { NULL, 0, 0, 0 };
    bool good = send_scout(sweep, &scout, error) && check_scout(sweep, &scout, error);
    for (int i = 0; good && i <= SHARES; i++) {
        ptrdiff_t shift = i == 0 ? shift_past(&scout)
                                 : shift_to(&scout, (double)i / SHARES);
        points[i] = sweep->base;
        points[i].view = look(sweep, &scout, direction(&scout) * shift);
    }
    free(scout.hit);
    return good && sweep_run(sweep, points, SHARES + 1, error);
}

/* ---- Tables -------------------------------------------------------------- */

static const struct table_column point_columns[] = {
    { "rays", "rays", TABLE_COUNT, 0 },
    { "hits", "hits", TABLE_COUNT, 0 },
    SWEEP_COLUMNS,
};
enum { BEFORE = 2 };

static void print_hits(struct sweep_report *report, const struct sweep *sweep)
{
    const struct sweep_measure *none = sweep->measures;
    const struct sweep_measure *all = none + sweep->count - 1;
    sweep_report_line(report,
                      "From %.1f %% to %.1f %% of hits a ray of the "
                      "scalar form costs %.2f times as much,",
                      sweep_hit_percent(none), sweep_hit_percent(all),
                      sweep_cost(all, SWEEP_SCALAR) / sweep_cost(none, SWEEP_SCALAR));
    sweep_report_line(report,
                      "one in a queue %.2f times; the speedup changes from %.2f to "
                      "%.2f.",
                      sweep_cost(all, SWEEP_QUEUED) / sweep_cost(none, SWEEP_QUEUED),
                      sweep_speedup(none), sweep_speedup(all));
}

static void draw_hits(struct sweep_report *report, const struct table *table)
{
    report->plotted = table;
    report->plot.x_column = BEFORE + SWEEP_COLUMN_HITS;
    report->plot.x = (struct plot_axis){ "% of the rays that hit", PLOT_LINEAR };
    report->plot.y = (struct plot_axis){ "clocks per ray; speedup", PLOT_LOG10 };
    sweep_report_curve(report, BEFORE + SWEEP_COLUMN_SCALAR, "scalar");
    sweep_report_curve(report, BEFORE + SWEEP_COLUMN_QUEUED, "in queues");
    sweep_report_curve(report, BEFORE + SWEEP_COLUMN_SPEEDUP, "speedup");
}

static bool report_hits(struct sweep *sweep, struct sweep_report *report,
                        c205_error *error)
{
    struct table *table = sweep_report_table(report, "points", sweep_points_heading,
                                             TABLE_COLUMNS(point_columns));
    error_set(error, "out of memory");
    if (!table)
        return false;
    for (size_t i = 0; i < sweep->count; i++) {
        table_count(table, sweep->measures[i].rays);
        table_count(table, sweep->measures[i].hits);
        sweep_add_cells(table, &sweep->measures[i]);
    }
    print_hits(report, sweep);
    draw_hits(report, table);
    return true;
}

const struct sweep_kind sweep_hits = {
    .name = "hits",
    .title = "Rays that hit",
    .angle = 37, /* shows the shape and some background */
    .primitive_only = true,
    .measure = measure,
    .report = report_hits,
};
