/* primitive.h - a primitive of a scene: its shape as written, and the transform that is
 * then applied. */
#ifndef RT_PRIMITIVE_H
#define RT_PRIMITIVE_H

#include "rt/scene/scene.h"

enum primitive_kind {
#define SHAPE(KIND, ...) PRIMITIVE_##KIND,
#include "rt/shapes/shapes.def"
    PRIMITIVE_KINDS
};
/* Returns the word of the kind in the scene language. */
const char *primitive_kind_name(enum primitive_kind kind);

enum { QUADRIC_TERMS = 10, QUARTIC_TERMS = 35, STEINER_POINTS = 6 };

/* Points in a plane, which the scene owns. */
struct outline {
    size_t count;
    double (*points)[2];
};

/* A triangle. The normals are used if it is smooth; their lengths are any above 0. */
struct triangle {
    double corners[3][3], normals[3][3];
    bool smooth;
};

/* A list of triangles, which the scene owns. */
struct triangles {
    size_t count;
    struct triangle *list;
};

/* A component of a blob: a sphere, or a cylinder with hemispheres at its ends. At a
 * distance d below its radius, from the centre or from the axis between the ends, it
 * adds strength (1 - d^2 / radius^2)^2 to the field. It has a space of its own. */
struct blob_part {
    bool cylinder;
    double base[3], cap[3]; /* of a sphere the base is the centre */
    double radius, strength;
    struct transform to_blob, to_local; /* from its space to the blob's, and the
                                         * inverse */
};

/* A list of components, which the scene owns. */
struct blob_parts {
    size_t count;
    struct blob_part *list;
};

/* Rays to which a primitive is invisible: camera rays that no reflection precedes, and
 * rays after a reflection. */
enum { HIDDEN_FROM_IMAGE = 1, HIDDEN_FROM_REFLECTIONS = 2 };

struct primitive {
    enum primitive_kind kind;
    union {
/* The members end with semicolons of their own. */
#define SHAPE(KIND, name, ...) \
    struct { \
        __VA_ARGS__ \
    } name;
#include "rt/shapes/shapes.def"
    } shape;
    bool empty; /* it is invisible; the parser removes it */
    struct transform to_world;
    struct transform to_local; /* the inverse of to_world */
    bool transformed;          /* to_world is not the identity */
    struct pigment pigment;
    struct bumps bumps;
    struct finish finish;
    bool no_shadow;
    unsigned hidden_from;
    bool invisible;  /* it cuts other parts of its tree and is invisible itself */
    double ior;      /* index of refraction of its inside; the default is 1 */
    size_t interior; /* primitives with the same number are one body to a ray that
                      * records which bodies it is inside */
    bool inverted;   /* below an odd number of complements in its tree: its outward
                      * normal points into the solid */
    size_t object;   /* index of the scene's object that it is part of */
    size_t line;     /* of its statement, in the main file */
};

#endif
