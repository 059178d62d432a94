/* plain_shapes.h - intersections of lines with primitives, for the plain tracer.
 *
 * They are derived from the geometry of each shape in its own space. They share no code
 * with the kernels.
 */
#ifndef PLAIN_SHAPES_H
#define PLAIN_SHAPES_H

#include "rt/shapes/primitive.h"

#include <math.h>
#include <stdbool.h>

struct ray {
    double origin[3], direction[3]; /* of any nonzero length */
};

/* A crossing of a ray with a surface, at origin + distance * direction. */
struct crossing {
    double distance;
    double normal[3]; /* of any length, on either side */
};

/* The largest number of crossings of a prism. A quartic has up to 4. A mesh may have
 * more; the list then has its first crossings ahead of the origin. */
enum { MAX_CROSSINGS = 40 };

/* Computes all crossings of the whole line, in any order, and returns their number. */
typedef size_t cross_shape(const struct primitive *primitive, const struct ray *ray,
                           struct crossing crossings[MAX_CROSSINGS]);
cross_shape plain_crossings;
#define CROSS(name) \
    size_t name(const struct primitive *primitive, const struct ray *ray, \
                struct crossing crossings[MAX_CROSSINGS])

/* Returns true if a point of the primitive's own space is inside. A patch and a mesh
 * without an inside_vector have no inside. */
typedef bool enclose_point(const struct primitive *primitive, const double point[3]);
enclose_point plain_encloses;
#define ENCLOSE(name) \
    bool name(const struct primitive *primitive, const double point[3])

/* A cone (a cylinder has equal radii), or an elliptical or circular torus. */
struct round {
    const double *base, *cap;
    double base_radius, cap_radius;
    bool open;
};
struct torus {
    double major, radial, axial;
};
/* Intersects the line with the horizontal plane at this height. Computes the point. */
bool cross_level(double height, const struct ray *ray, struct crossing *crossing,
                 double point[3]);
struct round round_of(const struct primitive *primitive);
struct torus torus_of(const struct primitive *primitive);

/* The files tests/oracle/plain_*.c define these functions. */
#define SHAPE(KIND, name, ...) \
    cross_shape cross_##name; \
    enclose_point in_##name;
#include "rt/shapes/shapes.def"

/* ---- Vectors ------------------------------------------------------------- */

static inline double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns the greatest absolute value of the components. */
static inline double greatest(const double a[3])
{
    return fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2])));
}

/* Computes result = a + scale b. result may alias a or b. */
static inline void add_scaled(double result[3], const double a[3], double scale,
                              const double b[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] + scale * b[i];
}

static inline void copy(double to[3], const double from[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

static inline void scale_by(double a[3], double scale)
{
    for (int i = 0; i < 3; i++)
        a[i] *= scale;
}

static inline void normalise(double a[3])
{
    scale_by(a, 1 / sqrt(dot(a, a)));
}

static inline void cross_product(const double a[3], const double b[3],
                                 double product[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        product[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* Maps a point by a transform. */
static inline void to_other_space(const struct transform *transform, const double in[3],
                                  double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = dot(transform->rows[i], in) + transform->rows[i][3];
}

/* Transforms a normal by the transposed matrix. */
static inline void transposed(const struct transform *transform, const double in[3],
                              double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = transform->rows[0][i] * in[0] + transform->rows[1][i] * in[1]
                 + transform->rows[2][i] * in[2];
}

static inline void point_on(const struct ray *ray, double distance, double point[3])
{
    add_scaled(point, ray->origin, distance, ray->direction);
}

#endif
