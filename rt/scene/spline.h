/* spline.h - splines: the values of a parameter between given points. */
#ifndef RT_SCENE_SPLINE_H
#define RT_SCENE_SPLINE_H

#include <stdbool.h>
#include <stddef.h>

enum spline_kind {
    SPLINE_LINEAR, /* the default */
    SPLINE_QUADRATIC,
    SPLINE_CUBIC, /* a Catmull-Rom spline */
    SPLINE_NATURAL,
    SPLINE_KINDS
};

enum { SPLINE_TERMS = 5 };
struct spline_point {
    double t, value[SPLINE_TERMS];
    double bend[SPLINE_TERMS]; /* second derivatives of a natural spline */
    double pivot;              /* for their equations */
};

/* The points are in the order of their parameters, no two of them equal. */
struct spline {
    enum spline_kind kind;
    int terms;                   /* of the values, as the scene wrote them */
    size_t holders;              /* the spline is freed with the last of them */
    double latest[SPLINE_TERMS]; /* the value that was added last */
    size_t count;
    struct spline_point *points;
};

/* A spline with the points of another one, or without points if that is NULL;
 * NULL: no memory. */
struct spline *spline_new(const struct spline *from);
void spline_release(struct spline *spline);

/* The first point that is not before the parameter; the count from the last
 * point on. */
size_t spline_find(const struct spline *spline, double t);
/* Adds a point whose value has that many terms.  False: no memory. */
bool spline_add(struct spline *spline, double t, const double *value, int terms);
/* After the last point: computes the second derivatives. */
void spline_solve(struct spline *spline);
/* The terms of the value, as a spline of that kind; of one point or more. */
void spline_value(const struct spline *spline, enum spline_kind kind, double t,
                  double value[SPLINE_TERMS]);

#endif
