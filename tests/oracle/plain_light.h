/* plain_light.h - surfaces, lights and camera rays of the plain tracer. */
#ifndef PLAIN_LIGHT_H
#define PLAIN_LIGHT_H

#include "tests/oracle/plain_regions.h"

/* A scene, and a buffer for the crossings with one region. */
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
    double point[3], before[3]; /* point, and the normal before bumps, opposed to the
                                 * ray */
    double normal[3];           /* normal after bumps */
    double pigment[3];
    double color[3];   /* colour of the opaque part */
    double passing[3]; /* transmitted fraction of each channel */
};

/* Returns the position in the pigment's map for a point in the pattern's space. */
double plain_pattern(const struct pigment *pigment, const double point[3]);

/* Changes a unit normal at a point by the bumps. unit is the scene's unit of length. */
void plain_bumps(const struct bumps *bumps, double unit, const double point[3],
                 double normal[3]);

/* Returns true if a point in the pigment's space is outside of the image. */
bool plain_image_misses(const struct image_map *map, const double point[3]);
/* Computes the image's colour at a point that is not outside. */
void plain_image(const struct image_map *map, const double point[3], double color[3]);

/* Computes the colour of a map or an image at a point, or a sky's at a direction. */
void plain_map_color(const struct pigment *pigment, const double point[3],
                     double color[3]);

void plain_describe(const struct scene *scene, const struct ray *ray,
                    const struct plain_hit *hit, struct plain_surface *surface);

/* Sets color to the fraction of the reflected ray's colour that the surface adds. index
 * is the refractive index of the far side divided by the index of the near side;
 * Fresnel's formulas use it. Returns POV-Ray's weight of the ray: the greatest channel
 * of color before the metallic change. For a reflection by a power of the angle it is
 * the greatest weight over all angles. */
double plain_mirror(const struct plain_surface *surface, double index, double color[3]);

/* Computes the colour of the surface without refraction and reflection: the ambient
 * light, and the lights, attenuated by the surfaces in front of them. */
void plain_shade(const struct plain_tracer *tracer, const struct plain_surface *surface,
                 double color[3]);

/* Returns the rays across and down a pixel, which is 1 for a camera without a lens. */
size_t plain_samples(const struct camera *camera);

/* Returns the ray of sample x, y in a picture of width x height samples. */
struct ray plain_camera_ray(const struct camera *camera, size_t width, size_t height,
                            size_t x, size_t y);

#endif
