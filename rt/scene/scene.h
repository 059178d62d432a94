/* scene.h - a scene as the scene language describes it, in world units.
 *
 * Doubles are here at the edge: rt/layout/layout.c turns them into the machine's
 * own numbers.  Axes are left-handed as in POV-Ray: x right, y up, z away.
 * Colours are linear RGB as the file gives them.
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

/* The ray through the picture at u, v (each -1/2 .. 1/2, v upwards) starts at
 * location and has the direction direction + u right + v up, not of length
 * one; an orthographic camera's starts at location + u right + v up and has the
 * direction direction. */
struct camera {
    double location[3];
    double direction[3];
    double right[3];
    double up[3];
    bool orthographic;
    double lens_radius;    /* 0: none */
    double focal_distance; /* along direction, to what is sharp */
    int lens_points;       /* from which a pixel is seen, at least */
};

/* Of a lens. */
enum { MAX_LENS_POINTS = 256 };

/* Where a light shines: all around, or in a beam about the way from it to a
 * point. */
enum light_beam { BEAM_NONE, BEAM_CONE, BEAM_CYLINDER };

/* Points of a light's area. */
enum { MAX_AREA_POINTS = 65536 };

struct light {
    double position[3];
    double color[3];
    bool shadowless; /* casts no shadow and, as in POV-Ray, makes no phong or
                        specular highlight */
    bool parallel;   /* all its rays go the way from it to the point: a cone then
                        holds all, those of a cylinder always do */
    enum light_beam beam;
    double point_at[3];
    double radius, falloff; /* it is full within, and ends: of a cone in degrees
                               off the axis, of a cylinder so far from it */
    double tightness;       /* the power by which it is less off the axis, of the
                         cosine or of how near the edge is */
    double area_axes[2][3]; /* of a parallelogram about its place, */
    size_t area_size[2];    /* with so many points along each of these, from
                               which it casts shadows; 0: it has none */
    bool circular;          /* .. an ellipse */
    double fade_distance, fade_power; /* times 2 / (1 + (distance /
                                         fade_distance) ^ fade_power), if
                                         neither is 0 */
};

/* POV-Ray's finish; its defaults (3.7) are ambient .1, diffuse .6, the rest
 * 0, phong_size 40, roughness .05, reflection black, brilliance and falloff
 * 1. */
struct finish {
    double ambient[3];         /* times the ambient light */
    double emission[3];        /* .. and as it is */
    double reflection[3];      /* seen straight on */
    double reflection_most[3]; /* .. along the surface */
    double reflection_falloff; /* the power by which it goes from one to the
                                  other with 1 less the cosine */
    bool fresnel;              /* .. or by Fresnel's formulas */
    double reflection_metallic;
    double diffuse, brilliance; /* the power of the cosine */
    double phong, phong_size;
    double specular, roughness;
    double metallic; /* how far highlights have the pigment's colour */
    double ior;      /* of the object's interior, in old scenes; 0: not given */
};

enum pigment_kind {
    PIGMENT_COLOR,
    PIGMENT_CHECKER,
    PIGMENT_GRADIENT,
    PIGMENT_PATTERN, /* any other that has a map */
    PIGMENT_IMAGE
};

/* Colours at values from 0 to 1 that do not fall: those between are in a line
 * with those beside, those beyond are as the first or the last. */
struct color_stop {
    double at, color[3];
    double filter, transmit; /* of checkers; what has a map is opaque */
};
struct color_map {
    size_t count;
    const struct color_stop *stops; /* the scene keeps them */
    size_t clear; /* so many that let light pass, as they are written */
};

/* Of a point a value, which then goes in a wave: rt/kernels/light/pattern.s has
 * the formulas. */
enum pattern_function {
    PATTERN_PLANAR,
    PATTERN_SPHERICAL,
    PATTERN_CYLINDRICAL,
    PATTERN_BOXED,
    PATTERN_ONION,
    PATTERN_LEOPARD,
    PATTERN_RADIAL,
    PATTERN_SLANTED, /* a gradient that is not the plain one */
    PATTERN_BRICK,
    PATTERN_HEXAGON,
    PATTERN_CHECKER, /* as a bump only: a pigment of it is another kind */
    PATTERN_QUILTED, /* as a bump only, which has no heights */
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
struct pattern {
    enum pattern_function function;
    enum pattern_wave wave;
    double frequency, phase, exponent;
    double brick_size[3], mortar;
};

struct pigment {
    enum pigment_kind kind;
    double color[2][3];        /* checker: where floor(x)+floor(y)+floor(z)
                                  is even, and odd; image: within, and outside;
                                  gradient: the first */
    double filter[2];          /* the share of light that passes, coloured */
    double transmit[2];        /* .. and as it is */
    struct transform to_local; /* from world points to the pattern's */
    double axis[3];            /* gradient: of length one; the value is how far
                                  the point is along it, less its floor */
    struct pattern pattern;
    struct color_map map; /* of a list: its colours, at 0, 1 .. */
    struct image_map image;
};
bool pigment_has_map(const struct pigment *pigment);
/* Cells that may let different light pass: two of a checker, and of an image that
 * is bounded; else one. */
int pigment_cells(const struct pigment *pigment);
/* More than a colour, in each direction of a sky. */
bool pigment_makes_sky(const struct pigment *pigment);
/* Light passes, for one of its colours at least. */
bool pigment_is_clear(const struct pigment *pigment);
/* A checker, bricks and hexagons have a list of so many colours; all others 0. */
size_t pigment_list_count(const struct pigment *pigment);
/* The i-th that is drawn, from 0 on: what the map has where the waves put i. */
/* .. and the value that they make of it. */
double pigment_list_value(const struct pigment *pigment, size_t i);
struct color_stop pigment_listed(const struct pigment *pigment, size_t i);

/* A slope_map: at a value it is so high, and rises so much by the next one. */
struct slope_stop {
    double at, height, slope;
};

/* Heights over points: those of a pattern (kind PIGMENT_COLOR: there are none, and it
 * changes no normal), as they are or by a slope_map. */
struct bump {
    struct pigment pattern; /* no colours of it */
    double amount, accuracy;
    double controls[2]; /* quilted */
    size_t stop_count;
    const struct slope_stop *stops; /* the scene keeps them */
};

/* What changes the normals of a surface: a bump, or several in its space, between
 * which its pattern chooses. */
struct bump_entry {
    double at; /* .. of an average: how much it counts */
    struct bump bump;
};
struct bump_list {
    struct bump bump;
    bool average; /* all of them are added */
    size_t count; /* 0: the bump itself */
    const struct bump_entry *entries;
};
struct bumps {
    const struct bump_list *list; /* the scene keeps it; NULL: none */
    struct transform to_local;    /* from world points to its pattern's */
    bool unscaled; /* normals keep their lengths there, as of no_bump_scale */
};
/* There is something that changes normals. */
bool bumps_show(const struct bumps *bumps);

/* Of the same density everywhere: at its distance a share of 1/e is seen through
 * it, of light that is not fogged; transmit of it at least. */
struct fog {
    double distance; /* above 0 */
    double color[3], filter, transmit;
};
enum { MAX_FOGS = 16 };

struct primitive; /* rt/shapes/primitive.h */

/* A Boolean tree over primitives, its nodes in preorder: a node, then all that
 * is below its first child, and so on.  A difference is the intersection of
 * its first child with the complements of the others. */
enum tree_operation { TREE_LEAF, TREE_AND, TREE_OR, TREE_NOT };

struct tree_node {
    enum tree_operation operation;
    size_t next;      /* the node behind all that is below this one */
    size_t primitive; /* of a leaf: which of the scene's */
};

/* What a statement of the file put into the world. */
struct world_object {
    const char *name;     /* of the #declare that it comes from, or NULL */
    const char *material; /* .. that its texture comes from, or NULL; what is
                             taken away does not count, of several
                             textures the first one's */
    bool mixed;           /* .. there are several materials */
    size_t line;          /* where it is written, in the main file */
};

/* A float that #declare gave a name. */
struct declared_float {
    const char *name;
    double value;
};

/* What is traced as one thing: a primitive, or a Boolean tree of them.  A
 * union that is not part of another solid is several regions. */
struct region {
    size_t first_primitive, primitive_count; /* its leaves, in order */
    size_t first_node, node_count;           /* of the scene's nodes */
    size_t line;
    double yield; /* times k_delta, added to distances of its opaque surfaces
                     before they are compared with those of other regions
                     (rt/shapes/coincident.h) */
};

struct scene {
    int unit_log; /* lengths of the file are those of this scene times 2^unit_log;
                     0 for a scene of ordinary size (unit.h) */
    struct camera camera;
    double background[3];
    struct pigment sky; /* of directions: one with a map or an image, before the
                           background; any other kind: there is none */
    size_t image_count; /* of the tables of images */
    size_t fog_count;
    struct fog fogs[MAX_FOGS];
    double ambient_light[3];
    double assumed_gamma; /* 0: not given */
    bool gamma_off;       /* colours are displayed as they are: version < 3.7 */
    int max_trace_level;  /* rays in a chain of reflections, the first
                               counted, what goes straight on not */
    double adc_bailout;   /* rays that weigh less are not followed */
    size_t light_count;
    struct light *lights;
    size_t primitive_count;
    struct primitive *primitives; /* in file order */
    size_t node_count;
    struct tree_node *nodes;
    size_t region_count;
    struct region *regions;        /* in file order */
    size_t object_count;           /* that statements of the file put into the world */
    struct world_object *objects;  /* the scene keeps them */
    size_t float_count;            /* as they are when the file ends */
    struct declared_float *floats; /* the scene keeps them */
    bool every_crossing;           /* all crossings of its rays are asked, not what
                               they meet first alone: no region is simple */
    struct arena kept;             /* what primitives point to */
};
void scene_free(struct scene *scene);

#endif
