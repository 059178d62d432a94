/* surface.h - the light that a surface transmits and reflects. */
#ifndef RT_SURFACE_H
#define RT_SURFACE_H

#include "rt/scene/scene.h"

/* How the reflection depends on the angle: the values of P_REFLECTION_KIND. */
enum mirror_kind { MIRROR_CONSTANT, MIRROR_POWER, MIRROR_FRESNEL };

bool surface_is_mirror(const struct finish *finish);
enum mirror_kind surface_mirror_kind(const struct finish *finish);
/* Returns true if a finish of the scene needs the kernel light/gloss.s. */
bool scene_is_glossy(const struct scene *scene);
/* Computes the transmitted fraction of the light, per channel, for one of the
 * pigment's colours. */
void surface_passing(const struct pigment *pigment, int which, double passing[3]);
/* Returns the weight of a transmitted ray: the largest channel, or a negative
 * number if the ray is not followed. */
double surface_passing_weight(const double passing[3], double least);
/* Returns the fraction of the light that is not transmitted. */
double surface_opacity(const struct pigment *pigment, int which);
/* Computes the pigment's colour times its opacity. */
void surface_color(const struct pigment *pigment, int which, double color[3]);
/* Returns true if the opacity is applied in the finish, because a metal shows its
 * full colour. This is impossible if the two colours of a checker differ in
 * opacity. */
bool surface_is_metal(const struct pigment *pigment, const struct finish *finish);
/* Returns the weight of a colour. As in POV-Ray, a negative channel counts by its
 * absolute value. */
double greatest_of(const double color[3]);

#endif
