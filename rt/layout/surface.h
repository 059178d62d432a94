/* surface.h - what of the light a surface lets through and gives back. */
#ifndef RT_SURFACE_H
#define RT_SURFACE_H

#include "rt/scene/scene.h"

bool surface_is_mirror(const struct finish *finish);
/* Of a pigment's colours: the light that goes through, per channel. */
void surface_passing(const struct pigment *pigment, int which,
                     double passing[3]);
/* .. and what a ray that goes through weighs: the greatest of it, or less than
 * nothing. */
double surface_passing_weight(const double passing[3], double least);
/* .. and the pigment as the light that stays sees it: times its opacity. */
void surface_color(const struct pigment *pigment, int which, double color[3]);
/* What a colour weighs: POV-Ray takes a negative one by its size. */
double greatest_of(const double color[3]);

#endif
