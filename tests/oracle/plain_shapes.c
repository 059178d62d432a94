/* plain_shapes.c - planes, boxes and surfaces of degree two. */
#include "tests/oracle/plain_shapes.h"

/* Computes the real roots of a t^2 + 2 b t + c without cancellation. */
static size_t quadratic(double a, double b, double c, double roots[2])
{
    double discriminant = b * b - a * c;
    if (discriminant < 0)
        return 0;
    double q = -(b + copysign(sqrt(discriminant), b));
    roots[0] = q == 0 ? 0 : c / q;
    roots[1] = q / a;
    return a != 0 ? 2 : b != 0;
}

CROSS(cross_sphere)
{
    const double *center = primitive->shape.sphere.center;
    double radius = primitive->shape.sphere.radius;
    double from[3], roots[2], point[3];
    add_scaled(from, ray->origin, -1, center);
    size_t count = quadratic(dot(ray->direction, ray->direction),
                             dot(from, ray->direction),
                             dot(from, from) - radius * radius, roots);
    for (size_t i = 0; i < count; i++) {
        crossings[i].distance = roots[i];
        point_on(ray, roots[i], point);
        add_scaled(crossings[i].normal, point, -1, center);
    }
    return count;
}

static void face_crossing(struct crossing *crossing, double distance, int axis)
{
    *crossing = (struct crossing){ .distance = distance };
    crossing->normal[axis] = 1;
}

bool cross_level(double height, const struct ray *ray, struct crossing *crossing,
                 double point[3])
{
    if (ray->direction[1] == 0)
        return false;
    face_crossing(crossing, (height - ray->origin[1]) / ray->direction[1], 1);
    point_on(ray, crossing->distance, point);
    return true;
}

/* Intersects the three intervals of the line between opposite faces. */
CROSS(cross_box)
{
    const double(*const corner)[3] = primitive->shape.box.corner;
    crossings[0].distance = -INFINITY;
    crossings[1].distance = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        double from = ray->origin[axis], along = ray->direction[axis];
        if (along == 0 && (from < corner[0][axis] || from > corner[1][axis]))
            return 0;
        if (along == 0)
            continue;
        double a = (corner[0][axis] - from) / along;
        double b = (corner[1][axis] - from) / along;
        if (fmin(a, b) > crossings[0].distance)
            face_crossing(&crossings[0], fmin(a, b), axis);
        if (fmax(a, b) < crossings[1].distance)
            face_crossing(&crossings[1], fmax(a, b), axis);
    }
    return crossings[0].distance <= crossings[1].distance ? 2 : 0;
}

/* The axis of a cone, its length, and a ray's components along and across it. The
 * radius at height h is radius + slope h. A cylinder is a cone with slope 0. */
struct axial_view {
    double axis[3], length;
    double height, rise;          /* components of origin and direction along the
                                   * axis */
    double from[3], direction[3]; /* components across the axis, relative to it */
    double radius, slope;
};

static void view_along(const struct round *cone, const struct ray *ray,
                       struct axial_view *view)
{
    add_scaled(view->axis, cone->cap, -1, cone->base);
    view->length = sqrt(dot(view->axis, view->axis));
    view->radius = cone->base_radius;
    view->slope = (cone->cap_radius - cone->base_radius) / view->length;
    normalise(view->axis);
    add_scaled(view->from, ray->origin, -1, cone->base);
    view->height = dot(view->from, view->axis);
    view->rise = dot(ray->direction, view->axis);
    add_scaled(view->from, view->from, -view->height, view->axis);
    add_scaled(view->direction, ray->direction, -view->rise, view->axis);
}

/* On the wall, the distance from the axis equals the radius. The difference of their
 * squares is therefore 0, and its gradient is the normal. */
static size_t cross_wall(const struct axial_view *view, struct crossing *crossings)
{
    double radius = view->radius + view->slope * view->height;
    double growth = view->slope * view->rise;
    double roots[2];
    size_t count = 0;
    size_t found = quadratic(dot(view->direction, view->direction) - growth * growth,
                             dot(view->from, view->direction) - radius * growth,
                             dot(view->from, view->from) - radius * radius, roots);
    for (size_t i = 0; i < found; i++) {
        double height = view->height + roots[i] * view->rise;
        double *normal = crossings[count].normal;
        if (!(height >= 0 && height <= view->length))
            continue;
        crossings[count++].distance = roots[i];
        add_scaled(normal, view->from, roots[i], view->direction);
        add_scaled(normal, normal, -view->slope * (view->radius + view->slope * height),
                   view->axis);
    }
    return count;
}

static size_t cross_disk(const struct axial_view *view, double height,
                         struct crossing *crossing)
{
    double radius = view->radius + view->slope * height;
    double across[3];
    if (view->rise == 0)
        return 0;
    crossing->distance = (height - view->height) / view->rise;
    add_scaled(across, view->from, crossing->distance, view->direction);
    copy(crossing->normal, view->axis);
    return dot(across, across) <= radius * radius;
}

static size_t cross_disks(const struct axial_view *view, struct crossing *crossings)
{
    size_t count = cross_disk(view, 0, crossings);
    return count + cross_disk(view, view->length, &crossings[count]);
}

CROSS(cross_cone)
{
    struct round cone = round_of(primitive);
    struct axial_view view;
    view_along(&cone, ray, &view);
    size_t count = cross_wall(&view, crossings);
    return cone.open ? count : count + cross_disks(&view, &crossings[count]);
}

CROSS(cross_cylinder)
{
    return cross_cone(primitive, ray, crossings);
}

CROSS(cross_plane)
{
    const double *normal = primitive->shape.plane.normal;
    double along = dot(normal, ray->direction);
    if (along == 0)
        return 0;
    crossings[0].distance = (primitive->shape.plane.distance - dot(normal, ray->origin))
                            / along;
    copy(crossings[0].normal, normal);
    return 1;
}

/* Intersects the line with the plane. The crossing is valid if it is on the ring. */
CROSS(cross_disc)
{
    const double *normal = primitive->shape.disc.normal;
    double along = dot(normal, ray->direction), from[3], away;
    add_scaled(from, primitive->shape.disc.center, -1, ray->origin);
    if (along == 0)
        return 0;
    crossings[0].distance = dot(normal, from) / along;
    copy(crossings[0].normal, normal);
    point_on(ray, crossings[0].distance, from);
    add_scaled(from, from, -1, primitive->shape.disc.center);
    away = sqrt(dot(from, from));
    return away >= primitive->shape.disc.hole && away <= primitive->shape.disc.radius;
}

/* Computes the gradient of a quadric if `linear` is 1, or the product of the Hessian
 * and a direction if it is 0. */
static void quadric_gradient(const double c[QUADRIC_TERMS], const double at[3],
                             double linear, double gradient[3])
{
    double x = at[0], y = at[1], z = at[2];
    gradient[0] = 2 * c[0] * x + c[3] * y + c[4] * z + linear * c[6];
    gradient[1] = c[3] * x + 2 * c[1] * y + c[5] * z + linear * c[7];
    gradient[2] = c[4] * x + c[5] * y + 2 * c[2] * z + linear * c[8];
}

/* Uses f(o + t d) = f(o) + t d.grad f(o) + t^2 / 2 d.H d with the constant Hessian H.
 * f(o) is computed by Euler's rule from the quadratic and linear parts. */
CROSS(cross_quadric)
{
    const double *c = primitive->shape.quadric.coefficients;
    double at[3], along[3], roots[2], point[3];
    quadric_gradient(c, ray->direction, 0, along);
    double a = dot(along, ray->direction) / 2;
    quadric_gradient(c, ray->origin, 1, at);
    double b = dot(at, ray->direction) / 2;
    quadric_gradient(c, ray->origin, 2, at);
    size_t count = quadratic(a, b, dot(at, ray->origin) / 2 + c[9], roots);
    for (size_t i = 0; i < count; i++) {
        crossings[i].distance = roots[i];
        point_on(ray, roots[i], point);
        quadric_gradient(c, point, 1, crossings[i].normal);
    }
    return count;
}

CROSS(plain_crossings)
{
    static cross_shape *const cross[PRIMITIVE_KINDS] = {
#define SHAPE(KIND, name, ...) cross_##name,
#include "rt/shapes/shapes.def"
    };
    return cross[primitive->kind](primitive, ray, crossings);
}
