/* spline.h - evaluates splines, which interpolate values between given points. */
#ifndef RT_SCENE_SPLINE_H
#define RT_SCENE_SPLINE_H

#include <stdbool.h>
#include <stddef.h>

enum spline_kind {
    SPLINE_LINEAR, /* the default */
    SPLINE_QUADRATIC,
    SPLINE_CUBIC, /* Catmull-Rom */
    SPLINE_NATURAL,
    SPLINE_KINDS
};

enum { SPLINE_TERMS = 5 };
struct spline_point {
    double t, value[SPLINE_TERMS];
    double bend[SPLINE_TERMS]; /* second derivatives of a natural spline */
    double pivot;              /* pivot of the equations for these derivatives */
};

/* The points are sorted by their parameters, which are distinct. */
struct spline {
    enum spline_kind kind;
    int terms;                   /* number of terms of the values in the scene */
    size_t holders;              /* reference count */
    double latest[SPLINE_TERMS]; /* the value that was last added */
    size_t count;
    struct spline_point *points;
};

/* Returns a spline with the points of `from`, or without points if `from` is NULL.
 * Returns NULL if out of memory. */
struct spline *spline_new(const struct spline *from);
void spline_release(struct spline *spline);

/* Returns the index of the first point whose parameter is not below t. If there is
 * none, returns the number of points. */
size_t spline_find(const struct spline *spline, double t);
/* Adds a point. `terms` is the number of terms of its value. Returns false if out of
 * memory. */
bool spline_add(struct spline *spline, double t, const double *value, int terms);
/* Computes the second derivatives of a natural spline. Call it after the last point has
 * been added. */
void spline_solve(struct spline *spline);
/* Computes the value at t by the rules of this kind. The spline must have at least one
 * point. */
void spline_value(const struct spline *spline, enum spline_kind kind, double t,
                  double value[SPLINE_TERMS]);

#endif
