/* primitive.h - a primitive of a scene: its shape as it is written, and the
 * transform that then applies. */
#ifndef RT_PRIMITIVE_H
#define RT_PRIMITIVE_H

#include "rt/scene/scene.h"

enum primitive_kind {
#define SHAPE(KIND, ...) PRIMITIVE_##KIND,
#include "rt/shapes/shapes.def"
    PRIMITIVE_KINDS
};
/* Its word in the scene language. */
const char *primitive_kind_name(enum primitive_kind kind);

enum { QUADRIC_TERMS = 10, QUARTIC_TERMS = 35, STEINER_POINTS = 6 };

/* Points of a plane, as many as there are; the scene keeps them. */
struct outline {
    size_t count;
    double (*points)[2];
};

/* Normals, of any length above 0, are at the corners of a smooth one. */
struct triangle {
    double corners[3][3], normals[3][3];
    bool smooth;
};

/* As many as there are; the scene keeps them. */
struct triangles {
    size_t count;
    struct triangle *list;
};

/* A ball, or a cylinder with half balls at its ends: at a distance d below its
 * radius from the centre, or from the axis between the ends, it adds
 * strength (1 - d^2 / radius^2)^2 to the field, in a space of its own. */
struct blob_part {
    bool cylinder;
    double base[3], cap[3]; /* of a ball the base is the centre */
    double radius, strength;
    struct transform to_blob, to_local; /* from its space, and back */
};

/* As many as there are; the scene keeps them. */
struct blob_parts {
    size_t count;
    struct blob_part *list;
};

/* Rays that do not see a primitive: those of the camera, as long as none of them is
 * reflected, and those that a reflection precedes. */
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
    bool empty; /* nothing is seen of it: the reader leaves it out */
    struct transform to_world;
    struct transform to_local; /* the inverse of to_world */
    bool transformed;          /* to_world is not the identity */
    struct pigment pigment;
    struct bumps bumps;
    struct finish finish;
    bool no_shadow;
    unsigned hidden_from;
    bool unseen;     /* a part of a tree that cuts others and is not seen
                                  itself */
    double ior;      /* index of refraction of its inside; 1 */
    size_t interior; /* those of one number are one body to a ray
                        that remembers in what it is */
    bool inverted;   /* an odd number of complements stands above
                                  it: its outward normal points to what is
                                  solid */
    size_t object;   /* it is a part of: of the scene's, from 0 on */
    size_t line;     /* where it is written, in the scene's main file */
};

#endif
