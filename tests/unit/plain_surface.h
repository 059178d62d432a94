/* plain_surface.h - surfaces of one or more primitives, and rays that hit them, for the
 * tests of the plain tracer's shapes. */
#ifndef TESTS_PLAIN_SURFACE_H
#define TESTS_PLAIN_SURFACE_H

#include "tests/oracle/plain_shapes.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

#define PI 3.14159265358979323846
#define CLOSE 1e-12
#define START 1e-6 /* nearer crossings are at the ray's origin */

void assert_near(double found, double expected, double within);
double number_between(uint64_t *random, double low, double high);
void random_direction(uint64_t *random, double direction[3]);

/* ---- Crossings of a surface of many parts ------------------------------- */

enum { MAX_PARTS = 16 };
struct surface {
    size_t count;
    struct primitive parts[MAX_PARTS];
};

struct spelling {
    double distance; /* infinite: no hit */
    double normal[3];
};

struct spelling shoot(const struct surface *surface, const struct ray *ray);
struct surface one(enum primitive_kind kind);

/* A ray, its expected distance (0: no hit), and the expected normal against it. */
struct expectation {
    double origin[3], direction[3];
    double distance, normal[3];
};

void assert_hits(const struct surface *surface, const struct expectation *rows,
                 size_t count);
#define ASSERT_HITS(surface, rows) \
    assert_hits(surface, rows, sizeof(rows) / sizeof *(rows))

/* ---- Volumes ------------------------------------------------------------ */

/* Estimates the volume with parallel oblique rays through a grid from -size to size. */
double volume(const struct surface *surface, double size);

/* ---- Two equal surfaces --------------------------------------------------- */

/* Sets the coefficient of the term of a quartic with these powers of x, y and z. */
void set_coefficient(struct surface *surface, int x, int y, int z, double value);

/* Compares two surfaces with random rays. Rays that graze a surface may differ, because
 * rounding decides whether they hit. */
void assert_same_surface(const struct surface *a, const struct surface *b, double size);

#endif
