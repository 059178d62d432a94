/* surface.h - what of the light a surface lets through and gives back. */
#ifndef RT_SURFACE_H
#define RT_SURFACE_H

#include "rt/scene/scene.h"

/* How a mirror's colour depends on the angle, as P_REFLECTION_KIND has it. */
enum mirror_kind { MIRROR_CONSTANT, MIRROR_POWER, MIRROR_FRESNEL };

bool surface_is_mirror(const struct finish *finish);
enum mirror_kind surface_mirror_kind(const struct finish *finish);
/* Whether the kernels need light/gloss.s for one of its finishes. */
bool scene_is_glossy(const struct scene *scene);
/* Of a pigment's colours: the light that goes through, per channel. */
void surface_passing(const struct pigment *pigment, int which, double passing[3]);
/* .. and what a ray that goes through weighs: the greatest of it, or less than
 * nothing. */
double surface_passing_weight(const double passing[3], double least);
/* .. the share of the light that stays, */
double surface_opacity(const struct pigment *pigment, int which);
/* .. and the pigment as that light sees it: times its opacity. */
void surface_color(const struct pigment *pigment, int which, double color[3]);
/* Whether the opacity is in the finish, since a metal shows all of its colour:
 * not if a checker's colours have two of them. */
bool surface_is_metal(const struct pigment *pigment, const struct finish *finish);
/* What a colour weighs: POV-Ray takes a negative one by its size. */
double greatest_of(const double color[3]);

#endif
