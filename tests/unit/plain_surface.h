/* plain_surface.h - surfaces of one or more primitives, and rays at them, for
 * the tests of the plain tracer's shapes. */
#ifndef TESTS_PLAIN_SURFACE_H
#define TESTS_PLAIN_SURFACE_H

#include "tests/oracle/plain_shapes.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

#define PI 3.14159265358979323846
#define CLOSE 1e-12
#define START 1e-6 /* nearer crossings are the ray's own start */

void assert_near(double found, double expected, double within);
double number_between(uint64_t *random, double low, double high);
void random_direction(uint64_t *random, double direction[3]);

/* --- crossings of a surface of many parts -------------------------------- */

enum { MAX_PARTS = 16 };
struct surface {
    size_t count;
    struct primitive parts[MAX_PARTS];
};

struct spelling {
    double distance; /* infinite: none */
    double normal[3];
};

struct spelling shoot(const struct surface *surface, const struct ray *ray);
struct surface one(enum primitive_kind kind);

/* One ray: the distance (0: none), the normal that faces it. */
struct expectation {
    double origin[3], direction[3];
    double distance, normal[3];
};

void assert_hits(const struct surface *surface, const struct expectation *rows,
                 size_t count);
#define ASSERT_HITS(surface, rows) \
    assert_hits(surface, rows, sizeof(rows) / sizeof *(rows))

/* --- volumes ------------------------------------------------------------- */

/* By parallel rays from a grid over -size .. size, in a slanted direction. */
double volume(const struct surface *surface, double size);

/* --- two surfaces that are one -------------------------------------------- */

/* A coefficient of a quartic by the powers of x and y and z. */
void set_coefficient(struct surface *surface, int x, int y, int z, double value);

/* Random rays at both; where they graze, a rounding decides. */
void assert_same_surface(const struct surface *a, const struct surface *b, double size);

#endif
