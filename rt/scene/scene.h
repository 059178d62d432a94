/* scene.h - a scene as the scene language describes it, in world units.
 *
 * Its numbers are doubles; rt/layout/layout.c converts them to the format of the
 * machine. The axes are left-handed as in POV-Ray: x right, y up, z away. Colours are
 * linear RGB as the file gives them.
 */
#ifndef RT_SCENE_H
#define RT_SCENE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "rt/scene/image_map.h"

/* x' = rows[i][0..2] . x + rows[i][3] */
struct transform {
    double rows[3][4];
};

/* A camera. The ray through the picture at u, v (each -1/2 .. 1/2, v upwards) starts at
 * location and has the direction direction + u right + v up, which is not normalised.
 * The ray of an orthographic camera starts at location + u right + v up and has the
 * direction direction. */
struct camera {
    double location[3];
    double direction[3];
    double right[3];
    double up[3];
    bool orthographic;
    double lens_radius;    /* 0: none */
    double focal_distance; /* distance of the sharp plane, along direction */
    int lens_points;       /* minimum of points on the lens per pixel */
};

/* The limit of lens_points. */
enum { MAX_LENS_POINTS = 256 };

/* The directions in which a light shines: all of them, or a beam around the axis from
 * its position to point_at. */
enum light_beam { BEAM_NONE, BEAM_CONE, BEAM_CYLINDER };

/* The limit of points in an area light. */
enum { MAX_AREA_POINTS = 65536 };

struct light {
    double position[3];
    double color[3];
    bool shadowless; /* casts no shadow and, as in POV-Ray, makes no phong or
                        specular highlight */
    bool parallel;   /* all rays are parallel to the axis: a cone then contains every
                      * point, a cylinder is parallel in any case */
    enum light_beam beam;
    double point_at[3];
    double radius, falloff; /* full intensity within radius, none beyond falloff:
                             * degrees off the axis (cone) or distance from it
                             * (cylinder) */
    double tightness;       /* exponent by which the light decreases off the axis: of
                             * the cosine (cone), of 1 - distance / falloff
                             * (cylinder) */
    double area_axes[2][3]; /* edges of a parallelogram around position */
    size_t area_size[2];    /* points along each edge, from which shadows are cast; 0:
                             * no area */
    bool circular;          /* the area is an ellipse */
    double fade_distance, fade_power; /* the light is multiplied by 2 / (1 + (distance /
                                       * fade_distance) ^ fade_power) if neither is 0 */
};

/* POV-Ray's finish. The defaults (3.7) are ambient .1, diffuse .6, phong_size 40,
 * roughness .05, brilliance and falloff 1, reflection black, and 0 for all others. */
struct finish {
    double ambient[3];         /* factor of the ambient light */
    double emission[3];        /* added to the colour without a factor */
    double reflection[3];      /* perpendicular to the surface */
    double reflection_most[3]; /* at grazing incidence */
    double reflection_falloff; /* exponent of 1 - cosine in the interpolation between
                                * the two */
    bool fresnel;              /* the interpolation follows Fresnel's formulas */
    double reflection_metallic;
    double diffuse, brilliance; /* brilliance: exponent of the cosine */
    double phong, phong_size;
    double specular, roughness;
    double metallic; /* share of the pigment's colour in highlights */
    double ior;      /* of the interior, in old scenes; 0: not given */
};

enum pigment_kind {
    PIGMENT_COLOR,
    PIGMENT_CHECKER,
    PIGMENT_GRADIENT,
    PIGMENT_PATTERN, /* any other pattern with a map */
    PIGMENT_IMAGE
};

/* A colour at a value from 0 to 1. The values of a map do not decrease. Colours between
 * two stops are interpolated linearly; beyond the ends they are those of the first or
 * last stop. */
struct color_stop {
    double at, color[3];
    double filter, transmit; /* of checkers only; the colours of a map are opaque */
};
struct color_map {
    size_t count;
    const struct color_stop *stops; /* owned by the scene */
    size_t clear; /* number of stops that transmit light, as written */
};

/* A pattern maps a point to a value, which a wave function then transforms; the
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
/* Parameters of patterns other than the wave. */
struct pattern_parameters {
    double brick_size[3], mortar;
};
struct pattern {
    enum pattern_function function;
    enum pattern_wave wave;
    double frequency, phase, exponent;
    struct pattern_parameters own;
};
/* What a row of patterns.def states of its pattern. */
enum { MAX_LISTED = 3 };
struct pattern_rule {
    const char *routine;           /* of the kernels; returns its value at a point */
    bool round;                    /* the values 0 and 1 are at the same points */
    size_t listed;                 /* number of colours in its list; 0: none */
    double colors[MAX_LISTED][3];  /* defaults of the list */
    struct pattern_parameters own; /* defaults */
};
extern const struct pattern_rule pattern_rules[PATTERN_FUNCTIONS];

struct pigment {
    enum pigment_kind kind;
    double color[2][3];        /* checker: where floor(x)+floor(y)+floor(z) is even, and
                                * odd; image: inside, and outside; gradient: the
                                * first */
    double filter[2];          /* share of light that passes coloured */
    double transmit[2];        /* share of light that passes unchanged */
    struct transform to_local; /* from the world to the space of the pattern */
    double axis[3];            /* of a gradient, normalised; the value is the fractional
                                * part of the coordinate along it */
    struct pattern pattern;
    struct color_map map; /* of a list: its colours, at 0, 1 .. */
    struct image_map image;
};
bool pigment_has_map(const struct pigment *pigment);
/* Returns the number of cells that may transmit light differently: two for a checker
 * and for a bounded image, else one. */
int pigment_cells(const struct pigment *pigment);
/* Returns true if it has a map or an image, so that a sky of it differs by
 * direction. */
bool pigment_makes_sky(const struct pigment *pigment);
/* Returns true if at least one of its colours transmits light. */
bool pigment_is_clear(const struct pigment *pigment);
/* Returns the number of colours in the list of the pattern; 0 if it has none. */
size_t pigment_list_count(const struct pigment *pigment);
/* Returns the value of the map at which colour i of the list is looked up: the wave
 * function of i, from 0. */
double pigment_list_value(const struct pigment *pigment, size_t i);
struct color_stop pigment_listed(const struct pigment *pigment, size_t i);

/* An entry of a slope_map: the height and the slope at a value. */
struct slope_stop {
    double at, height, slope;
};

/* A bump: heights over points, from a pattern, optionally through a slope_map. The kind
 * PIGMENT_COLOR has no heights and changes no normal. */
struct bump {
    struct pigment pattern; /* its colours are not used */
    double amount, accuracy;
    double controls[2]; /* of quilted */
    size_t stop_count;
    const struct slope_stop *stops; /* owned by the scene */
};

/* The change of the normals of a surface: one bump, or a list of bumps in its space.
 * The pattern of the first selects between them. */
struct bump_entry {
    double at; /* value in the map; in an average: the weight */
    struct bump bump;
};
struct bump_list {
    struct bump bump;
    bool average; /* all entries are added */
    size_t count; /* 0: the bump itself is used */
    const struct bump_entry *entries;
};
struct bumps {
    const struct bump_list *list; /* owned by the scene; NULL: none */
    struct transform to_local;    /* from the world to the space of its pattern */
    bool unscaled; /* normals are not rescaled by that map (no_bump_scale) */
};
/* Returns true if any normal is changed. */
bool bumps_show(const struct bumps *bumps);

/* Fog of constant density. At `distance` the share 1/e of the light passes through it
 * unchanged; at least the share `transmit` always passes. */
struct fog {
    double distance; /* above 0 */
    double color[3], filter, transmit;
};
enum { MAX_FOGS = 16 };

struct primitive; /* rt/shapes/primitive.h */

/* A node of a Boolean tree over primitives. The nodes are in preorder: a node is
 * followed by the subtrees of its children in order. A difference is the intersection
 * of its first child with the complements of its other children. */
enum tree_operation { TREE_LEAF, TREE_AND, TREE_OR, TREE_NOT };

struct tree_node {
    enum tree_operation operation;
    size_t next;      /* index of the first node after this subtree */
    size_t primitive; /* of a leaf: index of the scene's primitive */
};

/* An object that a statement of the file puts into the world. */
struct world_object {
    const char *name;     /* of the #declare that it comes from, or NULL */
    const char *material; /* name of the #declare of its texture, or NULL; parts that
                           * are subtracted do not count; of several textures the
                           * first */
    bool mixed;           /* it has several materials */
    size_t line;          /* of the statement, in the main file */
};

/* A float that is named by #declare. */
struct declared_float {
    const char *name;
    double value;
};

/* A unit of tracing: one primitive, or a Boolean tree of primitives. A union that is
 * not part of another solid is several regions. */
struct region {
    size_t first_primitive, primitive_count; /* its leaves, in order */
    size_t first_node, node_count;           /* in the scene's nodes */
    size_t line;
    double yield; /* times k_delta: added to the distances of its opaque surfaces before
                   * they are compared with those of other regions
                   * (rt/shapes/coincident.h) */
};

struct scene {
    int unit_log; /* lengths of the file are lengths of this scene times 2^unit_log; 0
                   * for a scene of ordinary size (unit.h) */
    struct camera camera;
    double background[3];
    struct pigment sky; /* over directions, before the background if it has a map or an
                         * image; any other kind: no sky */
    size_t image_count; /* tables of images */
    size_t fog_count;
    struct fog fogs[MAX_FOGS];
    double ambient_light[3];
    double assumed_gamma; /* 0: not given */
    bool gamma_off;       /* colours are displayed without correction: version < 3.7 */
    int max_trace_level;  /* rays in a chain of reflections, the camera ray included;
                           * rays that pass straight through do not count */
    double adc_bailout;   /* rays of less weight are not traced */
    size_t light_count;
    struct light *lights;
    size_t primitive_count;
    struct primitive *primitives; /* in file order */
    size_t node_count;
    struct tree_node *nodes;
    size_t region_count;
    struct region *regions;        /* in file order */
    size_t object_count;           /* objects that statements put into the world */
    struct world_object *objects;  /* owned by the scene */
    size_t float_count;            /* floats with names, with their values at the end of
                                    * the file */
    struct declared_float *floats; /* owned by the scene */
    bool every_crossing;           /* queries return all crossings of a ray instead of
                                    * the first hit: no region counts as simple */
    struct arena kept;             /* storage that primitives point to */
};
void scene_free(struct scene *scene);

#endif
