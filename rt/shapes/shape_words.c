#include "rt/shapes/shape_words.h"

#include <string.h>

#include "rt/scene/vector.h"
#include "rt/shapes/singular.h"
#include "rt/shapes/steiner.h"

/* The words of P_SHAPE, for each kind; their number is returned. */
static size_t sphere_shape(const struct primitive *primitive, double *shape)
{
    double r = primitive->shape.sphere.radius;

    memcpy(shape, primitive->shape.sphere.center, 3 * sizeof *shape);
    shape[3] = r * r;
    shape[4] = 1 / r;
    return 5;
}

static size_t box_shape(const struct primitive *primitive, double *shape)
{
    const double *low = primitive->shape.box.corner[0];
    const double *high = primitive->shape.box.corner[1];

    for (size_t i = 0; i < 3; i++) {
        shape[i] = low[i];
        shape[3 + i] = high[i];
        shape[6 + i] = (low[i] + high[i]) / 2;
        shape[9 + i] = (high[i] - low[i]) / 2;
    }
    return 12;
}

/* Two unit vectors square to the unit vector w and to each other. */
static void frame_about(const double *w, double *u, double *v)
{
    double axis[3] = { 0, 0, 0 };
    double length;

    axis[fabs(w[0]) < 0.5 ? 0 : fabs(w[1]) < 0.5 ? 1 : 2] = 1;
    cross3(axis, w, u);
    length = length3(u);
    for (size_t i = 0; i < 3; i++)
        u[i] /= length;
    cross3(w, u, v);
}

/* The middle of an axis and the frame u, v, w about it; its length. */
static double put_axis(const double *base, const double *cap, double *shape)
{
    double axis[3];
    double length;

    for (size_t i = 0; i < 3; i++) {
        shape[i] = (base[i] + cap[i]) / 2;
        axis[i] = cap[i] - base[i];
    }
    length = length3(axis);
    for (size_t i = 0; i < 3; i++)
        shape[9 + i] = axis[i] / length;
    frame_about(shape + 9, shape + 3, shape + 6);
    return length;
}

static size_t cylinder_shape(const struct primitive *primitive, double *shape)
{
    double r = primitive->shape.cylinder.radius;
    double length = put_axis(primitive->shape.cylinder.base,
                             primitive->shape.cylinder.cap, shape);

    shape[12] = r * r;
    shape[13] = length / 2;
    shape[14] = 1 / (2 * r);
    shape[15] = 1 / r;
    return 16;
}

static size_t cone_shape(const struct primitive *primitive, double *shape)
{
    double base = primitive->shape.cone.base_radius;
    double cap = primitive->shape.cone.cap_radius;
    double length = put_axis(primitive->shape.cone.base,
                             primitive->shape.cone.cap, shape);
    double slope = (cap - base) / length;

    shape[12] = (base + cap) / 2;
    shape[13] = slope;
    shape[14] = length / 2;
    shape[15] = 1 / sqrt(1 + slope * slope);
    return 16;
}

/* X A X + 2 g X + k about the centre: A c = -g, the nearest such point to the
 * origin or, where there is none, to being one. */
static size_t quadric_shape(const struct primitive *primitive, double *shape)
{
    enum { CENTER = 0, MATRIX = 3, LINEAR = 9, CONSTANT = 12 };
    static const size_t place[3][3] = { { 0, 3, 4 },
                                        { 3, 1, 5 },
                                        { 4, 5, 2 } };
    const double *terms = primitive->shape.quadric.coefficients;
    struct singular matrix = { .rows = 3, .columns = 3 };
    double *center = shape + CENTER, against[3];

    for (size_t i = 0; i < 6; i++)
        shape[MATRIX + i] = i < 3 ? terms[i] : terms[i] / 2;
    for (size_t i = 0; i < 3; i++)
        against[i] = -terms[6 + i] / 2;
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            matrix.scaled[i][j] = shape[MATRIX + place[i][j]];
    singular_decompose(&matrix);
    singular_solve(&matrix, 1e-6, against, center);
    shape[CONSTANT] = terms[9];
    for (size_t i = 0; i < 3; i++) {
        double product = 0;

        for (size_t j = 0; j < 3; j++)
            product += shape[MATRIX + place[i][j]] * center[j];
        shape[LINEAR + i] = product - against[i];
        shape[CONSTANT] += center[i] * (shape[LINEAR + i] - against[i]);
    }
    return 13;
}

/* A plane is carried into the world here: P^T n' with P the way back. */
static size_t plane_shape(const struct primitive *primitive, double *shape)
{
    const struct transform *back = &primitive->to_local;
    const double *normal = primitive->shape.plane.normal;
    double length;

    for (size_t i = 0; i < 3; i++)
        shape[i] = normal[0] * back->rows[0][i] + normal[1] * back->rows[1][i]
                   + normal[2] * back->rows[2][i];
    shape[3] = primitive->shape.plane.distance;
    for (size_t i = 0; i < 3; i++)
        shape[3] -= normal[i] * back->rows[i][3];
    length = length3(shape);
    for (size_t i = 0; i < 4; i++)
        shape[i] /= length;
    return 4;
}

/* Does the transform keep every sphere a sphere?  Then the sphere is carried
 * into the world here. */
static bool carry_sphere(const struct primitive *primitive, double *shape)
{
    const double(*rows)[4] = primitive->to_world.rows;
    double scale = length3(
        (const double[]){ rows[0][0], rows[1][0], rows[2][0] });
    const double *center = primitive->shape.sphere.center;
    double r = primitive->shape.sphere.radius * scale;

    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++) {
            double dot = rows[0][i] * rows[0][j] + rows[1][i] * rows[1][j]
                         + rows[2][i] * rows[2][j];
            double want = i == j ? scale * scale : 0;

            if (fabs(dot - want) > 1e-12 * scale * scale)
                return false;
        }
    for (size_t i = 0; i < 3; i++)
        shape[i] = rows[i][0] * center[0] + rows[i][1] * center[1]
                   + rows[i][2] * center[2] + rows[i][3];
    shape[3] = r * r;
    shape[4] = 1 / r;
    return true;
}

/* (x^2 + z^2 + rho y^2 + b0)^2 = a0 (x^2 + z^2) of the half axes p, n of the
 * tube, and a sphere and two planes about it that rounding cannot reach. */
static size_t torus_words(double major, double p, double n, double *shape)
{
    double bound = 1.001 * (major + fmax(p, n));

    shape[0] = (p / n) * (p / n);
    shape[1] = (major - p) * (major + p);
    shape[2] = 4 * major * major;
    shape[3] = 2 * major * major;
    shape[4] = bound * bound;
    shape[5] = major * major + p * p;
    shape[6] = p * p;
    shape[7] = 8 * major * major;
    shape[8] = bound * ROOT_RESOLUTION;
    shape[9] = 1.001 * n;
    return 10;
}

static size_t torus_shape(const struct primitive *primitive, double *shape)
{
    double minor = primitive->shape.torus.minor;

    return torus_words(primitive->shape.torus.major, minor, minor, shape);
}

static size_t elliptical_torus_shape(const struct primitive *primitive,
                                     double *shape)
{
    return torus_words(primitive->shape.elliptical_torus.major,
                       primitive->shape.elliptical_torus.radial,
                       primitive->shape.elliptical_torus.axial, shape);
}

/* The bound is POV-Ray's: it looks no farther. */
static size_t quartic_shape(const struct primitive *primitive, double *shape)
{
    (void)primitive;
    shape[0] = 1e7;
    shape[1] = ROOT_RESOLUTION;
    return 2;
}

static size_t quartic_table(const struct primitive *primitive, double *table)
{
    memcpy(table, primitive->shape.quartic.coefficients,
           QUARTIC_TERMS * sizeof *table);
    return QUARTIC_TERMS;
}

static size_t patch_shape(const struct primitive *primitive, double *shape)
{
    steiner_shape(primitive, shape);
    return STEINER_SHAPE;
}

static size_t patch_table(const struct primitive *primitive, double *table)
{
    return steiner_table(primitive, table);
}

static bool cylinder_is_open(const struct primitive *primitive)
{
    return primitive->shape.cylinder.open;
}

static bool cone_is_open(const struct primitive *primitive)
{
    return primitive->shape.cone.open;
}

/* In a tree the kernel may be another, and an open shape has one more. */
struct kernels {
    const char *kernel, *normal;
    size_t segments;
    const char *solid, *state;
};

/* Some kinds have two sorts: a condition, and the kernels where it holds. */
struct kind {
    size_t (*shape)(const struct primitive *primitive, double *shape);
    size_t (*table)(const struct primitive *primitive, double *table);
    struct kernels kernels;
    bool (*is_special)(const struct primitive *primitive);
    struct kernels special;
    const char *historical, *special_historical; /* the kernels of 1984 */
};

static const struct kind kinds[PRIMITIVE_KINDS] = {
    [PRIMITIVE_SPHERE] = {
        .shape = sphere_shape,
        .kernels = { "sphere", "normal_sphere", 1, NULL, NULL },
    },
    [PRIMITIVE_BOX] = {
        .shape = box_shape,
        .kernels = { "box", "normal_box", 1, NULL, NULL },
    },
    [PRIMITIVE_CYLINDER] = {
        .shape = cylinder_shape,
        .kernels = { "cylinder", "normal_cylinder", 1, NULL, NULL },
        .is_special = cylinder_is_open,
        .special = { "open_cylinder", "normal_open_cylinder", 1, NULL,
                     "cylinder" },
    },
    [PRIMITIVE_PLANE] = {
        .shape = plane_shape,
        .kernels = { "plane", "normal_plane", 1, NULL, NULL },
    },
    [PRIMITIVE_CONE] = {
        .shape = cone_shape,
        .kernels = { "cone", "normal_cone", 1, NULL, NULL },
        .is_special = cone_is_open,
        .special = { "open_cone", "normal_open_cone", 1, NULL, "cone" },
    },
    [PRIMITIVE_TORUS] = {
        .shape = torus_shape,
        .kernels = { "torus", "normal_torus", 2, "torus_solid", NULL },
    },
    [PRIMITIVE_ELLIPTICAL_TORUS] = {
        .shape = elliptical_torus_shape,
        .kernels = { "elliptical_torus", "normal_torus", 2,
                     "elliptical_torus_solid", NULL },
    },
    [PRIMITIVE_QUADRIC] = {
        .shape = quadric_shape,
        .kernels = { "quadric", "normal_quadric", 2, "quadric_solid", NULL },
    },
    [PRIMITIVE_QUARTIC] = {
        .shape = quartic_shape,
        .table = quartic_table,
        .kernels = { "quartic_surface", "normal_quartic", 3, "quartic_solid",
                     NULL },
    },
    [PRIMITIVE_STEINER_PATCH] = {
        .shape = patch_shape,
        .table = patch_table,
        .kernels = { "rational_steiner", "normal_rational_steiner", 0,
                     "rational_steiner_crossings", NULL },
        .is_special = steiner_is_polynomial,
        .special = { "steiner", "normal_steiner", 0, "steiner_crossings",
                     NULL },
        .historical = "rational_steiner_implicit",
        .special_historical = "steiner_implicit",
    },
};

void shape_words(const struct primitive *primitive, struct shape_words *shape)
{
    const struct kind *kind = &kinds[primitive->kind];
    bool special = kind->is_special && kind->is_special(primitive);
    const struct kernels *kernels = special ? &kind->special : &kind->kernels;

    shape->count = kind->shape(primitive, shape->words);
    shape->table_count = !kind->table ? 0
                                      : kind->table(primitive, shape->table);
    shape->kernel = kernels->kernel;
    shape->normal = kernels->normal;
    shape->solid = kernels->solid ? kernels->solid : kernels->kernel;
    shape->state = kernels->state;
    shape->on_patch = primitive->kind == PRIMITIVE_STEINER_PATCH;
    shape->historical = shape->table_count <= STEINER_TABLE ? NULL
                        : special ? kind->special_historical
                                  : kind->historical;
    shape->segments = kernels->segments;
    shape->events = shape->on_patch ? PATCH_CROSSINGS : 2 * shape->segments;
    shape->transformed = primitive->transformed
                         && primitive->kind != PRIMITIVE_PLANE;
    if (shape->transformed && primitive->kind == PRIMITIVE_SPHERE
        && carry_sphere(primitive, shape->words))
        shape->transformed = false;
}

bool shape_is_finite(const struct primitive *primitive)
{
    struct shape_words shape;
    bool finite = true;

    shape_words(primitive, &shape);
    for (size_t i = 0; i < shape.count; i++)
        finite = finite && isfinite(shape.words[i]);
    for (size_t i = 0; i < shape.table_count; i++)
        finite = finite && isfinite(shape.table[i]);
    return finite;
}
