#include "rt/layout/bounds.h"

#include <math.h>
#include <stdlib.h>

#include "rt/scene/transform.h"
#include "rt/scene/vector.h"
#include "rt/shapes/singular.h"

/* Beyond this the square of a sum of distances may tell nothing. */
#define GREATEST 1e12

const struct bound bound_none = { { 0, 0, 0 }, BOUND_NONE };

bool bound_is_none(const struct bound *bound)
{
    return bound->radius >= BOUND_NONE;
}

static bool is_sound(const struct bound *bound)
{
    return bound->radius <= GREATEST && length3(bound->center) <= GREATEST;
}

/* --- about others -------------------------------------------------------- */

static double distance_to(const double *from, const struct bound *part)
{
    const double way[3] = { part->center[0] - from[0],
                            part->center[1] - from[1],
                            part->center[2] - from[2] };

    return length3(way);
}

/* The part that reaches farthest from a point; how far. */
static const struct bound *farthest(const struct bound *parts, size_t count,
                                    const double *from, double *reach)
{
    const struct bound *found = parts;

    *reach = 0;
    for (size_t i = 0; i < count; i++) {
        double far = distance_to(from, &parts[i]) + parts[i].radius;

        if (far > *reach) {
            *reach = far;
            found = &parts[i];
        }
    }
    return found;
}

/* The middle of the box about all parts. */
static void middle(const struct bound *parts, size_t count, double *center)
{
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;

        for (size_t i = 0; i < count; i++) {
            low = fmin(low, parts[i].center[axis] - parts[i].radius);
            high = fmax(high, parts[i].center[axis] + parts[i].radius);
        }
        center[axis] = (low + high) / 2;
    }
}

/* To the farthest point, by shorter and shorter steps; the best centre on the
 * way is taken.  Source: Badoiu and Clarkson 2003. */
void bound_enclose(const struct bound *parts, size_t count,
                   struct bound *whole)
{
    enum { STEPS = 24 };
    double center[3], reach;

    *whole = bound_none;
    for (size_t i = 0; i < count; i++)
        if (!is_sound(&parts[i]))
            return;
    middle(parts, count, center);
    for (int step = 1; step <= STEPS && count > 0; step++) {
        const struct bound *far = farthest(parts, count, center, &reach);
        double distance = distance_to(center, far);

        if (reach < whole->radius) {
            copy3(center, whole->center);
            whole->radius = reach;
        }
        for (int i = 0; i < 3 && distance > 0; i++)
            center[i] += (far->center[i] - center[i])
                         * (reach / distance / (step + 1));
    }
    whole->radius *= 1 + 1e-12;
}

/* --- primitives ---------------------------------------------------------- */

/* Points whose hull the shape does not leave. */
enum { RING = 16, HULL_MOST = 2 * RING };
struct hull {
    size_t count;
    struct bound points[HULL_MOST];
};

static void add_point(struct hull *hull, const struct primitive *primitive,
                      const double *point)
{
    struct bound *added = &hull->points[hull->count++];

    copy3(point, added->center);
    transform_point(&primitive->to_world, added->center);
    added->radius = 0;
}

/* A polygon about a circle: its points stand a little farther out. */
static void add_ring(struct hull *hull, const struct primitive *primitive,
                     const double *center, const double *axis, double radius)
{
    double across[3] = { 0, 0, 0 }, u[3], v[3];

    across[fabs(axis[0]) <= fmax(fabs(axis[1]), fabs(axis[2])) ? 0 : 1] = 1;
    cross3(axis, across, u);
    scale3(1 / length3(u), u);
    cross3(axis, u, v);
    scale3(1 / length3(v), v);
    radius /= cos(PI / RING);
    for (int i = 0; i < RING; i++) {
        double c = radius * cos(2 * PI * i / RING);
        double s = radius * sin(2 * PI * i / RING);
        double point[3];

        for (int k = 0; k < 3; k++)
            point[k] = center[k] + c * u[k] + s * v[k];
        add_point(hull, primitive, point);
    }
}

static void add_rings(struct hull *hull, const struct primitive *primitive,
                      const double *base, double base_radius,
                      const double *cap, double cap_radius)
{
    const double axis[3] = { cap[0] - base[0], cap[1] - base[1],
                             cap[2] - base[2] };

    add_ring(hull, primitive, base, axis, base_radius);
    add_ring(hull, primitive, cap, axis, cap_radius);
}

static void box_hull(const struct primitive *primitive, struct hull *hull)
{
    const double(*corner)[3] = primitive->shape.box.corner;

    for (int i = 0; i < 8; i++) {
        const double point[3] = { corner[i & 1][0], corner[i >> 1 & 1][1],
                                  corner[i >> 2][2] };
        add_point(hull, primitive, point);
    }
}

static void cylinder_hull(const struct primitive *primitive,
                          struct hull *hull)
{
    double radius = primitive->shape.cylinder.radius;

    add_rings(hull, primitive, primitive->shape.cylinder.base, radius,
              primitive->shape.cylinder.cap, radius);
}

static void cone_hull(const struct primitive *primitive, struct hull *hull)
{
    add_rings(hull, primitive, primitive->shape.cone.base,
              primitive->shape.cone.base_radius, primitive->shape.cone.cap,
              primitive->shape.cone.cap_radius);
}

/* With weights above 0 a patch lies in the hull of its control points. */
static void patch_hull(const struct primitive *primitive, struct hull *hull)
{
    for (int i = 0; i < STEINER_POINTS; i++)
        add_point(hull, primitive, primitive->shape.steiner_patch.points[i]);
}

/* How much the way to the world stretches a vector at the most, of those with
 * components at most as long as the weights are. */
static double stretch(const struct primitive *primitive, double x, double y,
                      double z)
{
    const double weights[3] = { x, y, z };
    struct singular matrix = { .rows = 3, .columns = 3 };

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            matrix.scaled[i][j] = primitive->to_world.rows[i][j] * weights[j];
    singular_decompose(&matrix);
    return fmax(matrix.values[0], fmax(matrix.values[1], matrix.values[2]));
}

static double sphere_reach(const struct primitive *primitive, double *center)
{
    double r = primitive->shape.sphere.radius;

    copy3(primitive->shape.sphere.center, center);
    return stretch(primitive, r, r, r);
}

/* A circle about y, and from there the tube. */
static double torus_reach(const struct primitive *primitive, double *center)
{
    double major = primitive->shape.torus.major;
    double minor = primitive->shape.torus.minor;

    (void)center;
    return stretch(primitive, major, 0, major)
           + stretch(primitive, minor, minor, minor);
}

static double elliptical_torus_reach(const struct primitive *primitive,
                                     double *center)
{
    double major = primitive->shape.elliptical_torus.major;
    double radial = primitive->shape.elliptical_torus.radial;

    (void)center;
    return stretch(primitive, major, 0, major)
           + stretch(primitive, radial,
                     primitive->shape.elliptical_torus.axial, radial);
}

/* A shape has a hull, or a centre and how far it reaches from there in the
 * world, or no bound. */
static const struct {
    void (*hull)(const struct primitive *primitive, struct hull *hull);
    double (*reach)(const struct primitive *primitive, double *center);
} kinds[PRIMITIVE_KINDS] = {
    [PRIMITIVE_SPHERE] = { NULL, sphere_reach },
    [PRIMITIVE_BOX] = { box_hull, NULL },
    [PRIMITIVE_CYLINDER] = { cylinder_hull, NULL },
    [PRIMITIVE_CONE] = { cone_hull, NULL },
    [PRIMITIVE_TORUS] = { NULL, torus_reach },
    [PRIMITIVE_ELLIPTICAL_TORUS] = { NULL, elliptical_torus_reach },
    [PRIMITIVE_STEINER_PATCH] = { patch_hull, NULL },
};

/* A part in a thousand, what a ray from far away may lose, and what an event
 * is looked at from (twice k_delta, docs/solids.md): a solid that is left out is
 * on neither side of an event. */
static void add_margin(struct bound *bound)
{
    bound->radius = 1.001 * bound->radius + 1e-9 * length3(bound->center)
                    + 2e-7;
    if (!is_sound(bound))
        *bound = bound_none;
}

void bound_primitive(const struct primitive *primitive, struct bound *bound)
{
    struct hull hull = { .count = 0 };

    *bound = bound_none;
    if (kinds[primitive->kind].hull) {
        kinds[primitive->kind].hull(primitive, &hull);
        bound_enclose(hull.points, hull.count, bound);
    } else if (kinds[primitive->kind].reach) {
        bound->radius = kinds[primitive->kind].reach(primitive,
                                                     bound->center);
        transform_point(&primitive->to_world, bound->center);
    }
    add_margin(bound);
}

/* --- trees --------------------------------------------------------------- */

/* The bounds of a node's children, one after another; how many. */
static size_t gather(const struct scene *scene, size_t node,
                     const struct bound *bounds, struct bound *children)
{
    size_t count = 0;

    for (size_t child = node + 1; child < scene->nodes[node].next;
         child = scene->nodes[child].next)
        children[count++] = bounds[child];
    return count;
}

static struct bound least_of(const struct bound *children, size_t count)
{
    struct bound least = bound_none;

    for (size_t i = 0; i < count; i++)
        if (children[i].radius < least.radius)
            least = children[i];
    return least;
}

static void bound_node(const struct scene *scene, size_t node,
                       struct bound *bounds, struct bound *children)
{
    size_t count = gather(scene, node, bounds, children);

    switch (scene->nodes[node].operation) {
    case TREE_LEAF:
        bound_primitive(&scene->primitives[scene->nodes[node].primitive],
                        &bounds[node]);
        break;
    case TREE_AND: bounds[node] = least_of(children, count); break;
    case TREE_OR: bound_enclose(children, count, &bounds[node]); break;
    case TREE_NOT: bounds[node] = bound_none; break;
    }
}

/* Backwards, so that what is below a node comes before it. */
bool bound_nodes(const struct scene *scene, struct bound *bounds)
{
    struct bound *children = malloc((scene->node_count + 1)
                                    * sizeof *children);

    if (!children)
        return false;
    for (size_t node = scene->node_count; node-- > 0;)
        bound_node(scene, node, bounds, children);
    free(children);
    return true;
}
