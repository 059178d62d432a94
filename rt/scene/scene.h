/* scene.h - a scene as the scene language describes it, in world units.
 *
 * The numbers are doubles. rt/layout/layout.c converts them to the format of the
 * machine. The axes are left-handed as in POV-Ray: x right, y up, z away. Colours are
 * linear RGB, as in the file.
 */
#ifndef RT_SCENE_H
#define RT_SCENE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "rt/scene/image_map.h"

/* Maps x to x', where x'[i] = rows[i][0..2] . x + rows[i][3]. */
struct transform {
    double rows[3][4];
};

/* A camera. A picture has coordinates u and v from -1/2 to 1/2, with v upwards. The ray
 * through u, v starts at location. Its direction is direction + u right + v up, which
 * is not normalised. The ray of an orthographic camera starts at location + u right + v
 * up, and its direction is `direction`. */
struct camera {
    double location[3];
    double direction[3];
    double right[3];
    double up[3];
    bool orthographic;
    double lens_radius;    /* 0: no lens */
    double focal_distance; /* distance of the sharp plane, along direction */
    int lens_points;       /* least number of points on the lens for a pixel */
};

/* The largest value of lens_points, the number of points of a camera's lens. */
enum { MAX_LENS_POINTS = 256 };

/* The directions in which a light shines: all directions, or a beam around the axis
 * from its position to point_at. */
enum light_beam { BEAM_NONE, BEAM_CONE, BEAM_CYLINDER };

/* The largest number of points in an area light. */
enum { MAX_AREA_POINTS = 65536 };

struct light {
    double position[3];
    double color[3];
    bool shadowless; /* casts no shadow and, as in POV-Ray, no phong or specular
                      * highlight */
    bool parallel;   /* All rays are parallel to the axis. A cone with this flag
                      * contains every point. A cylinder always has parallel rays. */
    enum light_beam beam;
    double point_at[3];
    double radius, falloff; /* The intensity is full within `radius` and 0 outside of
                             * `falloff`. Both are angles from the axis in degrees for a
                             * cone, and distances from the axis for a cylinder. */
    double tightness;       /* exponent of the cosine of the angle from the axis (cone),
                             * or of 1 - distance / falloff (cylinder) */
    double area_axes[2][3]; /* edges of a parallelogram whose centre is `position` */
    size_t area_size[2];    /* number of points along each edge, from which shadows are
                             * cast; 0: no area */
    bool circular;          /* the area is an ellipse */
    double fade_distance, fade_power; /* The light is multiplied by 2 / (1 + (distance /
                                       * fade_distance) ^ fade_power) if fade_distance
                                       * and fade_power are not 0. */
};

/* POV-Ray's finish. The defaults (3.7) are ambient .1, diffuse .6, phong_size 40,
 * roughness .05, brilliance and falloff 1, reflection black, and 0 for all others. */
struct finish {
    double ambient[3];         /* factor for the ambient light */
    double emission[3];        /* added to the colour; has no factor */
    double reflection[3];      /* at perpendicular incidence */
    double reflection_most[3]; /* at grazing incidence */
    double reflection_falloff; /* exponent of 1 - cosine when both reflections are
                                * interpolated */
    bool fresnel;              /* interpolate by Fresnel's formulas */
    double reflection_metallic;
    double diffuse, brilliance; /* brilliance: exponent of the cosine in the diffuse
                                 * light */
    double phong, phong_size;
    double specular, roughness;
    double metallic; /* fraction of the pigment's colour in highlights */
    double ior;      /* refractive index of the interior, in old scenes; 0: not
                      * specified */
};

enum pigment_kind {
    PIGMENT_COLOR,
    PIGMENT_CHECKER,
    PIGMENT_GRADIENT,
    PIGMENT_PATTERN, /* any other pattern with a map */
    PIGMENT_IMAGE
};

/* A colour at a value from 0 to 1. The values of a map do not decrease. Colours are
 * interpolated linearly between two stops. Beyond the ends the first or last stop
 * defines the colour. */
struct color_stop {
    double at, color[3];
    double filter, transmit; /* only used in checkers, because the colours of a map are
                              * opaque */
};
struct color_map {
    size_t count;
    const struct color_stop *stops; /* owned by the scene */
    size_t clear; /* number of stops that transmit light in the scene file */
};

/* A pattern maps a point to a value. A wave function then transforms the value. The
 * formulas are in rt/scene/patterns.def and rt/kernels/light/pattern.s. */
enum pattern_function {
#define PATTERN(KIND, ...) PATTERN_##KIND,
#include "rt/scene/patterns.def"
    PATTERN_FUNCTIONS
};
enum pattern_wave {
    WAVE_RAMP,
    WAVE_TRIANGLE,
    WAVE_SINE,
    WAVE_SCALLOP,
    WAVE_CUBIC,
    WAVE_POLY,
    PATTERN_WAVES
};
/* The parameters of a pattern, except its wave. */
struct pattern_parameters {
    double brick_size[3], mortar;
};
struct pattern {
    enum pattern_function function;
    enum pattern_wave wave;
    double frequency, phase, exponent;
    struct pattern_parameters own;
};
/* The members of a row of patterns.def. */
enum { MAX_LISTED = 3 };
struct pattern_rule {
    const char *routine;           /* kernel that computes the value of the pattern at a
                                    * point */
    bool round;                    /* points with the values 0 and 1 are the same */
    size_t listed;                 /* number of colours in its list; 0: none */
    double colors[MAX_LISTED][3];  /* default colours of the list */
    struct pattern_parameters own; /* default parameters */
};
extern const struct pattern_rule pattern_rules[PATTERN_FUNCTIONS];

struct pigment {
    enum pigment_kind kind;
    double color[2][3];        /* checker: where floor(x) + floor(y) + floor(z) is even,
                                * and odd; image: inside, and outside; gradient: only
                                * the first */
    double filter[2];          /* fraction of light that is transmitted and coloured */
    double transmit[2];        /* fraction of light that is transmitted unchanged */
    struct transform to_local; /* from world space to the space of the pattern */
    double axis[3];            /* unit axis of a gradient; the value is the fractional
                                * part of the coordinate along the axis */
    struct pattern pattern;
    struct color_map map; /* of a list: its colours at 0, 1 .. */
    struct image_map image;
};
bool pigment_has_map(const struct pigment *pigment);
/* Returns the number of cells that may transmit light differently. It is 2 for a
 * checker and for a bounded image, else 1. */
int pigment_cells(const struct pigment *pigment);
/* Returns true if the pigment has a map or an image. If the sky has such a pigment, its
 * colour depends on the direction. */
bool pigment_makes_sky(const struct pigment *pigment);
/* Returns true if at least one colour of the pigment transmits light. */
bool pigment_is_clear(const struct pigment *pigment);
/* Returns the number of colours in the list of the pattern, or 0 if it has no list. */
size_t pigment_list_count(const struct pigment *pigment);
/* Returns the value at which the map contains colour i of the list: the wave function
 * of i. i starts at 0. */
double pigment_list_value(const struct pigment *pigment, size_t i);
struct color_stop pigment_listed(const struct pigment *pigment, size_t i);

/* An entry of a slope_map: the height and the slope at a value. */
struct slope_stop {
    double at, height, slope;
};

/* A bump: heights of points that come from a pattern and an optional slope_map. A bump
 * of kind PIGMENT_COLOR has no heights and changes no normal. */
struct bump {
    struct pigment pattern; /* its colours are not used */
    double amount, accuracy;
    double controls[2]; /* parameters of `quilted` */
    size_t stop_count;
    const struct slope_stop *stops; /* owned by the scene */
};

/* The change of a surface's normals: one bump, or a list of bumps. The pattern of the
 * first bump is in the space of the list, and selects between the entries. */
struct bump_entry {
    double at; /* value in the map; in an average, the weight */
    struct bump bump;
};
struct bump_list {
    struct bump bump;
    bool average; /* all entries are added */
    size_t count; /* 0: `bump` itself is used */
    const struct bump_entry *entries;
};
struct bumps {
    const struct bump_list *list; /* owned by the scene; NULL: none */
    struct transform to_local;    /* from world space to the space of the pattern */
    bool unscaled; /* this map does not scale the normals (no_bump_scale) */
};
/* Returns true if the bumps change the normal at any point. */
bool bumps_show(const struct bumps *bumps);

/* Fog of constant density. The fraction 1/e of the light passes `distance` unchanged.
 * At any distance at least the fraction `transmit` passes. */
struct fog {
    double distance; /* above 0 */
    double color[3], filter, transmit;
};
enum { MAX_FOGS = 16 };

struct primitive; /* declared in rt/shapes/primitive.h */

/* A node of a Boolean tree over primitives. The nodes are in preorder: the subtrees of
 * a node's children follow the node in order. A difference is the intersection of its
 * first child with the complements of its other children. */
enum tree_operation { TREE_LEAF, TREE_AND, TREE_OR, TREE_NOT };

struct tree_node {
    enum tree_operation operation;
    size_t next;      /* index of the first node after the subtree */
    size_t primitive; /* leaf: index of its primitive in the scene */
};

/* An object that a statement of the file adds to the world. */
struct world_object {
    const char *name;     /* name of the #declare that it comes from, or NULL */
    const char *material; /* name of the #declare of its texture, or NULL; if it has
                           * several textures, the first; subtracted parts are
                           * ignored */
    bool mixed;           /* it has several materials */
    size_t line;          /* line of the statement in the main file */
};

/* A float that #declare names. */
struct declared_float {
    const char *name;
    double value;
};

/* A unit of tracing: a primitive, or a Boolean tree of primitives. A union that is not
 * part of another solid becomes several regions. */
struct region {
    size_t first_primitive, primitive_count; /* its leaves in order */
    size_t first_node, node_count;           /* range in the scene's nodes */
    size_t line;
    double yield; /* yield times k_delta is added to the distances of its opaque
                   * surfaces before they are compared with distances of other regions
                   * (rt/shapes/coincident.h) */
};

struct scene {
    int unit_log; /* lengths in the file are lengths in this scene times 2^unit_log; 0
                   * for a scene of ordinary size (scene_unit.h) */
    struct camera camera;
    double background[3];
    struct pigment sky; /* colour of a direction, drawn before the background; without a
                         * map or an image there is no sky */
    size_t image_count; /* number of images */
    size_t fog_count;
    struct fog fogs[MAX_FOGS];
    double ambient_light[3];
    double assumed_gamma; /* 0: not specified */
    bool gamma_off;       /* colours are displayed without correction, as in versions
                           * below 3.7 */
    int max_trace_level;  /* number of rays in a chain of reflections, including the
                           * camera ray; straight transmitted rays do not count */
    double adc_bailout;   /* rays of smaller weight are not traced */
    size_t light_count;
    struct light *lights;
    size_t primitive_count;
    struct primitive *primitives; /* in the order of the file */
    size_t node_count;
    struct tree_node *nodes;
    size_t region_count;
    struct region *regions;        /* in the order of the file */
    size_t object_count;           /* number of objects that statements add to the
                                    * world */
    struct world_object *objects;  /* owned by the scene */
    size_t float_count;            /* number of named floats, which have their values at
                                    * the end of the file */
    struct declared_float *floats; /* owned by the scene */
    bool every_crossing;           /* queries return all crossings of a ray, not the
                                    * first hit, so no region counts as simple */
    struct arena kept;             /* storage that primitives point to */
};
void scene_free(struct scene *scene);

#endif
