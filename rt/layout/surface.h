/* surface.h - computes the fractions of light that a surface transmits and reflects,
 * from its pigment and finish. */
#ifndef RT_SURFACE_H
#define RT_SURFACE_H

#include "rt/scene/scene.h"

/* How the reflection depends on the angle: the values of P_REFLECTION_KIND. */
enum mirror_kind { MIRROR_CONSTANT, MIRROR_POWER, MIRROR_FRESNEL };

bool surface_is_mirror(const struct finish *finish);
enum mirror_kind surface_mirror_kind(const struct finish *finish);
/* Returns true if a finish of the scene needs the kernel light/gloss.s. */
bool scene_is_glossy(const struct scene *scene);
/* Computes the fraction of light that the colour `which` of the pigment transmits, for
 * each channel. */
void surface_passing(const struct pigment *pigment, int which, double passing[3]);
/* Returns the weight of a transmitted ray, which is the largest channel of `passing`.
 * Returns a negative number if the brightness of `passing` is at most `least`, because
 * such a ray is not traced. */
double surface_passing_weight(const double passing[3], double least);
/* Returns the fraction of the light that the colour `which` of the pigment does not
 * transmit. */
double surface_opacity(const struct pigment *pigment, int which);
/* Computes the colour `which` of the pigment, multiplied by its opacity. */
void surface_color(const struct pigment *pigment, int which, double color[3]);
/* Returns true if the opacity multiplies the finish, not the colour, because a metal
 * reflects in its full colour. This is impossible if the two colours of a checker have
 * different opacities. */
bool surface_is_metal(const struct pigment *pigment, const struct finish *finish);
/* Returns the weight of a colour as in POV-Ray: the largest absolute value of its
 * channels. */
double greatest_of(const double color[3]);

#endif
