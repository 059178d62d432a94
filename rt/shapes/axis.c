/* axis.c - computes the frames of shapes about an axis. */
#include "rt/shapes/axis.h"

#include <stddef.h>

#include "rt/scene/vector3.h"

/* Computes two unit vectors that are perpendicular to the unit vector w and to each
 * other. */
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

double axis_words(const double base[3], const double cap[3], double *words)
{
    double axis[3];
    double length;
    for (size_t i = 0; i < 3; i++) {
        words[i] = (base[i] + cap[i]) / 2;
        axis[i] = cap[i] - base[i];
    }
    length = length3(axis);
    for (size_t i = 0; i < 3; i++)
        words[9 + i] = axis[i] / length;
    frame_about(words + 9, words + 3, words + 6);
    return length;
}

bool axis_is_point(const double base[3], const double cap[3])
{
    return base[0] == cap[0] && base[1] == cap[1] && base[2] == cap[2];
}

const char *axis_make_normal(double normal[3])
{
    double length = length3(normal);
    if (length == 0 || !isfinite(length))
        return "the normal has no direction";
    scale3(1 / length, normal);
    return NULL;
}
