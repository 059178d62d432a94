/* primitive.c - the arguments of the primitives. */
#include "rt/scene/language/expression.h"
#include "rt/scene/language/patch.h"
#include "rt/scene/language/statement.h"
#include "rt/scene/vector.h"

#include <string.h>

/* A radius counts by its size; without one there is nothing to see. */
static bool read_radius(struct reader *reader, double *radius)
{
    struct token at = reader->token;

    if (!read_number(reader, radius))
        return false;
    *radius = fabs(*radius);
    return *radius > 0 || reader_fault(reader, &at, "the radius is 0");
}

static bool read_sphere(struct reader *reader, struct primitive *primitive)
{
    primitive->kind = PRIMITIVE_SPHERE;
    if (!read_vector(reader, primitive->shape.sphere.center))
        return false;
    reader_comma(reader);
    return read_radius(reader, &primitive->shape.sphere.radius);
}

static bool read_box(struct reader *reader, struct primitive *primitive)
{
    double a[3], b[3];

    primitive->kind = PRIMITIVE_BOX;
    if (!read_vector(reader, a))
        return false;
    reader_comma(reader);
    if (!read_vector(reader, b))
        return false;
    for (int i = 0; i < 3; i++) {
        primitive->shape.box.corner[0][i] = fmin(a[i], b[i]);
        primitive->shape.box.corner[1][i] = fmax(a[i], b[i]);
    }
    return true;
}

static bool read_cylinder(struct reader *reader, struct primitive *primitive)
{
    const double *base = primitive->shape.cylinder.base;
    const double *cap = primitive->shape.cylinder.cap;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_CYLINDER;
    if (!read_vector(reader, primitive->shape.cylinder.base))
        return false;
    reader_comma(reader);
    if (!read_vector(reader, primitive->shape.cylinder.cap))
        return false;
    reader_comma(reader);
    if (!read_radius(reader, &primitive->shape.cylinder.radius))
        return false;
    primitive->shape.cylinder.open = reader_accept(reader, "open");
    return base[0] != cap[0] || base[1] != cap[1] || base[2] != cap[2]
           || reader_fault(reader, &at, "both ends of the axis are the same");
}

/* The distance is along the normal of length one. */
static bool read_plane(struct reader *reader, struct primitive *primitive)
{
    double *normal = primitive->shape.plane.normal, length;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_PLANE;
    if (!read_vector(reader, normal))
        return false;
    length = length3(normal);
    if (length == 0 || !isfinite(length))
        return reader_fault(reader, &at, "the normal has no direction");
    scale3(1 / length, normal);
    reader_comma(reader);
    return read_number(reader, &primitive->shape.plane.distance);
}

/* The end of a cone's axis, and its radius: 0 makes a point of it. */
static bool read_end(struct reader *reader, double end[3], double *radius)
{
    struct token at;

    if (!read_vector(reader, end))
        return false;
    reader_comma(reader);
    at = reader->token;
    if (!read_number(reader, radius))
        return false;
    return *radius >= 0
           || reader_fault(reader, &at, "a radius of a cone is below 0");
}

/* As in POV-Ray. */
static void cylinder_from_cone(struct primitive *primitive)
{
    struct primitive cone = *primitive;

    primitive->kind = PRIMITIVE_CYLINDER;
    memcpy(primitive->shape.cylinder.base, cone.shape.cone.base,
           sizeof cone.shape.cone.base);
    memcpy(primitive->shape.cylinder.cap, cone.shape.cone.cap,
           sizeof cone.shape.cone.cap);
    primitive->shape.cylinder.radius = cone.shape.cone.base_radius;
    primitive->shape.cylinder.open = cone.shape.cone.open;
}

static bool read_cone(struct reader *reader, struct primitive *primitive)
{
    const double *base = primitive->shape.cone.base;
    const double *cap = primitive->shape.cone.cap;
    double *base_radius = &primitive->shape.cone.base_radius;
    double *cap_radius = &primitive->shape.cone.cap_radius;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_CONE;
    if (!read_end(reader, primitive->shape.cone.base, base_radius))
        return false;
    reader_comma(reader);
    if (!read_end(reader, primitive->shape.cone.cap, cap_radius))
        return false;
    primitive->shape.cone.open = reader_accept(reader, "open");
    if (base[0] == cap[0] && base[1] == cap[1] && base[2] == cap[2])
        return reader_fault(reader, &at,
                            "both ends of the axis are the same");
    if (*base_radius == 0 && *cap_radius == 0)
        return reader_fault(reader, &at, "both radii of the cone are 0");
    if (*base_radius == *cap_radius)
        cylinder_from_cone(primitive);
    return true;
}

/* A number above 0, after a comma unless it is the first. */
static bool read_size(struct reader *reader, const char *what, double *size)
{
    struct token at;

    reader_comma(reader);
    at = reader->token;
    if (!read_number(reader, size))
        return false;
    return *size > 0
           || reader_fault(reader, &at, "the %s is not above 0", what);
}

static bool read_torus(struct reader *reader, struct primitive *primitive)
{
    primitive->kind = PRIMITIVE_TORUS;
    return read_size(reader, "major radius", &primitive->shape.torus.major)
           && read_size(reader, "minor radius",
                        &primitive->shape.torus.minor);
}

static bool read_elliptical_torus(struct reader *reader,
                                  struct primitive *primitive)
{
    primitive->kind = PRIMITIVE_ELLIPTICAL_TORUS;
    return read_size(reader, "major radius",
                     &primitive->shape.elliptical_torus.major)
           && read_size(reader, "tube's radial half axis",
                        &primitive->shape.elliptical_torus.radial)
           && read_size(reader, "tube's axial half axis",
                        &primitive->shape.elliptical_torus.axial);
}

/* A surface needs a coefficient besides the last, the constant. */
static bool check_surface(struct reader *reader, const struct token *at,
                          const double *coefficients, size_t count)
{
    for (size_t i = 0; i + 1 < count; i++)
        if (coefficients[i] != 0)
            return true;
    return reader_fault(reader, at, "all coefficients of the surface are 0");
}

/* Three vectors and the constant. */
static bool read_quadric(struct reader *reader, struct primitive *primitive)
{
    double *coefficients = primitive->shape.quadric.coefficients;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_QUADRIC;
    for (size_t i = 0; i < 9; i += 3) {
        if (!read_vector(reader, coefficients + i))
            return false;
        reader_comma(reader);
    }
    return read_number(reader, coefficients + 9)
           && check_surface(reader, &at, coefficients, QUADRIC_TERMS);
}

/* All of <..> are read, that their number can be told. */
static bool read_coefficients(struct reader *reader, double *coefficients,
                              size_t count)
{
    struct token at = reader->token;
    size_t found = 0;
    double value;

    if (!reader_expect_sign(reader, '<'))
        return false;
    do {
        if (!read_number(reader, &value))
            return false;
        if (found < count)
            coefficients[found] = value;
        found++;
        reader_comma(reader);
    } while (!reader_at_sign(reader, '>'));
    if (found != count)
        reader_fault(reader, &at, "expected %zu coefficients, found %zu",
                     count, found);
    return reader_expect_sign(reader, '>') && found == count;
}

static bool read_quartic(struct reader *reader, struct primitive *primitive)
{
    double *coefficients = primitive->shape.quartic.coefficients;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_QUARTIC;
    return read_coefficients(reader, coefficients, QUARTIC_TERMS)
           && check_surface(reader, &at, coefficients, QUARTIC_TERMS);
}

static bool read_weights(struct reader *reader, double *weights)
{
    for (size_t i = 0; i < STEINER_POINTS; i++)
        if (!read_size(reader, "weight", &weights[i]))
            return false;
    return true;
}

static bool read_steiner_patch(struct reader *reader,
                               struct primitive *primitive)
{
    double(*points)[3] = primitive->shape.steiner_patch.points;
    double *weights = primitive->shape.steiner_patch.weights;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_STEINER_PATCH;
    for (size_t i = 0; i < STEINER_POINTS; i++) {
        if (!read_vector(reader, points[i]))
            return false;
        reader_comma(reader);
        weights[i] = 1;
    }
    if (reader_accept(reader, "weights") && !read_weights(reader, weights))
        return false;
    return patch_has_area(primitive)
           || reader_fault(reader, &at, "the patch has no area");
}

typedef bool primitive_reader(struct reader *reader,
                              struct primitive *primitive);

bool primitive_read(struct reader *reader, enum shape shape,
                    struct primitive *primitive)
{
    static primitive_reader *const readers[] = {
        [SHAPE_SPHERE] = read_sphere,
        [SHAPE_BOX] = read_box,
        [SHAPE_CYLINDER] = read_cylinder,
        [SHAPE_PLANE] = read_plane,
        [SHAPE_CONE] = read_cone,
        [SHAPE_TORUS] = read_torus,
        [SHAPE_ELLIPTICAL_TORUS] = read_elliptical_torus,
        [SHAPE_QUADRIC] = read_quadric,
        [SHAPE_QUARTIC] = read_quartic,
        [SHAPE_STEINER_PATCH] = read_steiner_patch,
    };

    memset(primitive, 0, sizeof *primitive);
    return readers[shape](reader, primitive);
}
