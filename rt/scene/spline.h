/* spline.h - splines: values interpolated between given points. */
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
    double pivot;              /* pivot of their equations */
};

/* The points are sorted by their parameters, which are distinct. */
struct spline {
    enum spline_kind kind;
    int terms;                   /* in the values, as written in the scene */
    size_t holders;              /* reference count */
    double latest[SPLINE_TERMS]; /* the value that was added last */
    size_t count;
    struct spline_point *points;
};

/* Returns a spline with the points of another one, or without points if that is NULL.
 * Returns NULL without memory. */
struct spline *spline_new(const struct spline *from);
void spline_release(struct spline *spline);

/* Returns the index of the first point whose parameter is not less than t; the count if
 * t is at or after the last point. */
size_t spline_find(const struct spline *spline, double t);
/* Adds a point whose value has this number of terms. Fails without memory. */
bool spline_add(struct spline *spline, double t, const double *value, int terms);
/* Computes the second derivatives of a natural spline. It is called after the last
 * point. */
void spline_solve(struct spline *spline);
/* Computes the terms of the value at t, as a spline of this kind. The spline has at
 * least one point. */
void spline_value(const struct spline *spline, enum spline_kind kind, double t,
                  double value[SPLINE_TERMS]);

#endif
