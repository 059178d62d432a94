/* plain_solids.c - tests whether a point is inside a primitive. */
#include "tests/oracle/plain_shapes.h"

bool in_sphere(const struct primitive *primitive, const double point[3])
{
    double radius = primitive->shape.sphere.radius;
    double from[3];
    add_scaled(from, point, -1, primitive->shape.sphere.center);
    return dot(from, from) < radius * radius;
}

bool in_box(const struct primitive *primitive, const double point[3])
{
    const double(*const corner)[3] = primitive->shape.box.corner;
    for (int i = 0; i < 3; i++)
        if (!(point[i] > corner[0][i] && point[i] < corner[1][i]))
            return false;
    return true;
}

bool in_plane(const struct primitive *primitive, const double point[3])
{
    return dot(primitive->shape.plane.normal, point) < primitive->shape.plane.distance;
}

/* The inside of a disc is a half space, as in POV-Ray. */
bool in_disc(const struct primitive *primitive, const double point[3])
{
    double from[3];
    add_scaled(from, point, -1, primitive->shape.disc.center);
    return dot(primitive->shape.disc.normal, from) < 0;
}

/* Returns whether a point is between the planes of the ends and nearer to the axis than
 * the radius there. */
static bool about_axis(const double base[3], double base_radius, const double cap[3],
                       double cap_radius, const double point[3])
{
    double axis[3], from[3];
    add_scaled(axis, cap, -1, base);
    add_scaled(from, point, -1, base);
    double share = dot(from, axis) / dot(axis, axis);
    double radius = base_radius + share * (cap_radius - base_radius);
    add_scaled(from, from, -share, axis);
    return share > 0 && share < 1 && dot(from, from) < radius * radius;
}

/* An open cylinder or cone encloses the same points as the closed one, as in
 * POV-Ray. */
bool in_cylinder(const struct primitive *primitive, const double point[3])
{
    double radius = primitive->shape.cylinder.radius;
    return about_axis(primitive->shape.cylinder.base, radius,
                      primitive->shape.cylinder.cap, radius, point);
}

bool in_cone(const struct primitive *primitive, const double point[3])
{
    return about_axis(primitive->shape.cone.base, primitive->shape.cone.base_radius,
                      primitive->shape.cone.cap, primitive->shape.cone.cap_radius,
                      point);
}

/* A tube thicker than its ring intersects itself.  Its core, where the ellipses of both
 * sides overlap, is outside: the polynomial is positive there. */
static bool in_ellipses(double major, double radial, double axial,
                        const double point[3])
{
    double across = hypot(point[0], point[2]);
    double along = point[1] / axial;
    double here = (across - major) / radial;
    double beyond = (across + major) / radial;
    return here * here + along * along < 1 && beyond * beyond + along * along > 1;
}

bool in_torus(const struct primitive *primitive, const double point[3])
{
    double minor = primitive->shape.torus.minor;
    return in_ellipses(primitive->shape.torus.major, minor, minor, point);
}

bool in_elliptical_torus(const struct primitive *primitive, const double point[3])
{
    return in_ellipses(primitive->shape.elliptical_torus.major,
                       primitive->shape.elliptical_torus.radial,
                       primitive->shape.elliptical_torus.axial, point);
}

bool in_quadric(const struct primitive *primitive, const double point[3])
{
    const double *c = primitive->shape.quadric.coefficients;
    double x = point[0], y = point[1], z = point[2];
    return x * (c[0] * x + c[3] * y + c[4] * z + c[6])
               + y * (c[1] * y + c[5] * z + c[7]) + z * (c[2] * z + c[8]) + c[9]
           < 0;
}

static double raised(double value, int exponent)
{
    double product = 1;
    for (int i = 0; i < exponent; i++)
        product *= value;
    return product;
}

bool in_quartic(const struct primitive *primitive, const double point[3])
{
    const double *c = primitive->shape.quartic.coefficients;
    double sum = 0;
    for (int x = 4; x >= 0; x--)
        for (int y = 4 - x; y >= 0; y--)
            for (int z = 4 - x - y; z >= 0; z--)
                sum += *c++ * raised(point[0], x) * raised(point[1], y)
                       * raised(point[2], z);
    return sum < 0;
}

bool in_steiner_patch(const struct primitive *primitive, const double point[3])
{
    (void)primitive;
    (void)point;
    return false;
}

bool plain_encloses(const struct primitive *primitive, const double point[3])
{
    static enclose_point *const inside[PRIMITIVE_KINDS] = {
#define SHAPE(KIND, name, ...) in_##name,
#include "rt/shapes/shapes.def"
    };

    return inside[primitive->kind](primitive, point);
}
