/* plain_solids.c - tests whether a point is inside a primitive. */
#include "tests/oracle/plain_shapes.h"

struct round round_of(const struct primitive *primitive)
{
    if (primitive->kind == PRIMITIVE_CONE)
        return (struct round){ primitive->shape.cone.base, primitive->shape.cone.cap,
                               primitive->shape.cone.base_radius,
                               primitive->shape.cone.cap_radius,
                               primitive->shape.cone.open };
    double radius = primitive->shape.cylinder.radius;
    return (struct round){ primitive->shape.cylinder.base,
                           primitive->shape.cylinder.cap, radius, radius,
                           primitive->shape.cylinder.open };
}

struct torus torus_of(const struct primitive *primitive)
{
    double minor = primitive->shape.torus.minor;
    if (primitive->kind == PRIMITIVE_TORUS)
        return (struct torus){ primitive->shape.torus.major, minor, minor };
    return (struct torus){ primitive->shape.elliptical_torus.major,
                           primitive->shape.elliptical_torus.radial,
                           primitive->shape.elliptical_torus.axial };
}

ENCLOSE(in_sphere)
{
    double radius = primitive->shape.sphere.radius;
    double from[3];
    add_scaled(from, point, -1, primitive->shape.sphere.center);
    return dot(from, from) < radius * radius;
}

ENCLOSE(in_box)
{
    const double(*const corner)[3] = primitive->shape.box.corner;
    for (int i = 0; i < 3; i++)
        if (!(point[i] > corner[0][i] && point[i] < corner[1][i]))
            return false;
    return true;
}

ENCLOSE(in_plane)
{
    return dot(primitive->shape.plane.normal, point) < primitive->shape.plane.distance;
}

/* The inside of a disc is a half-space, as in POV-Ray. */
ENCLOSE(in_disc)
{
    double from[3];
    add_scaled(from, point, -1, primitive->shape.disc.center);
    return dot(primitive->shape.disc.normal, from) < 0;
}

/* Returns true if a point is between the planes of the ends, and nearer to the axis
 * than the radius at its height. As in POV-Ray, an open cylinder or cone encloses the
 * same points as a closed one. */
ENCLOSE(in_cone)
{
    struct round cone = round_of(primitive);
    double axis[3], from[3];
    add_scaled(axis, cone.cap, -1, cone.base);
    add_scaled(from, point, -1, cone.base);
    double share = dot(from, axis) / dot(axis, axis);
    double radius = cone.base_radius + share * (cone.cap_radius - cone.base_radius);
    add_scaled(from, from, -share, axis);
    return share > 0 && share < 1 && dot(from, from) < radius * radius;
}

ENCLOSE(in_cylinder)
{
    return in_cone(primitive, point);
}

/* A tube that is thicker than its ring intersects itself. The core, where the ellipses
 * of both sides overlap, is outside, because the polynomial is positive there. */
ENCLOSE(in_torus)
{
    struct torus torus = torus_of(primitive);
    double across = hypot(point[0], point[2]);
    double along = point[1] / torus.axial;
    double here = (across - torus.major) / torus.radial;
    double beyond = (across + torus.major) / torus.radial;
    return here * here + along * along < 1 && beyond * beyond + along * along > 1;
}

ENCLOSE(in_elliptical_torus)
{
    return in_torus(primitive, point);
}

ENCLOSE(in_quadric)
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

ENCLOSE(in_quartic)
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

ENCLOSE(in_steiner_patch)
{
    (void)primitive;
    (void)point;
    return false;
}

ENCLOSE(plain_encloses)
{
    static enclose_point *const inside[PRIMITIVE_KINDS] = {
#define SHAPE(KIND, name, ...) in_##name,
#include "rt/shapes/shapes.def"
    };
    return inside[primitive->kind](primitive, point);
}
