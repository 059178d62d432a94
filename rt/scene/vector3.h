/* vector3.h - arithmetic on vectors of doubles, mostly of three components. */
#ifndef RT_SCENE_VECTOR3_H
#define RT_SCENE_VECTOR3_H

#include <math.h>
#include <stdbool.h>
#include <string.h>

#define PI 3.14159265358979323846

static inline bool equal2(const double a[2], const double b[2])
{
    return a[0] == b[0] && a[1] == b[1];
}

static inline double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double length3(const double a[3])
{
    return sqrt(dot3(a, a));
}

static inline void copy3(const double from[3], double to[3])
{
    memcpy(to, from, 3 * sizeof *to);
}

static inline void subtract3(const double a[3], const double b[3], double difference[3])
{
    for (int i = 0; i < 3; i++)
        difference[i] = a[i] - b[i];
}

/* Returns the greatest absolute value of a component. Unlike the length, it cannot
 * overflow. */
static inline double greatest3(const double a[3])
{
    return fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2])));
}

static inline void scale3(double by, double a[3])
{
    for (int i = 0; i < 3; i++)
        a[i] *= by;
}

/* Computes the cross product a x b, which must not alias a or b. */
static inline void cross3(const double a[3], const double b[3], double product[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        product[i] = a[j] * b[k] - a[k] * b[j];
    }
}

#endif
