/* scene_object.h - an object of a scene file while it is read.
 *
 * An object is a list of solids. Each is a tree in preorder whose leaves are the parts,
 * in order. A union has the solids of its children from the start, because its
 * transform applies to each primitive. Texture, interior and hidden_from are deferred:
 * they go to the parts when the object becomes part of another one, since `object {
 * NAME texture {...} }` may still change them. Texture and interior go only to parts
 * that have none.
 */
#ifndef RT_SCENE_OBJECT_H
#define RT_SCENE_OBJECT_H

#include "rt/scene/transform.h"
#include "rt/shapes/primitive.h"

struct texture {
    const char *name; /* of the #declare that it comes from, or NULL */
    struct pigment pigment;
    struct bumps bumps;
    struct finish finish;
};

struct scene_part {
    struct primitive primitive; /* pigment, bumps and finish are valid if textured; ior
                                 * and interior if filled */
    bool textured, filled;
    const char *material;              /* name of the texture, if textured */
    const struct bicubic_patch *patch; /* becomes a mesh in the world */
    bool smooth_field;                 /* a mesh whose normals are normalised in the
                                        * world */
    bool field; /* a mesh of a height field; it gets a body if it needs an inside */
};

/* How the children of an object are combined; those of a union stay separate. */
enum joining { JOIN_APART, JOIN_MERGE, JOIN_INTERSECTION, JOIN_DIFFERENCE };

struct branch {
    enum tree_operation operation;
    size_t size; /* number of branches in the subtree, this one included */
    bool clips;  /* an intersection of the first child with clipping objects */
};

struct scene_object {
    size_t part_count;
    struct scene_part *parts;
    size_t branch_count;
    struct branch *branches;
    size_t light_count;
    struct light *lights;
    bool is_light; /* a light, optionally with the object of its looks_like */
    enum joining joining;
    size_t child_count; /* including lights */
    bool textured;
    const char *name; /* of the #declare that it comes from, or of `part`; or NULL */
    bool named;       /* the name was set by `part` (part.c) */
    struct texture texture;
    bool filled;
    double ior;
    size_t interior;
    unsigned hidden_from; /* as of a primitive */
};

/* Applies a transform to the subject, of the type that the name says. */
typedef void step_mover(void *subject, const struct placement *step);
step_mover pigment_move, texture_move, object_move;

/* These return false without memory. */
bool object_add_primitive(struct scene_object *object,
                          const struct primitive *primitive);
bool object_add_light(struct scene_object *object, const struct light *light);
/* Adds the solids of a child. Parts without texture or interior get those of the child,
 * if it has them; all its parts are hidden from the rays that it is hidden from. */
bool object_add(struct scene_object *object, const struct scene_object *child);
/* Adds a child as the object's joining requires: one solid of it, or its complement. */
bool object_add_child(struct scene_object *object, struct scene_object *child);
/* Returns the union of the rays from which some part is hidden. */
unsigned object_hidden_from(const struct scene_object *object);
/* Makes all parts visible to all rays, except parts that clip. */
void object_show(struct scene_object *object);
/* Joins all solids into one. */
bool object_join(struct scene_object *object);
/* Joins all solids and swaps inside and outside. Clipping is kept. */
bool object_invert(struct scene_object *object);
/* Clips each solid by all solids of another object, which become invisible. */
bool object_clip(struct scene_object *object, const struct scene_object *clip);
/* Removes empty parts, and simplifies the solids that contain them. */
void object_prune(struct scene_object *object);
bool object_copy(struct scene_object *copy, const struct scene_object *object);
/* Gives a copy interiors of its own, numbered from *last + 1; *last becomes the
 * greatest. */
bool object_renumber(struct scene_object *object, size_t *last);
void scene_object_free(struct scene_object *object);

#endif
