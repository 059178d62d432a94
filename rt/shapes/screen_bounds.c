#include "rt/shapes/screen_bounds.h"

#include <math.h>
#include <stdlib.h>

#include "rt/scene/vector.h"

/* A row of an eye, and of a node: EYE and WINDOW of records.s. */
enum {
    EYE_PLACE,
    EYE_AXIS = 3,
    EYE_SIGN,
    EYE_FAR,
    EYE_WINDOWS,
    EYE_ROW,

    WINDOW_LOW_U = 0,
    WINDOW_HIGH_U,
    WINDOW_LOW_V,
    WINDOW_HIGH_V,
    WINDOW_NEAR,
    WINDOW_LINKS, /* from here on they are integers */
    WINDOW_FIRST = WINDOW_LINKS + 2,
    WINDOW_COUNT,
    WINDOW_ROW
};

/* ---- Eyes ---------------------------------------------------------------- */

/* In sizes of the greatest coordinate: windows are wider by MARGIN, where their corners
 * are, which is eight times what is rounded of a ray that comes from no farther than
 * MAX_FAR, and of a triangle that it meets.  An eye that is nearer than NEAR_LEAST would
 * see little else than that. */
#define MARGIN 0x1p-31
#define NEAR_LEAST 0x1p-20
enum { MAX_FAR = 512 };
/* Points stand no farther beside the eye's axis, in depths. */
enum { MAX_SLOPE = 64 };
/* Words of an eye's windows: more would not stay in the real memory of the machine, and
 * each ray would wait for pages. */
enum { MAX_WINDOWS = 1 << 20 };

struct viewpoint {
    const double *place;
    int axis;
    double sign;
    double size; /* the greatest coordinate, of the box and its own */
    double near; /* the least z, of the box */
};

static double greatest_side(const struct box *box, const double place[3])
{
    double most = 0;

    for (int k = 0; k < 3; k++)
        most = fmax(most, fmax(box->high[k] - place[k], place[k] - box->low[k]));
    return most;
}

/* False: it is within the box, or so near that little would be seen. */
static bool eye_find(const double place[3], const struct box *whole,
                     struct viewpoint *viewpoint)
{
    *viewpoint = (struct viewpoint){ .place = place };
    for (int k = 0; k < 3; k++) {
        double below = whole->low[k] - place[k], above = place[k] - whole->high[k];

        if (fmax(below, above) <= viewpoint->near)
            continue;
        viewpoint->axis = k;
        viewpoint->sign = below > above ? 1 : -1;
        viewpoint->near = fmax(below, above);
    }
    viewpoint->size = fmax(greatest3(place),
                           fmax(greatest3(whole->low), greatest3(whole->high)));
    return viewpoint->near > NEAR_LEAST * viewpoint->size
           && greatest_side(whole, place) <= MAX_SLOPE * viewpoint->near
           && isfinite(MAX_FAR * viewpoint->size);
}

size_t screen_bounds_size(const struct viewpoints *viewpoints, const struct box *whole,
                          size_t nodes, size_t *seeing)
{
    size_t words = (nodes + 1) * WINDOW_ROW;
    struct viewpoint viewpoint;

    *seeing = 0;
    if (words > MAX_WINDOWS)
        return 0;
    for (size_t i = 0; viewpoints && i < viewpoints->count; i++)
        *seeing += eye_find(viewpoints->places[i], whole, &viewpoint);
    return *seeing * (EYE_ROW + words);
}

/* ---- What is seen from one ------------------------------------------------ */

struct mesh_window {
    double low[2], high[2], near;
};

static const struct mesh_window no_window = { { INFINITY, INFINITY },
                                              { -INFINITY, -INFINITY },
                                              INFINITY };

static void join(struct mesh_window *window, const struct mesh_window *other)
{
    for (int i = 0; i < 2; i++) {
        window->low[i] = fmin(window->low[i], other->low[i]);
        window->high[i] = fmax(window->high[i], other->high[i]);
    }
    window->near = fmin(window->near, other->near);
}

static struct mesh_window window_of(const struct viewpoint *viewpoint,
                                    const double corner[3])
{
    struct mesh_window window;
    double away[3];

    subtract3(corner, viewpoint->place, away);
    window.near = viewpoint->sign * away[viewpoint->axis];
    for (int i = 0; i < 2; i++)
        window.low[i] = window.high[i] = away[(viewpoint->axis + 1 + i) % 3]
                                         / window.near;
    return window;
}

/* Nodes are before those below them. */
static void find_windows(const struct screen_bounds *of,
                         const struct viewpoint *viewpoint, struct mesh_window *bounds)
{
    const struct mesh_node *nodes = of->hierarchy->nodes;

    for (size_t i = of->hierarchy->node_count; i-- > 0;) {
        bounds[i] = no_window;
        for (size_t k = 0; k < 3 * nodes[i].count; k++) {
            const double *triangle = of->triangles + of->row * (nodes[i].first + k / 3);
            struct mesh_window corner = window_of(viewpoint, triangle + k % 3 * 3);

            join(&bounds[i], &corner);
        }
        if (nodes[i].count == 0) {
            join(&bounds[i], &bounds[i + 1]);
            join(&bounds[i], &bounds[nodes[i + 1].next]);
        }
    }
}

/* ---- What it costs ---------------------------------------------------------- */

/* Clocks of a vector program for a ray, about, as its instructions come to: where it is asked
 * at a box, at a window, where it meets a triangle.  A guess, which chooses and changes no frame. */
enum { BOX_CLOCKS = 25, WINDOW_CLOCKS = 14, TRIANGLE_CLOCKS = 60 };

/* Of all rays from the eye so many come near something as the area says that it has in
 * the plane where z is 1.  Each asks the two nodes below one, or meets a leaf's triangles. */
static double cost_below(const struct mesh_node *node, double area, int clocks)
{
    return area
           * (node->count > 0 ? TRIANGLE_CLOCKS * (double)node->count : 2. * clocks);
}

/* Of a box that is small, as seen from there; for the others it need not be right. */
static double silhouette(const struct box *box, const struct viewpoint *viewpoint)
{
    double away[3], size[3], z, area = 0;

    for (int k = 0; k < 3; k++) {
        away[k] = box->low[k] / 2 + box->high[k] / 2 - viewpoint->place[k];
        size[k] = box->high[k] - box->low[k];
    }
    z = viewpoint->sign * away[viewpoint->axis];
    for (int k = 0; k < 3; k++)
        area += fabs(away[k]) / z * (size[(k + 1) % 3] / z) * (size[(k + 2) % 3] / z);
    return area;
}

static double area_of(const struct mesh_window *window)
{
    return (window->high[0] - window->low[0]) * (window->high[1] - window->low[1]);
}

/* Whether rays from the eye are asked less by windows than by boxes. */
static bool windows_pay(const struct screen_bounds *of,
                        const struct viewpoint *viewpoint,
                        const struct mesh_window *bounds)
{
    double by_boxes = 0, by_windows = 0;

    for (size_t i = 0; i < of->hierarchy->node_count; i++) {
        const struct mesh_node *node = &of->hierarchy->nodes[i];

        by_boxes += cost_below(node, silhouette(&node->box, viewpoint), BOX_CLOCKS);
        by_windows += cost_below(node, area_of(&bounds[i]), WINDOW_CLOCKS);
    }
    return by_windows <= by_boxes;
}

/* ---- Ways ---------------------------------------------------------------- */

/* Who looks from an eye sees the half of a node on its own side first. */
static bool upper_is_first(const struct mesh_node *nodes, size_t node,
                           const struct viewpoint *viewpoint)
{
    const struct box *lower = &nodes[node + 1].box;
    const struct box *upper = &nodes[nodes[node + 1].next].box;
    int axis = nodes[node].axis;

    return viewpoint->place[axis] > lower->high[axis] / 2 + upper->low[axis] / 2;
}

/* A test of one of these spares the two below it: as plan_tests of boxes, but a
 * window is passed over at a greater share, as it costs less to be asked (of
 * .4 to .7 a count of the nodes asked was least at .6, for rays of a camera to a ball of
 * 100,352 triangles). */
static void plan_ways(const struct mesh_node *nodes, size_t node,
                      const struct viewpoint *viewpoint,
                      const struct mesh_window *bounds, double above,
                      unsigned char *ways)
{
    double area = area_of(&bounds[node]);

    ways[node] = 0;
    if (nodes[node].count > 0)
        return;
    if (upper_is_first(nodes, node, viewpoint))
        ways[node] |= MESH_UPPER_FIRST;
    if (node > 0 && area > .6 * above)
        ways[node] |= MESH_PASSED;
    else
        above = area;
    plan_ways(nodes, node + 1, viewpoint, bounds, above, ways);
    plan_ways(nodes, nodes[node + 1].next, viewpoint, bounds, above, ways);
}

/* ---- Its words ----------------------------------------------------------- */

/* Depth counts for as much less. */
static void put_window(const struct screen_bounds *of,
                       const struct viewpoint *viewpoint,
                       const struct mesh_window *window, size_t node, double *row)
{
    const struct mesh_node *from = &of->hierarchy->nodes[node];
    double margin = MARGIN * viewpoint->size;

    for (size_t i = 0; i < 2; i++) {
        double most = fmax(fabs(window->low[i]), fabs(window->high[i]));
        double wider = margin / viewpoint->near * (1 + most);

        row[WINDOW_LOW_U + 2 * i] = window->low[i] - wider;
        row[WINDOW_HIGH_U + 2 * i] = window->high[i] + wider;
    }
    row[WINDOW_NEAR] = window->near - margin;
    row[WINDOW_FIRST] = of->triangles_place + (double)(of->row * from->first);
    row[WINDOW_COUNT] = (double)from->count;
}

static void put_eye(const struct viewpoint *viewpoint, double bounds, double *row)
{
    copy3(viewpoint->place, row + EYE_PLACE);
    row[EYE_AXIS] = viewpoint->axis;
    row[EYE_SIGN] = viewpoint->sign;
    row[EYE_FAR] = MAX_FAR * viewpoint->size;
    row[EYE_WINDOWS] = bounds;
}

/* What one eye sees of all nodes; rows from that of zeros on. */
struct view {
    struct mesh_window *bounds;
    unsigned char *ways;
};

/* False: they do not pay, and there are none. */
static bool put_view(const struct screen_bounds *of, const struct viewpoint *viewpoint,
                     const struct view *view, double *rows)
{
    const struct mesh_hierarchy *hierarchy = of->hierarchy;
    double *first = rows + WINDOW_ROW;

    find_windows(of, viewpoint, view->bounds);
    if (!windows_pay(of, viewpoint, view->bounds))
        return false;
    plan_ways(hierarchy->nodes, 0, viewpoint, view->bounds, 0, view->ways);
    for (size_t i = 0; i < hierarchy->node_count; i++)
        put_window(of, viewpoint, &view->bounds[i], i, first + WINDOW_ROW * i);
    mesh_hierarchy_thread(hierarchy, view->ways,
                          &(struct mesh_rows){ first + WINDOW_LINKS, WINDOW_ROW });
    return true;
}

bool screen_bounds_put(const struct screen_bounds *of,
                       const struct viewpoints *viewpoints, double place, double *words,
                       size_t *planned)
{
    size_t nodes = of->hierarchy->node_count, seeing, at;
    const struct box *whole = &of->hierarchy->nodes[0].box;
    struct view view = { malloc(nodes * sizeof *view.bounds), malloc(nodes) };
    bool good = view.bounds && view.ways;

    screen_bounds_size(viewpoints, whole, nodes, &seeing);
    at = seeing * EYE_ROW;
    *planned = 0;
    for (size_t i = 0; good && seeing > 0 && i < viewpoints->count; i++) {
        struct viewpoint viewpoint;

        if (!eye_find(viewpoints->places[i], whole, &viewpoint)
            || !put_view(of, &viewpoint, &view, words + at))
            continue;
        put_eye(&viewpoint, place + (double)at, words + EYE_ROW * *planned);
        at += WINDOW_ROW * (nodes + 1);
        ++*planned;
    }
    free(view.bounds);
    free(view.ways);
    return good;
}

void screen_bounds_mark(size_t seeing, size_t nodes, bool *marks)
{
    size_t rows = seeing * (nodes + 1);

    for (size_t i = 0; i < seeing * EYE_ROW; i++)
        marks[i] = i % EYE_ROW == EYE_AXIS || i % EYE_ROW == EYE_WINDOWS;
    marks += seeing * EYE_ROW;
    for (size_t i = 0; i < rows * WINDOW_ROW; i++)
        marks[i] = i % WINDOW_ROW >= WINDOW_LINKS;
}
