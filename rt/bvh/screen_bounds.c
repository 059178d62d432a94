/* screen_bounds.c - computes the windows of a mesh's nodes, as seen from viewpoints. */
#include "rt/bvh/screen_bounds.h"

#include <math.h>
#include <stdlib.h>

#include "rt/scene/vector3.h"

/* The fields of a viewpoint's row and of a node's row, as in VIEWPOINT and SCREEN of
 * records.s. */
enum {
    VIEWPOINT_POSITION,
    VIEWPOINT_AXIS = 3,
    VIEWPOINT_SIGN,
    VIEWPOINT_FAR,
    VIEWPOINT_BOUNDS,
    VIEWPOINT_ROW,

    SCREEN_LOW_U = 0,
    SCREEN_HIGH_U,
    SCREEN_LOW_V,
    SCREEN_HIGH_V,
    SCREEN_NEAR,
    SCREEN_LINKS, /* this field and those after it are integers */
    SCREEN_FIRST = SCREEN_LINKS + 2,
    SCREEN_COUNT,
    SCREEN_ROW
};

/* ---- Viewpoints ---------------------------------------------------------- */

/* These limits are relative to the greatest coordinate of the mesh and the viewpoint.
 * MARGIN is added to each side of a window, measured at the smallest depth of the mesh.
 * It is eight times the rounding error of a hit by a ray that starts within MAX_FAR. A
 * viewpoint closer than MIN_NEAR has no windows, because the margin would be most of
 * them. */
#define MARGIN 0x1p-31
#define MIN_NEAR 0x1p-20
enum { MAX_FAR = 512 };
/* The largest slope of a point relative to the view axis. */
enum { MAX_SLOPE = 64 };
/* The largest number of words for the windows of a viewpoint. A larger table would not
 * fit in the real memory of the machine, and each ray would cause page faults. */
enum { MAX_BOUNDS_WORDS = 1 << 20 };

struct viewpoint {
    const double *place;
    int axis;
    double sign;
    double size; /* greatest coordinate of the box and the viewpoint */
    double near; /* least z of the box */
};

static double greatest_side(const struct box *box, const double place[3])
{
    double most = 0;
    for (int k = 0; k < 3; k++)
        most = fmax(most, fmax(box->high[k] - place[k], place[k] - box->low[k]));
    return most;
}

/* Finds the view axis of a viewpoint. Returns false if the viewpoint is inside the box,
 * or too close to it. */
static bool viewpoint_find(const double place[3], const struct box *whole,
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
    return viewpoint->near > MIN_NEAR * viewpoint->size
           && greatest_side(whole, place) <= MAX_SLOPE * viewpoint->near
           && isfinite(MAX_FAR * viewpoint->size);
}

size_t screen_bounds_size(const struct viewpoints *viewpoints, const struct box *whole,
                          size_t nodes, size_t *seeing)
{
    size_t words = (nodes + 1) * SCREEN_ROW;
    struct viewpoint viewpoint;
    *seeing = 0;
    if (words > MAX_BOUNDS_WORDS)
        return 0;
    for (size_t i = 0; viewpoints && i < viewpoints->count; i++)
        *seeing += viewpoint_find(viewpoints->places[i], whole, &viewpoint);
    return *seeing * (VIEWPOINT_ROW + words);
}

/* ---- Windows ------------------------------------------------------------- */

struct node_bounds {
    double low[2], high[2], near;
};

static const struct node_bounds no_bounds = { { INFINITY, INFINITY },
                                              { -INFINITY, -INFINITY },
                                              INFINITY };

static void join_bounds(struct node_bounds *window, const struct node_bounds *other)
{
    for (int i = 0; i < 2; i++) {
        window->low[i] = fmin(window->low[i], other->low[i]);
        window->high[i] = fmax(window->high[i], other->high[i]);
    }
    window->near = fmin(window->near, other->near);
}

static struct node_bounds bounds_of_point(const struct viewpoint *viewpoint,
                                          const double corner[3])
{
    struct node_bounds window;
    double away[3];
    subtract3(corner, viewpoint->place, away);
    window.near = viewpoint->sign * away[viewpoint->axis];
    for (int i = 0; i < 2; i++)
        window.low[i] = window.high[i] = away[(viewpoint->axis + 1 + i) % 3]
                                         / window.near;
    return window;
}

/* Computes the windows of all nodes. The loop runs backwards, because the children of a
 * node come after the node. */
static void find_node_bounds(const struct screen_bounds *of,
                             const struct viewpoint *viewpoint,
                             struct node_bounds *bounds)
{
    const struct mesh_node *nodes = of->hierarchy->nodes;
    for (size_t i = of->hierarchy->node_count; i-- > 0;) {
        bounds[i] = no_bounds;
        for (size_t k = 0; k < 3 * nodes[i].count; k++) {
            const double *triangle = of->triangles + of->row * (nodes[i].first + k / 3);
            struct node_bounds corner = bounds_of_point(viewpoint,
                                                        triangle + k % 3 * 3);
            join_bounds(&bounds[i], &corner);
        }
        if (nodes[i].count == 0) {
            join_bounds(&bounds[i], &bounds[i + 1]);
            join_bounds(&bounds[i], &bounds[nodes[i + 1].next]);
        }
    }
}

/* ---- Costs --------------------------------------------------------------- */

/* The estimated clocks per ray of a test of a box, a window and a triangle, from the
 * instructions of the vector programs. They only select the method; no frame depends on
 * them. */
enum { BOX_CLOCKS = 25, BOUNDS_CLOCKS = 14, TRIANGLE_CLOCKS = 60 };

/* Returns the cost of the rays that hit a node. Their number is proportional to the
 * node's area in the plane z = 1. Each ray tests both children, or all triangles of a
 * leaf. */
static double cost_below(const struct mesh_node *node, double area, int clocks)
{
    return area
           * (node->count > 0 ? TRIANGLE_CLOCKS * (double)node->count : 2. * clocks);
}

/* Returns the area of a box in the plane z = 1. The value is accurate only for a small
 * box, which suffices. */
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

static double area_of(const struct node_bounds *window)
{
    return (window->high[0] - window->low[0]) * (window->high[1] - window->low[1]);
}

/* Returns true if the windows of a viewpoint cost less than boxes. */
static bool bounds_pay(const struct screen_bounds *of,
                       const struct viewpoint *viewpoint,
                       const struct node_bounds *bounds)
{
    double by_boxes = 0, by_bounds = 0;
    for (size_t i = 0; i < of->hierarchy->node_count; i++) {
        const struct mesh_node *node = &of->hierarchy->nodes[i];
        by_boxes += cost_below(node, silhouette(&node->box, viewpoint), BOX_CLOCKS);
        by_bounds += cost_below(node, area_of(&bounds[i]), BOUNDS_CLOCKS);
    }
    return by_bounds <= by_boxes;
}

/* ---- Traversal ----------------------------------------------------------- */

/* Returns true if the second child of a node is on the viewpoint's side of the
 * split. */
static bool upper_is_first(const struct mesh_node *nodes, size_t node,
                           const struct viewpoint *viewpoint)
{
    const struct box *lower = &nodes[node + 1].box;
    const struct box *upper = &nodes[nodes[node + 1].next].box;
    int axis = nodes[node].axis;
    return viewpoint->place[axis] > lower->high[axis] / 2 + upper->low[axis] / 2;
}

/* Selects the nodes that are tested, as plan_tests does for boxes. The threshold is
 * higher here, because a test of a window is cheaper. With camera rays and a ball of
 * 100,352 triangles, .6 gave the fewest tests of the thresholds from .4 to .7. */
static void plan_orders(const struct mesh_node *nodes, size_t node,
                        const struct viewpoint *viewpoint,
                        const struct node_bounds *bounds, double above,
                        unsigned char *orders)
{
    double area = area_of(&bounds[node]);
    orders[node] = 0;
    if (nodes[node].count > 0)
        return;
    if (upper_is_first(nodes, node, viewpoint))
        orders[node] |= MESH_UPPER_FIRST;
    if (node > 0 && area > .6 * above)
        orders[node] |= MESH_PASSED;
    else
        above = area;
    plan_orders(nodes, node + 1, viewpoint, bounds, above, orders);
    plan_orders(nodes, nodes[node + 1].next, viewpoint, bounds, above, orders);
}

/* ---- Words --------------------------------------------------------------- */

/* Writes the row of a node. MARGIN is a length at the smallest depth of the mesh;
 * divided by this depth, it is added to each side of the window. */
static void put_node_bounds(const struct screen_bounds *of,
                            const struct viewpoint *viewpoint,
                            const struct node_bounds *window, size_t node, double *row)
{
    const struct mesh_node *from = &of->hierarchy->nodes[node];
    double margin = MARGIN * viewpoint->size;
    for (size_t i = 0; i < 2; i++) {
        double most = fmax(fabs(window->low[i]), fabs(window->high[i]));
        double wider = margin / viewpoint->near * (1 + most);
        row[SCREEN_LOW_U + 2 * i] = window->low[i] - wider;
        row[SCREEN_HIGH_U + 2 * i] = window->high[i] + wider;
    }
    row[SCREEN_NEAR] = window->near - margin;
    row[SCREEN_FIRST] = of->triangles_place + (double)(of->row * from->first);
    row[SCREEN_COUNT] = (double)from->count;
}

static void put_viewpoint(const struct viewpoint *viewpoint, double bounds, double *row)
{
    copy3(viewpoint->place, row + VIEWPOINT_POSITION);
    row[VIEWPOINT_AXIS] = viewpoint->axis;
    row[VIEWPOINT_SIGN] = viewpoint->sign;
    row[VIEWPOINT_FAR] = MAX_FAR * viewpoint->size;
    row[VIEWPOINT_BOUNDS] = bounds;
}

/* Work arrays of one viewpoint: its windows, and the traversal flags of all nodes. */
struct view {
    struct node_bounds *bounds;
    unsigned char *orders;
};

/* Writes the windows of a viewpoint. If they would cost more than boxes, it writes
 * nothing and returns false. */
static bool put_view(const struct screen_bounds *of, const struct viewpoint *viewpoint,
                     const struct view *view, double *rows)
{
    const struct mesh_hierarchy *hierarchy = of->hierarchy;
    double *first = rows + SCREEN_ROW;
    find_node_bounds(of, viewpoint, view->bounds);
    if (!bounds_pay(of, viewpoint, view->bounds))
        return false;
    plan_orders(hierarchy->nodes, 0, viewpoint, view->bounds, 0, view->orders);
    for (size_t i = 0; i < hierarchy->node_count; i++)
        put_node_bounds(of, viewpoint, &view->bounds[i], i, first + SCREEN_ROW * i);
    mesh_hierarchy_thread(hierarchy, view->orders,
                          &(struct mesh_rows){ first + SCREEN_LINKS, SCREEN_ROW });
    return true;
}

bool screen_bounds_put(const struct screen_bounds *of,
                       const struct viewpoints *viewpoints, double place, double *words,
                       size_t *planned)
{
    size_t nodes = of->hierarchy->node_count, seeing, at;
    const struct box *whole = &of->hierarchy->nodes[0].box;
    struct view view = { malloc(nodes * sizeof *view.bounds), malloc(nodes) };
    bool good = view.bounds && view.orders;
    screen_bounds_size(viewpoints, whole, nodes, &seeing);
    at = seeing * VIEWPOINT_ROW;
    *planned = 0;
    for (size_t i = 0; good && seeing > 0 && i < viewpoints->count; i++) {
        struct viewpoint viewpoint;
        if (!viewpoint_find(viewpoints->places[i], whole, &viewpoint)
            || !put_view(of, &viewpoint, &view, words + at))
            continue;
        put_viewpoint(&viewpoint, place + (double)at, words + VIEWPOINT_ROW * *planned);
        at += SCREEN_ROW * (nodes + 1);
        ++*planned;
    }
    free(view.bounds);
    free(view.orders);
    return good;
}

void screen_bounds_mark(size_t seeing, size_t nodes, bool *marks)
{
    size_t rows = seeing * (nodes + 1);
    for (size_t i = 0; i < seeing * VIEWPOINT_ROW; i++)
        marks[i] = i % VIEWPOINT_ROW == VIEWPOINT_AXIS
                   || i % VIEWPOINT_ROW == VIEWPOINT_BOUNDS;
    marks += seeing * VIEWPOINT_ROW;
    for (size_t i = 0; i < rows * SCREEN_ROW; i++)
        marks[i] = i % SCREEN_ROW >= SCREEN_LINKS;
}
