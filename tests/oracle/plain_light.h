/* plain_light.h - the plain tracer's surfaces, lights and camera rays, by POV-Ray's
 * rules. */
#ifndef PLAIN_LIGHT_H
#define PLAIN_LIGHT_H

#include "tests/oracle/plain_regions.h"

/* A scene, and a buffer for the crossings with any of its regions. */
struct plain_tracer {
    const struct scene *scene;
    struct crossing_list *crossings;
    bool clear; /* the scene has a transparent pigment */
};

/* The surface at a ray's hit. */
struct plain_surface {
    const struct ray *ray;
    const struct finish *finish;
    const struct bumps *bumps;
    double point[3], before[3]; /* the normal, against the ray */
    double normal[3];           /* the normal after bumps */
    double pigment[3];
    double color[3];   /* of the opaque share */
    double passing[3]; /* transmission of each channel */
};

/* Returns the position in the pigment's map of a point in the pattern's space. */
double plain_pattern(const struct pigment *pigment, const double point[3]);

/* Changes a unit normal at a point by the bumps; unit is the scene's unit of length. */
void plain_bumps(const struct bumps *bumps, double unit, const double point[3],
                 double normal[3]);

/* Returns whether a point of the pigment's space is outside of the image. */
bool plain_image_misses(const struct image_map *map, const double point[3]);
/* Sets the image's colour at a point that is not outside. */
void plain_image(const struct image_map *map, const double point[3], double color[3]);

/* Sets the colour of a pigment with a map or an image: at a point or, for a sky, in a
 * direction. */
void plain_map_color(const struct pigment *pigment, const double point[3],
                     double color[3]);

void plain_describe(const struct scene *scene, const struct ray *ray,
                    const struct plain_hit *hit, struct plain_surface *surface);

/* Sets color to the share of the reflected ray's colour that the surface adds.  index,
 * the refractive index of the far side divided by that of the near side, is used by
 * Fresnel's formulas.  Returns POV-Ray's weight of the ray: the greatest channel of
 * color before the metallic change; for a reflection by a power of the angle, the
 * greatest over all angles. */
double plain_mirror(const struct plain_surface *surface, double index, double color[3]);

/* Computes the surface's colour without refraction and reflection: the ambient light,
 * and each light after attenuation by the surfaces in front of it. */
void plain_shade(const struct plain_tracer *tracer, const struct plain_surface *surface,
                 double color[3]);

/* Returns the number of rays per pixel in each direction: 1 for a camera without a
 * lens. */
size_t plain_samples(const struct camera *camera);

/* Returns the ray of sample x, y in a picture of width x height samples. */
struct ray plain_camera_ray(const struct camera *camera, size_t width, size_t height,
                            size_t x, size_t y);

#endif
