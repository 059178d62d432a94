/* primitive.h - a primitive of a scene: its shape as written, and the transform that is
 * applied to the shape. */
#ifndef RT_PRIMITIVE_H
#define RT_PRIMITIVE_H

#include "rt/scene/scene.h"

enum primitive_kind {
#define SHAPE(KIND, ...) PRIMITIVE_##KIND,
#include "rt/shapes/shapes.def"
    PRIMITIVE_KINDS
};
/* Returns the keyword of the kind in the scene language. */
const char *primitive_kind_name(enum primitive_kind kind);

enum { QUADRIC_TERMS = 10, QUARTIC_TERMS = 35, STEINER_POINTS = 6 };

/* Points in a plane. The scene owns them. */
struct outline {
    size_t count;
    double (*points)[2];
};

/* A triangle. If it is smooth, it has normals. Their lengths are arbitrary, but above
 * 0. */
struct triangle {
    double corners[3][3], normals[3][3];
    bool smooth;
};

/* A list of triangles. The scene owns them. */
struct triangles {
    size_t count;
    struct triangle *list;
};

/* A component of a blob: a sphere, or a cylinder with hemispheres at its ends. A point
 * at distance d from the centre, or from the axis between the ends, gets strength (1 -
 * d^2 / radius^2)^2 if d is below the radius. The component has a space of its own. */
struct blob_part {
    bool cylinder;
    double base[3], cap[3]; /* the base of a sphere is its centre */
    double radius, strength;
    struct transform to_blob, to_local; /* from the component's space to the blob's
                                         * space, and the inverse */
};

/* A list of the components of a blob. The scene owns them. */
struct blob_parts {
    size_t count;
    struct blob_part *list;
};

/* The rays to which a primitive is invisible: rays that have not been reflected, and
 * rays that have been reflected. */
enum { HIDDEN_FROM_IMAGE = 1, HIDDEN_FROM_REFLECTIONS = 2 };

struct primitive {
    enum primitive_kind kind;
    union {
/* The members in shapes.def end with a semicolon. */
#define SHAPE(KIND, name, ...) \
    struct { \
        __VA_ARGS__ \
    } name;
#include "rt/shapes/shapes.def"
    } shape;
    bool empty; /* it is invisible, and the parser removes it */
    struct transform to_world;
    struct transform to_local; /* the inverse of to_world */
    bool transformed;          /* to_world is not the identity */
    struct pigment pigment;
    struct bumps bumps;
    struct finish finish;
    bool no_shadow;
    unsigned hidden_from;
    bool invisible;  /* it cuts other parts of its tree, but is invisible */
    double ior;      /* refractive index of the inside; the default is 1 */
    size_t interior; /* Primitives with the same number are one body for rays that
                      * record the bodies that contain them. */
    bool inverted;   /* it is below an odd number of complements in its tree, so its
                      * outward normal points into the solid */
    size_t object;   /* index of the scene's object that contains it */
    size_t line;     /* line of its statement in the main file */
};

#endif
