#include "rt/layout/surface.h"

#include <math.h>

double greatest_of(const double color[3])
{
    return fmax(fabs(color[0]), fmax(fabs(color[1]), fabs(color[2])));
}

bool surface_is_mirror(const struct finish *finish)
{
    return finish->reflection[0] != 0 || finish->reflection[1] != 0
           || finish->reflection[2] != 0;
}

void surface_passing(const struct pigment *pigment, int which,
                     double passing[3])
{
    for (int i = 0; i < 3; i++)
        passing[i] = pigment->filter[which] * pigment->color[which][i]
                     + pigment->transmit[which];
}

/* POV-Ray's: what passes more dimly than the limit is not followed, whatever
 * its greatest part. */
double surface_passing_weight(const double passing[3], double least)
{
    double brightness = .297 * passing[0] + .589 * passing[1]
                        + .114 * passing[2];

    return brightness > least ? greatest_of(passing) : -1;
}

void surface_color(const struct pigment *pigment, int which, double color[3])
{
    double share = 1 - pigment->filter[which] - pigment->transmit[which];

    for (int i = 0; i < 3; i++)
        color[i] = share * pigment->color[which][i];
}
