/* scene_object.h - an object of a scene file while it is read.
 *
 * An object is a list of solids. A solid is a tree in preorder, whose leaves are the
 * parts in order. A union has the solids of its children from the start, because its
 * transform applies to each primitive. Texture, interior and hidden_from are deferred,
 * because `object { NAME texture {...} }` may still change them: they are copied to the
 * parts when the object becomes part of another object. Texture and interior are only
 * copied to parts without them.
 */
#ifndef RT_SCENE_OBJECT_H
#define RT_SCENE_OBJECT_H

#include "rt/scene/transform.h"
#include "rt/shapes/primitive.h"

struct texture {
    const char *name; /* name of the #declare that it comes from, or NULL */
    struct pigment pigment;
    struct bumps bumps;
    struct finish finish;
};

struct scene_part {
    struct primitive primitive; /* pigment, bumps and finish are valid if `textured`;
                                 * ior and interior are valid if `filled` */
    bool textured, filled;
    const char *material;              /* name of the texture if `textured` */
    const struct bicubic_patch *patch; /* is replaced by a mesh in world space */
    bool smooth_field;                 /* a mesh whose normals are normalised in world
                                        * space */
    bool field; /* a mesh of a height field, which gets a body if it needs an inside */
};

/* How the children of an object are combined. JOIN_APART: they stay separate, as in a
 * union. */
enum joining { JOIN_APART, JOIN_MERGE, JOIN_INTERSECTION, JOIN_DIFFERENCE };

struct branch {
    enum tree_operation operation;
    size_t size; /* number of branches in the subtree, including this branch */
    bool clips;  /* an intersection of the first child with clipping objects */
};

struct scene_object {
    size_t part_count;
    struct scene_part *parts;
    size_t branch_count;
    struct branch *branches;
    size_t light_count;
    struct light *lights;
    bool is_light; /* a light, which may have an object of looks_like */
    enum joining joining;
    size_t child_count; /* number of children, including lights */
    bool textured;
    const char *name; /* name from #declare or `part`; NULL: none */
    bool named;       /* the name was set by `part` (part.c) */
    struct texture texture;
    bool filled;
    double ior;
    size_t interior;
    unsigned hidden_from; /* as in struct primitive */
};

/* Applies a transform to the subject. The name of a function states the type of the
 * subject. */
typedef void step_mover(void *subject, const struct placement *step);
step_mover pigment_move, texture_move, object_move;

/* These functions return false if out of memory. */
bool object_add_primitive(struct scene_object *object,
                          const struct primitive *primitive);
bool object_add_light(struct scene_object *object, const struct light *light);
/* Adds the solids of a child. Parts without a texture or interior get the texture or
 * interior of the child. The hidden_from of the child applies to all its parts. */
bool object_add(struct scene_object *object, const struct scene_object *child);
/* Adds a child to the object. Unless `joining` is JOIN_APART, the child is first joined
 * to one solid, and after the first child of a difference it is also inverted. */
bool object_add_child(struct scene_object *object, struct scene_object *child);
/* Returns the kinds of rays that do not see the object, or do not see at least one of
 * its parts. Clipping parts are not considered. */
unsigned object_hidden_from(const struct scene_object *object);
/* Makes all parts except clipping parts visible to all rays. */
void object_show(struct scene_object *object);
/* Joins all solids of an object into one solid. */
bool object_join(struct scene_object *object);
/* Joins all solids of an object, and swaps inside and outside. Clipping does not
 * change. */
bool object_invert(struct scene_object *object);
/* Intersects each solid of the object with all solids of `clip`. */
bool object_clip(struct scene_object *object, const struct scene_object *clip);
/* Removes empty parts, and simplifies the solids that contain them. */
void object_prune(struct scene_object *object);
bool object_copy(struct scene_object *copy, const struct scene_object *object);
/* Renumbers the interiors of a copied object from *last + 1, so that it shares no
 * interior with the original. Sets *last to the greatest new number. */
bool object_renumber(struct scene_object *object, size_t *last);
void scene_object_free(struct scene_object *object);

#endif
