/* plain_light.h - the plain tracer's surfaces and lights, by POV-Ray's rules.
 */
#ifndef PLAIN_LIGHT_H
#define PLAIN_LIGHT_H

#include "tests/oracle/plain_regions.h"

/* A scene, and room for the crossings with any of its regions. */
struct plain_tracer {
    const struct scene *scene;
    struct crossing_list *crossings;
    bool clear; /* something of it is */
};

/* What a ray sees where it hits something. */
struct plain_surface {
    const struct ray *ray;
    const struct finish *finish;
    const struct bumps *bumps;
    double point[3], before[3]; /* the normal against the ray .. */
    double normal[3];           /* .. and as bumps change it */
    double pigment[3];
    double color[3];   /* of what is opaque of it */
    double passing[3]; /* what it lets through, per channel */
};

/* Where among the stops of the pigment's map a point of the pattern's space is. */
double plain_pattern(const struct pigment *pigment, const double point[3]);

/* A normal of length one at a point, as the bumps change it; the scene's unit of
 * length. */
void plain_bumps(const struct bumps *bumps, double unit, const double point[3],
                 double normal[3]);

/* Whether a point of the pigment's space is outside of an image. */
bool plain_image_misses(const struct image_map *map, const double point[3]);
/* .. and the image's colour of any other. */
void plain_image(const struct image_map *map, const double point[3], double color[3]);

/* The colour of a pigment with a map or an image at a point, of a sky in a
 * direction. */
void plain_map_color(const struct pigment *pigment, const double point[3],
                     double color[3]);

void plain_describe(const struct scene *scene, const struct ray *ray,
                    const struct plain_hit *hit, struct plain_surface *surface);

/* What of a mirrored ray's colour the surface gives back; the index of what is
 * behind it to what is before it counts in Fresnel's formulas.  Returns what
 * the ray weighs, POV-Ray's: the greatest part of that colour before it is made
 * metallic, but by a power of the angle the greatest of all angles. */
double plain_mirror(const struct plain_surface *surface, double index, double color[3]);

/* The surface's colour without what comes through it or is mirrored: ambient,
 * and what each light adds through what is before it. */
void plain_shade(const struct plain_tracer *tracer, const struct plain_surface *surface,
                 double color[3]);

#endif
